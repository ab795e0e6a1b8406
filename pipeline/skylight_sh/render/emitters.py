"""What shines from few directions: the sun's disc, balls, points, spots and parallel light, sampled by shadow rays.

Each kind gives, for points and numbers of the unit square, directions towards itself, how far it is, and the irradiance in
lux that a direction stands for on a surface that faces it. The numbers of a point are best a set that covers the square
evenly: then penumbrae are smooth.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from skylight_sh.scene import lamps
from skylight_sh.transfer.sampling import frames

Array = NDArray[np.float64]
Bool = NDArray[np.bool_]


@dataclass(frozen=True)
class Towards:
    """Directions ``along`` ``(n, s, 3)``, ``distance`` ``(n, s)``, infinite for what is far, and ``lux`` ``(n, s, 3)``.

    The mean over s of ``lux`` times a cosine is the irradiance of a surface that nothing shades.
    """

    along: Array
    distance: Array
    lux: Array


class Emitter(Protocol):
    """Something that shines."""

    def towards(self, points: Array, unit: Array) -> Towards:
        """Return directions from ``points`` ``(n, 3)`` by numbers ``unit`` ``(n, s, 2)`` of [0, 1)."""

    def seen(self, eye: Array, along: Array, /) -> tuple[Array, Array]:
        """Return how far from ``eye`` ``(3,)`` it is seen along unit vectors ``(n, 3)``, and its radiance ``(3,)``.

        Where it is not seen, the distance ``(n,)`` is NaN.
        """


@dataclass(frozen=True)
class Disc:
    """A far disc of even ``radiance`` ``(3,)`` in cd/m2, ``half_angle`` radians about a unit ``direction`` ``(3,)``."""

    direction: Array
    half_angle: float
    radiance: Array

    def towards(self, points: Array, unit: Array) -> Towards:
        """Sample the disc evenly."""
        axis = np.broadcast_to(self.direction, (len(points), 3))
        along, solid = _cone(axis, np.full(len(points), self.half_angle), unit)
        return Towards(along, np.full(unit.shape[:2], np.inf), solid[:, np.newaxis, np.newaxis] * _all(self.radiance, unit))

    def seen(self, _: Array, along: Array) -> tuple[Array, Array]:
        """See it beyond everything."""
        return np.where(_angle(along, self.direction) <= self.half_angle, np.inf, np.nan), self.radiance


@dataclass(frozen=True)
class Ball:
    """A sphere of even ``radiance`` ``(3,)`` in cd/m2."""

    centre: Array
    radius: float
    radiance: Array

    def towards(self, points: Array, unit: Array) -> Towards:
        """Sample the part of the sphere that shows; points within it see its whole inside as if they stood on it."""
        offset = self.centre - points
        distance = np.linalg.norm(offset, axis=-1)
        half = np.arcsin(np.clip(self.radius / np.maximum(distance, 1e-300), 0.0, 1.0))
        axis = offset / np.maximum(distance, 1e-300)[:, np.newaxis]
        along, solid = _cone(axis, half, unit)
        # To its middle's distance less its radius nothing of it shades itself.
        near = np.broadcast_to(np.maximum(distance - self.radius, 0.0)[:, np.newaxis], unit.shape[:2])
        return Towards(along, near, solid[:, np.newaxis, np.newaxis] * _all(self.radiance, unit))

    def seen(self, eye: Array, along: Array) -> tuple[Array, Array]:
        """See its near side."""
        offset = self.centre - eye
        middle = along @ offset
        half_chord = self.radius**2 - (offset @ offset - middle**2)
        meets = (half_chord > 0.0) & (middle > 0.0)
        return np.where(meets, middle - np.sqrt(np.maximum(half_chord, 0.0)), np.nan), self.radiance


@dataclass(frozen=True)
class Spot:
    """A point of ``intensity`` ``(3,)``; whole to ``inner`` radians off ``axis`` ``(3,)``, none beyond ``outer``.

    A point that shines everywhere has an inner of infinity.
    """

    centre: Array
    intensity: Array
    axis: Array
    inner: float
    outer: float

    def towards(self, points: Array, unit: Array) -> Towards:
        """Return the one direction there is."""
        offset = self.centre - points
        distance = np.maximum(np.linalg.norm(offset, axis=-1), 1e-300)
        along = offset / distance[:, np.newaxis]
        share = 1.0 / distance**2
        if np.isfinite(self.inner):
            cosine = -along @ self.axis
            step = np.clip((cosine - np.cos(self.outer)) / (np.cos(self.inner) - np.cos(self.outer)), 0.0, 1.0)
            share = share * step * step * (3.0 - 2.0 * step)
        return Towards(
            _each(along, unit),
            np.repeat(distance[:, np.newaxis], unit.shape[1], axis=1),
            share[:, np.newaxis, np.newaxis] * _all(self.intensity, unit),
        )

    def seen(self, _: Array, along: Array) -> tuple[Array, Array]:
        """Show nothing: it is a point."""
        return np.full(len(along), np.nan), np.zeros(3)


@dataclass(frozen=True)
class Parallel:
    """Parallel light from a unit ``direction`` ``(3,)``, of ``illuminance`` ``(3,)`` lux on a surface that faces it."""

    direction: Array
    illuminance: Array

    def towards(self, points: Array, unit: Array) -> Towards:
        """Return the one direction there is."""
        along = _each(np.broadcast_to(self.direction, (len(points), 3)), unit)
        return Towards(along, np.full(unit.shape[:2], np.inf), _all(self.illuminance, unit))

    def seen(self, _: Array, along: Array) -> tuple[Array, Array]:
        """Show nothing."""
        return np.full(len(along), np.nan), np.zeros(3)


def of_lamp(lamp: lamps.Lamp) -> Emitter | None:
    """Return a config's lamp as an emitter; nothing for a probe, whose light comes from everywhere.

    A colour of one number is grey. Raises ValueError for a direction of no length.
    """
    if isinstance(lamp, lamps.Sphere):
        return Ball(np.array(lamp.centre), lamp.radius, _rgb(lamp))
    if isinstance(lamp, lamps.Disc):
        return Disc(_unit(lamp.direction), lamp.half_angle, _rgb(lamp))
    if isinstance(lamp, lamps.Point):
        return Spot(np.array(lamp.centre), _rgb(lamp), np.array([0.0, 0.0, 1.0]), np.inf, np.inf)
    if isinstance(lamp, lamps.Spot):
        return Spot(np.array(lamp.centre), _rgb(lamp), _unit(lamp.axis), lamp.inner, lamp.outer)
    if isinstance(lamp, lamps.Directional):
        return Parallel(_unit(lamp.direction), _rgb(lamp))
    return None


def _rgb(lamp: lamps.Lamp) -> Array:
    return np.broadcast_to(np.array(lamp.colour, dtype=np.float64), (3,))


def _unit(vector: Sequence[float]) -> Array:
    length = float(np.linalg.norm(vector))
    if not length > 0.0:
        raise ValueError("Invalid direction (0, 0, 0). Should be a vector of any other length.")
    return np.asarray(np.array(vector) / length)


def _cone(axis: Array, half_angle: Array, unit: Array) -> tuple[Array, Array]:
    """Return directions ``(n, s, 3)``, evenly in cones about ``axis`` ``(n, 3)``, and the cones' solid angles ``(n,)``."""
    # 1 - cos, without the cancellation of small angles.
    cap = 2.0 * np.sin(0.5 * half_angle) ** 2
    low = cap[:, np.newaxis] * unit[..., 0]
    flat, angle = np.sqrt(low * (2.0 - low)), 2.0 * np.pi * unit[..., 1]
    local = np.stack([flat * np.cos(angle), flat * np.sin(angle), 1.0 - low], axis=-1)
    return local @ frames(axis, np.zeros(len(axis))).transpose(0, 2, 1), 2.0 * np.pi * cap


def _angle(along: Array, direction: Array) -> Array:
    return np.asarray(2.0 * np.arcsin(np.minimum(0.5 * np.linalg.norm(along - direction, axis=-1), 1.0)))


def _all(colour: Array, unit: Array) -> Array:
    return np.broadcast_to(colour, (*unit.shape[:2], 3))


def _each(along: Array, unit: Array) -> Array:
    return np.broadcast_to(along[:, np.newaxis], (*unit.shape[:2], 3))
