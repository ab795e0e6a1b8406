"""A cube unfolded: left, front, right, back in a row, 4:3, or the back below the down face, upside down, 3:4."""

from __future__ import annotations

from skylight_sh.probe.charts import Face
from skylight_sh.probe.image_layouts.faces import HALF_TURNS, faces
from skylight_sh.probe.image_layouts.protocol import ImageLayout, Patch

_HORIZONTAL = {"up": (0, 1), "left": (1, 0), "front": (1, 1), "right": (1, 2), "back": (1, 3), "down": (2, 1)}
# The vertical cross carries the back upside down, so that it folds.
_VERTICAL = {"up": (0, 1), "left": (1, 0), "front": (1, 1), "right": (1, 2), "down": (2, 1), "back": (3, 1)}
_TURNED_BACK = Face((-1, 0, 0), (0, -1, 0), (0, 0, 1))


def _patches(height: int, width: int) -> list[Patch]:
    if width % 4 == 0 and 3 * width == 4 * height:
        return faces(_HORIZONTAL, width // 4)
    if width % 3 == 0 and 4 * width == 3 * height:
        return faces(_VERTICAL, width // 3, back=_TURNED_BACK)
    return []


LAYOUT = ImageLayout("4:3 (horizontal) or 3:4 (vertical), in whole faces", _patches, HALF_TURNS)
