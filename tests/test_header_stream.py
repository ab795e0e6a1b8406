"""The C header's reader of packed streams at its edges: long runs of ones, wide low bits, the stream's last bytes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from c_programs import FACTS, STRICT, run
from skylight_sh.export import c_header
from skylight_sh.fit.axis import Axis
from skylight_sh.runtime import Packed, Table
from skylight_sh.table.bits import Writer
from skylight_sh.table.table import small, specification

PRINTED = """
#include <stdio.h>
#include "{header}"
static void {prefix}_print(void)
{{
    float memory[{upper}_UNPACKED];
    int i;
    {prefix}_unpack(memory);
    for (i = 0; i < {count}; ++i) printf("%.0f ", (double)memory[i]);
    printf("\\n");
}}
"""
# Each of the stream's bytes is read where it stands alone, and none behind it: it lies in a global with a redzone.
SANITIZED = ["-O1", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]


def table_of(numbers: list[int], low_bits: list[int]) -> Table:
    """A table of one weight whose numbers, along one axis, are written with the given low bits."""
    writer = Writer()
    writer.fixed(len(numbers), 5)
    for low in low_bits:
        writer.fixed(2 * low, 5)
    writer.rice(len(numbers), 0)
    for number, low in zip(numbers, low_bits, strict=True):
        writer.rice(number, low)
    spec = specification((Axis("haze", 0.0, 1.0),), ("one",), True, "monomial", None)
    table = small(spec, np.array(numbers).reshape(1, 1, -1, 1), 1.0, (len(numbers) - 1,), 1)
    zero = np.zeros(1, dtype=np.int64)
    return replace(table, body=Packed(writer.bytes(), len(numbers), zero, zero, 1.0))


def cases() -> list[tuple[list[int], list[int]]]:
    """Runs of 0 to 300 ones at any place of a byte, next to low bits of any width; streams from 3 bytes on."""
    rng = np.random.default_rng(5)
    found: list[tuple[list[int], list[int]]] = [([1], [0]), ([-1], [15]), ([28], [0]), ([-32, 1], [0, 0])]
    for ones in (54, 55, 56, 57, 62, 63, 64, 65, 126, 127, 128, 300):
        for before in range(3):
            # Where a run of ones begins hangs on the numbers before it.
            low = [*rng.integers(0, 16, before).tolist(), int(rng.integers(0, 10)), int(rng.integers(0, 16))]
            folded = [(int(rng.integers(0, 9)) << k) + int(rng.integers(0, 1 << k)) for k in low]
            folded[before] = (ones << low[before]) + int(rng.integers(0, 1 << low[before]))
            folded[-1] = max(folded[-1], 1)
            found.append(([u >> 1 if u % 2 == 0 else -(u >> 1) - 1 for u in folded], low))
    return found


@pytest.mark.parametrize("flags", [[*STRICT, "-O3"], SANITIZED], ids=["strict", "sanitizers"])
def test_long_runs_and_last_bytes_are_read(tmp_path: Path, flags: list[str]) -> None:
    """One program of many small tables, each read to its stream's last bit."""
    parts, calls = [], []
    for k, (numbers, low) in enumerate(cases()):
        prefix = "stream_" + "".join("abcdefghij"[int(digit)] for digit in str(k))
        (tmp_path / f"{prefix}.h").write_text(c_header.write(table_of(numbers, low), FACTS, prefix), encoding="utf-8")
        parts.append(PRINTED.format(header=f"{prefix}.h", prefix=prefix, upper=prefix.upper(), count=len(numbers)))
        calls.append(f"    {prefix}_print();")
    source = "\n".join([*parts, "int main(void)", "{", *calls, "    return 0;", "}"])
    got = [[int(v) for v in line.split()] for line in run(tmp_path, source, flags=flags).stdout.splitlines()]
    assert got == [numbers for numbers, _ in cases()]
