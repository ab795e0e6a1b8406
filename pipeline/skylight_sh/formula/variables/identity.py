"""The parameter scaled to [-1, 1]."""

from __future__ import annotations

from skylight_sh.formula.variables.protocol import Variable


def _constants(low: float, high: float, _: float) -> tuple[float, ...]:
    # A value that never changes has a range of no width; its basis is 1 alone.
    return low, 2.0 / (high - low) if high > low else 0.0


VARIABLE = Variable(
    constants=_constants,
    forward=lambda v, k: (v - k[0]) * k[1] - 1,
    inverse=lambda u, k: (u + 1) / k[1] + k[0],
)
