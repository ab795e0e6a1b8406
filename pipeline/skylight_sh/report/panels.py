"""Rows of pictures under each other, with few words in letters that stay legible on a phone."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from skylight_sh.report import style
from skylight_sh.report.report_data import ReportData

Array = NDArray[np.float64]

# Inches: the whole width, between pictures, and around them.
_WIDTH, _GAP, _EDGE = 11.6, 0.1, 0.06
_DPI = 110
# A line's height over its letters'.
_LEADING = 1.45
_BRUTE = {"paths": "brute force", "integrated": "brute force"}


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
    figure = Figure(figsize=(_WIDTH, whole), dpi=_DPI)
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


def told(found: Mapping[str, NDArray[Any]], name: str, exact: str = "paths") -> list[tuple[str, Array]]:
    """Return the pictures of ``name`` with what they are and how far off, fewest bands first, brute force last."""
    shown = []
    for bands, error, flip in zip(*(found[f"{name}/{key}"].tolist() for key in ("bands", "error", "flip")), strict=True):
        shown.append((f"{bands} bands {measured(error, flip)}", found[f"{name}/{bands}"] / 255.0))
    return [*shown, (_BRUTE.get(exact, exact), found[f"{name}/{exact}"] / 255.0)]


def fewer(found: Mapping[str, NDArray[Any]], name: str, bands: Sequence[int] = (3, 5, 7)) -> str:
    """Return a line of errors by the number of bands: the relative RMSE in per cent, and FLIP."""
    known = found[f"{name}/bands"].tolist()
    rows = [known.index(n) for n in bands]
    errors = ", ".join(style.percent(float(f"{found[f'{name}/error'][k]:.2g}")).removesuffix(" %") for k in rows)
    flips = ", ".join(f"{found[f'{name}/flip'][k]:.3f}".removeprefix("0") for k in rows)
    return f"{', '.join(map(str, bands))} bands: {errors} %; FLIP {flips}"


def numbers(file: str, part: str, names: Sequence[str]) -> Callable[[ReportData], Mapping[str, bytes]]:
    """Return what writes the errors of pictures as ``file``.csv: a row for each of ``names`` and number of bands."""

    def write(data: ReportData) -> Mapping[str, bytes]:
        found = data.pictures.get(part)
        if found is None:
            return {}
        lines = ["picture,bands,relative_rmse,flip"]
        for name in names:
            columns = [found[f"{name}/{key}"].tolist() for key in ("bands", "error", "flip")]
            lines += [f"{name},{bands},{error:.4g},{flip:.4g}" for bands, error, flip in zip(*columns, strict=True)]
        return {f"{file}.csv": ("\n".join(lines) + "\n").encode()}

    return write
