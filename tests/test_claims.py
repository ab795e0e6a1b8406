"""What measures the README's claims: a scene by its directions, and the files and blocks that figures go through."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from click.testing import CliRunner
from conftest import ROOT
from numpy.typing import NDArray
from skylight_sh import shipped, sphere
from skylight_sh.config import Config, parse
from skylight_sh.config.extending import read
from skylight_sh.light import spherical_lights
from skylight_sh.probe import files
from skylight_sh.report.page import is_noisy
from skylight_sh.report.report_data import ReportData
from skylight_sh.studies.claims import readme, scene, times
from skylight_sh.studies.claims.__main__ import main

Array = NDArray[np.float64]
BANDS = 6
VALLEY = ROOT / "configs" / "valley.toml"
REFERENCE = ROOT / "reports" / "reference"
SUN = ({"sun_zenith": 0.8, "turbidity": 3.0}, 2.0)


def lit(**edits: Any) -> Config:
    """The valley with these parts of its scene alone."""
    raw = read(VALLEY)
    raw["scene"], raw["report"] = edits, {"figures": ["maps"]}
    return parse(raw, "a valley", VALLEY.parent)


def even(monkeypatch: pytest.MonkeyPatch) -> None:
    """A sky of radiance 1."""
    monkeypatch.setattr(scene, "_sky", lambda _config, where, *_: np.ones((len(where), 3)))


def test_an_even_sky_above_a_skyline_and_behind_a_sphere(monkeypatch: pytest.MonkeyPatch) -> None:
    """Closed forms: the skyline's mask, and everything but a cap."""
    even(monkeypatch)
    skyline = [0.1, 0.5, 0.3, 0.2]
    found = scene.direct(lit(horizon=skyline), [SUN], BANDS, 64)
    # The skyline's corners are met to a meridian.
    assert np.abs(found[0] - sphere.horizon(skyline, BANDS)).max() < 1e-3
    sphere_ = {"centre": [1.0, -2.0, 2.5], "radius": 1.0}
    angle, direction = spherical_lights.half_angles([sphere_["centre"]], [1.0])
    expected = sphere.horizon(0.0, BANDS) - sphere.aim(sphere.cap(angle[0], BANDS), direction[0])
    found = scene.direct(lit(occluders=[sphere_]), [SUN], BANDS, 256)
    # Its edge is met to a node's distance.
    assert np.abs(found[0] - expected).max() < 2e-3


def test_an_even_ground_and_lamps(monkeypatch: pytest.MonkeyPatch) -> None:
    even(monkeypatch)
    ground = scene.direct(lit(ground=[0.1, 0.2, 0.3], horizon=[0.0]), [SUN], BANDS, 64)
    upper = sphere.horizon(0.0, BANDS)
    expected = np.array([sphere.add_ground(upper, albedo, BANDS) for albedo in (0.1, 0.2, 0.3)])
    assert np.abs(ground[0] - expected).max() < 1e-12
    lights = read(VALLEY)["scene"]["lights"]
    lamps = scene.direct(lit(horizon=[0.0], lights=lights), [SUN], BANDS, 32) - scene.direct(lit(), [SUN], BANDS, 32)
    one, other = lights
    told = np.multiply.outer(one["radiance"], spherical_lights.spheres(one["centre"], one["radius"], BANDS))
    spot = spherical_lights.spots(other["centre"], other["axis"], other["inner"], other["outer"], BANDS)
    told += np.multiply.outer(other["intensity"], spot)
    assert np.abs(lamps[0] - told).max() < 1e-9 * np.abs(told).max()
    with pytest.raises(ValueError, match=r"kind 'point'.*sphere or a spot"):
        scene.direct(lit(lights=[{"kind": "point", "centre": [0.0, 0.0, 1.0], "intensity": [1.0] * 3}]), [SUN], BANDS, 16)


def test_a_sky_that_has_no_more_bands_is_what_the_transfer_matrix_makes_of_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """Behind a skyline alone the matrix is exact for the bands it has: all that is lost is what the sky has beyond."""
    config = lit(horizon=read(VALLEY)["scene"]["horizon"])
    assert scene.measure(config, [SUN], BANDS, 128)[BANDS][1] > 0.01

    def cut(config: Config, where: Array, parameters: dict[str, float], azimuth: float) -> Array:
        return sphere.basis(where, BANDS) @ scene._expansion(config, parameters, azimuth, BANDS).T

    monkeypatch.setattr(scene, "_sky", cut)
    assert scene.measure(config, [SUN], BANDS, 128)[BANDS][1] < 1e-4


