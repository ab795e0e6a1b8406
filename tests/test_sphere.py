"""Spherical harmonics: independent library, closed forms, rotation identities."""

from __future__ import annotations

import ast
import math
from collections.abc import Callable
from importlib import import_module
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sphericart
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from skylight_sh import sphere
from skylight_sh.runtime import flat_places

Array = NDArray[np.float64]


def directions(count: int, seed: int = 0) -> Array:
    drawn = np.random.default_rng(seed).normal(size=(count, 3))
    return np.asarray(drawn / np.linalg.norm(drawn, axis=1, keepdims=True))


def test_basis_equals_an_independent_library() -> None:
    where = directions(300)
    expected = sphericart.SphericalHarmonics(20).compute(where)
    assert np.abs(sphere.basis(where, 21) - expected).max() < 1e-13


def test_basis_closed_forms_have_no_condon_shortley_sign() -> None:
    x, y, z = where = directions(50).T
    got = sphere.basis(where.T, 3)
    k = np.sqrt(3 / (4 * np.pi))
    expected = [np.full_like(x, np.sqrt(0.25 / np.pi)), k * y, k * z, k * x]
    expected += [np.sqrt(15 / (4 * np.pi)) * x * y, np.sqrt(15 / (4 * np.pi)) * y * z]
    expected += [np.sqrt(5 / (16 * np.pi)) * (3 * z * z - 1), np.sqrt(15 / (4 * np.pi)) * x * z]
    expected += [np.sqrt(15 / (16 * np.pi)) * (x * x - y * y)]
    assert np.abs(got - np.stack(expected, axis=-1)).max() < 1e-15


@pytest.mark.parametrize("theta", [1e-9, 0.3, 1.5, 3.1415])
def test_legendre_factors_match_mpmath(theta: float) -> None:
    bands = 40
    got = sphere.legendre(np.array(np.cos(theta)), np.array(np.sin(theta)), bands)
    with mpmath.workdps(60):
        for l, m in [(0, 0), (1, 1), (7, 3), (20, 20), (39, 0), (39, 17), (39, 38)]:
            x, sine = mpmath.cos(mpmath.mpf(theta)), mpmath.sin(mpmath.mpf(theta))
            norm = mpmath.sqrt(
                (2 - (m == 0)) * (2 * l + 1) / (4 * mpmath.pi) * mpmath.factorial(l - m) / mpmath.factorial(l + m)
            )
            derivative = mpmath.fsum(
                (-1) ** k * math.comb(l, k) * math.comb(2 * l - 2 * k, l) * math.perm(l - 2 * k, m) * x ** (l - 2 * k - m)
                for k in range((l - m) // 2 + 1)
            )
            exact = norm * sine**m * derivative / 2**l
            assert float(got[l * (l + 1) // 2 + m]) == pytest.approx(float(exact), rel=1e-12, abs=1e-13)


@given(azimuth=st.floats(-20, 20), seed=st.integers(0, 1000))
def test_azimuth_rotation_moves_the_environment(azimuth: float, seed: int) -> None:
    weights = np.random.default_rng(seed).normal(size=(2, 36))
    where = directions(20, seed)
    c, s = np.cos(azimuth), np.sin(azimuth)
    turned = where @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    got = sphere.evaluate(sphere.rotate_azimuth(weights, azimuth), turned)
    assert np.abs(got - sphere.evaluate(weights, where)).max() < 1e-12


@given(angle=st.floats(-7, 7), seed=st.integers(0, 1000))
def test_rotation_about_y_moves_the_environment(angle: float, seed: int) -> None:
    weights = np.random.default_rng(seed).normal(size=(1, 2, 64))
    where = directions(20, seed)
    c, s = np.cos(angle), np.sin(angle)
    turned = where @ np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]]).T
    got = sphere.evaluate(sphere.rotate_y(weights, np.array([angle]), sphere.Harmonics(8))[0], turned)
    assert np.abs(got - sphere.evaluate(weights[0], where)).max() < 1e-12


