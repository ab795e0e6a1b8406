"""Layouts of image files over the sphere: which chart each texel of a picture belongs to.

Every layout is a list of patches, rectangles of the picture with one chart each. Faces of a cube are named as seen by
someone who looks along +x with +z up: front +x, back -x, left +y, right -y, up +z, down -z.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from skylight_sh.probe.charts import Angular, Chart, Face, LatLong

Array = NDArray[np.float64]
Layout = Literal["angular", "cube-cross", "cube-strip", "equirect"]
LAYOUTS: tuple[Layout, ...] = get_args(Layout)

# Centre, right and down. Up's lower edge and down's upper edge touch the front.
_FACES = {
    "front": Face((1, 0, 0), (0, -1, 0), (0, 0, -1)),
    "back": Face((-1, 0, 0), (0, 1, 0), (0, 0, -1)),
    "left": Face((0, 1, 0), (1, 0, 0), (0, 0, -1)),
    "right": Face((0, -1, 0), (-1, 0, 0), (0, 0, -1)),
    "up": Face((0, 0, 1), (0, -1, 0), (1, 0, 0)),
    "down": Face((0, 0, -1), (0, -1, 0), (-1, 0, 0)),
}
_TURNED_BACK = Face((-1, 0, 0), (0, -1, 0), (0, 0, 1))

# Places (row, column) in units of a face. The vertical cross carries the back below the down face, upside down, so that
# it folds. The strip keeps the order of graphics libraries, +X, -X, +Y, -Y, +Z, -Z with Y up and Z forward.
_HORIZONTAL_CROSS = {"up": (0, 1), "left": (1, 0), "front": (1, 1), "right": (1, 2), "back": (1, 3), "down": (2, 1)}
_VERTICAL_CROSS = {"up": (0, 1), "left": (1, 0), "front": (1, 1), "right": (1, 2), "down": (2, 1), "back": (3, 1)}
_STRIP = ("right", "left", "up", "down", "front", "back")


@dataclass(frozen=True)
class Patch:
    """A rectangle of a picture: its first row and column, its numbers of rows and columns, and its chart."""

    row: int
    column: int
    rows: int
    columns: int
    chart: Chart

    def edges(self) -> tuple[Array, Array]:
        """Return the texels' edges in the chart's plane, u ``(columns + 1,)`` and v ``(rows + 1,)``."""
        left, right, top, bottom = self.chart.bounds
        # From the middle outwards: the horizon of an even number of rows is exactly 0.
        u = (2 * np.arange(self.columns + 1) - self.columns) / self.columns
        v = (2 * np.arange(self.rows + 1) - self.rows) / self.rows
        return (left + right) / 2 + u * (right - left) / 2, (top + bottom) / 2 + v * (bottom - top) / 2


def patches(layout: Layout, height: int, width: int) -> list[Patch]:
    """Return the patches of a picture of ``height`` by ``width`` texels.

    ``angular`` is square; ``equirect`` twice as wide as high; ``cube-cross`` 4:3 (horizontal) or 3:4 (vertical) and
    ``cube-strip`` 6:1 or 1:6 in faces. Raises ValueError where the shape is none of these.
    """
    if layout not in LAYOUTS:
        raise ValueError(f"Invalid layout {layout!r}. Should be one of {', '.join(LAYOUTS)}.")
    if height < 1 or width < 1:
        raise ValueError(f"Invalid size {width}x{height} (width x height). Should be at least one texel each way.")
    if layout == "angular" and height == width:
        return [Patch(0, 0, height, width, Angular())]
    if layout == "equirect" and width == 2 * height:
        return [Patch(0, 0, height, width, LatLong())]
    if layout == "cube-cross" and width % 4 == 0 and 3 * width == 4 * height:
        return _faces(_HORIZONTAL_CROSS, width // 4)
    if layout == "cube-cross" and width % 3 == 0 and 4 * width == 3 * height:
        return _faces(_VERTICAL_CROSS, width // 3, back=_TURNED_BACK)
    if layout == "cube-strip" and width == 6 * height:
        return _faces({name: (0, i) for i, name in enumerate(_STRIP)}, height)
    if layout == "cube-strip" and height == 6 * width:
        return _faces({name: (i, 0) for i, name in enumerate(_STRIP)}, width)
    raise ValueError(
        f"Invalid size {width}x{height} (width x height) for the layout {layout}. Should have the proportions "
        f"{_SHAPES[layout]}. Crop or resize the picture, or name its own layout."
    )


def layout_of(height: int, width: int) -> Layout:
    """Return the one layout that has a picture's proportions. Raises ValueError where none has."""
    for layout in LAYOUTS:
        try:
            patches(layout, height, width)
        except ValueError:
            continue
        return layout
    known = "; ".join(f"{shape} {layout}" for layout, shape in _SHAPES.items())
    raise ValueError(f"Invalid size {width}x{height} (width x height). Should have the proportions of a layout: {known}.")


def most_bands(found: list[Patch]) -> int:
    """Return the most bands that a picture's texels resolve: one a texel over half a turn, and 100 at most.

    A cube's face covers a quarter of a turn and an angular map twice 180 degrees across.
    """
    first = found[0]
    over_half_a_turn = first.rows // 2 if isinstance(first.chart, Angular) else first.rows * (2 if len(found) > 1 else 1)
    return max(1, min(_MOST_BANDS, over_half_a_turn))


_SHAPES: dict[Layout, str] = {
    "angular": "1:1",
    "cube-cross": "4:3 (horizontal) or 3:4 (vertical), in whole faces",
    "cube-strip": "6:1 or 1:6, in whole faces",
    "equirect": "2:1",
}
_MOST_BANDS = 100


def _faces(places: dict[str, tuple[int, int]], size: int, *, back: Face = _FACES["back"]) -> list[Patch]:
    charts = {**_FACES, "back": back}
    return [Patch(row * size, column * size, size, size, charts[name]) for name, (row, column) in places.items()]
