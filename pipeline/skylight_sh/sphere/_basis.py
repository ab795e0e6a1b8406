"""Real orthonormal spherical harmonics without the Condon-Shortley sign.

``y_lm = Pbar_lm(cos theta) * cos(m phi)`` for m >= 0 and ``Pbar_l|m| * sin(|m| phi)`` for m < 0, where
``Pbar`` carries the whole normalisation: the integral of ``y_lm**2`` over the sphere is 1. z is up,
theta is the angle from +z, phi runs from +x towards +y.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh.formula.harmonics import CONSTANT, ahead, behind, diagonal
from skylight_sh.sphere._orders import Harmonics, as_harmonics, bands_of, check_bands

Array = NDArray[np.float64]

# Of the square of a length.
_UNIT = 2e-6


def legendre(cos_theta: Array, sin_theta: Array, bands: int) -> Array:
    """Evaluate the normalised associated Legendre factors ``Pbar_lm`` for all l < bands, 0 <= m <= l.

    ``cos_theta`` and ``sin_theta`` have one shape ``(...)``; the sine is asked for because it is lost
    near the poles when derived from the cosine. Returns ``(N(N+1)/2, ...)``, ordered by l, then m.

    The recurrence in l at fixed m (Holmes and Featherstone 2002, eq. 11) is forward stable; see
    ``tests/test_sphere.py`` for its error against mpmath.

    >>> legendre(np.array(1.0), np.array(0.0), 2).round(4).tolist()
    [0.2821, 0.4886, 0.0]
    """
    check_bands(bands)
    cos_theta, sin_theta = np.broadcast_arrays(cos_theta, sin_theta)
    rows = np.empty((bands * (bands + 1) // 2, *cos_theta.shape))
    rows[0] = CONSTANT
    m = np.arange(bands).reshape(-1, *(1 for _ in cos_theta.shape))
    for l in range(1, bands):
        # All orders of a degree at once: the recurrence in l needs m < l, the diagonal starts it.
        low = m[:l]
        a = ahead(l, low)
        now = rows[_row(l, 0) : _row(l, l)]
        np.multiply(a * cos_theta, rows[_row(l - 1, 0) : _row(l - 1, l)], out=now)
        if l > 1:
            low = m[: l - 1]
            b = behind(l, low)
            now[:-1] -= b * rows[_row(l - 2, 0) : _row(l - 2, l - 1)]
        rows[_row(l, l)] = rows[_row(l - 1, l - 1)] * (diagonal(l) * sin_theta)
    return rows


def basis(directions: Array, harmonics: Harmonics | int) -> Array:
    """Evaluate the SH basis at unit vectors.

    ``directions`` has shape ``(..., 3)``. Returns ``(..., count)``, the ``harmonics`` in flat order; a number of bands
    stands for all N*N. Raises ValueError where a length is not 1 to a millionth.

    >>> basis(np.array([0.0, 0.0, 1.0]), 2).round(4).tolist()
    [0.2821, 0.0, 0.4886, 0.0]
    >>> basis(np.array([0.0, 0.0, 1.0]), Harmonics.even(2)).round(4).tolist()
    [0.2821, 0.4886, 0.0]
    """
    held = as_harmonics(harmonics)
    x, y, z = np.moveaxis(np.asarray(directions, dtype=np.float64), -1, 0)
    square = x * x + y * y + z * z
    if not np.all(np.abs(square - 1.0) < _UNIT):
        length = float(np.sqrt(square[~(np.abs(square - 1.0) < _UNIT)].flat[0]))
        raise ValueError(f"Invalid direction of length {length!r}. Should be a unit vector: divide it by its length.")
    factors = legendre(z, np.hypot(x, y), held.bands)
    phi = np.arctan2(y, x)
    out = np.empty((*x.shape, held.count))
    waves = {m: np.cos(m * phi) if m >= 0 else np.sin(-m * phi) for m in set(held.orders.tolist())}
    for k, (row, m) in enumerate(zip(held.triangle.tolist(), held.orders.tolist(), strict=True)):
        out[..., k] = factors[row] * waves[m]
    return out


def spiral(count: int) -> Array:
    """Return ``count`` unit vectors ``(count, 3)``, spread evenly over the sphere by the golden angle.

    >>> spiral(4)[:, 2].tolist()
    [0.75, 0.25, -0.25, -0.75]
    """
    if count < 1:
        raise ValueError(f"Invalid count {count!r}. Should be at least 1.")
    k = np.arange(count) + 0.5
    z, phi = 1.0 - 2.0 * k / count, np.pi * (1.0 + np.sqrt(5.0)) * k
    flat = np.sqrt((1.0 - z) * (1.0 + z))
    return np.stack([flat * np.cos(phi), flat * np.sin(phi), z], axis=-1)


def evaluate(weights: NDArray[np.floating], directions: Array) -> Array:
    """Sum an SH expansion: ``weights`` of shape ``(..., N*N)`` at ``directions`` of shape ``(n, 3)`` -> ``(..., n)``.

    >>> evaluate(np.array([np.sqrt(4 * np.pi)]), np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])).round(6).tolist()
    [1.0, 1.0]
    """
    return np.asarray(weights @ basis(directions, bands_of(weights)).T)


def _row(degree: int, order: int) -> int:
    return degree * (degree + 1) // 2 + order
