"""Noise in the samples, and how much of it reaches the fit."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from skylight_sh.studies import outcomes, single_fit
from skylight_sh.studies.grid_samples import Samples
from skylight_sh.studies.page import Row, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_LEVELS = tuple(10.0**k for k in range(-12, -1))
TEXT = (
    "Every sample is multiplied by 1 + noise times a normal random number; the figure is the largest change of any "
    "weight over random sets and corners, relative to its set's largest weight, divided by the noise. Least squares "
    "on more samples than coefficients averages noise out: an amplification of about 1, the same at every level, says "
    "that a fit passes on no more than it is given; one that grows as the noise vanishes says that rounding of the fit's "
    "own is below it."
)


def section(samples: Samples) -> Section:
    """Refit with noise and compare with the fit without it, at the paper's degrees."""
    rng = np.random.default_rng(5)
    clean = samples.half
    drawn = rng.normal(size=clean.shape)
    rows: list[Row] = []
    for label, basis, solver, kind in (
        ("monomial, raw, normal equations", "monomial", "normal", "raw"),
        ("monomial, raw, SVD", "monomial", "svd", "raw"),
        ("Chebyshev, SVD", "chebyshev", "svd", "identity"),
        ("Chebyshev, config's maps and prefactor", "chebyshev", "svd", "config"),
    ):
        base = _weights(samples, clean, basis, solver, kind)
        scale = np.abs(samples.reference.weights).max(axis=(1, 2))[:, np.newaxis]
        for level in _LEVELS:
            noisy = _weights(samples, clean * (1 + level * drawn), basis, solver, kind)
            change = float((np.abs(noisy - base) / scale).max())
            rows.append({"fit": label, "noise": level, "change": change, "amplification": change / level})
    return Section("noise", "Noise in the samples", TEXT, rows, _draw, outcomes.noise(rows))


def _weights(samples: Samples, values: np.ndarray, basis: str, solver: str, kind: str) -> np.ndarray:
    made = single_fit.fit(samples, values, single_fit.paper_degrees(samples), basis, solver, kind)
    where = samples.reference.parameters
    classes, count = made.dense.shape[:2]
    sums = made.products(where) @ made.dense.reshape(classes * count, -1).T
    weights = made.weights(where, sums.reshape(len(where), classes, count), samples.reference.weights.shape[1])
    return weights.reshape(len(where), -1)


def _draw(rows: Sequence[Row]) -> Figure:
    from skylight_sh.report import style

    figure = style.figure(style.WIDTH, 5.2)
    axes = figure.subplots()
    for i, label in enumerate(dict.fromkeys(str(row["fit"]) for row in rows)):
        mine = [row for row in rows if row["fit"] == label]
        axes.loglog([row["noise"] for row in mine], [row["amplification"] for row in mine], label=label, **style.look(i))
    axes.set_xlabel("noise in the samples (relative)")
    axes.set_ylabel("change of the fit / noise")
    style.decades(axes.xaxis)
    style.decades(axes.yaxis)
    axes.grid(True, which="major", alpha=0.3)
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", fontsize=11, frameon=False)
    return figure
