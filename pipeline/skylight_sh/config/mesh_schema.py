"""A scene's mesh, as a config gives it, and how its transfer is computed."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from skylight_sh.config.section import Section


class MeshSection(Section):
    """Surfaces that the light falls on; their transfer is computed and published as transfer.h5."""

    file: str = Field(
        min_length=1,
        description="courtyard, or the path of an OBJ, PLY or glTF file from the config's folder, in it or below",
    )
    up: Literal["y", "z"] | None = Field(
        None, description="the file's upward axis; left out, y for glTF and z for the other formats"
    )
    bands: int = Field(0, ge=0, le=20, description="SH bands of the transfer, 1 to 20; 0: those of the recommended table")
    rays: int = Field(1024, ge=16, le=1_000_000, description="rays a vertex for what it sees of the light, 16 to 1,000,000")
    gather_rays: int = Field(
        256, ge=16, le=100_000, description="rays a vertex for light from other surfaces, 16 to 100,000"
    )
    bounces: int = Field(3, ge=0, le=20, description="how often surfaces send light on, 0 to 20")
    unshadowed: bool = Field(False, description="whether surfaces see no mesh, as if each stood alone")
    seed: int = Field(0, ge=0, le=2**31 - 1, description="of the rays' random turns")
