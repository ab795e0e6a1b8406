"""What stands before a scene's sky, as a config gives it: clouds and occluders. Its lamps are ``scene.lamps``."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from skylight_sh.config.choices import OneOf
from skylight_sh.config.section import Section
from skylight_sh.probe.image_layouts import IMAGE_LAYOUTS
from skylight_sh.scene.lamps import Colour, Radius, Vector


class CloudsSection(Section):
    """Clouds from a picture: white is opaque, black is clear."""

    image: str = Field(min_length=1, description="path of a picture from the config's folder, in it or below")
    layout: Annotated[str, OneOf(IMAGE_LAYOUTS, "how the picture covers the sphere")]
    colour: Colour = Field(description="the clouds' own radiance in cd/m2, a number for each channel")
    opacity: float = Field(1.0, ge=0.0, le=1.0, description="what the picture is multiplied with, 0 to 1")


class OccluderSection(Section):
    """A black sphere that stands for something that casts a shadow."""

    centre: Vector = Field(description="[x, y, z]: east, north, up")
    radius: Radius = Field(description="above 0, in the unit of its centre, and less than its distance")
