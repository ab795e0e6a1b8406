"""Changes of axes: SH weights under any orthogonal 3x3 matrix, rotations and reflections alike."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pipeline.sphere._indexing import degrees_orders
from pipeline.sphere._rotation import rotate_azimuth, rotate_y

Array = NDArray[np.float64]

# How far from orthogonal a matrix may be: the rounding of one typed with seven digits.
_TOLERANCE = 1e-6


def change_axes(weights: NDArray[np.floating], matrix: ArrayLike) -> Array:
    """Return the SH weights of the same environment seen in other axes.

    ``matrix`` is orthogonal, 3x3, and takes a direction in the old axes to the same direction in the new ones; its
    columns are the old axes' places in the new. ``weights`` has shape ``(..., N*N)``, any N; so has the result, for which
    ``evaluate(result, directions @ matrix.T)`` equals ``evaluate(weights, directions)``.

    A proper matrix is split into turns about z, y and z, each of them exact. An improper one is minus a proper one,
    and the point reflection multiplies degree l by ``(-1)**l``. A mere permutation of axes mixes the weights of a
    degree from l = 2 on. Raises ValueError where the matrix is not orthogonal.
    """
    bands = round(weights.shape[-1] ** 0.5)
    degrees, _ = degrees_orders(bands)
    if degrees.size != weights.shape[-1]:
        raise ValueError(f"{weights.shape[-1]} weights are not a square number N*N of bands.")
    proper, improper = _split(matrix)
    first, middle, last = _angles(proper)
    parity = np.where(degrees % 2, -1.0, 1.0) if improper else 1.0
    turned: Array = np.asarray(rotate_azimuth(weights.astype(np.float64) * parity, first), dtype=np.float64)
    turned = rotate_y(turned[np.newaxis], np.array([middle]), bands, mirrored=False)[0]
    return np.asarray(rotate_azimuth(turned, last), dtype=np.float64)


def _split(matrix: ArrayLike) -> tuple[Array, bool]:
    """Return the matrix, or its negative where it is improper, and whether it is."""
    found = np.array(matrix, dtype=np.float64)
    if found.shape != (3, 3) or not np.abs(found @ found.T - np.eye(3)).max() < _TOLERANCE:
        raise ValueError(
            f"Invalid axes {found.tolist()}. Should be an orthogonal 3x3 matrix: unit columns at right angles to each other."
        )
    improper = bool(np.linalg.det(found) < 0)
    return (-found if improper else found), improper


def _angles(rotation: Array) -> tuple[float, float, float]:
    """Return the angles, in the order of their turns, about z, y and z whose product is ``rotation``."""
    last = np.arctan2(rotation[1, 2], rotation[0, 2])
    middle = np.arctan2(np.hypot(rotation[0, 2], rotation[1, 2]), rotation[2, 2])
    # Where +z hardly moves, ``last`` is arbitrary: the first angle comes from what the last one leaves, so that
    # their sum holds.
    c, s = np.cos(last), np.sin(last)
    first = np.arctan2(c * rotation[1, 0] - s * rotation[0, 0], c * rotation[1, 1] - s * rotation[0, 1])
    return float(first), float(middle), float(last)
