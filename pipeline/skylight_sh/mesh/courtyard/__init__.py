"""A courtyard made by code: a saturated wall, an arcade, a sculpture on steps, pots, a bench and plants, on paving.

It is open to the south and east; +x is east, +y north, lengths are metres. What stands on something stands off it by two
millimetres, so that no surfaces coincide, and floors have more vertices where things stand on them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh._mesh import Mesh, Part
from skylight_sh.mesh.courtyard import _arcade, _objects
from skylight_sh.mesh.courtyard._ground import Foot, box_foot, earth, floor, round_foot, slabs
from skylight_sh.mesh.shapes import Piece, assembled, box

Array = NDArray[np.float64]

# Albedo, linear RGB.
WALL = (0.72, 0.17, 0.10)
PLASTER = (0.72, 0.68, 0.60)
STONE = (0.55, 0.51, 0.44)
MARBLE = (0.78, 0.76, 0.71)
TILES = (0.50, 0.20, 0.11)
WOOD = (0.26, 0.14, 0.07)
CLAY = (0.56, 0.22, 0.11)
GLAZE = (0.03, 0.17, 0.40)
OCHRE = (0.78, 0.47, 0.07)
LEAF = (0.17, 0.28, 0.10)
CYPRESS = (0.07, 0.12, 0.05)
EARTH = (0.34, 0.29, 0.20)

_GAP = 0.002
# West, south, east and north of what is paved.
_COURT = (-6.0, -13.0, 10.0, 3.9)
_FAR = 400.0
_PLAN = _arcade.Arcade(west=-5.6, bays=4, width=3.4, front=4.2, depth=3.0, floor=0.15)


@dataclass(frozen=True)
class View:
    """Where a picture is taken from: ``eye`` and ``target`` in metres, ``field`` the vertical angle in degrees."""

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    field: float


# The wall on the left, the sculpture on a third, the arcade leading to the right.
ENTRANCE = View(eye=(4.6, -7.6, 1.75), target=(-1.5, 1.0, 1.75), field=40.0)
# From beneath the arcade.
WALK = View(eye=(7.2, 6.3, 1.75), target=(-2.6, 2.0, 1.45), field=42.0)


def courtyard() -> Mesh:
    """Return the courtyard, about 21,000 vertices."""
    parts: list[tuple[Part, Sequence[float], Piece]] = []

    def add(name: str, colour: Sequence[float], piece: Piece, texture: Array | None = None) -> None:
        parts.append((Part(name, texture), colour, piece))

    add("wall", WALL, box((-6.4, -13.5, _GAP), (-6.0, 4.17, 3.1), 0.4, without="-z", finer=0.06))
    add("coping", STONE, box((-6.5, -13.55, 3.1 + _GAP), (-5.93, 4.17, 3.19), 0.8))
    add("arches", PLASTER, _arcade.arches(_PLAN))
    add("cornice", STONE, _arcade.cornice(_PLAN))
    add("roof", TILES, _arcade.roof(_PLAN))
    add("walk", PLASTER, _arcade.walls(_PLAN))
    boards, beams = _arcade.ceiling(_PLAN)
    add("ceiling", (0.55, 0.42, 0.28), boards)
    add("beams", WOOD, beams)
    frame, leaves = _arcade.door(_PLAN, 2)
    add("frame", STONE, frame)
    add("door", (0.05, 0.16, 0.20), leaves)
    for i, (x, y) in enumerate(_PLAN.columns):
        add(f"column {i + 1}", MARBLE, _arcade.column().moved((x, y, _PLAN.floor)))
    feet = [Foot(np.array([[-6.0 - 0.01, -14.0], [-6.0, -14.0], [-6.0, 5.0], [-6.0 - 0.01, 5.0]]))]
    for thing in _objects.things():
        add(thing.name, globals()[thing.colour], thing.piece)
        if thing.radius:
            feet.append(round_foot(thing.x, thing.y, thing.radius))
        elif thing.sides:
            feet.append(box_foot(*thing.sides))
    terrace = box((-6.0 + _GAP, 3.9, _GAP), (_PLAN.east + 0.35, _PLAN.back - _GAP, 0.15), 0.4, without="+z-z-x+y")
    feet.append(box_foot(-6.0 + _GAP, 3.9, _PLAN.east + 0.35, _PLAN.back))
    standing = [box_foot(x - 0.3, y - 0.3, x + 0.3, y + 0.3) for x, y in _PLAN.columns]
    west, east = -6.0 + _GAP, _PLAN.east + 0.35
    top = floor((west, 3.9, east, _PLAN.back - _GAP), 0.15, 0.5, standing)
    texture = slabs()
    add("terrace", STONE, terrace)
    add("terrace floor", (1.0, 1.0, 1.0), top, texture)
    add("paving", (1.0, 1.0, 1.0), floor(_COURT, 0.0, 0.4, feet), texture)
    add("earth", EARTH, earth(_FAR, _COURT))
    return assembled(parts)


__all__ = ["ENTRANCE", "WALK", "View", "courtyard"]
