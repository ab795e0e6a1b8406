"""Operations on SH weights: rotations, windows, convolutions, products, caps; and the papers' golden examples."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

import numpy as np
import pytest
import sphericart
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation
from skylight_sh import sphere
from test_sphere import directions

Array = NDArray[np.float64]
BANDS = 31
# A number of bands as code that is not type-checked might give it.
HALF_A_BAND: Any = 2.5
SEEDS = st.integers(0, 10_000)
# Turns near which angles or recurrences might lose digits.
SPECIAL = [(0.0, 0.0, 0.0), (0.3, 1e-9, 0.2), (1.0, np.pi, -2.0), (0.5, np.pi - 1e-7, 3.0), (0.0, np.pi / 2, 0.0)]


def turn(seed: int) -> Array:
    return np.asarray(Rotation.random(rng=seed).as_matrix())


def weights(seed: int, bands: int, *lead: int) -> Array:
    return np.random.default_rng(seed).normal(size=(*lead, bands * bands))


def sphere_rule(degree: int) -> tuple[Array, Array]:
    """Directions and areas that integrate polynomials of ``degree`` exactly, turned away from the axes."""
    z, areas = np.polynomial.legendre.leggauss(degree // 2 + 1)
    phi = np.arange(degree + 1) * 2 * np.pi / (degree + 1)
    s = np.sqrt(1 - z * z)[:, np.newaxis]
    where = np.stack(np.broadcast_arrays(s * np.cos(phi), s * np.sin(phi), z[:, np.newaxis]), axis=-1).reshape(-1, 3)
    return where @ turn(1).T, np.repeat(areas * 2 * np.pi / (degree + 1), degree + 1)


# Rotations


@given(seed=SEEDS)
@settings(max_examples=25)
def test_rotation_to_degree_30_is_orthogonal_composes_and_inverts(seed: int) -> None:
    one, two = turn(seed), turn(seed + 1)
    whole = sphere.rotation_blocks(np.stack([one, two, two @ one, one.T]), BANDS)
    for block in whole:
        first, second, both, back = block
        assert np.abs(first @ first.T - np.eye(len(first))).max() < 1e-14
        assert np.abs(second @ first - both).max() < 2e-14
        assert np.abs(back - first.T).max() < 2e-14


@pytest.mark.parametrize("angles", SPECIAL + [tuple(directions(1, k)[0] * 6) for k in range(6)])
def test_rotation_to_degree_30_agrees_with_independent_libraries(angles: tuple[float, float, float]) -> None:
    """Rows of SciPy's rotation, harmonics of sphericart at the rotated points, ZYZ turns of our own."""
    matrix = Rotation.from_euler("zyz", angles).as_matrix()
    where = directions(60)
    harmonics = sphericart.SphericalHarmonics(BANDS - 1)
    here, there = harmonics.compute(where), harmonics.compute(where @ matrix.T)
    for l, block in enumerate(sphere.rotation_blocks(matrix, BANDS)):
        part = slice(l * l, (l + 1) ** 2)
        assert np.abs(there[:, part] @ block - here[:, part]).max() < 2e-13
    drawn = weights(0, BANDS) / BANDS
    assert np.abs(there @ sphere.rotate(drawn, matrix) - here @ drawn).max() < 1e-12
    assert np.abs(sphere.zyz_matrix(*angles) - matrix).max() < 1e-15
    assert np.abs(sphere.rotate_zyz(drawn, *angles) - sphere.rotate(drawn, matrix)).max() < 1e-13


@given(azimuth=st.floats(-2 * np.pi, 2 * np.pi))
@settings(max_examples=50)
def test_equation_4_is_the_general_rotation_about_the_zenith(azimuth: float) -> None:
    general = sphere.rotate(np.eye(BANDS**2), sphere.zyz_matrix(azimuth, 0.0, 0.0))
    assert np.abs(sphere.rotate_azimuth(np.eye(BANDS**2), azimuth) - general).max() < 5e-14


def test_rotation_stays_orthogonal_at_64_bands() -> None:
    one, two = turn(3), turn(4)
    first, second, both = sphere.rotation_blocks(np.stack([one, two, two @ one]), 64)[-1]
    assert np.abs(first @ first.T - np.eye(127)).max() < 1e-14
    assert np.abs(second @ first - both).max() < 5e-14


