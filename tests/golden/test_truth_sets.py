"""Parameter sets, least luminance and quadrature nodes against SciPy, NumPy's generator and closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import optimize
from scipy.stats import qmc
from skylight_sh import sphere
from skylight_sh.light.cie_traditional import CieTraditional
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import (
    least_luminance,
    monte_carlo,
    parameter_points,
    ring_sums,
    rings,
    sampling,
    sobol,
    sun_centred,
    zenith_gauss,
)

from golden.oracles import REC709, WHITE, basis, orders, preetham_xyz, towards, xyz_to_rgb

Array = NDArray[np.float64]


def test_sets() -> None:
    assert parameter_points.grid([np.array([1.0, 2.0]), np.array([5.0, 6.0, 7.0])]).tolist() == [
        [a, b] for a in (1, 2) for b in (5, 6, 7)
    ]
    drawn = np.random.Generator(np.random.PCG64(9)).random((4, 2))
    got = parameter_points.random([(1.0, 3.0), (-1.0, 0.0)], 4, 9)
    assert got == pytest.approx(np.stack([1 + 2 * drawn[:, 0], drawn[:, 1] - 1], axis=-1), rel=1e-14)
    shared = parameter_points.random([(1.0, 3.0), (-1.0, 0.0)], 4, 9, shared=0, each=3)
    assert shared[:, 0] == pytest.approx([got[0, 0], got[0, 0], got[0, 0], got[3, 0]], rel=1e-14)
    assert shared[:, 1].tolist() == got[:, 1].tolist()


@pytest.mark.parametrize("dimensions", range(1, sobol.MOST + 1))
@pytest.mark.parametrize(("count", "seed"), [(1, 3), (2, 0), (5, 1959), (2000, 7)])
def test_sobol_sequences_are_scipys(dimensions: int, count: int, seed: int) -> None:
    expected = qmc.Sobol(dimensions, bits=30, rng=np.random.default_rng(seed)).random_base2((count - 1).bit_length())
    assert np.array_equal(sobol.scrambled(dimensions, count, seed), expected[:count])


def test_sets_of_many_axes_come_from_scipy() -> None:
    axes = sobol.MOST + 1
    made = parameter_points.held_out([(0.0, 1.0)] * axes, 16, 1, 5)
    assert np.array_equal(made[:16], qmc.Sobol(axes, bits=30, rng=np.random.default_rng(5)).random_base2(4))
    with pytest.raises(ValueError, match="Should be 1 to 8"):
        sobol.scrambled(axes, 4, 5)


@pytest.mark.parametrize(("theta", "tau"), [(0.3, 2.5), (1.0, 3.0), (1.5, 6.0)])
def test_least_luminance_is_scipys(theta: float, tau: float) -> None:
    """The darkest point by Nelder and Mead from a start of our own."""

    def luminance(place: np.ndarray) -> float:
        where = towards(min(max(float(place[0]), 0.0), math.pi / 2 - 1e-9), float(place[1]))
        return float(preetham_xyz("published", where[np.newaxis], theta, tau)[0, 1])

    starts = [(z, a) for z in np.linspace(0.05, 1.55, 12) for a in np.linspace(0, math.pi, 9)]
    best = min(starts, key=lambda p: luminance(np.array(p)))
    found = optimize.minimize(luminance, best, method="Nelder-Mead", options={"xatol": 1e-7, "fatol": 1e-9})
    start = towards(best[0] + 0.12, best[1] + 0.1)[np.newaxis]
    at = {"sun_zenith": np.array([theta]), "turbidity": np.array([tau])}
    light = Preetham()
    got = least_luminance.refine(light, at, start, light.radiance(start, at) @ light.luminance_row)
    assert float(got[0]) == pytest.approx(found.fun, rel=2e-6)


def test_nodes_integrate_the_hemisphere() -> None:
    """2 pi sr, pi for a cosine, 2 pi / 3 for its square; each cell of Green's samples holds one sample of equal area."""
    for where, solid in (zenith_gauss.directions(6), sun_centred.half_sky(0.7, 24), sun_centred.half_sky(math.pi / 2, 24)):
        assert solid.sum() == pytest.approx(2 * math.pi, rel=1e-9)
        assert (where[:, 2] * solid).sum() == pytest.approx(math.pi, rel=1e-9)
        assert (where[:, 2] ** 2 * solid).sum() == pytest.approx(2 * math.pi / 3, rel=1e-9)
    where, solid = monte_carlo.directions(8, 3)
    assert solid == pytest.approx(np.full(64, 2 * math.pi / 64), rel=1e-14)
    azimuth = np.arctan2(where[:, 1], where[:, 0]) % (2 * math.pi)
    cells = np.floor(where[:, 2] * 8).astype(int), np.floor(azimuth * 8 / (2 * math.pi)).astype(int)
    assert sorted(zip(*(c.tolist() for c in cells), strict=True)) == [(i, j) for i in range(8) for j in range(8)]


