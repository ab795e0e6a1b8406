"""Sines to single precision: of the peak's zenith angle, whose powers weights have as a factor, and of an azimuth."""

from __future__ import annotations

from typing import Any

from skylight_sh.formula.elementary import sin
from skylight_sh.formula.expression import trace

SINE = trace(lambda theta: [sin(theta)], ["theta"])

# Of sin x / x by powers of x^2, least largest relative error over [0, pi / 2]: 6.1e-9.
_SHORT = (-0.16666659523576033, 0.008333065487429207, -0.00019809542895612316, 2.6056392547629314e-06)
SHORT_END = 1.5708
"""As far as ``SHORT_SINE`` goes, to either side of 0."""


def _short(theta: Any) -> Any:
    z = theta * theta
    a, b, c, d = _SHORT
    return theta + theta * (z * (a + z * (b + z * (c + z * d))))


SHORT_SINE = trace(lambda theta: [_short(theta)], ["theta"])
"""The sine to single precision without a branch, which a processor would have to guess."""


# Of sin x / x and cos x by powers of x^2, least largest error over [0, pi / 4]: 3.8e-9 of the sine, 9.6e-11 of 1.
_QUARTER_SINE = (-0.166666546095, 0.0083321607504, -0.000195152812578)
_QUARTER_COSINE = (0.0416666468409, -0.0013887366439, 2.44383456808e-05)


def _quarter(angle: Any) -> list[Any]:
    z = angle * angle
    a, b, c = _QUARTER_SINE
    p, q, r = _QUARTER_COSINE
    return [1 - 0.5 * z + z * z * (p + z * (q + z * r)), angle + angle * (z * (a + z * (b + z * c)))]


QUARTER = trace(_quarter, ["angle"])
"""Cosine and sine of an angle of at most an eighth of a turn, to single precision."""
