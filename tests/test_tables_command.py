"""The command ``tables``: lists, comparisons and advice, over summaries written by hand and the released reference."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import ROOT, with_spec
from skylight_sh import runtime
from skylight_sh.report.advice import Limits, advise
from skylight_sh.report.published_tables import PublishedTable
from skylight_sh.report.timings import Timing
from skylight_sh.runtime import Surroundings
from skylight_sh.table import difference, npz
from test_cli import invoke

REFERENCE = ROOT / "reports" / "reference"

# name, bands, layout, bytes, E_mean, E_max, nanoseconds or None, E_mean over the first 1, 2, .. bands.
ROWS = (
    ("small", 3, "packed", 600, 0.012, 0.05, 4000.0, (0.003, 0.008)),
    ("quick", 3, "rows", 1800, 0.011, 0.04, 80.0, (0.002, 0.007)),
    ("exact", 3, "rows", 2600, 0.0009, 0.003, 95.0, (0.0002, 0.0006)),
    ("large", 5, "rows", 5200, 0.0012, 0.006, 150.0, (0.0003, 0.0005, 0.0007, 0.0009)),
)


def publish(
    reports: Path, run: str, rows: Sequence[tuple[Any, ...]] = ROWS, scene: str = "radiance", low: float = 2.0
) -> Path:
    """Write a run's summary, errors and benchmark as the documented formats have them."""
    folder = reports / run
    (folder / "bench").mkdir(parents=True)
    axes = [{"name": "sun_zenith", "range": [0.0, np.pi / 2]}, {"name": "turbidity", "range": [low, 6.0]}]
    config = {"name": run, "light": {"model": "preetham"}, "axes": axes, "scene": {"quantity": scene, "ground": "black"}}
    keys = ("name", "bands", "layout", "bytes", "e_mean", "e_max")
    tables = []
    errors = ["table,dtype,bands,channel,l_min,e_max,e_mean"]
    candidates = []
    for row in rows:
        name = row[0]
        more = {"path": f"export/{name}", "prefix": f"sky_{name}", "l_min": "per-set", "quantity": scene, "dtype": "float32"}
        tables.append({**dict(zip(keys, row, strict=False)), **more})
        for bands, error in enumerate(row[7], 1):
            # The worst channel counts, and the convention of the summary alone.
            errors.append(f"{name},float32,{bands},red,per-set,{3 * error},{error}")
            errors.append(f"{name},float32,{bands},blue,per-set,{2 * error},{error / 2}")
            errors.append(f"{name},float32,{bands},red,mean,{30 * error},{10 * error}")
        if row[6] is not None:
            times = {"portable": {"ns": {"median": row[6]}}}
            kind = "packed table" if row[2] == "packed" else "table"
            candidates.append({"name": name, "kind": kind, "bytes": row[3], "times": times})
    machine = {"processor": "Abacus 9", "compiler": "cc (Some) 1"}
    (folder / "bench" / "speed.json").write_text(json.dumps({"machine": machine, "candidates": candidates}))
    (folder / "summary.json").write_text(json.dumps({"config": config, "recommended": rows[0][0], "tables": tables}))
    (folder / "errors.csv").write_text("\n".join([*errors, ""]))
    return folder


def listed(reports: Path, *more: str) -> list[dict[str, Any]]:
    code, out, _ = invoke("tables", "--reports", str(reports), "--json", *more)
    assert code == 0
    found: list[dict[str, Any]] = json.loads(out)["tables"]
    return found


def advice(reports: Path, *more: str) -> tuple[int, list[dict[str, Any]]]:
    code, out, _ = invoke("tables", "--reports", str(reports), "--json", *more)
    return code, json.loads(out)["advice"]


def test_tables_of_all_runs_are_listed_by_size_in_columns(tmp_path: Path) -> None:
    publish(tmp_path, "one")
    publish(tmp_path, "two", [("odd", 4, "rows", 1234567, 0.5, 1.25, None, ())])
    code, out, err = invoke("tables", "--reports", str(tmp_path))
    assert code == 0
    assert err == ""
    lines = out.splitlines()
    assert lines[0].split() == ["run", "table", "bands", "layout", "bytes", "ns", "e_mean", "e_max", "quantity", "path"]
    assert [line.split()[1] for line in lines[1:6]] == ["small", "quick", "exact", "large", "odd"]
    assert lines[1].split()[:11] == ["one", "small", "3", "packed", "600", "4,000", "1.2", "%", "5", "%", "radiance"]
    assert "1,234,567" in lines[5]
    assert "- not timed" in lines[5]
    assert lines[5].endswith((tmp_path / "two" / "export" / "odd").as_posix())
    place = lines[0].index("bytes") + len("bytes")
    assert [line[place - 1] != " " and line[place] == " " for line in lines[:6]] == [True] * 6
    assert out.count("Abacus 9") == 1


