"""General rotations and changes of axes: SH weights under any orthogonal 3x3 matrix, degree by degree."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh.sphere._orders import bands_of, check_bands

Array = NDArray[np.float64]

# How far from orthogonal a matrix may be: the rounding of one typed with seven digits.
_TOLERANCE = 1e-6
# Degree 1 of the basis is y, z, x.
_ORDER = np.array([1, 2, 0])
# The recurrence multiplies rounding by about 1.2 a degree: 2e-14 at l = 30, 3e-11 at l = 63. Made orthogonal at every
# degree from this one on, blocks stay within 1e-14 of each other's products at l = 63.
_POLISHED = 6


def rotate(weights: NDArray[np.floating], matrix: ArrayLike) -> Array:
    """Turn environments by rotation matrices.

    ``weights`` has shape ``(..., N*N)`` and ``matrix`` ``(..., 3, 3)``, a right-handed rotation that takes a direction
    to its new place; the leading axes broadcast. Returns float64 of the broadcast shape, for which
    ``evaluate(result, directions @ matrix.T)`` equals ``evaluate(weights, directions)``.

    Raises ValueError where the weights fill no bands, or where a matrix is not orthogonal to 1e-6 or reflects; within
    that, the nearest orthogonal matrix is meant. Source: see ``rotation_blocks``.

    A quarter turn about z takes x to y:

    >>> turned = rotate(np.array([0.0, 0.0, 0.0, 1.0]), [[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    >>> np.abs(turned).round(6).tolist()
    [0.0, 1.0, 0.0, 0.0]
    """
    proper = _nearest_orthogonal(matrix)
    determinant = np.linalg.det(proper)
    if np.any(determinant < 0):
        worst = np.asarray(matrix, dtype=np.float64)[determinant < 0].reshape(-1, 3, 3)[0]
        raise ValueError(
            f"Invalid rotation {worst.tolist()} of determinant -1. Should be +1: negate a column, or call change_axes, "
            "which reflects."
        )
    return _act(weights, proper)


def change_axes(weights: NDArray[np.floating], matrix: ArrayLike) -> NDArray[np.float64]:
    """Return the SH weights of the same environment seen in other axes.

    ``matrix`` is orthogonal, 3x3, and takes a direction in the old axes to the same direction in the new ones; its
    columns are the old axes' places in the new. ``weights`` has shape ``(..., N*N)``, any N; so has the result, for which
    ``evaluate(result, directions @ matrix.T)`` equals ``evaluate(weights, directions)``. Matrices ``(..., 3, 3)``
    broadcast against the leading axes.

    Numerically the same as ``rotate``, reflections included. A mere permutation of axes mixes the weights of a
    degree from l = 2 on. Raises ValueError where the matrix is not orthogonal.

    An engine whose y is up, and -z our y, sees in y what we see in z:

    >>> seen = change_axes(np.array([0.0, 0.0, 1.0, 0.0]), [[1, 0, 0], [0, 0, 1], [0, -1, 0]])
    >>> np.abs(seen).round(6).tolist()
    [0.0, 1.0, 0.0, 0.0]
    """
    return _act(weights, _nearest_orthogonal(matrix))


def rotation_blocks(matrix: ArrayLike, bands: int) -> list[Array]:
    """Return the matrices by which an orthogonal 3x3 matrix acts on the SH weights of each degree.

    ``matrix`` has shape ``(..., 3, 3)``; item l of the result has shape ``(..., 2l+1, 2l+1)``, is orthogonal, and takes
    the weights of orders -l..l to those of the turned environment. A reflection is as good as a rotation.

    The recurrence of Ivanic and Ruedenberg (J. Phys. Chem. 1996, 100, 6342, tables 1 and 2) with their corrections
    (J. Phys. Chem. A 1998, 102, 9099): degree l is the highest part of the product of degrees 1 and l - 1. It needs no
    angles, so no rotation is special to it. Raises ValueError as ``rotate`` does, but for reflections.

    >>> [block.shape for block in rotation_blocks(np.eye(3), 3)]
    [(1, 1), (3, 3), (5, 5)]
    """
    check_bands(bands)
    return list(_blocks(_nearest_orthogonal(matrix), bands))


def _nearest_orthogonal(matrix: ArrayLike) -> Array:
    """Return the orthogonal matrices nearest to ``matrix``, both ``(..., 3, 3)``.

    Raises ValueError where one is further from orthogonal than 1e-6, or not 3x3.
    """
    found = np.array(matrix, dtype=np.float64)
    if found.shape[-2:] != (3, 3):
        raise ValueError(f"Invalid axes of shape {found.shape}. Should be an orthogonal 3x3 matrix, shape (..., 3, 3).")
    transposed = found.swapaxes(-1, -2)
    excess = np.abs(found @ transposed - np.eye(3)).max(axis=(-1, -2))
    # Written so that NaN fails too.
    wrong = ~(excess < _TOLERANCE)
    if np.any(wrong):
        worst = found[wrong].reshape(-1, 3, 3)[0]
        raise ValueError(
            f"Invalid axes {worst.tolist()}. Should be an orthogonal 3x3 matrix: unit columns at right angles to each other"
            "; divide each column by its length, or take u @ vt of its singular value decomposition."
        )
    # 1e-6 from orthogonal becomes 1e-12, then 1e-24. The recurrence would amplify what is left.
    return _polish(_polish(found))


def _act(weights: NDArray[np.floating], matrix: Array) -> Array:
    """Act on ``weights (..., N*N)`` with orthogonal ``matrix (..., 3, 3)`` as ``_nearest_orthogonal`` returned it."""
    bands = bands_of(weights)
    source = weights.astype(np.float64)
    out = np.empty((*np.broadcast_shapes(source.shape[:-1], matrix.shape[:-2]), bands * bands))
    for l, block in enumerate(_blocks(matrix, bands)):
        part = source[..., l * l : (l + 1) ** 2]
        # One matrix and many weights is one product of matrices.
        out[..., l * l : (l + 1) ** 2] = part @ block.T if block.ndim == 2 else (block @ part[..., np.newaxis])[..., 0]
    return out


def _blocks(matrix: Array, bands: int) -> Iterator[Array]:
    """Yield degree after degree: no more than two are held, however many matrices there are."""
    yield np.ones((*matrix.shape[:-2], 1, 1))
    first = matrix[..., _ORDER[:, np.newaxis], _ORDER]
    block = first
    for l in range(1, bands):
        block = first if l == 1 else _next(first, block, l)
        yield block


def _next(first: Array, last: Array, l: int) -> Array:
    """Degree l from degrees 1 and l - 1; rows and columns run over the orders from the least up."""
    size = 2 * l - 1
    # The papers' P_i, stacked over i = -1, 0, 1: products with column n of degree l, which needs both ends of
    # degree l - 1 where |n| = l.
    stacked = np.empty((*last.shape[:-2], 3 * size, size + 2))
    for i in range(3):
        down, level, up = (first[..., i, k, np.newaxis, np.newaxis] for k in range(3))
        rows = stacked[..., i * size : (i + 1) * size, :]
        rows[..., 1:-1] = level * last
        rows[..., -1:] = up * last[..., -1:] - down * last[..., :1]
        rows[..., :1] = up * last[..., :1] + down * last[..., -1:]
    coupling, divisor = _coupling(l)
    block: Array = (coupling @ stacked) / divisor
    return block if l < _POLISHED else _polish(block)


def _polish(matrix: Array) -> Array:
    """Newton and Schulz: a step squares a matrix's distance from the nearest orthogonal one."""
    size = matrix.shape[-1]
    return matrix @ (1.5 * np.eye(size) - 0.5 * (matrix.swapaxes(-1, -2) @ matrix))


@lru_cache(maxsize=128)
def _coupling(l: int) -> tuple[Array, Array]:
    """Rows of u U + v V + w W over the stacked P_i without their common divisor, and that divisor for every column."""
    size = 2 * l - 1
    out = np.zeros((2 * l + 1, 3, size))
    for m in range(-l, l + 1):
        row = out[m + l]
        k, sign = abs(m), 1 if m > 0 else -1
        if k < l:
            row[1, m + l - 1] = np.sqrt((l + m) * (l - m))
        if m == 0:
            v = -0.5 * np.sqrt(2.0 * (l - 1) * l)
            row[2, 1 + l - 1] += v
            row[0, -1 + l - 1] += v
            continue
        # |m| - 1 with the sign of m for i = +1, with the other one for i = -1. At |m| = 1 both are order 0: one of
        # them is absent and the other counts sqrt 2.
        v = 0.5 * np.sqrt((l + k - 1.0) * (l + k))
        if k > 1 or m > 0:
            row[2, sign * (k - 1) + l - 1] += v * (np.sqrt(2.0) if k == 1 else 1.0)
        if k > 1 or m < 0:
            row[0, -sign * (k - 1) + l - 1] -= sign * v * (np.sqrt(2.0) if k == 1 else 1.0)
        if k < l - 1:
            w = -0.5 * np.sqrt((l - k - 1.0) * (l - k))
            row[2, sign * (k + 1) + l - 1] += w
            row[0, -sign * (k + 1) + l - 1] += sign * w
    n = np.arange(-l, l + 1)
    divisor = np.sqrt(np.where(np.abs(n) == l, 2.0 * l * (2 * l - 1), (l + n) * (l - n)))
    return out.reshape(2 * l + 1, 3 * size), divisor
