"""What stands in a scene beside its sky: skyline, clouds, occluders and lights, as a config gives them.

Directions and places are those of the world: +x east, +y north, +z up, seen from the receiver at the origin, in one unit of
length; angles are radians. Colours have one number for each of the light's channels.
"""

from __future__ import annotations

from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from skylight_sh.config.section import Section
from skylight_sh.light import spherical_lights
from skylight_sh.probe.layouts import Layout

Array = NDArray[np.float64]
Vector = Annotated[tuple[float, float, float], Field(description="[x, y, z]: east, north, up")]
Colour = Annotated[
    tuple[Annotated[float, Field(ge=0.0, le=1e12)], ...], Field(description="one number of 0 to 1e12 for each channel")
]
_IMAGE = Field(min_length=1, description="path of a picture from the config's folder, in it or below")
_LAYOUT = Field(description="how the picture covers the sphere: angular, cube-cross, cube-strip or equirect")
_RADIANCE = Field(description="cd/m2, a number for each channel")
_INTENSITY = Field(description="candela where lengths are metres, a number for each channel")
_RADIUS = Field(gt=0.0, le=1e9, description="above 0, in the unit of its centre, and less than its distance")


class CloudsSection(Section):
    """Clouds from a picture: white is opaque, black is clear."""

    image: str = _IMAGE
    layout: Layout = _LAYOUT
    colour: Colour = Field(description="the clouds' own radiance in cd/m2, a number for each channel")
    opacity: float = Field(1.0, ge=0.0, le=1.0, description="what the picture is multiplied with, 0 to 1")


class OccluderSection(Section):
    """A black sphere that stands for something that casts a shadow."""

    centre: Vector
    radius: float = _RADIUS


class SphereLight(Section):
    """A sphere of even radiance."""

    kind: Literal["sphere"]
    centre: Vector
    radius: float = _RADIUS
    radiance: Colour = _RADIANCE


class DiscLight(Section):
    """A disc of even radiance, far away."""

    kind: Literal["disc"]
    direction: Vector
    half_angle: float = Field(gt=0.0, le=float(np.pi), description="radians, above 0, at most pi")
    radiance: Colour = _RADIANCE


class PointLight(Section):
    """A point."""

    kind: Literal["point"]
    centre: Vector
    intensity: Colour = _INTENSITY


class SpotLight(Section):
    """A point whose light fades between two cones."""

    kind: Literal["spot"]
    centre: Vector
    axis: Vector = Field(description="[x, y, z]: where it shines")
    inner: float = Field(ge=0.0, description="half-angle of the cone of whole intensity, radians, below outer")
    outer: float = Field(le=float(np.pi), description="half-angle of the cone of no intensity, radians, at most pi")
    intensity: Colour = _INTENSITY


class DirectionalLight(Section):
    """Parallel light."""

    kind: Literal["directional"]
    direction: Vector = Field(description="[x, y, z]: where it comes from")
    illuminance: Colour = Field(description="lx on a surface that faces it, a number for each channel")


class ProbeLight(Section):
    """Captured light: a picture of all directions, linear as a file of floats, or decoded from sRGB."""

    kind: Literal["probe"]
    image: str = _IMAGE
    layout: Layout = _LAYOUT
    brightness: float = Field(1.0, ge=0.0, le=1e12, description="cd/m2 of a pixel of value 1")
    blur: float = Field(0.0, ge=0.0, le=float(np.pi), description="Gaussian pre-filter, standard deviation in radians")


LampSection = SphereLight | DiscLight | PointLight | SpotLight | DirectionalLight
LightSection = LampSection | ProbeLight


def colour(light: LampSection) -> tuple[float, ...]:
    """Return a lamp's numbers, one for each channel."""
    if isinstance(light, SphereLight | DiscLight):
        return light.radiance
    return light.illuminance if isinstance(light, DirectionalLight) else light.intensity


def weights(light: LampSection, bands: int) -> Array:
    """Return the SH weights ``(channels, N*N)`` of a lamp at the origin. Raises ValueError for one that cannot be."""
    match light:
        case SphereLight():
            shape = spherical_lights.spheres(light.centre, light.radius, bands)
        case DiscLight():
            shape = spherical_lights.discs(light.half_angle, light.direction, bands)
        case PointLight():
            shape = spherical_lights.points(light.centre, bands)
        case SpotLight():
            shape = spherical_lights.spots(light.centre, light.axis, light.inner, light.outer, bands)
        case DirectionalLight():
            shape = spherical_lights.directional(light.direction, bands)
    return np.asarray(np.multiply.outer(np.array(colour(light)), shape))