@pytest.mark.parametrize(
    ("key", "order"),
    [("ns", "quick exact large small"), ("e_max", "exact large quick small"), ("table", "exact large quick small")],
)
def test_the_list_is_sorted_as_asked(tmp_path: Path, key: str, order: str) -> None:
    publish(tmp_path, "one")
    assert [row["table"] for row in listed(tmp_path, "--sort", key)] == order.split()


def test_runs_that_are_named_alone_are_listed(tmp_path: Path) -> None:
    publish(tmp_path, "one")
    publish(tmp_path, "two")
    assert {row["run"] for row in listed(tmp_path, "two")} == {"two"}
    code, _, err = invoke("tables", "--reports", str(tmp_path), "three")
    assert code == 2
    assert "'three'" in err
    assert "one, two" in err
    code, _, err = invoke("tables", "--reports", str(tmp_path / "none"))
    assert code == 2
    assert "skylight-sh run" in err


@pytest.mark.parametrize(
    ("spoil", "told"),
    [
        (lambda text: text[:40], "line 1 column"),
        (lambda text: text.replace('"bytes": 600', '"bytes": -600'), "-600"),
        (lambda text: text.replace('"layout"', '"lay"'), "'layout'"),
        (lambda _: "[]", "not what a run writes"),
    ],
)
def test_a_damaged_summary_is_told_and_hides_no_other(tmp_path: Path, spoil: Any, told: str) -> None:
    publish(tmp_path, "good")
    place = publish(tmp_path, "bad") / "summary.json"
    place.write_text(spoil(place.read_text()))
    code, out, err = invoke("tables", "--reports", str(tmp_path))
    assert code == 0
    assert out.count("good ") == len(ROWS)
    assert str(place) in err
    assert told in err
    assert "skylight-sh run bad" in err
    assert invoke("tables", "--reports", str(tmp_path), "bad")[0] == 1


def test_a_damaged_benchmark_and_other_bytes_are_told_in_a_word(tmp_path: Path) -> None:
    folder = publish(tmp_path, "one")
    place = folder / "bench" / "speed.json"
    place.write_text(place.read_text().replace('"bytes": 1800', '"bytes": 1801'))
    rows = {row["table"]: row for row in listed(tmp_path)}
    assert rows["quick"]["ns"] is None
    assert rows["quick"]["untimed"] == "other bytes timed"
    place.write_text("{")
    assert {row["untimed"] for row in listed(tmp_path)} == {"damaged"}


def test_the_reference_has_its_released_times() -> None:
    candidates = json.loads((REFERENCE / "speed.json").read_text())["candidates"]
    times = {(row["name"], row["bytes"]): row["times"]["portable"]["ns"]["median"] for row in candidates}
    summary = json.loads((REFERENCE / "summary.json").read_text())["tables"]
    found = {row["table"]: row for row in listed(REFERENCE.parent, "reference")}
    assert set(found) == {row["name"] for row in summary}
    for row in summary:
        mine = found[row["name"]]
        assert (mine["bytes"], mine["e_mean"], mine["e_max"]) == (row["bytes"], row["e_mean"], row["e_max"])
        assert mine["ns"] == times.get((row["name"], row["bytes"]))
        assert (ROOT / mine["path"]).is_dir()


