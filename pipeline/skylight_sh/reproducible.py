"""Arithmetic that gives the same bits on every machine: sums in a fixed order, and rounding of what is decided on.

IEEE 754 fixes + - * / and the square root, but not the order in which a matrix product adds, nor exp, log and their
kind: these differ in the last bits between processors and library kernels. Where a number is only computed, that is
noise of 1e-15. Where something is decided by it, a search may take another way. Numbers that decide are therefore
rounded far above the noise and far below what matters; and what is measured of a table is summed in a fixed order.
"""

from __future__ import annotations

from decimal import Context, Decimal
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

_EXACT = Context(prec=40)


def significant(values: ArrayLike, bits: int) -> Array:
    """Round to ``bits`` significant bits, any shape; exact powers of two scale, so that all machines agree.

    >>> float(significant(0.1, 4))
    0.1015625
    """
    mantissa, exponent = np.frexp(np.asarray(values, dtype=np.float64))
    return np.asarray(np.ldexp(np.rint(np.ldexp(mantissa, bits)), exponent - bits))


def to_grid(values: Array, bits: int) -> Array:
    """Round to multiples of the largest magnitude's power of two over ``2**bits``, any shape; zeros stay zeros.

    >>> to_grid(np.array([1.0, 0.3]), 2).tolist()
    [1.0, 0.25]
    """
    largest = float(np.abs(values).max(initial=0.0))
    if not largest:
        return values
    step = int(np.frexp(largest)[1]) - 1 - bits
    return np.asarray(np.ldexp(np.rint(np.ldexp(values, -step)), step))


@lru_cache(maxsize=256)
def logarithm(value: float) -> float:
    """Return the natural logarithm of a positive number, correctly rounded: what tables print must be the same anywhere."""
    return float(_EXACT.ln(Decimal(value)))


@lru_cache(maxsize=256)
def cube_root(value: float) -> float:
    """Return the cube root of a number of at least 0, correctly rounded."""
    return float(_EXACT.power(Decimal(value), _EXACT.divide(Decimal(1), Decimal(3))))
