"""The light's own quadrature in C, where the export has a target of that name: no table at all."""

from __future__ import annotations

import re
import tempfile
from pathlib import Path

from skylight_sh.export.targets import TARGETS
from skylight_sh.runtime import Table
from skylight_sh.studies import compiled
from skylight_sh.studies.speed.candidate import Candidate

TARGET = "direct"


def direct(name: str, table: Table) -> Candidate | None:
    """Return the target's header for ``table`` as its rival, or None where there is no such target or it has an obstacle.

    Its bytes are the constants that a compiler keeps of it.
    """
    if TARGET not in TARGETS or TARGETS[TARGET].obstacle(table) is not None:
        return None
    files = TARGETS[TARGET].write(table, compiled.FACTS, compiled.PREFIX)
    header = _renamed(next(data.decode() for file, data in sorted(files.items()) if file.endswith(".h")))
    with tempfile.TemporaryDirectory() as folder:
        sizes = compiled.code_and_constants(header, len(table.axes) + 1, Path(folder), ["-O3"])
    return Candidate(header, sizes[1] if sizes else 0, table.bands, TARGET, name)


def _renamed(header: str) -> str:
    """Return the header with its names under the benchmarks' own prefix too, where it has a longer one."""
    found = re.search(rf"\b({compiled.PREFIX}\w*)_weights\(", header)
    own, prefix = found[1] if found else compiled.PREFIX, compiled.PREFIX
    if own == prefix:
        return header
    macros = [f"#define {prefix.upper()}_{part} {own.upper()}_{part}" for part in ("BANDS", "WEIGHTS", "CHANNELS")]
    return "\n".join([header, *macros, f"#define {prefix}_weights {own}_weights", ""])
