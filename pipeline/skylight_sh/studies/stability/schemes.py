"""Number types and evaluation schemes: powers, Horner, Clenshaw and the recurrence, in 64 to 16 bits."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.errors import e_mean
from skylight_sh.formula.bases import BASES
from skylight_sh.studies import outcomes, single_fit
from skylight_sh.studies.grid_samples import Samples
from skylight_sh.studies.page import Row, Section
from skylight_sh.table.grid_fit import GridFit

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
Floats = NDArray[np.floating]

TEXT = (
    "The paper's degrees for every basis, coefficients rounded to a number type and summed in it (int16: one step for "
    "the whole table, summed in float32), by powers u**k, Horner's scheme, Clenshaw's, or products with the basis's "
    "own recurrence, which is what tables ship with: as float32, or as whole numbers of one step in as many bits as each "
    "needs. Coefficients of raw monomials are large and cancel; scaled variables keep them small."
)
_BITS = ("float64", "float32", "float16", "int16")


def section(samples: Samples) -> Section:
    """Evaluate the same fits every way; errors are the largest per-set E_mean on random sets and corners."""
    rows: list[Row] = []
    for label, basis, kind in (
        ("monomial, raw (the paper)", "monomial", "raw"),
        ("monomial, scaled", "monomial", "identity"),
        ("Chebyshev, scaled", "chebyshev", "identity"),
        ("Chebyshev, config's maps and prefactor", "chebyshev", "config"),
    ):
        schemes = ("powers", "Horner") if basis == "monomial" else ("recurrence", "Clenshaw")
        made = single_fit.fit(samples, samples.half, single_fit.paper_degrees(samples), basis, "svd", kind)
        for scheme in schemes:
            row: dict[str, object] = {"fit": label, "scheme": scheme}
            row |= {bits: _error(samples, made, scheme, bits) for bits in _BITS}
            rows.append(row)
    return Section("schemes", "Number types and evaluation schemes", TEXT, rows, _draw, outcomes.schemes(rows))


def _error(samples: Samples, made: GridFit, scheme: str, bits: str) -> float:
    """Return the largest per-set E_mean of a fit kept as ``bits`` and summed by ``scheme``."""
    dense = made.dense
    dtype = np.dtype("float32" if bits == "int16" else bits)
    with np.errstate(all="ignore"):
        if bits == "int16":
            step = np.abs(dense).max() / 32767
            kept = (np.round(dense / step) * step).astype(dtype)
        else:
            kept = dense.astype(dtype)
        values = samples.reference.parameters.astype(dtype)
        got: Floats = np.repeat(kept[np.newaxis], len(values), axis=0)
        for i in reversed(range(len(made.axes))):
            u = made.axes[i].scaled(values[:, i]).reshape(-1, *(1,) * (got.ndim - 2))
            got = SCHEMES[scheme](got, u)
        truth = samples.reference.weights
        weights = made.weights(samples.reference.parameters, got.astype(np.float64), truth.shape[1])
        return e_mean(weights - truth, samples.reference.headline)


def powers(coefficients: Floats, u: Floats) -> Floats:
    """Sum ``c_k u**k`` over the last axis of ``coefficients``, each power on its own; ``u`` broadcasts to the rest."""
    total = np.zeros(coefficients.shape[:-1], dtype=coefficients.dtype)
    for k in range(coefficients.shape[-1]):
        total = total + coefficients[..., k] * u**k
    return np.asarray(total)


def horner(coefficients: Floats, u: Floats) -> Floats:
    """Sum ``c_k u**k`` over the last axis from the highest power down."""
    total = coefficients[..., -1]
    for k in range(coefficients.shape[-1] - 2, -1, -1):
        total = total * u + coefficients[..., k]
    return np.asarray(total)


def recurrence(coefficients: Floats, u: Floats) -> Floats:
    """Sum ``c_k T_k(u)`` over the last axis with the values of the recurrence."""
    values = BASES["chebyshev"].vander(np.asarray(u), coefficients.shape[-1] - 1)
    return np.asarray((coefficients * values).sum(axis=-1, dtype=coefficients.dtype))


def clenshaw(coefficients: Floats, u: Floats) -> Floats:
    """Sum ``c_k T_k(u)`` over the last axis by Clenshaw's recurrence on the coefficients."""
    one = np.zeros(coefficients.shape[:-1], dtype=coefficients.dtype)
    two = one
    for k in range(coefficients.shape[-1] - 1, 0, -1):
        one, two = 2 * u * one - two + coefficients[..., k], one
    return np.asarray(u * one - two + coefficients[..., 0])


SCHEMES = {"powers": powers, "Horner": horner, "recurrence": recurrence, "Clenshaw": clenshaw}


def _draw(rows: Sequence[Row]) -> Figure:
    from skylight_sh.report import style

    figure = style.figure(style.WIDTH, 1.4 + 0.95 * len(rows))
    axes = figure.subplots()
    width, most, least = 0.18, 1e6, 1e-6
    for i, bits in enumerate(_BITS):
        lengths = [min(value, most) if np.isfinite(value := float(str(row[bits]))) else most for row in rows]
        axes.barh(np.arange(len(rows)) + (i - 1.5) * width, lengths, width, color=style.SERIES[i], label=bits)
    axes.set_xscale("log")
    axes.set_xlim(least, most)
    # Each bar's group is told above it, where there is room for it.
    for place, row in enumerate(rows):
        axes.text(1.4 * least, place - 2.15 * width, f"{row['fit']}, {row['scheme']}", va="bottom", fontsize=11)
    axes.set_ylim(len(rows) - 0.5, -0.75)
    axes.set_yticks([])
    axes.xaxis.set_major_formatter(style.percent_ticks())
    axes.set_xticks([1e-5, 1e-3, 1e-1, 1e1, 1e3])
    style.decades(axes.xaxis)
    axes.set_xlabel("largest E_mean (to the edge: overflow)")
    axes.grid(True, axis="x", which="major", alpha=0.3)
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=2, fontsize=11, frameon=False)
    return figure
