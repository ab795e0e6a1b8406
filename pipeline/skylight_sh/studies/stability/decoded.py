"""Packed tables decoded: the call that decodes, unpacked memory, batches, a fast table of the same numbers, and Python."""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh.runtime import Packed, Table, unpack
from skylight_sh.studies import compiled
from skylight_sh.studies.page import Row, Section
from skylight_sh.studies.stability import rounding, wide
from skylight_sh.table.powers import in_powers
from skylight_sh.table.table import whole

Array = NDArray[np.float64]
Single = NDArray[np.float32]

_SETS, _SEED = 203, 31
# Without contraction an operation is an operation; with it, and with wide vectors, some are fused.
_FLAGS = {
    "-O2, no contraction": ("-O2", "-ffp-contract=off"),
    "-O3, native": ("-O3", "-march=native", "-ffp-contract=fast"),
}
TEXT = (
    "Packed tables by every way there is to evaluate them, at random sets, edges and corners; of all packed tables the one "
    "where the error, relative to its largest weight, is largest. Bound 0: the same operations on the same numbers, so that "
    "every bit must be the same. Else, and where the compiler may fuse operations as it likes, it is what both results' "
    "roundings may do, each operation's followed to the result; against double precision those of one. The fast table has "
    "the same numbers, decoded; it sums them in another order."
)
_PROGRAM = """
#include <stdio.h>
#include <stdlib.h>
#include "table.h"
#define COUNT {count}
#define WEIGHTS (BENCH_SH_CHANNELS * BENCH_SH_WEIGHTS)
typedef float all[COUNT][BENCH_SH_CHANNELS][BENCH_SH_WEIGHTS];
static float in[{inputs}][COUNT], memory[BENCH_SH_UNPACKED], columns[WEIGHTS][COUNT];
static all out;
int main(void)
{{
    int s, i;
    if (fread(in, sizeof in, 1, stdin) != 1) return 1;
    bench_sh_unpack(memory);
    for (s = 0; s < COUNT; ++s) bench_sh_weights({each}, out[s]);
    fwrite(out, sizeof out, 1, stdout);
    for (s = 0; s < COUNT; ++s) bench_sh_weights_bands({each}, {fewer}, out[s]);
    fwrite(out, sizeof out, 1, stdout);
    for (s = 0; s < COUNT; ++s) bench_sh_unpacked_weights(memory, {each}, out[s]);
    fwrite(out, sizeof out, 1, stdout);
    for (s = 0; s < COUNT; ++s) bench_sh_unpacked_weights_bands(memory, {each}, {fewer}, out[s]);
    fwrite(out, sizeof out, 1, stdout);
    bench_sh_unpacked_weights_batch(memory, COUNT, {arrays}, out);
    fwrite(out, sizeof out, 1, stdout);
    bench_sh_weights_batch(COUNT, {arrays}, out);
    fwrite(out, sizeof out, 1, stdout);
    bench_sh_unpacked_weights_columns(memory, COUNT, {arrays}, &columns[0][0]);
    for (s = 0; s < COUNT; ++s)
        for (i = 0; i < WEIGHTS; ++i) (&out[s][0][0])[i] = columns[i][s];
    fwrite(out, sizeof out, 1, stdout);
    return 0;
}}
"""
_WAYS = ("call", "first bands", "unpacked", "unpacked, first bands", "unpacked batch", "batch", "unpacked columns")


@dataclass(frozen=True)
class Compared:
    """Two ways, one as ``built``: how far apart they are at most, how far they may be, and whether they hold everywhere."""

    built: str
    what: str
    against: str
    error: float
    bound: float
    holds: bool


def section(tables: Mapping[str, Table]) -> Section:
    """Measure every packed table; no rows where there is none."""
    found: dict[tuple[str, str, str], list[tuple[str, Compared]]] = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, table in tables.items():
            if isinstance(table.body, Packed) and table.spec.azimuth is None:
                for one in compared(table, Path(folder)):
                    found.setdefault((one.built, one.what, one.against), []).append((name, one))
    rows: list[Row] = []
    for (built, what, against), each in found.items():
        name, worst = max(each, key=lambda pair: pair[1].error)
        row = {
            "built": built,
            "what": what,
            "against": against,
            "error": worst.error,
            "bound": worst.bound,
            "of table": name,
        }
        rows.append(row | {"holds": "yes" if all(one.holds for _, one in each) else "no"})
    return Section("decoded", "Packed tables decoded", TEXT, rows)


