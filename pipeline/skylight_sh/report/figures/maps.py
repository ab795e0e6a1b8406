"""E_mean over the parameter space."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

from skylight_sh.fit.axis import Axis
from skylight_sh.report import style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import Entry, ReportData

CAPTION = (
    "E_mean of each winner laid out for speed over the verification grid (worst channel, per-set L_min). A cross "
    "marks the worst set. Where there are more than two axes, the worst over the others is shown, and where on them "
    "the worst set lies."
)


def draw(data: ReportData) -> Figure:
    """Draw one map a winner, or one line where there is one axis."""
    found = [(entry, entry.per_set) for entry in data.winners if entry.per_set is not None]
    entries = [entry for entry, _ in found]
    if len(data.axes) == 1:
        return _lines(data, found)
    columns = min(4, len(entries))
    rows = -(-len(entries) // columns)
    width, height = 4.0 * columns, 3.3 * rows
    top = 0.4 if data.axes[2:] else 0.25
    figure, placed = style.panels(width, height, rows, columns, left=0.85, right=1.05, top=top, gap=(0.2, top + 0.05))
    grids = [np.maximum(_grid(data, per_set), 1e-12) for _, per_set in found]
    low, high = 100 * min(float(g.min()) for g in grids), 100 * max(float(g.max()) for g in grids)
    panels: list[Axes] = list(placed.ravel())
    first, second = data.axes[:2]
    for panel, entry, grid in zip(panels, entries, grids, strict=False):
        x, y = _shown(first, data.grid[0]), _shown(second, data.grid[1])
        image = panel.pcolormesh(x, y, 100 * grid.T, cmap=style.ERROR_MAP, norm=LogNorm(low, high), shading="nearest")
        panel.plot(
            _shown(first, entry.worst[:1]),
            _shown(second, entry.worst[1:2]),
            "x",
            color=style.RED,
            markersize=9,
            markeredgewidth=2,
            clip_on=False,
            zorder=5,
        )
        where = f"\nworst at {data.describe(entry.worst, first=2)}" if data.axes[2:] else ""
        panel.set_title(f"{entry.name}: {style.percent(entry.headline[0])}{where}", fontsize=9)
    for place, panel in enumerate(panels):
        panel.yaxis.set_visible(place % columns == 0)
        panel.xaxis.set_visible(place + columns >= len(entries))
        if place >= len(entries):
            panel.set_axis_off()
    figure.supxlabel(_label(first), y=0.1 / height)
    figure.supylabel(_label(second), x=0.15 / width)
    others = " and ".join(axis.name.replace("_", " ") for axis in data.axes[2:])
    bar = style.bar(figure, width - 0.9, 0.55, 0.2, height - 0.55 - top)
    figure.colorbar(image, cax=bar, label="E_mean, % of L_min" + (f", worst over {others}" if others else ""))
    return figure


def _grid(data: ReportData, per_set: np.ndarray) -> np.ndarray:
    shape = tuple(nodes.size for nodes in data.grid)
    values = per_set[: int(np.prod(shape))].reshape(shape)
    return np.asarray(values.max(axis=tuple(range(2, len(shape)))) if len(shape) > 2 else values)


def _lines(data: ReportData, found: list[tuple[Entry, np.ndarray]]) -> Figure:
    figure, placed = style.panels(9, 4.5, top=0.15)
    axes = placed[0, 0]
    for i, (entry, per_set) in enumerate(found):
        values = per_set[: data.grid[0].size]
        axes.semilogy(_shown(data.axes[0], data.grid[0]), values, color=style.SERIES[i % 7], label=entry.name)
    axes.set_xlabel(_label(data.axes[0]))
    axes.set_ylabel("E_mean (fraction of L_min)")
    axes.grid(True, alpha=0.3)
    axes.legend(fontsize=8)
    return figure


def _shown(axis: Axis, values: np.ndarray) -> np.ndarray:
    return np.degrees(values) if axis.unit == "rad" else values


def _label(axis: Axis) -> str:
    unit = {"rad": " (degrees)", "1": ""}.get(axis.unit, f" ({axis.unit})")
    return axis.name.replace("_", " ") + unit


PICTURE = Picture("Where the error is", CAPTION, draw)
