"""Error against bytes: the sweep's rectangles and the winners."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from skylight_sh.report import style
from skylight_sh.report.choice import same_as
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData
from skylight_sh.runtime import Table
from skylight_sh.table import table as tables
from skylight_sh.table.row_layout import stored
from skylight_sh.table.selection import pareto_front
from skylight_sh.table.size import bytes_of

Array = NDArray[np.float64]

SEE = "Below and left is better: steps are the best that is known for so many bytes, large marks what is shipped."
CAPTION = (
    "Largest E_mean against size, every constant of an evaluation counted. Large marks: the winners as shipped and "
    "measured, laid out for speed (filled) or packed (open). Small dots: every combination of degrees with all its "
    "coefficients, laid out for speed, in double precision. Steps: the front of all of these and of what the search "
    "tried on its way; a try's error is that on the sets that selection sees, before its numbers are rounded to the "
    "table's type, so that a winner may stand a little above its step. Black marks: other fits, in the recommended "
    "table's bands."
)
# Habel et al. 2008, section 3.3: 49 weights of 14 x 8 coefficients in double precision, "below 1.5 %".
_QUOTED = (131_712, 0.015)
_LAYOUTS = {"rows": "for speed", "packed": "packed"}


def draw(data: ReportData) -> Figure:
    """Draw one colour a number of bands."""
    twins = same_as(data.winners)
    winners = [entry for entry in data.winners if entry.name not in twins]
    groups = sorted({entry.table.bands for entry in winners}, reverse=True)
    figure = style.figure(style.WIDTH, 5.4 + 0.12 * (2 * len(groups) + len(data.references)))
    axes = figure.subplots()
    for i, bands in enumerate(groups):
        for layout, told in _LAYOUTS.items():
            mine = [e for e in winners if e.table.bands == bands and e.table.body.kind == layout]
            shipped = np.array([(bytes_of(e.table), e.headline[0]) for e in mine]).reshape(-1, 2)
            swept = _swept(data, bands) if layout == "rows" and mine else np.zeros((0, 2))
            if len(swept):
                axes.loglog(*swept.T, ".", color=style.SERIES[i], alpha=0.3, markersize=3)
            tried = data.fronts.get((bands, layout), np.zeros((0, 2)))
            front = np.array(pareto_front([(a, b) for a, b in np.concatenate([tried, swept, shipped]).tolist()]))
            if len(front) > 1:
                axes.loglog(
                    *front.T,
                    color=style.SERIES[i],
                    linestyle="-" if layout == "rows" else "--",
                    linewidth=1,
                    drawstyle="steps-post",
                )
            if mine:
                look = {"color": style.SERIES[i], "fillstyle": "full" if layout == "rows" else "none", "markersize": 9}
                edge = "black" if layout == "rows" else style.SERIES[i]
                axes.loglog(*shipped.T, style.MARKERS[i], markeredgecolor=edge, label=f"{bands} bands, {told}", **look)
    best = data.best
    bands = best.table.bands
    for i, entry in enumerate(data.references):
        place = (bytes_of(entry.table, bands), entry.headline_at(bands)[0])
        axes.loglog(*place, "xP*"[i % 3], color="black", markersize=9, label=entry.name)
    if data.references:
        axes.loglog(*_QUOTED, "X", color=style.RED, markeredgecolor="black", markersize=9, label="quoted by the paper")
    place = (bytes_of(best.table), best.headline[0])
    look = {"marker": "o", "markersize": 17, "fillstyle": "none", "color": style.BLACK, "linestyle": ""}
    axes.loglog(*place, label="recommended", **look)
    axes.set_xlabel("bytes")
    axes.set_ylabel("largest E_mean")
    # A fit that is exact but for rounding lies far below all that is shipped.
    axes.set_ylim(bottom=max(axes.get_ylim()[0], min(e.headline[0] for e in winners) / 30))
    axes.xaxis.set_major_formatter(style.plain_ticks())
    axes.yaxis.set_major_formatter(style.percent_ticks())
    style.steps(axes.yaxis)
    style.steps(axes.xaxis)
    axes.grid(True, which="major", alpha=0.3)
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=2, fontsize=11, frameon=False)
    return figure


def _swept(data: ReportData, bands: int) -> Array:
    """Return bytes and E_mean of every combination of degrees with all its coefficients, ``(combinations, 2)``."""
    error = data.sweep.e_mean[0, :, :, bands - 1].max(axis=1)
    like = next(e.table for e in data.winners if e.table.bands == bands and e.table.body.kind == "rows")
    size = [whole_bytes(like, [int(d) for d in degrees]) for degrees in data.sweep.degrees]
    return np.stack([np.array(size, dtype=np.float64), error], axis=1)


def whole_bytes(like: Table, degrees: list[int]) -> int:
    """Return the bytes of a table of all coefficients of ``degrees``, laid out for speed, otherwise as ``like`` is."""
    shape = (like.spec.classes, stored(like.spec, like.bands).count, *(degree + 1 for degree in degrees))
    return bytes_of(tables.whole(like.spec, np.zeros(shape), like.bands, str(like.dtype), like.surroundings))


PICTURE = Picture("Error against bytes", CAPTION, draw, see=SEE)
