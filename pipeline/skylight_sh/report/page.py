"""The report's HTML page."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined

from skylight_sh.report import savings
from skylight_sh.report.figures import PICTURES
from skylight_sh.report.report_data import Entry, Material
from skylight_sh.report.style import percent
from skylight_sh.table.size import bytes_of, coefficients_of


def html(material: Material, pictures: Sequence[str]) -> bytes:
    """Return the page; ``pictures`` names the figures that lie beside it."""
    page = _TEMPLATES.get_template("index.html.j2").render(
        name=material.name,
        title=material.light.title,
        best=_row(material, material.best, material.best.table.bands),
        tables=[_row(material, e, e.table.bands) for e in material.winners],
        references=[_row(material, e, min(e.table.bands, material.best.table.bands)) for e in material.references],
        conventions=material.conventions,
        pictures=[(name, PICTURES[name]) for name in pictures],
        degrees=_degrees(material),
        facts=_facts(material),
        skipped=savings.rows(material),
        settings=json.dumps(material.settings, indent=2),
    )
    return page.encode()


def _row(material: Material, entry: Entry, bands: int) -> dict[str, Any]:
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
        "worst": material.describe(entry.worst),
        "condition": None if entry.condition is None else f"{entry.condition:.2g}",
    }


def _facts(material: Material) -> dict[str, str]:
    sets = int(np.prod([nodes.size for nodes in material.grid]))
    truth = material.settings["truth"]
    random = truth["random"]
    return {
        "Light": material.light.title,
        "Axes": "; ".join(f"{a.name} [{a.low:.6g}, {a.high:.6g}] {a.unit}, map {a.map}" for a in material.axes),
        "Truth": f"{material.rule['rule']} quadrature, {material.rule['nodes']} nodes, estimated error "
        f"{material.rule['estimate']:.1e} of each set's largest weight",
        "Seen by selection": f"{sets} grid sets that share no interior node with the fit grid, and {random} random sets",
        "Errors": f"measured on {material.held_out} held-out sets that nothing else reads: {truth['held_out']} scrambled "
        f"Sobol sets, {truth['held_out_edge']} on each edge of the ranges, and the corners",
        "Stored orders": "m >= 0 (the light is mirror-symmetric about the sun's azimuth)"
        if material.harmonics.mirrored
        else "all",
        "Condition number of the fit": f"{material.condition:.3g}",
        "Least luminance over all sets": f"{material.least.min():.5g} cd/m2",
    }


def _degrees(material: Material) -> dict[str, Any] | None:
    """Return the degree by degree table of the recommended bands, or None unless there are two axes."""
    if len(material.axes) != 2 or len(material.sweep.degrees) < 2:
        return None
    error = material.sweep.e_mean[0, :, :, material.best.table.bands - 1].max(axis=1)
    cells = {tuple(d): percent(float(e)) for d, e in zip(material.sweep.degrees.tolist(), error, strict=True)}
    first, second = (np.unique(material.sweep.degrees[:, i]).tolist() for i in (0, 1))
    return {
        "first": first,
        "rows": [(d, [cells[f, d] for f in first]) for d in second],
        "names": [axis.name.replace("_", " ") for axis in material.axes],
        "bands": material.best.table.bands,
    }


_TEMPLATES = Environment(
    loader=PackageLoader("skylight_sh.report"),
    undefined=StrictUndefined,
    autoescape=True,
    trim_blocks=True,
    lstrip_blocks=True,
)
