"""The Perez all-weather sky against the perezsky package's tables and formulas written out anew."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import perezsky
import pytest
from perezsky.coefficients import LUMINANCE_1993
from skylight_sh.light import perez
from skylight_sh.light.perez import Perez

from golden.oracles import angle, towards, upper

# Perez and others 1990, table 4 "zenith luminance" (eq. 10), as Ladybug Tools and DTCC Solar print it: a, c, c', d.
ZENITH_1990 = """
40.86 26.77 -29.59 -45.75
26.58 14.73 58.46 -21.25
19.34 2.28 100.00 0.25
13.25 -1.39 124.79 15.66
14.47 -5.09 160.09 9.13
19.76 -3.88 154.61 -19.21
28.39 -9.67 151.58 -69.39
42.91 -19.62 130.80 -164.08
"""
SOLAR_CONSTANT = 1367.0  # W/m2, Radiance's gendaylit (solar_constant_e)


def shape(category: int, theta: float, delta: float) -> list[float]:
    """Perez, Seals and Michalsky 1993, eqs. 4 to 6 and the erratum, over perezsky 1.0.0's ``LUMINANCE_1993``."""
    x = LUMINANCE_1993[category - 1]
    out = [float(row[0] + row[1] * theta + delta * (row[2] + row[3] * theta)) for row in x]
    if category == 1:
        out[2] = math.exp((delta * (x[2][0] + x[2][1] * theta)) ** x[2][2]) - x[2][3]
        out[3] = -math.exp(delta * (x[3][0] + x[3][1] * theta)) + x[3][2] + delta * x[3][3]
    return out


def value(k: list[float], zenith: float, gamma: float) -> float:
    a, b, c, d, e = k
    return (1 + a * math.exp(b / math.cos(zenith))) * (1 + c * math.exp(d * gamma) + e * math.cos(gamma) ** 2)


def brightness(category: Any) -> list[float]:
    domain = Perez(category=category).domains["brightness"]
    return [domain.low, 0.3 * domain.low + 0.7 * domain.high, domain.high]


@pytest.mark.parametrize("category", range(1, 9))
def test_shape_and_sky(category: Any) -> None:
    where = upper(30, seed=11)
    for theta in (0.0, 0.55, 1.3):
        for delta in brightness(category):
            k = shape(category, theta, delta)
            got = [float(v) for v in perez.shape(category, np.array(theta), np.array(delta))]
            assert got == pytest.approx(k, rel=1e-12, abs=1e-12)
            sky = Perez(category=category).radiance(where, {"sun_zenith": np.array(theta), "brightness": np.array(delta)})
            expected = [value(k, angle(d, towards(0.0)), angle(d, towards(theta))) / value(k, 0.0, theta) for d in where]
            assert sky[:, 0] == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("category", range(1, 9))
def test_zenith_luminance(category: Any) -> None:
    a, c, c_exp, d = np.array(ZENITH_1990.split(), dtype=float).reshape(8, 4)[category - 1]
    for degrees in (3.0, 48.0, 86.0):
        theta = math.radians(degrees)
        for delta in brightness(category):
            # Kasten and Young 1989, as perezsky has it by that name.
            diffuse = delta * SOLAR_CONSTANT / float(perezsky.airmass(degrees))
            expected = diffuse * (a + c * math.cos(theta) + c_exp * math.exp(-3 * theta) + d * delta)
            got = float(perez.zenith_luminance(category, np.array(theta), np.array(delta)))
            assert got == pytest.approx(expected, rel=1e-12)
            at = {"sun_zenith": np.array(theta), "brightness": np.array(delta)}
            up = Perez(category=category, quantity="absolute").radiance(np.array([[0.0, 0.0, 1.0]]), at)
            assert float(up[0, 0]) == pytest.approx(expected, rel=1e-12)


def test_air_mass_and_constants_as_gendaylit_prints_them() -> None:
    """Kasten and Young 1989: 1 at the zenith, about 38 on the horizon; the printed table has 37.92 there and 10.32 at 85."""
    for degrees, printed in ((0.0, 1.0), (60.0, 1.994), (85.0, 10.306), (90.0, 37.92)):
        theta = math.radians(degrees)
        luminance = float(perez.zenith_luminance(3, np.array(theta), np.array(0.3)))
        a, c, c_exp, d = np.array(ZENITH_1990.split(), dtype=float).reshape(8, 4)[2]
        efficacy = a + c * math.cos(theta) + c_exp * math.exp(-3 * theta) + d * 0.3
        assert 0.3 * SOLAR_CONSTANT * efficacy / luminance == pytest.approx(printed, rel=2e-3)


def is_sky(category: int, delta: float) -> bool:
    """Whether the sky is positive everywhere and finite at the horizon, b clearly below 0, for every sun."""
    for theta in np.linspace(0, math.pi / 2, 31).tolist():
        a, b, c, d, e = shape(category, theta, delta)
        if b > -0.005:
            return False
        gradation = 1 + a * np.exp(b / np.cos(np.linspace(0, 1.5705, 40)))
        chi = np.linspace(0, math.pi / 2 + theta, 40)
        if min(gradation.min(), (1 + c * np.exp(d * chi) + e * np.cos(chi) ** 2).min()) <= 0:
            return False
    return True


@pytest.mark.parametrize("category", range(1, 9))
def test_limits_of_brightness_are_the_models_own(category: Any) -> None:
    """To 0.05 the widest range in which the model is a sky, within gendaylit's 0.01 to 0.6."""
    low, high = perezsky.model.DELTA_RANGE
    assert (low, high) == (0.01, 0.6)
    domain = Perez(category=category).domains["brightness"]
    for delta in np.linspace(domain.low, domain.high, 12).tolist():
        assert low <= delta <= high
        assert is_sky(category, delta)
    for beyond in (domain.low - 0.05, domain.high + 0.05):
        assert not low - 1e-9 <= beyond <= high + 1e-9 or not is_sky(category, beyond)
    assert domain.low == low or 20 * domain.low == pytest.approx(round(20 * domain.low), rel=1e-9)


@pytest.mark.parametrize("category", range(2, 9))
def test_prefactor_is_one_over_the_shape_towards_the_zenith(category: Any) -> None:
    prefactor = Perez(category=category).hints.prefactor
    assert prefactor is not None
    assert list(prefactor.constants) == LUMINANCE_1993[category - 1].ravel().tolist()
    delta = brightness(category)[1]
    assert prefactor.axes == ("sun_zenith", "brightness")
    expected = 1 / value(shape(category, 0.83, delta), 0.0, 0.83)
    assert float(prefactor.formula(np.array(0.83), np.array(delta), prefactor.constants)) == pytest.approx(
        expected, rel=1e-12
    )
