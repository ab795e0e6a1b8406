"""Small scenes made by code, each for one question: a relief, an object with cavities, a hall with many lights.

All stand on a floor at z = 0; +x is east, +y north, lengths are metres.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh.mesh import textures
from skylight_sh.mesh._mesh import Mesh, Part
from skylight_sh.mesh.courtyard._arcade import column
from skylight_sh.mesh.courtyard._vault import SPRING
from skylight_sh.mesh.shapes import Piece, assembled, box, joined, lathe, prism, sheet, ticks

Array = NDArray[np.float64]

_GAP = 0.003
_WHITE, _STONE = (0.75, 0.74, 0.72), (0.55, 0.52, 0.47)
# Metres that one copy of the bricks covers.
_BRICKS_SIDE = 1.2
# Radius and height of a thick bowl, up along the outside and down within.
_BOWL = (
    *((0.0, 0.0), (0.16, 0.0), (0.24, 0.02), (0.26, 0.06), (0.22, 0.1), (0.24, 0.14), (0.33, 0.2), (0.42, 0.29)),
    *((0.48, 0.4), (0.505, 0.52), (0.495, 0.64), (0.455, 0.74), (0.41, 0.81), (0.395, 0.835), (0.38, 0.845)),
    *((0.362, 0.835), (0.365, 0.8), (0.4, 0.73), (0.435, 0.63), (0.442, 0.52), (0.42, 0.41), (0.365, 0.31)),
    *((0.29, 0.235), (0.2, 0.185), (0.1, 0.165), (0.0, 0.16)),
)


def wall_with_relief() -> Mesh:
    """Return a brick wall that faces south, about 2,000 vertices, with a floor before it; the wall has texture and relief.

    >>> wall_with_relief().parts[0].relief.shape
    (512, 512, 3)
    """
    height, colour = textures.bricks(3)
    rows = [_GAP, 0.04, 0.12, 0.3, 0.6, 1.0, 1.4, 1.8, 2.1, 2.4]
    # Anticlockwise seen from the east: the front is at y = 0.
    section = [(0.0, 2.4), *((0.0, z) for z in rows[-2::-1]), (0.4, _GAP), (0.4, 2.4)]
    wall = prism(section, ticks(-1.8, 1.8, 0.18, 0.05)).mapped((1.0, 0.0, 0.0), (0.0, 0.0, 1.0), _BRICKS_SIDE)
    brick = Part("wall", colour, textures.relief(height, _BRICKS_SIDE))
    return assembled(
        [(brick, (0.52, 0.21, 0.12), wall), (Part("floor"), _STONE, _floor((-6.0, -8.0, 6.0, 6.0), [(0.0, -0.01)]))]
    )


def cavities() -> Mesh:
    """Return a lobed bowl with balls in it and beside it, on a floor: about 10,000 vertices.

    Most of what lights its inside has met it before, so that unshadowed, shadowed and interreflected transfer differ, as in
    Green 2003.
    """

    def lobes(azimuth: Array) -> Array:
        return np.asarray(1.0 + 0.13 * np.cos(9.0 * azimuth))

    bowl = lathe(_BOWL, 126, lobes).moved((0.0, 0.0, _GAP))
    named: list[tuple[Part, ArrayLike, Piece]] = [(Part("bowl"), (0.78, 0.74, 0.66), bowl)]
    balls = (
        ("red ball", (0.66, 0.09, 0.06), 0.13, (0.12, 0.03, 0.335)),
        ("yellow ball", (0.78, 0.56, 0.08), 0.1, (-0.15, 0.1, 0.335)),
        ("blue ball", (0.05, 0.16, 0.5), 0.17, (0.74, -0.26, 0.17 + _GAP)),
    )
    for name, colour, radius, place in balls:
        named.append((Part(name), colour, _ball(radius).moved(place)))
    named.append((Part("floor"), _STONE, _floor((-6.0, -6.0, 6.0, 6.0), [(0.0, 0.0), (0.74, -0.26)])))
    return assembled(named)


def hall() -> Mesh:
    """Return a hall of eight columns, 12 m long and 7 m wide, open to the south: about 11,000 vertices.

    Lamps hang in it at ``LAMPS``, after the ten spherical lights of Mezieres and Paulin. The floor, to be glossy, is a
    part of its own.
    """
    half, length, high = 3.5, 12.0, 4.2
    places = [(sign * 2.2, y) for sign in (-1.0, 1.0) for y in (1.5, 4.5, 7.5, 10.5)]
    x, y = ticks(-half, half, 0.32, 0.06), ticks(0.0, length, 0.36, 0.06)
    floor = sheet(np.stack(np.broadcast_arrays(x, y[:, np.newaxis], 0.0), axis=-1)).mapped((1, 0, 0), (0, 1, 0), 2.4)
    tiles = np.kron(np.array([[1.0, 0.45], [0.45, 1.0]]), np.ones((64, 64)))[..., np.newaxis] * np.ones(3)
    walls = [
        box((-half - 0.3, 0.0, _GAP), (-half, length, high), 0.5, finer=0.06),
        box((half, 0.0, _GAP), (half + 0.3, length, high), 0.5, finer=0.06),
        box((-half - 0.3, length + _GAP, _GAP), (half + 0.3, length + 0.3, high), 0.5, finer=0.06),
    ]
    lintels = [
        box((at - 0.25, 0.0, SPRING + _GAP), (at + 0.25, length - _GAP, SPRING + 0.4), 0.4, finer=0.06) for at in (-2.2, 2.2)
    ]
    ceiling = box((-half - 0.3, 0.0, high + _GAP), (half + 0.3, length + 0.3, high + 0.3), 0.5, finer=0.06)
    named: list[tuple[Part, ArrayLike, Piece]] = [(Part("floor", tiles), (0.62, 0.6, 0.56), floor)]
    named += [
        (Part(f"{side} wall"), colour, wall)
        for side, colour, wall in zip(("west", "east", "north"), _HALL, walls, strict=True)
    ]
    named += [
        (Part("lintels"), _WHITE, joined(lintels)),
        (Part("ceiling"), _WHITE, ceiling),
    ]
    named += [(Part(f"column {i + 1}"), _WHITE, column(1.0).moved((*at, 0.0))) for i, at in enumerate(places)]
    return assembled(named)


_HALL = ((0.62, 0.17, 0.07), (0.1, 0.28, 0.5), (0.72, 0.66, 0.52))
LAMPS = (
    *((-2.9, 1.0, 1.2), (2.9, 2.2, 2.6), (0.0, 3.0, 3.4), (-1.0, 4.6, 0.7), (1.4, 5.6, 1.9)),
    *((-2.9, 6.2, 3.1), (2.9, 7.8, 0.9), (0.6, 8.4, 2.9), (-1.3, 9.6, 1.6), (1.2, 11.0, 3.5)),
)
"""Centres of ten spherical lamps in the hall, clear of everything by 0.25 m."""


def _ball(radius: float, rows: int = 22, around: int = 36) -> Piece:
    angle = np.pi * np.linspace(-0.5, 0.5, rows)
    profile = radius * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    profile[[0, -1], 0] = 0.0
    return lathe(profile, around)


def _floor(area: tuple[float, float, float, float], near: list[tuple[float, float]]) -> Piece:
    """Return a level floor whose vertices are dense about the places ``near``."""
    west, south, east, north = area
    lines = []
    for axis, (low, high) in enumerate(((west, east), (south, north))):
        places = sorted({place[axis] for place in near})
        steps = np.concatenate([[0.0], np.geomspace(0.03, 1.0, 14), np.linspace(1.5, 6.0, 6)])
        line = np.concatenate([*(at + sign * steps for at in places for sign in (-1.0, 1.0)), [low, high]])
        line = np.unique(np.round(line[(line >= low) & (line <= high)], 6))
        lines.append(line[np.concatenate([[True], np.diff(line) > 0.012])])
    x, y = lines
    return sheet(np.stack(np.broadcast_arrays(x, y[:, np.newaxis], 0.0), axis=-1))
