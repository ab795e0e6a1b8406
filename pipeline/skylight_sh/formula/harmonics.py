"""The recurrences of normalised associated Legendre functions, real and without the Condon-Shortley sign.

Along the degree l at one order m, ``y_l = ahead(l, m) z y_(l-1) - behind(l, m) y_(l-2)``, which is forward stable; it starts
from the diagonal, ``y_mm = diagonal(m) sin(theta) y_(m-1)(m-1)`` (Holmes and Featherstone 2002, eqs. 11 and 13).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

# y_00.
CONSTANT = math.sqrt(0.25 / math.pi)
# Irradiance on the horizontal of a light that comes from above alone, over its weight l = 1, m = 0.
HORIZONTAL = math.sqrt(4 * math.pi / 3)


def ahead(l: int, m: Any) -> Any:
    """Return the factor of z y_(l-1) at orders ``m`` < l, a number or an array.

    >>> round(float(ahead(1, 0)), 6)
    1.732051
    """
    return np.sqrt((4 * l * l - 1) / (l * l - m * m))


def behind(l: int, m: Any) -> Any:
    """Return the factor of y_(l-2) at orders ``m`` < l - 1, a number or an array.

    >>> round(float(behind(2, 0)), 6)
    1.118034
    """
    return np.sqrt((2 * l + 1) * ((l - 1) ** 2 - m * m) / ((2 * l - 3) * (l * l - m * m)))


def diagonal(m: int) -> float:
    """Return ``y_mm`` over sin(theta) and ``y_(m-1)(m-1)``, m > 0.

    >>> round(diagonal(2), 6)
    1.118034
    """
    return math.sqrt((2 * m + 1) / (2 * m)) * (math.sqrt(2.0) if m == 1 else 1.0)


def sectoral(m: int) -> float:
    """Return ``y_mm`` over sin^m(theta) cos(m phi), a constant.

    >>> round(sectoral(1), 6)
    0.488603
    """
    return CONSTANT * math.prod(diagonal(k) for k in range(1, m + 1))
