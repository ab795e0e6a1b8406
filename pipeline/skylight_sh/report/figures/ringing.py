"""Ringing below the horizon, before and after the zonal window (the paper's figure 4)."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from skylight_sh import sphere
from skylight_sh.report import panorama, style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData

CAPTION = (
    "The paper's figure 4: luminance of the recommended table's expansion without and with the zonal window of eq. 5, at "
    "the middle of the parameter ranges. Titles give the lowest value below the horizon as a share of the sky's own "
    "brightest value there. Purple is negative light; colours are stretched to show it, so that the sky itself saturates. "
    "Right: along the sun's meridian, from the nadir through the sun to the zenith."
)


def draw(data: ReportData) -> Figure | None:
    """Draw luminance before and after, and a cut through the sun; None where the weights are windowed or no radiance."""
    table = data.best.table
    if table.spec.windowed or table.spec.quantity != "radiance":
        return None
    values = data.middle
    weights = table.whole(table.evaluate(values[np.newaxis])[0], table.bands).astype(np.float64)
    row = data.light.luminance_row
    sky = panorama.sky(data.light, values, tuple(a.name for a in data.axes)) @ row
    before = panorama.expansion(weights) @ row
    after = panorama.expansion(weights * sphere.zonal_sinc(table.bands)) @ row
    # Three times the undershoot: the sky saturates, the ringing shows.
    reach = 3.0 * max(-float(before.min()), 1e-6 * float(before.max()))
    figure, found = style.panels(12, 3.9, columns=3, bottom=1.2, top=0.6, width_ratios=(1, 1, 1.1))
    left, middle, right = found[0]
    for panel, picture, title in ((left, before, "original"), (middle, after, "windowed")):
        image = panel.imshow(picture, extent=panorama.EXTENT, aspect="auto", cmap="PuOr_r", vmin=-reach, vmax=reach)
        low = 100 * picture[len(picture) // 2 :].min() / sky.max()
        panel.set_title(f"{title}: lowest {low:.1f} % of the sky's own brightest", fontsize=9)
        panel.set_xlabel("azimuth from the sun (degrees)")
    left.set_ylabel("altitude (degrees)")
    figure.colorbar(image, cax=style.bar(figure, 1.8, 0.45, 4.6, 0.12), label="luminance (cd/m²)", orientation="horizontal")
    altitude = 90.0 - (np.arange(len(sky)) + 0.5) * 180.0 / len(sky)
    centre = sky.shape[1] // 2
    for picture, colour, dash, label in (
        (sky, style.BLACK, ":", "sky"),
        (before, style.RED, "-", "original"),
        (after, style.BLUE, "--", "windowed"),
    ):
        right.plot(altitude, picture[:, centre], color=colour, linestyle=dash, label=label)
    right.axhline(0.0, color="grey", linewidth=0.8)
    right.set_ylim(1.6 * min(before.min(), 0.0), 1.1 * sky.max())
    right.set_xlabel("altitude on the sun's side (degrees)")
    right.set_ylabel("luminance (cd/m²)")
    right.legend(fontsize=8)
    figure.suptitle(f"{data.best.name}, {data.describe(values)}", fontsize=10)
    return figure


PICTURE = Picture("Ringing, before and after the window", CAPTION, draw)
