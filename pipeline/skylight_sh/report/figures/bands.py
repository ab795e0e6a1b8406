"""Largest E_mean and E_max against the number of bands (the paper's figure 3)."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from skylight_sh.report import style
from skylight_sh.report.choice import same_as
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData
from skylight_sh.table.size import bytes_of

SEE = (
    "A curve that stays flat errs alike in all bands: take as few of a table's bands as the picture needs, its error stays."
)
CAPTION = (
    "The paper's figure 3: the largest errors over all parameter sets and channels, in per cent of the least radiance of "
    "each set (for irradiance: of an even sky's that has it), against the number of bands. Tables are measured as shipped, "
    "in their own number type. Crosses, for the paper's sky: the two bounds on E_mean that it quotes (1.5 % at 7 bands, "
    "0.005 % up to 5), against its own samples. Bytes are those of the recommended table's bands. A reference by the normal "
    "equations (paper-normal) is what rounding leaves of its system: that curve is this machine's, and another CPU's may "
    "differ by most of itself."
)
# Habel et al. 2008, section 3.2.
_QUOTED = ((7, 0.015), (5, 0.00005))


def draw(data: ReportData) -> Figure:
    """Draw E_mean above E_max, one line a table."""
    best, twins = data.best.table.bands, same_as(data.winners)
    shown = [entry for entry in data.winners if entry.table.bands == best and entry.name not in twins]
    shown += data.references
    quoted = ("preetham" in str(data.settings["light"]["model"]) and data.references) or data.name == "paper"
    lines = 0.235 * (len(shown) + bool(quoted))
    figure, found = style.panels(style.WIDTH, 6.3 + lines, 2, bottom=0.85 + lines, left=1.05, gap=(0.0, 0.5), sharex=True)
    above, below = found[:, 0]
    for axes, attribute, title in ((above, "e_mean", "E_mean"), (below, "e_max", "E_max")):
        for i, entry in enumerate(shown):
            errors = getattr(entry, attribute)[0].max(axis=0)
            size = f"{bytes_of(entry.table, min(best, entry.table.bands)):,} bytes"
            told = f"{entry.name} (reference): {size}" if entry in data.references else f"{entry.name}: {size}"
            axes.semilogy(np.arange(1, errors.size + 1), errors, label=told, **style.look(i))
        axes.set_title(f"largest {title}, of the {_words(data)}", fontsize=11)
        axes.yaxis.set_major_formatter(style.percent_ticks())
        style.decades(axes.yaxis)
        axes.grid(True, which="major", alpha=0.3)
    if quoted:
        look = {"color": "black", "markersize": 10, "markeredgewidth": 2, "label": "quoted by the paper"}
        above.plot(*zip(*_QUOTED, strict=True), "x", **look)
    below.set_xlabel("bands N")
    figure.legend(*above.get_legend_handles_labels(), loc="lower center", fontsize=11, frameon=False)
    return figure


def _words(data: ReportData) -> str:
    least = "mean" if data.conventions[0] == "mean" else "least"
    return f"{least} light" if data.best.table.spec.quantity == "irradiance" else f"{least} luminance"


PICTURE = Picture("Largest errors against bands", CAPTION, draw, see=SEE)
