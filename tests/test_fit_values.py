"""Fits against closed forms: nodes, changes of variable, error measures, importance, and what scaling may not change."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from sampled import plain
from skylight_sh.fit import errors, quantisation, sweep, variable_search
from skylight_sh.fit.axis import Axis
from skylight_sh.fit.minimax import OF_FITTED, OF_ROUNDED, even, metric, sharpen
from skylight_sh.fit.nearest_plane import round_kept
from skylight_sh.fit.sampled import Sampled
from skylight_sh.fit.term_selection import fewest
from skylight_sh.formula.variables import VARIABLES
from skylight_sh.reproducible import significant

Array = NDArray[np.float64]

POINTS = {"identity": 0.0, "log": 0.7, "reciprocal": 5.5, "cbrt": 4.25, "raw": 0.0, "even": -3.0}
VALUES = np.array([1.25, 1.5, 2.0, 3.0, 4.0])
SCALED = {
    "identity": (VALUES - 1.25) / 2.75 * 2 - 1,
    "log": np.log((VALUES - 0.7) / 0.55) / np.log(3.3 / 0.55) * 2 - 1,
    "reciprocal": (1 / (5.5 - VALUES) - 1 / 4.25) / (1 / 1.5 - 1 / 4.25) * 2 - 1,
    "cbrt": (np.cbrt(3.0) - np.cbrt(4.25 - VALUES)) / (np.cbrt(3.0) - np.cbrt(0.25)) * 2 - 1,
    "raw": VALUES,
    "even": (1 / (3.0 + VALUES**2) - 1 / 4.5625) / (1 / 19.0 - 1 / 4.5625) * 2 - 1,
}


@pytest.mark.parametrize("name", VARIABLES)
def test_maps_are_their_formulas_both_ways(name: str) -> None:
    axis = Axis("haze", 1.25, 4.0, map=name, point=POINTS[name])
    assert axis.scaled(VALUES) == pytest.approx(SCALED[name], abs=1e-14)
    assert axis.unscaled(SCALED[name]) == pytest.approx(VALUES, abs=1e-14)


def test_a_value_that_never_changes_stands_in_the_middle_of_nothing() -> None:
    axis = Axis("haze", 2.0, 2.0)
    assert axis.scaled(np.array([2.0])).tolist() == [-1.0]
    assert axis.fit_nodes(3, "chebyshev").tolist() == [2.0] * 3
    assert axis.verification_nodes(5, np.array([2.0])).tolist() == [2.0]


def test_nodes_are_chebyshevs() -> None:
    axis = Axis("haze", 1.0, 5.0)
    roots = np.sort(3.0 + 2.0 * np.cos(np.pi * (2 * np.arange(1, 8) - 1) / 14))
    for kind in ("identity", "raw"):
        assert Axis("haze", 1.0, 5.0, map=kind).fit_nodes(7, "chebyshev") == pytest.approx(roots, abs=1e-14)
    assert axis.fit_nodes(5, "uniform").tolist() == [1.0, 2.0, 3.0, 4.0, 5.0]
    # Of a map the nodes lie where its variable is a root.
    log = Axis("haze", 1.0, 5.0, map="log", point=0.0)
    assert log.fit_nodes(7, "chebyshev") == pytest.approx(np.sqrt(5.0) ** (1 + (roots - 3.0) / 2.0), rel=1e-14)

    extrema = 3.0 - 2.0 * np.cos(np.pi * np.arange(5) / 4)
    free = axis.verification_nodes(5, np.array([0.0]))
    assert free == pytest.approx(extrema, abs=1e-14)
    assert (free[0], free[-1]) == (1.0, 5.0)
    assert axis.verification_nodes(1, np.array([0.0])).tolist() == [1.0]
    assert axis.verification_nodes(2, np.array([0.0])).tolist() == [1.0, 5.0]
    # One that a fit shares, or nearly, moves by a quarter of the way to the next; the ends stay.
    spacing = extrema[1] - extrema[0]
    for near, moves in ((0.0, True), (0.9e-3 * spacing, True), (-0.9e-3 * spacing, True), (1.1e-3 * spacing, False)):
        moved = axis.verification_nodes(5, np.array([1.0, 3.0 + near, 5.0]))
        expected = extrema.copy()
        expected[2] += 0.25 * (extrema[3] - extrema[2]) if moves else 0.0
        assert moved == pytest.approx(expected, abs=1e-14)


def test_errors_are_those_of_the_papers_equations() -> None:
    degrees = np.array([0, 1, 1, 2, 2, 2])
    reference = errors.Reference(np.zeros((2, 1)), np.zeros((2, 1, 6)), degrees, np.array([2.0, 0.5]), np.array([3.0, 4.0]))
    assert [reference.first_bands(n).tolist() for n in (1, 2, 3, 4)] == [[0], [0, 1, 2], [*range(6)], [*range(6)]]
    assert reference.l_min["global"].tolist() == [0.5, 0.5]
    assert reference.headline.tolist() == [2.0, 0.5]
    zero = errors.Reference(np.zeros((2, 1)), np.zeros((2, 1, 6)), degrees, np.array([2.0, 0.0]), np.array([3.0, 4.0]))
    assert zero.headline.tolist() == [3.0, 4.0]
    residual = np.array([[[1.0, -2.0, 2.0, 4.0, -4.0, 1.0]], [[0.5, 0.0, 0.0, 0.0, 0.0, -1.0]]])
    absolute, root = errors.by_band(residual, degrees, 3)
    assert absolute.tolist() == [[[1.0, 5.0, 14.0]], [[0.5, 0.5, 1.5]]]
    assert root == pytest.approx(np.sqrt([[[1.0, 9.0, 42.0]], [[0.25, 0.25, 1.25]]]))
    assert errors.e_mean(residual, reference.headline) == pytest.approx(np.sqrt(42.0) / 2.0)
    assert errors.e_mean(residual[1:], reference.headline[1:]) == pytest.approx(np.sqrt(1.25) / 0.5)


@pytest.mark.parametrize("worst", [0, 255, 256, 299])
def test_a_sweep_sees_every_set(worst: int) -> None:
    """A constant 1 fits all sets but one, whichever of the blocks it is in."""
    weights = np.ones((300, 1, 1))
    weights[worst] = 3.0
    one = np.ones(300)
    reference = errors.Reference(np.zeros((300, 1)), weights, np.zeros(1, dtype=np.int64), 0.5 * one, one)
    factor, waves = one.reshape(-1, 1, 1), one.reshape(-1, 1)
    found = sweep.sweep(np.array([[[1.0, 0.0]]]), [np.ones((300, 2))], factor, waves, reference, [range(2)], 1)
    assert found.degrees == [(0,), (1,)]
    for row in range(2):
        assert found.at["per-set"][row].tolist() == [[worst]]
        assert found.e_mean["per-set"][row].tolist() == found.e_max["global"][row].tolist() == [[4.0]]
        assert found.rel_l2[row].tolist() == [[pytest.approx(2.0 / 3.0)]]


def test_importance_moves_in_proportion_to_the_errors() -> None:
    """Lawson's rule, where all sets of a channel err alike, and averages of four binomial steps where they do not."""
    importance = np.array([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]]) / 21.0
    moved = sharpen(importance, np.tile([0.3, 0.6], (3, 1)), (3,), OF_ROUNDED)
    expected = importance * [1.0, 2.0]
    # Rounded to four bits, at most a sixteenth off.
    assert moved == pytest.approx(significant(expected / expected.sum(), 4), rel=1e-14)
    assert np.all(np.abs(moved / (expected / expected.sum()) - 1.0) <= 2.0**-4)

    spike = np.zeros((31, 1))
    spike[15] = 0.7
    flat = np.full((31, 1), 1.0 / 31.0)
    made = sharpen(flat, spike, (31,), OF_ROUNDED)[:, 0]
    binomial = np.array([1, 8, 28, 56, 70, 56, 28, 8, 1])
    shares = np.sqrt(binomial) / np.sqrt(binomial).sum()
    assert made[11:20] == pytest.approx(significant(shares, 4), rel=1e-12)
    assert not made[:11].any()
    assert not made[20:].any()
    assert made.sum() == pytest.approx(1.0, rel=2.0**-4)
    # Of a fit's errors: with their squares, averaged once.
    fitted = sharpen(flat, spike, (31,), OF_FITTED)[:, 0]
    assert fitted[14:17] == pytest.approx([0.25, 0.5, 0.25], rel=1e-12)
    assert np.count_nonzero(fitted) == 3
    assert sharpen(importance, np.tile([0.3, 0.6], (3, 1)), (3,), OF_FITTED) == pytest.approx(
        significant(importance * [1.0, 4.0] / (importance * [1.0, 4.0]).sum(), 6), rel=1e-14
    )


