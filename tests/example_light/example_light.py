"""What another package needs to offer a light: one class, and one line in its pyproject.toml."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray
from skylight_sh.light import Domain, Hints

Array = NDArray[np.float64]


class Glow:
    """A glow of width ``width`` about the sun over a constant sky, one channel; it tells nothing about itself."""

    channels = ("luminance",)
    luminance_row = np.ones(1)
    hints = Hints()
    version = ""

    def __init__(self, width: float = 1.0) -> None:
        self.width = width
        self.title = f"Glow of width {width:g}"

    @property
    def domains(self) -> Mapping[str, Domain]:
        """How high the sun stands, and how strong its glow is."""
        return {
            "sun_zenith": Domain(0.0, float(np.pi / 2), "rad", "a sun above the horizon"),
            "strength": Domain(0.0, 10.0, "1", "a glow takes no light away"),
        }

    def radiance(self, directions: Array, parameters: Mapping[str, Array]) -> Array:
        """Return ``(..., 1)`` in cd/m2."""
        theta = parameters["sun_zenith"]
        cosine = directions[..., 0] * np.sin(theta) + directions[..., 2] * np.cos(theta)
        glow = 1.0 + parameters["strength"] * np.exp((cosine - 1.0) / self.width**2)
        return np.asarray(1000.0 * glow)[..., np.newaxis]
