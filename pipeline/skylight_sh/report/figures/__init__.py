"""Pictures of the report, one file a picture, named here in the order of the page."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from skylight_sh.registry import Registry

if TYPE_CHECKING:
    from skylight_sh.report.figures.picture import Picture

PICTURES: Registry[Picture] = Registry(
    {
        "bands": "skylight_sh.report.figures.bands:PICTURE",
        "origins": "skylight_sh.report.figures.origins:PICTURE",
        "bytes": "skylight_sh.report.figures.bytes:PICTURE",
        "degrees": "skylight_sh.report.figures.degrees:PICTURE",
        "maps": "skylight_sh.report.figures.maps:PICTURE",
        "panoramas": "skylight_sh.report.figures.panoramas:PICTURE",
        "surroundings": "skylight_sh.report.figures.surroundings:PICTURE",
        "daylight": "skylight_sh.report.figures.daylight:PICTURE",
        "ringing": "skylight_sh.report.figures.ringing:PICTURE",
        "gibbs": "skylight_sh.report.figures.gibbs:PICTURE",
        "lighting_error": "skylight_sh.report.figures.lighting_error:PICTURE",
        "error_sources": "skylight_sh.report.figures.error_sources:PICTURE",
        "daylight_scene": "skylight_sh.report.figures.daylight_scene:PICTURE",
        "interreflection": "skylight_sh.report.figures.interreflection:PICTURE",
        "spherical_lights": "skylight_sh.report.figures.spherical_lights:PICTURE",
        "normal_map": "skylight_sh.report.figures.normal_map:PICTURE",
        "encoding": "skylight_sh.report.figures.encoding:PICTURE",
    }
)

# Pictures of scenes, and the steps that make what they draw.
SCENES: Mapping[str, tuple[str, ...]] = {
    "daylight_scene": ("pictures/courtyard",),
    "interreflection": ("pictures/courtyard",),
    "spherical_lights": ("pictures/ten_lights",),
    "normal_map": ("pictures/courtyard", "pictures/relief"),
    "error_sources": ("pictures/courtyard",),
}
