"""Convolution with zonal kernels: factors a degree, irradiance, and the two-band shortcuts of lightmaps."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh.sphere._orders import Harmonics, bands_of, check_bands

Array = NDArray[np.float64]


def clamped_cosine(bands: int) -> Array:
    """Return the factors ``A_l`` by which a clamped cosine turns radiance weights into irradiance weights, ``(bands,)``.

    pi, 2 pi / 3, pi / 4, 0, -pi / 24, ..: for l = 0, 1 and even l; other odd l carry nothing (Ramamoorthi and Hanrahan
    2001, eq. 8). The irradiance towards n is the sum of ``A_l c_lm y_lm(n)``, not divided by pi.

    >>> clamped_cosine(4).round(4).tolist()
    [3.1416, 2.0944, 0.7854, 0.0]
    """
    check_bands(bands)
    out = np.zeros(bands)
    for l in range(bands):
        if l == 1:
            out[l] = 2 * math.pi / 3
        elif l % 2 == 0:
            sign = -1.0 if l % 4 == 0 else 1.0
            # Integers of any length, divided once: comb alone overflows a float from l = 1030 on.
            out[l] = sign * 2 * math.pi / ((l + 2) * (l - 1)) * (math.comb(l, l // 2) / 2**l)
    return out


def scale_degrees(weights: NDArray[np.floating], factors: ArrayLike) -> Array:
    """Multiply every degree of ``weights (..., N*N)`` by its factor, ``factors (..., N)``: windows and kernels.

    Leading axes broadcast. Raises ValueError where the number of factors is not N.

    >>> scale_degrees(np.ones(4), [1.0, 0.5]).tolist()
    [1.0, 0.5, 0.5, 0.5]
    """
    bands = bands_of(weights)
    known = np.asarray(factors, dtype=np.float64)
    if known.ndim == 0 or known.shape[-1] != bands:
        raise ValueError(f"Invalid factors of shape {known.shape}. Should be one a degree, shape (..., {bands}).")
    return np.asarray(weights * known[..., Harmonics(bands).degrees], dtype=np.float64)


def convolve(weights: NDArray[np.floating], kernel: ArrayLike) -> Array:
    """Convolve ``weights (..., N*N)`` with a kernel symmetric about its axis, ``kernel (..., N)`` its weights ``h_l0``.

    The result at n is the integral of the function times the kernel turned from +z to n: ``sqrt(4 pi / (2l+1)) h_l0
    c_lm`` (Funk and Hecke; Ramamoorthi and Hanrahan 2001, eq. 5). Raises ValueError as ``scale_degrees`` does.

    A kernel that is all at one point changes nothing:

    >>> convolve(np.array([2.0, 0.0, 1.0, 0.0]), np.sqrt([1 / (4 * np.pi), 3 / (4 * np.pi)])).round(6).tolist()
    [2.0, 0.0, 1.0, 0.0]
    """
    known = np.asarray(kernel, dtype=np.float64)
    return scale_degrees(weights, known * np.sqrt(4 * np.pi / (2 * np.arange(known.shape[-1] if known.ndim else 1) + 1)))


def irradiance(weights: NDArray[np.floating]) -> Array:
    """Return irradiance weights of radiance weights, both ``(..., N*N)``; not divided by pi. See ``clamped_cosine``.

    >>> irradiance(np.array([1.0, 0.0, 1.0, 0.0])).round(4).tolist()
    [3.1416, 0.0, 2.0944, 0.0]
    """
    return scale_degrees(weights, clamped_cosine(bands_of(weights)))


def packed_irradiance(weights: NDArray[np.floating]) -> Array:
    """Return the packed two-band irradiance ``(..., 4)``: a constant, and factors of y, z and x in that order.

    ``weights`` are radiance weights ``(..., N*N)``, N >= 2; bands beyond the second are left out. ``packed[0] + y
    packed[1] + z packed[2] + x packed[3]`` is the irradiance towards (x, y, z) within two bands, not divided by pi: kernel,
    basis constants and all, 1/4 and 1/2 times the radiance's integrals against 1 and (y, z, x) (O'Donnell 2018,
    "Precomputed Global Illumination in Frostbite"). Raises ValueError where N < 2.

    >>> packed_irradiance(np.array([1.0, 0.0, 1.0, 0.0])).round(4).tolist()
    [0.8862, 0.0, 1.0233, 0.0]
    """
    if bands_of(weights) < 2:
        raise ValueError("Invalid number of bands 1. Should be at least 2 for the packed irradiance.")
    constants = np.array([np.sqrt(np.pi) / 2, *[np.sqrt(np.pi / 3)] * 3])
    return np.asarray(weights[..., :4] * constants, dtype=np.float64)


def nonnegative_irradiance(packed: NDArray[np.floating], normals: Array) -> Array:
    """Evaluate a packed two-band irradiance so that it is never negative.

    ``packed`` is ``(..., 4)`` as ``packed_irradiance`` returns it, ``normals`` unit vectors ``(n, 3)``; returns
    ``(..., n)``. Normals ``(..., n, 3)`` broadcast against the leading axes. Raises ValueError for another shape.

    With ``R0 = packed[0]``, ``R1`` half the vector part, ``r = |R1| / R0``, ``q = (1 + cos(R1, n)) / 2``: ``R0 (a + (1 - a)
    (p + 1) q**p)``, p = 1 + 2r, a = (1 - r) / (1 + r) (Hazel 2017, "Reconstructing Diffuse Lighting from Spherical Harmonic
    Data"). Its mean over the normals is R0 exactly, to first order in r it is the linear sum, and a light from one
    direction (r = 1) peaks at its true 4 R0. No radiance has r > 1; rounding and ringing may, and are taken as 1. A
    constant that is not positive has no such reconstruction: 0 is returned there.

    The linear sum would be -0.1 towards -z:

    >>> up_and_down = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
    >>> nonnegative_irradiance(np.array([1.0, 0.0, 1.1, 0.0]), up_and_down).round(4).tolist()
    [2.4903, 0.2903]
    """
    known = np.asarray(packed, dtype=np.float64)
    if known.ndim == 0 or known.shape[-1] != 4:
        raise ValueError(f"Invalid packed irradiance of shape {known.shape}. Should be (..., 4).")
    constant = np.maximum(known[..., :1], 0.0)
    # y, z, x of the packed order.
    towards = np.asarray(normals, dtype=np.float64)[..., [1, 2, 0]].swapaxes(-1, -2)
    along = known[..., 1:] @ towards if towards.ndim == 2 else (known[..., np.newaxis, 1:] @ towards)[..., 0, :]
    length = np.linalg.norm(known[..., 1:], axis=-1, keepdims=True)
    cosine = np.divide(along, length, out=np.zeros_like(along), where=length > 0)
    ratio = np.divide(0.5 * length, constant, out=np.zeros_like(length), where=constant > 0)
    ratio = np.minimum(ratio, 1.0)
    floor = (1 - ratio) / (1 + ratio)
    power = 1 + 2 * ratio
    linear = np.clip(0.5 * (1 + cosine), 0.0, 1.0)
    return np.asarray(constant * (floor + (1 - floor) * (power + 1) * linear**power))


def dot(one: NDArray[np.floating], other: NDArray[np.floating]) -> Array:
    """Integrate the product of two expansions over the sphere: ``(..., N1*N1)`` and ``(..., N2*N2)`` -> ``(...)``.

    The basis is orthonormal, so bands that only one of them has add nothing (Green 2003, eq. 7). Leading axes broadcast.

    >>> float(dot(np.ones(4), np.ones(9)))
    4.0
    """
    size = min(bands_of(one), bands_of(other)) ** 2
    return np.asarray(np.einsum("...i,...i->...", one[..., :size], other[..., :size]), dtype=np.float64)
