"""Layouts of pictures over the sphere, one file each, named here. What a layout is, its file's first line says."""

from __future__ import annotations

from typing import TYPE_CHECKING

from skylight_sh.registry import Registry

if TYPE_CHECKING:
    from skylight_sh.probe.image_layouts.protocol import ImageLayout

# In the order in which proportions are tried.
IMAGE_LAYOUTS: Registry[ImageLayout] = Registry(
    {
        "angular": "skylight_sh.probe.image_layouts.angular:LAYOUT",
        "cube-cross": "skylight_sh.probe.image_layouts.cube_cross:LAYOUT",
        "cube-strip": "skylight_sh.probe.image_layouts.cube_strip:LAYOUT",
        "equirect": "skylight_sh.probe.image_layouts.equirect:LAYOUT",
    }
)

__all__ = ["IMAGE_LAYOUTS"]