@pytest.mark.parametrize(
    ("limits", "table", "bands"),
    [
        # As many bands as the limits allow, then the fewest bytes.
        ("--max-error 2%", "large", 5),
        ("--max-error 0.1%", "large", 4),
        ("--max-error 0.1% --max-bytes 3KB", "exact", 3),
        ("--max-error 0.001 --max-bytes 3KB --max-ns 0.1us", "exact", 3),
        # So many bands: the error over these alone counts.
        ("--max-error 0.8% --bands 2", "small", 2),
        ("--max-error 0.75% --bands 2", "quick", 2),
        ("--max-error 0.8% --bands 2 --max-ns 100", "quick", 2),
        ("--max-error 0.05% --bands 2", "large", 2),
        # Where the error is free, the least.
        ("--max-bytes 2600 --bands 3", "exact", 3),
        ("--max-ns 90 --bands 3", "quick", 3),
        # Nothing but bands: 0.1 %.
        ("--bands 3", "exact", 3),
        ("--quantity radiance", "large", 4),
    ],
)
def test_advice_takes_what_the_limits_leave(tmp_path: Path, limits: str, table: str, bands: int) -> None:
    publish(tmp_path, "one")
    code, found = advice(tmp_path, *limits.split())
    assert code == 0
    (given,) = found
    assert (given["take"]["table"], given["take"]["evaluate_bands"]) == (table, bands)


def test_advice_says_why_in_words(tmp_path: Path) -> None:
    publish(tmp_path, "one")
    code, out, _ = invoke("tables", "--reports", str(tmp_path), "--max-error", "0.1%", "--max-ns", "200", "--bands", "4")
    assert code == 0
    assert "Take one/large and evaluate 4 of its 5 bands: 5,200 bytes, 150 ns a call for all bands" in out
    # The worst channel's: three times E_mean as written above.
    assert "E_mean 0.09 %, E_max 0.27 %" in out
    assert "The next smaller, one/exact, 3 bands, has 2,600 bytes, 95 ns a call" in out
    assert "over the limit on bands" in out
    assert "sky_large_weights_bands(.., 4, ..)" in out
    assert "Abacus 9" in out


@pytest.mark.parametrize(
    ("limits", "told", "nearest"),
    [
        ("--max-bytes 500", "500 bytes: the smallest has 600", "small"),
        ("--max-ns 40", "40 ns: the fastest takes 80 ns", "quick"),
        ("--max-error 0.01% --bands 3", "an E_mean of 0.01 %: the least is 0.07 %", "large"),
        ("--bands 6", "6 bands: the most are 5", "large"),
        ("--max-bytes 2KB --max-error 0.1% --bands 3", "2,000 bytes, E_mean 0.1 % over 3 bands together by none", "exact"),
    ],
)
def test_where_nothing_keeps_to_the_limits_the_nearest_is_told(tmp_path: Path, limits: str, told: str, nearest: str) -> None:
    publish(tmp_path, "one")
    code, out, _ = invoke("tables", "--reports", str(tmp_path), *limits.split())
    assert code == 1
    assert told in out
    assert f"one/{nearest}, " in out
    assert "comes nearest" in out
    code, (given,) = advice(tmp_path, *limits.split())
    assert code == 1
    assert given["take"] is None
    assert given["nearest"]["table"] == nearest


def test_without_errors_by_bands_only_whole_tables_are_advised(tmp_path: Path) -> None:
    folder = publish(tmp_path, "one")
    (folder / "errors.csv").unlink()
    code, (given,) = advice(tmp_path, "--max-error", "0.1%", "--bands", "2")
    assert code == 1
    assert "no errors.csv" in given["why"]
    assert advice(tmp_path, "--max-error", "0.1%", "--bands", "3")[1][0]["take"]["table"] == "exact"
    (folder / "errors.csv").write_text("table,bands,l_min\nexact,2,per-set\n")
    code, out, err = invoke("tables", "--reports", str(tmp_path), "--max-error", "0.1%", "--bands", "3")
    assert code == 0
    assert "Take one/exact" in out
    assert str(folder / "errors.csv") in err


def test_skies_that_differ_are_advised_apart_and_quantities_chosen(tmp_path: Path) -> None:
    publish(tmp_path, "one")
    publish(tmp_path, "same", [("spare", 3, "rows", 2500, 0.0008, 0.002, 70.0, (0.0001, 0.0002))])
    publish(tmp_path, "wider", low=1.8)
    publish(tmp_path, "lit", scene="irradiance")
    code, found = advice(tmp_path, "--max-error", "0.1%", "--bands", "3")
    assert code == 0
    assert [(each["runs"], each["take"]["run"]) for each in found] == [
        (["lit"], "lit"),
        (["one", "same"], "same"),
        (["wider"], "wider"),
    ]
    assert found[0]["quantity"] == "diffuse irradiance in lux"
    _, found = advice(tmp_path, "--max-error", "0.1%", "--quantity", "irradiance")
    assert [each["runs"] for each in found] == [["lit"]]
    code, _, err = invoke("tables", "--reports", str(tmp_path), "one", "--quantity", "irradiance")
    assert code == 1
    assert "irradiance" in err


