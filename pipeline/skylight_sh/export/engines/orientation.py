"""Axes of engines as text: where our +x (east), +y (north) and +z (up) go."""

from __future__ import annotations

import re

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

_PART = re.compile(r"\s*([xyz])\s*=\s*([+-]?)([xyz])\s*")


def parse_axes(text: str) -> Array:
    """Return the matrix ``(3, 3)`` that takes our directions to the engine's.

    ``text`` names, for each of our axes, the engine's axis that it goes to: ``"x=+x,y=-z,z=+y"`` sends our +y to the
    engine's -z. Raises ValueError where an axis is missing, named twice, or the target of two.

    >>> parse_axes("x=+x,y=-z,z=+y").tolist()
    [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]
    """
    parts = [_PART.fullmatch(part) for part in text.split(",")]
    found = [part.groups() for part in parts if part]
    ours, theirs = {part[0] for part in found}, {part[2] for part in found}
    if len(found) != 3 or len(parts) != 3 or len(ours) != 3 or len(theirs) != 3:
        raise ValueError(
            f"Invalid axes {text!r}. Should send each of our +x (east), +y (north), +z (up) to an axis of its own, "
            'like "x=+x,y=-z,z=+y".'
        )
    matrix = np.zeros((3, 3))
    for axis, sign, target in found:
        matrix["xyz".index(target), "xyz".index(axis)] = -1.0 if sign == "-" else 1.0
    return matrix


def describe(text: str) -> str:
    """Say in words what ``parse_axes`` reads: where east, north and up go, and which hand the engine's axes have."""
    matrix = parse_axes(text)
    places = []
    for i, name in enumerate(("east", "north", "up")):
        target = int(np.abs(matrix[:, i]).argmax())
        places.append(f"{name} is {'+' if matrix[target, i] > 0 else '-'}{'xyz'[target]}")
    hand = "right" if np.linalg.det(matrix) > 0 else "left"
    return f"{', '.join(places)}; {hand}-handed"
