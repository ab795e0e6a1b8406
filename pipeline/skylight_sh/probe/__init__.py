"""Captured light: pictures of the whole sphere and their SH weights. Pure numerics, but for ``files``."""

from skylight_sh.probe.layouts import LAYOUTS, Layout, layout_of, patches
from skylight_sh.probe.projection import blur, project
from skylight_sh.probe.rendering import render

__all__ = ["LAYOUTS", "Layout", "blur", "layout_of", "patches", "project", "render"]
