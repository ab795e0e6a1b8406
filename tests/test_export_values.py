"""Exports by hand: what a file's text says in numbers, which places and moments there are, and an archive's dates."""

from __future__ import annotations

import io
import re
import zipfile
from dataclasses import replace
from datetime import date

import numpy as np
import pytest
from conftest import with_spec
from skylight_sh import runtime
from skylight_sh.export import c_comment, c_header, day, shaders
from skylight_sh.export.targets.glsl import DIALECT as GLSL
from skylight_sh.fit.axis import Axis
from skylight_sh.light.preetham import Preetham
from skylight_sh.scene import solar
from skylight_sh.studies.stability.flavours import flavours
from skylight_sh.table import npz, twilight
from skylight_sh.table.prefactor import closed_form
from skylight_sh.table.table import fast, specification

FLAVOURS = flavours()


@pytest.mark.parametrize(("bands", "lost"), [(1, "75 %"), (2, "25 %"), (3, "9.4 %"), (5, "5.9 %")])
def test_the_suns_light_on_a_surface_is_right_to_what_the_bands_hold(bands: int, lost: str) -> None:
    """A clamped cosine is 1/4 P0 + 1/2 P1 + 5/16 P2 - 3/32 P4 ..: cuts differ most at 1, then at 0."""
    base = FLAVOURS["rows"]
    table = replace(with_spec(base, quantity="irradiance", sun_disc=True), bands=bands)
    unit, lines = c_comment.about(table)
    assert unit == "lx"
    assert f"{bands} bands hold its light on a surface to {lost} of that" in " ".join(lines)
    assert max(map(len, lines)) <= 117


def test_a_fixed_parameter_is_told_once() -> None:
    table = FLAVOURS["rows"]
    sky = Preetham().hints.prefactor
    assert sky is not None
    fixed = with_spec(table, axes=table.axes[:1], scale=closed_form(sky, table.axes[:1], {"turbidity": 3.25}))
    text = " ".join(c_comment.about(fixed)[1])
    assert text.count("turbidity is 3.25 for good.") == 1
    assert "for good" not in " ".join(c_comment.about(table)[1])


def test_a_header_states_its_ranges_and_an_example_in_their_middle() -> None:
    text = c_header.write(FLAVOURS["rows"], c_header.Facts("t", 0.0125, 0.05, "per-set", [], least=-0.25))
    assert max(map(len, text.splitlines())) <= 100
    assert "skylight_sh_weights(0.785000026f, 0.0f, 4.25f, w)" in text
    assert "E_mean 1.25 %, E_max 5 %" in text
    assert "is -25 % of its largest" in re.sub(r"\n \* +", " ", text)
    for name, value in (("BANDS", 7), ("WEIGHTS", 49), ("CHANNELS", 3), ("AXES", 2)):
        assert re.search(rf"^#define SKYLIGHT_SH_{name} {value}$", text, re.MULTILINE)
    assert "least value" not in c_header.write(FLAVOURS["rows"], c_header.Facts("t", 0.0, 0.0, "per-set", [], least=0.0))


def test_an_archive_holds_no_date() -> None:
    with zipfile.ZipFile(io.BytesIO(npz.write(FLAVOURS["packed"]))) as archive:
        assert {info.date_time for info in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}


def test_places_end_at_the_poles_and_half_way_round() -> None:
    for good in ((90, 180), (-90, -180), (0, 0)):
        assert solar.Place(*good).latitude == good[0]
    for bad in ((90.001, 0), (-90.001, 0), (0, 180.001), (0, -180.001), (float("nan"), 0)):
        with pytest.raises(ValueError, match="Should be degrees"):
            solar.Place(*bad)


def test_moments_run_from_midnight_to_before_the_next() -> None:
    found = list(solar.moments(date(2024, 6, 21), "Europe/Vienna", 60))
    assert [m.isoformat() for m in (found[0], found[1], found[-1])] == [
        f"2024-06-21T{hour}:00:00+02:00" for hour in ("00", "01", "23")
    ]
    assert len(found) == 24
    assert len(list(solar.moments(date(2024, 6, 21), "UTC", 1))) == 1440
    assert len(list(solar.moments(date(2024, 6, 21), "UTC", 1441))) == 1
    assert len(list(solar.moments(date(2024, 10, 27), "Europe/Vienna", 60))) == 25
    with pytest.raises(ValueError, match="at least 1 minute"):
        next(solar.moments(date(2024, 6, 21), "UTC", 0))


