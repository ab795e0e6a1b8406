"""The smallest window that leaves an expansion nowhere negative."""

from __future__ import annotations

from functools import lru_cache
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from skylight_sh.sphere._basis import basis, spiral
from skylight_sh.sphere._convolution import clamped_cosine, scale_degrees
from skylight_sh.sphere._orders import Harmonics, Index, bands_of, check_finite
from skylight_sh.sphere._windows import laplacian_window

Array = NDArray[np.float64]

# Smoothings tried before one is bracketed: the least is far below any effect, the greatest leaves the mean.
_LADDER = np.concatenate([[0.0], np.geomspace(1e-9, 1e6, 121)])
# What an evaluation may round, as a fraction of the sum of sizes: kept in hand on both sides.
_ROUNDING = 1e-13
_ROUNDS = 20


def nonnegative_smoothing(weights: NDArray[np.floating], keep: Literal["radiance", "irradiance"] = "radiance") -> Array:
    """Return the least smoothing whose ``laplacian_window`` leaves an expansion nowhere negative.

    ``weights`` are radiance weights ``(..., N*N)``; returns ``(...)``, 0 where nothing is negative as it is. ``keep``
    says what must not be negative: the radiance itself, or its irradiance, for which far less smoothing does. Apply it by
    ``scale_degrees(weights, laplacian_window(N, smoothing))``. One window for all channels takes the largest smoothing and
    is to be checked: the least value need not rise all the way.

    Sloan 2008 gives the window, and Sloan 2017 ("Deringing Spherical Harmonics") the aim: no more smoothing than the
    minimum asks for. The minimum is found on a grid, then to rounding by Newton steps on its local minima; these join the
    grid and the smoothing is bracketed again, until no new minimum is negative. Raises ValueError where the mean is
    negative, or a weight is not finite: no window helps.

    >>> float(nonnegative_smoothing(np.array([1.0, 0.0, 1.0, 0.0])).round(4))
    0.183
    >>> float(nonnegative_smoothing(np.array([1.0, 0.0, 0.5, 0.0])))
    0.0
    """
    bands = bands_of(weights)
    if keep not in {"radiance", "irradiance"}:
        raise ValueError(f"Invalid keep {keep!r}. Should be 'radiance' or 'irradiance'.")
    known = np.asarray(weights, dtype=np.float64)
    check_finite("weight", known)
    if np.any(known[..., 0] < 0):
        raise ValueError(
            f"Invalid mean: weight 0 is {float(known[..., 0].min())!r}. Should be at least 0, as no window changes it; "
            "clamp it, or leave that channel out."
        )
    kept = scale_degrees(known, clamped_cosine(bands)) if keep == "irradiance" else known
    rows = kept.reshape(-1, bands * bands)
    return np.array([_least(row, bands) for row in rows]).reshape(known.shape[:-1])


def minimum(weights: NDArray[np.floating]) -> tuple[Array, Array]:
    """Return the least values ``(...)`` of expansions ``(..., N*N)`` and the unit vectors ``(..., 3)`` where they are.

    A grid finer than the highest degree, and Newton steps from each of its local minima. Raises ValueError for a weight
    that is not finite.

    >>> value, direction = minimum(np.array([1.0, 0.0, 1.0, 0.0]))
    >>> value.round(4).tolist(), np.abs(direction).round(4).tolist()
    (-0.2065, [0.0, 0.0, 1.0])
    """
    bands = bands_of(weights)
    check_finite("weight", weights)
    rows = np.asarray(weights, dtype=np.float64).reshape(-1, bands * bands)
    found = [_minima(row, bands) for row in rows]
    best = [int(np.argmin(values)) for values, _ in found]
    lead = weights.shape[:-1]
    values = np.array([each[0][k] for each, k in zip(found, best, strict=True)]).reshape(lead)
    return values, np.array([each[1][k] for each, k in zip(found, best, strict=True)]).reshape(*lead, 3)


def _least(weights: Array, bands: int) -> float:
    degrees = Harmonics(bands).degrees
    where, _, grid = _grid(bands)
    spare = _ROUNDING * np.abs(weights).sum()
    parts = _parts(weights, grid, bands)
    smoothing = 0.0
    for _ in range(_ROUNDS):
        values, places = _minima(weights * laplacian_window(bands, smoothing)[degrees], bands)
        low = values < 0
        if not low.any():
            return smoothing
        parts = np.concatenate([parts, _parts(weights, basis(places[low], bands), bands)])
        smoothing = _bracket(parts, bands, spare)
    raise RuntimeError(f"No smoothing found in {_ROUNDS} rounds for {where.shape[0]} directions.")


