"""Pictures of a scene, as a config asks for them: where from, when, and under which sky."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from skylight_sh.config.section import Section
from skylight_sh.scene.lamps import Vector

ViewName = Annotated[str, Field(pattern=r"^[a-z0-9][a-z0-9_-]{0,39}$")]


class SkySunSection(Section):
    """Where the sun stands: by its height and azimuth, or by time and place."""

    height: float | None = Field(None, ge=-18.0, le=90.0, description="degrees above the horizon, -18 to 90")
    azimuth: float | None = Field(
        None, ge=-360.0, le=360.0, description="degrees from east (+x) towards north (+y), as everywhere here; -360 to 360"
    )
    time: str | None = Field(
        None, description='instead of them: a moment at a place, ISO 8601, like "2026-06-21T18:30"; with no offset, local'
    )
    latitude: float | None = Field(None, ge=-90.0, le=90.0, description="degrees, north positive")
    longitude: float | None = Field(None, ge=-180.0, le=180.0, description="degrees, east positive")
    timezone: str = Field("UTC", description="IANA name of the clock's zone, like Europe/Vienna")


class ViewSection(Section):
    """One picture: `skylight-sh render CONFIG --view NAME`."""

    name: ViewName = Field(description="lower-case letters, digits, - and _; at most 40")
    eye: Vector = Field(description="[x, y, z]: east, north, up, in the mesh's unit")
    target: Vector = Field(description="what is in the middle, neither above the eye nor below it")
    field: float = Field(40.0, ge=1.0, le=150.0, description="vertical angle of view in degrees, 1 to 150")
    width: int = Field(960, ge=1, le=8192, description="pixels, 1 to 8192")
    height: int = Field(540, ge=1, le=8192, description="pixels, 1 to 8192")
    sun: SkySunSection = Field(SkySunSection.model_construct(), description="where the sun stands")
    at: dict[str, float] = Field({}, description="the light's other parameters, e.g. { turbidity = 3.0 }")
    disc: bool = Field(True, description="whether the sun's disc shines beside a Preetham sky")
    table: str = Field("", description="name of the table that lights the picture; left out, the recommended one")
    bands: int = Field(0, ge=0, le=20, description="SH bands of the light, 1 to 20; 0: all that table and transfer share")
    samples: int = Field(16, ge=1, le=1024, description="points looked at in each pixel, 1 to 1024")
    exposure: float = Field(0.0, ge=-20.0, le=20.0, description="stops brighter than by the scene's light, -20 to 20")
    ground: tuple[Annotated[float, Field(ge=0.0, le=1.0)], ...] = Field(
        (0.34, 0.29, 0.20),
        min_length=3,
        max_length=3,
        description="albedo of the ground that shows between the mesh and the horizon; it lights nothing",
    )
