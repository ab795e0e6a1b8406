"""What the tables promise, beside what light on surfaces really loses by them and by their bands."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter
from numpy.typing import NDArray

from skylight_sh.report import style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData

Array = NDArray[np.float64]

_WIDTH = 8.0
PROMISED, ALSO, LOST, PICTURE_LOST, BANDS = (
    "promised: E_mean",
    "E_max",
    "irradiance",
    "picture",
    "irradiance, bands",
)
SEE = "A circle left of its bar loses less light on surfaces than is promised; squares are what the number of bands costs."
CAPTION = (
    "What is promised and what is lost, largest values over sets that neither fit nor selection saw. E_mean and E_max "
    "(the paper's eqs. 3 and 2) are errors of all weights over the least luminance of the same sky. Irradiance is what a "
    "surface receives: the error of its luminance over its own, the worst of all normals that do not face down. No "
    "surface can lose more than 0.92 times E_mean, by the clamped cosine alone; it loses far less. Triangles: the "
    "relative RMSE of a picture of the courtyard, lit by the table and by true weights of as many bands. Squares: what a "
    "table's number of bands loses against the whole light, which no better table mends."
)


def draw(data: ReportData) -> Figure | None:
    """Draw a line a table; None where the run did not measure it."""
    if data.lighting is None:
        return None
    found = data.lighting
    columns = {
        PROMISED: [entry.headline[0] for entry in data.winners],
        ALSO: [entry.headline[1] for entry in data.winners],
        LOST: [float(found[f"tables/{entry.name}/table/local"].max()) for entry in data.winners],
        PICTURE_LOST: [float(found[f"tables/{entry.name}/picture"].max()) for entry in data.winners],
        BANDS: [float(found[f"tables/{entry.name}/bands/local"].max()) for entry in data.winners],
    }
    return lines([entry.name for entry in data.winners], columns)


def lines(names: Sequence[str], columns: Mapping[str, Sequence[float]]) -> Figure:
    """Draw a line for each of ``names`` with a mark a column, on a logarithmic scale in per cent."""
    figure = style.figure(_WIDTH, 1.9 + 0.42 * len(names))
    panel, size = figure.subplots(), style.legible(_WIDTH)
    looks = zip(columns.items(), (style.BLACK, "grey", style.BLUE, style.GREEN, style.RED), "|od^s", strict=False)
    for (label, values), color, marker in looks:
        long, wide = (16, 3) if marker == "|" else (9, 1)
        panel.plot(
            values,
            range(len(names)),
            color=color,
            linestyle="",
            label=label,
            marker=marker,
            markersize=long,
            markeredgewidth=wide,
        )
    panel.set_xscale("log")
    panel.xaxis.set_major_formatter(FuncFormatter(lambda value, _: style.percent(float(value)).removesuffix(" %")))
    panel.set_xlabel("per cent", fontsize=size)
    panel.set_yticks(range(len(names)), names)
    panel.set_ylim(len(names) - 0.5, -0.5)
    panel.tick_params(labelsize=size)
    panel.grid(axis="both", color="#dddddd")
    panel.set_axisbelow(True)
    figure.legend(loc="outside lower center", ncols=2, fontsize=size, frameon=False, handletextpad=0.2)
    return figure


PICTURE = Picture("What is promised, and what is lost", CAPTION, draw, see=SEE)
