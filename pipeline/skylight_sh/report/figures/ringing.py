"""Ringing below the horizon, before and after the zonal window (the paper's figure 4)."""

from __future__ import annotations

import textwrap

import numpy as np
from matplotlib.figure import Figure

from skylight_sh import sphere
from skylight_sh.report import panorama, style, titles
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData

SEE = "Purple below the horizon is negative light; look at how much the window leaves of it, and what it takes of the peak."
CAPTION = (
    "The paper's figure 4: luminance of the recommended table's expansion without and with the zonal window of eq. 5, at "
    "the middle of the parameter ranges. Titles give the lowest value below the horizon as a share of the sky's own "
    "brightest value there. Purple is negative light; colours are stretched to show it, so that the sky itself saturates. "
    "Below: along the sun's meridian, from the nadir through the sun to the zenith."
)


def draw(data: ReportData) -> Figure | None:
    """Draw luminance before and after, and a cut through the sun; None where the weights are windowed or no radiance."""
    table = data.best.table
    if table.spec.windowed or table.spec.quantity != "radiance":
        return None
    values = data.middle
    weights = table.whole(table.evaluate(values[np.newaxis])[0], table.bands).astype(np.float64)
    row, unit = data.light.luminance_row, titles.unit(data.settings)
    sky = panorama.sky(data.light, values, tuple(a.name for a in data.axes)) @ row
    before = panorama.expansion(weights) @ row
    after = panorama.expansion(weights * sphere.zonal_sinc(table.bands)) @ row
    # Three times the undershoot: the sky saturates, the ringing shows.
    reach = 3.0 * max(-float(before.min()), 1e-6 * float(before.max()))
    figure = style.figure(style.WIDTH, 6.6)
    grid = figure.add_gridspec(3, 2, height_ratios=(1.0, 0.08, 1.7))
    left, middle = (figure.add_subplot(grid[0, i]) for i in range(2))
    for panel, picture, title in ((left, before, "original"), (middle, after, "windowed")):
        image = panel.imshow(
            picture, extent=panorama.EXTENT, aspect="auto", cmap="PuOr_r", vmin=-reach, vmax=reach, interpolation="nearest"
        )
        low = style.percent(float(picture[len(picture) // 2 :].min() / sky.max()))
        panel.set_title(f"{title}:\nlowest {low}", fontsize=11)
        panel.set_xticks([-120, 0, 120])
        panel.set_yticks([-90, 0, 90])
        panel.set_xlabel("azimuth (°)")
    left.set_ylabel("altitude (°)")
    middle.set_yticklabels([])
    bar = figure.colorbar(image, cax=figure.add_subplot(grid[1, :]), orientation="horizontal", label=f"luminance ({unit})")
    bar.set_ticks([-reach, 0.0, reach], labels=[style.plain(value, 2) for value in (-reach, 0.0, reach)])
    altitude = 90.0 - (np.arange(len(sky)) + 0.5) * 180.0 / len(sky)
    centre = sky.shape[1] // 2
    below = figure.add_subplot(grid[2, :])
    for picture, colour, dash, label in (
        (sky, style.BLACK, ":", "sky"),
        (before, style.RED, "-", "original"),
        (after, style.BLUE, "--", "windowed"),
    ):
        below.plot(altitude, picture[:, centre], color=colour, linestyle=dash, label=label)
    below.axhline(0.0, color="grey", linewidth=0.8)
    below.set_ylim(1.6 * min(before.min(), 0.0), 1.1 * sky.max())
    below.set_xlabel("altitude on the sun's side (°)")
    below.set_ylabel(f"luminance ({unit})")
    below.yaxis.set_major_formatter(style.plain_ticks())
    below.legend(fontsize=11, loc="upper left")
    figure.suptitle("\n".join(textwrap.wrap(f"{data.best.name}, {data.describe(values)}", 50)), fontsize=11)
    return figure


PICTURE = Picture("Ringing, before and after the window", CAPTION, draw, see=SEE)
