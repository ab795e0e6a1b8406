"""Changes of variable: monotone maps of a parameter's range onto [-1, 1]."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.reproducible import cube_root, in_double, logarithm

Floats = NDArray[np.floating]


@dataclass(frozen=True)
class Map:
    """One kind of map: ``forward`` to [-1, 1], ``inverse`` back, and ``forward`` as a C expression.

    ``constants(low, high, point)`` gives the numbers ``k`` that ``forward(v, k)`` and ``c_expression`` (over ``v`` and
    the array ``k``) use; ``point`` is the map's singular point, outside the range, where it has one. Both directions
    keep the dtype of their values.
    """

    constants: Callable[[float, float, float], tuple[float, ...]]
    forward: Callable[[Floats, Floats], Floats]
    inverse: Callable[[Floats, Floats], Floats]
    c_expression: str
    c_functions: int = 0


def _scaled(low: float, high: float, _: float) -> tuple[float, ...]:
    # A value that never changes has a range of no width; its basis is 1 alone.
    return low, 2.0 / (high - low) if high > low else 0.0


def _log(low: float, high: float, point: float) -> tuple[float, ...]:
    # With the pole above the range the distances shrink, but their ratios stay positive.
    return point, 1.0 / (low - point), 2.0 / logarithm((high - point) / (low - point))


def _reciprocal(low: float, high: float, point: float) -> tuple[float, ...]:
    return low, 2.0 * (point - high) / (high - low), point


def _cbrt(low: float, high: float, point: float) -> tuple[float, ...]:
    far = cube_root(point - low)
    return point, far, 2.0 / (far - cube_root(point - high))


MAPS: dict[str, Map] = {
    "raw": Map(lambda *_: (), lambda v, _: v, lambda u, _: u, "v"),
    "identity": Map(
        _scaled,
        lambda v, k: (v - k[0]) * k[1] - 1,
        lambda u, k: (u + 1) / k[1] + k[0],
        "(v - k[0]) * k[1] - 1",
    ),
    "log": Map(
        _log,
        lambda v, k: k[2] * in_double(np.log, (v - k[0]) * k[1]) - 1,
        lambda u, k: np.exp((u + 1) / k[2]) / k[1] + k[0],
        "k[2] * LOG((v - k[0]) * k[1]) - 1",
        c_functions=1,
    ),
    # 1/(point - v), scaled; written so that nothing cancels near the range's ends.
    "reciprocal": Map(
        _reciprocal,
        lambda v, k: k[1] * (v - k[0]) / (k[2] - v) - 1,
        lambda u, k: ((u + 1) * k[2] + k[1] * k[0]) / (u + 1 + k[1]),
        "k[1] * (v - k[0]) / (k[2] - v) - 1",
    ),
    # The cube root of the distance to a point at or above the range: unlike the others, it may be singular at the end.
    "cbrt": Map(
        _cbrt,
        lambda v, k: k[2] * (k[1] - in_double(np.cbrt, k[0] - v)) - 1,
        lambda u, k: k[0] - (k[1] - (u + 1) / k[2]) ** 3,
        "k[2] * (k[1] - CBRT(k[0] - v)) - 1",
        c_functions=1,
    ),
}
