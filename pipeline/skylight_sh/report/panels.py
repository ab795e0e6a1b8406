"""Rows of pictures under each other, with few words in letters that stay legible on a phone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from skylight_sh.report import style

Array = NDArray[np.float64]

# Inches: the whole width, between pictures, and around them.
_WIDTH, _GAP, _EDGE = 11.6, 0.1, 0.06
# A line's height over its letters'.
_LEADING = 1.45


@dataclass(frozen=True)
class Row:
    """Pictures ``(rows, columns, 3)`` side by side in sRGB from 0 to 1, a title above each, and perhaps a line below them.

    Pictures of a row are equally wide and have the same proportions.
    """

    pictures: Sequence[tuple[str, NDArray[np.floating]]]
    below: str = ""


def draw(rows: Sequence[Row]) -> Figure:
    """Return a figure of ``rows``; letters are 11 pixels high where the figure is shown 360 wide."""
    size = style.legible(_WIDTH)
    line = _LEADING * size / 72.0
    heights = [_shape(row)[1] for row in rows]
    titled = [any(title for title, _ in row.pictures) for row in rows]
    whole = 2 * _EDGE + sum(
        height + (line if above else _GAP) + (line if row.below else 0.0)
        for row, height, above in zip(rows, heights, titled, strict=True)
    )
    figure = Figure(figsize=(_WIDTH, whole), dpi=style.DPI)
    top = whole - _EDGE
    for row, height, above in zip(rows, heights, titled, strict=True):
        width = _shape(row)[0]
        top -= line if above else _GAP
        for place, (title, picture) in enumerate(row.pictures):
            left = _EDGE + place * (width + _GAP)
            panel = figure.add_axes((left / _WIDTH, (top - height) / whole, width / _WIDTH, height / whole))
            panel.imshow(np.clip(picture, 0.0, 1.0), aspect="auto", interpolation="lanczos")
            panel.set_axis_off()
            figure.text(left / _WIDTH, (top + 0.22 * line) / whole, title, fontsize=size, va="bottom")
        top -= height
        if row.below:
            top -= line
            figure.text(_EDGE / _WIDTH, (top + 0.22 * line) / whole, row.below, fontsize=size, va="bottom")
    return figure


def _shape(row: Row) -> tuple[float, float]:
    """Return the width and height in inches of a row's pictures."""
    count, picture = len(row.pictures), row.pictures[0][1]
    width = (_WIDTH - 2 * _EDGE - (count - 1) * _GAP) / count
    return width, width * picture.shape[0] / picture.shape[1]


def measured(error: float, flip: float) -> str:
    """Return a relative RMSE and a FLIP mean in few letters.

    >>> measured(0.0368, 0.0457)
    '3.7 %, FLIP .046'
    """
    return f"{style.percent(float(f'{error:.2g}'))}, FLIP {flip:.3f}".replace(" 0.", " .")
