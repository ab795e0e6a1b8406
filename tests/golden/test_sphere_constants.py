"""Constants of the sphere: basis, cosine lobe, caps, ground, products, windows and the reconstructions of lightmaps."""

from __future__ import annotations

import itertools
import math
from fractions import Fraction

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import special
from scipy.spatial.transform import Rotation
from skylight_sh import sphere

from golden.oracles import basis, degrees, gauss, hemisphere, lobe, orders, sinc, towards, upper

Array = NDArray[np.float64]


def everywhere(count: int, seed: int) -> Array:
    drawn = np.random.default_rng(seed).normal(size=(count, 3))
    return np.asarray(drawn / np.linalg.norm(drawn, axis=1, keepdims=True))


def both(count: int = 24) -> tuple[Array, Array]:
    (one, solid), (other, _) = hemisphere(count), hemisphere(count, lower=True)
    return np.concatenate([one, other]), np.concatenate([solid, solid])


def test_basis_is_scipys_without_its_sign() -> None:
    where = everywhere(40, 1)
    assert np.abs(sphere.basis(where, 12) - basis(where, 12)).max() < 1e-12
    mirrored = orders(12) >= 0
    assert np.abs(sphere.basis(where, sphere.Harmonics.even(12)) - basis(where, 12)[:, mirrored]).max() < 1e-12


def test_basis_by_its_printed_polynomials() -> None:
    """Sloan 2008, appendix A2, without Condon and Shortley's sign."""
    x, y, z = where = np.array([0.48, -0.6, 0.64])
    expected = [0.282095, 0.488603 * y, 0.488603 * z, 0.488603 * x, 1.092548 * x * y, 1.092548 * y * z]
    expected += [0.315392 * (3 * z * z - 1), 1.092548 * x * z, 0.546274 * (x * x - y * y)]
    assert sphere.basis(where, 3) == pytest.approx(expected, abs=1e-6)


def test_legendre_factors_are_scipys() -> None:
    theta = np.linspace(0.0, np.pi, 9)
    found = sphere.legendre(np.cos(theta), np.sin(theta), 20)
    row = 0
    for l in range(20):
        for m in range(l + 1):
            expected = np.ravel(special.sph_legendre_p(l, m, theta)) * (-1) ** m * (math.sqrt(2) if m else 1)
            assert found[row] == pytest.approx(expected, abs=1e-12)
            row += 1


def test_the_cosine_lobe() -> None:
    """Ramamoorthi and Hanrahan 2001, eq. 8, whose printed values are 3.1416, 2.0944, 0.7854, 0, -0.1309, 0, 0.0491."""
    exact = [Fraction(1), Fraction(2, 3), Fraction(1, 4), 0, Fraction(-1, 24), 0, Fraction(1, 64), 0, Fraction(-1, 128)]
    assert sphere.clamped_cosine(9) == pytest.approx([math.pi * float(v) for v in exact], rel=1e-15, abs=1e-16)
    assert sphere.clamped_cosine(30) == pytest.approx(lobe(30), abs=1e-13)
    weights = np.random.default_rng(2).normal(size=(2, 36))
    assert sphere.irradiance(weights) == pytest.approx(weights * lobe(6)[degrees(6)], rel=1e-12, abs=1e-13)
    with pytest.raises(ValueError, match="bands 0"):
        sphere.clamped_cosine(0)


def test_irradiance_of_an_even_sphere_and_of_a_cosine_sky() -> None:
    """An even radiance 1 gives pi lx; radiance z above the horizon 2 pi / 3 on the horizontal."""
    up = np.array([[0.0, 0.0, 1.0]])
    even = np.zeros(16)
    even[0] = math.sqrt(4 * math.pi)
    assert sphere.evaluate(sphere.irradiance(even), up)[0] == pytest.approx(math.pi, rel=1e-14)
    where, solid = hemisphere(30)
    cosine = (where[:, 2] * solid) @ basis(where, 20)
    assert sphere.evaluate(sphere.irradiance(cosine), up)[0] == pytest.approx(2 * math.pi / 3, rel=2e-4)


def test_two_bands_of_irradiance() -> None:
    """O'Donnell 2018: a quarter of the integral of radiance, and half of those against y, z and x."""
    where, solid = both()
    light = np.exp(where @ [0.5, -0.3, 0.9])
    packed = sphere.packed_irradiance((light * solid) @ basis(where, 4))
    integrals = [float((light * solid * f).sum()) for f in (np.ones(len(where)), *where[:, [1, 2, 0]].T)]
    assert packed == pytest.approx(np.array(integrals) * [0.25, 0.5, 0.5, 0.5], rel=1e-10)


