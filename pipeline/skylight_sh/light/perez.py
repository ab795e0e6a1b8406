"""The Perez all-weather sky (Perez, Seals and Michalsky 1993), one clearness category at a time.

A category (1 overcast to 8 clear) is a bin of the clearness epsilon, within which the shape depends on the sun's zenith
angle Z and the sky brightness Delta = D m / E0: diffuse horizontal irradiance times air mass over extraterrestrial
irradiance. Between categories the model jumps, so that each is a light of its own.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from skylight_sh.formula.elementary import cos, exp, label
from skylight_sh.light.mixins import OneChannel, OwnCode
from skylight_sh.light.protocol import OPTIONS, Array, Domain, Hints, Parameters, Prefactor, sun_angle

Floats = NDArray[np.floating]

# Rows a..e of each category, in a line of twenty; columns x1..x4 of x1 + x2 Z + Delta (x3 + x4 Z). Table 1 of the paper.
# Rows c and d of category 1 belong to formulas of their own. Compared number by number with two other programs (perezsky,
# UMEP); the printed table was not at hand.
_SHAPE = (
    "1.3525 -.2576 -.2690 -1.4366  -.7670 .0007 1.2734 -.1233  2.8 .6004 1.2375 1  1.8734 .6297 .9738 .2809  "
    ".0356 -.1246 -.5718 .9938",
    "-1.2219 -.7730 1.4148 1.1016  -.2054 .0367 -3.9128 .9156  6.9750 .1774 6.4477 -.1239  "
    "-1.5798 -.5081 -1.7812 .1080  .2624 .0672 -.2190 -.4285",
    "-1.1 -.2515 .8952 .0156  .2782 -.1812 -4.5 1.1766  24.7219 -13.0812 -37.7 34.8438  -5 1.5218 3.9229 -2.6204  "
    "-.0156 .1597 .4199 -.5562",
    "-.5484 -.6654 -.2672 .7117  .7234 -.6219 -5.6812 2.6297  33.3389 -18.3 -62.25 52.0781  -3.5 .0016 1.1477 .1062  "
    ".4659 -.3296 -.0876 -.0329",
    "-.6 -.3566 -2.5 2.3250  .2937 .0496 -5.6812 1.8415  21 -4.7656 -21.5906 7.2492  -3.5 -.1554 1.4062 .3988  "
    ".0032 .0766 -.0656 -.1294",
    "-1.0156 -.3670 1.0078 1.4051  .2875 -.5328 -3.85 3.3750  14 -.9999 -7.1406 7.5469  -3.4 -.1078 -1.0750 1.5702  "
    "-.0672 .4016 .3017 -.4844",
    "-1 .0211 .5025 -.5119  -.3 .1922 .7023 -1.6317  19 -5 1.2438 -1.9094  -4 .0250 .3844 .2656  "
    "1.0468 -.3788 -2.4517 1.4656",
    "-1.05 .0289 .4260 .3590  -.3250 .1156 .7781 .0025  31.0625 -14.5 -46.1148 55.3750  -7.2312 .4050 13.35 .6234  "
    "1.5 -.6426 1.8564 .5636",
)

# Zenith luminance over diffuse irradiance, cd/W: a + c cos Z + c' exp(-3 Z) + d Delta (Perez and others 1990).
# Integrated over the sky with the shape above, it gives that paper's diffuse illuminance in the median, with single cases
# from 0.75 to 1.45 of it (tests).
_ZENITH = (
    (40.86, 26.77, -29.59, -45.75),
    (26.58, 14.73, 58.46, -21.25),
    (19.34, 2.28, 100.00, 0.25),
    (13.25, -1.39, 124.79, 15.66),
    (14.47, -5.09, 160.09, 9.13),
    (19.76, -3.88, 154.61, -19.21),
    (28.39, -9.67, 151.58, -69.39),
    (42.91, -19.62, 130.80, -164.08),
)
_SOLAR_CONSTANT = 1367.0

# Least and largest brightness at which, for every sun above the horizon, the whole sky is positive and b < 0. Below, the
# zenith turns black; above, exp(b / cos z) grows without bound at the horizon, or the sky far from the sun turns black.
_BRIGHTNESS = (
    (0.01, 0.55, "0.01 is the least that gendaylit allows, and higher b nears 0: the horizon's edge is no longer smooth"),
    (0.20, 0.60, "lower the zenith turns black (1 + a exp b <= 0) for a low sun, and 0.6 is the most that gendaylit allows"),
    (0.15, 0.60, "lower the zenith turns black (1 + a exp b <= 0), and 0.6 is the most that gendaylit allows"),
    (0.15, 0.55, "lower b >= 0, where the horizon is infinite, and higher the sky behind a high sun turns black"),
    (0.15, 0.60, "lower the zenith turns black or the horizon infinite (b >= 0), and 0.6 is the most that gendaylit allows"),
    (0.10, 0.35, "lower the zenith turns black for a high sun, and higher b >= 0, where the horizon is infinite"),
    (0.05, 0.40, "lower b nears 0 for a low sun, and higher b >= 0, where the horizon is infinite"),
    (0.01, 0.15, "0.01 is the least that gendaylit allows, and higher b >= 0, where the horizon is infinite"),
)


@dataclass(frozen=True)
class Perez(OwnCode, OneChannel):
    """Clearness category ``category`` over ``sun_zenith`` (radians) and ``brightness`` (Perez's Delta).

    ``quantity`` is ``relative``, with a zenith of 1 cd/m2, or ``absolute``: the zenith's luminance is then the 1990
    model's, with a solar constant of 1367 W/m2 at the mean distance. One channel, luminance in cd/m2.
    """

    __pydantic_config__: ClassVar[Mapping[str, object]] = OPTIONS

    category: Literal[1, 2, 3, 4, 5, 6, 7, 8]
    """clearness, 1 (overcast) to 8 (clear)"""
    quantity: Literal["relative", "absolute"] = "relative"
    """relative (the zenith's luminance is 1) or absolute (cd/m2, by the 1990 model of the zenith)"""
    model: Literal["perez"] = "perez"
    """The Perez all-weather sky."""

    @property
    def title(self) -> str:
        """Name for people."""
        return f"Perez all-weather sky, clearness category {self.category}, {self.quantity}"

    @property
    def domains(self) -> Mapping[str, Domain]:
        """Sun zenith, and the category's own range of brightness."""
        return {
            "sun_zenith": Domain(0.0, float(np.pi / 2), "rad", "the model describes a sun above the horizon"),
            "brightness": Domain(*_BRIGHTNESS[self.category - 1][:2], "1", _BRIGHTNESS[self.category - 1][2]),
        }

    @cached_property
    def hints(self) -> Hints:
        """Mirror-symmetric, a cusp at the sun, and the shape towards the zenith as prefactor.

        That shape nears 0 in the corners of most categories' domains, where no polynomial follows its reciprocal. Category
        1, whose zenith never darkens, does without.
        """
        if self.category == 1:
            return Hints(mirrored=True, peak_axis="sun_zenith")
        numbers = tuple(_rows(self.category).ravel().tolist())
        prefactor = Prefactor("perez_zenith", ("sun_zenith", "brightness"), numbers, zenith_factor)
        return Hints(mirrored=True, peak_axis="sun_zenith", prefactor=prefactor)

    def radiance(self, directions: Array, parameters: Parameters) -> Array:
        """Return ``(..., 1)``: gradation times indicatrix, over their values towards the zenith, in cd/m2."""
        theta, delta = parameters["sun_zenith"], parameters["brightness"]
        a, b, c, d, e = shape(self.category, theta, delta)
        gamma, cos_gamma = sun_angle(directions, theta)

        def indicatrix(angle: Array, cosine: Array) -> Array:
            return np.asarray(1.0 + c * np.exp(d * angle) + e * cosine**2)

        zenith = (1.0 + a * np.exp(b)) * indicatrix(theta, np.cos(theta))
        if self.quantity == "absolute":
            zenith = zenith / zenith_luminance(self.category, theta, delta)
        gradation = 1.0 + a * np.exp(b / np.maximum(directions[..., 2], 1e-300))
        return np.asarray(gradation * indicatrix(gamma, cos_gamma) / zenith)[..., np.newaxis]


def _rows(category: int) -> Array:
    """Rows a..e of four numbers each."""
    return np.array(_SHAPE[category - 1].split(), dtype=np.float64).reshape(5, 4)


def zenith_factor(theta: Any, delta: Any, k: Sequence[Any]) -> Any:
    """Return 1 over the shape towards the zenith: a formula of generic numbers; ``k`` are rows a..e of four."""
    rows = [k[i : i + 4] for i in range(0, 20, 4)]
    a, b, c, d, e = (
        label(x1 + x2 * theta + delta * (x3 + x4 * theta), name)
        for name, (x1, x2, x3, x4) in zip("abcde", rows, strict=True)
    )
    cosine, up, halo = label(cos(theta), "cosine"), label(exp(b), "up"), label(exp(d * theta), "halo")
    return 1 / ((1 + a * up) * (1 + c * halo + e * (cosine * cosine)))


def shape(category: int, theta: Array, delta: Array) -> tuple[Array, ...]:
    """Return a, b, c, d and e of a category at sun zenith ``theta`` (radians) and brightness ``delta``."""
    rows = _rows(category).tolist()
    found = [np.asarray(x1 + x2 * theta + delta * (x3 + x4 * theta)) for x1, x2, x3, x4 in rows]
    if category == 1:
        (c1, c2, c3, c4), (d1, d2, d3, d4) = rows[2:4]
        found[2] = np.asarray(np.exp((delta * (c1 + c2 * theta)) ** c3) - c4)
        found[3] = np.asarray(-np.exp(delta * (d1 + d2 * theta)) + d3 + delta * d4)
    return tuple(found)


def zenith_luminance(category: int, theta: Array, delta: Array) -> Array:
    """Return the zenith luminance in cd/m2 (Perez, Ineichen, Seals and others 1990), the sun at its mean distance.

    The diffuse irradiance follows from ``delta`` with the air mass of Kasten and Young 1989, which is finite on the
    horizon. A regression over measurements, no more: beside the same paper's diffuse efficacy it is off by up to 45 % in
    single cases, and in category 7 above a brightness of 0.2 too dark by half.
    """
    a, c, c_exp, d = _ZENITH[category - 1]
    mass = 1.0 / (np.cos(theta) + 0.50572 * (96.07995 - np.degrees(theta)) ** -1.6364)
    diffuse = delta * _SOLAR_CONSTANT / mass
    return np.asarray(diffuse * (a + c * np.cos(theta) + c_exp * np.exp(-3.0 * theta) + d * delta))
