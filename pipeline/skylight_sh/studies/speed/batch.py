"""Batches of suns beside single calls of the same suns, and beside what storing their weights costs."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from skylight_sh.runtime import Packed, Table
from skylight_sh.studies import compiled, outcomes
from skylight_sh.studies.page import Row, Section
from skylight_sh.studies.speed import contest, race
from skylight_sh.studies.timing import Spread

_SUNS = 4096
_SINGLE, _BATCH, _COLUMNS, _STORES = "single calls", "a batch", "columns", "stores"
_DAY, _MIXED = "a day", "mixed weather"
TEXT = (
    "4,096 suns, nanoseconds of CPU time a sun: single calls in a loop against one batch of the same suns. `a day` differs "
    "in the first axis and azimuth alone, so that a batch sums the other axes once; in `mixed weather` every sun has its "
    "own. `times faster` is the batch than the single calls, round by round, and its `spread` the interquartile range over "
    "the median; `columns` is the batch whose output has the suns of each weight side by side; `over stores` how many "
    "times as long it takes as writing its output takes alone. Single calls of a packed table decode it each time. All of "
    "a build take turns in one process."
)


def section(tables: Mapping[str, Table], recommended: str, repeats: int) -> Section:
    """Time every table laid out for speed, in every build; of packed ones that of the ``recommended`` budget, portable."""
    fast = {name: table for name, table in tables.items() if not isinstance(table.body, Packed)}
    packed = {name: table for name, table in tables.items() if name not in fast and contest.twin_of(name) == recommended}
    rows: list[Row] = []
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        for build, flags in compiled.builds(place / "probe").items():
            timed = fast | (packed if build == "portable" else {})
            entrants = {key: entrant for name, table in timed.items() for key, entrant in _entrants(name, table).items()}
            found = race.run(entrants, flags, place / build, 3 * repeats).warm
            for name in timed:
                for suns in (_DAY, _MIXED):
                    single, batch, columns, stores = (
                        f"{name}, {suns}, {what}" for what in (_SINGLE, _BATCH, _COLUMNS, _STORES)
                    )
                    ratios = {
                        "times faster": found.times_faster(batch, single),
                        "columns times faster": found.times_faster(columns, single),
                        "over stores": found.times_faster(stores, batch),
                    }
                    rows.append(
                        {
                            "table": name,
                            "build": build,
                            "suns": suns,
                            "single ns": 1e9 * found.time(single).median,
                            "batch ns": 1e9 * found.time(batch).median,
                            "columns ns": 1e9 * found.time(columns).median,
                            **{f"{what}{part}": value for what, ratio in ratios.items() for part, value in _told(ratio)},
                            "noisy": ", ".join(what for what, ratio in ratios.items() if ratio.noisy),
                        }
                    )
    return Section("batch", "Batches of 4,096 suns", TEXT, rows, told=outcomes.batches(rows))


def _told(ratio: Spread) -> list[tuple[str, float]]:
    return [("", ratio.median), (": spread", ratio.spread)]


def _entrants(name: str, table: Table) -> dict[str, race.Entrant]:
    header, axes = compiled.header_of(table), [(axis.low, axis.high) for axis in table.axes]
    fixed = table.spec.azimuth is not None
    mixed = contest.ranges_of(axes, fixed_azimuth=fixed)
    middle = [axes[0], *(((low + high) / 2, (low + high) / 2) for low, high in axes[1:])]
    day = contest.ranges_of(middle, fixed_azimuth=fixed)
    return {
        f"{name}, {suns}, {what}": race.Entrant(header, _source(ranges, what), _SUNS)
        for suns, ranges in ((_DAY, day), (_MIXED, mixed))
        for what in (_SINGLE, _BATCH, _COLUMNS, _STORES)
    }


def _source(ranges: Sequence[tuple[float, float]], what: str) -> str:
    return race.template(
        "batch.c.j2",
        p=compiled.PREFIX,
        P=compiled.PREFIX.upper(),
        suns=_SUNS,
        what=what,
        names=range(len(ranges)),
        lows=[repr(float(low)) for low, _ in ranges],
        spans=[repr(float(high - low)) for low, high in ranges],
        steps=[repr(step) for step in race.even_steps(len(ranges))],
    )
