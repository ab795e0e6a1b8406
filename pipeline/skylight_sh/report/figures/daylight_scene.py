"""A scene by day and at sunset, lit by few bands beside brute force (the paper's figures 1 and 5)."""

from __future__ import annotations

from matplotlib.figure import Figure

from skylight_sh.report import panels
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import ReportData

SEE = "Compare each picture with the last of its block, which is brute force: more bands sharpen shadows."
CAPTION = (
    "Figures 1 and 5 of Habel, Mustata and Wimmer 2008 show a scene lit by five SH bands, by day and at sunset, with "
    "directional sunlight, soft shadows and Reinhard's tone mapper, and no other picture to hold it against. Here is a "
    "courtyard with the sun 52 degrees high, and 7: lit by this run's recommended table through precomputed transfer, in "
    "3, 5 and 7 bands, and beside it by paths through the sky itself. Straight sunlight comes by shadow rays in all of "
    "them, its bounces through the same matrix as the sky's, or by paths. In per cent: relative RMSE of linear light over "
    "what is not sky; and the mean of FLIP, which is what an eye sees of the difference, from 0 to 1."
)


def draw(data: ReportData) -> Figure | None:
    """Draw two rows of two pictures for each sun; None where the run made no pictures of scenes."""
    found = data.pictures.get("courtyard")
    if found is None:
        return None
    rows = []
    for name in ("day", "sunset"):
        three, five, seven, paths = panels.told(found, name)
        rows += [panels.Row((three, five)), panels.Row((seven, paths))]
    return panels.draw(rows)


PICTURE = Picture(
    "By day and at sunset, beside brute force",
    CAPTION,
    draw,
    panels.numbers("daylight_scene", "courtyard", ("day", "sunset")),
    see=SEE,
)
