"""The reciprocal of the distance to a point outside the range, scaled to [-1, 1]."""

from __future__ import annotations

from skylight_sh.formula.variables.protocol import Variable


def _constants(low: float, high: float, point: float) -> tuple[float, ...]:
    return low, 2.0 * (point - high) / (high - low), point


VARIABLE = Variable(
    constants=_constants,
    # 1/(point - v), scaled; written so that nothing cancels near the range's ends.
    forward=lambda v, k: k[1] * (v - k[0]) / (k[2] - v) - 1,
    inverse=lambda u, k: ((u + 1) * k[2] + k[1] * k[0]) / (u + 1 + k[1]),
    allowed=lambda low, high, point: "" if not low <= point <= high else f"a point outside [{low:.9g}, {high:.9g}]",
)
