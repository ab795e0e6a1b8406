"""What a reflectance model is: a function of two directions in the surface's own frame, and how symmetric it is."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Model(Protocol):
    """How a surface reflects, seen in its own frame: z is the normal, x the tangent."""

    @property
    def title(self) -> str:
        """Name for people, numbers included."""

    @property
    def channels(self) -> int:
        """How many numbers ``values`` has for a pair of directions, such as 3 for red, green and blue."""

    @property
    def isotropic(self) -> bool:
        """Whether nothing changes where the surface is turned about its normal."""

    @property
    def mirrored(self) -> bool:
        """Whether nothing changes where both directions are mirrored in y: then half the directions are sampled."""

    def values(self, incident: Array, views: Array) -> Array:
        """Return the reflectance f ``(..., channels)`` in 1/sr, its cosine left out.

        ``incident`` and ``views`` are unit vectors ``(..., 3)`` that point away from the surface and broadcast. Directions
        below the surface are not asked for; on its edge values are finite.
        """


def check_share(name: str, values: Sequence[float]) -> tuple[float, ...]:
    """Return an albedo's or a specular colour's numbers; raises ValueError for none of them, or one outside [0, 1]."""
    found = tuple(float(value) for value in values)
    if not found or not all(0.0 <= value <= 1.0 for value in found):
        raise ValueError(f"Invalid {name} {found}. Should be a number from 0 to 1 for each channel.")
    return found
