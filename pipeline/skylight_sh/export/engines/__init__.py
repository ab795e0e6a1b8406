"""Engines: one sky, or a tabulated day, in the form that a named engine reads. ``profiles`` says what each expects."""

from skylight_sh.export.engines.convert import HALF_MAX, bands_for, convert
from skylight_sh.export.engines.forms import columns, flatten, structure, text
from skylight_sh.export.engines.orientation import describe, parse_axes
from skylight_sh.export.engines.profiles import PROFILES, Profile

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
