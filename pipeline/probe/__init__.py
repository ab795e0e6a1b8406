"""Captured light: pictures of the whole sphere and their SH weights. Pure numerics, but for ``files``."""

from pipeline.probe.layouts import LAYOUTS, Layout, layout_of, patches
from pipeline.probe.projection import blur, project
from pipeline.probe.rendering import render

__all__ = ["LAYOUTS", "Layout", "blur", "layout_of", "patches", "project", "render"]
