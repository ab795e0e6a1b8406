"""A tabulated day: the sun where it is published to be, its skies those of the runtime, the file whole or absent."""

from __future__ import annotations

import csv
import json
import sys
from datetime import UTC, date, datetime, timedelta, timezone
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT
from skylight_sh import runtime
from skylight_sh.export import day, engines
from skylight_sh.light import MissingExtraError
from skylight_sh.scene import solar
from test_cli import invoke

TABLE = ROOT / "reports" / "reference" / "export" / "skylight_sh.npz"
VIENNA = ("--latitude", "48.2", "--longitude", "16.4", "--timezone", "Europe/Vienna", "--date", "2024-06-21")


def export(output: Path, *more: str) -> tuple[int, str, str]:
    return invoke("export", str(TABLE), "--format", "unity", "--turbidity", "3", "--output", str(output), *VIENNA, *more)


def test_the_sun_stands_where_nrel_publishes_it() -> None:
    """Reda and Andreas 2004 (NREL/TP-560-34302), table A5: zenith 50.11162, azimuth 194.34024 from north by east."""
    moment = datetime(2003, 10, 17, 12, 30, 30, tzinfo=timezone(timedelta(hours=-7)))
    zenith, azimuth = solar.position(solar.Place(39.742476, -105.1786), moment)
    assert np.degrees(zenith) == pytest.approx(50.11162, abs=0.1)
    assert np.degrees(azimuth) == pytest.approx((90 - 194.34024) % 360, abs=0.1)


def test_the_sun_rises_in_the_east_and_culminates_in_the_south() -> None:
    """At an equinox: +x, our azimuth 0, in the morning, then -y, and -x in the evening."""
    place = solar.Place(48.2, 0.0)
    for hour, expected in ((6.13, 0.0), (12.13, 270.0), (18.13, 180.0)):
        zenith, azimuth = solar.position(place, datetime(2024, 3, 20, tzinfo=UTC) + timedelta(hours=hour))
        assert abs((np.degrees(azimuth) - expected + 180) % 360 - 180) < 1.5
        assert np.degrees(zenith) == pytest.approx(48.2 if expected == 270 else 90, abs=1)


def test_a_day_holds_the_skies_of_the_runtime(tmp_path: Path) -> None:
    code, out, err = export(tmp_path / "day.json", "--step", "30", "--exposure", "0.01")
    assert (code, err) == (0, "")
    assert "16 times with the sun below the horizon are left out." in out
    made = json.loads((tmp_path / "day.json").read_text(encoding="utf-8"))
    assert (made["axes_in_words"], made["exposure"]) == ("east is +x, north is +z, up is +y; left-handed", 0.01)
    assert len(made["skies"]) == 32
    assert made["skies"][0]["time"] == "2024-06-21T05:00:00+02:00"
    loaded, unity = runtime.load(TABLE), engines.PROFILES["unity"]
    for sky in made["skies"]:
        weights = loaded.weights(sky["sun_zenith"], sky["sun_azimuth"], 3.0, bands=3)
        assert sky["sky"] == engines.structure(engines.convert(weights, unity, exposure=0.01), unity)
    assert [path.name for path in tmp_path.iterdir()] == ["day.json"]

    assert export(tmp_path / "day.csv", "--step", "30", "--exposure", "0.01", "--night", "zero")[0] == 0
    rows = list(csv.reader((tmp_path / "day.csv").read_text(encoding="utf-8").splitlines()))
    assert rows[0][:5] == ["time", "sun_zenith", "sun_azimuth", "red_0", "red_1"]
    assert len(rows) == 1 + 48
    lit = {row[0]: row[3:] for row in rows[1:] if any(float(v) for v in row[3:])}
    assert list(lit) == [sky["time"] for sky in made["skies"]]
    for sky in made["skies"]:
        assert [float(v) for v in lit[sky["time"]]] == [v for channel in sky["sky"] for v in channel]


def test_morning_light_comes_from_the_east(tmp_path: Path) -> None:
    """Unity's weight 3 multiplies its x, which is east."""
    export(tmp_path / "day.json")
    skies = json.loads((tmp_path / "day.json").read_text(encoding="utf-8"))["skies"]
    assert min(skies[1]["sky"][0][3], -skies[-2]["sky"][0][3]) > 1000


def test_days_of_23_hours_and_without_sun(tmp_path: Path) -> None:
    assert len(list(solar.moments(date(2024, 3, 31), "Europe/Vienna", 60))) == 23
    code, out, _ = export(tmp_path / "night.json", "--latitude", "80", "--date", "2024-12-21")
    assert code == 0
    assert "0 skies" in out
    assert json.loads((tmp_path / "night.json").read_text(encoding="utf-8"))["skies"] == []


@pytest.mark.parametrize(
    ("more", "message"),
    [
        (("--latitude", "91"), "Invalid latitude 91.0. Should be degrees from -90 to 90"),
        (("--longitude", "nan"), "Invalid longitude nan"),
        (("--timezone", "Mars/Olympus"), "Should be an IANA name"),
        (("--timezone", "../etc"), "Should be an IANA name"),
        (("--date", "2024-02-30"), "2024-02-30"),
        (("--date", "9999-12-31"), "Invalid date"),
        (("--step", "0"), "--step"),
        (("--turbidity", "nan"), "Should be finite"),
        (("--at", "albedo=1"), "albedo is no axis"),
        (("--at", "sun_zenith=1"), "The date and the place"),
        (("--bands", "4"), "Invalid bands 4"),
        (("--axes", "y"), "Invalid axes"),
    ],
)
def test_bad_input_is_refused_and_nothing_written(tmp_path: Path, more: tuple[str, ...], message: str) -> None:
    code, _, err = export(tmp_path / "day.json", *more)
    assert code == 2
    assert message in err
    assert not list(tmp_path.iterdir())


def test_an_output_of_another_kind_is_refused(tmp_path: Path) -> None:
    code, _, err = export(tmp_path / "day.xml")
    assert code == 2
    assert "Should end in .json or .csv" in err


def test_a_clamped_sky_is_told(tmp_path: Path) -> None:
    code, _, err = export(tmp_path / "day.json", "--turbidity", "9")
    assert code == 0
    assert "16 skies lie outside the table and were clamped" in err


def test_without_astral_the_remedy_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "astral", None)
    with pytest.raises(MissingExtraError, match=r"pip install 'skylight-sh\[solar\]'"):
        solar.position(solar.Place(0, 0), datetime(2024, 1, 1, tzinfo=UTC))
    assert day.WRITERS.keys() == {".json", ".csv"}
