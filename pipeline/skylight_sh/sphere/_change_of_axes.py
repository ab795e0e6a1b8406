"""Changes of axes: SH weights under any orthogonal 3x3 matrix, rotations and reflections alike."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh.sphere._general_rotation import apply_orthogonal, nearest_orthogonal


def change_axes(weights: NDArray[np.floating], matrix: ArrayLike) -> NDArray[np.float64]:
    """Return the SH weights of the same environment seen in other axes.

    ``matrix`` is orthogonal, 3x3, and takes a direction in the old axes to the same direction in the new ones; its
    columns are the old axes' places in the new. ``weights`` has shape ``(..., N*N)``, any N; so has the result, for which
    ``evaluate(result, directions @ matrix.T)`` equals ``evaluate(weights, directions)``. Matrices ``(..., 3, 3)``
    broadcast against the leading axes.

    Numerically the same as ``rotate``, reflections included. A mere permutation of axes mixes the weights of a
    degree from l = 2 on. Raises ValueError where the matrix is not orthogonal.
    """
    return apply_orthogonal(weights, nearest_orthogonal(matrix))
