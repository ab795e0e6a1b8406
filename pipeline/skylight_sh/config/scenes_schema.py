"""The part of the schema that says how large and how exact the report's pictures of scenes are."""

from __future__ import annotations

from pydantic import Field

from skylight_sh.config.section import Section


class ScenesSection(Section):
    """Pictures of a courtyard, through transfer and by brute force."""

    width: int = Field(256, ge=16, le=1920, description="pixels across, 16 to 1920; 9/16 of that high")
    paths: int = Field(
        512, ge=8, le=1_000_000, description="paths of brute force a pixel, 8 to 1000000, an eighth of them at a time"
    )
    rays: int = Field(
        1024, ge=8, le=1_000_000, description="rays a vertex and a pixel that transfer is computed by, 8 to 1000000"
    )
    bounces: int = Field(3, ge=1, le=16, description="bounces of light, 1 to 16")
