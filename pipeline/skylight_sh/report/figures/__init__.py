"""Pictures of the report, one file a picture, named here in the order of the page."""

from __future__ import annotations

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
        "encoding": "skylight_sh.report.figures.encoding:PICTURE",
    }
)
