"""A courtyard made by code: a saturated wall, a vaulted arcade, a sculpture on steps, jars, a bench and plants, on paving.

It is open to the south and east; +x is east, +y north, lengths are metres. What stands on something stands off it by three
millimetres, so that no surfaces coincide, and floors have more vertices where things stand on them.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh._mesh import Mesh, Part
from skylight_sh.mesh.courtyard import _arcade, _objects, _textures
from skylight_sh.mesh.courtyard._ground import box_foot, earth, floor, round_foot
from skylight_sh.mesh.courtyard._vault import HALF_PIER, Arcade, body
from skylight_sh.mesh.courtyard.views import ENTRANCE, WALK, View
from skylight_sh.mesh.shapes import Piece, assembled, box, prism, ticks

Array = NDArray[np.float64]

# Albedo, linear RGB.
COLOURS = {
    "WALL": (0.66, 0.17, 0.055),
    "PLASTER": (0.78, 0.73, 0.64),
    "STONE": (0.60, 0.55, 0.47),
    "MARBLE": (0.78, 0.76, 0.71),
    "TILES": (0.56, 0.21, 0.105),
    "CLAY": (0.58, 0.23, 0.11),
    "GLAZE": (0.025, 0.13, 0.42),
    "OCHRE": (0.80, 0.50, 0.09),
    "LEAF": (0.17, 0.28, 0.10),
    "CYPRESS": (0.10, 0.17, 0.065),
    "EARTH": (0.34, 0.29, 0.20),
    "DOOR": (0.06, 0.22, 0.25),
    "PAVING": (1.0, 1.0, 1.0),
}

_GAP = 0.003
# West, south, east and north of what is paved, and of what is looked at.
_COURT, _NEAR = (-6.0 + _GAP, -13.6, 10.25, 3.9 - _GAP), (-6.0, -6.5, 6.5, 3.9)
_AROUND = (-6.6, -13.6, 10.25, 8.1)
_FAR = 300.0
_PLAN = Arcade(west=-5.6, bays=5, width=3.1, front=4.2, depth=2.9, floor=0.15, door=2)


def courtyard(detail: float = 1.0) -> Mesh:
    """Return the courtyard: about 21,000 vertices at ``detail`` 1, more or fewer by somewhat less than its square.

    Its parts are closed solids, all but the floors, the terrace's edge, and the earth around.
    """
    named: list[tuple[Part, Sequence[float], Piece]] = []

    def add(name: str, colour: str, piece: Piece, texture: Array | None = None) -> None:
        named.append((Part(name, texture), COLOURS[colour], piece))

    add("wall", "WALL", _wall(detail), _textures.plaster(0.13, 11))
    add("coping", "TILES", _coping(detail))
    flat = body(_PLAN, detail).mapped((1.0, 1.0, 0.0), (0.0, 0.0, 1.0), 6.0)
    add("arcade", "PLASTER", flat, _textures.plaster(0.08, 12))
    add("cornice", "PLASTER", _arcade.cornice(_PLAN, detail))
    add("roof", "TILES", _arcade.roof(_PLAN, detail))
    frame, leaves = _arcade.door(_PLAN, detail)
    add("door frame", "STONE", frame)
    add("door", "DOOR", leaves, _textures.boards(8, 3))
    places = _arcade.columns(_PLAN)
    for i, (x, y) in enumerate(places):
        add(f"column {i + 1}", "MARBLE", _arcade.column(detail).moved((x, y, _PLAN.floor)))
    ends = ((_PLAN.west, _PLAN.west + HALF_PIER), (_PLAN.east - HALF_PIER, _PLAN.east))
    for name, (low, high) in zip(("west", "east"), ends, strict=True):
        add(f"{name} pier", "MARBLE", _arcade.pier(low, high, _PLAN, detail))
    things = _objects.things(detail)
    feet = [box_foot(-6.01, -14.0, -6.0, 5.0), box_foot(-6.0 + _GAP, 3.9, _PLAN.east + 0.35, _PLAN.back)]
    for thing in things:
        add(thing.name, thing.colour, thing.piece, _textures.leaves(4) if thing.colour == "CYPRESS" else None)
        if thing.radius:
            feet.append(round_foot(thing.x, thing.y, thing.radius))
        elif thing.sides:
            feet.append(box_foot(*thing.sides))
    paving = _textures.slabs()
    walk = (-6.0 + _GAP, 3.9, _PLAN.east + 0.35, _PLAN.back - _GAP)
    add("terrace", "STONE", box((*walk[:2], _GAP), (*walk[2:], 0.15), 0.4 / detail, without="+z-z+y-x", finer=0.05))
    standing = [box_foot(x - 0.29, y - 0.29, x + 0.29, y + 0.29) for x, y in places]
    standing.append(box_foot(-6.1, _PLAN.front, _PLAN.west, _PLAN.back + 1.0))
    standing.append(box_foot(_PLAN.west - 2.0, _PLAN.back - _GAP, _PLAN.east + 2.0, _PLAN.back + 1.0))
    standing += [box_foot(low, _PLAN.front, high, _PLAN.inner) for low, high in ends]
    add("terrace floor", "PAVING", floor(walk, 0.15, 0.5 / detail, standing), paving)
    add("paving", "PAVING", floor(_COURT, 0.0, 0.48 / detail, feet, dense=_NEAR), paving)
    add("earth", "EARTH", earth(_FAR, _AROUND))
    return assembled(named)


def _wall(detail: float) -> Piece:
    """Return the wall, its rows dense at its foot and beneath the coping."""
    rows = np.array([0.05, 0.16, 0.36, 0.7, 1.15, 1.65, 2.15, 2.6, 2.87, 3.0, 3.06])
    rows = np.interp(np.linspace(0.0, 10.0, max(4, round(11 * detail))), np.arange(11), rows)
    face = [(-6.0, z) for z in (_GAP, *rows, 3.1)]
    places = np.concatenate([np.arange(-13.5, -6.0, 0.7 / detail), ticks(-6.0, 4.17, 0.36 / detail, 0.06)])
    return prism([*face, (-6.5, 3.1), (-6.5, _GAP)], places, "y").mapped((0.0, 1.0, 0.0), (0.0, 0.0, 1.0), 4.0)


def _coping(detail: float) -> Piece:
    """Return a coping with a drip and a roll on its top."""
    section = (
        *((-5.9, 3.1), (-5.9, 3.165), (-5.93, 3.185), (-6.06, 3.215), (-6.1, 3.27), (-6.17, 3.31), (-6.25, 3.325)),
        *((-6.33, 3.31), (-6.4, 3.27), (-6.44, 3.215), (-6.57, 3.185), (-6.6, 3.165), (-6.6, 3.1)),
    )
    return prism(np.add(section, (0.0, _GAP)), np.linspace(-13.55, 4.17, max(4, round(13 * detail))), "y")


__all__ = ["COLOURS", "ENTRANCE", "WALK", "View", "courtyard"]
