"""Ground truth against integration in zenith coordinates, which shares nothing with the sun-centred rule."""

from __future__ import annotations

import itertools
import tomllib

import numpy as np
import pytest
from conftest import ROOT, SMALL
from numpy.typing import NDArray
from scipy import integrate, optimize
from skylight_sh import sphere
from skylight_sh.config import Config, load, parse
from skylight_sh.light import Light
from skylight_sh.light.cie_general import CieGeneral
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import convergence, least_luminance, samples, sampling
from skylight_sh.quadrature import parameter_points as parameter_sets
from skylight_sh.run.stages.truth import make_rule
from skylight_sh.store.dataset import Dataset

Array = NDArray[np.float64]

BANDS = 10
HELD = sphere.Harmonics.even(BANDS)
HALF_PI = float(np.pi / 2)
RANGES = {"sun_zenith": (0.0, HALF_PI), "turbidity": (2.5, 6.0)}
EDGES = [(0.0, 2.5), (0.0, 6.0), (HALF_PI, 2.5), (HALF_PI, 6.0), (HALF_PI, 4.0), (0.0, 4.0), (0.7, 2.5), (1.55, 6.0)]
RANDOM = parameter_sets.random(list(RANGES.values()), 20, seed=31).tolist()


def weights(light: Light, values: tuple[float, ...], nodes: int, held: sphere.Harmonics = HELD) -> Array:
    block = np.array(values).reshape(1, 1, -1)
    job = sampling.Job(light, tuple(light.domains), block, nodes, held)
    return sampling.project_block(job).weights[0, 0]


def adaptive(light: Light, values: tuple[float, ...], tolerance: float) -> Array:
    """Integrate over zenith angle and azimuth by adaptive Gauss-Kronrod cells, split where the cusp stands."""
    parameters = {name: np.array(value) for name, value in zip(light.domains, values, strict=True)}

    def integrand(points: Array) -> Array:
        zenith, azimuth = points[:, 0], points[:, 1]
        flat = np.sin(zenith)
        directions = np.stack([flat * np.cos(azimuth), flat * np.sin(azimuth), np.cos(zenith)], axis=-1)
        basis = sphere.basis(directions, HELD)
        radiance = light.radiance(directions, parameters) * (2.0 * flat[:, np.newaxis])
        return (radiance[:, :, np.newaxis] * basis[:, np.newaxis, :]).reshape(len(points), -1)

    sun = values[0]
    cuts = [0.0, sun, HALF_PI] if 0.0 < sun < HALF_PI else [0.0, HALF_PI]
    total = 0.0
    scale = np.abs(weights(light, values, 48)).max()
    for low, high in itertools.pairwise(cuts):
        result = integrate.cubature(
            integrand, [low, 0.0], [high, np.pi], rule="gk15", atol=tolerance * scale, rtol=0.0, max_subdivisions=4000
        )
        assert result.status == "converged"
        total = total + result.estimate
    return np.asarray(total).reshape(len(light.channels), -1)


@pytest.mark.parametrize("values", [*map(tuple, RANDOM), *EDGES])
def test_weights_match_adaptive_integration_in_zenith_coordinates(values: tuple[float, float]) -> None:
    light = Preetham()
    nodes, estimate = convergence.choose_nodes(light, RANGES, harmonics=HELD, tolerance=1e-10)
    got = weights(light, values, nodes)
    expected = adaptive(light, values, 2e-11)
    scale = np.abs(expected).max(axis=1, keepdims=True)
    assert estimate <= 1e-10
    assert np.max(np.abs(got - expected) / scale) < 1e-10


def small_with(tolerance: float | str, name: str, **winner: object) -> Config:
    """The tests' small config, with the winners given, one named ``name`` among them, and a truth's tolerance."""
    raw = tomllib.loads(SMALL.read_text(encoding="utf-8"))
    raw["truth"]["tolerance"] = tolerance
    raw["winners"] = [{"bands": 4, **winner}]
    raw["export"]["recommended"] = name
    return parse(raw, "a config")


