"""The degree by degree table as a picture."""

from __future__ import annotations

import numpy as np
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

from skylight_sh.report import style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData

SEE = "Where colours stop to change along a row or column, higher degrees of that axis are wasted."
CAPTION = (
    "Largest E_mean (worst channel, the recommended table's bands) for every combination of degrees, from one orthogonal "
    "fit: lower degrees are its truncations. Two axes are shown, further ones at the degree named above the picture."
)

# Errors below are rounding alone: of a light that a few terms are exactly.
_EXACT = 1e-9


def draw(data: ReportData) -> Figure | None:
    """Draw the first two axes' degrees; further axes stand at their largest. None where nothing was swept, or all exact."""
    sweep, bands = data.sweep, data.best.table.bands
    error = sweep.e_mean[0, :, :, bands - 1].max(axis=1)
    if error.size < 2 or error.max() < _EXACT:
        return None
    if len(data.axes) == 1:
        figure, found = style.panels(style.WIDTH, 3.6, left=1.3, top=0.4, bottom=0.6)
        axes = found[0, 0]
        axes.semilogy(sweep.degrees[:, 0], np.maximum(error, _EXACT), marker="o", color=style.BLUE)
        axes.set_xlabel(f"degree in {_name(data, 0)}")
        axes.set_title("largest E_mean", fontsize=11)
        axes.yaxis.set_major_formatter(style.percent_ticks())
        style.decades(axes.yaxis)
        axes.grid(True, alpha=0.3)
        return figure
    full = np.all(sweep.degrees[:, 2:] == sweep.degrees[:, 2:].max(axis=0), axis=1)
    first, second = (np.unique(sweep.degrees[:, i]) for i in (0, 1))
    table = np.empty((second.size, first.size))
    rows = np.searchsorted(second, sweep.degrees[full, 1])
    table[rows, np.searchsorted(first, sweep.degrees[full, 0])] = error[full]
    figure, found = style.panels(style.WIDTH, 3.6, left=0.75, right=1.3, top=0.4, bottom=0.6)
    axes = found[0, 0]
    image = axes.imshow(table, origin="lower", aspect="auto", cmap=style.ERROR_MAP, norm=LogNorm())
    for axis, degrees in ((axes.xaxis, first), (axes.yaxis, second)):
        # Every second degree: letters are as wide as cells.
        axis.set_ticks(np.arange(0, degrees.size, 2), degrees[::2].tolist())
    axes.set_xlabel(f"degree in {_name(data, 0)}")
    axes.set_ylabel(f"degree in {_name(data, 1)}")
    held = zip(data.axes[2:], sweep.degrees[:, 2:].max(axis=0), strict=True)
    axes.set_title(", ".join(f"degree {degree} in {axis.name.replace('_', ' ')}" for axis, degree in held), fontsize=11)
    bar = figure.colorbar(image, cax=style.bar(figure, 3.85, 0.6, 0.18, 2.6))
    bar.ax.yaxis.set_major_formatter(style.percent_ticks())
    style.decades(bar.ax.yaxis)
    return figure


def _name(data: ReportData, place: int) -> str:
    return data.axes[place].name.replace("_", " ")


PICTURE = Picture("Error of every combination of degrees", CAPTION, draw, see=SEE)
