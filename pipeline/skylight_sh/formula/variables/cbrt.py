"""The cube root of the distance to a point not below the range: unlike the others, it may be singular at the range's end."""

from __future__ import annotations

from skylight_sh.formula.elementary import cbrt
from skylight_sh.formula.variables.protocol import Variable
from skylight_sh.reproducible import cube_root


def _constants(low: float, high: float, point: float) -> tuple[float, ...]:
    far = cube_root(point - low)
    return point, far, 2.0 / (far - cube_root(point - high))


VARIABLE = Variable(
    constants=_constants,
    forward=lambda v, k: k[2] * (k[1] - cbrt(k[0] - v)) - 1,
    inverse=lambda u, k: k[0] - (k[1] - (u + 1) / k[2]) ** 3,
    allowed=lambda _, high, point: "" if point >= high else f"a point not below the range: at least {high:.9g}",
)
