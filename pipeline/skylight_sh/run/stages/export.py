"""Export: every winner as a C header, an NPZ and the shaders asked for, and the summary that names them."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Mapping
from typing import Any

from skylight_sh import __version__
from skylight_sh.config.schema import Config
from skylight_sh.config.wanted import table_names, wanted
from skylight_sh.export import prefixes, targets
from skylight_sh.export.c_header import Facts
from skylight_sh.fit.errors import published
from skylight_sh.run.executors import Advance
from skylight_sh.run.files import to_dataset
from skylight_sh.run.from_config import headline_of, read_table
from skylight_sh.run.plan import Inputs
from skylight_sh.run.provenance import settings, settings_digest, whole_settings
from skylight_sh.runtime import Table
from skylight_sh.store.dataset import Dataset
from skylight_sh.table.size import bytes_of, coefficients_of


def facts_of(config: Config, table: Table, measured: Dataset, name: str) -> dict[str, Any]:
    """Return one row of the summary: a table's name, place, size and measured errors, to four digits."""
    place = "export" if name == config.export.recommended else f"export/{name}"
    e_mean, e_max = headline_of(measured, f"tables/{name}")
    return {
        "name": name,
        "path": place,
        "prefix": prefixes.by_table(table_names(config), config.export.recommended, config.export.prefix)[name],
        "bands": table.bands,
        "dtype": str(table.dtype),
        "layout": table.body.kind,
        "bytes": bytes_of(table),
        "coefficients": coefficients_of(table),
        "e_mean": e_mean,
        "e_max": e_max,
        "l_min": str(measured.attrs["conventions"]).split(",")[0],
        "quantity": table.spec.quantity,
        "least": published(measured[f"tables/{name}/least"]),
    }


def told_of(config: Config, row: Mapping[str, Any]) -> Facts:
    """Return what a table's files say of it, from its ``row`` of the summary."""
    return Facts(
        config.source.title,
        row["e_mean"],
        row["e_max"],
        row["l_min"],
        [f"skylight-sh {__version__}, config {config.name} {settings_digest(config)[:16]}, table {row['name']}"],
        least=row["least"],
        luminance=config.source.luminance_row.tolist(),
    )


def make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    """Write every winner's files and the summary."""
    select, measured = inputs["select"], inputs["measure"]
    asked = wanted(config)
    files: dict[str, bytes] = {}
    rows = []
    for done, request in enumerate(asked):
        advance(done, len(asked))
        name = request.name
        found = read_table(select, f"tables/{name}")
        row = facts_of(config, found, measured, name)
        rows.append(row)
        provenance = {
            "table": name,
            "budget": request.budget,
            "e_mean": row["e_mean"],
            "e_max": row["e_max"],
            "l_min": row["l_min"],
            "config": settings(config),
            "version": __version__,
        }
        table = dataclasses.replace(found, provenance=provenance)
        facts = told_of(config, row)
        written = targets.write(config.export.targets, table, facts, row["prefix"])
        files |= {f"{row['path']}/{file}": data for file, data in written.items()}
    summary = {"config": whole_settings(config), "recommended": config.export.recommended, "tables": rows}
    files["summary.json"] = (json.dumps(summary, indent=2) + "\n").encode()
    return to_dataset(files)
