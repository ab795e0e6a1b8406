"""Truth rules against one another: rings, and the adaptive rule that is told nothing."""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable, Mapping

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh import sphere
from skylight_sh.light import Domain, Hints, Light
from skylight_sh.light.cie_general import CieGeneral
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import adaptive, direction_sums, rings, sun_centred
from skylight_sh.quadrature import parameter_points as parameter_sets
from skylight_sh.quadrature.samples import NotConvergedError, Samples

Array = NDArray[np.float64]

HALF_PI = float(np.pi / 2)
EDGES = [0.0, 1e-3, HALF_PI - 1e-3, HALF_PI - 1e-9, HALF_PI]
SUNS = np.array([*EDGES, *np.random.default_rng(4).uniform(0.0, HALF_PI, 10)])
GRID = {"sun_zenith": SUNS[:, np.newaxis], "turbidity": np.tile([2.5, 3.7, 6.0], (SUNS.size, 1))}
RANDOM = parameter_sets.random([(0.0, HALF_PI), (2.5, 6.0)], 50, seed=8)
ONE = {"sun_zenith": np.array([[1.2]]), "turbidity": np.array([[3.0]])}


class Toy:
    """A light of one channel and one parameter, given by a function."""

    title, channels, luminance_row, hints = "toy", ("value",), np.ones(1), Hints()

    def __init__(self, radiance: Callable[[Array, Array], Array]) -> None:
        self.function = radiance
        self.domains = {"sun_zenith": Domain(0.0, HALF_PI, "rad", "a test")}

    def radiance(self, directions: Array, parameters: Mapping[str, Array]) -> Array:
        return self.function(directions, parameters["sun_zenith"])[..., np.newaxis]


class Wrapped:
    """Another light's radiance, changed or not, with its hints hidden."""

    title = "wrapped"

    def __init__(self, light: Light, side: float = 0.0, hints: Hints | None = None) -> None:
        self.light, self.side, self.hints = light, side, hints or Hints()
        self.channels, self.luminance_row, self.domains = light.channels, light.luminance_row, light.domains

    def radiance(self, directions: Array, parameters: Mapping[str, Array]) -> Array:
        return self.light.radiance(directions, parameters) * (1.0 + self.side * directions[..., 1:2])


def error(got: Array, expected: Array) -> Array:
    """Each set's error relative to the largest weight, its worst channel's: ``(g, k)``."""
    return (np.abs(got - expected).max(axis=-1) / np.abs(expected).max(axis=-1)).max(axis=-1)


@pytest.mark.parametrize(("bands", "nodes"), [(7, 60), (32, 60), (64, 76)])
def test_rings_miss_the_sun_centred_rule_by_less_than_1e_9(bands: int, nodes: int) -> None:
    got = rings.project(Preetham(), GRID, nodes=nodes, harmonics=sphere.Harmonics.even(bands))
    expected = sun_centred.project(Preetham(), GRID, nodes=bands + 70, harmonics=sphere.Harmonics.even(bands))
    assert error(got.weights, expected.weights).max() < 1e-9
    assert np.isnan(got.estimate).all()
    luminance = Preetham().radiance(got.least_direction, GRID) @ Preetham().luminance_row
    assert luminance == pytest.approx(got.least)
    assert got.least == pytest.approx(expected.least, rel=0.02)


@pytest.mark.parametrize(("project", "nodes"), [(rings.project, 120), (sun_centred.project, 72)])
def test_a_rule_reaches_1e_12(project: Callable[..., Samples], nodes: int) -> None:
    got = project(Preetham(), GRID, nodes=nodes, harmonics=sphere.Harmonics.even(7))
    finer = project(Preetham(), GRID, nodes=2 * nodes, harmonics=sphere.Harmonics.even(7))
    assert error(got.weights, finer.weights).max() < 1e-12


def test_rings_keep_the_sine_orders_of_a_lopsided_sky() -> None:
    light = Wrapped(Preetham(), side=0.3, hints=Hints(peak_axis="sun_zenith"))
    got = rings.project(light, GRID, nodes=64, harmonics=sphere.Harmonics(9)).weights
    expected = sun_centred.project(light, GRID, nodes=80, harmonics=sphere.Harmonics(9)).weights
    assert np.abs(got[..., sphere.Harmonics(9).orders < 0]).max() > 0.01 * np.abs(got).max()
    assert error(got, expected).max() < 1e-10


