"""How right a header's gradient is: inside the ranges, on their edges and in their corners."""

from __future__ import annotations

import itertools
import subprocess
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh.runtime import Rows, Table
from skylight_sh.studies import compiled

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
    do not end at the ranges. ``table`` is a fast one, with an azimuth among its inputs, which is 0 here. Raises OSError
    where the header does not compile.
    """
    if not isinstance(table.body, Rows):
        raise TypeError("Only a fast table's rows can be kept in double precision. Give a table of layout rows.")
    wide = replace(table, body=replace(table.body, rows=table.body.rows.astype(np.float64)))
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
        return {name: _worst(table, wide, program, sets) for name, sets in places.items()}


def _pinned(sets: Array, axis: int, value: float) -> Array:
    out = sets.copy()
    out[:, axis] = value
    return out


def _worst(table: Table, wide: Table, program: Path, sets: Array) -> float:
    # Float32 pi / 2 lies beyond pi / 2, and is clamped to it.
    inputs = np.insert(sets, 1, 0.0, axis=1).astype(np.float32)
    out = subprocess.run([str(program)], input=inputs.tobytes(), capture_output=True, check=True).stdout
    got = np.frombuffer(out, dtype=np.float32).reshape(len(sets), len(table.axes), len(table.channels), -1)
    clamped = np.clip(np.delete(inputs, 1, axis=1).astype(np.float64), *np.transpose(table.ranges))
    worst = 0.0
    for axis, (low, high) in enumerate(table.ranges):
        exact = table.whole(_derivative(wide, clamped, axis, _STEP * (high - low)))
        off = np.abs(got[:, axis] - exact).max(axis=(1, 2)) / np.abs(exact).max(axis=(1, 2))
        worst = max(worst, float(off.max()))
    return worst


def _derivative(table: Table, sets: Array, axis: int, step: float) -> Array:
    """Return the derivative of stored weights after an axis, ``(n, channels, count)``, by three steps, errors of h**6."""
    found = []
    for share in (1.0, 0.5, 0.25):
        move = np.zeros(sets.shape[1])
        move[axis] = share * step
        found.append((table.evaluate(sets + move) - table.evaluate(sets - move)) / (2 * share * step))
    once = [(4 * fine - rough) / 3 for rough, fine in itertools.pairwise(found)]
    return np.asarray((16 * once[1] - once[0]) / 15, dtype=np.float64)
