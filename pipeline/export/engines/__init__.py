"""Engines: one sky, or a tabulated day, in the form that a named engine reads. ``profiles`` says what each expects."""

from pipeline.export.engines.axes import describe, parse_axes
from pipeline.export.engines.convert import HALF_MAX, bands_for, convert
from pipeline.export.engines.forms import columns, flatten, structure, text
from pipeline.export.engines.profiles import PROFILES, Profile

__all__ = [
    "HALF_MAX",
    "PROFILES",
    "Profile",
    "bands_for",
    "columns",
    "convert",
    "describe",
    "flatten",
    "parse_axes",
    "structure",
    "text",
]
