"""Every table and its rivals in one race a build: the paper's scheme, lookup tables as exact, quadrature, brute force."""

from __future__ import annotations

import math
import os
import tempfile
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from skylight_sh import sphere
from skylight_sh.export import paper_literal
from skylight_sh.fit.errors import e_mean
from skylight_sh.runtime import Packed, Table
from skylight_sh.studies import compiled, single_fit
from skylight_sh.studies.grid_samples import Samples
from skylight_sh.studies.speed import lookup, race
from skylight_sh.studies.speed.brute_force import brute_force
from skylight_sh.studies.speed.candidate import Candidate
from skylight_sh.studies.speed.direct import direct
from skylight_sh.studies.speed.unpacked import UNPACK, UNPACKED, unpacked
from skylight_sh.studies.speed.well_written import well_written
from skylight_sh.studies.timing import FEWEST
from skylight_sh.table.errors import headline
from skylight_sh.table.size import bytes_of

LITERAL = "paper-literal"
WELL_WRITTEN = "paper-well-written"
BRUTE_FORCE = "brute force, 1,024 directions"
TABLE, PACKED = "table", "packed table"
OURS = (TABLE, PACKED, UNPACKED)
# Warm rounds for each that a benchmark's medians are asked to be of: slices are short.
_WARM = 8


@dataclass(frozen=True)
class Contest:
    """Who took part, the E_mean of what each returns, the bytes of its code at -O3, and the results by build.

    What returns no weights has no E_mean.
    """

    candidates: Mapping[str, Candidate]
    errors: Mapping[str, float | None]
    code: Mapping[str, int | None]
    results: Mapping[str, race.Result]

    @property
    def rounds(self) -> int:
        """How many rounds the warm medians are of."""
        return len(next(iter(self.results.values())).warm.seconds)

    @property
    def timings(self) -> tuple[int, int]:
        """How many timings were dropped, of how many."""
        dropped = total = 0
        for result in self.results.values():
            for laps, each in ((result.warm, 1), (result.cold, race.COLD_CALLS)):
                if laps:
                    dropped, total = dropped + laps.dropped, total + each * laps.seconds.size
        return dropped, total

    def rivals(self, name: str) -> list[str]:
        """Return who stands against a table: those made as exact as its budget's, and those of as many bands for any.

        Against a packed table, unpacked or not, also the fast one of its budget.
        """
        bands, twin = self.candidates[name].bands, twin_of(name)
        return [
            other
            for other, candidate in self.candidates.items()
            if candidate.rival_of in (name, twin)
            or (other == twin != name)
            or (candidate.rival_of is None and candidate.kind not in (*OURS, UNPACK) and candidate.bands == bands)
        ]


def hold(samples: Samples, tables: Mapping[str, Table], repeats: int) -> Contest:
    """Time all candidates in turn, in every build that this processor runs, and measure what they return."""
    found = candidates(samples, tables)
    ranges = ranges_of([axis.range for axis in samples.config.axes], fixed_azimuth=False)
    entrants = {name: race.calls(candidate.header, ranges) for name, candidate in found.items()}
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        builds = compiled.builds(place / "probe")
        results = {
            build: race.run(entrants, flags, place / build, _WARM * repeats, max(repeats, FEWEST))
            for build, flags in builds.items()
        }

        def measured(name: str) -> tuple[float | None, int | None]:
            candidate, own = found[name], place / str(list(found).index(name))
            sizes = compiled.code_and_constants(candidate.header, len(ranges), own / "code", builds["portable"])
            off = None if candidate.kind == UNPACK else error(samples, candidate, own)
            return off, sizes[0] if sizes else None

        # Compilers are processes of their own.
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            told = dict(zip(found, pool.map(measured, found), strict=True))
    errors, code = {name: pair[0] for name, pair in told.items()}, {name: pair[1] for name, pair in told.items()}
    return Contest(found, errors, code, results)


def ranges_of(axes: list[tuple[float, float]], *, fixed_azimuth: bool) -> list[tuple[float, float]]:
    """Return the ranges of a header's inputs in order, the sun's azimuth after the first axis."""
    first, *rest = axes
    return [first, *([] if fixed_azimuth else [(-math.pi, math.pi)]), *rest]


def candidates(samples: Samples, tables: Mapping[str, Table]) -> dict[str, Candidate]:
    """Return the tables and their rivals by name."""
    found = {LITERAL: literal(samples), WELL_WRITTEN: well_written(samples)}
    for name, table in tables.items():
        kind = PACKED if isinstance(table.body, Packed) else TABLE
        header = compiled.header_of(table)
        found[name] = Candidate(header, bytes_of(table), table.bands, kind)
        if kind == PACKED:
            found |= unpacked(name, header, len(table.axes) + 1, table.bands)
    made = lookup.source(samples)
    for name, table in tables.items():
        if twin_of(name) in tables and twin_of(name) != name:
            continue
        wanted, first = headline(table, samples.reference), made.first_bands(table.bands)
        for kind in lookup.POINTS:
            grid = lookup.as_exact_as(first, samples.reference, wanted, kind)
            if grid:
                sizes = " x ".join(map(str, grid.sizes))
                found[f"{name}: lookup {sizes}, {kind}"] = lookup.candidate(grid, first, name)
        rival = direct(name, table)
        if rival:
            found[f"{name}: direct"] = rival
    projected = brute_force(samples)
    return found | ({BRUTE_FORCE: projected} if projected else {})


def twin_of(name: str) -> str:
    """Return the name of the fast table of the same budget.

    >>> twin_of("4-bands-1pct-packed"), twin_of("4-bands-1pct-packed: unpacked table"), twin_of("4-bands-1pct")
    ('4-bands-1pct', '4-bands-1pct', '4-bands-1pct')
    """
    return name.removesuffix(f": {UNPACKED}").removesuffix("-packed")


def literal(samples: Samples) -> Candidate:
    """Return the paper's scheme on these samples as printed: monomials in double precision, every order kept."""
    made = single_fit.fit(samples, samples.full, single_fit.paper_degrees(samples), "monomial", "svd", "raw")
    names = [axis.name for axis in samples.config.axes]
    text = paper_literal.write(made.dense, names, samples.spec.channels, compiled.PREFIX)
    return Candidate(text, made.dense.nbytes, samples.config.truth.bands, "paper")


def error(samples: Samples, candidate: Candidate, place: Path) -> float:
    """Return the largest E_mean over the samples' reference of what a candidate's header returns, compiled in ``place``."""
    inputs = np.insert(samples.reference.parameters, 1, 0.0, axis=1).astype(np.float32)
    got = compiled.weights(candidate.header, inputs, place, ["-O2"])
    held = sphere.Harmonics.even(candidate.bands)
    truth = held.unmirror(samples.reference.weights[..., : held.count])
    return e_mean(got - truth, samples.reference.headline)
