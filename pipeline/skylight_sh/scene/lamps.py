"""Lamps and captured light: what shines in a scene beside its sky and never moves, as a config gives it.

Directions and places are those of the world: +x east, +y north, +z up, seen from the receiver at the origin, in one unit of
length; angles are radians. Colours have one number for each of the light's channels. Every kind is a frozen dataclass, whose
fields are its options in a config's ``[[scene.lights]]``, and an entry of ``LAMPS``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal, Protocol

import numpy as np
from annotated_types import Ge, Gt, Le, MinLen
from numpy.typing import NDArray

from skylight_sh import probe, sphere
from skylight_sh.light import spherical_lights
from skylight_sh.light.protocol import OPTIONS
from skylight_sh.probe.image_layouts import IMAGE_LAYOUTS

Array = NDArray[np.float64]
# Reads a picture by its path: linear pixels ``(rows, columns, channels)``.
Reader = Callable[[str], NDArray[np.floating]]

Vector = tuple[float, float, float]
Colour = tuple[Annotated[float, Ge(0.0), Le(1e12)], ...]
Radius = Annotated[float, Gt(0.0), Le(1e9)]
_PI = float(np.pi)
_OPTIONS: Mapping[str, object] = {**OPTIONS, "allow_inf_nan": False}


class Lamp(Protocol):
    """Something that shines on the origin."""

    @property
    def kind(self) -> str:
        """Name in ``LAMPS``."""

    @property
    def colour(self) -> tuple[float, ...]:
        """Its numbers, one for each channel; none where a picture has them."""

    @property
    def image(self) -> str:
        """Path of the picture it reads; empty where it reads none."""

    def weights(self, bands: int, read: Reader, /) -> Array:
        """Return its SH weights ``(channels, N*N)`` in cd/m2, or ``(1, N*N)`` of a grey picture.

        Raises ValueError for a lamp that cannot be, such as one that stands at the receiver.
        """


class _NoPicture:
    @property
    def image(self) -> str:
        """None."""
        return ""


@dataclass(frozen=True, kw_only=True)
class Sphere(_NoPicture):
    """A sphere of even radiance."""

    __pydantic_config__: ClassVar[Mapping[str, object]] = _OPTIONS

    kind: Literal["sphere"] = "sphere"
    """sphere"""
    centre: Vector
    """[x, y, z]: east, north, up"""
    radius: Radius
    """above 0, in the unit of its centre, and less than its distance"""
    radiance: Colour
    """cd/m2, a number for each channel"""

    @property
    def colour(self) -> tuple[float, ...]:
        """Its radiance."""
        return self.radiance

    def weights(self, bands: int, _: Reader, /) -> Array:
        """Return its SH weights ``(channels, N*N)``. Raises ValueError with the origin inside."""
        return _coloured(self.colour, spherical_lights.spheres(self.centre, self.radius, bands))


@dataclass(frozen=True, kw_only=True)
class Disc(_NoPicture):
    """A disc of even radiance, far away."""

    __pydantic_config__: ClassVar[Mapping[str, object]] = _OPTIONS

    kind: Literal["disc"] = "disc"
    """disc"""
    direction: Vector
    """[x, y, z]: east, north, up"""
    half_angle: Annotated[float, Gt(0.0), Le(_PI)]
    """radians, above 0, at most pi"""
    radiance: Colour
    """cd/m2, a number for each channel"""

    @property
    def colour(self) -> tuple[float, ...]:
        """Its radiance."""
        return self.radiance

    def weights(self, bands: int, _: Reader, /) -> Array:
        """Return its SH weights ``(channels, N*N)``. Raises ValueError for the direction (0, 0, 0)."""
        return _coloured(self.colour, spherical_lights.discs(self.half_angle, self.direction, bands))


@dataclass(frozen=True, kw_only=True)
class Point(_NoPicture):
    """A point."""

    __pydantic_config__: ClassVar[Mapping[str, object]] = _OPTIONS

    kind: Literal["point"] = "point"
    """point"""
    centre: Vector
    """[x, y, z]: east, north, up"""
    intensity: Colour
    """candela where lengths are metres, a number for each channel"""

    @property
    def colour(self) -> tuple[float, ...]:
        """Its intensity."""
        return self.intensity

    def weights(self, bands: int, _: Reader, /) -> Array:
        """Return its SH weights ``(channels, N*N)``. Raises ValueError for one at the origin."""
        return _coloured(self.colour, spherical_lights.points(self.centre, bands))


@dataclass(frozen=True, kw_only=True)
class Spot(_NoPicture):
    """A point whose light fades between two cones."""

    __pydantic_config__: ClassVar[Mapping[str, object]] = _OPTIONS

    kind: Literal["spot"] = "spot"
    """spot"""
    centre: Vector
    """[x, y, z]: east, north, up"""
    axis: Vector
    """[x, y, z]: where it shines"""
    inner: Annotated[float, Ge(0.0)]
    """half-angle of the cone of whole intensity, radians, below outer"""
    outer: Annotated[float, Le(_PI)]
    """half-angle of the cone of no intensity, radians, at most pi"""
    intensity: Colour
    """candela where lengths are metres, a number for each channel"""

    @property
    def colour(self) -> tuple[float, ...]:
        """Its intensity."""
        return self.intensity

    def weights(self, bands: int, _: Reader, /) -> Array:
        """Return its SH weights ``(channels, N*N)``. Raises ValueError for one at the origin, and for cones of no order."""
        return _coloured(self.colour, spherical_lights.spots(self.centre, self.axis, self.inner, self.outer, bands))


@dataclass(frozen=True, kw_only=True)
class Directional(_NoPicture):
    """Parallel light."""

    __pydantic_config__: ClassVar[Mapping[str, object]] = _OPTIONS

    kind: Literal["directional"] = "directional"
    """directional"""
    direction: Vector
    """[x, y, z]: where it comes from"""
    illuminance: Colour
    """lx on a surface that faces it, a number for each channel"""

    @property
    def colour(self) -> tuple[float, ...]:
        """Its illuminance."""
        return self.illuminance

    def weights(self, bands: int, _: Reader, /) -> Array:
        """Return its SH weights ``(channels, N*N)``. Raises ValueError for the direction (0, 0, 0)."""
        return _coloured(self.colour, spherical_lights.directional(self.direction, bands))


@dataclass(frozen=True, kw_only=True)
class Probe:
    """Captured light: a picture of all directions, linear as a file of floats, or decoded from sRGB."""

    __pydantic_config__: ClassVar[Mapping[str, object]] = _OPTIONS

    kind: Literal["probe"] = "probe"
    """probe"""
    image: Annotated[str, MinLen(1)]
    """path of a picture from the config's folder, in it or below"""
    layout: Annotated[str, MinLen(1)]
    """how the picture covers the sphere, as the clouds' layout"""
    brightness: Annotated[float, Ge(0.0), Le(1e12)] = 1.0
    """cd/m2 of a pixel of value 1"""
    blur: Annotated[float, Ge(0.0), Le(_PI)] = 0.0
    """Gaussian pre-filter, standard deviation in radians"""

    def __post_init__(self) -> None:
        if self.layout not in IMAGE_LAYOUTS:
            raise ValueError(f"Invalid layout {self.layout!r}. Should be one of {', '.join(IMAGE_LAYOUTS)}.")

    @property
    def colour(self) -> tuple[float, ...]:
        """None: the picture has it."""
        return ()

    def weights(self, bands: int, read: Reader, /) -> Array:
        """Return its SH weights ``(channels of the picture, N*N)``. Raises ValueError for a picture of another layout."""
        return np.asarray(self.brightness * probe.blur(probe.project(read(self.image), self.layout, bands), self.blur))