def test_rotations_broadcast_over_leading_axes() -> None:
    drawn, turns = weights(1, 4, 2, 1), Rotation.random(3, rng=2).as_matrix()
    angles = np.random.default_rng(3).uniform(-3, 3, size=(3, 2, 3))
    every, by_angles = sphere.rotate(drawn, turns), sphere.rotate_zyz(drawn, *angles)
    assert every.shape == by_angles.shape == (2, 3, 16)
    for i, k in np.ndindex(2, 3):
        assert every[i, k] == pytest.approx(sphere.rotate(drawn[i, 0], turns[k]), abs=1e-14)
        assert by_angles[i, k] == pytest.approx(sphere.rotate_zyz(drawn[i, 0], *angles[:, i, k]), abs=1e-14)


def test_a_matrix_typed_with_seven_digits_turns_as_the_nearest_rotation() -> None:
    found = sphere.rotation_blocks(np.round(turn(5), 7), BANDS)
    assert max(np.abs(block @ block.T - np.eye(len(block))).max() for block in found) < 1e-14


def test_whole_numbers_turn_like_others() -> None:
    whole = np.array([1, 2, 3, 4])
    assert sphere.rotate_azimuth(whole, 0.5) == pytest.approx(sphere.rotate_azimuth(whole.astype(float), 0.5), abs=1e-15)


# Windows


def test_windows_have_their_closed_forms() -> None:
    l = np.arange(1, 6)
    x = np.pi * l / 6
    assert sphere.lanczos_window(6)[1:] == pytest.approx(np.sin(x) / x)
    assert sphere.sinc_window(6, power=3)[1:] == pytest.approx((np.sin(x) / x) ** 3)
    assert sphere.hann_window(6)[1:] == pytest.approx(0.5 + 0.5 * np.cos(x))
    assert sphere.laplacian_window(6, 0.01)[1:] == pytest.approx(1 / (1 + 0.01 * l**2 * (l + 1) ** 2))
    for window in (sphere.sinc_window(8, cutoff=4.0), sphere.hann_window(8, cutoff=4.0)):
        assert window[0] == 1.0
        assert not window[4:].any()
    assert sphere.laplacian_window(3, [0.0, np.inf]).tolist() == [[1, 1, 1], [1, 0, 0]]


@pytest.mark.parametrize("keep", ["radiance", "irradiance"])
@pytest.mark.parametrize("bands", [2, 3, 5, 7, 10])
def test_nonnegative_smoothing_is_nowhere_negative_and_smooths_no_more_than_that(
    bands: int, keep: Literal["radiance", "irradiance"]
) -> None:
    """On 10,000 directions: small suns over dim caps, an expansion at random, and one that needs nothing."""
    lights = sphere.aim(sphere.cap([0.05, 0.3, 0.8], bands), directions(3)) + 0.05 * sphere.aim(
        sphere.cap(1.2, bands), directions(1, 1)
    )
    drawn = weights(bands, bands, 2)
    drawn[:, 0] = np.abs(drawn[:, 0]) + 1
    calm = np.where(np.arange(bands**2) == 0, 1.0, 1e-3 / bands**2)
    known = np.concatenate([lights, drawn, calm[np.newaxis]])
    kernel = sphere.clamped_cosine(bands) if keep == "irradiance" else np.ones(bands)
    smoothing = sphere.nonnegative_smoothing(known, keep)
    after = sphere.scale_degrees(known, kernel * sphere.laplacian_window(bands, smoothing))
    assert sphere.evaluate(after, directions(10_000, 9)).min() >= 0.0
    least, where = sphere.minimum(after)
    assert least.min() >= 0.0
    assert least == pytest.approx([float(sphere.evaluate(a, w[np.newaxis])[0]) for a, w in zip(after, where, strict=True)])
    assert smoothing[-1] == 0.0
    acted = smoothing > 0
    assert acted.any()
    less = sphere.scale_degrees(known, kernel * sphere.laplacian_window(bands, 0.9999 * smoothing))
    assert np.all(sphere.minimum(less)[0][acted] < 0)


def test_minimum_is_below_any_sample() -> None:
    known = weights(7, 8, 20)
    sampled = sphere.evaluate(known, directions(40_000)).min(axis=1)
    assert np.all(sphere.minimum(known)[0] <= sampled)
    valley = sphere.rotate(np.eye(16)[0] + np.eye(16)[6], turn(2))  # least all along a circle
    assert float(sphere.minimum(valley)[0]) == pytest.approx(np.sqrt(0.25 / np.pi) - np.sqrt(5 / (16 * np.pi)), abs=1e-13)
    zonal = np.eye(49)[2] - 0.5 * np.eye(49)[0]
    least, where = sphere.minimum(zonal)
    assert float(least) == pytest.approx(-np.sqrt(3 / (4 * np.pi)) - 0.5 * np.sqrt(0.25 / np.pi), abs=1e-14)
    assert where == pytest.approx([0, 0, -1], abs=1e-6)


