"""The C header's derivatives against complex steps, over the ranges, at their edges, and with the sun at the zenith."""

from __future__ import annotations

import itertools
import subprocess
import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh.runtime import Packed, Table
from skylight_sh.studies import compiled
from skylight_sh.studies.page import Row, Section
from skylight_sh.studies.stability import rounding, wide
from skylight_sh.studies.stability.decoded import as_rows
from skylight_sh.table.powers import in_powers

Array = NDArray[np.float64]

_SETS, _SEED = 200, 47
# So small that its square vanishes beside 1: a complex step has no other error than rounding.
_STEP = 1e-30
_DOUBLE = 2.0**-53
_FLAGS = ("-O2", "-ffp-contract=off")
TEXT = (
    "`_weights_gradient` of every header with powers of the sine, against complex steps of the same polynomials in double "
    "precision (Squire and Trapp 1998), which know nothing of the header's own derivatives; of all tables the one where the "
    "error is largest. Errors and bounds are relative to the table's largest derivative after the same axis. The bound is "
    "one rounding to single precision of each derivative, and a rounding in double precision of each term and operation. "
    "`runtime` is the distance to complex steps of the Python runtime's coefficients: the header has fast tables in powers "
    "of the variables, each rounded anew, and does not round a packed table's; that bound adds a rounding of each "
    "coefficient. Beyond the ranges the header has the edge's derivatives, to the bit."
)
_PROGRAM = """
#include <stdio.h>
#include "table.h"
int main(void)
{{
    static float in[{inputs}], w[BENCH_SH_CHANNELS][BENCH_SH_WEIGHTS];
    static float g[BENCH_SH_AXES][BENCH_SH_CHANNELS][BENCH_SH_WEIGHTS];
    while (fread(in, sizeof in, 1, stdin) == 1) {{
        bench_sh_weights_gradient({arguments}, w, g);
        fwrite(g, sizeof g, 1, stdout);
    }}
    return 0;
}}
"""


@dataclass(frozen=True)
class Compared:
    """One table's derivatives after an axis, somewhere: largest errors, their bounds, and whether they hold everywhere."""

    after: str
    where: str
    error: float
    bound: float
    runtime: float
    runtime_bound: float
    holds: bool


def section(tables: Mapping[str, Table]) -> Section:
    """Measure every table with parity, without its twilight; no rows where there is none."""
    found: dict[tuple[str, str], list[tuple[str, Compared]]] = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, table in tables.items():
            if table.spec.parity and table.spec.azimuth is None:
                by_day = replace(table, spec=replace(table.spec, twilight=None))
                for one in compared(by_day, Path(folder)):
                    found.setdefault((one.after, one.where), []).append((name, one))
    rows: list[Row] = []
    for (after, where), each in found.items():
        name, worst = max(each, key=lambda pair: pair[1].error)
        far = max((one for _, one in each), key=lambda one: one.runtime)
        row = {"after": after, "where": where, "error": worst.error, "bound": worst.bound, "of table": name}
        row |= {"runtime": far.runtime, "runtime bound": far.runtime_bound}
        rows.append(row | {"holds": "yes" if all(one.holds for _, one in each) else "no"})
    return Section("gradients", "Exact derivatives", TEXT, rows)


def compared(table: Table, place: Path) -> Iterator[Compared]:
    """Hold the derivatives in C, compiled in ``place``, of a table without twilight against complex steps: axis by axis."""
    held = _held(table)
    program = _program(table, place)
    groups = {name: wide.in_single(table, sets) for name, sets in _places(table).items()}
    for axis, given in enumerate(table.axes):
        largest = float(np.abs(slopes(held, np.concatenate(list(groups.values())), axis)).max())
        for name, sets in groups.items():
            got = _in_c(table, program, sets)[:, axis]
            bound = limit(held, sets, axis)
            # Coefficients once rounded to single precision, whichever of both are.
            wider = bound + (rounding.UNIT + 16.0 * _DOUBLE) * magnitudes(held, sets, axis)
            error, apart = (np.abs(got - slopes(one, sets, axis)) for one in (held, table))
            holds = bool((error <= bound).all() and (apart <= wider).all())
            own, limited, far, allowed = (float(values.max() / largest) for values in (error, bound, apart, wider))
            yield Compared(given.name, name, own, limited, far, allowed, holds)
        beyond = _beyond(table, program, axis) / largest
        yield Compared(given.name, "beyond the ends", beyond, 0.0, beyond, 0.0, beyond == 0.0)


def _held(table: Table) -> Table:
    """Return the polynomials that the header differentiates: a packed table's in double precision, others in powers."""
    return as_rows(table, "float64") if isinstance(table.body, Packed) else in_powers(table)


