"""The worst cases as skies: truth, reconstruction, difference (the paper's figure 2)."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.report import panorama, style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import Entry, ReportData

CAPTION = (
    "The paper's figure 2: the sky itself, its SH expansion from converged weights, the expansion from the table, and "
    "their difference in per cent of the least radiance (luminance). Azimuth across, the sun in the middle; altitude "
    "up. An expansion of few bands rings below the horizon, which is the truth of that expansion and no error of a "
    "table."
)


def draw(data: ReportData) -> Figure:
    """Draw a column a case and table, a row a picture."""
    columns: list[tuple[str, NDArray[np.float64], Entry]] = []
    for title, values in data.cases.items():
        columns += [(title, values, entry) for entry in (*data.references[:2], data.best)]
    columns.append(("Worst set of this table", data.best.worst, data.best))
    width = 3.7 * len(columns)
    # Axes are not shared: all show the same ranges, and each would tell all others so.
    figure, panels = style.panels(width, 8.6, 4, len(columns), bottom=1.3, top=0.65, gap=(0.2, 0.13))
    for column, (title, values, entry) in enumerate(columns):
        left, _, across, _ = panels[-1, column].get_position().bounds
        bar = style.bar(figure, left * width, 0.58, across * width, 0.15)
        _column(data, list(panels[:, column]), title, values, entry, bar)
    for panel in panels[:-1].ravel():
        panel.xaxis.set_visible(False)
    for panel in panels[:, 1:].ravel():
        panel.yaxis.set_visible(False)
    for row, label in zip(panels[:, 0], _rows(data), strict=True):
        row.set_ylabel(f"{label}\naltitude (degrees)", fontsize=8)
    for panel in panels[-1]:
        panel.set_xlabel("azimuth from the sun (degrees)", fontsize=8)
    return figure


def _rows(data: ReportData) -> tuple[str, ...]:
    """Return what the rows show."""
    if data.best.table.spec.quantity == "irradiance":
        return ("sky (radiance)", "true irradiance", "irradiance, table", "difference")
    return ("sky", "SH, true weights", "SH, table", "difference")


def _column(data: ReportData, panels: list[Axes], title: str, values: np.ndarray, entry: Entry, bar: Axes) -> None:
    light, table = data.light, entry.table
    names = tuple(axis.name for axis in data.axes)
    bands = min(table.bands, data.best.table.bands)
    truth = table.whole(data.sample(values), bands)
    if table.spec.windowed:
        truth = truth * sphere.zonal_sinc(table.bands)[: bands * bands]
    rebuilt = table.whole(table.evaluate(values[np.newaxis])[0], bands)
    sky = panorama.sky(light, values, names)
    # Both at once, since the basis takes longer than the sums.
    true, made = np.split(panorama.expansion(np.concatenate([truth, rebuilt])), 2, axis=-1)
    white = panorama.white(sky[: len(sky) // 2] @ light.luminance_row)
    # An even sky's irradiance is pi times its radiance.
    scale = np.pi if table.spec.quantity == "irradiance" else 1.0
    # A sun in the weights outshines the sky.
    lit = panorama.white(true @ light.luminance_row) if table.spec.sun_disc else scale * white
    for panel, picture, level in zip(panels, (sky, true, made), (white, lit, lit), strict=False):
        panel.imshow(panorama.display(picture, level), extent=panorama.EXTENT, aspect="auto", interpolation="nearest")
    difference = 100 * ((made - true) @ light.luminance_row) / (scale * _scale(data, values))
    reach = max(float(np.abs(difference).max()), 1e-12)
    image = panels[3].imshow(
        difference, extent=panorama.EXTENT, aspect="auto", cmap=style.SIGNED_MAP, vmin=-reach, vmax=reach
    )
    ticks = np.array([-1.0, -0.5, 0.0, 0.5, 1.0]) * float(f"{reach:.1g}")
    labels = [f"{tick:.2g}" for tick in ticks]
    colours = panels[3].figure.colorbar(image, cax=bar, orientation="horizontal", label="% of L_min", ticks=ticks)
    colours.set_ticklabels(labels)
    bar.tick_params(labelsize=8)
    for panel in panels:
        panel.tick_params(labelsize=7)
    panels[0].set_title(f"{title}\n{entry.name}, N = {bands}\n{data.describe(values)}", fontsize=8.5, parse_math=False)


def _scale(data: ReportData, values: np.ndarray) -> float:
    """Return the least luminance of the nearest verification grid set (1 if it is not positive): a scale for people."""
    index = tuple(int(np.abs(nodes - value).argmin()) for nodes, value in zip(data.grid, values, strict=True))
    least = float(data.least[index])
    return least if least > 0.0 else 1.0


PICTURE = Picture("The worst cases as skies", CAPTION, draw)
