"""The vaulted body of the arcade: arches, groin vaults, back wall and end wall as one closed solid."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh.shapes import Piece, disc, joined, sheet, strip

Array = NDArray[np.float64]

# Heights above the walk's floor.
SPRING, TOP = 2.5, 4.35
# Rows of vertices: beneath the cornice, which shades them; and of the walls up to the spring, dense at the floor.
_FRIEZE = (4.0, 4.17, 4.27, 4.32, TOP)
# They start above the floor, which goes on beneath them.
_FOOT = 0.003
_HEIGHTS = (_FOOT, 0.05, 0.16, 0.4, 0.8, 1.3, 1.85, 2.403, SPRING)
# How thick the arches' wall is, half as wide as an arch's foot, and how thick the other walls are.
THICK, HALF_PIER, WALL = 0.5, 0.25, 0.4
_SOUTH, _NORTH, _EAST, _WEST = (0.0, -1.0, 0.0), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0), (-1.0, 0.0, 0.0)
_UP, _DOWN = (0.0, 0.0, 1.0), (0.0, 0.0, -1.0)


@dataclass(frozen=True)
class Arcade:
    """Bays of one ``width`` from ``west`` on, the arches' front at y = ``front``, the walk behind them ``depth`` deep.

    It stands on a terrace of height ``floor``; the back wall of bay ``door`` has a door. Vaults are as wide as bays, arches
    narrower by their feet.
    """

    west: float
    bays: int
    width: float
    front: float
    depth: float
    floor: float
    door: int

    @property
    def east(self) -> float:
        """Where the last bay ends."""
        return self.west + self.bays * self.width

    @property
    def borders(self) -> Array:
        """Where bays begin and end, ``(bays + 1,)``."""
        return np.asarray(self.west + self.width * np.arange(self.bays + 1))

    @property
    def inner(self) -> float:
        """The y of the arches' back."""
        return self.front + THICK

    @property
    def back(self) -> float:
        """The y of the walk's back wall."""
        return self.inner + self.depth


def body(plan: Arcade, detail: float) -> Piece:
    """Return arches, vaults and walls, with 15 vertices around an arch at ``detail`` 1."""
    steps = _steps(detail)
    pieces: list[Piece] = []
    for bay, west in enumerate(plan.borders[:-1]):
        pieces += [*_front(plan, west, steps), *_vault(plan, west, steps, detail), *_back(plan, bay, steps, detail)]
    pieces += [*_west_end(plan, steps, detail), *_east_end(plan, steps, detail)]
    return joined(pieces).moved((0.0, 0.0, plan.floor))


def _steps(detail: float) -> int:
    return 2 * max(3, round(7 * detail))


def _angles(steps: int) -> Array:
    """Return angles from an arch's crown, one foot to the other."""
    return 0.5 * np.pi * np.linspace(-1.0, 1.0, steps + 1)


def _arch(middle: float, half: float, y: float, steps: int) -> Array:
    """Return a half circle, stretched to the vault's rise where it is the vault's."""
    angle = _angles(steps)
    return np.stack([middle + half * np.sin(angle), np.full(angle.shape, y), SPRING + half * np.cos(angle)], axis=-1)


def _outline(plan: Arcade, steps: int) -> Array:
    """Return where rays from an arch's centre meet the outline of its bay beneath the frieze, ``(steps + 1, 2)``."""
    half, high = 0.5 * plan.width, _FRIEZE[0] - SPRING
    sin, cos = np.sin(_angles(steps)), np.maximum(np.cos(_angles(steps)), 0.0)
    reach = np.minimum(half / np.maximum(np.abs(sin), 1e-12), high / np.maximum(cos, 1e-12))
    points = np.stack([reach * sin, reach * cos], axis=-1)
    points[[0, -1]] = [[-half, 0.0], [half, 0.0]]
    corner = int(np.argmin(np.abs(_angles(steps) + np.arctan2(half, high))))
    points[corner], points[steps - corner] = [-half, high], [half, high]
    return points


def _side(plan: Arcade, steps: int) -> Array:
    """Return the heights above the spring of the vertices where two bays' fronts meet."""
    outline = _outline(plan, steps)
    below = outline[outline[:, 0] < -0.5 * plan.width + 1e-9, 1]
    return np.concatenate([below, np.array(_FRIEZE[1:]) - SPRING])


