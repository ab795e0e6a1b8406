"""Spherical lights nearby: integration against closed forms and against sampling, bands against both."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh import sphere
from skylight_sh.light import spherical_lights
from skylight_sh.reflectance import lobes
from skylight_sh.reflectance.spheres import Spheres, in_bands, integrated

Array = NDArray[np.float64]
ORIGIN = np.zeros((1, 3))
UP = np.array([[0.0, 0.0, 1.0]])


def one(angle: float, apart: float) -> Spheres:
    """A light of radiance 1 seen from the origin as a disc."""
    centre = [[np.sin(apart), 0.0, np.cos(apart)]]
    return Spheres(np.array(centre), np.array([np.sin(angle)]), np.ones((1, 1)))


@pytest.mark.parametrize(("angle", "apart"), [(0.01, 0.3), (0.3, 0.0), (0.5, 0.9), (0.5, 0.2), (1.2, 0.3)])
def test_a_disc_above_the_horizon_gives_its_projected_area(angle: float, apart: float) -> None:
    found = integrated(one(angle, apart), ORIGIN, UP, 1.0)[0, 0]
    assert found == pytest.approx(np.sin(angle) ** 2 * np.cos(apart), rel=1e-9)


def test_a_disc_on_the_horizon_gives_half_of_a_sphere_cut_in_two() -> None:
    """A sphere whose centre is on the horizon: E = a - sin a cos a (by a plane through its centre)."""
    for angle in (0.05, 0.4, 1.0):
        # The integral of cos over the upper half of the disc, in cylinder coordinates about the disc's axis.
        expected = angle - np.sin(angle) * np.cos(angle)
        assert np.pi * integrated(one(angle, np.pi / 2), ORIGIN, UP, 1.0)[0, 0] == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("exponent", [1.0, 8.0, 33.5])
def test_integration_is_what_sampling_finds(exponent: float) -> None:
    draw = np.random.default_rng(5)
    for angle, apart in ((0.3, 0.2), (0.4, 1.3), (0.7, 1.9), (1.3, 1.0), (0.3, 3.0)):
        cosine = 1.0 - (1.0 - np.cos(angle)) * (np.arange(400_000) + 0.5) / 400_000
        azimuth = 2 * np.pi * draw.random(cosine.size)
        height = np.cos(apart) * cosine - np.sin(apart) * np.sqrt(1 - cosine**2) * np.cos(azimuth)
        lobe = (exponent + 1) / (2 * np.pi) * np.maximum(height, 0.0) ** exponent
        values = 2 * np.pi * (1 - np.cos(angle)) * lobe
        found = integrated(one(angle, apart), ORIGIN, UP, exponent)[0, 0]
        assert abs(found - values.mean()) <= 5 * values.std() / np.sqrt(values.size) + 1e-12


def test_many_bands_are_the_integral() -> None:
    """Also with several lights of several colours, nearby, at turned axes."""
    draw = np.random.default_rng(6)
    centres = draw.normal(size=(4, 3)) + np.array([0.0, 0.0, 4.0])
    lights = Spheres(centres, np.array([0.5, 0.8, 0.3, 1.0]), draw.random((4, 3)))
    points = 0.3 * draw.normal(size=(20, 3))
    axes = draw.normal(size=(20, 3)) + np.array([0.0, 0.0, 1.5])
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    exact = integrated(lights, points, axes, 6.0)
    weights = lights.weights(points, 24)
    off = [np.abs(in_bands(weights, axes, lobes.cosine_power(6, n)) - exact).max() for n in (3, 10, 24)]
    assert off[0] > 3e-3 * exact.max()
    assert off[1] < 2e-3 * exact.max()
    assert off[2] < 2e-5 * exact.max()


def test_weights_are_the_sum_of_the_lights() -> None:
    lights = Spheres(np.array([[0.0, 0.0, 3.0], [2.0, 0.0, 0.0]]), np.array([1.0, 0.5]), np.array([[1.0, 2.0], [3.0, 4.0]]))
    point = np.array([[0.1, 0.2, 0.3]])
    first, second = (spherical_lights.spheres(lights.centres[k], lights.radii[k], 5, point[0]) for k in (0, 1))
    expected = np.stack([first + 3 * second, 2 * first + 4 * second])
    assert np.abs(lights.weights(point, 5)[0] - expected).max() < 1e-12


def test_irradiance_in_bands_is_the_clamped_cosine() -> None:
    lights = one(0.4, 0.7)
    whole = lights.weights(ORIGIN, 9)
    expected = sphere.evaluate(sphere.irradiance(whole[0]), UP)[0] / np.pi
    found = in_bands(whole, UP, sphere.clamped_cosine(9) / np.pi)
    assert np.abs(found[0] - expected).max() < 1e-12


def test_a_point_inside_a_light_is_refused() -> None:
    lights = Spheres(np.array([[0.0, 0.0, 0.5]]), np.array([1.0]), np.ones((1, 3)))
    with pytest.raises(spherical_lights.InsideLightError, match="lies inside light"):
        integrated(lights, ORIGIN, UP, 1.0)
