"""Tensor products of bases in one variable each: over scattered points, and over a grid."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Number = TypeVar("Number", bound=np.floating)


def products(values: Sequence[NDArray[Number]]) -> NDArray[Number]:
    """Return all products of one function an axis at ``n`` points: ``(n, t_1 .. t_D)``, the first axis slowest.

    ``values[a]`` ``(n, t_a)`` are the functions of axis a at each point. Raises ValueError for no axis.

    >>> products([np.array([[1.0, 2.0]]), np.array([[1.0, 3.0]])]).tolist()
    [[1.0, 3.0, 2.0, 6.0]]
    """
    if not values:
        raise ValueError("A product needs at least one axis, got none.")
    out = np.ones((len(values[0]), 1), dtype=values[0].dtype)
    for own in values:
        out = (out[:, :, np.newaxis] * own[:, np.newaxis, :]).reshape(len(own), -1)
    return out


def grid_products(values: Sequence[NDArray[Number]]) -> NDArray[Number]:
    """Return the same for all points of a grid: ``(n_1 .. n_D, t_1 .. t_D)``, the first axis slowest.

    ``values[a]`` ``(n_a, t_a)`` are the functions of axis a at its nodes: the Kronecker product. Raises ValueError for no
    axis.

    >>> grid_products([np.array([[1.0], [2.0]]), np.array([[3.0], [5.0]])]).ravel().tolist()
    [3.0, 5.0, 6.0, 10.0]
    """
    if not values:
        raise ValueError("A product needs at least one axis, got none.")
    out = values[0]
    for own in values[1:]:
        out = np.einsum("ai,bj->abij", out, own).reshape(len(out) * len(own), -1)
    return out