def grid(count: int) -> Sampled:
    """Two smooth weights of one channel over two variables: four terms of the first, three of the second."""
    u = -np.cos(np.pi * (np.arange(count) + 0.5) / count)
    a, b = (x.ravel() for x in np.meshgrid(u, u, indexing="ij"))
    first, second = np.polynomial.chebyshev.chebvander(a, 3), np.polynomial.chebyshev.chebvander(b, 2)
    basis = (first[:, :, np.newaxis] * second[:, np.newaxis, :]).reshape(a.size, -1)
    truth = np.stack([1.0 / (1.6 - a - 0.3 * b), np.exp(0.7 * a - 0.4 * b)], axis=-1)
    return plain(basis, truth[:, np.newaxis])


@pytest.mark.parametrize("budget", [0.8, 0.5, 0.4])
def test_fewest_terms_are_those_of_trying_every_staircase(budget: float) -> None:
    fitted, checked = grid(9), grid(14)
    normal = metric(fitted, even(fitted))
    needed = 12
    for lengths in itertools.product(range(5), repeat=3):
        kept = (np.arange(4)[:, np.newaxis] < np.array(lengths)).reshape(1, -1)
        if 0 < kept.sum() < needed and checked.errors(normal.best_of(kept)).max() <= budget:
            needed = int(kept.sum())
    assert needed < 12
    best, _ = fewest(fitted, checked, (9, 9), 4, budget)
    assert best is not None
    assert best.lengths.sum() <= needed
    # A budget that is met to the last bit is met.
    again, _ = fewest(fitted, checked, (9, 9), 4, best.error)
    assert again is not None
    assert again.error <= best.error
    assert again.lengths.sum() <= best.lengths.sum()