def test_hazels_reconstruction() -> None:
    """Hazel 2017: R0 (a + (1 - a)(p + 1) q^p), p = 1 + 2r, a = (1 - r) / (1 + r), with R1 half the linear part."""
    rng = np.random.default_rng(3)
    normals = everywhere(30, 4)
    for _ in range(5):
        constant, linear = float(rng.uniform(1, 2)), rng.normal(size=3) * 0.5
        # The packed order is y, z, x.
        got = sphere.nonnegative_irradiance(np.array([constant, linear[1], linear[2], linear[0]]), normals)
        half = 0.5 * linear
        r = float(np.linalg.norm(half)) / constant
        q = 0.5 * (1 + normals @ half / np.linalg.norm(half))
        a, p = (1 - r) / (1 + r), 1 + 2 * r
        assert got == pytest.approx(constant * (a + (1 - a) * (p + 1) * q**p), rel=1e-12)
    # A light from one direction, r = 1, gives its fourfold mean towards it; more than 1 is taken as 1.
    peak = sphere.nonnegative_irradiance(np.array([1.0, 0.0, 2.0, 0.0]), np.array([[0.0, 0.0, 1.0]]))
    assert peak == pytest.approx([4.0], rel=1e-14)
    more = sphere.nonnegative_irradiance(np.array([1.0, 0.0, 3.0, 0.0]), np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]))
    assert more == pytest.approx([4.0, 0.0], abs=1e-14)


@pytest.mark.parametrize("half", [1e-4, 0.3, 1.2, math.pi / 2, 2.6, math.pi])
def test_caps(half: float) -> None:
    """Their integral of the zonal basis, by quadrature."""
    z, w = gauss(math.cos(half), 1.0, 20)
    expected = [
        2 * math.pi * math.sqrt((2 * l + 1) / (4 * math.pi)) * float(w @ special.eval_legendre(l, z)) for l in range(9)
    ]
    area = 2 * math.pi * (1 - math.cos(half))
    assert sphere.cap(half, 9) == pytest.approx(expected, rel=1e-7, abs=1e-12 * area)


def test_aim_and_convolve_are_funk_and_heckes() -> None:
    rng = np.random.default_rng(5)
    zonal, axis = rng.normal(size=5), towards(0.7, -2.0)
    where, solid = both()
    turned = sphere.aim(zonal, axis)
    # The value of the zonal function at an angle from its axis.
    norms = np.sqrt((2 * np.arange(5) + 1) / (4 * np.pi))
    for d in everywhere(10, 6):
        expected = sum(zonal[l] * norms[l] * special.eval_legendre(l, d @ axis) for l in range(5))
        assert float(sphere.evaluate(turned, d[np.newaxis])[0]) == pytest.approx(expected, rel=1e-11)
    weights = rng.normal(size=25)
    light = basis(where, 5) @ weights
    kernel = sum(zonal[l] * norms[l] * special.eval_legendre(l, where @ axis) for l in range(5))
    got = sphere.evaluate(sphere.convolve(weights, zonal), axis[np.newaxis])[0]
    assert float(got) == pytest.approx(float((light * kernel * solid).sum()), rel=1e-10)
    assert float(sphere.dot(weights, turned)) == pytest.approx(float((light * kernel * solid).sum()), rel=1e-10)


def test_the_lower_hemisphere_and_its_ground() -> None:
    where, solid = hemisphere(40, lower=True)
    zonal = orders(7) == 0
    assert sphere.lower_hemisphere(7) == pytest.approx((solid @ basis(where, 7))[zonal], abs=1e-12)
    above, solid = hemisphere(60)
    sky = 1 + 0.5 * above[:, 0] + np.exp(-above[:, 2])
    black = (sky * solid) @ basis(above, 6)
    fallen = float((sky * above[:, 2]) @ solid)
    below, _ = hemisphere(60, lower=True)
    lit = black + 0.37 * fallen / math.pi * (solid @ basis(below, 6))
    assert sphere.add_ground(black, 0.37, 6) == pytest.approx(lit, abs=1e-10)
    half_set = sphere.add_ground(black, 0.37, 6, from_below=0.25) - sphere.add_ground(black, 0.37, 6)
    assert half_set == pytest.approx(0.37 * 0.25 / math.pi * (solid @ basis(below, 6)), abs=1e-11)
    image = black + (sky * solid) @ basis(above * [1, 1, -1], 6)
    assert sphere.mirror_ground(black, 6) == pytest.approx(image, abs=1e-10)


