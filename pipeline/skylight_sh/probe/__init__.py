"""Captured light: pictures of the whole sphere and their SH weights. Pure numerics, but for ``files``."""

from skylight_sh.probe.image_layouts import IMAGE_LAYOUTS
from skylight_sh.probe.layouts import layout_of, patches
from skylight_sh.probe.projection import blur, project
from skylight_sh.probe.rendering import render

__all__ = ["IMAGE_LAYOUTS", "blur", "layout_of", "patches", "project", "render"]
