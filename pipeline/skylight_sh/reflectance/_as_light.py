"""A surface's reflection towards a view, as a light on the upper hemisphere: what the truth rules integrate."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.light.protocol import Domain, Hints, Parameters
from skylight_sh.reflectance.models.protocol import Model

Array = NDArray[np.float64]

VIEW = "view_zenith"


@dataclass(frozen=True)
class Reflection:
    """``f cos_i`` of a ``model``, whose mirror direction stands ``view_zenith`` from the normal, at azimuth 0.

    The view hence stands at azimuth pi, and the surface's tangent at minus ``azimuth``, the mirror direction's in the
    surface's own frame.
    """

    model: Model
    azimuth: float = 0.0

    @property
    def title(self) -> str:
        """The model's."""
        return self.model.title

    @property
    def version(self) -> str:
        """Our own code."""
        return ""

    @property
    def channels(self) -> tuple[str, ...]:
        """The model's, by their numbers."""
        return tuple(str(k) for k in range(self.model.channels))

    @property
    def luminance_row(self) -> Array:
        """All alike."""
        return np.ones(self.model.channels)

    @property
    def domains(self) -> Mapping[str, Domain]:
        """The view's zenith angle."""
        return {VIEW: Domain(0.0, float(np.pi / 2), "rad", "surfaces are seen from above")}

    @property
    def hints(self) -> Hints:
        """The peak is about the mirror direction; only a view along x or y keeps the mirror symmetry of the model."""
        mirrored = self.model.mirrored and (self.model.isotropic or self.azimuth == 0.0)
        return Hints(mirrored=mirrored, peak_axis=VIEW)

    def radiance(self, directions: Array, parameters: Parameters) -> Array:
        """Return ``f cos_i`` of shape ``(..., channels)``; see ``Light.radiance``."""
        zenith = np.asarray(parameters[VIEW], dtype=np.float64)
        views = np.stack([-np.sin(zenith), np.zeros_like(zenith), np.cos(zenith)], axis=-1)
        cosine = np.maximum(directions[..., 2:], 0.0)
        return np.asarray(self.model.values(_turned(directions, self.azimuth), _turned(views, self.azimuth)) * cosine)


def _turned(directions: Array, azimuth: float) -> Array:
    """Return directions turned about z."""
    if not azimuth:
        return directions
    c, s = np.cos(azimuth), np.sin(azimuth)
    return np.asarray(directions @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]))