# Convolutions


def test_clamped_cosine_equals_its_integral_at_any_degree() -> None:
    x, areas = np.polynomial.legendre.leggauss(40)
    x, areas = (x + 1) / 2, areas / 2
    expected = [2 * np.pi * areas @ (x * np.polynomial.legendre.Legendre.basis(l)(x)) for l in range(64)]
    assert np.abs(sphere.clamped_cosine(64) - expected).max() < 1e-13
    assert np.isfinite(sphere.clamped_cosine(1200)).all()


def test_convolution_is_the_integral_against_the_turned_kernel() -> None:
    known, kernel = weights(0, 6, 2), np.random.default_rng(1).normal(size=6)
    where, areas = sphere_rule(12)
    towards = directions(10)
    turned = sphere.aim(kernel, towards)
    integral = sphere.evaluate(known, where) * areas @ sphere.evaluate(turned, where).T
    assert np.abs(sphere.evaluate(sphere.convolve(known, kernel), towards) - integral).max() < 1e-12
    assert np.abs(sphere.dot(known[:, np.newaxis], turned) - integral).max() < 1e-12


def test_packed_irradiance_of_exactly_two_bands() -> None:
    # An even sky of radiance 1 over the whole sphere sends pi onto every surface, and has no second band.
    even = np.array([np.sqrt(4 * np.pi), 0.0, 0.0, 0.0])
    assert sphere.packed_irradiance(even) == pytest.approx([np.pi, 0.0, 0.0, 0.0], rel=1e-15)
    with pytest.raises(ValueError, match="at least 2"):
        sphere.packed_irradiance(even[:1])


def test_packed_irradiance_is_a_dot_product_with_the_normal() -> None:
    """004's constants: a light from p packs to 1/4 and 1/2 (y, z, x), up to the basis' pi."""
    towards = directions(20)
    light = sphere.basis(towards, 5)
    packed = sphere.packed_irradiance(light)
    x, y, z = towards.T
    assert np.abs(packed - np.stack([0.25 + 0 * x, 0.5 * y, 0.5 * z, 0.5 * x], axis=-1)).max() < 1e-15
    linear = packed @ np.stack([1 + 0 * x, y, z, x])
    assert np.abs(linear - sphere.evaluate(sphere.irradiance(light[:, :4]), towards)).max() < 1e-14


def test_hazels_irradiance_is_never_negative_and_keeps_its_mean() -> None:
    axis = directions(1)[0]
    ratio = np.array([0.0, 1e-5, 0.5, 0.9, 1.0, 1.7])
    packed = 2.0 * np.concatenate([np.ones((6, 1)), 2 * ratio[:, np.newaxis] * axis[[1, 2, 0]]], axis=1)
    where, areas = sphere_rule(200)
    found = sphere.nonnegative_irradiance(packed, where)
    assert found.min() >= 0
    assert found @ areas / (4 * np.pi) == pytest.approx(np.full(6, 2.0), rel=1e-6)
    assert sphere.nonnegative_irradiance(packed, axis[np.newaxis])[2:5, 0] == pytest.approx([14 / 3, 2 * 6.94 / 1.9, 8.0])
    linear = packed @ np.concatenate([np.ones((1, len(where))), where[:, [1, 2, 0]].T])
    assert np.abs(found - linear)[:2].max() < 1e-9
    assert not sphere.nonnegative_irradiance(np.array([[0.0, 0, 0, 0], [-1, 1, 0, 0]]), where).any()


# Products


def test_gaunt_coefficients_equal_integration_and_leave_nothing_out() -> None:
    where, areas = sphere_rule(22)
    full = sphere.basis(where, 12)
    expected = np.einsum("qi,qj,qk->ijk", full[:, :36] * areas[:, np.newaxis], full[:, :49], full, optimize=True)
    table = sphere.gaunt(6, 7, 12)
    found = np.zeros_like(expected)
    found[table.left, table.right, table.out] = table.value
    assert np.abs(found - expected).max() < 1e-13
    assert np.count_nonzero(np.abs(expected) > 1e-12) == table.value.size < 0.08 * expected.size
    k = np.sqrt(5 / np.pi)
    for place, value in {(0, 5, 5): np.sqrt(0.25 / np.pi), (6, 6, 6): k / 7, (8, 8, 6): -k / 7, (7, 7, 6): k / 14}.items():
        assert found[place] == pytest.approx(value, rel=1e-14)