@given(first=st.floats(-3, 3), second=st.floats(-3, 3))
def test_rotations_about_y_compose_and_keep_the_norm(first: float, second: float) -> None:
    held = sphere.Harmonics.even(32)
    weights = np.random.default_rng(3).normal(size=(1, held.count))
    one = sphere.rotate_y(sphere.rotate_y(weights, np.array([first]), held), np.array([second]), held)
    both = sphere.rotate_y(weights, np.array([first + second]), held)
    assert np.abs(one - both).max() < 1e-12
    assert np.linalg.norm(both) == pytest.approx(np.linalg.norm(weights), rel=1e-13)


def test_window_touches_zonal_weights_alone() -> None:
    window = sphere.zonal_sinc(4)
    degrees, orders = sphere.Harmonics(4).degrees, sphere.Harmonics(4).orders
    assert np.all(window[orders != 0] == 1.0)
    assert window[orders == 0] == pytest.approx(
        [1.0, np.sin(np.pi / 4) / (np.pi / 4), 2 / np.pi, np.sin(3 * np.pi / 4) / (3 * np.pi / 4)]
    )
    assert degrees[orders == 0].tolist() == [0, 1, 2, 3]


@pytest.mark.parametrize("held", [sphere.Harmonics(6), sphere.Harmonics.even(6), sphere.Harmonics(1)])
def test_harmonics_hold_degrees_and_orders_in_flat_order(held: sphere.Harmonics) -> None:
    pairs = [(l, m) for l in range(held.bands) for m in range(0 if held.mirrored else -l, l + 1)]
    assert list(zip(held.degrees.tolist(), held.orders.tolist(), strict=True)) == pairs
    assert (
        held.flat.tolist()
        == [sphere.flat_index(l, m) for l, m in pairs]
        == flat_places(held.bands, mirrored=held.mirrored).tolist()
    )
    assert held.triangle.tolist() == [l * (l + 1) // 2 + abs(m) for l, m in pairs]
    assert held.count == len(pairs) == held.degrees.size
    assert sphere.Harmonics.of_degrees(held.degrees) == held
    first = held.first(1)
    assert np.array_equal(held.flat[: first.count], first.flat)
    with pytest.raises(ValueError, match="read-only"):
        held.degrees[0] = 1


def test_unmirror_puts_exact_zeros_at_negative_orders() -> None:
    half = np.arange(1.0, 7.0)
    assert sphere.Harmonics.even(3).unmirror(half).tolist() == [1, 0, 2, 3, 0, 0, 4, 5, 6]


@pytest.mark.parametrize(
    ("call", "match"),
    [
        (lambda: sphere.flat_index(1, 2), "degree 1 and order 2"),
        (lambda: sphere.basis(np.zeros((1, 3)), 0), "number of bands 0"),
        (lambda: sphere.evaluate(np.zeros(5), np.zeros((1, 3))), "5 weights"),
        (lambda: sphere.Harmonics.even(3).unmirror(np.zeros(5)), "6 weights of order m >= 0, .* holds 5"),
        (lambda: sphere.Harmonics(2).unmirror(np.zeros(5)), "4 weights of all orders, .* holds 5"),
        (lambda: sphere.Harmonics(0), "number of bands 0"),
        (lambda: sphere.Harmonics.of_degrees(np.array([0, 1, 1, 1, 2])), "5 weights of degrees up to 2"),
    ],
)
def test_errors_name_the_value(call: Callable[[], object], match: str) -> None:
    with pytest.raises(ValueError, match=match):
        call()


def test_every_name_is_looked_up_where_it_is_written() -> None:
    """Names come late, from the first module that has one of that name: it must be the one that types are read from."""
    (block,) = (
        node for node in ast.parse(Path(sphere.__file__).read_text(encoding="utf-8")).body if isinstance(node, ast.If)
    )
    homes = {alias.name: node.module for node in block.body if isinstance(node, ast.ImportFrom) for alias in node.names}
    assert sorted(homes) == sorted(sphere.__all__)
    for name, home in homes.items():
        assert getattr(sphere, name) is getattr(import_module(str(home)), name)
    assert not hasattr(sphere, "legendres")
