"""The scene about the receiver: what of the sky is seen, and what shines beside it, as the sun turns."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from pipeline import sphere
from pipeline.report import panorama, style
from pipeline.report.material import Material
from pipeline.table.surroundings import Surroundings
from pipeline.table.table import full_weights

Array = NDArray[np.float64]

_AZIMUTHS = (0.0, 120.0, 240.0)
CAPTION = (
    "Surroundings, which stand still while the sun turns, in the bands of the recommended table: the sky alone, what an "
    "even light would look like through what hides the sky (an occluder's shadow is everything but a cap), and the whole "
    "scene with its clouds, lights and ground. East in the middle, north to the left of it. All by the same table; few "
    "bands blur every edge, and all columns are windowed by sinc(l / N), so that ringing does not hide the rest."
)


def draw(material: Material) -> Figure | None:
    """Draw a row a sun azimuth; None where nothing surrounds the scene."""
    table = material.best.table
    around = table.surroundings
    if around is None:
        return None
    values = next(iter(material.cases.values()), np.array([(axis.low + axis.high) / 2 for axis in material.axes]))
    still = full_weights(table, table.evaluate(values[np.newaxis])[0], table.bands).astype(np.float64)
    even = np.zeros_like(still)
    even[:, 0] = np.sqrt(4 * np.pi)
    hidden = _picture(Surroundings(around.transfer).apply(even, table.bands))
    row = material.light.luminance_row
    azimuths = _AZIMUTHS if table.azimuth is None else (float(np.degrees(table.azimuth)),)
    figure = style.figure(12, 2.3 * len(azimuths) + 0.7)
    panels = figure.subplots(len(azimuths), 3, squeeze=False, sharex=True, sharey=True)
    for line, azimuth in zip(panels, azimuths, strict=True):
        turned = sphere.rotate_azimuth(still, np.radians(azimuth))
        sky, scene = _picture(turned), _picture(around.apply(turned, table.bands))
        white = float(np.quantile(sky @ row, 0.98))
        pictures = (panorama.display(sky, white), panorama.display(hidden, 1.0), panorama.display(scene, white))
        for panel, picture in zip(line, pictures, strict=True):
            # Azimuth rises to the left, as seen from inside.
            panel.imshow(picture[:, ::-1], extent=(180, -180, -90, 90), aspect="auto", interpolation="nearest")
            panel.tick_params(labelsize=7)
        line[0].set_ylabel(f"sun at {azimuth:g}°\naltitude (degrees)", fontsize=8)
    for panel, title in zip(panels[0], ("the sky", "what is seen of an even light", "the scene"), strict=True):
        panel.set_title(title, fontsize=10)
    for panel in panels[-1]:
        panel.set_xlabel("azimuth, from east towards north (degrees)", fontsize=8)
    figure.suptitle(f"{material.best.name}, {material.describe(values)}", fontsize=10)
    return figure


def _picture(weights: NDArray[np.floating]) -> Array:
    return panorama.expansion(sphere.scale_degrees(weights, sphere.sinc_window(sphere.bands_of(weights))))
