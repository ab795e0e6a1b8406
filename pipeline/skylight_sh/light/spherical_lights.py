"""Spherical lights, and the simple ones whose light comes from one direction: SH weights at a receiver, many at once.

A sphere of uniform radiance is seen as a disc of half-angle asin(radius / distance), whatever the distance (Mezieres and
Paulin, section 3). Directional, point and spot lights are Dirac pulses: the basis in their direction, scaled by the
irradiance they give a surface that faces them (section 2.2). Nothing here hides a light behind the horizon.

Every function returns one row of weights a light, ``(..., N*N)`` for radiance 1; a scene's sum is
``colours.T @ weights`` with colours ``(lights, channels)``.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh import sphere

Array = NDArray[np.float64]


class InsideLightError(ValueError):
    """A receiver lies inside a spherical light, which then has no direction."""


def half_angles(
    centres: ArrayLike,
    radii: ArrayLike,
    receivers: ArrayLike = (0.0, 0.0, 0.0),
    *,
    inside: Literal["refuse", "sphere"] = "refuse",
) -> tuple[Array, Array]:
    """Return half-angles ``(...)`` in radians and unit directions ``(..., 3)`` of spheres as seen from ``receivers``.

    ``centres`` ``(..., 3)``, ``radii`` ``(...)`` and ``receivers`` ``(..., 3)`` broadcast, in one unit of length. A
    receiver on a light's surface sees half of all directions. Inside one it sees nothing but light: ``inside = "sphere"``
    makes that the half-angle pi, ``"refuse"`` raises InsideLightError. Raises ValueError for a negative radius, a value
    that is not finite, and a light without extent at its receiver.

    >>> angle, direction = half_angles([0.0, 0.0, 2.0], 1.0)
    >>> round(float(angle), 4), direction.tolist()
    (0.5236, [0.0, 0.0, 1.0])
    """
    radius, offset = np.asarray(radii, dtype=np.float64), np.subtract(centres, receivers, dtype=np.float64)
    _check("radius", radius, low=0.0)
    _check("centre or receiver", offset)
    distance = _length(offset)
    radius, distance = np.broadcast_arrays(radius, distance)
    within = distance < radius
    if inside == "refuse" and within.any():
        at = np.unravel_index(int(within.argmax()), within.shape)
        raise InsideLightError(
            f"The receiver lies inside light {'.'.join(map(str, at)) or 0}: distance {distance[at]:.6g}, radius "
            f"{radius[at]:.6g}. Move one of them, make the light smaller, or use inside='sphere'."
        )
    if np.any((distance == 0.0) & (radius == 0.0)):
        raise ValueError("A light of radius 0 stands at its receiver. Move one of them.")
    ratio = radius / np.where(within, 1.0, distance)
    angle = np.where(within, np.pi, np.arcsin(np.where(within, 0.0, ratio)))
    # At the very centre any direction serves: the full sphere has none.
    up = np.where(distance[..., np.newaxis] == 0.0, np.array([0.0, 0.0, 1.0]), offset)
    return angle, up / _length(up)[..., np.newaxis]


def discs(half_angle: ArrayLike, directions: ArrayLike, bands: int) -> Array:
    """Return the weights of discs of radiance 1, ``half_angle`` ``(...)`` in radians, about ``directions`` ``(..., 3)``."""
    return sphere.aim(sphere.cap(half_angle, bands), _unit(directions))


def spheres(
    centres: ArrayLike,
    radii: ArrayLike,
    bands: int,
    receivers: ArrayLike = (0.0, 0.0, 0.0),
    *,
    inside: Literal["refuse", "sphere"] = "refuse",
) -> Array:
    """Return the weights of spheres of radiance 1 at ``receivers``; see ``half_angles`` for the arguments."""
    angle, direction = half_angles(centres, radii, receivers, inside=inside)
    return sphere.aim(sphere.cap(angle, bands), direction)


def directional(directions: ArrayLike, bands: int) -> Array:
    """Return the weights of light from ``directions`` ``(..., 3)``, of irradiance 1 on a surface that faces it."""
    return sphere.basis(_unit(directions), bands)


def points(centres: ArrayLike, bands: int, receivers: ArrayLike = (0.0, 0.0, 0.0)) -> Array:
    """Return the weights of point lights of intensity 1 (a candela for lux in metres): irradiance 1 / distance squared.

    >>> points([0.0, 0.0, 2.0], 1).round(4).tolist()  # a quarter of y_00
    [0.0705]
    """
    offset = np.subtract(centres, receivers, dtype=np.float64)
    _check("centre or receiver", offset)
    distance = _length(offset)
    if np.any(distance == 0.0):
        raise ValueError("A point light stands at its receiver, where it is infinitely bright. Move one of them.")
    return directional(offset, bands) / (distance**2)[..., np.newaxis]


def spots(
    centres: ArrayLike,
    axes: ArrayLike,
    inner: ArrayLike,
    outer: ArrayLike,
    bands: int,
    receivers: ArrayLike = (0.0, 0.0, 0.0),
) -> Array:
    """Return the weights of spot lights of intensity 1: point lights that fade between two cones about ``axes``.

    ``axes`` ``(..., 3)`` point where the spots shine. The intensity is whole up to the half-angle ``inner`` and 0 from
    ``outer`` on, both in radians with 0 <= inner < outer <= pi, by a cubic step in the angle's cosine between them.
    """
    near, far = np.asarray(inner, dtype=np.float64), np.asarray(outer, dtype=np.float64)
    if not np.all((near >= 0.0) & (near < far) & (far <= np.pi)):
        raise ValueError(f"Invalid cone {inner!r} to {outer!r}. Should be radians with 0 <= inner < outer <= pi.")
    weights = points(centres, bands, receivers)
    towards = -_unit(np.subtract(centres, receivers, dtype=np.float64))
    cosine = np.sum(towards * _unit(axes), axis=-1)
    step = np.clip((cosine - np.cos(far)) / (np.cos(near) - np.cos(far)), 0.0, 1.0)
    return np.asarray(weights * (step * step * (3.0 - 2.0 * step))[..., np.newaxis])


def _length(vectors: Array) -> Array:
    return np.asarray(np.hypot(np.hypot(vectors[..., 0], vectors[..., 1]), vectors[..., 2]))


def _unit(vectors: ArrayLike) -> Array:
    found = np.asarray(vectors, dtype=np.float64)
    _check("direction", found)
    length = _length(found)
    if np.any(length == 0.0):
        raise ValueError("Invalid direction (0, 0, 0). Should be a vector of any other length.")
    return np.asarray(found / length[..., np.newaxis])


def _check(what: str, values: Array, low: float = -np.inf) -> None:
    """Raise ValueError where a value is not finite or lies below ``low``."""
    wrong = ~(np.isfinite(values) & (values >= low))
    if wrong.any():
        needed = "finite numbers" if low == -np.inf else f"finite numbers of at least {low:g}"
        raise ValueError(f"Invalid {what} {float(values[wrong].flat[0])!r}. Should be {needed}.")
