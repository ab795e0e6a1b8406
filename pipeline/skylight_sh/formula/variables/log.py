"""The logarithm of the distance to a point below the range, scaled to [-1, 1]."""

from __future__ import annotations

import numpy as np

from skylight_sh.formula.elementary import log
from skylight_sh.formula.variables.protocol import Variable
from skylight_sh.reproducible import logarithm


def _constants(low: float, high: float, point: float) -> tuple[float, ...]:
    # With the pole above the range the distances shrink, but their ratios stay positive.
    return point, 1.0 / (low - point), 2.0 / logarithm((high - point) / (low - point))


VARIABLE = Variable(
    constants=_constants,
    forward=lambda v, k: k[2] * log((v - k[0]) * k[1]) - 1,
    inverse=lambda u, k: np.exp((u + 1) / k[2]) / k[1] + k[0],
    allowed=lambda low, _, point: "" if point < low else f"a point below the range: less than {low:.9g}",
)