def slopes(table: Table, sets: Array, axis: int) -> Array:
    """Return the stored weights' derivatives after ``axis`` at sets ``(n, axes)``, ``(n, channels, count)``."""
    moved = sets.astype(np.complex128)
    moved[:, axis] += 1j * _STEP
    return np.asarray(wide.parts(table, moved).weights.imag / _STEP)


def magnitudes(table: Table, sets: Array, axis: int) -> Array:
    """Return the sum of the magnitudes of all that a derivative is the sum of, ``(n, channels, count)``."""
    moved = sets.astype(np.complex128)
    moved[:, axis] += 1j * _STEP
    parts = wide.parts(table, moved)
    value = np.stack([np.abs(parts.terms.real[:, p]) @ np.abs(m.astype(np.float64)) for p, m in table.matrices], axis=1)
    slope = np.stack([np.abs(parts.terms.imag[:, p]) @ np.abs(m.astype(np.float64)) for p, m in table.matrices], axis=1)
    factors, powers = parts.factors, parts.powers
    found = np.einsum("nck,nkw,nw->ncw", np.abs(factors.real), slope, np.abs(powers.real))
    found += np.einsum("nck,nkw,nw->ncw", np.abs(factors.imag), value, np.abs(powers.real))
    found += np.einsum("nck,nkw,nw->ncw", np.abs(factors.real), value, np.abs(powers.imag))
    return np.asarray(found / _STEP)


def limit(table: Table, sets: Array, axis: int) -> Array:
    """Return how far the header's derivatives may be off, ``(n, channels, count)``: see the section's text."""
    steps = sum(len(axis.variable.steps) for axis in table.axes) + sum(len(program.steps) for program in table.terms)
    terms = max(len(places) for places, _ in table.matrices)
    scale = len(table.spec.scale.program.steps) if table.spec.scale else 0
    operations = steps + terms + scale + 2 * table.bands
    exact = np.abs(slopes(table, sets, axis))
    # Single precision's least numbers are the last term's, which complex steps are below where a derivative is 0.
    return np.asarray(rounding.UNIT * exact + operations * _DOUBLE * magnitudes(table, sets, axis) + rounding.SMALLEST)


def _places(table: Table) -> dict[str, Array]:
    """Return sets inside the ranges, on each edge, in the corners, and with the peak at the zenith and close to it."""
    low, high = np.transpose([(axis.low, axis.high) for axis in table.axes])
    inside = np.random.default_rng(_SEED).uniform(low, high, size=(_SETS, low.size))
    edges = [_pinned(inside, axis, end) for axis in range(low.size) for end in (low[axis], high[axis])]
    found = {
        "inside": inside,
        "edges": np.concatenate(edges),
        "corners": np.array(list(itertools.product(*zip(low, high, strict=True)))),
    }
    peak = [axis.name for axis in table.axes].index(str(table.spec.peak_axis))
    if low[peak] == 0.0:
        found["zenith"] = _pinned(inside, peak, 0.0)
        near = inside.copy()
        near[:, peak] = 10.0 ** np.linspace(-7.0, -1.0, _SETS)
        found["near the zenith"] = near
    return found


def _pinned(sets: Array, axis: int, value: float) -> Array:
    out = sets.copy()
    out[:, axis] = value
    return out


def _program(table: Table, place: Path) -> Path:
    count = len(table.axes) + 1
    source = _PROGRAM.format(inputs=count, arguments=", ".join(f"in[{i}]" for i in range(count)))
    return compiled.program(compiled.header_of(table), source, place, _FLAGS)


def _in_c(table: Table, program: Path, sets: Array) -> Array:
    """Return the header's derivatives of the stored weights, ``(n, axes, channels, count)``."""
    inputs = np.insert(sets, 1, 0.0, axis=1).astype(np.float32)
    out = subprocess.run([str(program)], input=inputs.tobytes(), capture_output=True, check=True).stdout
    found = np.frombuffer(out, dtype=np.float32).reshape(len(sets), len(table.axes), len(table.channels), -1)
    return np.asarray(found[..., table.places], dtype=np.float64)


def _beyond(table: Table, program: Path, axis: int) -> float:
    """Return the largest difference of derivatives far beyond an axis's ends from those just beyond."""
    given = table.axes[axis]
    inside = _places(table)["inside"]
    worst = 0.0
    for end, sign in ((given.low, -1.0), (given.high, 1.0)):
        # The first number of single precision that is clamped to the end, which may lie between two of them.
        just = np.nextafter(np.float32(end), np.float32(sign * np.inf))
        at, far = (_in_c(table, program, _pinned(inside, axis, value)) for value in (float(just), end + sign))
        worst = max(worst, float(np.abs(at - far).max()))
    return worst
