"""Where a picture's error comes from: one bar a source and sun."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter
from numpy.typing import NDArray

from skylight_sh.report import style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData

Array = NDArray[np.float64]

_WIDTH = 8.0
SEE = "The longest bars are what to improve first; each grid line to the right is ten times the error."
CAPTION = (
    "Where the error of a lit picture comes from: relative RMSE of linear light over all that is seen of the courtyard, "
    "for suns of three heights, on a logarithmic scale. The tables: weights from the recommended and from the smallest "
    "one against true ones. Sampling: transfer by two halves of its rays. Vertices: transfer at vertices, interpolated, "
    "against transfer at every pixel. Bands: transfer at every pixel against brute force. All: the picture as it is, "
    "against brute force; and the same without its bounces, and without its shadows."
)


def draw(data: ReportData) -> Figure | None:
    """Draw the bars; None where the run made no pictures of scenes."""
    found = data.pictures.get("courtyard")
    if found is None:
        return None
    names = [str(name) for name in found["sources/source"]]
    suns = [f"sun {height:g}°" for height in found["sources/height"]]
    return bars(names, dict(zip(suns, found["sources/error"].T, strict=True)))


def bars(names: Sequence[str], errors: Mapping[str, Array]) -> Figure:
    """Draw a group of bars for each of ``names``, a bar for each series of ``errors`` ``(names,)``, its number beside it."""
    size, each = style.legible(_WIDTH), 0.8 / len(errors)
    figure = style.figure(_WIDTH, 1.5 + 0.26 * (len(errors) + 1) * len(names))
    panel = figure.subplots()
    values = np.array(list(errors.values()))
    start = 10.0 ** np.floor(np.log10(values[values > 0.0].min()) - 0.2)
    for place, (label, series) in enumerate(errors.items()):
        at = np.arange(len(names)) + (place - 0.5 * (len(errors) - 1)) * each
        panel.barh(at, series - start, height=each, left=start, color=style.SERIES[place], label=label)
        for y, value in zip(at, series, strict=True):
            told = style.percent(float(f"{value:.2g}")).removesuffix(" %")
            panel.text(max(value, start) * 1.15, y, told, va="center", fontsize=size)
    panel.set_xscale("log")
    # Room for the numbers beside the longest bars.
    panel.set_xlim(start, values.max() * 12.0)
    panel.xaxis.set_major_locator(FixedLocator([10.0**k for k in range(round(np.log10(start)), 1)]))
    panel.xaxis.set_major_formatter(FuncFormatter(lambda value, _: style.percent(float(value)).removesuffix(" %")))
    panel.set_xlabel("relative RMSE, per cent", fontsize=size)
    panel.set_yticks(range(len(names)), names)
    panel.set_ylim(len(names) - 0.5, -0.5)
    panel.tick_params(labelsize=size)
    panel.grid(axis="x", color="#dddddd")
    panel.set_axisbelow(True)
    figure.legend(
        loc="outside upper center", ncols=len(errors), fontsize=size, frameon=False, handlelength=0.8, columnspacing=1.0
    )
    return figure


PICTURE = Picture("Where a picture's error comes from", CAPTION, draw, see=SEE)
