"""Ten spherical lights on ten bands, diffuse and glossy (Mezieres and Paulin's figures 1, 5 and 6)."""

from __future__ import annotations

from matplotlib.figure import Figure

from skylight_sh.report import panels
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData

_NAMES = ("diffuse", "glossy")
SEE = "Left ten bands, right no expansion: what is soft on the left and sharp on the right is what bands cost."
CAPTION = (
    "Mezieres and Paulin light San Miguel by ten spherical lights alone, projected on ten SH bands (figure 1), Sponza by "
    "thirty with a glossy floor in 5 and 8 bands (figure 5), and measured materials by ten (figure 6); nothing hides a "
    "light. So here: the courtyard by night, ten lights of many colours, projected at every point; above, diffuse; below, "
    "with a lobe of cos^16 about the mirror direction for a quarter of the light. Ten bands on the left; on the right the "
    "same lobes integrated over each light's disc, without any expansion. The lights themselves are drawn dimmer than "
    "they are. Below each pair: the relative RMSE of linear light and the mean of FLIP for fewer bands. What projecting "
    "the lights costs a frame is a machine's figure: make bench prints it, under Spherical lights."
)


def draw(data: ReportData) -> Figure | None:
    """Draw a row for each material; None where the run made no pictures of scenes."""
    found = data.pictures.get("ten_lights")
    if found is None:
        return None
    rows = []
    for name in _NAMES:
        ten, exact = panels.told(found, name, "integrated")[-2:]
        rows.append(panels.Row((ten, exact), panels.fewer(found, name)))
    return panels.draw(rows)


PICTURE = Picture("Ten spherical lights", CAPTION, draw, panels.numbers("spherical_lights", "ten_lights", _NAMES), see=SEE)