def test_clouds_are_where_their_picture_has_them(monkeypatch: pytest.MonkeyPatch) -> None:
    """As the pipeline projects the picture, to what two bands lack; turned or upside down they would be elsewhere."""
    config = lit(clouds={"image": "clouds.png", "layout": "equirect", "colour": [9500.0] * 3, "opacity": 0.85})
    right = scene.measure(config, [SUN], BANDS, 128)[2][1]
    at = scene._clouds
    for moved in (
        lambda c, polar, around: at(c, polar, around + 1.0),
        lambda c, polar, around: at(c, np.pi - polar, around),
    ):
        monkeypatch.setattr(scene, "_clouds", moved)
        assert scene.measure(config, [SUN], BANDS, 128)[2][1] > 3 * right
    assert config.scene.clouds
    odd = config.scene.clouds.model_copy(update={"layout": "angular"})
    odder = config.model_copy(update={"scene": config.scene.model_copy(update={"clouds": odd})})
    with pytest.raises(ValueError, match=r"layout 'angular'.*equirect"):
        at(odder, np.zeros(1), np.zeros(1))


@pytest.mark.parametrize(
    ("fit", "reference", "noise"), [(2.1, 8.9e19, True), (7e19, None, True), (2.1, 8e9, False), (2.1, None, False)]
)
def test_the_page_says_what_is_rounding_noise(fit: float, reference: float | None, noise: bool) -> None:
    """Beside a reference of that condition number, or on the page of a run whose own fit has it, as configs/paper.toml's."""
    told = {"fit": {"solver": "normal", "references": [{"name": "a", "solver": "normal"}]}}
    data = SimpleNamespace(settings=told, condition=fit, references=[SimpleNamespace(name="a", condition=reference)])
    assert is_noisy(cast("ReportData", data)) == noise
    # Another solver needs no normal equations.
    told["fit"] = {"solver": "svd", "references": [{"name": "a", "solver": "svd"}]}
    assert not is_noisy(cast("ReportData", data))


def test_the_command_writes_blocks_and_releases_speed(tmp_path: Path) -> None:
    reference = tmp_path / "reference"
    shutil.copytree(REFERENCE, reference)
    (tmp_path / "docs").mkdir()
    texts = {name: (ROOT / name).read_text(encoding="utf-8") for name in readme.PAGES}
    for name, text in texts.items():
        last = f"<!-- /{readme.PAGES[name][-1]} -->"
        (tmp_path / name).write_text(text.replace(last, f"stale\n{last}"), encoding="utf-8")
    places = ["--reference", str(reference)]
    done = CliRunner().invoke(main, ["write", *places, "--pages", str(tmp_path)])
    assert done.exit_code == 0, done.output
    for name, text in texts.items():
        assert (tmp_path / name).read_text(encoding="utf-8") == text
    (reference / "speed.json").rename(tmp_path / "speed.json")
    done = CliRunner().invoke(main, ["write", *places, "--pages", str(tmp_path)])
    assert done.exit_code == 1
    assert "make bench speed" in done.output
    assert CliRunner().invoke(main, ["speed", str(tmp_path), *places]).exit_code == 0
    assert (reference / "speed.json").read_bytes() == (REFERENCE / "speed.json").read_bytes()
    done = CliRunner().invoke(main, ["speed", str(tmp_path / "none"), *places])
    assert done.exit_code == 1
    assert "Run `make bench` first" in done.output
    with pytest.raises(ValueError, match=r"results\.md needs the block results once"):
        readme.rewrite("docs/results.md", "", readme.released(reference))


def test_the_command_writes_sources_and_a_sky(tmp_path: Path) -> None:
    reference = tmp_path / "reference"
    shutil.copytree(REFERENCE, reference, ignore=shutil.ignore_patterns("code", "*.exr"))
    done = CliRunner().invoke(main, ["code", "--reference", str(reference)])
    assert done.exit_code == 0, done.output
    for path in (REFERENCE / "code").iterdir():
        assert (reference / "code" / path.name).read_bytes() == path.read_bytes()
    assert files.read(reference / "sky.exr").pixels == pytest.approx(
        files.read(REFERENCE / "sky.exr").pixels, rel=1e-6, abs=1e-3
    )


def test_run_times_are_those_of_a_run(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a config that takes a few seconds; half of what the released run took, or ten times, is another machine's."""
    monkeypatch.setenv("PYTHONPATH", str(ROOT / "pipeline"))
    released = json.loads((REFERENCE / "times.json").read_text(encoding="utf-8"))["seconds"]
    assert set(released) <= set(shipped.names())
    found = times.measure(["fixed-weather"])
    assert set(found["machine"]) >= {"processor", "cores"}
    assert 0.2 < found["seconds"]["fixed-weather"] / released["fixed-weather"] < 10
