"""What to take for which need: a run's tables as answers, with what they cost, and which of them are one under two names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from skylight_sh.report.amounts import count, nanoseconds
from skylight_sh.report.report_data import Entry, ReportData
from skylight_sh.report.timings import Timings
from skylight_sh.runtime import Packed, Table
from skylight_sh.table.size import bytes_of

# What light of so many bands at most is for.
_USES = (
    (3, "diffuse surfaces without shadows of their own"),
    (5, "diffuse surfaces with soft shadows"),
    (8, "sharper shadows, normal maps, dull gloss"),
    (32, "gloss, and pictures that take their time"),
)


@dataclass(frozen=True)
class Choice:
    """A table as the answer to one or more ``needs``, with what it ``means`` in one line."""

    needs: str
    entry: Entry
    means: str


def choices(data: ReportData, timings: Timings) -> list[Choice]:
    """Return the recommended table first, then what is smallest, fastest, most exact, and what has fewer or more bands."""
    known = [entry for entry in data.winners if entry.name not in same_as(data.winners)]
    fast = [entry for entry in known if not isinstance(entry.table.body, Packed)]
    best = data.best
    found: list[tuple[str, Entry]] = [("most of all: recommended", best)]
    if len(known) > 1:
        found.append(("fewest bytes", min(known, key=lambda e: bytes_of(e.table))))
        timed = {e.name: t.ns for e in known if (t := timings.of(e.name, bytes_of(e.table)))}
        if len(timed) == len(known):
            found.append(("fastest call", min(known, key=lambda e: timed[e.name])))
        elif fast:
            found.append(("fewest bytes laid out for speed", min(fast, key=lambda e: bytes_of(e.table))))
        found.append(("least error", min(known, key=lambda e: e.headline[0])))
    for bands in sorted({e.table.bands for e in known} - {best.table.bands}):
        alike = [e for e in fast or known if e.table.bands == bands]
        if alike:
            word = "fewer" if bands < best.table.bands else "more"
            nearest = min(alike, key=lambda e: abs(np.log(max(e.headline[0], 1e-12) / max(best.headline[0], 1e-12))))
            found.append((f"{word} bands, about as exact", nearest))
    merged: dict[str, list[str]] = {}
    for need, entry in found:
        merged.setdefault(entry.name, []).append(need)
    by_name = {entry.name: entry for entry in data.winners}
    return [Choice("; ".join(needs), by_name[name], _means(by_name[name], timings)) for name, needs in merged.items()]


def same_as(winners: Sequence[Entry]) -> Mapping[str, str]:
    """Return the names of tables that hold the same numbers as an earlier one, each with that one's name."""
    first: dict[tuple[Any, ...], str] = {}
    found = {}
    for entry in winners:
        name = first.setdefault(_content(entry.table), entry.name)
        if name != entry.name:
            found[entry.name] = name
    return found


def _content(table: Table) -> tuple[Any, ...]:
    body = table.body
    parts = (getattr(body, field.name) for field in fields(body))
    held = (part.tobytes() if isinstance(part, np.ndarray) else part for part in parts)
    return (table.bands, table.degrees, str(table.dtype), body.kind, *(repr(part) for part in held))


def _means(entry: Entry, timings: Timings) -> str:
    """Return one line of what taking a table means."""
    table = entry.table
    timing = timings.of(entry.name, bytes_of(table))
    if table.spec.quantity == "irradiance":
        use = "irradiance by the surface's normal"
    else:
        use = next(told for most, told in _USES if table.bands <= most)
    if not isinstance(table.body, Packed):
        return f"{table.bands} bands: {use}"
    if timing and timing.unpack and timing.unpacked and timing.memory:
        cost = (
            f"each call decodes it; or unpack once in {nanoseconds(timing.unpack)} into {count(timing.memory)} bytes, "
            f"and a call takes {nanoseconds(timing.unpacked)}"
        )
    else:
        cost = "each call decodes it, which takes far longer than the sum: unpack it once where memory is cheap"
    return f"{table.bands} bands: {use}; packed: {cost}"


def scale(data: ReportData) -> str:
    """Return in words what errors of a run's tables are divided by."""
    luminance = "mean luminance" if data.conventions[0] == "mean" else "least luminance"
    if data.best.table.spec.quantity == "irradiance":
        return f"what an even sky gives in lux that has the same sky's {luminance} all over"
    return f"the {luminance} of the same sky"
