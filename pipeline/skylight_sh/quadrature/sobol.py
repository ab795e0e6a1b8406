"""Scrambled Sobol sequences of a few dimensions: SciPy's numbers, without the third of a second that its import takes.

Direction numbers: Joe and Kuo 2008, the set "new-joe-kuo-6". Scrambling: Matousek 1998, a random lower triangular matrix of
bits for each dimension, and a shift.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Words = NDArray[np.uint32]

# For each dimension after the first: a primitive polynomial's bits, and the first direction numbers.
_DIRECTIONS = (
    (3, (1,)),
    (7, (1, 3)),
    (11, (1, 3, 1)),
    (13, (1, 1, 1)),
    (19, (1, 1, 3, 3)),
    (25, (1, 3, 5, 13)),
    (37, (1, 1, 5, 5, 17)),
)
MOST = 1 + len(_DIRECTIONS)
_BITS = 30


def scrambled(dimensions: int, count: int, seed: int) -> Array:
    """Return the first ``count`` points in [0, 1), ``(count, dimensions)``; the seed decides the scrambling.

    From 1 to 8 ``dimensions`` (ValueError beyond), and to 2**30 points.

    >>> points = scrambled(2, 4, seed=1)
    >>> np.sort(np.floor(4 * points), axis=0).tolist()  # one in each quarter of each axis
    [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [3.0, 3.0]]
    """
    if not 1 <= dimensions <= MOST:
        raise ValueError(f"Invalid number of dimensions {dimensions}. Should be 1 to {MOST}.")
    # SciPy draws from a generator of its own, spawned by the one it is given.
    (rng,) = np.random.default_rng(seed).spawn(1)
    # Bits from the most significant one down.
    places = np.arange(_BITS - 1, -1, -1, dtype=np.uint32)
    shift = rng.integers(2, size=(dimensions, _BITS), dtype=np.uint32) @ (np.uint32(1) << places[::-1])
    matrices = np.tril(rng.integers(2, size=(dimensions, _BITS, _BITS), dtype=np.uint32))
    matrices[:, np.arange(_BITS), np.arange(_BITS)] = 1
    columns = np.stack([_columns(d) for d in range(dimensions)])
    bits = (columns[:, np.newaxis] >> places[:, np.newaxis]) & np.uint32(1)
    scrambled_bits = (matrices @ bits) & np.uint32(1)
    columns = (scrambled_bits << places[:, np.newaxis]).sum(axis=1, dtype=np.uint32)

    index = np.arange(count, dtype=np.uint32)
    gray = index ^ (index >> np.uint32(1))
    points = np.tile(shift, (count, 1))
    for place in range(max(0, count - 1).bit_length()):
        points[(gray >> np.uint32(place)) & np.uint32(1) == 1] ^= columns[:, place]
    return points * 0.5**_BITS


def _columns(dimension: int) -> Words:
    """Return the direction numbers of a dimension, the first of them the most significant bit alone, ``(30,)``."""
    if dimension == 0:
        found = [1] * _BITS
    else:
        polynomial, first = _DIRECTIONS[dimension - 1]
        degree, found = len(first), list(first)
        for place in range(degree, _BITS):
            value = found[place - degree]
            for k in range(degree):
                if polynomial >> (degree - 1 - k) & 1:
                    value ^= found[place - k - 1] << (k + 1)
            found.append(value)
    return np.array([value << (_BITS - 1 - place) for place, value in enumerate(found)], dtype=np.uint32)
