"""Oren and Nayar's rough diffuse surface, their qualitative model."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from skylight_sh.reflectance.models.protocol import Array, check_share


@dataclass(frozen=True)
class OrenNayar:
    """Facets of Lambert's kind whose slopes spread by ``sigma`` (radians, 0 to pi/2), without light between them.

    Oren and Nayar 1994, eq. 30: ``albedo / pi (A + B max(0, cos(phi_i - phi_o)) sin(a) tan(b))``, a the larger and b the
    smaller of the two zenith angles. Of ``sigma`` 0 it is Lambert's.

    >>> up = np.array([0.0, 0.0, 1.0])
    >>> float(OrenNayar((1.0,), sigma=0.0).values(up, up)[0].round(4))
    0.3183
    """

    albedo: tuple[float, ...] = (0.5, 0.5, 0.5)
    sigma: float = 0.35

    def __post_init__(self) -> None:
        check_share("albedo", self.albedo)
        if not 0.0 <= self.sigma <= np.pi / 2:
            raise ValueError(f"Invalid sigma {self.sigma!r}. Should be in radians, from 0 to pi/2.")

    @property
    def title(self) -> str:
        """Name for people."""
        return f"Oren-Nayar, sigma {self.sigma:g}, albedo {', '.join(f'{a:g}' for a in self.albedo)}"

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
        square = self.sigma**2
        constant, factor = 1 - 0.5 * square / (square + 0.33), 0.45 * square / (square + 0.09)
        # sin(a) tan(b) cos(phi) is the flat parts' dot product over the larger of the two cosines.
        flat = incident[..., 0] * views[..., 0] + incident[..., 1] * views[..., 1]
        higher = np.maximum(np.maximum(incident[..., 2], views[..., 2]), 1e-300)
        # Both directions on the surface's edge: the model's tangent has no end there.
        shape = constant + factor * np.minimum(np.maximum(flat, 0.0) / higher, _STEEPEST)
        return np.asarray(shape[..., np.newaxis] * (np.array(self.albedo) / np.pi))


# The tangent at 0.06 degrees from the edge: two such directions are met by no quadrature and no picture.
_STEEPEST = 1e3
