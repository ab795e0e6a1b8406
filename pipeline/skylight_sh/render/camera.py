"""A pinhole camera, and where in its pixels rays pass."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError

Array = NDArray[np.float64]

# Of the plastic number: the additive sequence that spreads evenly over a square.
_PLASTIC = 1.32471795724474602596
_STEPS = np.array([1.0 / _PLASTIC, 1.0 / _PLASTIC**2])


@dataclass(frozen=True)
class Camera:
    """A camera at ``eye`` that looks at ``target``, +z up, as ``width`` x ``height`` square pixels.

    ``field`` is the vertical angle of view in degrees; ``columns``, first and one past the last, are what a picture shows of
    the width, all of it if left out. Raises UserError for what no picture has.

    >>> ahead = Camera((0.0, -5.0, 1.0), (0.0, 0.0, 1.0), 40.0, 3, 3).directions()[1, 1]
    >>> [abs(round(float(c), 6)) for c in ahead]
    [0.0, 1.0, 0.0]
    """

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    field: float
    width: int
    height: int
    columns: tuple[int, int] | None = None

    def __post_init__(self) -> None:
        if not 0.0 < self.field < 180.0:
            raise UserError(f"Invalid field {self.field:g}. Should be degrees between 0 and 180.")
        if not (1 <= self.width <= 16384 and 1 <= self.height <= 16384):
            raise UserError(f"Invalid size {self.width}x{self.height}. Should be from 1x1 to 16384x16384 pixels.")
        ahead = np.subtract(self.target, self.eye)
        if not np.isfinite(ahead).all() or np.hypot(ahead[0], ahead[1]) <= 1e-6 * np.abs(ahead[2]):
            raise UserError(
                f"Invalid view from {self.eye} to {self.target}. Should be two places, neither above the other: +z is up."
            )

    @property
    def shown(self) -> slice:
        """The columns that a picture shows."""
        return slice(*self.columns) if self.columns else slice(0, self.width)

    def directions(self, within: Array | tuple[float, float] = (0.5, 0.5)) -> Array:
        """Return unit vectors ``(height, width, ..., 3)`` through the pixels, the first row on top.

        ``within`` ``(..., 2)`` says where in each pixel: from the left and from above, 0 to 1.
        """
        return self.through(np.arange(self.height * self.width), within).reshape(
            self.height, self.width, *np.shape(within)[:-1], 3
        )

    def through(self, pixels: NDArray[np.int64], within: Array | tuple[float, float] = (0.5, 0.5)) -> Array:
        """Return the same for some ``pixels`` ``(n,)``, counted along rows: unit vectors ``(n, ..., 3)``."""
        at = np.asarray(within, dtype=np.float64)
        ahead = np.subtract(self.target, self.eye).astype(np.float64)
        ahead /= np.linalg.norm(ahead)
        right = np.array([ahead[1], -ahead[0], 0.0])
        right /= np.linalg.norm(right)
        down = np.cross(ahead, right)
        reach = np.tan(np.radians(self.field) / 2.0)
        rank = (len(pixels), *(1 for _ in at.shape[:-1]))
        x = (2.0 * ((pixels % self.width).reshape(rank) + at[..., 0]) - self.width) / self.height * reach
        y = (2.0 * ((pixels // self.width).reshape(rank) + at[..., 1]) / self.height - 1.0) * reach
        along = ahead + x[..., np.newaxis] * right + y[..., np.newaxis] * down
        return np.asarray(along / np.linalg.norm(along, axis=-1, keepdims=True))


def spread(count: int, start: float = 0.5) -> Array:
    """Return ``count`` points ``(count, 2)`` that cover the unit square evenly, one alone in its middle.

    An additive recurrence by powers of the plastic number (Roberts 2018), ``start`` its first point.

    >>> spread(1).tolist()
    [[0.5, 0.5]]
    """
    return np.asarray((start + np.arange(count)[:, np.newaxis] * _STEPS) % 1.0)
