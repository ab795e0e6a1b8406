"""The degree by degree table as a picture."""

from __future__ import annotations

import numpy as np
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

from skylight_sh.report import style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData

CAPTION = (
    "Largest E_mean in per cent (per-set L_min, worst channel, recommended table's bands) for every combination of "
    "degrees, from one orthogonal fit: lower degrees are its truncations. Two axes are shown, further ones "
    "at the degree named above the picture."
)


def draw(data: ReportData) -> Figure | None:
    """Draw the first two axes' degrees; further axes stand at their largest. None where nothing was swept."""
    sweep, bands = data.sweep, data.best.table.bands
    error = sweep.e_mean[0, :, :, bands - 1].max(axis=1)
    if error.size < 2:
        return None
    if len(data.axes) == 1:
        figure, found = style.panels(8, 4, top=0.15)
        axes = found[0, 0]
        axes.semilogy(sweep.degrees[:, 0], error, marker="o", color=style.BLUE)
        axes.set_xlabel(f"degree in {data.axes[0].name}")
        axes.set_ylabel("largest E_mean")
        axes.yaxis.set_major_formatter(style.percent_ticks())
        axes.grid(True, alpha=0.3)
        return figure
    full = np.all(sweep.degrees[:, 2:] == sweep.degrees[:, 2:].max(axis=0), axis=1)
    first, second = (np.unique(sweep.degrees[:, i]) for i in (0, 1))
    table = np.empty((second.size, first.size))
    rows = np.searchsorted(second, sweep.degrees[full, 1])
    table[rows, np.searchsorted(first, sweep.degrees[full, 0])] = 100 * error[full]
    figure, found = style.panels(11, 5.2, right=1.1)
    axes = found[0, 0]
    image = axes.imshow(table, origin="lower", aspect="auto", cmap=style.ERROR_MAP, norm=LogNorm())
    middle = np.sqrt(table.min() * table.max())
    for (i, j), value in np.ndenumerate(table):
        axes.text(j, i, _short(value), ha="center", va="center", fontsize=6.5, color="black" if value > middle else "white")
    axes.set_xticks(range(first.size), first.tolist())
    axes.set_yticks(range(second.size), second.tolist())
    axes.set_xlabel(f"degree in {data.axes[0].name}")
    axes.set_ylabel(f"degree in {data.axes[1].name}")
    held = zip(data.axes[2:], sweep.degrees[:, 2:].max(axis=0), strict=True)
    axes.set_title(", ".join(f"degree {degree} in {axis.name}" for axis, degree in held), fontsize=10)
    figure.colorbar(image, cax=style.bar(figure, 10.05, 0.55, 0.2, 4.3), label="largest E_mean, % of L_min")
    return figure


def _short(value: float) -> str:
    return f"{value:.0f}" if value >= 10 else f"{value:.2g}"


PICTURE = Picture("Error of every combination of degrees", CAPTION, draw)