LAMPS: Mapping[str, type[Lamp]] = {
    "sphere": Sphere,
    "disc": Disc,
    "point": Point,
    "spot": Spot,
    "directional": Directional,
    "probe": Probe,
}


def total(
    lamps: Sequence[Lamp], bands: int, channels: int, quantity: Literal["radiance", "irradiance"], read: Reader
) -> Array:
    """Return the SH weights ``(channels, N*N)`` of all ``lamps`` together; of size 0 where there are none.

    A grey picture is given to all channels. Irradiance in lux is radiance behind the clamped cosine.

    >>> east = Directional(direction=(1.0, 0.0, 0.0), illuminance=(2.0,))
    >>> total([east, east], 1, 1, "radiance", lambda image: np.zeros((0, 0, 1))).round(4).tolist()
    [[1.1284]]
    """
    if not lamps:
        return np.zeros(0)
    radiance = np.sum([np.broadcast_to(lamp.weights(bands, read), (channels, bands * bands)) for lamp in lamps], axis=0)
    if quantity == "radiance":
        return np.asarray(radiance)
    return sphere.scale_degrees(radiance, sphere.clamped_cosine(bands))


def _coloured(colour: Sequence[float], shape: Array) -> Array:
    return np.asarray(np.multiply.outer(np.array(colour), shape))
