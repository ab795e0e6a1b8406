"""Condition number and error against degree, for every basis and solver."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from skylight_sh.studies import outcomes, single_fit
from skylight_sh.studies.grid_samples import Samples
from skylight_sh.studies.page import Row, Section
from skylight_sh.table.errors import headline

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_DEGREES = (2, 5, 8, 11, 13, 16, 20, 24, 28, 32, 36, 40)
# Label, basis, solver, change of variable; "config" stands for the config's own maps and prefactor.
_TRIED = (
    ("monomial, raw, normal equations", "monomial", "normal", "raw"),
    ("monomial, raw, QR", "monomial", "qr", "raw"),
    ("monomial, raw, SVD", "monomial", "svd", "raw"),
    ("monomial, scaled, normal equations", "monomial", "normal", "identity"),
    ("monomial, scaled, SVD", "monomial", "svd", "identity"),
    ("Fourier, SVD", "fourier", "svd", "identity"),
    ("Legendre, SVD", "legendre", "svd", "identity"),
    ("Chebyshev, normal equations", "chebyshev", "normal", "identity"),
    ("Chebyshev, QR", "chebyshev", "qr", "identity"),
    ("Chebyshev, SVD", "chebyshev", "svd", "identity"),
    ("Chebyshev, config's maps and prefactor", "chebyshev", "svd", "config"),
)
TEXT = (
    "The first axis's degree grows to 40, the others stay at their largest swept degree; the fit grid has enough "
    "nodes for each. Error is the largest per-set E_mean on random sets and corners of a table kept and evaluated in "
    "that number type. A fit has broken where a higher degree errs more. Monomials and Chebyshev polynomials of one "
    "variable span the same space: what tells them apart is rounding alone, by their condition numbers."
)


def section(samples: Samples) -> Section:
    """Fit and measure every combination. ``samples``' first axis needs more than 40 nodes for the highest degrees."""
    rows = [row for tried in _TRIED for row in _rows(samples, *tried)]
    return Section("bases", "Bases and solvers against degree", TEXT, rows, _draw, outcomes.bases(rows))


def _rows(samples: Samples, label: str, basis: str, solver: str, kind: str) -> list[Row]:
    rest = [min(axis.degrees[1], 7) for axis in samples.config.axes[1:]]
    rows: list[Row] = []
    for first in (d for d in _DEGREES if d < samples.nodes[0].size):
        row: dict[str, object] = {"fit": label, "degree": first}
        try:
            made = single_fit.fit(samples, samples.half, (first, *rest), basis, solver, kind)
        except np.linalg.LinAlgError:
            # The system is singular to the last bit: nothing to measure.
            rows.append(row | {"condition": np.inf, "E_mean float64": np.inf, "E_mean float32": np.inf})
            continue
        row["condition"] = made.condition
        for dtype in ("float64", "float32"):
            # Overflow is one of the ways to break; it shows as an infinite error.
            with np.errstate(over="ignore", invalid="ignore"):
                row[f"E_mean {dtype}"] = headline(single_fit.table_of(samples, made, dtype), samples.reference)
        rows.append(row)
    return rows


def _draw(rows: Sequence[Row]) -> Figure:
    from skylight_sh.report import style

    figure = style.figure(style.WIDTH, 12.4)
    panels = figure.subplots(3, 1)
    for i, (label, *_) in enumerate(_TRIED):
        mine = [row for row in rows if row["fit"] == label]
        degrees = [row["degree"] for row in mine]
        for panel, key in zip(panels, ("condition", "E_mean float64", "E_mean float32"), strict=True):
            panel.semilogy(degrees, [row[key] for row in mine], label=label, **style.look(i))
    for panel, title in zip(panels, ("condition number", "largest E_mean, float64", "largest E_mean, float32"), strict=True):
        panel.set_title(title, fontsize=11)
        panel.set_xlabel("degree of the first axis")
        panel.grid(True, which="major", alpha=0.3)
        style.decades(panel.yaxis)
    for panel in panels[1:]:
        panel.yaxis.set_major_formatter(style.percent_ticks())
        panel.set_ylim(1e-7, 1e4)
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", fontsize=11, frameon=False)
    return figure