def test_rings_hold_bounded_memory() -> None:
    parameters = {"sun_zenith": np.array([[1.2]]), "turbidity": np.linspace(2.5, 6.0, 3000)[np.newaxis]}
    for bands, nodes, turbidity in ((7, 60, 3000), (96, 108, 40)):
        named = {**parameters, "turbidity": parameters["turbidity"][:, :turbidity]}
        tracemalloc.start()
        got = rings.project(Preetham(), named, nodes=nodes, harmonics=sphere.Harmonics.even(bands))
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        assert peak - got.weights.nbytes < 64e6


@pytest.mark.parametrize("rule", ["sun-centred", "rings"])
def test_a_table_of_nodes_sums_what_the_rule_does(rule: str) -> None:
    light, held = Preetham(), sphere.Harmonics.even(7)
    if rule == "rings":
        nodes, expected = rings.half_sky(1.2, 40, 7), rings.project(light, ONE, nodes=40, harmonics=held)
    else:
        nodes, expected = (
            sun_centred.half_sky(1.2, 40),
            sun_centred.project(light, ONE, nodes=40, harmonics=held),
        )
    got = direction_sums.project_one(
        light, {"sun_zenith": 1.2, "turbidity": 3.0}, nodes[0], direction_sums.tabulate(*nodes, held)
    )
    assert error(got[np.newaxis, np.newaxis], expected.weights).max() < 1e-13


def check_honest(samples: Samples, truth: Array, tolerance: float) -> None:
    """The tolerance is met, never is the error above 3 times its estimate, and the median estimate is sharp."""
    missed = error(samples.weights, truth)
    assert samples.estimate.max() <= tolerance
    assert np.all(missed <= 3.0 * samples.estimate)
    assert np.median(samples.estimate / missed) < 10.0


@pytest.mark.parametrize("light", [Preetham(), CieGeneral(sky=4), CieGeneral(sky=8), CieGeneral(sky=12)])
def test_adaptive_estimates_are_honest_without_hints(light: Light) -> None:
    parameters = {name: RANDOM[:, i : i + 1] for i, name in enumerate(light.domains)}
    got = adaptive.project(Wrapped(light), parameters, tolerance=1e-6, harmonics=sphere.Harmonics.even(7))
    truth = sun_centred.project(light, parameters, nodes=64, harmonics=sphere.Harmonics.even(7)).weights
    check_honest(got, truth, 1e-6)
    assert np.median(got.estimate) > 1e-8


def test_adaptive_estimates_are_honest_at_a_jump() -> None:
    suns, radius = np.random.default_rng(3).uniform(0.0, 1.2, 20), 0.3

    def disc(directions: Array, theta: Array) -> Array:
        inside = directions[..., 0] * np.sin(theta) + directions[..., 2] * np.cos(theta) > np.cos(radius)
        return np.asarray(inside, dtype=np.float64)

    got = adaptive.project(
        Toy(disc), {"sun_zenith": suns[:, np.newaxis]}, tolerance=1e-3, harmonics=sphere.Harmonics.even(7)
    )
    # A cap's zonal weights, turned by the addition theorem.
    x, w = np.polynomial.legendre.leggauss(40)
    height = 1.0 - (1.0 - np.cos(radius)) * (1.0 - x) / 2.0
    zonal = np.pi * (1.0 - np.cos(radius)) * np.polynomial.legendre.legvander(height, 6).T @ w
    centres = np.stack([np.sin(suns), np.zeros(20), np.cos(suns)], axis=-1)
    truth = zonal[sphere.Harmonics.even(7).degrees] * sphere.basis(centres, sphere.Harmonics.even(7))
    check_honest(got, truth[:, np.newaxis, np.newaxis], 1e-3)


def test_adaptive_keeps_all_orders_and_sharpens_with_its_tolerance() -> None:
    light = Wrapped(Preetham(), side=0.3)
    peaked = Wrapped(Preetham(), side=0.3, hints=Hints(peak_axis="sun_zenith"))
    truth = sun_centred.project(peaked, ONE, nodes=72, harmonics=sphere.Harmonics(5)).weights
    for tolerance in (1e-3, 1e-6, 1e-9):
        check_honest(adaptive.project(light, ONE, tolerance=tolerance, harmonics=sphere.Harmonics(5)), truth, tolerance)


def test_adaptive_says_so_when_it_cannot_converge() -> None:
    rough = Toy(lambda directions, theta: 1.0 + (np.sin(3000.0 * directions[..., 0] + theta) > 0.0))
    parameters = {"sun_zenith": np.array([[0.5]])}
    with pytest.raises(NotConvergedError, match=r"truth\.tolerance"):
        adaptive.project(rough, parameters, tolerance=1e-7, harmonics=sphere.Harmonics.even(3))
    assert adaptive.integrate(rough, parameters, tolerance=1e-7, harmonics=sphere.Harmonics.even(3)).estimate[0, 0] > 1e-7
