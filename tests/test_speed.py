"""The benchmark as a judge: its statistics on closed forms, and rivals that are what they are said to be."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import ROOT, SMALL
from numpy.polynomial import chebyshev
from numpy.typing import NDArray
from skylight_sh import sphere
from skylight_sh.config import load
from skylight_sh.export.target import Target
from skylight_sh.fit.axis import Axis
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import direction_sums
from skylight_sh.run.runner import Result
from skylight_sh.runtime import Packed, Table
from skylight_sh.studies import compiled, single_fit
from skylight_sh.studies.claims import readme
from skylight_sh.studies.grid_samples import Samples, sample
from skylight_sh.studies.published import exported
from skylight_sh.studies.speed import (
    batch,
    brute_force,
    contest,
    direct,
    entropy,
    evaluation,
    lookup,
    quoted,
    race,
    speed,
    unpacked,
    well_written,
)
from skylight_sh.studies.timing import clean_slices, ratios, spread
from skylight_sh.table.errors import headline

Array = NDArray[np.float64]
SKY = Preetham()


@pytest.fixture(scope="module")
def tables(small_run: Result) -> dict[str, Table]:
    return exported(small_run.folder)[0]


@pytest.fixture(scope="module")
def samples(tables: dict[str, Table]) -> Samples:
    config = load(SMALL)
    return sample(config, 4, random=100, like=tables[config.export.recommended])


def test_a_spread_is_of_the_middle_half_of_clean_rounds() -> None:
    rounds = [*range(1, 102), 1e6, 1e6]
    found = spread(rounds, [value < 1e6 for value in rounds])
    assert (found.low, found.median, found.high, found.kept) == (26, 51, 76, 101)
    assert found.spread == pytest.approx(50 / 51)
    assert found.noisy
    # A tenth is flagged, less is not.
    assert spread([0.95, 0.95, 1.0, 1.05, 1.05]).noisy
    assert not spread([0.96, 0.96, 1.0, 1.04, 1.04]).noisy
    # Too few clean rounds: all count, and are flagged though they agree.
    few = spread([1.0] * 9 + [3.0], [True] * 4 + [False] * 6)
    assert (few.median, few.kept, few.noisy) == (1.0, 4, True)
    with pytest.raises(ValueError, match="No rounds"):
        spread([])


def test_rounds_are_dropped_for_what_disturbs_them_alone() -> None:
    cpu, ticks = np.full((8, 2), 1e-3), np.full(8, 1e-4)
    wall = cpu + 4e-6
    # One thread waited; another round's processor was slower, and so was all in it.
    wall[2, 1] += 1e-3
    ticks[5] *= 1.2
    clean = clean_slices(cpu, wall, ticks)
    assert np.argwhere(~clean).tolist() == [[2, 1], [5, 0], [5, 1]]
    # A slice that took longer by its own clock is not dropped for that.
    cpu[3], wall[3] = 9e-3, 9e-3
    assert clean_slices(cpu, wall, ticks)[3].all()
    # Where most rounds are slow, the fast ones are kept.
    assert clean_slices(cpu, wall, [1e-4] * 3 + [2e-4] * 5)[:, 0].tolist() == [True] * 3 + [False] * 5


def test_what_slows_both_slows_neither() -> None:
    slow = np.array([1.0, 3.0, 1.5, 2.0, 1.0])
    found = ratios(6.0 * slow, 2.0 * slow)
    assert (found.median, found.spread, found.noisy) == (3.0, 0.0, False)


def test_lines_of_a_race_become_seconds_of_one_thing() -> None:
    """In whatever order entrants had their turns; a batch's call is many things."""
    lines = []
    for turn in range(6):
        told = [f"{turn} -1 1 1e-4 1e-4", f"{turn} 0 10 1e-3 1e-3", f"{turn} 1 2 4e-3 {5e-3 if turn == 4 else 4e-3}"]
        lines += told[turn % 3 :] + told[: turn % 3]
    found = race.laps("\n".join(lines), ("one", "batch"), np.array([1, 100]))
    assert found.time("one").median == pytest.approx(1e-4)
    assert found.time("batch").median == pytest.approx(2e-5)
    assert found.times_faster("batch", "one").median == pytest.approx(5.0)
    assert (found.times_faster("batch", "one").kept, found.dropped) == (5, 1)


