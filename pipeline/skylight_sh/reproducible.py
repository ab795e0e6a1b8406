"""Arithmetic that gives the same bits on every machine: sums in a fixed order, and rounding of what is decided on.

IEEE 754 fixes + - * / and the square root, but not the order in which a matrix product adds, nor exp, log and their
kind: these differ in the last bits between processors and library kernels. Where a number is only computed, that is
noise of 1e-15. Where something is decided by it, a search may take another way. Numbers that decide are therefore
rounded far above the noise and far below what matters; and what is measured of a table is summed in a fixed order.
"""

from __future__ import annotations

from collections.abc import Callable
from decimal import Context, Decimal
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

_EXACT = Context(prec=40)
# Rows of a product that are summed at once: they stay in a first-level cache.
_ROWS = 128


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


def product(left: NDArray[np.floating], right: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return ``left @ right`` of shapes ``(n, terms)`` and ``(terms, m)``, every sum term by term from the first.

    A row's bits depend on that row alone, not on its neighbours; a library's matrix product promises neither. Works in
    the common dtype.
    """
    out = np.zeros((left.shape[0], right.shape[1]), dtype=np.result_type(left, right))
    for start in range(0, len(left), _ROWS):
        rows = slice(start, start + _ROWS)
        total, columns = out[rows], np.ascontiguousarray(left[rows].T)
        term = np.empty_like(total)
        for column, row in zip(columns, right, strict=True):
            np.multiply(column[:, np.newaxis], row, out=term)
            total += term
    return out


def in_double(function: Callable[[Any], Any], values: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return an elementary ``function`` of ``values`` in their dtype, computed in double precision.

    Libraries' single-precision functions differ in the last bit between processors; a double result, rounded, does not.
    """
    wide = np.asarray(values, dtype=np.float64, order="C")
    return np.asarray(function(wide), dtype=values.dtype)


@lru_cache(maxsize=256)
def logarithm(value: float) -> float:
    """Return the natural logarithm of a positive number, correctly rounded: what tables print must be the same anywhere."""
    return float(_EXACT.ln(Decimal(value)))


@lru_cache(maxsize=256)
def cube_root(value: float) -> float:
    """Return the cube root of a number of at least 0, correctly rounded."""
    return float(_EXACT.power(Decimal(value), _EXACT.divide(Decimal(1), Decimal(3))))
