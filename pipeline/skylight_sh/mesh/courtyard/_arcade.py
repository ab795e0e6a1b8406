"""An arcade: arches on columns before a covered walk, with a beamed ceiling and a tiled roof."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh.shapes import Piece, box, joined, lathe, sheet

Array = NDArray[np.float64]

_GAP = 0.002
_SPRING, _TOP, _THICK = 2.45, 4.3, 0.46
_HALF_PIER = 0.27
# Radius and height of a column between its square plinth and abacus, which end at 0.14 and 2.33.
_COLUMN = (
    *((0.265, 0.142), (0.285, 0.165), (0.285, 0.19), (0.262, 0.215), (0.23, 0.222), (0.228, 0.25)),
    *((0.248, 0.268), (0.248, 0.29), (0.21, 0.312), (0.2, 0.36)),
    *((0.199, 0.65), (0.196, 1.05), (0.189, 1.45), (0.179, 1.8), (0.17, 2.04)),
    *((0.192, 2.055), (0.192, 2.078), (0.17, 2.09)),
    *((0.174, 2.17), (0.2, 2.23), (0.25, 2.28), (0.27, 2.328)),
)


@dataclass(frozen=True)
class Arcade:
    """Bays of one ``width`` from ``west`` on, the arches' front at y = ``front``, the walk behind them ``depth`` deep.

    It stands on a terrace of height ``floor``.
    """

    west: float
    bays: int
    width: float
    front: float
    depth: float
    floor: float

    @property
    def east(self) -> float:
        """Where the last bay ends."""
        return self.west + self.bays * self.width

    @property
    def columns(self) -> Array:
        """Where columns stand, ``(bays + 1, 2)``."""
        x = self.west + self.width * np.arange(self.bays + 1)
        return np.stack([x, np.full(x.shape, self.front + 0.5 * _THICK)], axis=-1)

    @property
    def back(self) -> float:
        """The y of the walk's back wall."""
        return self.front + _THICK + self.depth


def column(around: int = 18) -> Piece:
    """Return a column with a square plinth and abacus, its foot at the origin."""
    plinth = box((-0.3, -0.3, _GAP), (0.3, 0.3, 0.14), 0.6)
    abacus = box((-0.3, -0.3, 2.33), (0.3, 0.3, _SPRING - _GAP), 0.3)
    return joined([plinth, lathe(_COLUMN, around), abacus])


def arches(plan: Arcade) -> Piece:
    """Return the wall above the columns with its arches, a closed solid but for its top, which the cornice covers."""
    pieces = []
    front, back = plan.front, plan.front + _THICK
    for bay in range(plan.bays):
        left = plan.west + bay * plan.width
        pieces += _bay(left, left + plan.width, front, back)
    for bay in range(plan.bays + 1):
        x = plan.west + bay * plan.width
        first, last = bay == 0, bay == plan.bays
        low, high = x - (_HALF_PIER if not first else 0.0), x + (_HALF_PIER if not last else 0.0)
        pieces.append(_quad((low, back, _SPRING), (high, back, _SPRING), (high, front, _SPRING), (low, front, _SPRING)))
    for x, sign in ((plan.west, -1.0), (plan.east, 1.0)):
        ends = [(x, front, _SPRING), (x, back, _SPRING), (x, back, _TOP), (x, front, _TOP)]
        pieces.append(_quad(*(ends if sign > 0.0 else ends[::-1])))
    return joined(pieces).moved((0.0, 0.0, plan.floor))


def cornice(plan: Arcade) -> Piece:
    """Return the moulding above the arches, in two steps."""
    low = box((plan.west - 0.4, plan.front - 0.07, _TOP + _GAP), (plan.east + 0.07, plan.front + _THICK, _TOP + 0.1), 0.85)
    high = box(
        (plan.west - 0.4, plan.front - 0.17, _TOP + 0.1 + _GAP), (plan.east + 0.17, plan.front + _THICK, _TOP + 0.2), 0.85
    )
    return joined([low, high]).moved((0.0, 0.0, plan.floor))


def roof(plan: Arcade, tile: float = 0.24) -> Piece:
    """Return the roof: half-round tiles that rise to the north, on boards."""
    count = round((plan.east + 0.75 - plan.west) / tile)
    phase = np.arange(count * 5 + 1) / 5.0
    x = plan.west - 0.45 + tile * phase
    bulge = 0.075 * np.sqrt(np.maximum(np.sin(np.pi * (phase % 1.0)), 0.0))
    slope = np.linspace(0.0, 1.0, 2)
    y = plan.front - 0.42 + (plan.depth + _THICK + 1.0) * slope
    low = _TOP + 0.26 + 0.95 * slope
    top = np.stack(np.broadcast_arrays(x, y[:, np.newaxis], low[:, np.newaxis] + bulge), axis=-1)
    bottom = np.stack(np.broadcast_arrays(x, y[:, np.newaxis], low[:, np.newaxis] - 0.03), axis=-1)
    edge = sheet(np.stack([bottom[0], top[0]]))
    coarse = bottom[:, :: len(phase) - 1][:, ::-1]
    ends = [sheet(np.stack([bottom[:, 0], top[:, 0]])[::-1]), sheet(np.stack([bottom[:, -1], top[:, -1]]))]
    far = sheet(np.stack([bottom[-1], top[-1]])[::-1])
    boards = sheet(np.linspace(coarse[:, 0], coarse[:, 1], 20, axis=1))
    return joined([sheet(top), boards, edge, far, *ends]).moved((0.0, 0.0, plan.floor))