def test_a_denominator_does_not_depend_on_the_unit_of_the_weights() -> None:
    x = np.linspace(-1.0, 1.0, 25)
    low, high = np.polynomial.chebyshev.chebvander(x, 2), np.polynomial.chebyshev.chebvander(x, 4)
    least = 1.0 / (1.5 - x)
    samples = np.stack([least * (1 + x), least * np.exp(x), np.cos(2 * x)], axis=-1)
    found = variable_search._denominator(low, high, samples, least, 1e-3)
    assert found is not None
    for unit in (1e-4, 1e5):
        other = variable_search._denominator(low, high, unit * samples, least, 1e-3)
        assert other == pytest.approx(found, rel=1e-6, abs=1e-8)
    # What is a polynomial over 1.5 - x needs no other denominator.
    exact = variable_search._denominator(low, high, samples[:, :1], least, 1e-6)
    assert exact is not None
    q = low @ exact
    assert q / (1.5 - x) == pytest.approx(np.full(25, q[0] / 2.5), rel=1e-3)
    assert q.mean() == pytest.approx(1.0)


def test_whole_numbers_stay_within_what_a_reader_holds(monkeypatch: pytest.MonkeyPatch) -> None:
    """A budget far below 2**-30 of the largest coefficient: the step stays where numbers of 30 bits can follow."""
    sampled = grid(9)
    seen: list[int] = []

    def recorded(*arguments: Any) -> NDArray[np.int64]:
        numbers = round_kept(*arguments)
        seen.append(int(np.abs(numbers).max()))
        return numbers

    monkeypatch.setattr(quantisation, "round_kept", recorded)
    best, _ = quantisation.smallest(sampled, sampled, (9, 9), 4, 1e-15, lambda numbers: numbers.size)
    assert best is None
    # What a Rice code's reader holds once folded (the packed format), and nearly all of it.
    assert 2**29 < max(seen) <= 2**30 - 1


def test_classes_that_share_channels_are_fitted_together_with_their_orders_powers() -> None:
    """Two channels made of two classes' polynomials, times sin^m: the fit finds the polynomials themselves."""
    rng = np.random.default_rng(3)
    theta = np.linspace(0.0, 1.5, 30)
    basis = np.polynomial.chebyshev.chebvander(2.0 * (theta / 1.5) ** 2 - 1.0, 3)
    factor = rng.uniform(0.5, 2.0, (30, 2, 2))
    orders = np.array([0, 0, 1, 0, 1, 2])
    known = rng.normal(size=(2, 6, 4))
    sums = np.einsum("nt,kwt->nkw", basis, known) * np.sin(theta)[:, np.newaxis, np.newaxis] ** orders
    truth = np.einsum("nck,nkw->ncw", factor, sums)
    sampled = Sampled(basis, factor, truth, np.sin(theta), orders)
    assert sampled.groups == [(0, 1)]
    found = metric(sampled, even(sampled)).best
    assert found == pytest.approx(known, abs=1e-6)
    assert sampled.errors(known) == pytest.approx(np.zeros((30, 2)), abs=1e-12)
    # One number off by a half: the error of a set is the root of its squares over the channels' weights.
    off = known.copy()
    off[1, 5, 2] += 0.5
    expected = np.abs(0.5 * factor[:, :, 1] * (basis[:, 2] * np.sin(theta) ** 2)[:, np.newaxis])
    assert sampled.errors(off) == pytest.approx(expected, abs=1e-12)


