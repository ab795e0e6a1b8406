"""Rotations of SH weights about the zenith (eq. 4 of the paper), about the y axis, and by ZYZ angles."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh import runtime
from skylight_sh.sphere._orders import Harmonics, Index, bands_of, check_finite

Array = NDArray[np.float64]


def rotate_azimuth(weights: NDArray[np.floating], azimuth: NDArray[np.floating] | float) -> NDArray[np.floating]:
    """Turn an environment by ``azimuth`` radians about +z, from +x towards +y (Habel et al. 2008, eq. 4).

    ``weights`` has shape ``(..., N*N)`` and ``azimuth`` broadcasts against ``(...)``. Exact but for
    rounding; the result keeps the dtype of ``weights``, whole numbers becoming float64. Raises ValueError for an azimuth
    that is not finite.

    >>> np.abs(rotate_azimuth(np.array([0.0, 0.0, 0.0, 1.0]), np.pi / 2)).round(6).tolist()
    [0.0, 1.0, 0.0, 0.0]
    """
    bands_of(weights)
    if not np.issubdtype(weights.dtype, np.floating):
        weights = weights.astype(np.float64)
    turn = np.asarray(azimuth, dtype=np.float64)
    check_finite("azimuth", turn)
    return runtime.rotate_azimuth(weights, turn)


def rotate_y(weights: Array, angles: Array, harmonics: Harmonics) -> Array:
    """Turn environments about +y, from +z towards +x, each by its own angle in radians.

    ``angles`` has shape ``(g,)`` and ``weights`` of the ``harmonics`` ``(g, ..., count)``; so has the result. About y the
    orders m >= 0 and m < 0 do not mix, so a function even in y stays so.

    >>> np.abs(rotate_y(np.array([[0.0, 1.0, 0.0]]), np.array([np.pi / 2]), Harmonics.even(2))).round(6).tolist()
    [[0.0, 0.0, 1.0]]
    """
    angles = np.asarray(angles, dtype=np.float64)
    out = np.empty(weights.shape)
    for l, first, index in _blocks(harmonics):
        turn = _turn_y(l, first, angles)
        part = weights[..., index].reshape(angles.size, -1, index.size)
        out[..., index] = (part @ turn.swapaxes(1, 2)).reshape(*weights.shape[:-1], index.size)
    return out


def rotate_zyz(weights: NDArray[np.floating], first: ArrayLike, middle: ArrayLike, last: ArrayLike) -> Array:
    """Turn environments by ``first`` radians about +z, then ``middle`` about +y, then ``last`` about +z, all fixed axes.

    ``weights`` has shape ``(..., N*N)`` and the angles broadcast against ``(...)``; so has the result, float64. Exact
    but for rounding, and the same as ``rotate(weights, zyz_matrix(first, middle, last))``. In axes that turn along, the
    angles read alpha = last, beta = middle, gamma = first (Green 2003, "Rotating Spherical Harmonics").

    From z to x, and on to y:

    >>> np.abs(rotate_zyz(np.array([0.0, 0.0, 1.0, 0.0]), 0.0, np.pi / 2, np.pi / 2)).round(6).tolist()
    [0.0, 1.0, 0.0, 0.0]
    """
    held = Harmonics(bands_of(weights))
    lead = np.broadcast_shapes(weights.shape[:-1], np.shape(first), np.shape(middle), np.shape(last))
    source = np.broadcast_to(weights.astype(np.float64), (*lead, held.count))
    turned = np.asarray(rotate_azimuth(source, np.asarray(first, dtype=np.float64)), dtype=np.float64)
    angles = np.asarray(middle, dtype=np.float64)
    if angles.ndim == 0:
        turned = rotate_y(turned[np.newaxis], angles[np.newaxis], held)[0]
    else:
        every = np.broadcast_to(angles, lead).reshape(-1)
        turned = rotate_y(turned.reshape(every.size, -1), every, held).reshape(*lead, -1)
    return np.asarray(rotate_azimuth(turned, np.asarray(last, dtype=np.float64)), dtype=np.float64)


def zyz_matrix(first: ArrayLike, middle: ArrayLike, last: ArrayLike) -> Array:
    """Return the rotation matrices ``(..., 3, 3)`` of ``rotate_zyz``; the angles, in radians, broadcast to ``(...)``.

    >>> np.abs(zyz_matrix(0.0, np.pi / 2, np.pi / 2) @ [0.0, 0.0, 1.0]).round(6).tolist()
    [0.0, 1.0, 0.0]
    """
    a, b, c = np.broadcast_arrays(*(np.asarray(angle, dtype=np.float64) for angle in (first, middle, last)))
    return _about_z(c) @ _about_y(b) @ _about_z(a)


def _about_z(angle: Array) -> Array:
    c, s, zero, one = np.cos(angle), np.sin(angle), np.zeros_like(angle), np.ones_like(angle)
    return np.stack([c, -s, zero, s, c, zero, zero, zero, one], axis=-1).reshape(*angle.shape, 3, 3)


def _about_y(angle: Array) -> Array:
    c, s, zero, one = np.cos(angle), np.sin(angle), np.zeros_like(angle), np.ones_like(angle)
    return np.stack([c, zero, s, zero, one, zero, -s, zero, c], axis=-1).reshape(*angle.shape, 3, 3)


@lru_cache(maxsize=32)
def _blocks(harmonics: Harmonics) -> list[tuple[int, int, Index]]:
    """Degree, least |m| and the places of |m| = least..l in flat order, for all orders that mix."""
    degrees, orders = harmonics.degrees, harmonics.orders
    found = []
    for l in range(harmonics.bands):
        cosines, sines = (np.flatnonzero((degrees == l) & part) for part in (orders >= 0, orders < 0))
        # Orders fall from -1 to -l, as |m| rises.
        found += [(l, first, index) for first, index in ((0, cosines), (1, sines[::-1])) if index.size]
    return found


def _turn_y(l: int, first: int, angles: Array) -> Array:
    """Matrices ``(g, n, n)`` acting on the orders |m| = first..l of degree l.

    The generator is tridiagonal with integer eigenvalues, known exactly; its eigenvectors are free of the angle
    and give every matrix at once (Feng, Wang, Yang and Jin 2015, for Wigner's d), without a recurrence in l.
    """
    vectors = generator_vectors(l, first)
    size = l + 1 - first
    turns = np.arange(1 - size, size, 2) * angles[:, np.newaxis]
    even = (vectors * np.cos(turns)[:, np.newaxis, :]) @ vectors.T
    odd = (vectors * np.sin(turns)[:, np.newaxis, :]) @ vectors.T
    # Re(i**d * (even - i*odd)) for d = m - m' cycles through even, odd, -even, -odd.
    phase = np.subtract.outer(np.arange(size), np.arange(size)) % 4
    return np.choose(phase, [even, odd, -even, -odd])


@lru_cache(maxsize=512)
def generator_vectors(l: int, first: int) -> Array:
    """Return the eigenvectors of the turn about y at degree l, for orders |m| = first..l: columns, eigenvalues rising by 2.

    With ``first`` = 0 these are the orders m >= 0 and the eigenvalues -l..l. Each column's sign is free.

    >>> np.abs(generator_vectors(1, 0)).round(4).tolist()
    [[0.7071, 0.7071], [0.7071, 0.7071]]
    """
    m = np.arange(first, l)
    off = 0.5 * np.sqrt((l - m) * (l + m + 1.0)) * np.where(m == 0, np.sqrt(2.0), 1.0)
    vectors: Array = np.linalg.eigh(np.diag(off, 1) + np.diag(off, -1))[1]
    vectors.setflags(write=False)
    return vectors