def _front(plan: Arcade, west: float, steps: int) -> list[Piece]:
    """Return an arch's front, its underside and feet, and what shows of it from beneath the vault."""
    half = 0.5 * plan.width
    middle, radius = west + half, half - HALF_PIER
    one, other = (_arch(middle, radius, y, steps) for y in (plan.front, plan.inner))
    outline = _outline(plan, steps)
    outer = np.stack([middle + outline[:, 0], one[:, 1], SPRING + outline[:, 1]], axis=-1)
    share = np.array([0.0, 0.1, 0.45, 1.0])[:, np.newaxis, np.newaxis]
    face, under = (
        one + share * (outer - one),
        one + np.array([0.0, 0.3, 0.7, 1.0])[:, np.newaxis, np.newaxis] * (other - one),
    )
    lowest = outer[outer[:, 2] > _FRIEZE[0] - 1e-9]
    frieze = np.stack([lowest * [1.0, 1.0, 0.0] + [0.0, 0.0, z] for z in _FRIEZE])
    rear = np.array([[west, plan.back + WALL, TOP], [west + plan.width, plan.back + WALL, TOP]])
    pieces = [
        sheet(face).towards(_SOUTH),
        sheet(frieze).towards(_SOUTH),
        sheet(under).towards(_DOWN),
        strip(other, _arch(middle, half, plan.inner, steps)).towards(_NORTH),
        strip(frieze[-1], rear).towards(_UP),
    ]
    for end, x in ((0, west), (-1, west + plan.width)):
        rim = np.concatenate([face[::-1, end], under[1:, end], [[x, plan.inner, SPRING]]])
        pieces.append(disc(rim).towards(_DOWN))
    return pieces


def _vault(plan: Arcade, west: float, steps: int, detail: float) -> list[Piece]:
    """Return four webs that meet in groins: two barrels, of which the higher one counts."""
    half, deep = 0.5 * plan.width, 0.5 * plan.depth
    middle = (west + half, plan.inner + deep)
    rows = max(2, round(4 * detail))
    out = np.sin(0.5 * np.pi * np.arange(rows + 1) / rows)[:, np.newaxis]
    across = out * np.sin(_angles(steps))
    along = np.broadcast_to(out, across.shape)
    rise = half * np.sqrt(np.maximum(1.0 - across**2, 0.0))
    webs = []
    for sign in (-1.0, 1.0):
        for x, y in ((across, sign * along), (sign * along, across)):
            points = np.stack([middle[0] + half * x, middle[1] + deep * y, SPRING + rise], axis=-1)
            webs.append(sheet(points).towards(_DOWN))
    return webs


def _at_foot(line: Array) -> Array:
    return np.add(line * [1.0, 1.0, 0.0], (0.0, 0.0, _FOOT))


def heights(detail: float) -> Array:
    """Return the heights of a wall's rows up to the spring."""
    count = max(4, round(8 * detail))
    found = np.interp(np.linspace(0.0, 8.0, count + 1), np.arange(9), _HEIGHTS)
    found[-2] = _HEIGHTS[-2]
    return found


def _wall(upper: Array, detail: float) -> list[Piece]:
    """Return a wall up to the spring, and up to the line ``upper`` above it."""
    level = upper * [1.0, 1.0, 0.0]
    share = np.array([0.0, 0.4, 0.8, 1.0])[:, np.newaxis, np.newaxis]
    spring = np.add(level, (0.0, 0.0, SPRING))
    lower = np.stack([np.add(level, (0.0, 0.0, z)) for z in heights(detail)])
    return [sheet(lower), sheet(spring + share * (upper - spring))]


def doorway(plan: Arcade, detail: float) -> float:
    """Return half the width that a door with its frame may have: a column of the wall's vertices is there."""
    across = 0.5 * plan.width * np.sin(_angles(_steps(detail)))
    return float(across[across > 0.55][0])


def _around_door(upper: Array, plan: Arcade, detail: float) -> list[Piece]:
    """Return a wall like ``_wall``, where what a door hides is a piece of its own, whose darkness stays there."""
    middle = 0.5 * (upper[0, 0] + upper[-1, 0])
    inside = np.flatnonzero(np.abs(upper[:, 0] - middle) < doorway(plan, detail) + 1e-6)
    first, last = int(inside[0]), int(inside[-1])
    rows = heights(detail)
    lower = np.stack([np.add(upper * [1.0, 1.0, 0.0], (0.0, 0.0, z)) for z in rows])
    door = lower[:-1, first : last + 1]
    rim = np.concatenate([door[0], door[1:, -1], door[-1, -2::-1], door[-2:0:-1, 0]])
    _, above = _wall(upper, detail)
    return [sheet(lower[:, : first + 1]), sheet(lower[:, last:]), sheet(lower[-2:, first : last + 1]), disc(rim), above]


