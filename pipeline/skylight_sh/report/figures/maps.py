"""E_mean over the parameter space."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from skylight_sh.fit.axis import Axis
from skylight_sh.report import style
from skylight_sh.report.choice import same_as
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import Entry, ReportData

SEE = "Even colour means that no sun and no weather pays for the others; a bright spot is where to look twice."
CAPTION = (
    "E_mean of each winner laid out for speed over the verification grid (worst channel, per set). A cross marks the worst "
    "set. Where there are more than two axes, the worst over the others is shown, and where on them the worst set lies."
)
# Inches: a map's height, and what stands above it for each line of its title.
_HEIGHT, _LINE, _FOOT = 1.45, 0.2, 1.35


def draw(data: ReportData) -> Figure:
    """Draw one map a winner, two beside each other, or one line each where there is one axis."""
    twins = same_as(data.winners)
    found = [(e, e.per_set) for e in data.winners if e.per_set is not None and e.name not in twins]
    if len(data.axes) == 1:
        return _lines(data, found)
    lines = 3 if data.axes[2:] else 2
    rows = -(-len(found) // 2)
    each = _HEIGHT + lines * _LINE + 0.16
    height = rows * each + _FOOT
    figure, placed = style.panels(style.WIDTH, height, left=0.0, right=0.0, bottom=0.0, top=0.0)
    figure.delaxes(placed[0, 0])
    grids = [np.maximum(_grid(data, per_set), 1e-12) for _, per_set in found]
    norm = LogNorm(min(float(g.min()) for g in grids), max(float(g.max()) for g in grids))
    first, second = data.axes[:2]
    left, gap = 0.82, 0.18
    half = (style.WIDTH - left - gap - 0.15) / 2
    for place, ((entry, _), grid) in enumerate(zip(found, grids, strict=True)):
        row, column = divmod(place, 2)
        # What stands alone in the last row takes all of it.
        alone = place == len(found) - 1 and column == 0
        across = 2 * half + gap if alone else half
        panel = style.bar(figure, left + column * (half + gap), _FOOT + (rows - 1 - row) * each, across, _HEIGHT)
        x, y = _shown(first, data.grid[0]), _shown(second, data.grid[1])
        image = panel.pcolormesh(x, y, grid.T, cmap=style.ERROR_MAP, norm=norm, shading="nearest")
        _cross(panel, _shown(first, entry.worst[:1]), _shown(second, entry.worst[1:2]))
        where = f"\nworst at {data.describe(entry.worst, first=2)}" if data.axes[2:] else ""
        panel.set_title(f"{entry.name}\nat most {style.percent(entry.headline[0])}{where}", fontsize=11, pad=3)
        panel.yaxis.set_visible(column == 0)
        panel.yaxis.set_major_locator(MaxNLocator(4))
        panel.xaxis.set_visible(row == rows - 1)
    figure.supxlabel(_label(first), y=0.78 / height, fontsize=11, va="bottom")
    figure.supylabel(_label(second), x=0.12 / style.WIDTH, fontsize=11)
    bar = figure.colorbar(image, cax=style.bar(figure, left, 0.5, style.WIDTH - left - 0.35, 0.15), orientation="horizontal")
    bar.ax.xaxis.set_major_formatter(style.percent_ticks())
    style.steps(bar.ax.xaxis)
    return figure


def _cross(panel: Axes, x: np.ndarray, y: np.ndarray) -> None:
    # Red above white, to be seen on any colour.
    for colour, width, size in (("white", 5, 11), (style.RED, 2.5, 9)):
        panel.plot(x, y, "x", color=colour, markersize=size, markeredgewidth=width, clip_on=False, zorder=5)


def _grid(data: ReportData, per_set: np.ndarray) -> np.ndarray:
    shape = tuple(nodes.size for nodes in data.grid)
    values = per_set[: int(np.prod(shape))].reshape(shape)
    return np.asarray(values.max(axis=tuple(range(2, len(shape)))) if len(shape) > 2 else values)


def _lines(data: ReportData, found: list[tuple[Entry, np.ndarray]]) -> Figure:
    under = 0.23 * len(found)
    figure, placed = style.panels(style.WIDTH, 3.6 + under, left=1.1, top=0.15, bottom=0.75 + under)
    axes = placed[0, 0]
    for i, (entry, per_set) in enumerate(found):
        values = per_set[: data.grid[0].size]
        axes.semilogy(_shown(data.axes[0], data.grid[0]), values, label=entry.name, **style.look(i, fewer=True))
    axes.set_xlabel(_label(data.axes[0]))
    axes.set_ylabel("E_mean")
    axes.yaxis.set_major_formatter(style.percent_ticks())
    style.decades(axes.yaxis)
    axes.grid(True, alpha=0.3)
    figure.legend(*axes.get_legend_handles_labels(), loc="lower center", fontsize=11, frameon=False)
    return figure


def _shown(axis: Axis, values: np.ndarray) -> np.ndarray:
    return np.degrees(values) if axis.unit == "rad" else values


def _label(axis: Axis) -> str:
    unit = {"rad": " (degrees)", "1": ""}.get(axis.unit, f" ({axis.unit})")
    return axis.name.replace("_", " ") + unit


PICTURE = Picture("Where the error is", CAPTION, draw, see=SEE)
