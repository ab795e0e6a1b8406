"""Programs timed against each other in C: one process, rounds that take turns, CPU clock, warm and with a cold cache."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape
from numpy.typing import NDArray

from skylight_sh.studies import compiled
from skylight_sh.studies.timing import Spread, clean_slices, spread

Array = NDArray[np.float64]

SETS = 512
"""How many sets of inputs the calls go through."""
_SLICE = 400
"""Microseconds of a candidate's slice in a round."""
COLD_CALLS = 7
"""How many cold calls a round's figure is the median of: one call alone is a matter of chance."""


@dataclass(frozen=True)
class Entrant:
    """What takes part: a ``header``, and a C ``source`` that includes it as table.h and defines ``prepare`` and ``call``.

    ``call(first, calls)`` does so many calls; one of them does ``work`` things, and times are told of one thing.
    """

    header: str
    source: str
    work: int = 1


@dataclass(frozen=True)
class Laps:
    """Seconds of each entrant ``(rounds, entrants)``, which rounds were ``clean``, and how many timings were ``dropped``."""

    names: tuple[str, ...]
    seconds: Array
    clean: NDArray[np.bool_]
    dropped: int

    def time(self, name: str) -> Spread:
        """Return an entrant's seconds."""
        i = self.names.index(name)
        return spread(self.seconds[:, i], self.clean[:, i])

    def times_faster(self, name: str, base: str) -> Spread:
        """Return how many times as long as ``name`` the entrant ``base`` takes, round by round where both were clean."""
        i, j = self.names.index(name), self.names.index(base)
        return spread(self.seconds[:, j] / self.seconds[:, i], self.clean[:, i] & self.clean[:, j])


@dataclass(frozen=True)
class Result:
    """A race's ``warm`` rounds and ``cold`` calls."""

    warm: Laps
    cold: Laps | None


def run(
    entrants: Mapping[str, Entrant], flags: Sequence[str], place: Path, rounds: int, cold: int = 0, slice_us: int = _SLICE
) -> Result:
    """Compile the entrants with ``cc`` and ``flags`` in ``place``; let them take turns for ``rounds`` and ``cold`` rounds.

    A cold round is ``COLD_CALLS`` calls of each, every one after 64 MB of other memory was written.
    Raises OSError where there is no compiler, or it refuses a source.
    """
    program = _program(list(entrants.values()), flags, place)
    sizes = [str(rounds), str(slice_us), str(cold * COLD_CALLS)]
    told = subprocess.run([str(program), *sizes], check=True, capture_output=True, text=True).stdout
    warm, _, rest = told.partition("\n\n")
    work = np.array([entrant.work for entrant in entrants.values()])
    names = tuple(entrants)
    return Result(laps(warm, names, work), grouped(laps(rest, names, work), COLD_CALLS) if cold else None)


def laps(told: str, names: tuple[str, ...], work: NDArray[np.int64]) -> Laps:
    """Return what lines of round, entrant (-1 for the tick), calls, CPU and wall seconds tell.

    ``work`` ``(entrants,)`` is how many things a call does.
    """
    rows = np.array([line.split() for line in told.splitlines() if line], dtype=np.float64)
    order = np.lexsort((rows[:, 1], rows[:, 0]))
    table = rows[order].reshape(-1, 1 + len(names), 5)
    cpu, wall, ticks = table[:, 1:, 3], table[:, 1:, 4], table[:, 0, 3]
    clean = clean_slices(cpu, wall, ticks)
    return Laps(names, cpu / (table[:, 1:, 2] * work), clean, int((~clean).sum()))


def grouped(found: Laps, each: int) -> Laps:
    """Return laps whose rounds are the medians of ``each`` rounds in a row, of the clean ones where there are any."""
    shape = (-1, each, len(found.names))
    seconds, clean = found.seconds.reshape(shape), found.clean.reshape(shape)
    some = np.asarray(clean.any(axis=1))
    kept = np.where(clean | ~some[:, np.newaxis], seconds, np.nan)
    return Laps(found.names, np.nanmedian(kept, axis=1), some, found.dropped)


def calls(header: str, ranges: Sequence[tuple[float, float]], work: int = 1) -> Entrant:
    """Return the entrant that calls ``_weights`` of a header with inputs that fill ``ranges`` (of each input, in order)."""
    source = _TEMPLATES.get_template("entrant.c.j2").render(
        p=compiled.PREFIX,
        P=compiled.PREFIX.upper(),
        sets=SETS,
        ranges=[(repr(float(low)), repr(float(high))) for low, high in ranges],
        spans=[repr(float(high - low)) for low, high in ranges],
        steps=[repr(step) for step in even_steps(len(ranges))],
    )
    return Entrant(header, source, work)


def even_steps(count: int) -> list[float]:
    """Return the steps of a sequence that fills a cube of ``count`` dimensions evenly (Roberts 2018).

    Powers of 1 / x, where x is the positive root of x^(count + 1) = x + 1.

    >>> [round(step, 6) for step in even_steps(2)]
    [0.754878, 0.56984]
    """
    root = 2.0
    for _ in range(60):
        root = (1.0 + root) ** (1.0 / (count + 1))
    return [root ** -(i + 1) for i in range(count)]


def template(name: str, **values: object) -> str:
    """Return a template of the studies, rendered."""
    return _TEMPLATES.get_template(name).render(**values)


def _program(entrants: Sequence[Entrant], flags: Sequence[str], place: Path) -> Path:
    def make(numbered: tuple[int, Entrant]) -> str:
        number, entrant = numbered
        folder = place / str(number)
        compiled.write(entrant.header, entrant.source, folder)
        names = [f"-Dprepare=prepare_{number}", f"-Dcall=call_{number}"]
        compiled.compile_c([*flags, *names, "-c", "main.c", "-o", "main.o"], folder)
        return f"{number}/main.o"

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = list(pool.map(make, enumerate(entrants)))
    listed = "".join(f"PREPARE({i})\nCALL({i})\n" for i in range(len(entrants)))
    (place / "entrants.h").write_text(listed, encoding="utf-8")
    (place / "race.c").write_text(template("race.c"), encoding="utf-8")
    compiled.compile_c(["-O2", "race.c", *objects, "-o", "race", "-lm"], place)
    return place / "race"


_TEMPLATES = Environment(
    loader=PackageLoader("skylight_sh.studies"),
    undefined=StrictUndefined,
    keep_trailing_newline=True,
    trim_blocks=True,
    lstrip_blocks=True,
    # C is no markup.
    autoescape=select_autoescape(default=False),
)
