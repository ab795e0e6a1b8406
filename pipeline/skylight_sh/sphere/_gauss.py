"""Gauss-Legendre rules, computed once each: on [-1, 1], and on [0, 1]."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@lru_cache(maxsize=256)
def gauss(n: int) -> tuple[Array, Array]:
    """Return ``n`` rising nodes in [-1, 1] and their weights, ``(n,)`` each: exact for polynomials of degree 2n - 1.

    Nodes are exactly symmetric about 0. The arrays are shared and cannot be written to. Raises ValueError for n below 1.

    >>> [part.round(4).tolist() for part in gauss(2)]
    [[-0.5774, 0.5774], [1.0, 1.0]]
    """
    return _kept(*np.polynomial.legendre.leggauss(n))


@lru_cache(maxsize=256)
def gauss_unit(n: int) -> tuple[Array, Array]:
    """Return the same rule on [0, 1]; one minus the nodes, without cancellation, are the nodes in reverse.

    >>> [part.round(4).tolist() for part in gauss_unit(2)]
    [[0.2113, 0.7887], [0.5, 0.5]]
    """
    x, w = gauss(n)
    return _kept((1.0 + x) / 2.0, w / 2.0)


def _kept(nodes: Array, weights: Array) -> tuple[Array, Array]:
    for array in (nodes, weights):
        array.flags.writeable = False
    return nodes, weights