@given(seed=SEEDS, first=st.integers(1, 6), second=st.integers(1, 6))
@settings(max_examples=30)
def test_product_is_the_product_everywhere(seed: int, first: int, second: int) -> None:
    one, other = weights(seed, first, 3, 1), weights(seed + 1, second, 2)
    where = directions(30, seed)
    whole = sphere.product(one, other)
    assert whole.shape == (3, 2, (first + second - 1) ** 2)
    expected = sphere.evaluate(one, where) * sphere.evaluate(other, where)
    assert np.abs(sphere.evaluate(whole, where) - expected).max() < 1e-12 * max(1.0, np.abs(expected).max())
    assert np.abs(sphere.product(one, other, first) - sphere.product(other, one, first)).max() < 1e-13 * 36
    padded = sphere.product(one, other, first + second + 1)
    assert np.abs(padded[..., : whole.shape[-1]] - whole).max() < 1e-13 * 36
    assert not padded[..., whole.shape[-1] :].any()


def test_multiplication_matrix_is_the_product_with_its_function_fixed() -> None:
    mask, light = weights(1, 5, 2), weights(2, 6, 3)
    matrix = sphere.multiplication(mask, 6)
    assert np.abs(matrix - matrix.swapaxes(-1, -2)).max() < 1e-14
    got = light @ matrix.swapaxes(-1, -2)
    assert np.abs(got - sphere.product(mask[:, np.newaxis], light, 6)).max() < 1e-13
    assert sphere.multiplication(mask, 6, 3).shape == (2, 9, 36)
    assert np.abs(sphere.multiplication(np.eye(9)[0] * np.sqrt(4 * np.pi), 4) - np.eye(16)).max() < 1e-14


def test_greens_transfer_matrix_of_a_mask_that_is_y22() -> None:
    """His figure 9: 25 x 25, mostly empty."""
    where, areas = sphere_rule(10)
    rows = sphere.basis(where, 5)
    matrix = sphere.multiplication(np.eye(9)[8], 5)
    assert np.abs(matrix - rows.T @ (rows * (areas * rows[:, 8])[:, np.newaxis])).max() < 1e-14
    assert 0 < np.count_nonzero(matrix) < 60


def test_everything_but_a_cap_times_the_sky_is_the_shadowed_sky() -> None:
    """Proxy shadow: a constant sky behind the mask is the mask; a cap and its complement restore any sky."""
    blocked = sphere.aim(sphere.cap(0.4, 5), directions(1)[0])
    mask = np.sqrt(4 * np.pi) * np.eye(25)[0] - blocked
    sky = weights(3, 4)
    assert np.abs(sphere.product(mask, np.eye(16)[0] * np.sqrt(4 * np.pi), 5) - mask).max() < 1e-14
    assert np.abs(sphere.product(mask, sky, 4) + sphere.product(blocked, sky, 4) - sky).max() < 1e-13


# Caps


