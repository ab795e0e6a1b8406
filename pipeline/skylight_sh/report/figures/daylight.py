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

CAPTION = (
    "Illuminance on the horizontal over the sun's height, at the least, a middle and the largest turbidity: the Preetham "
    "sky (published constants), its sun's disc behind the air of the same turbidity, and both. Dotted: IES RP-21 (1984) "
    f"for a clear day, a regression over measurements; dashed: the sun's {clear_day.SOLAR / 1000:g} klx above the "
    "atmosphere, which no clear day can exceed. The sky alone is about twice as bright as published, its sun dimmer: with "
    "a high sun the two errors cancel in the sum, near the horizon they do not. With twilight: the light on the horizontal "
    "as the sun sinks, beside measurements without a moon (Seidelmann 1992)."
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
    figure, placed = style.panels(16 if sinks else 12, 4.2, columns=4 if sinks else 3, gap=(0.65, 0.0))
    panels = placed[0]
    wanted = sorted({low, (low + high) / 2, high})
    found = {tau: clear_day.clear_day(theta, tau) for tau in wanted}
    published = clear_day.published(theta)
    for panel, title, parts in zip(panels, ("sky", "sun", "sky and sun"), ((0,), (1,), (0, 1)), strict=False):
        for tau, color, marker in zip(wanted, style.SERIES, style.MARKERS, strict=False):
            look = {"color": color, "marker": marker, "markevery": 9, "markersize": 5}
            panel.plot(height, sum(found[tau][i] for i in parts) / 1000, label=f"turbidity {tau:g}", **look)
        panel.plot(height, sum(published[i] for i in parts) / 1000, color=style.BLACK, linestyle=":", label="IES RP-21")
        panel.set_title(title, fontsize=10)
        panel.set_xlabel("sun's height (degrees)")
    panels[0].set_ylabel("illuminance (klx)")
    panels[0].legend(fontsize=8)
    top = max(panel.get_ylim()[1] for panel in panels[:3])
    for panel in panels[:3]:
        panel.set_ylim(0.0, top)
    panels[2].plot(height, clear_day.SOLAR / 1000 * np.cos(theta), color="grey", linestyle="--", label="above the air")
    panels[2].legend(fontsize=8)
    if sinks:
        _fade(panels[3], {tau: float(parts[0][height == 0.0][0]) for tau, parts in found.items()})
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
    for (tau, lux), color in zip(sunset.items(), style.SERIES, strict=False):
        panel.semilogy(np.degrees(depth), faded(lux, depth), color=color, label=f"turbidity {tau:g}")
    panel.semilogy(np.degrees(depth), clear_day.twilight(depth), color=style.BLACK, linestyle=":", label="measured")
    panel.set_ylim(1e-3, 3e4)
    panel.set_title("twilight", fontsize=10)
    panel.set_xlabel("sun's depth (degrees)")
    panel.set_ylabel("illuminance (lx)")
    panel.legend(fontsize=8)


PICTURE = Picture("A clear day in lux", CAPTION, draw)
