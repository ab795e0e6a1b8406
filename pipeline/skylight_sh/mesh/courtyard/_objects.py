"""What stands in the courtyard: a sculpture on steps, a bench, jars, plants, and cypresses around it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh.shapes import Piece, blade, box, joined, lathe, prism, ticks, tube

Array = NDArray[np.float64]

_GAP = 0.003
_JAR = (
    *((0.0, 0.0), (0.2, 0.0), (0.23, 0.02), (0.29, 0.12), (0.37, 0.28), (0.43, 0.46), (0.455, 0.64), (0.44, 0.8)),
    *((0.385, 0.93), (0.3, 1.02), (0.225, 1.075), (0.188, 1.12), (0.182, 1.17), (0.205, 1.22), (0.24, 1.25)),
    *((0.245, 1.265), (0.23, 1.278), (0.19, 1.262), (0.158, 1.2), (0.16, 1.1), (0.0, 1.02)),
)
_POT = (
    *((0.0, 0.0), (0.19, 0.0), (0.2, 0.015), (0.235, 0.2), (0.27, 0.4), (0.275, 0.41)),
    *((0.31, 0.418), (0.322, 0.435), (0.322, 0.49), (0.31, 0.505), (0.272, 0.505), (0.262, 0.45), (0.0, 0.46)),
)
# Three steps, and a moulded drum on them: one solid, so that nothing is hidden within it.
_STEP = (
    (0.0, 0.0),
    (0.0, 0.03),
    (0.0, 0.135),
    (-0.004, 0.147),
    (-0.011, 0.153),
    (-0.024, 0.155),
    (-0.1, 0.155),
    (-0.27, 0.155),
)
_DRUM = (
    *((0.42, 0.0), (0.42, 0.07), (0.4, 0.085), (0.36, 0.095), (0.335, 0.125), (0.326, 0.17), (0.322, 0.42)),
    *((0.326, 0.66), (0.338, 0.7), (0.372, 0.72), (0.4, 0.735), (0.4, 0.8), (0.385, 0.815), (0.3, 0.815), (0.0, 0.815)),
)
_TREAD = 0.34


@dataclass(frozen=True)
class Thing:
    """A piece, the name of its colour, and where it stands: a ``radius`` about ``x``, ``y``, or ``sides``, or nowhere."""

    name: str
    colour: str
    piece: Piece
    x: float = 0.0
    y: float = 0.0
    radius: float = 0.0
    sides: tuple[float, float, float, float] | None = None


def things(detail: float) -> list[Thing]:
    """Return everything, in its place."""
    x, y = -1.75, 0.1
    found = [
        Thing("pedestal", "STONE", pedestal(detail).moved((x, y, _GAP)), x, y, 1.45),
        Thing("sculpture", "OCHRE", sculpture(detail).moved((x, y, 1.285), turn=1.42)),
        *_bench(-5.3, -2.5, detail),
        _jar("blue jar", "GLAZE", 1.0, 3.0, -2.2, 26, detail),
        _jar("clay jar", "CLAY", 0.9, -4.9, 2.75, 16, detail),
        _jar("small jar", "MARBLE", 0.45, -4.1, 2.2, 12, detail),
        _jar("far jar", "CLAY", 0.9, 6.4, 3.2, 12, detail),
    ]
    for i, (px, py, seed) in enumerate(((0.9, 3.2, 1), (-5.35, 1.1, 2))):
        found.append(Thing(f"pot {i + 1}", "CLAY", lathe(_POT, _count(16, detail)).moved((px, py, _GAP)), px, py, 0.2))
        found.append(Thing(f"agave {i + 1}", "LEAF", _agave(seed, detail).moved((px, py, 0.47))))
    trees = (
        (11.5, 0.9, 6.5, 0.7),
        (12.4, -1.6, 7.6, 0.85),
        (11.0, -5.2, 6.4, 0.75),
        (-9.5, 1.4, 7.2, 0.8),
        (-10.6, 4.6, 8.6, 0.95),
    )
    for i, (px, py, high, wide) in enumerate(trees):
        found.append(
            Thing(f"cypress {i + 1}", "CYPRESS", _cypress(high, wide, i, np.arctan2(-py, -px), detail).moved((px, py, 0.0)))
        )
    return found


def pedestal(detail: float) -> Piece:
    """Return three round steps and a moulded drum, 1.29 m tall."""
    profile = [(0.0, 0.0)]
    for i in range(3):
        profile += [(1.45 - _TREAD * i + out, 0.155 * i + up) for out, up in _STEP]
    profile += [(radius, 0.465 + up) for radius, up in _DRUM]
    return lathe(profile, _count(33, detail))


def sculpture(detail: float) -> Piece:
    """Return a ring of a squarish section that turns about itself once on its way around, thickest at its foot."""
    count, around = _count(80, detail), 4 * max(2, round(6 * detail))
    angle = 2.0 * np.pi * np.arange(count) / count
    path = np.stack([0.6 * np.sin(angle), 0.1 * np.sin(2.0 * angle), -0.78 * np.cos(angle)], axis=-1)

    def outline(places: Array) -> Array:
        turn = 2.0 * np.pi * np.arange(around) / around
        # A square with hollow sides and round edges.
        radius = 0.235 * (1.0 - 0.17 * np.cos(4.0 * turn) + 0.03 * np.cos(8.0 * turn))
        swell = 1.0 + 0.3 * np.cos(2.0 * np.pi * places)
        angles = turn + 2.0 * np.pi * places[:, np.newaxis] + 0.2
        return np.asarray(
            (swell[:, np.newaxis] * radius)[..., np.newaxis] * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
        )

    ring = tube(path, outline, around)
    return ring.moved((0.0, 0.0, 0.002 - float(ring.positions[:, 2].min())))


def _count(number: int, detail: float) -> int:
    return max(6, round(number * detail))


def _jar(name: str, colour: str, size: float, x: float, y: float, around: int, detail: float) -> Thing:
    profile = np.array(_JAR) * size
    jar = lathe(profile, _count(around, detail)).mapped((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), 1.279 * size)
    return Thing(name, colour, jar.moved((x, y, _GAP)), x, y, 0.2 * size)


def _bench(x: float, y: float, detail: float) -> list[Thing]:
    section = [
        *((0.24, 0.415), (0.255, 0.43), (0.255, 0.475), (0.24, 0.49)),
        *((-0.18, 0.49), (-0.195, 0.475), (-0.195, 0.43), (-0.18, 0.415)),
    ]
    places = ticks(y - 1.15, y + 1.15, 0.28 / detail, 0.04)
    found = [Thing("seat", "MARBLE", prism(np.add(section, (x, 0.0)), places, "y"))]
    for i, at in enumerate((y - 0.75, y + 0.75)):
        sides = (x - 0.14, at - 0.13, x + 0.2, at + 0.13)
        leg = box((*sides[:2], _GAP), (*sides[2:], 0.415 - _GAP), 0.2 / detail, finer=0.05)
        found.append(Thing(f"leg {i + 1}", "MARBLE", leg, sides=sides))
    return found


def _agave(seed: int, detail: float) -> Piece:
    random = np.random.default_rng(seed)
    leaves = []
    for i in range(16):
        ring = i / 16
        length = 0.36 + 0.2 * (1.0 - abs(ring - 0.45)) + random.uniform(-0.03, 0.03)
        lift, around = 0.35 + 1.05 * ring + random.uniform(-0.06, 0.06), 2.39996 * i + random.uniform(-0.1, 0.1)
        leaf = blade(length, 0.055, 0.014, lift=lift, droop=0.75 * (1.0 - ring) + 0.1, rows=max(4, round(5 * detail)))
        reach = 0.1 * np.sqrt(1.0 - ring)
        leaves.append(leaf.moved((reach * np.cos(around), reach * np.sin(around), 0.012 * ring), turn=around))
    return joined(leaves)


def _cypress(high: float, wide: float, seed: int, towards: float, detail: float) -> Piece:
    """Return a tree whose texture is laid on from the azimuth ``towards``, from where it is seen."""
    random = np.random.default_rng(100 + seed)
    phases = random.uniform(0.0, 2.0 * np.pi, 3)

    def ragged(azimuth: Array) -> Array:
        return np.asarray(1.0 + 0.1 * np.sin(3.0 * azimuth + phases[0]) + 0.07 * np.sin(5.0 * azimuth + phases[1]))

    share = np.linspace(0.0, 1.0, _count(10, detail))
    radius = wide * np.sin(np.pi * share**0.62) ** 0.8 * (1.0 + 0.05 * np.sin(23.0 * share + phases[2]))
    radius[-1] = 0.0
    crown = np.stack([np.maximum(radius, 0.1 * (share < 0.5)), 0.4 + (high - 0.4) * share], axis=-1)
    tree = lathe(np.concatenate([[[0.0, 0.0], [0.12, 0.0], [0.1, 0.3]], crown]), _count(12, detail), ragged)
    return tree.mapped((-np.sin(towards), np.cos(towards), 0.0), (0.0, 0.0, 1.0), 1.5)
