"""Negative light and lost peaks: each window and each ground, for 3 to 10 bands, over the whole domain."""

from __future__ import annotations

import numpy as np
from matplotlib.colors import SymLogNorm
from matplotlib.figure import Figure, SubFigure
from numpy.typing import NDArray

from skylight_sh.report import panorama, ringing, style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData
from skylight_sh.report.ringing import GROUNDS, LEAST, Ringing, Study, tried

Array = NDArray[np.float64]

_TICKS = (-1.0, -0.3, -0.1, -0.03, 0.0, 0.03, 0.1, 0.3, 1.0)
_SHOWN = ("no window", "zonal sinc (eq. 5)", LEAST)
CAPTION = (
    "True luminance expansions cut to so many bands, at evenly spaced sets of parameters, edges included. All values are "
    "shares of the same sky's own brightest value. First row: the most negative value of any set and direction; second: "
    "the largest part of the sphere that is negative; third: the largest excess over the scene itself; fourth: by how much "
    "the brightest value differs from the sky's own, mean over sets (a smooth expansion cannot hold the sun's halo). The "
    "least windows leave no set negative: in radiance, or in irradiance. Below: three of the windows, each at its own "
    "worst set, in the bands of the recommended table; negative light is purple; the scale is logarithmic beyond 3 %. All "
    "numbers: ringing.csv."
)


def draw(data: ReportData) -> Figure | None:
    """Draw the study; None where there is none."""
    study = data.ringing
    if study is None:
        return None
    figure = style.figure(12, 15.5)
    # So many panels take a second to be laid out by constraint.
    figure.set_layout_engine("none")
    grid = figure.add_gridspec(2, 1, height_ratios=(2, 1))
    above, below = figure.add_subfigure(grid[0]), figure.add_subfigure(grid[1])
    _curves(above, study.found)
    figure.text(0.01, 0.995, f"{len(study.sets)} sets of parameters", fontsize=8, va="top")
    bands = study.found.bands
    shown = min(max(data.best.table.bands, bands[0]), bands[-1])
    below.suptitle(f"{shown} bands", fontsize=10)
    _panoramas(below, study, data, shown)
    return figure


def _curves(figure: SubFigure, found: Ringing) -> None:
    room = {"left": 0.085, "right": 0.99, "top": 0.965, "bottom": 0.05, "wspace": 0.04, "hspace": 0.06}
    measures = (
        (found.undershoot, "largest undershoot (of the\nsky's own brightest value)"),
        (found.area, "largest negative part\nof the sphere"),
        (found.overshoot, "largest overshoot (of the\nsky's own brightest value)"),
        (found.peak, "brightest value\nagainst the sky's"),
    )
    panels = figure.subplots(len(measures), len(GROUNDS), sharex=True, sharey="row", gridspec_kw=room)
    for k, (line, (values, label)) in enumerate(zip(panels, measures, strict=True)):
        for g, (panel, ground) in enumerate(zip(line, GROUNDS, strict=True)):
            for w, window in enumerate(found.windows):
                look = {"color": style.SERIES[w], "marker": style.MARKERS[w], "markersize": 4}
                panel.plot(found.bands, values[g, w], label=window, **look)
            panel.axhline(0.0, color="grey", linewidth=0.6)
            panel.yaxis.set_major_formatter(style.percent_ticks())
            if k == 0:
                panel.set_title(ground, fontsize=10)
            if k == len(measures) - 1:
                panel.set_xlabel("bands")
        line[0].set_ylabel(label)
    panels[0, -1].legend(fontsize=8)


def _panoramas(figure: SubFigure, study: Study, data: ReportData, bands: int) -> None:
    room = {"left": 0.06, "right": 0.88, "top": 0.88, "bottom": 0.1, "wspace": 0.06, "hspace": 0.32}
    panels = figure.subplots(len(GROUNDS), 3, sharex=True, sharey=True, gridspec_kw=room)
    scale = SymLogNorm(0.03, vmin=-1.0, vmax=1.0)
    found = study.found
    b, cut = found.bands.index(bands), bands * bands
    for g, (line, (ground, light)) in enumerate(zip(panels, GROUNDS.items(), strict=True)):
        lit = light.weights(study.weights[:, :cut], bands)
        factors = tried(found, g, b)
        for panel, window in zip(line, _SHOWN, strict=True):
            at = int(found.worst[g, found.windows.index(window), b])
            picture = panorama.expansion((lit[at] * factors[window])[np.newaxis])[..., 0] / study.brightest[at]
            image = panel.imshow(picture, extent=panorama.EXTENT, aspect="auto", cmap="PuOr_r", norm=scale)
            low = 100 * min(float(picture.min()), 0.0)
            place = data.describe(study.sets[at])
            panel.set_title(f"{ground}, {window}: lowest {low:.1f} %\n{place}", fontsize=7, parse_math=False)
        line[0].set_ylabel("altitude (°)")
    for panel in panels[-1]:
        panel.set_xlabel("azimuth from the sun (degrees)")
    figure.colorbar(
        image,
        cax=figure.add_axes((0.9, 0.1, 0.015, 0.78)),
        label="share of the sky's own brightest value",
        ticks=_TICKS,
        format=style.percent_ticks(),
    )


def files(data: ReportData) -> dict[str, bytes]:
    """Return the numbers behind the picture."""
    study = data.ringing
    return {"ringing.csv": ringing.csv(study, [axis.name for axis in data.axes])} if study else {}


PICTURE = Picture("Ringing: every window, every ground", CAPTION, draw, files)