def test_cold_rounds_are_medians_of_clean_calls() -> None:
    seconds = np.array([[1.0], [2.0], [9.0], [5.0], [6.0], [8.0]])
    clean = np.array([[True], [True], [False], [False], [False], [False]])
    found = race.grouped(race.Laps(("one",), seconds, clean, 4), 3)
    assert found.seconds.tolist() == [[1.5], [6.0]]
    assert found.clean.tolist() == [[True], [False]]
    assert found.dropped == 4


def polynomial(degree: int) -> lookup.Source:
    """The monomial of a degree on [-1, 1] as what tables are read off; two channels, the second twice the first."""
    coefficients = chebyshev.poly2cheb([0.0] * degree + [1.0])
    return lookup.Source((Axis("x", -1.0, 1.0),), None, np.multiply.outer([1.0, 2.0], coefficients)[:, np.newaxis])


def test_lookup_tables_interpolate_as_textbooks_say() -> None:
    sets = np.linspace(-1.0, 1.0, 2001)[:, np.newaxis]
    for kind, exact in (("linear", 1), ("cubic", 3)):
        for degree in (exact, exact + 1):
            made = polynomial(degree)
            found = lookup.interpolate(lookup.tabulate(made, [9], kind), made.axes, sets)
            off = np.abs(found[:, 0, 0] - sets[:, 0] ** degree).max()
            assert np.allclose(found[:, 1], 2 * found[:, 0])
            # Two points: h^2 / 8 times f''. Four: h^4 / 24 times the fourth derivative and |t (t-1) (t-2) (t-3)|, 1 at most.
            step = 2.0 / 8
            expected = 0.0 if degree == exact else step**2 / 4 if kind == "linear" else step**4
            assert off == pytest.approx(expected, rel=1e-4, abs=1e-12)


def test_a_lookup_table_has_the_error_that_it_is_said_to_have(
    tables: dict[str, Table], samples: Samples, tmp_path: Path
) -> None:
    """What the compiled table returns, against the light sampled directly; and no axis could do with a point less."""
    name = samples.config.export.recommended
    wanted = headline(tables[name], samples.reference)
    made = lookup.source(samples)
    for kind in lookup.POINTS:
        grid = lookup.as_exact_as(made, samples.reference, wanted, kind)
        assert grid
        found = lookup.candidate(grid, made, name)
        off = contest.error(samples, found, tmp_path)
        assert 0.6 * wanted < off < 1.001 * wanted
        assert found.bytes >= 4 * math.prod(grid.sizes) * 30
        truth = samples.reference.weights
        for axis in range(2):
            fewer = [size - (place == axis) for place, size in enumerate(grid.sizes)]
            if min(fewer) >= lookup.POINTS[kind]:
                values = lookup.interpolate(lookup.tabulate(made, fewer, kind), made.axes, samples.reference.parameters)
                values = values * made.factor(samples.reference.parameters)[:, np.newaxis, np.newaxis]
                errors = np.sqrt(((values - truth) ** 2).sum(axis=2)) / samples.reference.headline[:, np.newaxis]
                assert errors.max() > wanted
    assert lookup.as_exact_as(made, samples.reference, 1e-9, "linear") is None


