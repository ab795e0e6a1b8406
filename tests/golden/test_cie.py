"""The CIE's skies against ISO 15469's groups and the older standards' formulas and figures."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from skylight_sh.light.cie_general import CieGeneral
from skylight_sh.light.cie_traditional import CieTraditional

from golden.oracles import angle, hemisphere, towards, upper

# ISO 15469:2004 (CIE S 011), tables 1 and 2: six gradation groups (a, b), six indicatrix groups (c, d, e), fifteen types.
GRADATION = {
    "I": (4.0, -0.70),
    "II": (1.1, -0.80),
    "III": (0.0, -1.00),
    "IV": (-1.0, -0.55),
    "V": (-1.0, -0.32),
    "VI": (-1.0, -0.15),
}
INDICATRIX = {
    1: (0.0, -1.0, 0.00),
    2: (2.0, -1.5, 0.15),
    3: (5.0, -2.5, 0.30),
    4: (10.0, -3.0, 0.45),
    5: (16.0, -3.0, 0.30),
    6: (24.0, -2.8, 0.15),
}
TYPES = {
    1: ("I", 1),
    2: ("I", 2),
    3: ("II", 1),
    4: ("II", 2),
    5: ("III", 1),
    6: ("III", 2),
    7: ("III", 3),
    8: ("III", 4),
    9: ("IV", 2),
    10: ("IV", 3),
    11: ("IV", 4),
    12: ("V", 4),
    13: ("V", 5),
    14: ("VI", 5),
    15: ("VI", 6),
}


def general(sky: int, theta: float, direction: np.ndarray) -> float:
    (a, b), (c, d, e) = GRADATION[TYPES[sky][0]], INDICATRIX[TYPES[sky][1]]

    def gradation(zenith: float) -> float:
        return 1 + a * math.exp(b / math.cos(zenith))

    def indicatrix(chi: float) -> float:
        return 1 + c * (math.exp(d * chi) - math.exp(d * math.pi / 2)) + e * math.cos(chi) ** 2

    zenith, chi = angle(direction, towards(0.0)), angle(direction, towards(theta))
    return gradation(zenith) * indicatrix(chi) / (gradation(0.0) * indicatrix(theta))


@pytest.mark.parametrize("sky", TYPES)
@pytest.mark.parametrize("theta", [0.0, 0.62, 1.4])
def test_every_type_of_iso_15469(sky: Any, theta: float) -> None:
    where = upper(40, seed=3)
    got = CieGeneral(sky=sky).radiance(where, {"sun_zenith": np.array(theta)})[:, 0]
    assert got == pytest.approx([general(sky, theta, d) for d in where], rel=1e-11)


def luminance(sky: Any, where: np.ndarray, theta: float) -> np.ndarray:
    return CieTraditional(sky=sky).radiance(where, {"sun_zenith": np.array(theta)})[:, 0]


def test_the_overcast_sky_is_moon_and_spencers() -> None:
    """1942: three times as bright at the zenith as on the horizon, and 7 pi / 9 lx for a zenith of 1 cd/m2."""
    horizon, zenith = luminance("overcast", np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]), 0.5)
    assert (horizon, zenith) == (pytest.approx(1 / 3, rel=1e-14), pytest.approx(1.0, rel=1e-14))
    where, solid = hemisphere(20)
    assert (luminance("overcast", where, 0.5) * where[:, 2]) @ solid == pytest.approx(7 * math.pi / 9, rel=1e-12)


@pytest.mark.parametrize("theta", [0.0, 0.7, 1.5])
def test_the_named_skies_are_their_standards(theta: float) -> None:
    """Kittler's of CIE 22 (1973), Pierpoint's of IES RP-21 (1984), Nakamura's by Radiance's skybright.cal (``intersky``).

    0.274 and 0.55067 are the standards' own printed values of 1 - exp(-0.32) and 1 - exp(-0.80).
    """
    where = upper(60, seed=5)
    zenith = np.array([angle(d, towards(0.0)) for d in where])
    gamma = np.array([angle(d, towards(theta)) for d in where])
    clear = (0.91 + 10 * np.exp(-3 * gamma) + 0.45 * np.cos(gamma) ** 2) * (1 - np.exp(-0.32 / np.cos(zenith)))
    clear /= (0.91 + 10 * math.exp(-3 * theta) + 0.45 * math.cos(theta) ** 2) * 0.27385
    assert luminance("clear", where, theta) == pytest.approx(clear, rel=1e-5)
    assert abs(1 - 0.274 / 0.27385) < 6e-4
    partly = (0.526 + 5 * np.exp(-1.5 * gamma)) * (1 - np.exp(-0.80 / np.cos(zenith)))
    partly /= (0.526 + 5 * math.exp(-1.5 * theta)) * 0.55067
    assert luminance("partly-cloudy", where, theta) == pytest.approx(partly, rel=1e-5)

    def intersky(eta: Any, zt: float, g: Any) -> Any:
        scale = (1.35 * np.sin(5.631 - 3.59 * eta) + 3.12) * np.sin(4.396 - 2.6 * zt) + 6.37 - eta
        return scale / 2.326 * np.exp(g * -0.563 * ((2.629 - eta) * (1.562 - zt) + 0.812))

    expected = intersky(zenith, theta, gamma) / intersky(0.0, theta, theta)
    assert luminance("intermediate", where, theta) == pytest.approx(expected, rel=1e-11)


def test_two_standards_agree_on_the_clear_sky() -> None:
    """ISO 15469 says that type 12 is the clear sky of 1973, whose 0.91 is 1 - 10 exp(-3 pi / 2), rounded."""
    where = upper(80, seed=7)
    for theta in (0.3, 1.2):
        modern = CieGeneral(sky=12).radiance(where, {"sun_zenith": np.array(theta)})[:, 0]
        assert luminance("clear", where, theta) == pytest.approx(modern, rel=1e-3)


def test_the_suns_of_the_standards_stand_above_the_horizon() -> None:
    for light in (CieGeneral(sky=3), CieTraditional(sky="clear")):
        domain = light.domains["sun_zenith"]
        assert (domain.low, domain.high) == (0.0, math.pi / 2)
