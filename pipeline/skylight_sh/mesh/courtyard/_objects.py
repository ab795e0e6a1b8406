"""What stands in the courtyard: a sculpture on steps, a bench, jars, plants, and cypresses beside the court."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh.shapes import Piece, blade, box, joined, lathe, tube

Array = NDArray[np.float64]

_GAP = 0.002
_JAR = (
    *((0.0, 0.0), (0.2, 0.0), (0.235, 0.03), (0.3, 0.14), (0.385, 0.32), (0.44, 0.52), (0.452, 0.7), (0.42, 0.86)),
    *((0.345, 0.99), (0.255, 1.07), (0.2, 1.12), (0.18, 1.17), (0.185, 1.21), (0.225, 1.245), (0.235, 1.262), (0.22, 1.275)),
    *((0.17, 1.262), (0.145, 1.2), (0.0, 1.18)),
)
_POT = (
    *((0.0, 0.0), (0.19, 0.0), (0.2, 0.015), (0.24, 0.2), (0.275, 0.4), (0.28, 0.42)),
    *((0.315, 0.425), (0.325, 0.44), (0.325, 0.49), (0.315, 0.505), (0.27, 0.505), (0.262, 0.45), (0.0, 0.45)),
)


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


def things() -> list[Thing]:
    """Return everything, in its place."""
    x, y = -1.3, -0.9
    found = [
        Thing("steps", "STONE", _steps().moved((x, y, 0.0)), x, y, 1.45),
        Thing("plinth", "MARBLE", _plinth().moved((x, y, 0.45))),
        Thing("sculpture", "OCHRE", _sculpture().moved((x, y, 1.29), turn=0.35)),
        *_bench(-5.72, -3.6),
        _jar("blue jar", "GLAZE", 1.0, 3.05, -2.3, 24),
        _jar("clay jar", "CLAY", 0.86, -4.9, 2.75, 18),
        _jar("small jar", "MARBLE", 0.42, -4.15, 2.2, 14),
        _jar("far jar", "CLAY", 0.9, 6.4, 3.2, 16),
    ]
    for i, (px, py, seed) in enumerate(((0.9, 3.25, 1), (-5.2, -0.9, 2))):
        found.append(Thing(f"pot {i + 1}", "CLAY", lathe(_POT, 18).moved((px, py, _GAP)), px, py, 0.2))
        found.append(Thing(f"agave {i + 1}", "LEAF", _agave(seed).moved((px, py, 0.47))))
    for i, (px, py, high, wide) in enumerate(((9.3, -6.4, 6.6, 0.75), (10.9, -4.4, 7.8, 0.9), (11.6, -8.6, 5.6, 0.7))):
        found.append(Thing(f"cypress {i + 1}", "CYPRESS", _cypress(high, wide, i).moved((px, py, 0.0))))
    return found


def _jar(name: str, colour: str, size: float, x: float, y: float, around: int) -> Thing:
    profile = np.array(_JAR) * size
    return Thing(name, colour, lathe(profile, around).moved((x, y, _GAP)), x, y, 0.2 * size)


def _steps() -> Piece:
    """Return three round steps, each a solid of its own."""
    made = []
    for i, radius in enumerate((1.45, 1.1, 0.76)):
        low, high = 0.15 * i + (_GAP if i else 0.0), 0.15 * (i + 1)
        inner = radius - 0.34
        profile = [
            *((0.0, low), (radius - 0.01, low), (radius, low + 0.01), (radius, low + 0.05)),
            *(
                (radius, high - 0.02),
                (radius - 0.02, high),
                (radius - 0.12, high),
                (inner + 0.06, high),
                (inner + 0.012, high),
            ),
        ]
        made.append(lathe([*profile, (0.0, high)], 36))
    return joined(made)


def _plinth() -> Piece:
    """Return a moulded drum."""
    profile = (
        *((0.0, _GAP), (0.4, _GAP), (0.4, 0.06), (0.38, 0.075), (0.345, 0.09), (0.33, 0.12), (0.322, 0.16)),
        *((0.318, 0.4), (0.322, 0.64), (0.335, 0.68), (0.37, 0.705), (0.4, 0.72), (0.4, 0.79), (0.385, 0.805), (0.0, 0.805)),
    )
    return lathe(profile, 28)


def _sculpture() -> Piece:
    """Return a ribbon that turns about itself once on its way around a leaning loop."""
    turns = np.arange(112) / 112
    angle = 2.0 * np.pi * turns
    wide = 0.60 + 0.10 * np.cos(2.0 * angle) + 0.05 * np.sin(3.0 * angle)
    path = np.stack(
        [wide * np.sin(angle) + 0.12 * np.sin(2.0 * angle), 0.30 * np.sin(2.0 * angle + 0.5), -1.18 * wide * np.cos(angle)],
        axis=-1,
    )

    def outline(places: Array) -> Array:
        around = 2.0 * np.pi * np.arange(18) / 18
        cos, sin = np.cos(around), np.sin(around)
        long, thin = np.sign(cos) * np.abs(cos) ** 0.75, np.sign(sin) * np.abs(sin) ** 0.75
        swell = 1.0 + 0.25 * np.cos(2.0 * np.pi * places)
        flat = np.stack(
            np.broadcast_arrays(0.235 * swell[:, np.newaxis] * long, 0.085 * swell[:, np.newaxis] * thin), axis=-1
        )
        turn = 2.0 * np.pi * places + 0.6
        c, s = np.cos(turn)[:, np.newaxis], np.sin(turn)[:, np.newaxis]
        return np.stack([c * flat[..., 0] - s * flat[..., 1], s * flat[..., 0] + c * flat[..., 1]], axis=-1)

    loop = tube(path, outline, 18)
    return loop.moved((0.0, 0.0, -float(loop.positions[:, 2].min())))


def _bench(x: float, y: float) -> list[Thing]:
    found = [Thing("seat", "MARBLE", box((x - 0.2, y - 1.1, 0.4), (x + 0.24, y + 1.1, 0.49), 0.3, finer=0.04))]
    for i, at in enumerate((y - 0.75, y + 0.75)):
        sides = (x - 0.14, at - 0.11, x + 0.18, at + 0.11)
        leg = box((*sides[:2], _GAP), (*sides[2:], 0.4 - _GAP), 0.2)
        found.append(Thing(f"leg {i + 1}", "MARBLE", leg, sides=sides))
    return found


def _agave(seed: int) -> Piece:
    random = np.random.default_rng(seed)
    leaves = []
    for i in range(18):
        ring = i / 18
        length = 0.34 + 0.2 * (1.0 - abs(ring - 0.45)) + random.uniform(-0.03, 0.03)
        leaf = blade(
            length, 0.05, 0.014, lift=0.35 + 1.05 * ring + random.uniform(-0.06, 0.06), droop=0.75 * (1.0 - ring) + 0.1
        )
        leaves.append(leaf.moved((0.0, 0.0, 0.012 * ring), turn=2.39996 * i + random.uniform(-0.1, 0.1)))
    return joined(leaves)


def _cypress(high: float, wide: float, seed: int) -> Piece:
    random = np.random.default_rng(100 + seed)
    phases = random.uniform(0.0, 2.0 * np.pi, 3)

    def ragged(azimuth: Array) -> Array:
        return np.asarray(1.0 + 0.1 * np.sin(3.0 * azimuth + phases[0]) + 0.07 * np.sin(5.0 * azimuth + phases[1]))

    share = np.linspace(0.0, 1.0, 13)
    radius = wide * np.sin(np.pi * share**0.62) ** 0.8 * (1.0 + 0.05 * np.sin(23.0 * share + phases[2]))
    radius[0] = radius[-1] = 0.0
    return lathe(np.stack([radius, 0.25 + (high - 0.25) * share], axis=-1), 16, ragged)
