"""Largest E_mean and E_max against the number of bands (the paper's figure 3)."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from skylight_sh.report import style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData
from skylight_sh.table.size import bytes_of

CAPTION = (
    "The paper's figure 3: the largest errors over all parameter sets and channels, in per cent of the least radiance of "
    "each set, against the number of bands. Tables are measured as shipped, in their own number type. Crosses, for the "
    "paper's sky: the two bounds on E_mean that it quotes (1.5 % at 7 bands, 0.005 % up to 5), against its own samples. "
    "Bytes are those of the recommended table's bands. A reference by the normal equations (paper-normal) is what rounding "
    "leaves of its system: that curve is this machine's, and another CPU's may differ by most of itself."
)
# Habel et al. 2008, section 3.2.
_QUOTED = ((7, 0.015), (5, 0.00005))


def draw(data: ReportData) -> Figure:
    """Draw E_mean beside E_max, one line a table."""
    rows = -(-(len(data.winners) + len(data.references) + 1) // 4)
    figure, found = style.panels(11.5, 5.4, columns=2, left=1.05, bottom=0.65 + 0.16 * rows, gap=(0.15, 0.0), sharey=True)
    left, right = found[0]
    entries = [*data.winners, *data.references]
    shown = [e for e in entries if e in data.references or e.table.bands == data.best.table.bands]
    best = data.best.table.bands
    for axes, attribute, title in ((left, "e_mean", "E_mean"), (right, "e_max", "E_max")):
        for i, entry in enumerate(shown):
            errors = getattr(entry, attribute)[0].max(axis=0)
            count = np.arange(1, errors.size + 1)
            dashed = entry in data.references
            axes.semilogy(
                count,
                errors,
                color=style.SERIES[i % 7],
                marker=style.MARKERS[i % 7],
                markersize=5,
                linestyle="--" if dashed else "-",
                label=f"{entry.name}: {bytes_of(entry.table, min(best, entry.table.bands)):,} B",
            )
        axes.set_title(f"largest {title}, L_min {data.conventions[0]}")
        axes.set_xlabel("bands N")
        axes.yaxis.set_major_formatter(style.percent_ticks())
        style.decades(axes.yaxis)
        axes.grid(True, which="major", alpha=0.3)
    if ("preetham" in str(data.settings["light"]["model"]) and data.references) or data.name == "paper":
        left.plot(
            *zip(*_QUOTED, strict=True), "x", color="black", markersize=10, markeredgewidth=2, label="quoted by the paper"
        )
    left.set_ylabel("error relative to L_min")
    figure.legend(*left.get_legend_handles_labels(), loc="lower center", ncols=4, fontsize=8)
    return figure


PICTURE = Picture("Largest errors against bands", CAPTION, draw)
