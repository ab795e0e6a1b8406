"""The worst cases as skies: truth, reconstruction, difference (the paper's figure 2)."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.report import panorama, style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.report_data import Entry, ReportData

Array = NDArray[np.float64]

SEE = "Table and truth look alike, so look at the differences, which are stretched to their largest value."
CAPTION = (
    "The paper's figure 2: the sky itself, its SH expansion from converged weights, and for each table its expansion and "
    "the difference from that of the true weights, in per cent of the least luminance of the sky (for irradiance: of an "
    "even sky's lux that has it), orange below and purple above it. Azimuth runs across from -180° to 180°, the sun in the "
    "middle; altitude up from -90° to 90°. An expansion of few bands rings below the horizon, which is the truth of that "
    "expansion and no error of a table."
)
# Inches: a picture's width and height, between two, a line of letters.
_ACROSS, _HIGH, _GAP, _LINE = 2.4, 1.2, 0.1, 0.21


@dataclass(frozen=True)
class _Case:
    """A set of parameters: what it is, its sky and expansion as pictures, and for each table its picture and difference."""

    heading: str
    sky: Array
    true: Array
    made: tuple[tuple[str, Array, Array], ...]


def draw(data: ReportData) -> Figure:
    """Draw a block a case: sky and expansion, and below them a row a table."""
    cases = _cases(data)
    headings = [textwrap.wrap(case.heading, 46) for case in cases]
    blocks = [
        (len(lines) + 0.5) * _LINE + (1 + len(case.made)) * (_HIGH + _LINE + 0.06)
        for lines, case in zip(headings, cases, strict=True)
    ]
    foot = 0.62
    height = sum(blocks) + foot
    figure, placed = style.panels(style.WIDTH, height, left=0.0, right=0.0, bottom=0.0, top=0.0)
    figure.delaxes(placed[0, 0])
    top = height
    for case, lines in zip(cases, headings, strict=True):
        top -= 0.3 * _LINE
        figure.text(_GAP / 2 / style.WIDTH, top / height, "\n".join(lines), fontsize=11, fontweight="bold", va="top")
        top -= (len(lines) + 0.2) * _LINE
        titles = _titles(data)
        top = _row(figure, top, ((titles[0], case.sky), (titles[1], case.true)))
        for name, made, difference in case.made:
            reach = max(float(np.abs(difference).max()), 1e-12)
            told = f"difference, up to {style.plain(reach, 2)} %"
            top = _row(figure, top, ((name, made), (told, difference / reach)))
    bar = style.bar(figure, 0.6, 0.36, style.WIDTH - 1.2, 0.13)
    bar.imshow(np.linspace(-1.0, 1.0, 201)[np.newaxis], aspect="auto", cmap=style.SIGNED_MAP, extent=(-1, 1, 0, 1))
    bar.set_yticks([])
    bar.set_xticks([-1, 0, 1], ["least", "difference 0", "most"])
    return figure


def _row(figure: Figure, top: float, pictures: Sequence[tuple[str, Array]]) -> float:
    """Draw two pictures with their titles below ``top``, in inches; return where the next row starts."""
    bottom = top - _LINE - _HIGH
    for place, (title, picture) in enumerate(pictures):
        panel: Axes = style.bar(figure, _GAP / 2 + place * (_ACROSS + _GAP), bottom, _ACROSS, _HIGH)
        signed: dict[str, Any] = {"cmap": style.SIGNED_MAP, "vmin": -1.0, "vmax": 1.0} if picture.ndim == 2 else {}
        panel.imshow(picture, extent=panorama.EXTENT, aspect="auto", interpolation="nearest", **signed)
        panel.set_title(title, fontsize=11, pad=3, parse_math=False)
        panel.set_xticks([])
        panel.set_yticks([])
    return bottom - 0.06


def _titles(data: ReportData) -> tuple[str, str]:
    """Return what the first two pictures of a case show."""
    if data.best.table.spec.quantity == "irradiance":
        return ("sky (radiance)", "irradiance, true weights")
    return ("sky", "SH, true weights")


def _cases(data: ReportData) -> list[_Case]:
    """Return the config's cases with the first references and the recommended table, and that table's worst set.

    Where that looks like a case that is shown, as under a sky that does not know the sun, it is left out.
    """
    wanted = [(title, values, (*data.references[:2], data.best)) for title, values in data.cases.items()]
    wanted.append((f"Worst set of {data.best.name}", data.best.worst, (data.best,)))
    found: list[_Case] = []
    for title, values, entries in wanted:
        case = _case(data, f"{title}: {data.describe(values)}", values, entries)
        if not any(np.array_equal(np.rint(255 * case.sky), np.rint(255 * known.sky)) for known in found):
            found.append(case)
    return found


def _case(data: ReportData, heading: str, values: Array, entries: Sequence[Entry]) -> _Case:
    light, bands = data.light, data.best.table.bands
    table = data.best.table
    truth = table.whole(data.sample(values), bands)
    if table.spec.windowed:
        truth = truth * sphere.zonal_sinc(bands)
    sky = panorama.sky(light, values, tuple(axis.name for axis in data.axes))
    rebuilt = []
    for entry in entries:
        weights = entry.table.whole(entry.table.evaluate(values[np.newaxis])[0], min(entry.table.bands, bands))
        rebuilt.append(np.pad(weights, ((0, 0), (0, bands * bands - weights.shape[-1]))))
    # All at once, since the basis takes longer than the sums.
    true, *made = np.split(panorama.expansion(np.concatenate([truth, *rebuilt])), 1 + len(entries), axis=-1)
    white = panorama.white(sky[: len(sky) // 2] @ light.luminance_row)
    # An even sky's irradiance is pi times its radiance.
    scale = np.pi if table.spec.quantity == "irradiance" else 1.0
    # A sun in the weights outshines the sky.
    lit = panorama.white(true @ light.luminance_row) if table.spec.sun_disc else scale * white
    least = scale * _scale(data, values)
    shown = tuple(
        (entry.name, panorama.display(one, lit), 100 * ((one - true) @ light.luminance_row) / least)
        for entry, one in zip(entries, made, strict=True)
    )
    return _Case(heading, panorama.display(sky, white), panorama.display(true, lit), shown)


def _scale(data: ReportData, values: Array) -> float:
    """Return the least luminance of the nearest verification grid set (1 if it is not positive): a scale for people."""
    index = tuple(int(np.abs(nodes - value).argmin()) for nodes, value in zip(data.grid, values, strict=True))
    least = float(data.least[index])
    return least if least > 0.0 else 1.0


PICTURE = Picture("The worst cases as skies", CAPTION, draw, see=SEE)
