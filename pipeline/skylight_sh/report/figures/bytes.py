"""Error against bytes: the sweep's rectangles and the winners."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from skylight_sh.report import style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData
from skylight_sh.table.size import bytes_of

CAPTION = (
    "Largest E_mean against size. Dots: every combination of degrees of the sweep with all its coefficients kept, as "
    "four-byte numbers. Large marks: the winners as shipped, every constant counted, laid out for speed (rows) or "
    "packed; lines: the Pareto front of all tables that the selection tried; black marks: other fits, for the bands "
    "of the recommended table. Below and left is better."
)
# Habel et al. 2008, section 3.3: 49 weights of 14 x 8 coefficients in double precision, "below 1.5 %".
_QUOTED = (131_712, 0.015)


def draw(data: ReportData) -> Figure:
    """Draw one colour a number of bands."""
    figure, found = style.panels(10.5, 5, left=1.05, right=2.1, top=0.15)
    axes = found[0, 0]
    for i, bands in enumerate(sorted({entry.table.bands for entry in data.winners}, reverse=True)):
        outputs = data.harmonics.first(bands).count * len(data.light.channels)
        size = 4 * outputs * np.prod(data.sweep.degrees + 1, axis=1)
        error = data.sweep.e_mean[0, :, :, bands - 1].max(axis=1)
        axes.loglog(size, error, ".", color=style.SERIES[i], alpha=0.35, label=f"sweep, {bands} bands")
        for layout, fill in (("rows", "full"), ("packed", "none")):
            front = data.fronts.get((bands, layout))
            if front is not None:
                axes.loglog(*front.T, color=style.SERIES[i], linestyle="-" if layout == "rows" else "--", linewidth=1)
            winners = [e for e in data.winners if e.table.bands == bands and e.table.body.kind == layout]
            axes.loglog(
                [bytes_of(entry.table) for entry in winners],
                [entry.headline[0] for entry in winners],
                style.MARKERS[i],
                color=style.SERIES[i],
                fillstyle=fill,
                markeredgecolor="black" if fill == "full" else style.SERIES[i],
                markersize=9,
                label=f"{layout}, {bands} bands",
            )
    best = data.best
    bands = best.table.bands
    for i, entry in enumerate(data.references):
        axes.loglog(
            bytes_of(entry.table, bands),
            entry.headline_at(bands)[0],
            "xP*"[i % 3],
            color="black",
            markersize=9,
            label=entry.name,
        )
    if data.references:
        axes.loglog(*_QUOTED, "X", color=style.RED, markeredgecolor="black", markersize=9, label="quoted by the paper")
    axes.annotate(
        "recommended",
        (bytes_of(best.table), best.headline[0]),
        xytext=(-12, -28),
        textcoords="offset points",
        ha="right",
        arrowprops={"arrowstyle": "->"},
    )
    axes.set_xlabel("bytes")
    axes.set_ylabel(f"largest E_mean, L_min {data.conventions[0]}")
    axes.yaxis.set_major_formatter(style.percent_ticks())
    style.decades(axes.yaxis)
    axes.grid(True, which="major", alpha=0.3)
    figure.legend(*axes.get_legend_handles_labels(), loc="upper right", fontsize=8)
    return figure


PICTURE = Picture("Error against bytes", CAPTION, draw)
