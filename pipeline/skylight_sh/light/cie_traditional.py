"""The older CIE skies known by name, relative to the zenith luminance.

They are what Green (2003) lists; his printed formulas are pictures, so these are the standards' own:

- overcast: Moon and Spencer 1942, adopted by the CIE in 1955 (ISO 15469 keeps it as its formula 3);
- clear: Kittler 1967, CIE 22 (1973);
- partly cloudy: Pierpoint 1983, IES RP-21 (1984), the formula that goes by "CIE partly cloudy" in graphics;
- intermediate: Nakamura, Oki and others 1985, CIE 110 (1994), what the CIE itself offers between clear and overcast,
  with the constants of Radiance's gensky.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from skylight_sh.light.mixins import Relative
from skylight_sh.light.protocol import Array, Hints, Parameters, sun_angle


@dataclass(frozen=True)
class CieTraditional(Relative):
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