def rule_of(config: Config) -> Dataset:
    return make_rule(config, {}, lambda *_: None)


def test_a_truth_errs_by_a_fiftieth_of_the_tightest_budget_and_no_less() -> None:
    config = load(ROOT / "configs" / "preetham.toml")
    rule, light = rule_of(config), Preetham()
    nodes, budget = int(rule.attrs["nodes"]), min(b for w in config.winners for b in w.budgets)
    assert budget == 5e-5
    sets = np.concatenate([parameter_sets.random(list(RANGES.values()), 40, seed=77), EDGES])

    def e_mean(coarse: int) -> float:
        found = []
        for values in sets:
            block = values.reshape(1, 1, -1)
            one, other = (sampling.sample_block(sampling.Job(light, tuple(RANGES), block, n, HELD)) for n in (coarse, 104))
            found.append(np.sqrt(np.square(one.weights - other.weights).sum(axis=-1)).max() / other.least.item())
        return float(max(found))

    assert e_mean(nodes) < budget / 50
    # The ladder's next step down would not do.
    assert e_mean(nodes - 8) > budget / 50


def test_an_automatic_tolerance_hangs_on_the_budgets() -> None:
    rules = [
        rule_of(small_with("auto", "4-bands-5pct", budgets=[0.05])),
        rule_of(small_with("auto", "4-bands-1pct", budgets=[0.01, 1e-6])),
        rule_of(small_with("auto", "4-bands-degrees-6-4", degrees=[6, 4])),
        rule_of(small_with(1e-8, "4-bands-5pct", budgets=[0.05])),
    ]
    tolerances = [float(rule.attrs["tolerance"]) for rule in rules]
    # A loose budget counts as 5e-5.
    assert tolerances[0] / tolerances[1] == pytest.approx(50, rel=1e-2)
    assert tolerances[2:] == [1e-10, 1e-8]
    nodes = [int(rule.attrs["nodes"]) for rule in rules]
    assert nodes[0] < nodes[1] < nodes[2]
    assert all(float(rule.attrs["estimate"]) <= float(rule.attrs["tolerance"]) for rule in rules)


def test_all_orders_agree_with_the_mirrored_half() -> None:
    full = weights(Preetham(), (1.1, 3.0), 40, sphere.Harmonics(BANDS))
    half = HELD.unmirror(weights(Preetham(), (1.1, 3.0), 40))
    assert np.abs(full - half).max() < 1e-14 * np.abs(half).max()


class Lopsided:
    """A sky that is brighter on one side of the sun's azimuth: no mirror symmetry."""

    def __init__(self) -> None:
        self.sky = Preetham()
        self.channels, self.luminance_row, self.domains = self.sky.channels, self.sky.luminance_row, self.sky.domains
        self.hints, self.title = self.sky.hints, "lopsided"

    def radiance(self, directions: Array, parameters: dict[str, Array]) -> Array:
        return self.sky.radiance(directions, parameters) * (1.0 + 0.3 * directions[..., 1:2])


def test_a_light_without_mirror_symmetry_keeps_its_sine_orders() -> None:
    light = Lopsided()
    assert not convergence.is_mirrored(light, RANGES)
    assert convergence.is_mirrored(Preetham(), RANGES)
    got = weights(light, (1.0, 4.0), 64, sphere.Harmonics(4))
    z, w = np.polynomial.legendre.leggauss(400)
    z, w = (z + 1) / 2, w / 2
    phi = (np.arange(800) + 0.5) * np.pi / 400
    flat = np.sqrt((1 - z) * (1 + z))[:, np.newaxis]
    directions = np.stack([flat * np.cos(phi), flat * np.sin(phi), z[:, np.newaxis] + 0 * phi], axis=-1).reshape(-1, 3)
    solid = np.repeat(w, phi.size) * np.pi / 400
    radiance = light.radiance(directions, {"sun_zenith": np.array(1.0), "turbidity": np.array(4.0)})
    expected = (radiance * solid[:, np.newaxis]).T @ sphere.basis(directions, 4)
    orders = sphere.Harmonics(4).orders
    assert np.abs(expected[:, orders < 0]).max() > 0.01 * np.abs(expected).max()
    assert np.abs(got - expected).max() < 1e-6 * np.abs(expected).max()


