"""Words on pictures, as far as a day's hours need them: digits, drawn as pixels."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# Five by seven dots each, a row a number, the leftmost dot the highest bit.
_DOTS = {
    "0": (14, 17, 19, 21, 25, 17, 14),
    "1": (4, 12, 4, 4, 4, 4, 14),
    "2": (14, 17, 1, 2, 4, 8, 31),
    "3": (31, 2, 4, 2, 1, 17, 14),
    "4": (2, 6, 10, 18, 31, 2, 2),
    "5": (31, 16, 30, 1, 1, 17, 14),
    "6": (6, 8, 16, 30, 17, 17, 14),
    "7": (31, 1, 2, 4, 8, 8, 8),
    "8": (14, 17, 17, 14, 17, 17, 14),
    "9": (14, 17, 17, 15, 1, 2, 12),
    ":": (0, 4, 4, 0, 4, 4, 0),
    " ": (0, 0, 0, 0, 0, 0, 0),
}
_SHADE = 0.35


def dots(text: str) -> NDArray[np.bool_]:
    """Return ``text`` of digits and colons as dots ``(7, columns)``. Raises ValueError for other characters.

    >>> dots("1")[0].astype(int).tolist()
    [0, 0, 1, 0, 0]
    """
    wrong = sorted(set(text) - set(_DOTS))
    if wrong or not text:
        raise ValueError(f"Invalid text {text!r}. Should be digits, colons and blanks.")
    columns: list[NDArray[np.integer]] = []
    for place, character in enumerate(text):
        rows = np.array(_DOTS[character])
        dotted = (rows[:, np.newaxis] >> np.arange(4, -1, -1)) & 1
        narrow = dotted[:, 1:4] if character == ":" else dotted
        columns += [narrow] if place == 0 else [np.zeros((7, 1), dtype=int), narrow]
    return np.concatenate(columns, axis=1).astype(bool)


def written(srgb: Array, text: str, row: int, column: int, size: int) -> Array:
    """Return a picture ``(rows, columns, 3)`` in sRGB with white ``text`` upon a darkened field.

    Its dots are ``size`` pixels wide, the first at ``row``, ``column``; what does not fit is cut off.
    """
    ink = np.kron(dots(text), np.ones((size, size), dtype=bool))
    high, wide = ink.shape
    out = srgb.copy()
    field = out[max(row - 2 * size, 0) : row + high + 2 * size, max(column - 2 * size, 0) : column + wide + 2 * size]
    field *= 1.0 - _SHADE
    place = out[row : row + high, column : column + wide]
    place[ink[: place.shape[0], : place.shape[1]]] = 1.0
    return out


def ruled(srgb: Array, columns: NDArray[np.integer], width: int) -> Array:
    """Return a picture with white vertical rules ``width`` pixels wide, whose middles are at ``columns``."""
    out = srgb.copy()
    for column in columns.tolist():
        left = column - width // 2
        out[:, max(left, 0) : left + width] = 1.0
    return out
