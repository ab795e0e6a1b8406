"""The sine of the peak's zenith angle, whose powers weights have as a factor where a table has parity."""

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
