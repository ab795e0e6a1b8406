"""A wall with a normal map, from a lightmap of few bands (the tutorial's picture of baked irradiance)."""

from __future__ import annotations

from matplotlib.figure import Figure

from skylight_sh.report import panels
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData

SEE = "Bricks should stand out as on the last picture, where every normal has rays of its own."
CAPTION = (
    "The tutorial bakes irradiance as a function of the normal, two SH bands a texel in Frostbite's packed form, so that "
    "light in the shade still shows a normal map. Here is a piece of the courtyard's western wall in the morning's "
    "skylight, sky and bounces from the whole court, as bricks: a lightmap whose texels are eight of the picture's wide, "
    "in two and three bands, and the irradiance on every single normal by rays of its own. Relative RMSE of linear light, "
    "and the mean of FLIP. More bands hold no more of an irradiance; what is left is the lightmap's coarseness."
)


def draw(data: ReportData) -> Figure | None:
    """Draw two bands, three, seven, and every normal; None where the run made no pictures of scenes."""
    found = data.pictures.get("relief")
    if found is None:
        return None
    two, three, _, seven, exact = panels.told(found, "wall", "each normal")
    return panels.draw([panels.Row((two, three)), panels.Row((seven, exact), panels.fewer(found, "wall"))])


PICTURE = Picture("A wall with a normal map", CAPTION, draw, panels.numbers("normal_map", "relief", ("wall",)), see=SEE)