def compared(table: Table, place: Path) -> Iterator[Compared]:
    """Evaluate a packed table every way; C is compiled in ``place``. Raises TypeError where it is not packed."""
    sets, flat = _sets(table), as_rows(table)
    exact = _whole(table, wide.parts(table, sets).weights)
    size, fewer = float(np.abs(exact).max()), max(1, table.bands // 2)
    sine = float(rounding.sine_of_header(table, sets[:, _peak(table)]).max()) if table.spec.parity else 1.0
    of_python, of_flat = (_whole(table, rounding.bound(one, sets)) for one in (table, flat))
    of_c, of_fast = (_whole(table, rounding.bound(one, sets, sine=sine, horner=True)) for one in (table, in_powers(flat)))

    def apart(built: str, what: str, against: str, error: Array, bound: Array) -> Compared:
        holds = bool((np.abs(error) <= bound).all())
        return Compared(built, what, against, float(np.abs(error).max() / size), float(bound.max() / size), holds)

    none = np.zeros(1)
    got = _whole(table, table.evaluate(sets))
    one_by_one = np.concatenate([_whole(table, table.evaluate(one[np.newaxis])) for one in sets])
    yield apart("Python", "call", "float64", got - exact, of_python)
    yield apart("Python", "one by one", "all at once", one_by_one - got, none)
    yield apart("Python", "fast table", "call", _whole(table, flat.evaluate(sets)) - got, of_python + of_flat)
    inputs = np.insert(sets, 1, 0.0, axis=1).astype(np.float32)
    first = slice(fewer * fewer)
    for built, flags in _FLAGS.items():
        found = _in_c(table, inputs, fewer, place, flags)
        fast = compiled.weights(compiled.header_of(flat), inputs, place, flags)
        both = of_c + of_c
        same = none if "-ffp-contract=off" in flags else both
        call, unpacked = found["call"], found["unpacked"]
        yield apart(built, "call", "float64", call - exact, of_c)
        yield apart(built, "call", "Python", call - got, of_c + of_python)
        yield apart(built, "unpacked", "call", unpacked - call, both)
        yield apart(built, "fast table", "float64", fast - exact, of_fast)
        yield apart(built, "fast table", "unpacked", fast - unpacked, of_fast + of_c)
        yield apart(built, "unpacked batch", "unpacked", found["unpacked batch"] - unpacked, same)
        yield apart(built, "batch", "unpacked batch", found["batch"] - found["unpacked batch"], same)
        yield apart(built, "unpacked columns", "unpacked", found["unpacked columns"] - unpacked, both)
        yield apart(built, "first bands", "call", (found["first bands"] - call)[..., first], same[..., first])
        yield apart(
            built,
            "unpacked, first bands",
            "unpacked",
            (found["unpacked, first bands"] - unpacked)[..., first],
            both[..., first],
        )


def as_rows(table: Table, dtype: str = "float32") -> Table:
    """Return a packed table's numbers, decoded, as a table laid out for speed, each rounded to ``dtype``.

    Raises TypeError where the table is not packed.
    """
    body = table.body
    if not isinstance(body, Packed):
        raise TypeError(f"A table laid out as {body.kind!r} has nothing to decode.")
    numbers = unpack(body, table.places).swapaxes(0, 1)
    first, rest = table.degrees[0] + 1, int(np.prod([degree + 1 for degree in table.degrees[1:]], dtype=int))
    numbers = np.pad(numbers, ((0, 0), (0, 0), (0, first - numbers.shape[2]), (0, rest - numbers.shape[3])))
    # In double precision the product of a whole number and the step, which single precision holds, is exact.
    dense = numbers.astype(np.float64) * float(np.float32(body.step))
    return whole(table.spec, dense.reshape(*dense.shape[:2], *(d + 1 for d in table.degrees)), table.bands, dtype)


def _whole(table: Table, stored: NDArray[np.floating]) -> Array:
    return np.asarray(table.whole(stored), dtype=np.float64)


def _sets(table: Table) -> Array:
    """Return random sets of single precision within the ranges, a third of them moved to an end of each axis."""
    rng = np.random.default_rng(_SEED)
    low, high = np.transpose([(axis.low, axis.high) for axis in table.axes])
    share = rng.random((_SETS, low.size))
    ends = rng.integers(0, 6, size=share.shape)
    share = np.where(ends == 0, 0.0, np.where(ends == 1, 1.0, share))
    return wide.in_single(table, low + (high - low) * share)


def _peak(table: Table) -> int:
    return [axis.name for axis in table.axes].index(str(table.spec.peak_axis))


def _in_c(table: Table, inputs: Single, fewer: int, place: Path, flags: tuple[str, ...]) -> dict[str, Array]:
    columns = range(inputs.shape[1])
    source = _PROGRAM.format(
        count=len(inputs),
        inputs=len(columns),
        fewer=fewer,
        each=", ".join(f"in[{i}][s]" for i in columns),
        arrays=", ".join(f"in[{i}]" for i in columns),
    )
    made = compiled.program(compiled.header_of(table), source, place, flags)
    out = subprocess.run([str(made)], input=inputs.T.tobytes(), capture_output=True, check=True).stdout
    shape = (len(_WAYS), len(inputs), len(table.channels), table.bands**2)
    found = np.frombuffer(out, dtype=np.float32).reshape(shape).astype(np.float64)
    return dict(zip(_WAYS, found, strict=True))
