"""The scene about the receiver: what of the sky is seen, and what shines beside it, as the sun turns."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.report import panorama, style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData
from skylight_sh.runtime import Surroundings

Array = NDArray[np.float64]

_AZIMUTHS = (0.0, 120.0, 240.0)
_TITLES = ("the sky", "an even light,\nwhat is hidden", "the scene")
SEE = "The sun turns from row to row; what stands about the receiver, in the middle, does not."
CAPTION = (
    "Surroundings, which stand still while the sun turns, in the bands of the recommended table: the sky alone, what an "
    "even light would look like through what hides the sky (an occluder's shadow is everything but a cap), and the whole "
    "scene with its clouds, lights and ground. East in the middle, north to the left of it, the sun a red cross. All by "
    "the same table; few bands blur every edge, and all columns are windowed by sinc(l / N), so that ringing does not hide "
    "the rest. What hides the sky acts on as many bands as the table has. The heading tells by how much the first bands "
    "change with a wider sky (relative L2, worst channel of these suns). That is a sign, not the error: the wider sky is "
    "cut too, and the scene itself lies farther off. A table of more bands, of which a renderer takes the first, does "
    "better."
)


def draw(data: ReportData) -> Figure | None:
    """Draw a row a sun azimuth; None where nothing surrounds the scene."""
    table = data.best.table
    around = table.surroundings
    if around is None:
        return None
    values = next(iter(data.cases.values()), data.middle)
    still = table.whole(table.evaluate(values[np.newaxis])[0], table.bands).astype(np.float64)
    even = np.zeros_like(still)
    even[:, 0] = np.sqrt(4 * np.pi)
    hidden = _picture(Surroundings(around.transfer).apply(even, table.bands))
    row = data.light.luminance_row
    azimuths = _AZIMUTHS if table.spec.azimuth is None else (float(np.degrees(table.spec.azimuth)),)
    told = [f"{data.best.name}, {data.describe(values)}", *_truncation(data, values, azimuths)]
    heading = [line for text in told for line in textwrap.wrap(text, 46)]
    each, top = 1.35, 0.2 * len(heading) + 0.65
    height = top + each * len(azimuths) + 0.05
    figure, placed = style.panels(style.WIDTH, height, left=0.0, right=0.0, bottom=0.0, top=0.0)
    figure.delaxes(placed[0, 0])
    figure.text(0.5, 1.0 - 0.05 / height, "\n".join(heading), fontsize=11, va="top", ha="center")
    for place, azimuth in enumerate(azimuths):
        turned = sphere.rotate_azimuth(still, np.radians(azimuth))
        sky, scene = _picture(turned), _picture(around.apply(turned, table.bands))
        white = panorama.white(sky @ row)
        pictures = (panorama.display(sky, white), panorama.display(hidden, 1.0), panorama.display(scene, white))
        for column, (picture, title) in enumerate(zip(pictures, _TITLES, strict=True)):
            bottom = height - top - (place + 1) * each + 0.35
            panel = style.bar(figure, 0.35 + column * 1.55, bottom, 1.47, each - 0.38)
            # Azimuth rises to the left, as seen from inside.
            panel.imshow(picture[:, ::-1], extent=(180, -180, -90, 90), aspect="auto", interpolation="nearest")
            panel.set_xticks([])
            panel.set_yticks([])
            if place == 0:
                panel.set_title(title, fontsize=11, pad=3)
            if column == 0:
                panel.set_ylabel(f"sun at {azimuth:g}°", fontsize=11)
            if column != 1 and data.light.hints.peak_axis:
                at = 90.0 - float(np.degrees(values[[a.name for a in data.axes].index(data.light.hints.peak_axis)]))
                panel.plot((azimuth + 180.0) % 360.0 - 180.0, at, "+", color=style.RED, markersize=9)
    return figure


def _truncation(data: ReportData, values: Array, azimuths: Sequence[float]) -> list[str]:
    """Return a line that tells how far the first bands move with the widest sky; none without a wider one.

    A sign of convergence, not the error against the scene itself (``claims.scene`` measures that).
    """
    table, widest = data.best.table, max(data.surroundings)
    if widest <= table.bands or table.surroundings is None:
        return []
    sky = data.full(values)[:, : widest**2]
    worst = np.zeros(table.bands + 1)
    for azimuth in azimuths:
        turned = sphere.rotate_azimuth(sky, np.radians(azimuth))
        exact = data.surroundings[widest].apply(turned, table.bands)
        off = table.surroundings.apply(turned[:, : table.bands**2], table.bands) - exact
        for n in range(1, table.bands + 1):
            lost = np.linalg.norm(off[:, : n * n], axis=1) / np.linalg.norm(exact[:, : n * n], axis=1)
            worst[n] = max(worst[n], float(lost.max()))
    shown = [n for n in (3, 5, 7, 9, 12) if n < table.bands] + [table.bands]
    told = ", ".join(f"{n}: {style.percent(worst[n])}" for n in shown)
    return [f"change of the first bands with a sky of {widest} bands, which is cut too: {told}"]


def _picture(weights: NDArray[np.floating]) -> Array:
    return panorama.expansion(sphere.scale_degrees(weights, sphere.sinc_window(sphere.bands_of(weights))))


PICTURE = Picture("The scene's surroundings", CAPTION, draw, see=SEE)