def test_windows() -> None:
    """Sloan 2008, windowing: sinc, Hann, Lanczos, and the squared Laplacian; Habel 2008, eq. 5, m = 0 alone."""
    n = 7
    x = np.pi * np.arange(n) / n
    assert sphere.sinc_window(n) == pytest.approx(sinc(x), rel=1e-13)
    assert sphere.sinc_window(n, power=3.0) == pytest.approx(sinc(x) ** 3, rel=1e-13)
    assert sphere.lanczos_window(n) == pytest.approx(sinc(x), rel=1e-13)
    assert sphere.hann_window(n) == pytest.approx((1 + np.cos(x)) / 2, rel=1e-13)
    wide = np.pi * np.arange(n) / 4.5
    expected = np.where(np.arange(n) < 4.5, sinc(wide), 0.0)
    assert sphere.sinc_window(n, cutoff=4.5) == pytest.approx(expected, rel=1e-13)
    assert sphere.hann_window(n, cutoff=4.5) == pytest.approx(np.where(expected > 0, (1 + np.cos(wide)) / 2, 0.0), rel=1e-12)
    l = np.arange(n)
    assert sphere.laplacian_window(n, 0.03) == pytest.approx(1 / (1 + 0.03 * l**2 * (l + 1) ** 2), rel=1e-14)
    zonal = np.where(orders(n) == 0, sinc(np.pi * degrees(n) / n), 1.0)
    assert sphere.zonal_sinc(n) == pytest.approx(zonal, rel=1e-13)


def test_the_paper_s_sinc_is_a_box() -> None:
    """Eq. 5's Fourier side: averaging cos(l t) over half a turn / N either side multiplies it by sinc(pi l / N)."""
    n, l = 6, 4
    t, w = gauss(0.3 - math.pi / n, 0.3 + math.pi / n, 40)
    ratio = float(w @ np.cos(l * t)) / (2 * math.pi / n) / math.cos(l * 0.3)
    assert sphere.zonal_sinc(n)[l * (l + 1)] == pytest.approx(ratio, rel=1e-12)


def test_gaunt_by_wigners_symbols() -> None:
    """Known integrals: y00^3 = 1 / sqrt(4 pi); z z (3 z z - 1): 1 / sqrt(5 pi); and brute force for the rest."""
    where, solid = both()
    rows = basis(where, 5)
    table = sphere.gaunt(3, 3, 5)
    found = np.zeros((9, 9, 25))
    found[table.left, table.right, table.out] = table.value
    brute = np.einsum("ni,nj,nk,n->ijk", rows[:, :9], rows[:, :9], rows, solid)
    assert np.abs(found - brute).max() < 1e-11
    assert found[0, 0, 0] == pytest.approx(1 / math.sqrt(4 * math.pi), rel=1e-13)
    assert found[2, 2, 6] == pytest.approx(1 / math.sqrt(5 * math.pi), rel=1e-13)
    one, other = np.random.default_rng(8).normal(size=(2, 9))
    product = (basis(where, 3) @ one) * (basis(where, 3) @ other)
    assert sphere.product(one, other, 5) == pytest.approx((product * solid) @ rows, abs=1e-11)
    assert sphere.multiplication(one, 3, 5) @ other == pytest.approx((product * solid) @ rows, abs=1e-11)


@pytest.mark.parametrize("angles", [(0.4, -1.1, 2.2), (0.0, np.pi / 2, 0.0), (-2.0, 0.3, 0.0)])
def test_rotations_are_scipys(angles: tuple[float, float, float]) -> None:
    """SciPy's extrinsic z, y, z; the turned environment holds at a turned direction what the old one held."""
    matrix = Rotation.from_euler("zyz", angles).as_matrix()
    assert sphere.zyz_matrix(*angles) == pytest.approx(matrix, abs=1e-14)
    weights, where = np.random.default_rng(9).normal(size=36), everywhere(20, 10)
    expected = basis(where, 6) @ weights
    for turned in (sphere.rotate_zyz(weights, *angles), sphere.rotate(weights, matrix), sphere.change_axes(weights, matrix)):
        assert basis(where @ matrix.T, 6) @ turned == pytest.approx(expected, abs=1e-11)
    azimuth = sphere.rotate_azimuth(weights, angles[0])
    about = Rotation.from_euler("z", angles[0]).as_matrix()
    assert basis(where @ about.T, 6) @ azimuth == pytest.approx(expected, abs=1e-11)


