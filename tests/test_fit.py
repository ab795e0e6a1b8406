"""Fits: exact recovery, maps, error measures, the sweep against its definition, staircases."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from sampled import plain
from skylight_sh.fit import errors, least_squares, sweep
from skylight_sh.fit.axis import Axis
from skylight_sh.fit.minimax import OF_FITTED, OF_ROUNDED, Sharpening, even, metric, sharpen
from skylight_sh.fit.sampled import Sampled
from skylight_sh.fit.term_selection import fewest
from skylight_sh.formula.bases import BASES

Array = NDArray[np.float64]
VARIABLES = st.sampled_from([("identity", 0.0), ("log", -0.5), ("reciprocal", -2.0), ("reciprocal", 30.0), ("cbrt", 30.0)])


@given(low=st.floats(0.0, 3.0), width=st.floats(0.1, 9.0), kind=VARIABLES, share=st.floats(0.0, 1.0))
def test_maps_reach_both_ends_rise_or_fall_and_invert(
    low: float, width: float, kind: tuple[str, float], share: float
) -> None:
    axis = Axis("x", low, low + width, map=kind[0], point=kind[1])
    ends = axis.scaled(np.array([axis.low, axis.high]))
    assert sorted(ends) == pytest.approx([-1.0, 1.0], abs=1e-12)
    value = np.array([low + share * width])
    assert axis.unscaled(axis.scaled(value)) == pytest.approx(value, rel=1e-9, abs=1e-9)
    assert axis.scaled(value.astype(np.float32)).dtype == np.float32


@pytest.mark.parametrize("name", BASES)
def test_bases_match_numpy(name: str) -> None:
    u = np.linspace(-1, 1, 50)
    waves = [np.ones_like(u)] + [f(k * np.pi * u) for k in range(1, 6) for f in (np.cos, np.sin)]
    expected = {
        "chebyshev": np.polynomial.chebyshev.chebvander(u, 9),
        "legendre": np.polynomial.legendre.legvander(u, 9),
        "monomial": np.vander(u, 10, increasing=True),
        "fourier": np.stack(waves[:10], axis=-1),
    }[name]
    assert np.abs(BASES[name].vander(u, 9) - expected).max() < 1e-14


@pytest.mark.parametrize("degrees", [(5,), (4, 3), (2, 3, 1)])
def test_tensor_fit_recovers_a_polynomial_over_any_number_of_axes(degrees: tuple[int, ...]) -> None:
    rng = np.random.default_rng(0)
    axes = [Axis(f"x{i}", 0.5, 2.0 + i, map="reciprocal", point=-1.0) for i in range(len(degrees))]
    nodes = [axis.fit_nodes(d + 3, "chebyshev") for axis, d in zip(axes, degrees, strict=True)]
    matrices = [BASES["chebyshev"].vander(a.scaled(n), d) for a, n, d in zip(axes, nodes, degrees, strict=True)]
    exact = rng.normal(size=(7, *(d + 1 for d in degrees)))
    samples = np.moveaxis(exact, 0, -1)
    for axis, matrix in enumerate(matrices):
        samples = np.moveaxis(np.tensordot(matrix, samples, axes=(1, axis)), 0, axis)
    assert np.abs(least_squares.fit_tensor(samples, matrices) - exact).max() < 1e-13
    for solver in least_squares.SOLVERS:
        assert np.abs(least_squares.fit_full(samples, matrices, solver) - exact).max() < 1e-12
    assert least_squares.condition(matrices) < 8


def test_lower_fits_are_truncations() -> None:
    axis = Axis("x", 0.0, 1.0)
    x = axis.fit_nodes(20, "chebyshev")
    values = np.exp(3 * x)[:, np.newaxis]
    fits = [least_squares.fit_tensor(values, [BASES["chebyshev"].vander(axis.scaled(x), d)])[0] for d in (9, 4)]
    assert np.abs(fits[0][:5] - fits[1]).max() < 1e-13


@given(st.integers(2, 80), st.integers(5, 120))
def test_verification_nodes_keep_the_ends_and_share_no_interior_node(fitted: int, count: int) -> None:
    axis = Axis("x", 0.0, np.pi / 2)
    for spacing in ("chebyshev", "uniform"):
        nodes = axis.fit_nodes(fitted, spacing)
        check = axis.verification_nodes(count, nodes)
        assert (check[0], check[-1]) == (axis.low, axis.high)
        assert np.all(np.diff(check) > 0)
        assert not set(check[1:-1].tolist()) & set(nodes.tolist())


def small_reference() -> errors.Reference:
    rng = np.random.default_rng(4)
    parameters = rng.uniform([0.0, 1.0], [1.0, 3.0], size=(300, 2))
    degrees = np.array([0, 1, 1, 2, 2, 2])
    weights = rng.normal(size=(300, 2, 6))
    # Least luminances of few bits: rounding, which a test of its own holds, leaves them alone.
    least = rng.integers(128, 512, 300) / 256
    return errors.Reference(parameters, weights, degrees, least, rng.uniform(2.0, 3.0, 300))


def test_sweep_equals_its_definition() -> None:
    reference = small_reference()
    axes = (Axis("a", 0.0, 1.0), Axis("b", 1.0, 3.0))
    rng = np.random.default_rng(5)
    coefficients = rng.normal(size=(2, 6, 5, 4))
    factor, waves = rng.uniform(1, 2, (300, 2, 2)), rng.uniform(0, 1, (300, 6))
    vanders = [
        BASES["chebyshev"].vander(a.scaled(reference.parameters[:, i]), d)
        for i, (a, d) in enumerate(zip(axes, (4, 3), strict=True))
    ]
    worst = sweep.sweep(coefficients, vanders, factor, waves, reference, [range(2, 5), range(1, 4)], 3)
    assert sorted(worst.degrees) == sorted(itertools.product(range(2, 5), range(1, 4)))
    for row, (first, second) in enumerate(worst.degrees):
        cut = coefficients[:, :, : first + 1, : second + 1]
        made = np.einsum("ni,nj,cwij->ncw", vanders[0][:, : first + 1], vanders[1][:, : second + 1], cut)
        residual = np.einsum("nck,nkw->ncw", factor, made) * waves[:, np.newaxis] - reference.weights
        for name, l_min in {"per-set": reference.least, "global": np.full(300, reference.least.min())}.items():
            for bands in (1, 2, 3):
                part = residual[..., reference.degrees < bands]
                e_max = np.abs(part).sum(axis=-1) / l_min[:, np.newaxis]
                e_mean = np.sqrt((part**2).sum(axis=-1)) / l_min[:, np.newaxis]
                assert worst.e_max[name][row, :, bands - 1] == pytest.approx(e_max.max(axis=0), rel=1e-12)
                assert worst.e_mean[name][row, :, bands - 1] == pytest.approx(e_mean.max(axis=0), rel=1e-12)
                assert worst.at[name][row, :, bands - 1].tolist() == e_mean.argmax(axis=0).tolist()


def test_a_light_with_black_parts_is_measured_by_its_mean() -> None:
    reference = small_reference()
    assert list(reference.l_min) == ["per-set", "global"]
    black = errors.Reference(reference.parameters, reference.weights, reference.degrees, 0 * reference.least, reference.mean)
    assert list(black.l_min) == ["mean"]


def test_mean_luminance_of_a_uniform_sky() -> None:
    # c_00 of a constant 5 over the upper hemisphere is 5 * y_00 * 2 pi.
    first = np.array([[5.0 * np.sqrt(0.25 / np.pi) * 2 * np.pi]])
    assert errors.mean_luminance(first, np.ones(1)) == pytest.approx([5.0])


def sampled(count: int) -> Sampled:
    """Three smooth weights of two channels over one variable, in units of L_min."""
    u = -np.cos(np.pi * (np.arange(count) + 0.5) / count)
    truth = np.stack([np.exp(u), np.sin(3 * u), 1 / (1.4 - u)], axis=-1)[:, np.newaxis] * np.array([[1.0], [0.7]])
    return plain(np.polynomial.chebyshev.chebvander(u, 11), truth)


@pytest.mark.parametrize("budget", [0.1, 1e-2, 1e-3])
def test_fewest_terms_keep_the_budget_and_no_fewer_do(budget: float) -> None:
    grid, checked = sampled(40), sampled(67)
    best, tried = fewest(grid, checked, (40,), 12, budget)
    assert best is not None
    assert best.error <= budget
    assert best.error == pytest.approx(checked.errors(best.dense.reshape(2, 3, -1)).max())
    assert best.lengths.ravel().tolist() == np.count_nonzero(np.any(best.dense[..., 0] != 0, axis=1), axis=1).tolist()
    # None of fewer terms, fitted as well as can be, would do.
    fewer = [k.error for k in tried if k.lengths.sum() < best.lengths.sum()]
    assert min(fewer, default=np.inf) > budget


def test_fewest_says_so_when_all_terms_are_too_few() -> None:
    assert fewest(sampled(40), sampled(67), (40,), 12, 1e-9)[0] is None


@pytest.mark.parametrize("how", [OF_ROUNDED, OF_FITTED])
def test_sharpening_lowers_the_largest_error(how: Sharpening) -> None:
    grid = sampled(60)
    importance = even(grid)
    errors = []
    for _ in range(12):
        found = metric(grid, importance).best_of(np.tile(np.arange(12) < 6, (2, 1)))
        made = grid.errors(found)
        errors.append(float(made.max()))
        importance = sharpen(importance, made, (60,), how)
    assert min(errors) < 0.8 * errors[0]
