"""The paper's measures (Habel, Mustata and Wimmer 2008, eqs. 2 and 3) on expansions whose errors are known by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest
from skylight_sh.fit import errors, least_squares
from skylight_sh.fit.axis import Axis
from skylight_sh.fit.sampled import Sampled
from skylight_sh.table.errors import headline, least_reconstructed, measure
from skylight_sh.table.table import specification, whole

from golden.oracles import hemisphere

DEGREES = np.array([0, 1, 1, 1])


def test_e_mean_is_a_root_of_squares_and_e_max_a_sum() -> None:
    """3, 4 and 12: their root of squares is 13, their sum 19; over an L_min of 2 and 5."""
    residual = np.array([[[3.0, -4.0, 12.0, 0.0]], [[0.0, 0.0, -7.0, 0.0]]])
    assert errors.e_mean(residual, np.array([2.0, 5.0])) == pytest.approx(6.5, rel=1e-15)
    assert errors.e_mean(residual, np.array([13.0, 0.5])) == pytest.approx(14.0, rel=1e-15)
    absolute, root = errors.by_band(residual, DEGREES, 2)
    assert absolute[:, 0].tolist() == [[3.0, 19.0], [0.0, 7.0]]
    assert root[:, 0] == pytest.approx(np.array([[3.0, 13.0], [0.0, 7.0]]), rel=1e-15)
    plain = np.ones((2, 1, 1)), residual, np.ones(2), np.zeros(4, dtype=np.int64)
    sampled = Sampled(np.ones((2, 1)), *plain)
    assert sampled.errors(np.zeros((1, 4, 1))) == pytest.approx(np.array([[13.0], [7.0]]), rel=1e-15)


def test_mean_luminance_over_the_upper_hemisphere() -> None:
    """y_00 is 1 / sqrt(4 pi) and the hemisphere 2 pi sr."""
    where, solid = hemisphere(30)
    sky = 2 + where[:, 0] + where[:, 2] ** 2
    first = np.array([[float(sky @ solid) / math.sqrt(4 * math.pi), 0.0]])
    assert errors.mean_luminance(first, np.array([1.0, 9.0])) == pytest.approx([2 + 1 / 3], rel=1e-12)


def test_conventions_of_l_min() -> None:
    least, mean = np.array([2.0, 0.5, 4.0]), np.array([5.0, 6.0, 7.0])
    reference = errors.Reference(np.zeros((3, 1)), np.zeros((3, 1, 4)), DEGREES, least, mean)
    assert {name: v.tolist() for name, v in reference.l_min.items()} == {"per-set": [2.0, 0.5, 4.0], "global": [0.5] * 3}
    assert reference.headline.tolist() == [2.0, 0.5, 4.0]
    assert reference.first_bands(1).tolist() == [0]
    # A least radiance of exactly 0 is not positive.
    black = errors.Reference(np.zeros((3, 1)), np.zeros((3, 1, 4)), DEGREES, np.array([2.0, 0.0, 4.0]), mean)
    assert {name: v.tolist() for name, v in black.l_min.items()} == {"mean": [5.0, 6.0, 7.0]}


def test_a_constant_tables_figures() -> None:
    """A table that says 1, 0, 0.6, 0.8 everywhere, against zeros and against itself plus 3, 4 in two weights."""
    dense = np.array([1.0, 0.0, 0.6, 0.8]).reshape(1, 4, 1)
    frame = specification((Axis("sun_zenith", 0.0, 1.0),), ("luminance",), False, "chebyshev", None)
    table = whole(frame, dense, 2, "float64")
    parameters = np.array([[0.2], [0.9]])
    truth = np.array([[[0.0, 0.0, 0.0, 0.0]], [[4.0, 0.0, 4.6, 0.8]]])
    reference = errors.Reference(parameters, truth, DEGREES, np.array([0.5, 2.0]), np.ones(2))
    found = measure(table, reference)
    assert found.conventions == ("per-set", "global")
    # Set 0: residual 1, 0, .6, .8; root sqrt 2, sum 2.4, over .5. Set 1: 3 and 4; root 5, sum 7, over 2 (or .5).
    assert found.e_mean[:, 0] == pytest.approx(np.array([[2.0, math.sqrt(2) / 0.5], [6.0, 10.0]]), rel=1e-12)
    assert found.e_max[:, 0] == pytest.approx(np.array([[2.0, 4.8], [6.0, 14.0]]), rel=1e-12)
    assert found.at[0, 0].tolist() == [0, 0]
    assert found.at[1, 0].tolist() == [1, 1]
    assert found.per_set == pytest.approx([math.sqrt(2) / 0.5, 2.5], rel=1e-12)
    assert found.rel_l2[0, 1] > 1e300 or found.rel_l2[0, 1] == pytest.approx(math.sqrt(2) / np.finfo(float).tiny)
    assert headline(table, reference) == pytest.approx(math.sqrt(2) / 0.5, rel=1e-12)
    # 0.2821 +- 0.4886 |(.8, 0, .6)|: the least over the largest value.
    c0, c1 = math.sqrt(0.25 / math.pi), math.sqrt(0.75 / math.pi)
    got = least_reconstructed(table, parameters, np.ones(1))
    assert got == pytest.approx((c0 - c1) / (c0 + c1), abs=2e-3)


def test_condition_is_a_product_of_singular_values() -> None:
    one, other = np.diag([3.0, 1.0]), np.diag([5.0, 2.0])
    assert least_squares.condition([one, other]) == pytest.approx(7.5, rel=1e-14)