def gridded(shared: bool) -> Sampled:
    """A grid of 6 by 5 sets and 7 more, two channels of two classes, weights of orders 0 to 2."""
    rng = np.random.default_rng(8)
    along = (rng.normal(size=(6, 3)), rng.normal(size=(5, 2)))
    basis = np.concatenate([np.kron(*along), rng.normal(size=(7, 6))])
    factor = rng.uniform(0.5, 2.0, (37, 2, 2)) * (np.ones((2, 2)) if shared else np.eye(2))
    truth, sines = rng.normal(size=(37, 2, 4)), rng.uniform(0.1, 1.0, 37)
    return Sampled(basis, factor, truth, sines, np.array([0, 1, 1, 2]), (6, 5), along)


def residuals(sampled: Sampled, coefficients: Array) -> Array:
    """Errors of every set, channel and weight, ``(n, channels, count)``, by the definition."""
    sums = np.einsum("nt,kwt->nkw", sampled.basis, coefficients) * sampled.sines[:, np.newaxis, np.newaxis] ** sampled.orders
    return np.einsum("nck,nkw->ncw", sampled.factor, sums) - sampled.truth


@pytest.mark.parametrize("shared", [True, False])
def test_errors_on_a_grid_and_beside_it_are_those_of_the_definition(shared: bool) -> None:
    sampled, coefficients = gridded(shared), np.random.default_rng(9).normal(size=(2, 4, 6))
    expected = np.linalg.norm(residuals(sampled, coefficients), axis=2)
    assert sampled.errors(coefficients) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("shared", [True, False])
def test_sums_axis_by_axis_give_the_least_squares_of_the_whole_system(shared: bool) -> None:
    """Coefficients by NumPy's lstsq on one row a set, channel and weight; without a term the sum grows as is said."""
    whole = gridded(shared)
    part = (whole.basis[:30], whole.factor[:30], whole.truth[:30], whole.sines[:30])
    sampled = Sampled(*part, whole.orders, whole.shape, whole.along)
    importance = np.random.default_rng(10).uniform(0.5, 1.5, (30, 2)) / 60.0
    kept = np.array([[True, True, False, True, True, True], [True, False, True, True, False, True]])

    def least(of: NDArray[np.bool_]) -> tuple[Array, float]:
        found, left = np.zeros((2, 4, 6)), 0.0
        for w, order in enumerate(whole.orders):
            waves = sampled.sines[:, np.newaxis] ** order * sampled.basis
            rows = np.einsum("nck,nt->nckt", sampled.factor, waves).reshape(60, 12)[:, of.ravel()]
            root = np.sqrt(importance.ravel())
            right = root * sampled.truth[:, :, w].ravel()
            own, _, _, _ = np.linalg.lstsq(root[:, np.newaxis] * rows, right, rcond=None)
            found[:, w][of] = own
            left += float(np.square(right - root * (rows @ own)).sum())
        return found, left

    expected, before = least(kept)
    for normal in (metric(sampled, importance), metric(sampled, importance, kept)):
        assert normal.best_of(kept) == pytest.approx(expected, abs=1e-8)
        grown = []
        for place in zip(*np.nonzero(kept), strict=True):
            fewer = kept.copy()
            fewer[place] = False
            grown.append(least(fewer)[1] - before)
        assert normal.growths(kept, kept) == pytest.approx(np.array(grown), rel=1e-8)


def test_rounding_of_some_weights_leaves_no_trace_in_others() -> None:
    """Weights are rounded side by side, each as if it were alone."""
    sampled = grid(9)
    normal = metric(sampled, even(sampled))
    lengths = np.array([[[4, 3, 1], [2, 4, 2]]])
    both = round_kept(normal, lengths, 4, 1e-3)
    for weight in range(2):
        alone = lengths.copy()
        alone[0, 1 - weight] = 0
        assert round_kept(normal, alone, 4, 1e-3)[0, weight].tolist() == both[0, weight].tolist()
        assert not round_kept(normal, alone, 4, 1e-3)[0, 1 - weight].any()
