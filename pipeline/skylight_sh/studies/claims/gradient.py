"""How right a header's gradient is: inside the ranges, on their edges and in their corners."""

from __future__ import annotations

import itertools
import subprocess
import tempfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh.export import c_data
from skylight_sh.formula.bases import BASES
from skylight_sh.runtime import ClassRows, Packed, Table, unpack
from skylight_sh.studies import compiled
from skylight_sh.table.powers import in_powers
from skylight_sh.table.table import whole

Array = NDArray[np.float64]

_SETS = 300
_STEP = 2e-3
_FLAGS = ["-O2", "-ffp-contract=off"]
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


def measure(table: Table) -> dict[str, float]:
    """Return the largest error of a table's ``_weights_gradient`` in C ``inside``, on ``edges`` and in ``corners``.

    Each is a share of the largest derivative after the same axis at the same set, any weight and channel, the largest over
    axes and sets. Held against central differences (Richardson, twice) of the same polynomials in double precision, which
    do not end at the ranges; where a change of variable has no slope at its range's end, at the last float32 inside. The
    azimuth, an input, is 0 here. Raises OSError where the header does not compile.
    """
    low, high = np.transpose(table.ranges)
    rng = np.random.default_rng(8)
    inside = rng.uniform(low, high, size=(_SETS, low.size))
    edges = np.concatenate([_pinned(inside, axis, value) for axis in range(low.size) for value in (low[axis], high[axis])])
    corners = np.array(list(itertools.product(*zip(low, high, strict=True))))
    places = {"inside": inside, "edges": edges, "corners": corners}
    with tempfile.TemporaryDirectory() as folder:
        header = compiled.header_of(table)
        arguments = ", ".join(f"in[{i}]" for i in range(low.size + 1))
        source = _PROGRAM.format(inputs=low.size + 1, arguments=arguments)
        program = compiled.program(header, source, Path(folder), _FLAGS)
        return {name: _worst(table, program, sets) for name, sets in places.items()}


def _pinned(sets: Array, axis: int, value: float) -> Array:
    out = sets.copy()
    out[:, axis] = value
    return out


def _worst(table: Table, program: Path, sets: Array) -> float:
    # Float32 pi / 2 lies beyond pi / 2, and is clamped to it.
    inputs = np.insert(sets, 1, 0.0, axis=1).astype(np.float32)
    out = subprocess.run([str(program)], input=inputs.tobytes(), capture_output=True, check=True).stdout
    got = np.frombuffer(out, dtype=np.float32).reshape(len(sets), len(table.axes), len(table.channels), -1)
    given = np.clip(np.delete(inputs, 1, axis=1).astype(np.float64), *np.transpose(table.ranges))
    worst = 0.0
    for axis in range(len(table.axes)):
        expected = exact(table, given, axis)
        off = np.abs(got[:, axis] - expected).max(axis=(1, 2))
        # Nothing is left of the derivatives at the end of twilight.
        largest = np.abs(expected).max(axis=(1, 2))
        worst = max(worst, float((off / np.where(largest > 0, largest, 1.0)).max()))
    return worst


def exact(table: Table, sets: Array, axis: int) -> Array:
    """Return the derivative of all weights after ``axis`` at sets ``(n, axes)`` and azimuth 0: ``(n, channels, N*N)``."""
    wide, given = _in_double(table), table.axes[axis]
    within = np.clip(sets, *np.transpose([(a.low, a.high) for a in table.axes]))
    low, high = _sloped(table, axis)
    place = np.clip(within[:, axis], low, high)
    # Near an end without a slope differences must not reach it.
    near = [np.abs(place - end) for end, known in ((given.low, low), (given.high, high)) if end != known]
    step = np.min([np.full(len(sets), _STEP * (given.high - given.low)), *(0.1 * distance for distance in near)], axis=0)

    def weights(v: Array) -> Array:
        moved = within.copy()
        moved[:, axis] = v
        return np.asarray(table.whole(wide.evaluate(moved)), dtype=np.float64)

    found = _slope(weights, place, step) * table.fade(sets)[:, np.newaxis, np.newaxis]
    twilight = table.spec.twilight
    if twilight and given.name == table.spec.peak_axis:
        # Below the horizon the fade's own slope is all there is.
        depth = np.clip((sets[:, axis] - given.high) / twilight.depth, 0.0, 1.0)
        fade = _slope(lambda x: twilight.program.run([x])[0], depth, 0.05 * np.minimum(depth, 1.0 - depth)) / twilight.depth
        sunk = sets[:, axis] > np.float32(given.high)
        found[sunk] = (fade[:, np.newaxis, np.newaxis] * weights(within[:, axis]))[sunk]
    around = table.surroundings
    if around is None:
        return found
    linear = around.apply(found, table.bands) - around.apply(np.zeros_like(found), table.bands)
    return np.asarray(linear, dtype=np.float64)


def _sloped(table: Table, axis: int) -> tuple[float, float]:
    basis = BASES[table.spec.basis].program(table.degrees[axis])
    return c_data.slope_range(table, axis, basis)


def _in_double(table: Table) -> Table:
    """Return the same polynomials as a table of double precision."""
    # As the header has them.
    held = in_powers(table)
    if isinstance(held.body, ClassRows):
        return replace(held, body=replace(held.body, rows=held.body.rows.astype(np.float64)))
    if not isinstance(table.body, Packed):
        raise TypeError(f"An earlier version wrote a table of layout {table.body.kind!r}.")
    numbers = _spread(table, table.body).transpose(1, 0, 2, 3) * np.float64(np.float32(table.body.step))
    sizes = [degree + 1 for degree in table.degrees]
    return whole(table.spec, numbers.reshape(*numbers.shape[:2], *sizes), table.bands, "float64")


def _spread(table: Table, body: Packed) -> NDArray[np.int64]:
    """Return the whole numbers ``(count, channels, first, rest)`` with zeros where the stream ends early."""
    found = unpack(body, table.places)
    first, rest = table.degrees[0] + 1, int(np.prod([degree + 1 for degree in table.degrees[1:]], dtype=int))
    return np.pad(found, ((0, 0), (0, 0), (0, first - found.shape[2]), (0, rest - found.shape[3])))


def _slope(function: Callable[[Array], NDArray[np.floating]], at: Array, step: Array) -> Array:
    """Return the slopes ``(n, ...)`` of a function of each of ``at`` ``(n,)`` by three steps, 0 for none."""
    found = []
    for share in (1.0, 0.5, 0.25):
        change = np.asarray(function(at + share * step) - function(at - share * step))
        width = (2 * share * step).reshape(-1, *(1 for _ in change.shape[1:]))
        found.append(np.divide(change, width, out=np.zeros_like(change), where=width > 0))
    once = [(4 * fine - rough) / 3 for rough, fine in itertools.pairwise(found)]
    return np.asarray((16 * once[1] - once[0]) / 15, dtype=np.float64)
