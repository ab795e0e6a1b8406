"""The tables that a run has published."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

from skylight_sh import UserError, runtime
from skylight_sh.runtime import Table


def exported(folder: Path) -> tuple[dict[str, Table], dict[str, float]]:
    """Return a run's exported tables and their published E_mean by name. Raises UserError where there is no run."""
    summary = folder / "summary.json"
    if not summary.is_file():
        raise UserError(f"{folder} holds no summary.json. Run the same config first: skylight-sh run {folder.name}.")
    rows = json.loads(summary.read_text(encoding="utf-8"))["tables"]
    read = {row["name"]: runtime.read(folder / row["path"] / "skylight_sh.npz") for row in rows}
    # What is measured is the sky: of what stands about it the truth knows nothing.
    tables = {name: replace(table, surroundings=None) for name, table in read.items()}
    if not all(table.spec.mirrored for table in tables.values()):
        raise OSError(
            f"{folder} holds tables of all orders; benchmarks and stresses are for mirror-symmetric lights and "
            'truth.orders = "auto". Give such a config.'
        )
    return tables, {row["name"]: row["e_mean"] for row in rows}
