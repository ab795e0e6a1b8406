"""Skylines and clouds against closed forms and direct integration."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from skylight_sh import sphere
from skylight_sh.sphere import basis

Array = NDArray[np.float64]


@pytest.mark.parametrize("bands", [1, 7, 31])
@pytest.mark.parametrize("elevation", [-np.pi / 2, -0.4, 0.0, 1e-6, 0.7, np.pi / 2])
def test_a_level_horizon_is_a_cap(elevation: float, bands: int) -> None:
    found = sphere.horizon(np.full(5, elevation), bands)
    degrees, orders = sphere.Harmonics(bands).degrees, sphere.Harmonics(bands).orders
    expected = np.where(orders == 0, sphere.cap(np.array([np.pi / 2 - elevation]), bands)[0][degrees], 0)
    assert np.abs(found - expected).max() < 2e-14 * np.pi
    assert sphere.horizon(elevation, bands) == pytest.approx(expected, abs=2e-14 * np.pi)


def skyline_rule(corners: Array, rows: int, columns: int) -> tuple[Array, Array]:
    """Directions and areas above a skyline: a trapezoid in azimuth at the corners' multiples, Gauss in z, not the angle."""
    phi = (np.arange(columns) + 0.5) * 2 * np.pi / columns
    low = np.sin(np.interp(phi, np.linspace(0, 2 * np.pi, corners.size + 1), np.append(corners, corners[0])))
    nodes, areas = np.polynomial.legendre.leggauss(rows)
    z = 1 - (1 - low[:, np.newaxis]) * (1 + nodes) / 2
    s = np.sqrt(1 - z * z)
    where = np.stack((s * np.cos(phi)[:, np.newaxis], s * np.sin(phi)[:, np.newaxis], z), axis=-1)
    return where.reshape(-1, 3), ((1 - low)[:, np.newaxis] / 2 * areas * 2 * np.pi / columns).ravel()


@settings(max_examples=10, deadline=None)
@given(st.lists(st.floats(-1.5, 1.5), min_size=3, max_size=9))
def test_a_jagged_horizon_equals_direct_integration(corners: list[float]) -> None:
    where, areas = skyline_rule(np.array(corners), 40, 2520)
    # The trapezoid's own error at kinks is of the second order in its step.
    assert np.abs(sphere.horizon(corners, 6) - areas @ basis(where, 6)).max() < 5e-5


def test_refining_a_skyline_changes_nothing() -> None:
    corners = np.array([0.3, 0.9, -0.2, 0.1, 1.2])
    fine = np.interp(np.arange(40) / 8, np.arange(6), np.append(corners, corners[0]))
    assert np.abs(sphere.horizon(corners, 20) - sphere.horizon(fine, 20)).max() < 1e-14


def test_clouds_mix_sky_and_colour() -> None:
    """Against the mixed radiance itself, which is a polynomial where sky and opacity are."""
    draw = np.random.default_rng(11)
    sky, opacity, colour = draw.normal(size=(3, 36)), draw.normal(size=16), np.array([0.2, 0.5, 2.0])
    where = draw.normal(size=(50, 3))
    where /= np.linalg.norm(where, axis=1, keepdims=True)
    alpha = sphere.evaluate(opacity, where)
    mixed = (1 - alpha) * sphere.evaluate(sky, where) + alpha * colour[:, np.newaxis]
    whole = sphere.cover(sky, opacity, colour, 9)
    assert np.abs(sphere.evaluate(whole, where) - mixed).max() < 1e-12 * np.abs(mixed).max()
    for bands in (1, 3, 6):
        assert sphere.cover(sky, opacity, colour, bands) == pytest.approx(whole[:, : bands * bands], abs=1e-13)
    assert sphere.cover(sky, opacity, colour) == pytest.approx(whole[:, :36], abs=1e-13)


def test_an_occluded_sky_equals_its_integral_above_the_skyline() -> None:
    """A band-limited sky times a mask of enough bands: no truncation is left in the product's first bands."""
    corners = np.array([0.3, 0.9, 0.0, 0.1])
    sky = np.random.default_rng(2).normal(size=49)
    through = sphere.multiplication(sphere.horizon(corners, 11), 7, 5) @ sky
    where, areas = skyline_rule(corners, 40, 8000)
    direct = (areas * sphere.evaluate(sky, where)) @ basis(where, 5)
    assert np.abs(through - direct).max() < 1e-5
    hidden = -sphere.horizon(corners, 11)
    hidden[0] += np.sqrt(4 * np.pi)
    assert sphere.cover(sky, hidden, 0.0, 5) == pytest.approx(through, abs=1e-12)


@pytest.mark.parametrize("bad", [np.nan, np.inf, 1.6, -2.0])
def test_bad_elevations_are_named(bad: float) -> None:
    with pytest.raises(ValueError, match=r"elevations\[1\].*radians"):
        sphere.horizon([0.1, bad], 4)
    with pytest.raises(ValueError, match="one row"):
        sphere.horizon([], 4)
