"""A rough mirror of GGX facets with Smith's masking and Schlick's Fresnel factor, above a diffuse surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from skylight_sh.reflectance.models.protocol import Array, check_share


@dataclass(frozen=True)
class Ggx:
    """A microfacet surface: ``D F G / (4 cos_i cos_o)`` plus ``albedo / pi``.

    ``alpha`` from 0.001 to 1 is the facets' slope (of many engines' "roughness" the square), ``alpha_y`` that along y
    where it differs: brushed metal. ``specular`` is the Fresnel factor at normal incidence, ``albedo`` of what lies below,
    which is not dimmed by the mirror above it.

    D: Trowbridge and Reitz 1975, as in Walter et al. 2007, eq. 33; G: Smith's, of heights that incident and view direction
    share (Heitz 2014, eq. 99); F: Schlick 1994, eq. 15.

    >>> up = np.array([0.0, 0.0, 1.0])
    >>> float(Ggx(alpha=0.5, specular=(1.0,)).values(up, up)[0].round(4))  # 1 / (4 pi alpha**2)
    0.3183
    """

    alpha: float = 0.25
    specular: tuple[float, ...] = (0.04, 0.04, 0.04)
    albedo: tuple[float, ...] = ()
    alpha_y: float | None = None

    def __post_init__(self) -> None:
        for name, value in (("alpha", self.alpha), ("alpha_y", self.slopes[1])):
            if not _LEAST <= value <= 1.0:
                raise ValueError(f"Invalid {name} {value!r}. Should be from {_LEAST:g} to 1.")
        check_share("specular", self.specular)
        if self.albedo and len(check_share("albedo", self.albedo)) != len(self.specular):
            raise ValueError(f"Invalid albedo {self.albedo}. Should have {len(self.specular)} numbers, as the specular.")

    @property
    def slopes(self) -> tuple[float, float]:
        """Along x and y."""
        return (self.alpha, self.alpha if self.alpha_y is None else self.alpha_y)

    @property
    def title(self) -> str:
        """Name for people."""
        return f"GGX, alpha {' x '.join(f'{a:g}' for a in dict.fromkeys(self.slopes))}"

    @property
    def channels(self) -> int:
        """Those of the specular colour."""
        return len(self.specular)

    @property
    def isotropic(self) -> bool:
        """Where both slopes are one."""
        return self.slopes[0] == self.slopes[1]

    @property
    def mirrored(self) -> bool:
        """Mirroring both directions in y changes nothing."""
        return True

    def values(self, incident: Array, views: Array) -> Array:
        """Return ``(..., channels)`` in 1/sr; see ``Model.values``."""
        half = incident + views
        length = np.maximum(np.linalg.norm(half, axis=-1, keepdims=True), 1e-300)
        half = half / length
        # The cosine between a direction and the half vector, written so that nothing cancels.
        facing = 0.5 * length[..., 0]
        mirror = self.facets(half) * self._shadowing(incident, views)
        specular = np.array(self.specular)
        fresnel = specular + (1 - specular) * (np.clip(1 - facing, 0.0, 1.0) ** 5)[..., np.newaxis]
        found = mirror[..., np.newaxis] * fresnel
        return np.asarray(found + np.array(self.albedo) / np.pi if self.albedo else found)

    def facets(self, half: Array) -> Array:
        """Return how many facets face ``half`` ``(..., 3)``: D, ``(...)`` in 1/sr, whose integral times z is 1."""
        x, y = self.slopes
        stretched = np.square(half[..., 0] / x) + np.square(half[..., 1] / y) + np.square(half[..., 2])
        return np.asarray(1 / (np.pi * x * y * np.square(stretched)))

    def _shadowing(self, incident: Array, views: Array) -> Array:
        """Return ``G / (4 cos_i cos_o)``, finite on the edge: with Smith's Lambda, G is 1 / (1 + Lambda_i + Lambda_o)."""
        one, other = (self._slanted(directions) for directions in (incident, views))
        below = views[..., 2] * one + incident[..., 2] * other
        return np.asarray(0.5 / np.maximum(below, 1e-300))

    def _slanted(self, directions: Array) -> Array:
        """Return ``(1 + 2 Lambda) cos``: the root of the squared components times the slopes."""
        x, y = self.slopes
        squares = np.square(directions[..., 0] * x) + np.square(directions[..., 1] * y) + np.square(directions[..., 2])
        return np.asarray(np.sqrt(squares))


# Narrower lobes are mirrors, which SH cannot hold.
_LEAST = 1e-3