@pytest.mark.parametrize(
    ("option", "value", "allowed"),
    [
        ("--max-bytes", "2KiB", "1 byte to 1,000,000,000"),
        ("--max-bytes", "0", "1 byte to 1,000,000,000"),
        ("--max-bytes", "1.5", "whole"),
        ("--max-ns", "fast", "1 to 1,000,000,000 nanoseconds"),
        ("--max-error", "5", "at most 100 %"),
        ("--max-error", "0%", "above 0 %"),
        ("--max-error", "-1%", "above 0 %"),
        ("--bands", "0", "1<=x<=64"),
        ("--quantity", "luminance", "'irradiance'"),
    ],
)
def test_bad_limits_name_option_value_and_range(tmp_path: Path, option: str, value: str, allowed: str) -> None:
    publish(tmp_path, "one")
    code, _, err = invoke("tables", "--reports", str(tmp_path), f"{option}={value}")
    assert code == 2
    assert option in err
    assert value in err
    assert allowed in " ".join(err.split())


def made(name: str, size: int, ns: float | None, bands: int) -> PublishedTable:
    """A table of which its cost alone matters."""
    return PublishedTable(
        reports=Path(),
        run="r",
        name=name,
        folder=Path(name),
        prefix="p",
        bands=bands,
        layout="rows",
        bytes=size,
        e_mean=0.0,
        e_max=0.0,
        convention="per-set",
        quantity="radiance",
        unit="",
        sky="",
        sky_words="",
        recommended=False,
        timing=None if ns is None else Timing(ns),
        untimed="" if ns else "not timed",
        machine="",
    )


def test_advice_is_what_trying_everything_finds() -> None:
    """Against all tables and numbers of bands, for a thousand random wishes."""
    dice = np.random.default_rng(14)

    def throw(low: int, high: int) -> int:
        return int(dice.integers(low, high + 1))

    taken = 0
    for _ in range(1000):
        tables, errors = [], []
        for i in range(throw(1, 6)):
            bands = throw(1, 5)
            tables.append(made(f"t{i}", throw(1, 9), (None, 1.0, 2.0, 4.0)[throw(0, 3)], bands))
            errors.append({n: (throw(1, 9) / 100, 1.0) for n in range(1, bands + 1)})
        size, ns, error, asked = ((None, throw(1, 9))[throw(0, 1)] for _ in range(4))
        limits = Limits(size, None if ns is None else float(ns), (error or 5) / 100, asked)
        kept = [
            (0 if asked else -n, table.bytes, known[n][0])
            for table, known in zip(tables, errors, strict=True)
            for n in known
            if (size is None or table.bytes <= size)
            and (ns is None or (table.ns is not None and table.ns <= ns))
            and known[n][0] <= (error or 5) / 100
            and asked in (None, n)
        ]
        found = advise(tables, errors, limits)
        assert (found.take is None) == (not kept)
        assert (found.nearest is None) == bool(kept)
        if found.take:
            taken += 1
            assert (0 if asked else -found.take.bands, found.take.table.bytes, found.take.e_mean) == min(kept)
            assert found.take.e_mean == errors[tables.index(found.take.table)][found.take.bands][0]
    assert 200 < taken < 900


def test_two_tables_side_by_side() -> None:
    reports = ("--reports", str(REFERENCE.parent))
    code, out, _ = invoke("tables", *reports, "--compare", "reference/7-bands-0.1pct", "reference/7-bands-0.005pct")
    assert code == 0
    rows = {line.split()[0]: line for line in out.splitlines() if line}
    assert rows["table"].split() == ["table", "7-bands-0.1pct", "7-bands-0.005pct"]
    assert "Greatest difference of a weight over 7 bands" in out
    code, out, _ = invoke("tables", *reports, "--compare", "reference", "reference/7-bands-0.1pct", "--json")
    assert json.loads(out)["difference"]["greatest"] == 0.0
    code, _, err = invoke("tables", *reports, "--compare", "reference", "reference/8-bands")
    assert code == 2
    assert "reference/8-bands" in err
    assert "reference/7-bands-0.1pct-packed" in err
    code, _, err = invoke("tables", *reports, "--compare", "reference", "reference", "--bands", "3")
    assert code == 2
    assert "--compare" in err