@pytest.mark.parametrize("values", [(0.0, 2.5), (0.6, 3.0), (1.2, 6.0), (HALF_PI, 2.5), (HALF_PI, 6.0)])
def test_least_luminance_is_right_to_a_ten_thousandth(values: tuple[float, float]) -> None:
    light = Preetham()
    parameters = {name: np.array([value]) for name, value in zip(RANGES, values, strict=True)}

    def luminance(angles: Array) -> Array:
        zenith, azimuth = np.moveaxis(np.asarray(angles), -1, 0)
        flat = np.sin(zenith)
        z = np.maximum(np.cos(zenith), 0.0)
        directions = np.stack([flat * np.cos(azimuth), flat * np.sin(azimuth), z], axis=-1)
        return light.radiance(directions, parameters) @ light.luminance_row

    zenith, azimuth = np.meshgrid(np.linspace(0, HALF_PI, 400), np.linspace(0, np.pi, 400), indexing="ij")
    grid = luminance(np.stack([zenith, azimuth], axis=-1).reshape(-1, 2))
    start = np.array([zenith.ravel()[grid.argmin()], azimuth.ravel()[grid.argmin()]])
    found = optimize.minimize(
        lambda a: float(luminance(a[np.newaxis])[0]), start, bounds=[(0, HALF_PI), (0, np.pi)], method="Nelder-Mead"
    ).fun
    job = sampling.Job(light, tuple(RANGES), np.array(values).reshape(1, 1, 2), 48, sphere.Harmonics.even(3))
    assert sampling.sample_block(job).least[0, 0] == pytest.approx(found, rel=1e-4)


def test_least_luminance_search_reaches_the_horizon() -> None:
    start = np.array([[np.sin(1.5), 0.0, np.cos(1.5)]])
    parameters = {"sun_zenith": np.array([0.0])}
    light = CieGeneral(sky=1)
    got = least_luminance.refine(light, parameters, start, light.radiance(start, {"sun_zenith": np.zeros(1)})[:, 0])
    # The overcast sky's gradation falls to 1 on the horizon, over 1 + a exp(b) at the zenith.
    assert got[0] == pytest.approx(1.0 / (1.0 + 4.0 * np.exp(-0.7)), rel=1e-4)


def test_rule_says_so_when_it_cannot_converge() -> None:
    class Torn(Lopsided):
        def radiance(self, directions: Array, parameters: dict[str, Array]) -> Array:
            return self.sky.radiance(directions, parameters) * np.where(directions[..., :1] > 0.2, 2.0, 1.0)

    with pytest.raises(samples.NotConvergedError, match=r"truth\.tolerance"):
        convergence.choose_nodes(
            Torn(), {"sun_zenith": (0.3, 1.0), "turbidity": (3.0, 4.0)}, harmonics=sphere.Harmonics.even(3), tolerance=1e-10
        )


@pytest.mark.parametrize("size", [1, 7, 64])
def test_chunks_hold_every_set_once_and_share_the_peak(size: int) -> None:
    rng = np.random.default_rng(5)
    values = np.stack([rng.integers(0, 9, 200) / 8.0, rng.random(200)], axis=-1)
    blocks = parameter_sets.chunks(values, 0, size)
    together = np.concatenate([block.ravel() for block in blocks])
    assert sorted(together.tolist()) == list(range(200))
    for block in blocks:
        assert block.size <= size
        assert np.all(values[block][:, :, 0] == values[block][:, :1, 0])
