"""The report's HTML page."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined

from skylight_sh.report import choice, origins, player, savings, titles
from skylight_sh.report.amounts import count, percent, plain
from skylight_sh.report.cells import Cell, fraction, number, text
from skylight_sh.report.figures import PICTURES
from skylight_sh.report.report_data import Entry, ReportData
from skylight_sh.report.timings import Timings
from skylight_sh.runtime import Packed
from skylight_sh.table.size import bytes_of, coefficients_of

# Beyond this condition number double precision holds no digit of what normal equations need.
_NOISE = 1e15


def html(data: ReportData, pictures: Mapping[str, tuple[int, int]], timings: Timings) -> bytes:
    """Return the page; ``pictures`` names the figures that lie beside it, with their width and height as shown."""
    choices = choice.choices(data, timings)
    page = _TEMPLATES.get_template("index.html.j2").render(
        name=data.name,
        player=player.of(data),
        title=titles.title(data.light.title, data.settings),
        ranges=titles.ranges(data.settings, {axis.name: axis.unit for axis in data.axes}),
        quantity=titles.quantity(data.settings),
        channels=", ".join(data.light.channels),
        azimuth=data.best.table.spec.azimuth is None,
        best=data.best,
        scale=choice.scale(data),
        choices=[_choice(data, one, timings) for one in choices],
        tables=_tables(data, timings),
        references=_references(data),
        noisy=is_noisy(data),
        machine=timings.machine if any(_timed(e, timings) for e in data.winners) else "",
        packed=any(isinstance(e.table.body, Packed) for e in data.winners),
        conventions=data.conventions,
        pictures=[(name, PICTURES[name], shown) for name, shown in pictures.items()],
        degrees=_degrees(data),
        explained=origins.explained(data.origins, data.best.headline[0]) if data.origins is not None else [],
        facts=_facts(data),
        skipped=savings.rows(data),
        settings=json.dumps(data.settings, indent=2),
    )
    return page.encode()


def _timed(entry: Entry, timings: Timings) -> float | None:
    timing = timings.of(entry.name, bytes_of(entry.table))
    return timing.ns if timing else None


def _files(data: ReportData, entry: Entry) -> dict[str, str]:
    place = "export" if entry.name == data.recommended else f"export/{entry.name}"
    return {"C": f"{place}/skylight_sh.h", "NPZ": f"{place}/skylight_sh.npz"}


def _choice(data: ReportData, one: choice.Choice, timings: Timings) -> dict[str, Any]:
    entry, ns = one.entry, _timed(one.entry, timings)
    return {
        "needs": one.needs,
        "name": entry.name,
        "bytes": count(bytes_of(entry.table)),
        "ns": None if ns is None else count(ns),
        "error": percent(entry.headline[0]),
        "means": one.means,
        "files": _files(data, entry),
    }


def _tables(data: ReportData, timings: Timings) -> list[dict[str, Any]]:
    """Return a row a winner: its name, its files and its cells by their headings, the decisive ones first."""
    twins = choice.same_as(data.winners)
    anyone = any(_timed(entry, timings) is not None for entry in data.winners)
    return [
        {
            "name": entry.name,
            "twin": twins.get(entry.name),
            "best": entry.name == data.recommended,
            "files": _files(data, entry),
            "cells": _cells(data, entry, _timed(entry, timings), anyone),
        }
        for entry in data.winners
    ]


def _cells(data: ReportData, entry: Entry, ns: float | None, timed: bool) -> dict[str, Cell]:
    table, bands = entry.table, entry.table.bands
    e_mean, e_max = entry.headline
    found = {"bytes": number(bytes_of(table))}
    if timed:
        found["ns a call"] = number(ns) if ns is not None else text("not timed")
    found["E_mean"] = fraction(e_mean)
    found["E_max"] = fraction(e_max)
    found["bands"] = number(bands)
    found["layout"] = text(table.body.kind)
    found["degrees"] = text(", ".join(map(str, table.degrees)))
    found["coefficients"] = number(coefficients_of(table))
    found["numbers"] = text(str(table.dtype) if not isinstance(table.body, Packed) else "packed bits")
    for convention, errors in zip(data.conventions[1:], entry.e_mean[1:], strict=True):
        found[f"E_mean ({convention})"] = fraction(float(errors[:, bands - 1].max()))
    found["relative L2"] = fraction(float(entry.rel_l2[:, bands - 1].max()))
    found["worst at"] = text(data.describe(entry.worst))
    return found


def is_noisy(data: ReportData) -> bool:
    """Say whether the run's own fit or a reference's is rounding noise: the page says so once."""
    own = _is_lost(data.settings["fit"]["solver"], data.condition)
    return own or any(_is_noise(data, entry) for entry in data.references)


def _is_noise(data: ReportData, entry: Entry) -> bool:
    """Say whether a reference's fit is what rounding leaves of normal equations that double precision cannot hold."""
    solvers = {told["name"]: told["solver"] for told in data.settings["fit"]["references"]}
    return _is_lost(solvers.get(entry.name, ""), entry.condition)


def _is_lost(solver: str, condition: float | None) -> bool:
    return solver == "normal" and condition is not None and condition > _NOISE


def _references(data: ReportData) -> list[dict[str, Any]]:
    found = []
    for entry in data.references:
        table, bands = entry.table, min(entry.table.bands, data.best.table.bands)
        e_mean, e_max = entry.headline_at(bands)
        cells = {
            "bytes": number(bytes_of(table, bands)),
            "E_mean": fraction(e_mean),
            "E_max": fraction(e_max),
            "bands": number(bands),
            "basis": text(table.spec.basis),
            "degrees": text(", ".join(map(str, table.degrees))),
            "numbers": text(str(table.dtype)),
            "condition number": text("not told")
            if entry.condition is None
            else Cell(f"{entry.condition:.2g}".replace("e+", "e"), entry.condition),
            "worst at": text(data.describe(entry.worst)),
        }
        found.append({"name": entry.name, "noisy": _is_noise(data, entry), "cells": cells})
    return found


def _facts(data: ReportData) -> dict[str, str]:
    sets = int(np.prod([nodes.size for nodes in data.grid]))
    truth = data.settings["truth"]
    return {
        "Light": data.light.title,
        "Axes": "; ".join(f"{a.name} [{a.low:.6g}, {a.high:.6g}] {a.unit}, map {a.map}" for a in data.axes),
        "Truth": f"{data.rule['rule']} quadrature, {count(int(data.rule['nodes']))} nodes, estimated error "
        f"{data.rule['estimate']:.1e} of each set's largest weight ({data.rule['tolerance']:.1e} allowed)",
        "Seen by selection": f"{count(sets)} grid sets that share no interior node with the fit grid, and "
        f"{count(truth['random'])} random sets",
        "Errors": f"measured on {count(data.held_out)} held-out sets that nothing else reads: {count(truth['held_out'])} "
        f"scrambled Sobol sets, {count(truth['held_out_edge'])} on each edge of the ranges, and the corners",
        "Stored orders": "m >= 0 (the light is mirror-symmetric about the sun's azimuth)"
        if data.harmonics.mirrored
        else "all",
        "Condition number of the fit": f"{data.condition:.3g}".replace("e+", "e"),
        "Least luminance over all sets": f"{plain(float(data.least.min()), 5)} {titles.unit(data.settings)}",
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
