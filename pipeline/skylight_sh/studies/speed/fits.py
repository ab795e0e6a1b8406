"""Fits: error against time for every basis and solver."""

from __future__ import annotations

import dataclasses
import statistics
from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from skylight_sh.fit import least_squares
from skylight_sh.formula.bases import BASES
from skylight_sh.studies import outcomes, single_fit, timing
from skylight_sh.studies.grid_samples import Samples
from skylight_sh.studies.page import Row, Section
from skylight_sh.table.errors import headline

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TEXT = (
    "The paper's degrees, from samples in memory to coefficients, median seconds beside the largest per-set E_mean on "
    "sets the fit never saw. `tensor` solves one small system an axis, which is exact for a grid; the others solve "
    "one system over all grid points, as the paper describes. `paper ratio`: how many times faster than monomials by "
    "normal equations."
)
_FIRST = "monomial, raw, normal"


def section(samples: Samples, repeats: int) -> Section:
    """Time every combination in turn."""
    degrees = single_fit.paper_degrees(samples)
    calls: dict[str, Callable[[], np.ndarray]] = {}
    errors: dict[str, float] = {}
    for kind, label in (("raw", "raw"), ("identity", "scaled"), (single_fit.OWN, "config's maps, prefactor")):
        for basis in ("monomial",) if kind == "raw" else BASES:
            right, matrices = single_fit.system(samples, samples.half, degrees, basis, kind)
            for solver in least_squares.SOLVERS:
                name = f"{basis}, {label}, {solver}"
                calls[name] = partial(least_squares.fit_full, right, matrices, solver)
                made = single_fit.fit(samples, samples.half, degrees, basis, solver, kind)
                errors[name] = headline(single_fit.table_of(samples, made, "float64"), samples.reference)
            name = f"{basis}, {label}, tensor"
            calls[name] = partial(least_squares.fit_tensor, right, matrices)
            whole = dataclasses.replace(made, dense=least_squares.fit_tensor(right, matrices).reshape(made.dense.shape))
            errors[name] = headline(single_fit.table_of(samples, whole, "float64"), samples.reference)
    times = timing.rounds(calls, repeats)
    rows: list[Row] = []
    for name in calls:
        ratio = timing.ratios(times[_FIRST], times[name])
        row: dict[str, object] = {"fit": name, "ms": 1e3 * statistics.median(times[name]), "E_mean": errors[name]}
        row |= {"paper ratio": ratio.median, "spread": ratio.spread, "noisy": "yes" if ratio.noisy else ""}
        rows.append(row)
    return Section("fits", "Fits: error against time", TEXT, rows, _draw, outcomes.fits(rows))


def _draw(rows: Sequence[Row]) -> Figure:
    from skylight_sh.report import style

    figure = style.figure(style.WIDTH, 5.6)
    axes = figure.subplots()
    solvers = ("normal", "qr", "svd", "tensor")
    for i, basis in enumerate(BASES):
        for j, solver in enumerate(solvers):
            mine = [r for r in rows if str(r["fit"]).startswith(f"{basis},") and str(r["fit"]).endswith(f", {solver}")]
            # A little beside each other: bases of one space err alike in one time.
            times = [float(str(r["ms"])) * 1.03 ** (i - 1.5) for r in mine]
            axes.loglog(times, [r["E_mean"] for r in mine], style.MARKERS[j], color=style.SERIES[i], alpha=0.8)
    for i, basis in enumerate(BASES):
        axes.plot([], [], "o", color=style.SERIES[i], label=basis)
    for j, solver in enumerate(solvers):
        axes.plot([], [], style.MARKERS[j], color="white", markeredgecolor=style.BLACK, label=_SOLVERS[solver])
    axes.set_xlabel("milliseconds a fit")
    axes.set_ylabel("largest E_mean")
    axes.xaxis.set_major_formatter(style.plain_ticks())
    axes.yaxis.set_major_formatter(style.percent_ticks())
    style.steps(axes.xaxis)
    style.steps(axes.yaxis)
    axes.grid(True, which="major", alpha=0.3)
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=2, fontsize=11, frameon=False)
    return figure


_SOLVERS = {"normal": "normal equations", "qr": "QR", "svd": "SVD", "tensor": "tensor (a system an axis)"}
