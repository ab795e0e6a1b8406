"""What every truth rule returns, and the error one raises that cannot keep its word."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError

Array = NDArray[np.float64]


class NotConvergedError(UserError, RuntimeError):
    """A truth rule did not reach its tolerance within its largest number of nodes."""


@dataclass(frozen=True)
class Samples:
    """SH weights ``(g, k, channels, count)`` and, for each set, the least luminance met and its direction.

    ``estimate`` ``(g, k)`` is the error a rule has measured of its own weights, relative to the largest weight of the
    set's worst channel; NaN where a rule with fixed nodes has measured nothing.
    """

    weights: Array
    least: Array
    least_direction: Array
    estimate: Array


def keep_least(luminance: Array, directions: Array, least: Array, where: Array) -> None:
    """Update the least luminance ``least`` ``(...)`` and its direction ``where`` ``(..., 3)`` in place.

    ``luminance`` ``(..., n)`` stands at ``directions``, which broadcast to ``(..., n, 3)``.

    >>> least, where = np.array([np.inf]), np.zeros((1, 3))
    >>> keep_least(np.array([[3.0, 2.0]]), np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]), least, where)
    >>> least.tolist(), where.tolist()
    ([2.0], [[0.0, 0.0, 1.0]])
    """
    place = luminance.argmin(axis=-1)[..., np.newaxis]
    lowest = np.take_along_axis(luminance, place, axis=-1)[..., 0]
    better = lowest < least
    spread = np.broadcast_to(directions, (*luminance.shape, 3))
    least[better] = lowest[better]
    where[better] = np.take_along_axis(spread, place[..., np.newaxis], axis=-2)[..., 0, :][better]
