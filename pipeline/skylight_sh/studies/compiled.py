"""Exported headers compiled and run: what the C compiler makes of a table."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh.export import c_header
from skylight_sh.runtime import Table

PREFIX = "bench_sh"
_FACTS = c_header.Facts("benchmark", 0.0, 0.0, "per-set", [])
_EVALUATOR = """
#include <stdio.h>
#include "table.h"
int main(void)
{{
    float in[{inputs}], w[BENCH_SH_CHANNELS][BENCH_SH_WEIGHTS];
    const int sizes[2] = {{ BENCH_SH_CHANNELS, BENCH_SH_WEIGHTS }};
    fwrite(sizes, sizeof sizes, 1, stdout);
    while (fread(in, sizeof in, 1, stdin) == 1) {{
        bench_sh_weights({arguments}, w);
        fwrite(w, sizeof w, 1, stdout);
    }}
    return 0;
}}
"""


def program(header: str, source: str, place: Path, flags: Sequence[str]) -> Path:
    """Compile ``source``, which includes ``header`` as table.h, in ``place`` with ``cc`` and ``flags``; return the program.

    Raises OSError where there is no compiler or it refuses the source, with its message.
    """
    if shutil.which("cc") is None:
        raise OSError("No C compiler `cc` was found. Install one, such as gcc or clang.")
    place.mkdir(parents=True, exist_ok=True)
    (place / "table.h").write_text(header, encoding="utf-8")
    (place / "main.c").write_text(source, encoding="utf-8")
    made = subprocess.run(
        ["cc", "-std=c11", *flags, "main.c", "-o", "main", "-lm"], cwd=place, capture_output=True, text=True, check=False
    )
    if made.returncode:
        raise OSError(f"cc {' '.join(flags)} failed: {made.stderr[:2000]}")
    return place / "main"


def header_of(table: Table) -> str:
    """Return a table's header under the benchmarks' own prefix."""
    return c_header.write(table, _FACTS, PREFIX)


def weights(header: str, inputs: NDArray[np.float32], place: Path, flags: Sequence[str]) -> NDArray[np.float64]:
    """Return what a header gives for ``inputs`` ``(n, axes + 1)`` in the runtime's order: ``(n, channels, N*N)``."""
    columns = inputs.shape[1]
    source = _EVALUATOR.format(inputs=columns, arguments=", ".join(f"in[{i}]" for i in range(columns)))
    made = program(header, source, place, flags)
    out = subprocess.run([str(made)], input=inputs.tobytes(), capture_output=True, check=True).stdout
    sizes, data = np.frombuffer(out, dtype=np.int32, count=2), np.frombuffer(out, dtype=np.float32, offset=8)
    return data.reshape(len(inputs), *sizes).astype(np.float64)