def walls(plan: Arcade) -> Piece:
    """Return the back wall of the walk, and the wall at its western end."""
    high = _TOP - 0.1
    back = box(
        (plan.west - 0.4, plan.back, _GAP), (plan.east + 0.1, plan.back + 0.4, high), 0.45, finer=0.07, without="+y-z+z"
    )
    outside = box((plan.west - 0.4, plan.back, _GAP), (plan.east + 0.1, plan.back + 0.4, high), 3.0, without="-y-x+x-z")
    west = box(
        (plan.west - 0.8, plan.front - 0.02, _GAP), (plan.west - 0.4 - _GAP, plan.back + 0.4, high), 0.4, without="-z"
    )
    return joined([back, outside, west]).moved((0.0, 0.0, plan.floor))


def ceiling(plan: Arcade) -> tuple[Piece, Piece]:
    """Return the ceiling's boards, and its beams."""
    south, north, low = plan.front + _THICK + _GAP, plan.back - _GAP, _TOP - 0.3
    boards = box((plan.west - 0.39, south, low), (plan.east + 0.1, north, low + 0.05), 0.6, without="+z")
    x = np.arange(plan.west + 0.2, plan.east, 0.85)
    beams = [box((at - 0.06, south, low - 0.2), (at + 0.06, north, low - _GAP), 0.9) for at in x]
    return boards.moved((0.0, 0.0, plan.floor)), joined(beams).moved((0.0, 0.0, plan.floor))


def door(plan: Arcade, bay: int) -> tuple[Piece, Piece]:
    """Return a door in the middle of a bay's back wall: its frame, and its leaves of four boards each."""
    x, y = plan.west + (bay + 0.5) * plan.width, plan.back
    sides = [
        box((x - 0.72, y - 0.07, _GAP), (x - 0.58, y - _GAP, 2.25), 0.5),
        box((x + 0.58, y - 0.07, _GAP), (x + 0.72, y - _GAP, 2.25), 0.5),
        box((x - 0.78, y - 0.09, 2.25 + _GAP), (x + 0.78, y - _GAP, 2.42), 0.4),
    ]
    boards = [
        box((x + at + 0.004, y - 0.035, 0.02), (x + at + 0.141, y - _GAP, 2.24), 0.9) for at in np.arange(-0.58, 0.57, 0.145)
    ]
    return joined(sides).moved((0.0, 0.0, plan.floor)), joined(boards).moved((0.0, 0.0, plan.floor))


def _bay(left: float, right: float, front: float, back: float) -> list[Piece]:
    """Return the two faces and the underside of one arch."""
    middle, radius = 0.5 * (left + right), 0.5 * (right - left) - _HALF_PIER
    angle = np.linspace(np.pi, 0.0, 25)
    inner = np.stack([middle + radius * np.cos(angle), _SPRING + radius * np.sin(angle)], axis=-1)
    # Where rays from the arch's centre meet the bay's outline.
    half, high = 0.5 * (right - left), _TOP - _SPRING
    cos, sin = np.cos(angle), np.maximum(np.sin(angle), 1e-12)
    reach = np.minimum(half / np.maximum(np.abs(cos), 1e-12), high / sin)
    outer = np.stack([middle + reach * cos, _SPRING + reach * np.where(sin > 1e-9, sin, 0.0)], axis=-1)
    corner = np.arctan2(high, half)
    for exact in (corner, np.pi - corner):
        at = int(np.argmin(np.abs(angle - exact)))
        outer[at] = [middle + half * np.sign(np.cos(exact)), _TOP]
    share = np.array([0.0, 0.12, 0.45, 1.0])[:, np.newaxis, np.newaxis]
    face = inner + share * (outer - inner)
    across = np.linspace(front, back, 4)
    one, other = (np.stack([face[..., 0], np.full(face.shape[:2], y), face[..., 1]], axis=-1) for y in (front, back))
    under = np.stack(np.broadcast_arrays(inner[:, 0], across[:, np.newaxis], inner[:, 1]), axis=-1)
    return [sheet(one), sheet(other[::-1]), sheet(under[::-1])]


def _quad(a: tuple[float, ...], b: tuple[float, ...], c: tuple[float, ...], d: tuple[float, ...]) -> Piece:
    return sheet(np.array([[a, b], [d, c]]))