def test_a_day_by_default_is_hourly_and_unexposed_and_skips_the_night() -> None:
    place = solar.Place(48.2, 16.4)
    table = runtime.Runtime(FLAVOURS["rows"])
    made = day.tabulate(table, day.Request("unity", place, date(2024, 6, 21), {"turbidity": 3.0}))
    assert made.request.exposure == 1.0
    assert made.nights + len(made.times) == 24
    assert max(made.zeniths) <= twilight.BEGIN
    assert made.clamped == 0
    every = day.tabulate(table, replace(made.request, night="zero"))
    assert len(every.times) == 24
    assert every.nights == made.nights
    dark = np.array(every.zeniths) > twilight.BEGIN
    assert dark.sum() == made.nights
    assert not every.numbers[dark].any()
    assert np.array_equal(every.numbers[~dark], made.numbers)
    outside = day.tabulate(table, replace(made.request, others={"turbidity": 9.0}, night="zero"))
    assert outside.clamped == len(made.times)
    # Of a table with twilight the day is longer, by the suns at most 12 degrees below the horizon.
    sinking = day.tabulate(runtime.Runtime(FLAVOURS["twilight"]), made.request)
    assert made.nights > sinking.nights
    assert twilight.BEGIN < max(sinking.zeniths) <= twilight.END
    # At night what shines of itself in the surroundings is left.
    lamps = FLAVOURS["surrounded"].surroundings
    assert lamps is not None
    lit = day.tabulate(runtime.Runtime(FLAVOURS["surrounded"]), replace(made.request, night="zero"))
    assert lit.numbers[dark].any()
    assert np.ptp(lit.numbers[dark], axis=0).max() == 0.0


def test_formulas_become_shader_text() -> None:
    axes = (Axis("haze", 1e-6, 1.0, map="log", point=-0.5), Axis("hour", 0.0, 3.0, map="identity"))
    table = fast(specification(axes, ("one",), True, "chebyshev"), np.ones((1, 1, 3, 2)), np.array([[3, 2]]), 1, "float32")
    head = {"glsl": "float u{}", "hlsl": "const float u{}", "wgsl": "let u{}: f32"}
    for language, declared in head.items():
        text = shaders.write(table, c_header.Facts("t", 0.0, 0.0, "per-set", []), language)
        # Numbers have a point and nine digits, negative ones brackets; functions have no suffix.
        assert f"{declared.format(0)} = 1.82048178 * log((x0 - (-0.5)) * 1.99999595) - 1.0;\n" in text
        assert f"{declared.format(1)} = (x1 - 0.0) * 0.666666687 - 1.0;\n" in text
        assert "t0[2] = 2.0 * t0[1] * t0[1] - 1.0;\n" in text
    assert [GLSL.vector(["1.0", "2.0", "3.0"][:n]) for n in (1, 2, 3)] == ["1.0", "vec2(1.0, 2.0)", "vec3(1.0, 2.0, 3.0)"]
    assert GLSL.constants("real", "a", ["1.0", "2.0", "3.0"], 2) == (
        "const float a[3] = float[3](\n    1.0, 2.0,\n    3.0\n);"
    )


def test_a_shaders_slack_is_a_millionth_of_the_range_or_of_one() -> None:
    for high, limits in ((0.25, "haze < -1e-06 || haze > 0.250001"), (4.0, "haze < -4e-06 || haze > 4.000004")):
        frame = specification((Axis("haze", 0.0, high),), ("one",), True, "chebyshev", None)
        table = fast(frame, np.ones((1, 1, 2)), np.array([2]), 1, "float32")
        text = shaders.write(table, c_header.Facts("t", 0.0, 0.0, "per-set", []), "glsl")
        found = re.findall(r"if \(haze < (\S+) \|\| haze > (\S+)\)", text)
        expected = re.findall(r"haze < (\S+) \|\| haze > (\S+)", limits)
        assert [float(v) for v in found[0]] == pytest.approx([float(v) for v in expected[0]], rel=2e-7, abs=1e-13)
