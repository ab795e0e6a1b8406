"""What hides part of an environment: a horizon of mountains and buildings, clouds of their own colour."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh.sphere._basis import basis
from skylight_sh.sphere._gauss import gauss_unit
from skylight_sh.sphere._orders import bands_of, check_bands, check_finite
from skylight_sh.sphere._product import product

Array = NDArray[np.float64]

# Nodes of a Gauss rule beyond those an arc's waves need: rounding is then all that is left.
_SPARE = 10


def horizon(elevations: ArrayLike, bands: int) -> Array:
    """Return the weights ``(N*N,)`` of a visibility mask: 1 above a skyline, 0 below.

    ``elevations`` ``(n,)``, radians in [-pi/2, pi/2], are the skyline's at the azimuths 2 pi k / n, from x towards y,
    joined by straight lines; one number is a level horizon. Each piece is integrated by Gauss and Legendre in azimuth and
    in polar angle from the zenith to the skyline, with nodes for the highest band: to rounding. ``multiplication`` of the
    mask is the transfer matrix of Green 2003, eq. 8. Raises ValueError for an elevation that is not finite or out of range.

    >>> horizon(0.0, 2).round(4).tolist()
    [1.7725, 0.0, 1.535, 0.0]
    """
    check_bands(bands)
    corners = np.atleast_1d(np.asarray(elevations, dtype=np.float64))
    if corners.ndim != 1 or not corners.size:
        raise ValueError(f"elevations: one row of angles is needed, got the shape {corners.shape}.")
    bad = np.flatnonzero(~(np.abs(corners) <= np.pi / 2))
    if bad.size:
        raise ValueError(
            f"elevations[{bad[0]}]: {corners[bad[0]]:g} lies outside [-pi/2, pi/2]. Give radians above the horizon."
        )
    width = 2 * np.pi / corners.size
    along, along_areas = gauss_unit(math.ceil(bands * width / 2) + _SPARE)
    polar, polar_areas = gauss_unit(2 * bands + _SPARE)
    total = np.zeros(bands * bands)
    for k, (start, end) in enumerate(zip(corners, np.roll(corners, -1), strict=True)):
        phi = ((k + along) * width)[:, np.newaxis]
        depth = (np.pi / 2 - start - along * (end - start))[:, np.newaxis]
        theta = depth * polar
        sine = np.sin(theta)
        where = np.stack(np.broadcast_arrays(sine * np.cos(phi), sine * np.sin(phi), np.cos(theta)), axis=-1)
        areas = width * along_areas[:, np.newaxis] * depth * polar_areas * sine
        total += np.tensordot(areas, basis(where, bands), axes=2)
    return total


def cover(
    weights: NDArray[np.floating], opacity: NDArray[np.floating], colour: ArrayLike, bands: int | None = None
) -> Array:
    """Lay clouds over an environment: ``(1 - opacity) light + opacity colour``, as SH products (Green 2003, eq. 8).

    ``weights`` ``(..., N*N)`` and ``opacity`` ``(F*F,)`` are expansions, the opacity's of values in [0, 1]; ``colour``,
    the clouds' own radiance, broadcasts to ``(...)``. Returns ``bands`` bands; N if left out. An occluder is a black cloud.
    Raises ValueError for an opacity or a colour that is not finite.

    Clouds of radiance 3 that hide half of an even sky of radiance 1, all over:

    >>> constant = np.array([np.sqrt(4 * np.pi)])
    >>> (cover(constant, 0.5 * constant, 3.0) / constant).round(6).tolist()
    [2.0]
    """
    check_finite("opacity", opacity)
    check_finite("colour", np.asarray(colour, dtype=np.float64))
    bands = bands_of(weights) if bands is None else bands
    out = -product(opacity, weights, bands)
    light, clouds = min(bands, bands_of(weights)) ** 2, min(bands, bands_of(opacity)) ** 2
    out[..., :light] += weights[..., :light]
    out[..., :clouds] += np.asarray(colour, dtype=np.float64)[..., np.newaxis] * opacity[:clouds]
    return out
