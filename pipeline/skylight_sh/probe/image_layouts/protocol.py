"""What a layout of pictures over the sphere is: a list of patches, rectangles of the picture with one chart each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.probe.charts import Chart

Array = NDArray[np.float64]


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


@dataclass(frozen=True)
class ImageLayout:
    """How a picture covers the sphere.

    ``patches(height, width)`` returns those of a picture of so many texels, or none where its ``proportions`` are others.
    ``half_turns`` is how many times half a turn, 180 degrees, the rows of a patch cover.
    """

    proportions: str
    patches: Callable[[int, int], list[Patch]]
    half_turns: float
