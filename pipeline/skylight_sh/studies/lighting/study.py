"""The true lighting error of a run's tables: rows for people and programs, and their picture."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh import runtime
from skylight_sh.config.schema import Config
from skylight_sh.run.executors import Advance
from skylight_sh.run.stages import lighting
from skylight_sh.studies.page import Row, Section
from skylight_sh.table.lighting import Lighting, measure, promise

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TEXT = (
    "Fractions, each the largest over 512 scrambled Sobol sets of the light's parameters, 32 on each edge of their "
    "ranges, and the corners, by a seed used nowhere else. E_mean and E_max are as published. `E_mean allows`: the most "
    "that irradiance can be off, by E_mean and the clamped cosine alone. `irradiance`: what it is really off, table "
    "against the true weights of as many bands, over the irradiance towards the same normal, in luminance; `half of the "
    "sets`: the median; `channel`: the worst channel, over its own; `of largest`, `of least`: over the largest and the "
    "least irradiance of the same sky. `picture`: the relative RMSE of a picture of the courtyard through precomputed "
    "transfer, by the table's weights against true ones, the sun in the worst of four azimuths. `bands`: what as many "
    "true bands are off against the whole light (32 bands). Normals are 436, over all directions; those that face down "
    "count only for `of largest`. Surroundings are left out: of them the truth knows nothing."
)

# More lines than this nobody reads in a picture.
_DRAWN = 20


Array = NDArray[np.float64]


def rows(config: Config, folder: Path, form: Array) -> list[Row]:
    """Return a row a table that the run in ``folder`` has exported. Raises OSError where there is none.

    ``form`` is a picture's, of as many bands as any table.
    """
    on = lighting.surfaces_of(config, lambda *_: None)
    summary = _summary(folder)
    tables = [runtime.read(folder / row["path"] / "skylight_sh.npz") for row in summary]
    found: list[Row] = []
    for row, table in zip(summary, tables, strict=True):
        measured = measure(table, on)
        allowed = None if measured.bound is None else row["e_mean"] * promise(table.bands, table.spec.quantity)
        at = on.light.parameters[int(measured.table.local.argmax())]
        found.append(_row(config, row, measured, allowed, lighting.of_picture(form, table, on), at.tolist()))
    return found


def _summary(folder: Path) -> list[dict[str, Any]]:
    """Return what a run's summary says of its tables. Raises OSError."""
    found: list[dict[str, Any]] = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["tables"]
    return found


def _row(config: Config, row: Any, found: Lighting, allowed: float | None, picture: Array, at: Sequence[float]) -> Row:
    return {
        "config": config.name,
        "table": row["name"],
        "bytes": row["bytes"],
        "E_mean": row["e_mean"],
        "E_max": row["e_max"],
        "E_mean allows": allowed,
        "irradiance": float(found.table.local.max()),
        "half of the sets": float(np.median(found.table.local)),
        "channel": float(found.channel.local.max()),
        "of largest": float(found.table.of_largest.max()),
        "of least": float(found.table.of_least.max()),
        "picture": float(picture.max()),
        "half of the sets, picture": float(np.median(picture)),
        "bands": float(found.bands.local.max()),
        "half of the sets, bands": float(np.median(found.bands.local)),
        "worst at": ", ".join(f"{axis.name} {value:.4g}" for axis, value in zip(config.axes, at, strict=True)),
    }


def section(runs: Sequence[tuple[Config, Path]], advance: Advance) -> Section:
    """Measure ``runs``, configs and their reports' folders; a picture shows the tables where they are few enough."""
    bands = [row["bands"] for _, folder in runs for row in _summary(folder)]
    form, found = lighting.picture_form(max(bands)), list[Row]()
    for done, (config, folder) in enumerate(runs):
        advance(done, len(runs))
        found += rows(config, folder, form)
    draw = _draw if len(found) <= _DRAWN else None
    return Section("lighting", "What is promised, and what light on surfaces really loses", TEXT, found, draw)


def _draw(found: Sequence[Row]) -> Figure:
    from skylight_sh.report.figures import lighting_error as picture

    columns = {
        picture.PROMISED: "E_mean",
        picture.ALSO: "E_max",
        picture.LOST: "irradiance",
        picture.PICTURE_LOST: "picture",
        picture.BANDS: "bands",
    }
    values = {label: [float(str(row[key])) for row in found] for label, key in columns.items()}
    return picture.lines([str(row["table"]) for row in found], values)
