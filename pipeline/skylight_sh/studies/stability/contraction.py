"""Compilers: contraction to fused multiply-adds, optimisation levels and -ffast-math, on the exported headers."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from skylight_sh.fit.errors import e_mean
from skylight_sh.runtime import Table
from skylight_sh.studies import compiled, outcomes
from skylight_sh.studies.grid_samples import Samples
from skylight_sh.studies.page import Row, Section

_FLAGS = {
    "-O0": ["-O0", "-ffp-contract=off"],
    "-O2, no contraction": ["-O2", "-ffp-contract=off"],
    "-O3, native, contraction": ["-O3", "-march=native", "-ffp-contract=fast"],
    "-O3, native, fast-math": ["-O3", "-march=native", "-ffast-math"],
}
TEXT = (
    "Every table's header, compiled four ways and run at the random sets and "
    "corners: the largest difference from the Python runtime relative to the largest weight, and the largest per-set "
    "E_mean of what the C code returns. Contraction may change the last bits of a sum, and more of one that cancels. "
    "Conformance tests compile without it for 2e-6."
)


def section(samples: Samples, tables: Mapping[str, Table]) -> Section:
    """Compile and run every table every way."""
    values = samples.reference.parameters
    inputs = np.insert(values, 1, 0.0, axis=1).astype(np.float32)
    rows: list[Row] = []
    with tempfile.TemporaryDirectory() as folder:
        for name, table in tables.items():
            runtime = table.whole(table.evaluate(np.delete(inputs, 1, axis=1).astype(np.float64)))
            truth = table.whole(samples.reference.weights, table.bands)
            row: dict[str, object] = {"table": name}
            for label, flags in _FLAGS.items():
                got = compiled.weights(compiled.header_of(table), inputs, Path(folder) / "run", flags)
                row[f"{label}: from the runtime"] = float(np.abs(got - runtime).max() / np.abs(runtime).max())
                row[f"{label}: E_mean"] = e_mean(got - truth, samples.reference.headline)
            rows.append(row)
    return Section("contraction", "Compilers and contraction", TEXT, rows, told=outcomes.contraction(rows))