def test_the_paper_written_well_is_the_paper_s_polynomials(samples: Samples, tmp_path: Path) -> None:
    """As exact as the same fit evaluated in double precision, and at any azimuth what the runtime makes of it."""
    made = single_fit.fit(samples, samples.half, single_fit.paper_degrees(samples), "monomial", "svd", "identity")
    table = single_fit.table_of(samples, made, "float64")
    found = well_written.well_written(samples)
    assert contest.error(samples, found, tmp_path) == pytest.approx(headline(table, samples.reference), rel=1e-3)
    assert found.bytes == 4 * made.dense.size
    sets = np.array([[0.3, 2.0, 3.0], [1.2, -1.0, 5.5]], dtype=np.float32)
    expected = sphere.rotate_azimuth(table.whole(table.evaluate(sets[:, [0, 2]]), 4), sets[:, 1, np.newaxis])
    got = compiled.weights(found.header, sets, tmp_path, ["-O2"])
    assert np.abs(got - expected).max() < 1e-5 * np.abs(expected).max()


def test_brute_force_sums_the_sky_over_its_directions(samples: Samples, tmp_path: Path) -> None:
    """As the same directions in double precision, for a turned sun too; and it errs as so many directions do."""
    sets = np.array([[0.2, 0.0, 3.0], [1.5, 2.2, 2.5], [0.9, -1.7, 5.9]], dtype=np.float32)
    got = compiled.weights(brute_force.header(SKY, 4), sets, tmp_path, ["-O2"])
    x, areas = sphere.gauss(brute_force.RINGS)
    around = 2 * np.pi * (np.arange(brute_force.TURNS) + 0.5) / brute_force.TURNS
    up = np.repeat((1 + x) / 2, around.size)
    turn = np.tile(around, x.size)
    where = np.stack([np.sqrt(1 - up**2) * np.cos(turn), np.sqrt(1 - up**2) * np.sin(turn), up], axis=-1)
    basis = direction_sums.tabulate(where, np.repeat(areas / 2 * 2 * np.pi / around.size, around.size), 4)
    for (theta, azimuth, tau), weights in zip(sets.astype(np.float64), got, strict=True):
        cosine, sine = np.cos(azimuth), np.sin(azimuth)
        turned = where @ np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
        light = SKY.radiance(turned, {"sun_zenith": np.array([theta]), "turbidity": np.array([tau])})
        assert np.abs(weights - light.T @ basis).max() < 2e-5 * np.abs(weights).max()
    projected = brute_force.brute_force(samples)
    assert projected
    assert 1e-4 < contest.error(samples, projected, tmp_path) < 1e-2


def test_entropy_of_what_is_known() -> None:
    """Even numbers of four bits cost four bits each; a run's end costs nothing where all runs are as long."""
    rng = np.random.default_rng(5)
    count, channels, first, rest = 40, 3, 8, 6
    numbers = rng.integers(-8, 8, size=(count, channels, first, rest))
    numbers[:, :, -1] = np.where(numbers[:, :, -1] == 0, 7, numbers[:, :, -1])
    found = entropy.bits(numbers, np.zeros(count, dtype=np.int64))
    assert found / numbers.size == pytest.approx(4.0, abs=0.05)
    # A coin of one in four.
    coins = (rng.random(100_000) < 0.25).astype(np.int64)
    expected = -(0.25 * math.log2(0.25) + 0.75 * math.log2(0.75))
    assert entropy.entropy(coins) / coins.size == pytest.approx(expected, abs=0.01)
    assert entropy.entropy(np.zeros(10, dtype=np.int64)) == 0.0


def test_packed_streams_are_near_their_entropy(tables: dict[str, Table]) -> None:
    rows = entropy.section(tables).rows
    assert len(rows) == 2
    for row in rows:
        assert -0.1 < float(str(row["over"])) < 0.6
        assert float(str(row["stream"])) < float(str(row["bytes"]))


