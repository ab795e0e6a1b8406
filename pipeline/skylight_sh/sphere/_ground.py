"""What lies below the horizon: a mirror of the sky, or a ground that reflects it evenly."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh.formula.harmonics import HORIZONTAL
from skylight_sh.sphere._orders import Harmonics, as_harmonics, check_bands

Array = NDArray[np.float64]


def lower_hemisphere(bands: int) -> Array:
    """Return the zonal weights of radiance 1 below the horizon and 0 above, ``(bands,)``: exactly, for any l.

    By the integral of a Legendre polynomial, (P_{l-1}(0) - P_{l+1}(0)) / (2l+1): half a constant, and odd degrees.

    >>> lower_hemisphere(4).round(4).tolist()
    [1.7725, -1.535, 0.0, 0.5862]
    """
    check_bands(bands)
    out = np.zeros(bands)
    out[0] = math.sqrt(math.pi)
    for l in range(1, bands, 2):
        # Minus the upper half's integral, which for odd l is P_{l-1}(0) / (l+1).
        at_0 = (-1) ** (l // 2) * math.comb(l - 1, l // 2) / 2 ** (l - 1)
        out[l] = -math.sqrt((2 * l + 1) * math.pi) * at_0 / (l + 1)
    return out


def add_ground(weights: Array, albedo: ArrayLike, harmonics: Harmonics | int, *, from_below: ArrayLike = 0.0) -> Array:
    """Add an even ground of ``albedo``, lit by the light above it, to weights that are black below the horizon.

    ``weights`` ``(..., count)`` are those of the ``harmonics``, all N*N for a number of bands; ``albedo`` broadcasts to
    ``(...)``. The ground's radiance is albedo E / pi. Since nothing shines from below, E, the irradiance on the horizontal,
    is the integral of radiance times z: a multiple of the weight l = 1, m = 0, so that the result is exact. Where something
    does, as a sun half set, ``from_below`` ``(...)`` is the integral of radiance times -z below the horizon. Raises
    ValueError for one band, and for an albedo outside [0, 1].

    A white ground below an even sky of radiance 1 is as bright as the sky:

    >>> sky = np.sqrt(np.pi) * np.array([1.0, 0.0, np.sqrt(3) / 2, 0.0])
    >>> (np.abs(add_ground(sky, 1.0, 2)) / np.sqrt(4 * np.pi)).round(6).tolist()
    [1.0, 0.0, 0.0, 0.0]
    """
    share = np.asarray(albedo, dtype=np.float64)
    if not np.all((share >= 0.0) & (share <= 1.0)):
        wrong = float(share[~((share >= 0.0) & (share <= 1.0))].flat[0])
        raise ValueError(f"Invalid albedo {wrong!r}. Should be from 0 to 1.")
    held = as_harmonics(harmonics)
    if held.bands < 2:
        raise ValueError("One band does not tell the irradiance on the ground. Give at least two bands.")
    zonal = np.flatnonzero(held.orders == 0)
    irradiance = HORIZONTAL * weights[..., zonal[1]] + np.asarray(from_below)
    out = np.array(weights, dtype=np.float64)
    ground = share * irradiance / math.pi
    out[..., zonal] += ground[..., np.newaxis] * lower_hemisphere(held.bands)
    return out


def mirror_ground(weights: Array, harmonics: Harmonics | int) -> Array:
    """Return weights of a light that is black below the horizon with its mirror image there.

    Both are ``(..., count)``, those of the ``harmonics``; a number of bands stands for all N*N.

    >>> mirror_ground(np.array([1.0, 0.0, 2.0, 3.0]), 2).tolist()
    [2.0, 0.0, 0.0, 6.0]
    """
    held = as_harmonics(harmonics)
    return np.asarray(weights * (1 + (-1.0) ** (held.degrees + held.orders)))