def test_a_name_that_two_runs_have_must_name_its_run(tmp_path: Path) -> None:
    publish(tmp_path, "one")
    publish(tmp_path, "two")
    code, _, err = invoke("tables", "--reports", str(tmp_path), "--compare", "quick", "two/quick")
    assert code == 2
    assert "one/quick, two/quick" in err
    # Tables whose files are gone still stand side by side.
    code, out, _ = invoke("tables", "--reports", str(tmp_path), "--compare", "one/quick", "two/quick")
    assert code == 0
    assert "Weights are not compared" in out


def test_the_greatest_difference_is_found_where_it_was_put() -> None:
    table = runtime.read(REFERENCE / "export" / "skylight_sh.npz")
    own = np.zeros((3, 49))
    own[1, 5] = 12.5  # green, l = 2, m = -1
    found = difference.greatest(table, replace(table, surroundings=Surroundings(own=own)))
    assert (found.channel, found.l, found.m, found.bands) == ("green", 2, -1, 7)
    # Weights are float32, so that sums with 12.5 round.
    assert found.greatest == pytest.approx(12.5, rel=1e-3)


def test_differences_that_grow_towards_a_range_s_end_are_found_there() -> None:
    """Against a walk along the axis: what the light below adds is a multiple of the weight l = 1, m = 0."""
    table = runtime.read(REFERENCE / "export" / "skylight_sh.npz")
    below = np.zeros((3, 49))
    below[2, 0] = 0.5
    found = difference.greatest(table, replace(table, surroundings=Surroundings(below=below)))
    zenith, turbidity = np.meshgrid(np.linspace(0, np.pi / 2, 91), np.linspace(2.5, 6, 36))
    walked = 0.5 * np.abs(runtime.Runtime(table).weights(zenith, 0.0, turbidity)[..., 2, 2]).max()
    assert found.greatest == pytest.approx(walked, rel=2e-3)
    assert found.channel == "blue"
    assert 0 < found.relative < 0.5


def test_tables_that_cannot_be_compared_say_why(tmp_path: Path) -> None:
    table = runtime.read(REFERENCE / "export" / "skylight_sh.npz")
    axes = (table.axes[0], replace(table.axes[1], name="brightness"))
    assert "brightness" in difference.incomparable(table, with_spec(table, axes=axes))
    assert "channels" in difference.incomparable(table, with_spec(table, channels=("x", "y", "z")))
    assert "irradiance" in difference.incomparable(table, with_spec(table, quantity="irradiance"))
    moved = replace(table.axes[1], low=7.0, high=8.0)
    assert "turbidity" in difference.incomparable(table, with_spec(table, axes=(table.axes[0], moved)))
    with pytest.raises(ValueError, match="channels"):
        difference.greatest(table, with_spec(table, channels=("x", "y", "z")))
    for name, one in (("quick", table), ("exact", with_spec(table, channels=("x", "y", "z")))):
        folder = tmp_path / "one" if (tmp_path / "one").is_dir() else publish(tmp_path, "one")
        (folder / "export" / name).mkdir(parents=True)
        (folder / "export" / name / "skylight_sh.npz").write_bytes(npz.write(one))
    code, out, _ = invoke("tables", "--reports", str(tmp_path), "--compare", "quick", "exact")
    assert code == 0
    assert "Weights are not compared: their channels differ, red, green, blue against x, y, z." in out


def test_the_command_needs_numpy_and_click_alone(tmp_path: Path) -> None:
    """Nothing that the extra for making tables brings, and for its help not even NumPy."""
    publish(tmp_path, "one")
    for arguments, heavy in (
        (["tables", "--help"], {"numpy"}),
        (
            ["tables", "--reports", str(tmp_path), "--max-error", "0.1%"],
            {"scipy", "matplotlib", "pydantic", "jinja2", "h5py"},
        ),
    ):
        body = f"from skylight_sh.cli import main\nmain({arguments}, standalone_mode=False)\nimport sys\n"
        body += f"assert not sys.modules.keys() & {heavy}"
        done = subprocess.run([sys.executable, "-c", body], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
