"""What a call of a table was timed at: the released benchmark, for tables of the same name and bytes alone."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from skylight_sh import shipped

# The build whose figures are shown: what every compiler makes of the header.
BUILD = "portable"


@dataclass(frozen=True)
class Timing:
    """Nanoseconds of a call; of a packed table also of unpacking it, of a call after that, and the bytes it then takes."""

    ns: float
    unpack: float | None = None
    unpacked: float | None = None
    memory: int | None = None


@dataclass(frozen=True)
class Timings:
    """The released figures by a table's name and bytes, and the machine and compiler that they are of."""

    machine: str = ""
    by_table: Mapping[tuple[str, int], Timing] = field(default_factory=dict)

    def of(self, name: str, size: int) -> Timing | None:
        """Return what the table ``name`` of ``size`` bytes was timed at; None where that very table was not."""
        return self.by_table.get((name, size))


def released() -> Timings:
    """Return the figures that ship with the package; none where there are none."""
    place = shipped.speed()
    return read(place) if place else Timings()


def read(place: Path) -> Timings:
    """Return the figures of a benchmark's ``speed.json``. Raises KeyError, TypeError or ValueError where it is none."""
    told = json.loads(place.read_text(encoding="utf-8"))
    known = {row["name"]: row for row in told["candidates"]}

    def ns(name: str) -> float | None:
        return float(known[name]["times"][BUILD]["ns"]["median"]) if name in known else None

    found = {}
    for name, row in known.items():
        if row["kind"] in ("table", "packed table"):
            after = known.get(f"{name}: unpacked table")
            made = Timing(
                float(row["times"][BUILD]["ns"]["median"]),
                ns(f"{name}: unpack"),
                ns(f"{name}: unpacked table"),
                after and int(after["bytes"]),
            )
            found[name, int(row["bytes"])] = made
    machine = told["machine"]
    return Timings(f"{machine['processor']}, {machine['compiler'].partition(' (')[0]} -O3, one thread, warm cache", found)
