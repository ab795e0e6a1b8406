"""The reciprocal of the distance of the square to a point, scaled to [-1, 1]: for functions even in the parameter."""

from __future__ import annotations

import numpy as np

from skylight_sh.formula.variables.protocol import Variable


def _constants(low: float, high: float, point: float) -> tuple[float, ...]:
    return low * low, 2.0 * (point - high * high) / (high * high - low * low), point


def _allowed(low: float, high: float, point: float) -> str:
    if low < 0.0:
        return "a range from 0 on or above it"
    return "" if not low * low <= point <= high * high else f"a point outside [{low * low:.9g}, {high * high:.9g}]"


VARIABLE = Variable(
    constants=_constants,
    # 1 / (point - v^2), scaled.
    forward=lambda v, k: k[1] * (v * v - k[0]) / (k[2] - v * v) - 1,
    inverse=lambda u, k: np.sqrt(((u + 1) * k[2] + k[1] * k[0]) / (u + 1 + k[1])),
    allowed=_allowed,
    # In the square they would be far apart near 0, where other fits of the same samples need them.
    own_nodes=False,
)
