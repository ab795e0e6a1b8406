"""A cube's faces in a row or a column: right, left, up, down, front, back, 6:1 or 1:6.

The order of graphics libraries, +X, -X, +Y, -Y, +Z, -Z with Y up and Z forward.
"""

from __future__ import annotations

from skylight_sh.probe.image_layouts.faces import HALF_TURNS, faces
from skylight_sh.probe.image_layouts.protocol import ImageLayout, Patch

_STRIP = ("right", "left", "up", "down", "front", "back")


def _patches(height: int, width: int) -> list[Patch]:
    if width == 6 * height:
        return faces({name: (0, i) for i, name in enumerate(_STRIP)}, height)
    if height == 6 * width:
        return faces({name: (i, 0) for i, name in enumerate(_STRIP)}, width)
    return []


LAYOUT = ImageLayout("6:1 or 1:6, in whole faces", _patches, HALF_TURNS)
