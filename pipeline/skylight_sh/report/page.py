"""The report's HTML page."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined

from skylight_sh.report import savings
from skylight_sh.report.figures import PICTURES
from skylight_sh.report.report_data import Entry, ReportData
from skylight_sh.report.style import percent
from skylight_sh.table.size import bytes_of, coefficients_of


def html(data: ReportData, pictures: Sequence[str]) -> bytes:
    """Return the page; ``pictures`` names the figures that lie beside it."""
    page = _TEMPLATES.get_template("index.html.j2").render(
        name=data.name,
        title=data.light.title,
        best=_row(data, data.best, data.best.table.bands),
        tables=[_row(data, e, e.table.bands) for e in data.winners],
        references=[_row(data, e, min(e.table.bands, data.best.table.bands)) for e in data.references],
        conventions=data.conventions,
        pictures=[(name, PICTURES[name]) for name in pictures],
        degrees=_degrees(data),
        facts=_facts(data),
        skipped=savings.rows(data),
        settings=json.dumps(data.settings, indent=2),
    )
    return page.encode()


def _row(data: ReportData, entry: Entry, bands: int) -> dict[str, Any]:
    e_mean, e_max = entry.headline_at(bands)
    strict = [percent(float(e[:, bands - 1].max())) for e in entry.e_mean[1:]]
    return {
        "name": entry.name,
        "bands": bands,
        "basis": entry.table.spec.basis,
        "degrees": ", ".join(map(str, entry.table.degrees)),
        "dtype": str(entry.table.dtype),
        "layout": entry.table.body.kind,
        "coefficients": coefficients_of(entry.table),
        "bytes": bytes_of(entry.table, bands),
        "e_mean": percent(e_mean),
        "e_max": percent(e_max),
        "stricter": strict,
        "rel_l2": percent(float(entry.rel_l2[:, bands - 1].max())),
        "worst": data.describe(entry.worst),
        "condition": None if entry.condition is None else f"{entry.condition:.2g}",
    }


def _facts(data: ReportData) -> dict[str, str]:
    sets = int(np.prod([nodes.size for nodes in data.grid]))
    truth = data.settings["truth"]
    random = truth["random"]
    return {
        "Light": data.light.title,
        "Axes": "; ".join(f"{a.name} [{a.low:.6g}, {a.high:.6g}] {a.unit}, map {a.map}" for a in data.axes),
        "Truth": f"{data.rule['rule']} quadrature, {data.rule['nodes']} nodes, estimated error "
        f"{data.rule['estimate']:.1e} of each set's largest weight ({data.rule['tolerance']:.1e} allowed)",
        "Seen by selection": f"{sets} grid sets that share no interior node with the fit grid, and {random} random sets",
        "Errors": f"measured on {data.held_out} held-out sets that nothing else reads: {truth['held_out']} scrambled "
        f"Sobol sets, {truth['held_out_edge']} on each edge of the ranges, and the corners",
        "Stored orders": "m >= 0 (the light is mirror-symmetric about the sun's azimuth)"
        if data.harmonics.mirrored
        else "all",
        "Condition number of the fit": f"{data.condition:.3g}",
        "Least luminance over all sets": f"{data.least.min():.5g} cd/m2",
    }


def _degrees(data: ReportData) -> dict[str, Any] | None:
    """Return the degree by degree table of the recommended bands, or None unless there are two axes."""
    if len(data.axes) != 2 or len(data.sweep.degrees) < 2:
        return None
    error = data.sweep.e_mean[0, :, :, data.best.table.bands - 1].max(axis=1)
    cells = {tuple(d): percent(float(e)) for d, e in zip(data.sweep.degrees.tolist(), error, strict=True)}
    first, second = (np.unique(data.sweep.degrees[:, i]).tolist() for i in (0, 1))
    return {
        "first": first,
        "rows": [(d, [cells[f, d] for f in first]) for d in second],
        "names": [axis.name.replace("_", " ") for axis in data.axes],
        "bands": data.best.table.bands,
    }


_TEMPLATES = Environment(
    loader=PackageLoader("skylight_sh.report"),
    undefined=StrictUndefined,
    autoescape=True,
    trim_blocks=True,
    lstrip_blocks=True,
)
