"""Lambert's surface, as bright from everywhere."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from skylight_sh.reflectance.models.protocol import Array, check_share


@dataclass(frozen=True)
class Lambert:
    """A diffuse surface: ``albedo / pi`` (linear RGB, 0 to 1).

    >>> float(Lambert((0.5,)).values(np.array([0.6, 0.0, 0.8]), np.array([0.0, 0.0, 1.0]))[0].round(4))
    0.1592
    """

    albedo: tuple[float, ...] = (0.5, 0.5, 0.5)

    def __post_init__(self) -> None:
        check_share("albedo", self.albedo)

    @property
    def title(self) -> str:
        """Name for people."""
        return f"Lambert, albedo {', '.join(f'{a:g}' for a in self.albedo)}"

    @property
    def channels(self) -> int:
        """Those of the albedo."""
        return len(self.albedo)

    @property
    def isotropic(self) -> bool:
        """It is."""
        return True

    @property
    def mirrored(self) -> bool:
        """It is."""
        return True

    def values(self, incident: Array, views: Array) -> Array:
        """Return ``(..., channels)`` in 1/sr; see ``Model.values``."""
        lead = np.broadcast_shapes(incident.shape[:-1], views.shape[:-1])
        return np.broadcast_to(np.array(self.albedo) / np.pi, (*lead, self.channels)).copy()
