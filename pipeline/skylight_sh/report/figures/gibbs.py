"""Negative light and lost peaks: each window and each ground, for 3 to 10 bands, over the whole domain."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import SymLogNorm
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from skylight_sh.report import panorama, ringing, style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData
from skylight_sh.report.ringing import ALBEDO, GROUNDS, LEAST, Ringing, Study, tried

Array = NDArray[np.float64]

_TICKS = (-1.0, -0.1, 0.0, 0.1, 1.0)
_SHOWN = ("no window", "zonal sinc (eq. 5)", LEAST)
# The same, and the grounds, in few letters.
_HEADS = ("no window", "zonal sinc", "least window")
_SHORT = ("black", f"albedo {ALBEDO:g}", "mirrored")
SEE = "A window is good where undershoot is gone and the brightest value still is the sky's: look for both in one curve."
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
    names = study.found.windows
    legend = 0.235 * (len(names) + 1)
    curves, pictures = 4 * 1.75 + 0.35, 0.55 + len(GROUNDS) * 1.5
    height = legend + curves + pictures + 1.2
    figure, placed = style.panels(style.WIDTH, height, left=0.0, right=0.0, bottom=0.0, top=0.0)
    figure.delaxes(placed[0, 0])
    first = _curves(figure, study.found, height - legend)
    heading = f"{len(study.sets)} sets of parameters"
    figure.legend(
        *first.get_legend_handles_labels(), loc="upper left", fontsize=11, frameon=False, title=heading, alignment="left"
    )
    bands = study.found.bands
    _panoramas(figure, study, min(max(data.best.table.bands, bands[0]), bands[-1]), pictures + 0.75)
    return figure


# Inches: what stands left of the panels, and their width and gap.
_LEFT, _ACROSS, _GAP = 0.72, 1.33, 0.08


def _curves(figure: Figure, found: Ringing, top: float) -> Axes:
    """Draw a row a measure and a column a ground below ``top``, in inches; return the first panel."""
    measures = (
        (found.undershoot, "largest undershoot, of the sky's own brightest"),
        (found.area, "largest negative part of the sphere"),
        (found.overshoot, "largest overshoot, of the sky's own brightest"),
        (found.peak, "brightest value against the sky's own"),
    )
    first: Axes | None = None
    for k, (values, label) in enumerate(measures):
        bottom = top - (k + 1) * 1.75 + 0.12
        ends = min(0.0, float(values.min())), max(0.0, float(values.max()))
        room = 0.05 * (ends[1] - ends[0])
        for g in range(len(GROUNDS)):
            panel = style.bar(figure, _LEFT + g * (_ACROSS + _GAP), bottom, _ACROSS, 1.2)
            first = first or panel
            for w, window in enumerate(found.windows):
                panel.plot(found.bands, values[g, w], label=window, **{**style.look(w), "markersize": 4})
            panel.axhline(0.0, color="grey", linewidth=0.6)
            panel.set_ylim(ends[0] - room, ends[1] + room)
            panel.yaxis.set_major_locator(MaxNLocator(4))
            panel.yaxis.set_major_formatter(style.percent_ticks())
            panel.set_xticks([4, 7, 10])
            panel.tick_params(labelleft=g == 0, labelbottom=k == len(measures) - 1)
            if k == len(measures) - 1:
                panel.set_xlabel(f"bands,\n{_SHORT[g]}")
        height = float(figure.get_size_inches()[1])
        figure.text(0.1 / style.WIDTH, (bottom + 1.25) / height, label, fontsize=11, va="bottom")
    if first is None:
        raise ValueError("There is nothing to draw.")
    return first


def _panoramas(figure: Figure, study: Study, bands: int, top: float) -> None:
    """Draw a row a ground and a column a window below ``top``, in inches, and the scale at the figure's foot."""
    height = float(figure.get_size_inches()[1])
    scale = SymLogNorm(0.03, vmin=-1.0, vmax=1.0)
    found = study.found
    b, cut = found.bands.index(bands), bands * bands
    figure.text(0.1 / style.WIDTH, top / height, f"{bands} bands; lowest value of each", fontsize=11, va="top")
    for g, light in enumerate(GROUNDS.values()):
        lit = light.weights(study.weights[:, :cut], bands)
        factors = tried(found, g, b)
        bottom = top - 0.55 - (g + 1) * 1.5 + 0.25
        for w, window in enumerate(_SHOWN):
            at = int(found.worst[g, found.windows.index(window), b])
            picture = panorama.expansion((lit[at] * factors[window])[np.newaxis])[..., 0] / study.brightest[at]
            panel = style.bar(figure, 0.35 + w * (1.47 + _GAP), bottom, 1.47, 0.98)
            image = panel.imshow(
                picture, extent=panorama.EXTENT, aspect="auto", cmap="PuOr_r", norm=scale, interpolation="nearest"
            )
            low = style.percent(min(float(f"{picture.min():.2g}"), 0.0))
            panel.set_title(f"{_HEADS[w]}\n{low}" if g == 0 else low, fontsize=11, pad=3)
            panel.set_xticks([])
            panel.set_yticks([])
            if w == 0:
                panel.set_ylabel(_SHORT[g], fontsize=11)
    cax = style.bar(figure, 0.5, 0.55, style.WIDTH - 1.0, 0.15)
    label = "share of the sky's own brightest"
    figure.colorbar(image, cax=cax, orientation="horizontal", label=label, ticks=_TICKS, format=style.percent_ticks())


def files(data: ReportData) -> dict[str, bytes]:
    """Return the numbers behind the picture."""
    study = data.ringing
    return {"ringing.csv": ringing.csv(study, [axis.name for axis in data.axes])} if study else {}


PICTURE = Picture("Ringing: every window, every ground", CAPTION, draw, files, SEE)
