"""Exported headers compiled and run: what the C compiler makes of a table."""

from __future__ import annotations

import platform
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh.export import c_header
from skylight_sh.runtime import Table

PREFIX = "bench_sh"
FACTS = c_header.Facts("benchmark", 0.0, 0.0, "per-set", [])
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
_HAS_AVX2 = 'int main(void) { return !(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")); }'
_ONE_CALL = """
#include "table.h"
int one_call({parameters}, float w[BENCH_SH_CHANNELS][BENCH_SH_WEIGHTS]);
int one_call({parameters}, float w[BENCH_SH_CHANNELS][BENCH_SH_WEIGHTS])
{{
    return bench_sh_weights({arguments}, w);
}}
"""


def compile_c(arguments: Sequence[str], place: Path) -> None:
    """Run ``cc -std=c11`` with ``arguments`` in ``place``.

    Raises OSError where there is no compiler or it refuses the source, with its message.
    """
    if shutil.which("cc") is None:
        raise OSError("No C compiler `cc` was found. Install one, such as gcc or clang.")
    made = subprocess.run(["cc", "-std=c11", *arguments], cwd=place, capture_output=True, text=True, check=False)
    if made.returncode:
        raise OSError(f"cc {' '.join(arguments)} failed: {made.stderr[:2000]}")


def write(header: str, source: str, place: Path) -> None:
    """Write ``header`` as table.h and ``source`` as main.c into ``place``, which is made."""
    place.mkdir(parents=True, exist_ok=True)
    (place / "table.h").write_text(header, encoding="utf-8")
    (place / "main.c").write_text(source, encoding="utf-8")


def program(header: str, source: str, place: Path, flags: Sequence[str]) -> Path:
    """Compile ``source``, which includes ``header`` as table.h, in ``place`` with ``cc`` and ``flags``; return the program.

    Raises what ``compile_c`` raises.
    """
    write(header, source, place)
    compile_c([*flags, "main.c", "-o", "main", "-lm"], place)
    return place / "main"


def builds(place: Path) -> Mapping[str, Sequence[str]]:
    """Return the flags of the builds that this processor runs: ``portable``, ``AVX2`` where it has that, and ``native``."""
    found = {"portable": ["-O3"], "native": ["-O3", "-march=native"]}
    if platform.machine().lower() in ("x86_64", "amd64"):
        probe = program("", _HAS_AVX2, place, [])
        if subprocess.run([str(probe)], check=False).returncode == 0:
            return {"portable": found["portable"], "AVX2": ["-O3", "-mavx2", "-mfma"], "native": found["native"]}
    return found


def code_and_constants(header: str, inputs: int, place: Path, flags: Sequence[str]) -> tuple[int, int] | None:
    """Return the bytes of machine code and of constants of one call, all that is compiled for it.

    The C library's functions that it calls are not in them. None where no ``size`` tells an object's sections.
    """
    names = [f"v{i}" for i in range(inputs)]
    parameters = ", ".join(f"float {name}" for name in names)
    write(header, _ONE_CALL.format(parameters=parameters, arguments=", ".join(names)), place)
    compile_c([*flags, "-c", "main.c", "-o", "main.o"], place)
    if shutil.which("size") is None:
        return None
    told = subprocess.run(["size", "-A", "main.o"], cwd=place, capture_output=True, text=True, check=False).stdout
    rows = [line.split() for line in told.splitlines()]
    code, constants = (
        [int(row[1]) for row in rows if len(row) > 2 and row[0].startswith(section)] for section in (".text", ".rodata")
    )
    return (sum(code), sum(constants)) if code else None


def header_of(table: Table) -> str:
    """Return a table's header under the benchmarks' own prefix."""
    return c_header.write(table, FACTS, PREFIX)


def weights(header: str, inputs: NDArray[np.float32], place: Path, flags: Sequence[str]) -> NDArray[np.float64]:
    """Return what a header gives for ``inputs`` ``(n, axes + 1)`` in the runtime's order: ``(n, channels, N*N)``."""
    columns = inputs.shape[1]
    source = _EVALUATOR.format(inputs=columns, arguments=", ".join(f"in[{i}]" for i in range(columns)))
    made = program(header, source, place, flags)
    out = subprocess.run([str(made)], input=inputs.tobytes(), capture_output=True, check=True).stdout
    sizes, data = np.frombuffer(out, dtype=np.int32, count=2), np.frombuffer(out, dtype=np.float32, offset=8)
    return data.reshape(len(inputs), *sizes).astype(np.float64)