def _back(plan: Arcade, bay: int, steps: int, detail: float) -> list[Piece]:
    """Return a bay's back wall: its inner face up to the vault, its outer face, its foot."""
    half, west = 0.5 * plan.width, plan.borders[bay]
    upper = _arch(west + half, half, plan.back, steps)
    far = np.array([[[x, plan.back + WALL, z] for x in (west, west + plan.width)] for z in (_FOOT, SPRING, TOP)])
    wall = _around_door(upper, plan, detail) if bay == plan.door else _wall(upper, detail)
    inner = [piece.towards(_SOUTH) for piece in wall]
    return [*inner, sheet(far).towards(_NORTH), strip(_at_foot(upper), far[0]).towards(_DOWN)]


def _profile(plan: Arcade, x: float, steps: int) -> Array:
    """Return the vault's section across the walk."""
    angle = _angles(steps)
    y, z = plan.inner + 0.5 * plan.depth * (1.0 + np.sin(angle)), SPRING + 0.5 * plan.width * np.cos(angle)
    return np.stack([np.full(y.shape, x), y, z], axis=-1)


def _west_end(plan: Arcade, steps: int, detail: float) -> list[Piece]:
    """Return the wall at the western end, with its front beside the first arch."""
    upper = _profile(plan, plan.west, steps)
    lower = _at_foot(upper)
    x, y = (plan.west - WALL, plan.west), (plan.front, plan.back + WALL)
    low, high = heights(detail), SPRING + _side(plan, steps)
    rows = np.concatenate([low, high[1:]])
    front = np.array([[[at, y[0], z] for at in x] for z in rows])
    outside = np.array([[x[0], y[1], z] for z in (_FOOT, SPRING, TOP)])
    # Beside the arches' thickness the wall's inner face goes on to the front.
    jamb = np.array([[[x[1], at, z] for at in (y[0], plan.inner)] for z in low])
    foot = np.array([[at, v, _FOOT] for v in y for at in x]).reshape(2, 2, 3)
    top = np.array([[at, v, TOP] for v in y for at in x]).reshape(2, 2, 3)
    rear = np.array([[[at, y[1], z] for at in x] for z in (_FOOT, SPRING, TOP)])
    inner_foot = np.array([[x[1], y[0], _FOOT], *lower.tolist(), [x[1], y[1], _FOOT]])
    outer_front = np.array([[x[0], y[0], z] for z in rows])
    return [
        *(piece.towards(_EAST) for piece in _wall(upper, detail)),
        sheet(front).towards(_SOUTH),
        sheet(jamb).towards(_EAST),
        strip(outer_front, outside, (outer_front[:, 2], outside[:, 2])).towards(_WEST),
        strip(inner_foot, foot[:, 0]).towards(_DOWN),
        sheet(top).towards(_UP),
        sheet(rear).towards(_NORTH),
    ]


def _east_end(plan: Arcade, steps: int, detail: float) -> list[Piece]:
    """Return the eastern end: open below the vault, the back wall's end beside it."""
    x, far, middle = plan.east, plan.back + WALL, plan.inner + 0.5 * plan.depth
    curve = _profile(plan, x, steps)
    side = [[x, plan.front, SPRING + z] for z in _side(plan, steps)]
    outline = np.array([*side, [x, far, TOP], [x, far, SPRING]])
    # The outline's upper corners see the vault's halves up to its crown.
    turns = np.arctan2(outline[:, 1] - middle, outline[:, 2] - SPRING)
    turns[-2] = 0.0
    beside = np.array([[x, plan.back, z] for z in heights(detail)])
    return [
        strip(curve, outline, (_angles(steps), turns)).towards(_EAST),
        strip(beside, np.array([[x, far, _FOOT], [x, far, SPRING]])).towards(_EAST),
    ]


__all__ = ["HALF_PIER", "SPRING", "THICK", "TOP", "WALL", "Arcade", "body"]
