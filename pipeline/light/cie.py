"""The CIE's skies, relative to the zenith luminance: the fifteen general ones, and the older ones known by name.

The fifteen are CIE S 011 / ISO 15469:2004. The named ones are what Green (2003) lists; his printed formulas are pictures,
so these are the standards' own:

- overcast: Moon and Spencer 1942, adopted by the CIE in 1955 (ISO 15469 keeps it as its formula 3);
- clear: Kittler 1967, CIE 22 (1973);
- partly cloudy: Pierpoint 1983, IES RP-21 (1984), the formula that goes by "CIE partly cloudy" in graphics;
- intermediate: Nakamura, Oki and others 1985, CIE 110 (1994), what the CIE itself offers between clear and overcast,
  with the constants of Radiance's gensky.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, Literal

import numpy as np

from pipeline.light.one_channel import OneChannel
from pipeline.light.protocol import OPTIONS, Array, Domain, Hints, Parameters, sun_angle

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

_DOMAINS: Mapping[str, Domain] = {
    "sun_zenith": Domain(0.0, float(np.pi / 2), "rad", "the standard describes a sun above the horizon"),
}


class _Relative(OneChannel):
    """What all of these skies share: the axis of the sun's zenith angle."""

    __pydantic_config__: ClassVar[Mapping[str, object]] = OPTIONS

    @property
    def domains(self) -> Mapping[str, Domain]:
        """Sun zenith."""
        return _DOMAINS


@dataclass(frozen=True)
class CieGeneral(_Relative):
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
        """Mirror-symmetric with a cusp at the sun."""
        return Hints(mirrored=True, peak_axis="sun_zenith")

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


@dataclass(frozen=True)
class CieTraditional(_Relative):
    """The sky named ``sky`` over ``sun_zenith`` in radians; the zenith's luminance is 1 cd/m2.

    The overcast sky is the same wherever the sun stands. It takes the parameter all the same, so that a renderer asks
    every sky alike; its config gives the axis ``degrees = [0, 0]`` over the whole range.
    """

    sky: Literal["overcast", "clear", "partly-cloudy", "intermediate"]
    """overcast, clear, partly-cloudy or intermediate"""
    model: Literal["cie_traditional"] = "cie_traditional"
    """One of the older CIE skies."""

    @property
    def title(self) -> str:
        """Name for people."""
        return f"CIE {self.sky.replace('-', ' ')} sky"

    @property
    def hints(self) -> Hints:
        """Mirror-symmetric; a cusp at the sun, but for the overcast sky, which is round about the zenith."""
        if self.sky == "overcast":
            return Hints(mirrored=True, peak_zenith=0.0)
        return Hints(mirrored=True, peak_axis="sun_zenith")

    def radiance(self, directions: Array, parameters: Parameters) -> Array:
        """Return ``(..., 1)``: the named formula over its value towards the zenith."""
        theta, height = parameters["sun_zenith"], directions[..., 2]
        if self.sky == "overcast":
            return np.asarray((1.0 + 2.0 * height) / 3.0 + np.zeros_like(theta))[..., np.newaxis]
        gamma, cos_gamma = sun_angle(directions, theta)
        secant = 1.0 / np.maximum(height, 1e-300)
        if self.sky == "clear":
            value = _clear(secant, gamma, cos_gamma) / _clear(np.ones(()), theta, np.cos(theta))
        elif self.sky == "partly-cloudy":
            value = _partly_cloudy(secant, gamma) / _partly_cloudy(np.ones(()), theta)
        else:
            zenith = np.arctan2(np.hypot(directions[..., 0], directions[..., 1]), height)
            value = _intermediate(zenith, theta, gamma) / _intermediate(np.zeros(()), theta, theta)
        return np.asarray(value)[..., np.newaxis]


def _clear(secant: Array, gamma: Array, cos_gamma: Array) -> Array:
    return np.asarray((0.91 + 10.0 * np.exp(-3.0 * gamma) + 0.45 * cos_gamma**2) * -np.expm1(-0.32 * secant))


def _partly_cloudy(secant: Array, gamma: Array) -> Array:
    return np.asarray((0.526 + 5.0 * np.exp(-1.5 * gamma)) * -np.expm1(-0.80 * secant))


def _intermediate(zenith: Array, theta: Array, gamma: Array) -> Array:
    """CIE 110's fit, with zenith angles of the direction and the sun for its altitudes; the scale cancels."""
    level = (1.35 * np.sin(5.631 - 3.59 * zenith) + 3.12) * np.sin(4.396 - 2.6 * theta) + 6.37 - zenith
    return np.asarray(level * np.exp(-0.563 * gamma * ((2.629 - zenith) * (1.562 - theta) + 0.812)))