def test_a_level_skyline_is_a_cap_and_clouds_mix() -> None:
    skyline = np.array([0.1, 0.5, -0.2, 0.3])
    z, phi = np.meshgrid(np.linspace(-1, 1, 1201)[:-1] + 1 / 1200, (np.arange(1200) + 0.5) * 2 * np.pi / 1200, indexing="ij")
    flat = np.sqrt(1 - z * z)
    where = np.stack([flat * np.cos(phi), flat * np.sin(phi), z], axis=-1).reshape(-1, 3)
    edge = np.interp(phi, np.arange(5) * np.pi / 2, [*skyline, skyline[0]])
    seen = (np.arcsin(z) > edge).ravel()
    expected = basis(where[seen], 3).sum(axis=0) * 4 * np.pi / z.size
    assert sphere.horizon(skyline, 3) == pytest.approx(expected, abs=2e-3)
    level = sphere.horizon(0.4, 5)
    assert level[orders(5) == 0] == pytest.approx(sphere.cap(np.pi / 2 - 0.4, 5), abs=1e-12)
    light, mask = np.random.default_rng(12).normal(size=(2, 9))
    dirs = everywhere(30, 13)
    got = basis(dirs, 5) @ sphere.cover(light, mask, 3.0, 5)
    opacity = basis(dirs, 3) @ mask
    assert got == pytest.approx((1 - opacity) * (basis(dirs, 3) @ light) + 3.0 * opacity, abs=1e-10)


def test_the_spiral_is_even_and_golden() -> None:
    """Each azimuth is the golden angle, pi (3 - sqrt 5) = 137.5 degrees, from the last, or what is left of a turn."""
    where = sphere.spiral(400)
    steps = np.diff(np.unwrap(np.arctan2(where[:, 1], where[:, 0])))
    assert np.abs(np.cos(steps) - math.cos(math.radians(137.50776405))).max() < 1e-8
    assert np.diff(where[:, 2]) == pytest.approx(-2 / 400, rel=1e-9)
    assert where[0, 2] == pytest.approx(1 - 1 / 400, rel=1e-14)
    assert np.abs(basis(where, 4)[:, 1:].mean(axis=0)).max() < 0.01


@pytest.mark.parametrize("bands", [3, 5])
def test_the_least_window_is_the_least(bands: int) -> None:
    """Nothing below 0 on a grid of its own; a thousandth less smoothing, and something is."""
    where, _ = both(60)
    rows, l = basis(where, bands), degrees(bands)
    above, solid = hemisphere(50)
    sky = np.exp(3 * (above @ towards(0.9)))
    weights = (sky * solid) @ basis(above, bands)
    for keep, kernel in (("radiance", np.ones(bands)), ("irradiance", lobe(bands))):
        smoothing = float(sphere.nonnegative_smoothing(weights, keep))
        kept = weights * kernel[l]
        least = [(rows @ (kept / (1 + s * (l * (l + 1.0)) ** 2))).min() for s in (smoothing, 0.97 * smoothing)]
        assert least[0] > -1e-9 * kept[0]
        assert smoothing == 0.0 or least[1] < 0


def test_minimum_is_scipys() -> None:
    weights = np.random.default_rng(14).normal(size=(3, 16))
    values, places = sphere.minimum(weights)
    dense = everywhere(20000, 15)
    sampled = (basis(dense, 4) @ weights.T).min(axis=0)
    assert np.all(values <= sampled + 1e-12)
    assert values == pytest.approx(sampled, abs=0.02)
    assert [float(basis(p[np.newaxis], 4)[0] @ w) for p, w in zip(places, weights, strict=True)] == pytest.approx(
        values.tolist()
    )


def test_indices() -> None:
    """l (l + 1) + m, in the order of the design."""
    pairs = [(l, m) for l in range(5) for m in range(-l, l + 1)]
    assert [sphere.flat_index(l, m) for l, m in pairs] == list(range(25))
    every = sphere.Harmonics(5)
    assert list(zip(every.degrees.tolist(), every.orders.tolist(), strict=True)) == pairs
    assert [sphere.Harmonics(5).count, sphere.Harmonics.even(5).count] == [25, 15]
    full = sphere.Harmonics.even(5).unmirror(np.arange(1.0, 16.0))
    assert full[[m < 0 for _, m in pairs]].tolist() == [0.0] * 10
    assert full[[m >= 0 for _, m in pairs]].tolist() == list(itertools.accumulate([1.0] * 15))
    assert upper(3).shape == (3, 3)
