"""Changes of axes: the same environment in other axes, by rotations and reflections."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from skylight_sh import sphere
from test_sphere import directions

Array = NDArray[np.float64]
SPECIAL = {
    "identity": np.eye(3),
    "y up, right-handed": np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]]),
    "y up, left-handed": np.array([[1.0, 0, 0], [0, 0, 1], [0, 1, 0]]),
    "mirror": np.diag([1.0, -1, 1]),
    "upside down": np.diag([-1.0, 1, -1]),
    "point": -np.eye(3),
    "almost the identity": np.array([[1, 1e-9, 1e-12], [-1e-9, 1, 1e-13], [-1e-12, -1e-13, 1]]),
}


def orthogonal(seed: int, determinant: float) -> Array:
    found = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]
    return np.asarray(found * np.sign(np.linalg.det(found)) * determinant)


def holds(matrix: Array, bands: int) -> float:
    weights = np.random.default_rng(bands).normal(size=(2, bands * bands))
    where = directions(40)
    there = sphere.evaluate(sphere.change_axes(weights, matrix), where @ matrix.T)
    return float(np.abs(there - sphere.evaluate(weights, where)).max())


@given(seed=st.integers(0, 1000), determinant=st.sampled_from([1.0, -1.0]), bands=st.integers(1, 12))
def test_the_environment_stays_where_it_is(seed: int, determinant: float, bands: int) -> None:
    assert holds(orthogonal(seed, determinant), bands) < 1e-12


@pytest.mark.parametrize("name", SPECIAL)
def test_special_axes(name: str) -> None:
    assert holds(SPECIAL[name], 11) < 1e-12
    assert holds(SPECIAL[name], 64) < 2e-12


@given(seed=st.integers(0, 1000), determinant=st.sampled_from([1.0, -1.0]))
def test_it_is_orthogonal_and_keeps_degrees_apart(seed: int, determinant: float) -> None:
    whole = sphere.change_axes(np.eye(121), orthogonal(seed, determinant))
    assert np.abs(whole @ whole.T - np.eye(121)).max() < 1e-12
    degrees = sphere.Harmonics(11).degrees
    assert not whole[degrees[:, np.newaxis] != degrees].any()


@given(seed=st.integers(0, 1000), first=st.sampled_from([1.0, -1.0]), second=st.sampled_from([1.0, -1.0]))
def test_changes_compose(seed: int, first: float, second: float) -> None:
    one, two = orthogonal(seed, first), orthogonal(seed + 1, second)
    weights = np.random.default_rng(seed).normal(size=121)
    steps = sphere.change_axes(sphere.change_axes(weights, one), two)
    assert np.abs(steps - sphere.change_axes(weights, two @ one)).max() < 1e-12


def test_y_up_mixes_the_second_degree_as_the_polynomials_say() -> None:
    """3zz - 1 of ours is 3yy - 1 there: half of minus 3zz - 1, and the rest of xx - yy."""
    zonal = np.eye(9)[6]
    for name in ("y up, right-handed", "y up, left-handed"):
        found = sphere.change_axes(zonal, SPECIAL[name])
        assert found == pytest.approx([0, 0, 0, 0, 0, 0, -0.5, 0, -np.sqrt(3) / 2], abs=1e-15)


@pytest.mark.parametrize("matrix", [2 * np.eye(3), np.eye(2), np.full((3, 3), np.nan)])
def test_axes_that_are_not_orthogonal_are_refused(matrix: Array) -> None:
    with pytest.raises(ValueError, match="orthogonal 3x3"):
        sphere.change_axes(np.ones(9), matrix)


def test_weights_that_fill_no_bands_are_refused() -> None:
    with pytest.raises(ValueError, match="5 weights"):
        sphere.change_axes(np.ones(5), np.eye(3))
