"""Twilight: a stated fade below the horizon, the same in every target (flavours and shaders are held elsewhere)."""

from __future__ import annotations

import dataclasses
import json
import tomllib
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, SMALL, run_quietly, with_spec
from numpy.typing import NDArray
from skylight_sh import runtime
from skylight_sh.config import ConfigError, parse
from skylight_sh.export import day, engines
from skylight_sh.runtime import Surroundings, Table
from skylight_sh.scene import clear_day, solar
from skylight_sh.studies.stability.flavours import flavours
from skylight_sh.table import npz, twilight
from test_cli import invoke

TEXT = SMALL.read_text(encoding="utf-8")
HORIZON = np.pi / 2
Array = NDArray[np.float64]


def sinking(table: Table) -> Table:
    """Return ``table`` with twilight."""
    return with_spec(table, peak_axis="sun_zenith", twilight=twilight.TWILIGHT)


def test_the_fade_is_smooth_and_ends() -> None:
    table = flavours()["twilight"]

    def fade(zeniths: Array) -> Array:
        return table.fade(np.stack([zeniths, np.full(zeniths.size, 3.0)], axis=-1))

    depth = np.radians(np.linspace(-5.0, 20.0, 2001))
    factor = fade(HORIZON + depth)
    assert np.all(factor[depth <= 0] == 1.0)
    assert np.all(factor[depth >= np.radians(12.0)] == 0.0)
    falling = factor[(depth > 0) & (depth < np.radians(12.0))]
    assert np.all(np.diff(falling) < 0)
    # Once continuously differentiable everywhere: second differences stay bounded as the step halves.
    steepest = [np.abs(np.diff(fade(np.linspace(1.5, 1.9, n)), 2)).max() * (n - 1) ** 2 for n in (4001, 16001)]
    assert steepest[1] == pytest.approx(steepest[0], rel=0.02)


def test_the_fade_is_as_dark_as_measured() -> None:
    """What is measured falls to 3.4 lx at the end of civil twilight and to 0.008 lx at that of nautical twilight."""
    sunset, civil, nautical = clear_day.twilight(np.radians([0.0, 6.0, 12.0]))
    assert (sunset, civil, nautical) == (pytest.approx(759, 0.01), pytest.approx(3.4, 0.02), pytest.approx(0.008, 0.05))
    assert twilight.fade(0.5) == pytest.approx(civil / sunset, rel=0.35)


def test_a_table_fades_its_horizon(tmp_path: Path) -> None:
    config = parse(tomllib.loads(TEXT + "\n[scene]\ntwilight = true\n"), "a config")
    result = run_quietly(config, tmp_path)
    sky = runtime.load(result.folder / "export" / "skylight_sh.npz")
    x = np.linspace(0.0, 1.0, 40)[1:-1]
    sinking = HORIZON + np.radians(12.0) * x
    got, status = sky.weights_and_status(sinking, 0.4, 3.0)
    expected = sky.weights(HORIZON, 0.4, 3.0) * ((1 - x) ** 10 * (1 + 10 * x))[:, np.newaxis, np.newaxis]
    assert not status.any()
    assert np.abs(got - expected).max() < 1e-6 * np.abs(expected).max()
    night, status = sky.weights_and_status(1.9, 0.4, 3.0)
    assert status == runtime.CLAMPED
    assert not night.any()
    header = (result.folder / "export" / "skylight_sh.h").read_text(encoding="utf-8")
    assert "SUN_ZENITH_MAX 1.780" in header
    assert "_weights_gradient(" in header


def test_lamps_shine_at_night() -> None:
    table = runtime.read(ROOT / "reports" / "reference" / "export" / "skylight_sh.npz")
    lamps = np.arange(3.0 * table.bands**2).reshape(3, -1)
    lit = runtime.Runtime(dataclasses.replace(sinking(table), surroundings=Surroundings(own=lamps)))
    night = datetime(2024, 3, 20, tzinfo=UTC).date()
    request = day.Request(
        "filament-radiance", solar.Place(48.2, 16.4), night, {"turbidity": 3.0}, night="zero", exposure=0.5
    )
    made = day.tabulate(lit, request)
    expected = engines.convert(
        lamps[np.newaxis, :, : made.numbers.shape[-1]], engines.PROFILES["filament-radiance"], exposure=0.5
    )
    assert made.zeniths[0] > twilight.END
    assert np.abs(made.numbers[0] - expected[0]).max() < 1e-9
    dark = day.tabulate(runtime.Runtime(table), request)
    assert not dark.numbers[0].any()


@pytest.mark.parametrize(
    "edit",
    [
        ("range = [0.0, 1.5707963267948966]", "range = [0.0, 1.5]"),
        ("[scene]", '[scene]\nsun = { latitude = 80.0, dates = ["2027-06-20", "2027-06-22"] }'),
    ],
)
def test_twilight_begins_on_the_horizon(edit: tuple[str, str]) -> None:
    text = f"{TEXT}\n[scene]\ntwilight = true\n".replace(*edit)
    with pytest.raises(ConfigError, match=r"\$\.scene\.twilight = True.*1\.5707963"):
        parse(tomllib.loads(text), "a config")


def test_a_day_goes_on_to_12_degrees(tmp_path: Path) -> None:
    table = sinking(runtime.read(ROOT / "reports" / "reference" / "export" / "skylight_sh.npz"))
    (tmp_path / "t.npz").write_bytes(npz.write(table))
    place = ("--latitude", "48.2", "--longitude", "16.4", "--date", "2024-03-20", "--turbidity", "3", "--step", "10")
    code, out, err = invoke(
        "export", str(tmp_path / "t.npz"), "--format", "unity", "--output", str(tmp_path / "day.json"), *place
    )
    assert (code, err) == (0, "")
    assert "sun 12 degrees below the horizon" in out
    suns = [sky["sun_zenith"] for sky in json.loads((tmp_path / "day.json").read_text(encoding="utf-8"))["skies"]]
    assert max(suns) > np.radians(100)
    assert max(suns) < np.radians(102)
