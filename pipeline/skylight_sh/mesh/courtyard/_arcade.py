"""What belongs to the arcade's vaulted body: columns and piers, cornice, tiled roof, door."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh.courtyard._vault import SPRING, THICK, TOP, WALL, Arcade, doorway
from skylight_sh.mesh.shapes import Piece, box, joined, lathe, prism, sheet, strip

Array = NDArray[np.float64]

_GAP = 0.003
# Radius and height of a column between its square plinth and abacus: an Attic base, a shaft with entasis, a Tuscan capital.
_COLUMN = (
    *((0.0, 0.142), (0.262, 0.142), (0.281, 0.16), (0.281, 0.188), (0.262, 0.206), (0.232, 0.212), (0.226, 0.235)),
    *((0.243, 0.25), (0.247, 0.268), (0.238, 0.286), (0.21, 0.296), (0.202, 0.34)),
    *((0.201, 0.7), (0.197, 1.15), (0.189, 1.6), (0.178, 1.95), (0.172, 2.08)),
    *((0.19, 2.09), (0.196, 2.108), (0.188, 2.126), (0.171, 2.134)),
    *((0.173, 2.2), (0.19, 2.232), (0.225, 2.27), (0.25, 2.31), (0.256, 2.35), (0.0, 2.35)),
)
# y and z of the cornice before the wall's front, below its top: a fillet, a hollow and a crown, from the top down.
_BACK, _OUT = 0.3, -0.27
_CORNICE = (
    *((_OUT, 0.215), (-0.25, 0.195), (-0.205, 0.175), (-0.165, 0.15)),
    *((-0.145, 0.118), (-0.14, 0.1), (-0.105, 0.092), (-0.08, 0.06), (-0.03, 0.0)),
)
# The eaves before the wall's front and above the vaults' top, and how much higher the ridge is.
_EAVES, _EAVES_HEIGHT, _RISE = 0.4, 0.24, 1.25


def column(detail: float) -> Piece:
    """Return a column with a square plinth and abacus, its foot at the origin."""
    plinth = box((-0.29, -0.29, _GAP), (0.29, 0.29, 0.14), 0.6 / detail)
    abacus = box((-0.285, -0.285, 2.352), (0.285, 0.285, SPRING - _GAP), 0.6 / detail)
    return joined([plinth, lathe(_COLUMN, max(8, round(16 * detail))), abacus])


def pier(low: float, high: float, plan: Arcade, detail: float) -> Piece:
    """Return a square pier between x = ``low`` and ``high``, with a foot and an impost, as tall as the columns."""
    half = 0.5 * THICK
    heights = ((_GAP, 0.2, 0.03, 0.0), (0.2 + _GAP, 2.35 - _GAP, 0.0, 0.05), (2.35, SPRING - _GAP, 0.035, 0.0))
    middle = plan.front + half
    return joined(
        [
            box((low + _GAP, middle - half - out, z0), (high + out, middle + half + out, z1), 0.6 / detail, finer=fine)
            for z0, z1, out, fine in heights
        ]
    ).moved((0.0, 0.0, plan.floor))


def columns(plan: Arcade) -> Array:
    """Return where columns stand, ``(bays - 1, 2)``."""
    x = plan.borders[1:-1]
    return np.stack([x, np.full(x.shape, plan.front + 0.5 * THICK)], axis=-1)


def cornice(plan: Arcade, detail: float) -> Piece:
    """Return the moulding above the arches. Its top follows the roof: no sky shows between them."""
    top = [(y, _EAVES_HEIGHT + _RISE * (y + _EAVES) / _roof_depth(plan) - 2.0 * _GAP) for y in (_BACK, _OUT)]
    section = np.array([(_BACK, 0.0), *top, *_CORNICE])
    places = np.linspace(plan.west - WALL, plan.east + 0.06, max(4, round(14 * detail)))
    return prism(section, places).moved((0.0, plan.front, plan.floor + TOP + _GAP))


def roof(plan: Arcade, detail: float) -> Piece:
    """Return a roof of pantiles that rises to the north, a closed solid."""
    low, high = plan.west - WALL - 0.05, plan.east + 0.2
    count = round((high - low) / 0.32)
    fine = max(4, round(4 * detail))
    phase = np.arange(count * fine + 1) / fine
    x = low + (high - low) / count * phase
    # Rolls that are wider than the troughs between them.
    bulge = 0.085 * np.abs(np.cos(np.pi * phase)) ** 1.4
    slope = np.array([0.0, 0.12, 1.0])
    y = plan.front - _EAVES + _roof_depth(plan) * slope
    height = TOP + _EAVES_HEIGHT + _RISE * slope
    edge = x[::fine]

    def line(across: Array, k: int, above: Array | float) -> Array:
        return np.stack(np.broadcast_arrays(across, y[k], height[k] + above), axis=-1)

    # At the ridge, which nobody sees, tiles are flat.
    top, ridge = np.stack([line(x, k, 0.035 + bulge) for k in range(2)]), line(edge, 2, 0.035)
    eaves, beneath = line(x, 0, 0.0), np.stack([line(edge, k, 0.0) for k in range(1, len(y))])
    sides = [np.stack([[*top[:, i], ridge[i]], [eaves[i], *beneath[:, i]]]) for i in (0, -1)]
    pieces = [
        sheet(top).towards((0.0, 0.0, 1.0)),
        sheet(np.stack([top[0], eaves])).towards((0.0, -1.0, 0.0)),
        strip(eaves, beneath[0], (x, edge)).towards((0.0, 0.0, -1.0)),
        sheet(beneath).towards((0.0, 0.0, -1.0)),
        strip(top[-1], ridge, (x, edge)).towards((0.0, 0.0, 1.0)),
        sheet(np.stack([ridge, beneath[-1]])).towards((0.0, 1.0, 0.0)),
        sheet(sides[0]).towards((-1.0, 0.0, 0.0)),
        sheet(sides[1]).towards((1.0, 0.0, 0.0)),
    ]
    return joined(pieces).moved((0.0, 0.0, plan.floor))


def _roof_depth(plan: Arcade) -> float:
    return plan.depth + THICK + WALL + _EAVES + 0.2


def door(plan: Arcade, detail: float) -> tuple[Piece, Piece]:
    """Return a door in the back wall: its frame, and its leaves."""
    x, y = plan.west + (plan.door + 0.5) * plan.width, plan.back
    half = doorway(plan, detail) + 0.001
    inner = half - 0.13
    size = 0.3 / detail
    # So near the wall that one hardly sees between them.
    frame = [
        box((x - half, y - 0.08, _GAP), (x - inner, y - 0.5 * _GAP, 2.25), size),
        box((x + inner, y - 0.08, _GAP), (x + half, y - 0.5 * _GAP, 2.25), size),
        box((x - half, y - 0.1, 2.25 + _GAP), (x + half, y - 0.5 * _GAP, 2.4), size),
    ]
    low, high = np.array([-inner + _GAP, -0.03, _GAP]), np.array([inner - _GAP, -_GAP, 2.25 - _GAP])
    leaves = box(low, high, size, finer=0.06).mapped((1.0, 0.0, 0.0), (0.0, 0.0, 1.0), 2.0 * inner)
    place = (0.0, 0.0, plan.floor)
    return joined(frame).moved(place), leaves.moved((x, y, 0.0)).moved(place)


__all__ = ["column", "columns", "cornice", "door", "pier", "roof"]
