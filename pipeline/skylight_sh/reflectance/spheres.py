"""What spherical lights nearby give surfaces, in SH and by integration; nothing hides them.

A sphere of even radiance is seen as a disc, another one from every point, so that its SH weights are those of the point
(``light.spherical_lights``; Mezieres and Paulin, section 3). What a lobe about an axis collects of a disc is integrated here
ring by ring about that axis, without any expansion: the truth that bands are held to.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh import sphere
from skylight_sh.light import spherical_lights

Array = NDArray[np.float64]

_NODES = 48
# Numbers of a block of points held at once.
_BLOCK = 2_000_000


@dataclass(frozen=True)
class Spheres:
    """Lights: ``centres`` ``(lights, 3)`` and ``radii`` ``(lights,)`` in one unit, ``radiance`` ``(lights, channels)``."""

    centres: Array
    radii: Array
    radiance: Array

    def weights(self, points: Array, bands: int) -> Array:
        """Return the SH weights of all lights together at ``points`` ``(p, 3)``: ``(p, channels, N*N)``.

        Raises InsideLightError for a point inside a light.
        """
        out = np.empty((len(points), self.radiance.shape[1], bands * bands))
        for rows in _blocks(len(points), len(self.radii) * bands * bands):
            one = spherical_lights.spheres(self.centres, self.radii, bands, points[rows][:, np.newaxis])
            out[rows] = np.einsum("plw,lc->pcw", one, self.radiance)
        return out


def in_bands(weights: NDArray[np.floating], axes: Array, factors: ArrayLike, window: ArrayLike = 1.0) -> Array:
    """Return what a lobe about ``axes`` ``(p, 3)`` collects of ``weights`` ``(p, channels, M*M)``: ``(p, channels)``.

    ``factors`` ``(N,)`` are the lobe's (``reflectance.lobes``), N at most M, ``window`` those of a window against ringing.
    The clamped cosine's over pi, about the normal, give irradiance / pi: multiply by the albedo.
    """
    known = np.asarray(factors, dtype=np.float64) * np.asarray(window, dtype=np.float64)
    count = known.shape[-1] ** 2
    towards = sphere.scale_degrees(sphere.basis(axes, known.shape[-1]), known)
    return np.asarray(np.einsum("pcw,pw->pc", weights[..., :count], towards))


def integrated(lights: Spheres, points: Array, axes: Array, exponent: float) -> Array:
    """Return what the lobe ``(n+1) / (2 pi) max(0, cos)**n`` about ``axes`` collects, by integration: ``(p, channels)``.

    Of the exponent 1 about the normal it is irradiance / pi. Directions are not cut off at the surface's own horizon, as
    bands do not. Raises InsideLightError for a point inside a light.

    A light straight above that fills half of what an even sky's cosine would collect:

    >>> above = Spheres(np.array([[0.0, 0.0, 2.0]]), np.array([np.sqrt(2.0)]), np.array([[3.0]]))
    >>> up = np.array([[0.0, 0.0, 1.0]])
    >>> integrated(above, np.zeros((1, 3)), up, 1.0).round(6).tolist()
    [[1.5]]
    """
    out = np.empty((len(points), lights.radiance.shape[1]))
    for rows in _blocks(len(points), 2 * _NODES * len(lights.radii)):
        angle, towards = spherical_lights.half_angles(lights.centres, lights.radii, points[rows][:, np.newaxis])
        apart = np.arccos(np.clip(np.einsum("plk,pk->pl", towards, axes[rows]), -1.0, 1.0))
        out[rows] = _collected(angle, apart, exponent) @ lights.radiance
    return out


def _collected(angle: Array, apart: Array, exponent: float) -> Array:
    """Return the integral of the lobe over discs of half-angle ``angle``, their centres ``apart`` from its axis, ``(...)``.

    Rings about the axis lie within the disc (those nearer than ``angle - apart``), or cross it.
    """
    quarter = 0.5 * np.pi
    whole = np.minimum(np.maximum(angle - apart, 0.0), quarter)
    inside = 1.0 - np.cos(whole) ** (exponent + 1)
    low = np.minimum(np.abs(apart - angle), quarter)
    high = np.minimum(np.minimum(apart + angle, 2.0 * np.pi - apart - angle), quarter)
    width = np.maximum(high - low, 0.0)[..., np.newaxis]
    at, areas = sphere.gauss_unit(_NODES)
    # Crossing rings begin and end like a square root: sin u and its derivative smooth that out.
    share = 0.5 * (1.0 + np.sin(np.pi * (at - 0.5)))
    theta = low[..., np.newaxis] + width * share
    steps = width * 0.5 * np.pi * np.cos(np.pi * (at - 0.5)) * areas
    sine = np.sin(theta) * np.sin(apart)[..., np.newaxis]
    cosine = np.cos(angle)[..., np.newaxis] - np.cos(theta) * np.cos(apart)[..., np.newaxis]
    half = np.arccos(np.clip(np.divide(cosine, sine, out=np.ones_like(sine), where=sine > 0.0), -1.0, 1.0))
    lobe = (exponent + 1) / np.pi * np.cos(theta) ** exponent * np.sin(theta)
    return np.asarray(inside + np.sum(lobe * half * steps, axis=-1))


def _blocks(points: int, numbers: int) -> list[slice]:
    step = max(1, _BLOCK // numbers)
    return [slice(start, start + step) for start in range(0, points, step)]
