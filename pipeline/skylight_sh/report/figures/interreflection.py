"""A scene unshadowed, shadowed and interreflected, beside brute force (Green's figures 11, 13 and 15)."""

from __future__ import annotations

from matplotlib.figure import Figure

from skylight_sh.report import panels
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData

_NAMES = ("unshadowed", "shadowed", "interreflected")
SEE = "Left five bands, right brute force: they should look alike, and bounces are what fills the shade."
CAPTION = (
    "Green 2003 renders one model by diffuse unshadowed, shadowed and interreflected transfer of 25 coefficients, five "
    "bands (figures 11, 13 and 15), below a light of his own. Here is the same row under this run's sky, the sun 10 "
    "degrees high and its disc left out, in five bands and, beside it, by paths that stop where that transfer does. Above "
    "each: relative RMSE of linear light over what is not sky, and the mean of FLIP; below, those of 3 and 7 bands."
)


def draw(data: ReportData) -> Figure | None:
    """Draw a row for each kind of transfer; None where the run made no pictures of scenes."""
    found = data.pictures.get("courtyard")
    if found is None:
        return None
    rows = []
    for name in _NAMES:
        _, five, _, paths = panels.told(found, name)
        rows.append(panels.Row(((name, five[1]), paths), panels.fewer(found, name)))
    return panels.draw(rows)


PICTURE = Picture(
    "Unshadowed, shadowed, interreflected", CAPTION, draw, panels.numbers("interreflection", "courtyard", _NAMES), see=SEE
)
