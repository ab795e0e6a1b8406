"""Glossy reflection by convolution: the light, blurred by a lobe about the mirror direction.

A lobe whose shape hangs on the angle to the mirror direction alone turns reflection into a convolution (Ramamoorthi and
Hanrahan 2002; Sloan, Kautz and Snyder 2002): every degree of the light is multiplied by the lobe's factor, and the result
looked up in the mirror direction. ``reflectance/lobes.py`` has the factors. Where something hides the light, ``weights`` are
those that arrive at the point (a lightmap's transfer matrix gives them), else the sky's.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh.sphere import bands_of, basis, scale_degrees

Array = NDArray[np.float64]


def reflect(views: Array, normals: Array) -> Array:
    """Return the mirror directions of ``views`` about ``normals``, unit vectors ``(..., 3)`` that broadcast.

    Both point away from the surface, and so does the result.

    >>> reflect(np.array([0.6, 0.0, 0.8]), np.array([0.0, 0.0, 1.0])).tolist()
    [-0.6, 0.0, 0.8]
    """
    height = np.sum(views * normals, axis=-1, keepdims=True)
    return np.asarray(2 * height * normals - views)


def radiance(weights: NDArray[np.floating], factors: ArrayLike, reflected: Array, window: ArrayLike = 1.0) -> Array:
    """Return what a lobe reflects towards the eye, ``(..., channels)``: the light's mean under the lobe, in its unit.

    ``weights`` ``(..., channels, N*N)`` are the light's, ``reflected`` mirror directions ``(..., 3)``, which broadcast.
    ``factors`` ``(..., N)`` are the lobe's, or one lobe's of every point (then they broadcast with a channel axis,
    ``(..., 1, N)``), ``window`` those of a window against ringing such as ``sphere.hann_window(N)``. Multiply by the
    surface's specular albedo, its Fresnel factor or whatever the lobe is scaled by. A block of points holds N*N numbers a
    point. Raises ValueError where factors and weights have other bands.

    An even light is seen as it is, whatever the lobe:

    >>> from skylight_sh.reflectance.lobes import cosine_power
    >>> even = np.sqrt(4 * np.pi) * np.array([[3.0, 0.0, 0.0, 0.0]])
    >>> radiance(even, cosine_power(16, 2), np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])).round(6).tolist()
    [[3.0], [3.0]]
    """
    blurred = scale_degrees(weights, np.asarray(factors, dtype=np.float64) * np.asarray(window, dtype=np.float64))
    seen = basis(reflected, bands_of(weights))
    return np.asarray((blurred @ seen[..., np.newaxis])[..., 0])
