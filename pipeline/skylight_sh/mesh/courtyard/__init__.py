"""A courtyard made by code: a saturated wall, a vaulted arcade, a sculpture on steps, jars, a bench and plants, on paving.

It is open to the south and east; +x is east, +y north, lengths are metres. What stands on something stands off it by three
millimetres, so that no surfaces coincide, and floors have more vertices where things stand on them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh.mesh import textures
from skylight_sh.mesh._mesh import Mesh, Part
from skylight_sh.mesh.courtyard import _arcade, _objects
from skylight_sh.mesh.courtyard._ground import box_foot, earth, floor, round_foot
from skylight_sh.mesh.courtyard._vault import HALF_PIER, Arcade, body
from skylight_sh.mesh.courtyard.views import BENCH, ENTRANCE, MORNING, NOON, SUNSET, WALK, Hour, View
from skylight_sh.mesh.shapes import Piece, assembled, box, prism, ticks

Array = NDArray[np.float64]

# Albedo, linear RGB.
COLOURS = {
    "WALL": (0.66, 0.17, 0.055),
    "PLASTER": (0.78, 0.73, 0.64),
    "OCHRE WASH": (0.76, 0.57, 0.36),
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
# Metres that one copy of the wall's texture covers.
_WALL_SIDE = 4.0
# Of the blue glaze's colour.
_LINE = (26.0, 5.4, 1.5)
# West, south, east and north of what is paved, and of what is looked at.
# Floors go on for a little beneath what stands beside them.
_COURT, _NEAR = (-6.02, -13.6, 10.25, 3.92), (-6.0, -6.5, 6.5, 3.9)
_AROUND = (-6.6, -13.6, 10.25, 8.1)
_FAR = 300.0
_PLAN = Arcade(west=-5.6, bays=5, width=3.1, front=4.2, depth=2.9, floor=0.15, door=2)


def courtyard(detail: float = 1.0) -> Mesh:
    """Return the courtyard: about 21,000 vertices at ``detail`` 1, more or fewer by somewhat less than its square.

    Its parts are closed solids, all but the floors, the terrace's edge, and the earth around.
    """
    named: list[tuple[Part, ArrayLike, Piece]] = []

    def add(name: str, colour: str | Array, piece: Piece, texture: Array | None = None, relief: Array | None = None) -> None:
        named.append((Part(name, texture, relief), COLOURS[colour] if isinstance(colour, str) else colour, piece))

    add("wall", "WALL", _wall(detail), textures.plaster(0.13, 11), textures.relief(textures.trowelled(11), _WALL_SIDE))
    add("coping", "TILES", _coping(detail))
    flat = body(_PLAN, detail).mapped((1.0, 1.0, 0.0), (0.0, 0.0, 1.0), 6.0)
    within = (flat.positions[:, 1] > _PLAN.inner - 1e-6) & (flat.positions[:, 1] < _PLAN.back + 1e-6)
    washed = np.where(within[:, np.newaxis], COLOURS["OCHRE WASH"], COLOURS["PLASTER"])
    add("arcade", washed, flat, textures.plaster(0.08, 12))
    add("cornice", "PLASTER", _arcade.cornice(_PLAN, detail))
    add("roof", "TILES", _arcade.roof(_PLAN, detail))
    frame, leaves = _arcade.door(_PLAN, detail)
    add("door frame", "STONE", frame)
    add("door", "DOOR", leaves, textures.boards(8, 3))
    places = _arcade.columns(_PLAN)
    for i, (x, y) in enumerate(places):
        add(f"column {i + 1}", "MARBLE", _arcade.column(detail).moved((x, y, _PLAN.floor)))
    ends = ((_PLAN.west, _PLAN.west + HALF_PIER), (_PLAN.east - HALF_PIER, _PLAN.east))
    for name, (low, high) in zip(("west", "east"), ends, strict=True):
        add(f"{name} pier", "MARBLE", _arcade.pier(low, high, _PLAN, detail))
    things = _objects.things(detail)
    feet = [box_foot(-6.2, -14.0, -6.0, 5.0), box_foot(-6.0 + _GAP, 3.9, _PLAN.east + 0.35, _PLAN.back)]
    # Lines of white on a blue glaze.
    lines = textures.rings(((0.1, 0.115), (0.615, 0.63), (0.645, 0.69), (0.705, 0.72), (0.965, 1.0)), _LINE)
    painted = {"CYPRESS": textures.leaves(4), "GLAZE": lines}
    for thing in things:
        add(thing.name, thing.colour, thing.piece, painted.get(thing.colour))
        if thing.radius:
            feet.append(round_foot(thing.x, thing.y, thing.radius))
        elif thing.sides:
            feet.append(box_foot(*thing.sides))
    paving = textures.slabs()
    walk = (-6.0 + _GAP, 3.9, _PLAN.east + 0.35, _PLAN.back - _GAP)
    add("terrace", "STONE", box((*walk[:2], _GAP), (*walk[2:], 0.15), 0.7 / detail, without="+z-z+y", finer=0.05))
    standing = [box_foot(x - 0.29, y - 0.29, x + 0.29, y + 0.29) for x, y in places]
    standing.append(box_foot(-6.1, _PLAN.front, _PLAN.west, _PLAN.back + 1.0))
    standing.append(box_foot(_PLAN.west - 2.0, _PLAN.back, _PLAN.east + 2.0, _PLAN.back + 1.0))
    standing += [box_foot(low, _PLAN.front, high, _PLAN.inner) for low, high in ends]
    add("terrace floor", "PAVING", floor((*walk[:3], _PLAN.back + 0.02), 0.15, 0.5 / detail, standing), paving)
    add("paving", "PAVING", floor(_COURT, 0.0, 0.5 / detail, feet, dense=_NEAR), paving)
    add("earth", "EARTH", earth(_FAR, _AROUND))
    return assembled(named)


def _wall(detail: float) -> Piece:
    """Return the wall, its rows dense at its foot and beneath the coping."""
    rows = np.array([0.05, 0.16, 0.36, 0.7, 1.15, 1.65, 2.15, 2.6, 2.87, 3.0, 3.06])
    rows = np.interp(np.linspace(0.0, 10.0, max(4, round(11 * detail))), np.arange(11), rows)
    face = [(-6.0, z) for z in (_GAP, *rows, 3.1)]
    places = np.concatenate([np.arange(-13.5, -6.0, 0.7 / detail), ticks(-6.0, 4.17, 0.36 / detail, 0.06)])
    return prism([*face, (-6.5, 3.1), (-6.5, _GAP)], places, "y").mapped((0.0, 1.0, 0.0), (0.0, 0.0, 1.0), _WALL_SIDE)


def _coping(detail: float) -> Piece:
    """Return a coping with a drip and a roll on its top."""
    section = (
        *((-5.9, 3.1), (-5.9, 3.165), (-5.93, 3.185), (-6.06, 3.215), (-6.1, 3.27), (-6.17, 3.31), (-6.25, 3.325)),
        *((-6.33, 3.31), (-6.4, 3.27), (-6.44, 3.215), (-6.57, 3.185), (-6.6, 3.165), (-6.6, 3.1)),
    )
    return prism(np.add(section, (0.0, _GAP)), np.linspace(-13.55, 4.17, max(4, round(13 * detail))), "y")


__all__ = ["BENCH", "COLOURS", "ENTRANCE", "MORNING", "NOON", "SUNSET", "WALK", "Hour", "View", "courtyard"]
