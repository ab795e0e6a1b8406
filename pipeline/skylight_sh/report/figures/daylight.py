"""A clear day in lux: sky, sun and both on the horizontal, beside what was published."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from skylight_sh.report import style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData
from skylight_sh.scene import clear_day
from skylight_sh.table import twilight

SEE = "Where a coloured curve stands above the dotted one, the model is brighter than what was measured."
CAPTION = (
    "Illuminance on the horizontal over the sun's height, at the least, a middle and the largest turbidity: the Preetham "
    "sky (published constants), its sun's disc behind the air of the same turbidity, and both. Dotted: IES RP-21 (1984) "
    f"for a clear day, a regression over measurements; dashed: the sun's {clear_day.SOLAR / 1000:g} klx above the "
    "atmosphere, which no clear day can exceed. The sky alone is about twice as bright as published, its sun dimmer: with "
    "a high sun the two errors cancel in the sum, near the horizon they do not. With twilight: the light on the horizontal "
    "as the sun sinks, beside measurements without a moon (dotted, Seidelmann 1992)."
)


def draw(data: ReportData) -> Figure | None:
    """Draw three panels; None for a light that is not the Preetham sky."""
    if data.settings["light"]["model"] != "preetham":
        return None
    fixed = data.settings["scene"]["fixed"]
    low, high = next(
        ((axis.low, axis.high) for axis in data.axes if axis.name == "turbidity"), (fixed.get("turbidity"),) * 2
    )
    theta = np.radians(np.linspace(0.0, 90.0, 46))
    height = 90.0 - np.degrees(theta)
    sinks = data.best.table.spec.twilight
    figure = style.figure(style.WIDTH, 6.6)
    placed = figure.subplot_mosaic([["sky", "sun"], ["both", "twilight" if sinks else "both"]])
    wanted = sorted({low, (low + high) / 2, high})
    found = {tau: clear_day.clear_day(theta, tau) for tau in wanted}
    published = clear_day.published(theta)
    parts = {"sky": (0,), "sun": (1,), "both": (0, 1)}
    for key, title in (("sky", "sky"), ("sun", "sun"), ("both", "sky and sun")):
        panel = placed[key]
        for i, tau in enumerate(wanted):
            shown = sum(found[tau][part] for part in parts[key]) / 1000
            panel.plot(height, shown, label=f"turbidity {tau:g}", **style.look(i, fewer=True))
        measured = sum(published[part] for part in parts[key]) / 1000
        panel.plot(height, measured, color=style.BLACK, linestyle=":", label="IES RP-21 (dotted)")
        panel.set_title(f"{title} (klx)", fontsize=11)
        panel.set_xlabel("sun's height (°)")
        panel.set_xticks([0, 45, 90])
    placed["both"].plot(
        height, clear_day.SOLAR / 1000 * np.cos(theta), color="grey", linestyle="--", label="sun above the air"
    )
    top = max(placed[key].get_ylim()[1] for key in parts)
    for key in parts:
        placed[key].set_ylim(0.0, top)
    if sinks:
        _fade(placed["twilight"], {tau: float(lit[0][height == 0.0][0]) for tau, lit in found.items()})
    figure.legend(
        *placed["both"].get_legend_handles_labels(), loc="outside lower center", ncols=2, fontsize=11, frameon=False
    )
    return figure


def faded(lux: float, depth: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the light on the horizontal, ``lux`` at sunset, with the sun ``depth`` radians below the horizon.

    >>> faded(1000.0, np.radians([0.0, 6.0, 12.0])).round(1).tolist()
    [1000.0, 5.9, 0.0]
    """
    return np.asarray(lux * twilight.fade(np.minimum(depth / twilight.DEPTH, 1.0)))


def _fade(panel: Axes, sunset: dict[float, float]) -> None:
    """Draw lux against the sun's depth, from those at sunset for each turbidity."""
    depth = np.radians(np.linspace(0.0, 12.0, 121))
    for i, lux in enumerate(sunset.values()):
        look = {**style.look(i), "markevery": 20}
        panel.semilogy(np.degrees(depth), faded(lux, depth), **look)
    panel.semilogy(np.degrees(depth), clear_day.twilight(depth), color=style.BLACK, linestyle=":")
    panel.set_ylim(1e-3, 3e4)
    panel.set_title("twilight (lx)", fontsize=11)
    panel.set_xlabel("sun's depth (°)")
    panel.set_xticks([0, 6, 12])
    panel.yaxis.set_major_formatter(style.plain_ticks())
    panel.set_yticks([1e-3, 1e-1, 1e1, 1e3])
    style.decades(panel.yaxis)


PICTURE = Picture("A clear day in lux", CAPTION, draw, see=SEE)
