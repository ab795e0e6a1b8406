"""Lights against formulas written out a second time, point by point."""

from __future__ import annotations

import math
from typing import Any, get_args, get_type_hints

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh.light import colour
from skylight_sh.light.cie_general import CieGeneral
from skylight_sh.light.preetham import Preetham, zenith_factor, zenith_luminance

Array = NDArray[np.float64]
SKIES = get_args(get_type_hints(CieGeneral)["sky"])


def upper(count: int) -> Array:
    drawn = np.random.default_rng(2).normal(size=(count, 3))
    drawn[:, 2] = np.abs(drawn[:, 2])
    return np.asarray(drawn / np.linalg.norm(drawn, axis=1, keepdims=True))


def at(theta: float, tau: float) -> dict[str, Array]:
    return {"sun_zenith": np.array(theta), "turbidity": np.array(tau)}


def luminance_by_hand(direction: Array, theta: float, tau: float) -> float:
    gamma = math.acos(min(1.0, float(direction @ np.array([math.sin(theta), 0.0, math.cos(theta)]))))
    a, b, c = 0.1787 * tau - 1.4630, -0.3554 * tau + 0.4275, -0.0227 * tau + 5.3251
    d, e = 0.1206 * tau - 2.5771, -0.0670 * tau + 0.3703

    def perez(z: float, g: float) -> float:
        return (1 + a * math.exp(b / math.cos(z))) * (1 + c * math.exp(d * g) + e * math.cos(g) ** 2)

    chi = (4 / 9 - tau / 120) * (math.pi - 2 * theta)
    zenith = (4.0453 * tau - 4.9710) * math.tan(chi) - 0.2155 * tau + 2.4192
    return 1000 * zenith * perez(math.acos(direction[2]), gamma) / perez(0.0, theta)


@pytest.mark.parametrize(("theta", "tau"), [(0.0, 2.5), (0.8, 3.0), (1.5, 6.0)])
def test_preetham_luminance_by_hand(theta: float, tau: float) -> None:
    light, where = Preetham(), upper(40)
    got = light.radiance(where, at(theta, tau)) @ light.luminance_row
    assert got == pytest.approx([luminance_by_hand(d, theta, tau) for d in where], rel=1e-9)


def test_preetham_zenith_has_the_stated_chromaticity() -> None:
    light = Preetham()
    theta, tau = 0.5, 3.0
    rgb = light.radiance(np.array([0.0, 0.0, 1.0]), at(theta, tau))
    xyz = np.linalg.solve(colour.matrix("srgb"), rgb)
    x = 9 * (0.00166 * theta**3 - 0.00375 * theta**2 + 0.00209 * theta)
    x += 3 * (-0.02903 * theta**3 + 0.06377 * theta**2 - 0.03202 * theta + 0.00394)
    x += 0.11693 * theta**3 - 0.21196 * theta**2 + 0.06052 * theta + 0.25886
    assert xyz[0] / xyz.sum() == pytest.approx(x, rel=1e-12)
    assert xyz[1] == pytest.approx(float(zenith_luminance(np.array(theta), np.array(tau))), rel=1e-9)


def test_preetham_pole_is_where_the_domain_says() -> None:
    def normaliser(tau: float) -> float:
        return 1 + (0.1787 * tau - 1.4630) * math.exp(-0.3554 * tau + 0.4275)

    assert normaliser(1.642) * normaliser(1.644) < 0
    assert Preetham().domains["turbidity"].low > 1.644


def test_preetham_is_finite_on_the_horizon_and_at_the_sun() -> None:
    where = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    for theta in (0.0, np.pi / 2):
        assert np.all(np.isfinite(Preetham().radiance(where, at(theta, 2.5))))


def test_constant_sets_differ_a_little() -> None:
    where = upper(20)
    one, other = (Preetham(constants=name).radiance(where, at(0.7, 3.0)) for name in ("published", "smits"))
    assert 0 < np.abs(one / other - 1).max() < 0.01


def test_prefactor_keeps_the_dtype_and_matches_the_luminance() -> None:
    prefactor = Preetham().hints.prefactor
    assert prefactor is not None
    given = at(0.7, 3.0)
    assert prefactor.axes == tuple(given)
    single = [value.astype(np.float32) for value in given.values()]
    assert prefactor.formula(*single, prefactor.constants).dtype == np.float32
    assert prefactor.formula is zenith_factor
    assert zenith_factor(*single, prefactor.constants) == pytest.approx(
        zenith_factor(*given.values(), prefactor.constants), rel=1e-6
    )


@pytest.mark.parametrize("sky", SKIES)
def test_cie_skies_are_relative_to_the_zenith(sky: Any) -> None:
    assert set(SKIES) == set(range(1, 16))
    light = CieGeneral(sky=sky)
    parameters = {"sun_zenith": np.array(0.9)}
    assert light.radiance(np.array([0.0, 0.0, 1.0]), parameters)[0] == pytest.approx(1.0)
    values = light.radiance(upper(200), parameters)
    assert values.shape == (200, 1)
    assert np.all(values > 0)


def test_colour_luminance_row_is_close_to_rec_709() -> None:
    assert colour.luminance_row("srgb") == pytest.approx([0.2126729, 0.7151522, 0.0721750], abs=1e-6)
    with pytest.raises(ValueError, match="cymk"):
        colour.matrix("cymk")
