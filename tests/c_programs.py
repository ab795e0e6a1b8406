"""C programs around exported headers: compiled by gcc, run, and read."""

from __future__ import annotations

import subprocess
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from skylight_sh.export import c_header

FACTS = c_header.Facts("values", 0.0, 0.0, "per-set", [], luminance=(0.2, 0.7, 0.1))
GCC = ["gcc", "-std=c99"]
# At -O2 gcc sees what is read or written beyond the ends of arrays.
STRICT = ["-O2", "-Wall", "-Wextra", "-Werror", "-Wno-unused-function"]


def run(
    folder: Path, source: str, *arguments: str, check: bool = True, flags: Sequence[str] = ("-O1",)
) -> subprocess.CompletedProcess[str]:
    """Compile a C program in ``folder`` and run it there."""
    (folder / "program.c").write_text(source, encoding="utf-8")
    made = subprocess.run(
        [*GCC, *flags, "program.c", "-o", "program", "-lm"], cwd=folder, capture_output=True, text=True, check=False
    )
    assert made.returncode == 0, made.stderr
    return subprocess.run(["./program", *arguments], cwd=folder, capture_output=True, text=True, check=check)


def floats(values: NDArray[np.floating]) -> str:
    return ", ".join(f"{float(v):.9e}f" for v in np.asarray(values, dtype=np.float32).ravel())
