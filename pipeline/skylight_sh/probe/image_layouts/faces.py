"""Faces of a cube, as seen by someone who looks along +x with +z up.

Front is +x, back -x, left +y, right -y, up +z, down -z.
"""

from __future__ import annotations

from collections.abc import Mapping

from skylight_sh.probe.charts import Face
from skylight_sh.probe.image_layouts.protocol import Patch

# Centre, right and down. Up's lower edge and down's upper edge touch the front.
_FACES = {
    "front": Face((1, 0, 0), (0, -1, 0), (0, 0, -1)),
    "back": Face((-1, 0, 0), (0, 1, 0), (0, 0, -1)),
    "left": Face((0, 1, 0), (1, 0, 0), (0, 0, -1)),
    "right": Face((0, -1, 0), (-1, 0, 0), (0, 0, -1)),
    "up": Face((0, 0, 1), (0, -1, 0), (1, 0, 0)),
    "down": Face((0, 0, -1), (0, -1, 0), (-1, 0, 0)),
}
# Of a quarter of a turn each.
HALF_TURNS = 0.5


def faces(places: Mapping[str, tuple[int, int]], size: int, *, back: Face = _FACES["back"]) -> list[Patch]:
    """Return the patches of a cube's faces of ``size`` texels at ``places``, rows and columns in units of a face."""
    charts = {**_FACES, "back": back}
    return [Patch(row * size, column * size, size, size, charts[name]) for name, (row, column) in places.items()]
