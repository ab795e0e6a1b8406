"""Export: every winner as a C header, an NPZ and the shaders asked for, and the summary that names them."""

from __future__ import annotations

import dataclasses
import io
import json
from collections.abc import Mapping
from functools import partial
from typing import Any

from pipeline.config.names import wanted
from pipeline.config.schema import Config
from pipeline.export import c_header, npz, shaders, vectors
from pipeline.run.executors import Advance
from pipeline.run.plan import Inputs, Step
from pipeline.run.provenance import environment, settings
from pipeline.run.stages.files import to_dataset
from pipeline.store.dataset import Dataset
from pipeline.table.table import Table

_PARTS = ("export", "files")
_CODE = (
    "light",
    "sphere",
    "fit",
    "table",
    "export",
    "runtime.py",
    "config/names.py",
    *(f"run/stages/{p}.py" for p in _PARTS),
)


def steps(config: Config) -> list[Step]:
    """Return the export's step."""
    parameters = {"config": settings(config), "targets": config.export.targets, "environment": environment()}
    return [Step("export", "", _CODE, ("select",), parameters, partial(_make, config))]


def table_of(select: Dataset, name: str) -> Table:
    """Return a winner from the selection's artifact."""
    return npz.read(io.BytesIO(select[f"tables/{name}/npz"].tobytes()))


def facts_of(config: Config, select: Dataset, name: str) -> dict[str, Any]:
    """Return one row of the summary: a table's name, place, size and measured errors."""
    table = table_of(select, name)
    place = "export" if name == config.export.recommended else f"export/{name}"
    return {
        "name": name,
        "path": place,
        "bands": table.bands,
        "dtype": str(table.dtype),
        "layout": table.body.kind,
        "bytes": table.bytes,
        "coefficients": table.coefficients,
        "e_mean": float(select[f"tables/{name}/e_mean"][0, :, -1].max()),
        "e_max": float(select[f"tables/{name}/e_max"][0, :, -1].max()),
        "l_min": str(select.attrs["conventions"]).split(",")[0],
        "quantity": table.quantity,
        "least": float(select[f"tables/{name}/least"]),
    }


def _make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    select = inputs["select"]
    asked = wanted(config)
    files: dict[str, bytes] = {}
    rows = []
    for done, table_wanted in enumerate(asked):
        advance(done, len(asked))
        name = table_wanted.name
        row = facts_of(config, select, name)
        rows.append(row)
        provenance = {
            "table": name,
            "budget": table_wanted.budget,
            "e_mean": row["e_mean"],
            "e_max": row["e_max"],
            "l_min": row["l_min"],
            "config": settings(config),
            "environment": environment(),
            "keys": {"select": str(select.attrs["key"])},
        }
        table = dataclasses.replace(table_of(select, name), provenance=provenance)
        facts = c_header.Facts(
            config.source.title,
            row["e_mean"],
            row["e_max"],
            row["l_min"],
            _lines(config, provenance),
            least=float(select[f"tables/{name}/least"]),
            luminance=config.source.luminance_row.tolist(),
        )
        files[f"{row['path']}/skylight_sh.npz"] = npz.write(table)
        files[f"{row['path']}/skylight_sh.h"] = c_header.write(table, facts, config.export.prefix).encode()
        if "vectors" in config.export.targets:
            files[f"{row['path']}/skylight_sh_vectors.txt"] = vectors.write(table).encode()
            files[f"{row['path']}/skylight_sh_selftest.c"] = vectors.self_test(table, config.export.prefix).encode()
        for language in config.export.shaders if shaders.obstacle(table) is None else ():
            text = shaders.write(table, facts, language, config.export.prefix)
            files[f"{row['path']}/skylight_sh.{language}"] = text.encode()
    summary = {"config": settings(config), "recommended": config.export.recommended, "tables": rows}
    files["summary.json"] = (json.dumps(summary, indent=2) + "\n").encode()
    return to_dataset(files)


def _lines(config: Config, provenance: Mapping[str, Any]) -> list[str]:
    env = provenance["environment"]
    versions = ", ".join(f"{name} {env[name]}" for name in ("python", "numpy", "scipy", "h5py", "dask"))
    return [
        f"config {config.name}, table {provenance['table']}",
        f"selection {provenance['keys']['select']}",
        versions,
        f"{env['machine']}: {' '.join(env['cpu_features'])}",
    ]