def _parts(weights: Array, rows: Array, bands: int) -> Array:
    """Return what each degree adds at each direction, ``(n, N)``: any window is then one small product."""
    return np.asarray(np.add.reduceat(rows * weights, np.arange(bands) ** 2, axis=1))


def _bracket(parts: Array, bands: int, spare: float) -> float:
    """Return the least smoothing for which all of ``parts (n, N)`` sum to at least ``spare``, or to the mean."""

    def holds(smoothing: float) -> bool:
        return bool((parts @ laplacian_window(bands, smoothing)).min() >= spare)

    # The least value need not rise all the way with the smoothing: climb to the first that holds.
    above = next((k for k, smoothing in enumerate(_LADDER) if holds(float(smoothing))), None)
    if above is None:
        # Nothing but a mean of 0, or one that rounding hides.
        return float("inf")
    if above == 0:
        return 0.0
    low, high = float(_LADDER[above - 1]), float(_LADDER[above])
    while high - low > 1e-12 * high:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if holds(middle) else (middle, high)
    return high


@lru_cache(maxsize=4)
def _grid(bands: int) -> tuple[Array, Index, Array]:
    """Return directions of a spiral grid, six or more a wavelength, each one's eight neighbours, and the basis there."""
    # Tables are evaluated with NumPy alone (skylight_sh.runtime), and this package is part of that.
    from scipy.spatial import cKDTree

    where = spiral(max(200, 16 * bands * bands))
    neighbours: Index = np.asarray(cKDTree(where).query(where, k=9)[1], dtype=np.int64)
    return where, neighbours[:, 1:], basis(where, bands)


def _minima(weights: Array, bands: int) -> tuple[Array, Array]:
    """Return the local minima of one expansion, values ``(k,)`` and unit vectors ``(k, 3)``."""
    where, neighbours, rows = _grid(bands)
    values = rows @ weights
    start = values <= values[neighbours].min(axis=1)
    points = where[start]
    # A quadratic through nine points of the tangent plane: large steps first, for the points that start far off.
    for fraction in (1.0, 1.0, 1.0, 0.2, 0.04, 0.008):
        points = _step(weights, points, 0.25 * fraction / bands, bands)
    return basis(points, bands) @ weights, points


def _step(weights: Array, points: Array, spacing: float, bands: int) -> Array:
    """Move points towards the least of the quadratic through their surroundings, never upwards."""
    side = np.where(np.abs(points[:, 2:]) < 0.9, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0])
    u = np.cross(side, points)
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    v = np.cross(points, u)
    offsets = spacing * np.array([(a, b) for a in (-1, 0, 1) for b in (-1, 0, 1)])

    def moved(shift: Array) -> Array:
        found = points[:, np.newaxis] + shift[..., :1] * u[:, np.newaxis] + shift[..., 1:] * v[:, np.newaxis]
        return np.asarray(found / np.linalg.norm(found, axis=-1, keepdims=True))

    f = (basis(moved(offsets[np.newaxis]), bands) @ weights).reshape(-1, 3, 3)
    gradient = np.stack([f[:, 2, 1] - f[:, 0, 1], f[:, 1, 2] - f[:, 1, 0]], axis=-1) / (2 * spacing)
    xx = (f[:, 2, 1] - 2 * f[:, 1, 1] + f[:, 0, 1]) / spacing**2
    yy = (f[:, 1, 2] - 2 * f[:, 1, 1] + f[:, 1, 0]) / spacing**2
    xy = (f[:, 2, 2] - f[:, 2, 0] - f[:, 0, 2] + f[:, 0, 0]) / (4 * spacing**2)
    curvatures, axes = np.linalg.eigh(np.stack([xx, xy, xy, yy], axis=-1).reshape(-1, 2, 2))
    # Downhill along either axis, whatever its curvature's sign; a valley's floor has none, and no slope to speak of.
    sizes = np.abs(curvatures)
    sizes = np.maximum(sizes, np.maximum(1e-3 * sizes.max(axis=1, keepdims=True), 1e-300))
    slopes = (gradient[:, np.newaxis] @ axes)[:, 0]
    shift = -(axes @ (slopes / sizes)[..., np.newaxis])[..., 0]
    # As far as the stencil reached, a quadratic is to be trusted; beyond, it is a direction.
    length = np.maximum(np.linalg.norm(shift, axis=1, keepdims=True), 1e-300)
    shift *= np.minimum(1.0, 2 * spacing / length)
    tried = np.concatenate([moved(offsets[np.newaxis]), moved(shift[:, np.newaxis])], axis=1)
    values = np.concatenate([f.reshape(-1, 9), basis(tried[:, 9:], bands) @ weights], axis=1)
    return np.asarray(np.take_along_axis(tried, values.argmin(axis=1)[:, np.newaxis, np.newaxis], axis=1)[:, 0])