def test_caps_equal_integration_and_greens_closed_forms() -> None:
    angles = np.array([0.1, 0.7, 1.5, 2.9])
    x, areas = np.polynomial.legendre.leggauss(30)
    half = (1 - np.cos(angles))[:, np.newaxis] / 2
    rows = sphere.legendre(1 - half * (1 - x), np.sqrt(half * (1 - x) * (2 - half * (1 - x))), 40)
    zonal = np.moveaxis(rows[np.arange(40) * np.arange(1, 41) // 2], 0, 1)
    assert np.abs(2 * np.pi * half * (zonal @ areas) - sphere.cap(angles, 40)).max() < 1e-13
    c, s2 = np.cos(angles), np.sin(angles) ** 2
    green = [1.772453851 * (1 - c), 1.534990062 * s2, 1.98166365 * (c - c**3)]
    green += [2.930920062 * (1 - c**4) - 3.517104075 * s2]
    assert np.abs(sphere.cap(angles, 4) - np.stack(green, axis=-1)).max() < 1e-8
    assert sphere.cap([0.0, np.pi], 3) == pytest.approx(np.array([[0, 0, 0], [np.sqrt(4 * np.pi), 0, 0]]), abs=1e-15)


# Golden examples


def test_cartesian_polynomials_of_four_bands() -> None:
    x, y, z = where = directions(50).T
    c = np.sqrt(np.array([1, 3, 15, 5, 15, 70, 105, 42, 7, 105]) / np.pi) * [4, 4, 4, 2, 2, 1, 4, 1, 2, 2] / 8
    expected = [c[0] + 0 * x, c[1] * y, c[1] * z, c[1] * x]
    expected += [c[2] * x * y, c[2] * y * z, c[3] * (3 * z * z - 1), c[2] * x * z, c[4] * (x * x - y * y)]
    expected += [c[5] * y * (3 * x * x - y * y), c[6] * x * y * z, c[7] * y * (5 * z * z - 1), c[8] * z * (5 * z * z - 3)]
    expected += [c[7] * x * (5 * z * z - 1), c[9] * z * (x * x - y * y), c[5] * x * (x * x - 3 * y * y)]
    assert np.abs(sphere.basis(where.T, 4) - np.stack(expected, axis=-1)).max() < 2e-15


def test_greens_two_lights() -> None:
    """max(0, 5 cos theta - 4) + max(0, -4 sin(theta - pi) cos(phi - 2.5) - 3), both symmetric about an axis."""
    lights = np.zeros(16)
    for slope, level, axis in ((5.0, 4.0, [0.0, 0, 1]), (4.0, 3.0, [np.cos(2.5), np.sin(2.5), 0.0])):
        x, areas = np.polynomial.legendre.leggauss(6)
        half = (1 - level / slope) / 2
        x = 1 - half * (1 - x)
        rows = sphere.legendre(x, np.sqrt(1 - x * x), 4)[[0, 1, 3, 6]]
        lights += sphere.aim(2 * np.pi * half * rows @ (areas * (slope * x - level)), np.array(axis))
    golden = [0.39880, 0.21052, 0.28653, -0.28182, -0.31499, 0, 0.13138, 0, 0.09318, 0.24961, 0, -0.12336, 0.30388]
    golden += [0.16513, 0, 0.09224]
    assert np.abs(lights - golden).max() < 5.1e-6


# Errors


@pytest.mark.parametrize(
    ("call", "match"),
    [
        (lambda: sphere.rotate(np.ones(9), 1.001 * np.eye(3)), r"1\.001.*orthogonal 3x3.*divide each column"),
        (lambda: sphere.rotate(np.ones(9), np.diag([1.0, -1, 1])), "determinant -1.*change_axes"),
        (lambda: sphere.rotate(np.ones((2, 9)), np.stack([np.eye(3), np.full((3, 3), np.nan)])), "nan.*orthogonal"),
        (lambda: sphere.rotate(np.ones(9), np.eye(4)), r"shape \(4, 4\)"),
        (lambda: sphere.rotate_zyz(np.ones(8), 0, 0, 0), "8 weights"),
        (lambda: sphere.scale_degrees(np.ones(9), np.ones(4)), r"shape \(4,\).*\(\.\.\., 3\)"),
        (lambda: sphere.sinc_window(4, cutoff=0.0), "cutoff 0.0"),
        (lambda: sphere.sinc_window(4, power=-1), "power -1"),
        (lambda: sphere.laplacian_window(4, np.nan), "smoothing nan"),
        (lambda: sphere.nonnegative_smoothing(-np.ones(9)), "mean.*-1.0"),
        (lambda: sphere.nonnegative_smoothing(np.full(9, np.inf)), "weight inf"),
        (lambda: sphere.packed_irradiance(np.ones(1)), "at least 2"),
        (lambda: sphere.nonnegative_irradiance(np.ones(3), np.eye(3)), r"shape \(3,\)"),
        (lambda: sphere.cap([0.1, -0.2], 4), "half-angle -0.2"),
        (lambda: sphere.gaunt(2, 2, 0), "bands 0"),
        (lambda: sphere.cap(0.1, HALF_A_BAND), "bands 2.5"),
        (lambda: sphere.rotate_azimuth(np.ones(4), np.nan), "azimuth nan"),
        (lambda: sphere.evaluate(np.ones(4), np.array([[0.0, 0.0, 2.0]])), "length 2.0.*divide it"),
        (lambda: sphere.add_ground(np.ones(4), 1.7, 2), "albedo 1.7"),
        (lambda: sphere.cover(np.ones(4), np.full(4, np.nan), 1.0), "opacity nan"),
        (lambda: sphere.minimum(np.full(4, np.nan)), "weight nan"),
        (lambda: sphere.spiral(0), "count 0"),
        (lambda: sphere.product(np.ones(5), np.ones(4)), "5 weights"),
    ],
)
def test_errors_name_the_value_and_the_remedy(call: Callable[[], object], match: str) -> None:
    with pytest.raises(ValueError, match=match):
        call()
