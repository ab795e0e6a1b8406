"""The largest value of a smooth function that is known on a grid alone: its peaks lie between the nodes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def largest(values: Array, shape: Sequence[int]) -> float:
    """Return the largest of ``values`` ``(n, channels)``, not negative, of which the first are on a grid of ``shape``.

    Along each axis of the grid a parabola through the squares at a node and its two neighbours rises above the node by
    what its peak is higher. Nodes count as evenly spaced, as those of Chebyshev's kind are in their angle; at an axis'
    ends nothing is added along that axis. An error that oscillates with four nodes a lobe is up to 8 % higher between
    them than on them, and up to 3 % higher than what this returns.

    >>> largest(np.sqrt([[1.0], [3.0], [2.0]]), (3,)) ** 2 > 3.0
    True
    """
    squares = np.square(values)
    count = int(np.prod(shape, dtype=int))
    top = float(squares.max())
    grid = squares[:count].reshape(*shape, -1)
    risen = grid.copy()
    for axis, size in enumerate(shape):
        if size > 2:
            before, at, after = (np.moveaxis(grid, axis, 0)[slice(i, size - 2 + i)] for i in range(3))
            bend = before + after - 2.0 * at
            peak = (at >= before) & (at >= after) & (bend < 0.0)
            rise = np.where(peak, np.square(after - before) / (-8.0 * np.where(peak, bend, -1.0)), 0.0)
            np.moveaxis(risen, axis, 0)[1:-1] += rise
    return float(np.sqrt(max(top, float(risen.max(initial=0.0)))))