def test_waves_are_exponentials() -> None:
    azimuth = np.array([0.3, -2.0, 7.7])
    assert ring_sums.waves(azimuth, 9) == pytest.approx(np.exp(1j * np.multiply.outer(azimuth, np.arange(9))), abs=1e-13)


@pytest.fixture(scope="module")
def brute_force() -> Array:
    """Preetham's sky by Gauss in z^(1/3) and 1,600 azimuths of a mirror's half; the cusp costs it 1e-6."""
    root, share = np.polynomial.legendre.leggauss(200)
    root, share = (root + 1) / 2, share / 2
    z, areas = root**3, 3 * root**2 * share
    phi = (np.arange(800) + 0.5) * math.pi / 800
    flat = np.sqrt(1 - z * z)[:, np.newaxis]
    where = np.stack(np.broadcast_arrays(flat * np.cos(phi), flat * np.sin(phi), z[:, np.newaxis]), axis=-1).reshape(-1, 3)
    solid = np.repeat(areas * 2 * math.pi / 800, phi.size)
    sky = preetham_xyz("published", where, 0.9, 3.0) @ np.round(xyz_to_rgb(REC709, WHITE), 7).T
    return (sky * solid[:, np.newaxis]).T @ np.where(orders(5) < 0, 0.0, basis(where, 5))


@pytest.mark.parametrize("rule", ["sun-centred", "rings", "adaptive", "zenith"])
def test_every_rule_integrates_a_sky(rule: str, brute_force: Array) -> None:
    values = np.array([[[0.9, 3.0]]])
    nodes = {"zenith": 256}.get(rule, 40)
    job = sampling.Job(Preetham(), ("sun_zenith", "turbidity"), values, nodes, sphere.Harmonics(5), rule, 1e-6)
    got = sampling.project_block(job).weights[0, 0]
    assert np.abs(got - brute_force).max() < 2e-5 * np.abs(brute_force).max()


def test_rings_about_the_zenith_need_no_peak() -> None:
    """An overcast sky, (1 + 2 z) / 3, has zonal weights alone: sqrt(pi) (1 + 2/2) / 3 and so on, by hand."""
    at = {"sun_zenith": np.array([[0.4]])}
    got = rings.project(CieTraditional(sky="overcast"), at, nodes=24, harmonics=sphere.Harmonics.even(3)).weights[0, 0, 0]
    z, w = np.polynomial.legendre.leggauss(20)
    z, w = (z + 1) / 2, w / 2
    sky = (1 + 2 * z) / 3
    zonal = [
        2 * math.pi * float((sky * w * p).sum())
        for p in (np.full_like(z, 0.5 / math.sqrt(math.pi)), math.sqrt(0.75 / math.pi) * z)
    ]
    assert got[[0, 1]] == pytest.approx(zonal, rel=1e-9)
    assert got[0] == pytest.approx(math.sqrt(math.pi) * 2 / 3, rel=1e-9)
    assert np.abs(got[[2, 4, 5]]).max() < 1e-12
