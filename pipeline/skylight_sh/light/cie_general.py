"""The fifteen CIE general skies (CIE S 011 / ISO 15469:2004), relative to the zenith luminance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from skylight_sh.formula.elementary import cos, exp, label
from skylight_sh.light.mixins import Relative
from skylight_sh.light.protocol import Array, Hints, Parameters, Prefactor, sun_angle

# Gradation a, b and indicatrix c, d, e of sky types 1 (overcast) to 15 (white-blue turbid with broad corona).
_TYPES = (
    (4.0, -0.70, 0.0, -1.0, 0.00),
    (4.0, -0.70, 2.0, -1.5, 0.15),
    (1.1, -0.80, 0.0, -1.0, 0.00),
    (1.1, -0.80, 2.0, -1.5, 0.15),
    (0.0, -1.00, 0.0, -1.0, 0.00),
    (0.0, -1.00, 2.0, -1.5, 0.15),
    (0.0, -1.00, 5.0, -2.5, 0.30),
    (0.0, -1.00, 10.0, -3.0, 0.45),
    (-1.0, -0.55, 2.0, -1.5, 0.15),
    (-1.0, -0.55, 5.0, -2.5, 0.30),
    (-1.0, -0.55, 10.0, -3.0, 0.45),
    (-1.0, -0.32, 10.0, -3.0, 0.45),
    (-1.0, -0.32, 16.0, -3.0, 0.30),
    (-1.0, -0.15, 16.0, -3.0, 0.30),
    (-1.0, -0.15, 24.0, -2.8, 0.15),
)


@dataclass(frozen=True)
class CieGeneral(Relative):
    """Sky type ``sky`` (1 to 15) over ``sun_zenith`` in radians; the zenith's luminance is 1 cd/m2."""

    sky: Literal[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15]
    """type of ISO 15469, 1 (overcast) to 15 (white-blue turbid with a broad corona)"""
    model: Literal["cie_general"] = "cie_general"
    """One of the fifteen CIE general skies."""

    @property
    def title(self) -> str:
        """Name for people."""
        return f"CIE general sky, type {self.sky} (ISO 15469)"

    @property
    def hints(self) -> Hints:
        """Mirror-symmetric with a cusp at the sun; over the indicatrix towards the zenith even in the sun's zenith angle."""
        c, d, e = _TYPES[self.sky - 1][2:]
        numbers = (c, d, e, 1.0 - c * round(float(np.exp(d * np.pi / 2)), 6))
        return Hints(
            mirrored=True,
            peak_axis="sun_zenith",
            prefactor=Prefactor("cie_zenith", ("sun_zenith",), numbers, zenith_factor) if c or e else None,
            parity=True,
        )

    def radiance(self, directions: Array, parameters: Parameters) -> Array:
        """Return ``(..., 1)``: gradation times indicatrix, over their values towards the zenith (ISO 15469, eq. 1)."""
        a, b, c, d, e = _TYPES[self.sky - 1]
        theta = parameters["sun_zenith"]
        gamma, cos_gamma = sun_angle(directions, theta)
        gradation = 1.0 + a * np.exp(b / np.maximum(directions[..., 2], 1e-300))

        def indicatrix(angle: Array, cosine: Array) -> Array:
            return np.asarray(1.0 + c * (np.exp(d * angle) - np.exp(d * np.pi / 2)) + e * cosine**2)

        zenith = (1.0 + a * np.exp(b)) * indicatrix(theta, np.cos(theta))
        return np.asarray(gradation * indicatrix(gamma, cos_gamma) / zenith)[..., np.newaxis]


def zenith_factor(theta: Any, k: Sequence[Any]) -> Any:
    """Return 1 over the indicatrix towards the zenith, ``1 + c (exp(d theta) - exp(d pi / 2)) + e cos^2 theta``."""
    cosine = label(cos(theta), "cosine")
    return 1 / (k[3] + k[0] * exp(k[1] * theta) + k[2] * (cosine * cosine))