def test_a_contest_of_a_small_run(
    tables: dict[str, Table], samples: Samples, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """All take part, the quadrature where the export has it; figures go to a file, pages and the README."""
    monkeypatch.setattr(direct, "TARGETS", {})
    name = samples.config.export.recommended
    assert direct.direct(name, tables[name]) is None
    stand_in = Target(
        lambda table, *_: {"a.h": compiled.header_of(table).encode()}, lambda t: None if t.bands == 4 else "no"
    )
    monkeypatch.setattr(direct, "TARGETS", {"direct": stand_in})
    builds = compiled.builds(tmp_path / "probe")
    assert next(iter(builds)) == "portable"
    assert list(builds)[-1] == "native"
    # One build, and a table a kind: compilers take their time.
    monkeypatch.setattr(compiled, "builds", lambda _: {"portable": builds["portable"]})
    monkeypatch.setattr(lookup, "MOST_BYTES", 200_000)
    monkeypatch.setattr(contest, "FEWEST", 1)
    tables = {key: tables[key] for key in (name, f"{name}-packed", "3-bands-degrees-6-4-float64")}
    found = contest.hold(samples, tables, 1)
    assert found.rounds == 8
    fast = [key for key, table in tables.items() if not isinstance(table.body, Packed)]
    assert len(fast) == 2
    assert set(found.rivals(f"{name}-packed")) == {name, *found.rivals(name)}
    for key in fast:
        rivals = found.rivals(key)
        assert (f"{key}: direct" in rivals) == (tables[key].bands == 4)
        assert (contest.WELL_WRITTEN in rivals) == (tables[key].bands == 4)
        assert sum(": lookup" in rival for rival in rivals) >= 1
        assert all(found.errors[rival] < 1.001 * found.errors[key] for rival in rivals if ": lookup" in rival)
    rows = evaluation.calls(found).rows
    assert len(rows) == len(found.candidates) * len(found.results)
    assert {row["table"] for row in evaluation.rivals(found).rows} >= set(tables)
    told_of = evaluation.calls(found)
    assert "were disturbed by other work" in told_of.text
    assert told_of.draw
    assert len(told_of.draw(told_of.rows).axes) == 2
    engines = quoted.section(found, name).rows
    assert engines[0]["frames late"] == 0
    speed.save(tmp_path, found)
    told = json.loads((tmp_path / speed.FILE).read_text(encoding="utf-8"))
    summary = {"tables": [{"name": name, "bands": 4}], "recommended": name}
    text = readme._speed(readme.Released(tmp_path, summary, {}, told, {}))
    assert f"| {name} |" in text
    assert told["machine"]["processor"] in " ".join(text.split())


def test_a_header_that_unpacks_is_timed_so(tables: dict[str, Table], samples: Samples, tmp_path: Path) -> None:
    """Decoding and calls after it, where a packed header has them; and names under a longer prefix are found."""
    name = samples.config.export.recommended
    header = compiled.header_of(tables[name])
    assert unpacked.unpacked(name, header, 3, 4) == {}
    # A stand-in: what it unpacks is a flag without which its weights are 0.
    header += """
#define BENCH_SH_UNPACKED 2
static inline void bench_sh_unpack(float memory[2]) { memory[0] = 0.0f; memory[1] = 1.0f; }
static inline int bench_sh_unpacked_weights(const float memory[2], float a, float b, float c, float w[3][16])
{
    if (memory[1] != 1.0f) { memset(w, 0, sizeof(float) * 48); return 2; }
    return bench_sh_weights(a, b, c, w);
}
"""
    found = unpacked.unpacked(name, header, 3, 4)
    assert [candidate.bytes for candidate in found.values()] == [8, 8]
    expected = headline(tables[name], samples.reference)
    assert contest.error(samples, found[f"{name}: unpacked table"], tmp_path) == pytest.approx(expected, rel=1e-3)
    told = race.run(
        {key: race.calls(c.header, [(0.0, 1.5), (-3.0, 3.0), (2.5, 6.0)]) for key, c in found.items()},
        ["-O2"],
        tmp_path / "race",
        rounds=3,
        cold=2,
    )
    assert told.cold
    assert (told.warm.seconds.shape, told.cold.seconds.shape) == ((3, 2), (2, 2))
    assert (told.warm.seconds > 0).all()
    longer = direct._renamed("int bench_sh_direct_weights(float a);")
    assert "#define bench_sh_weights bench_sh_direct_weights" in longer
    assert direct._renamed("int bench_sh_weights(float a);") == "int bench_sh_weights(float a);"


def test_a_batch_is_timed_beside_single_calls(
    tables: dict[str, Table], samples: Samples, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of the recommended table's packed twin too; in one build here."""
    monkeypatch.setattr(compiled, "builds", lambda _: {"portable": ["-O1"]})
    name = samples.config.export.recommended
    rows = batch.section({key: tables[key] for key in (name, f"{name}-packed")}, name, 1).rows
    assert [(row["table"], row["suns"]) for row in rows] == [
        (key, suns) for key in (name, f"{name}-packed") for suns in ("a day", "mixed weather")
    ]
    assert all(float(str(row["batch ns"])) > 0 for row in rows)
    # Three rounds are too few to be trusted.
    assert all("times faster" in str(row["noisy"]) for row in rows)


def record(high: float, median: float) -> dict[str, Any]:
    figure = {"median": median, "low": median, "high": high, "noisy": high > 1.1 * median}
    times = {"portable": {"warm": figure, "cold": figure}}
    candidate = {"kind": "table", "bands": 4, "times": {"portable": {"ns": {"median": 100.0}}}}
    names = ("paper-literal", "paper-well-written", "one")
    rivals = [{"table": "one", "rival": rival, "bytes": 3.0, "times": times} for rival in names[:2]]
    machine = {"processor": "a processor", "cores": 2, "system": "one", "compiler": "cc"}
    return {
        **{"machine": machine, "rounds": 42, "timings": 1000, "dropped": 3},
        **{"literal": names[0], "well_written": names[1], "rivals": rivals},
        "candidates": [candidate | {"name": n, "kind": "table" if n == "one" else "paper"} for n in names],
    }


def test_the_readme_says_where_a_rival_wins_and_what_is_noisy() -> None:
    summary = {"tables": [{"name": "one", "bands": 4}], "recommended": "one"}

    def told(high: float, median: float) -> str:
        return readme._speed(readme.Released(Path(), summary, {}, record(high, median), {}))

    assert "No rival is faster" in told(4.0, 3.9)
    assert "| 3.9 |" in told(4.0, 3.9)
    assert "| ~3.9 |" in told(9.0, 3.9)
    assert "- paper-literal: 2 times as fast as one, 3 times its bytes" in told(0.5, 0.5)
    assert "No rival is faster" in told(0.99, 0.99)
    packed = record(4.0, 3.9)
    given = {"bands": 4, "times": {"portable": {"ns": {"median": 5000.0}}}}
    packed["candidates"] = [*packed["candidates"], {**given, "name": "two", "kind": "packed table"}]
    text = readme._speed(readme.Released(Path(), summary, {}, packed, {}))
    assert "decode at every call, which takes 5,000 ns (-O3)." in text
    packed["candidates"] = [*packed["candidates"], *({**given, "name": k, "kind": k} for k in ("unpack", "unpacked table"))]
    text = " ".join(readme._speed(readme.Released(Path(), summary, {}, packed, {})).split())
    assert "decoded once in 5,000 ns, a call takes 5,000 ns." in text


def test_sources_of_quoted_costs_are_listed() -> None:
    listed = (ROOT / "docs" / "references.md").read_text(encoding="utf-8")
    for told in quoted.QUOTED:
        assert told.source in listed


def test_a_variable_that_is_even_is_not_a_lookup_table_s(samples: Samples) -> None:
    first, *rest = samples.axes
    made = lookup.source(replace(samples, axes=(replace(first, map="identity"), *rest)))
    assert made.axes[0].map == "identity"
    assert lookup._uneven(first).point > first.high
