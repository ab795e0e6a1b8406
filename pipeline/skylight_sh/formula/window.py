"""The paper's window against ringing: eq. 5 of Habel, Mustata and Wimmer (2008), for generic numbers."""

from __future__ import annotations

from math import pi
from typing import Any

from skylight_sh.formula.elementary import label, sin
from skylight_sh.formula.expression import trace


def sinc(share: Any) -> Any:
    """Return ``sin(x) / x``, x = pi ``share``, which is not 0: the factor of the zonal weight of degree ``share`` N.

    >>> round(float(sinc(0.5)), 4)
    0.6366
    """
    x = label(pi * share, "x")
    return sin(x) / x


SINC = trace(lambda share: [sinc(share)], ["share"])
