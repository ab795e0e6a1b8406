"""Compressed transfer: what it loses, held against the transfer itself, a plain decomposition and closed forms."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import skylight_sh
from conftest import ROOT, with_spec
from numpy.typing import NDArray
from skylight_sh import UserError, runtime, sphere
from skylight_sh.light import sun_disc
from skylight_sh.mesh import Mesh, Part
from skylight_sh.mesh.shapes import assembled, box
from skylight_sh.transfer import Options, compression, precompute, unshadowed
from skylight_sh.transfer.compression import COMPONENTS, STEPS, Compressed
from skylight_sh.transfer.random_suns import random_suns

Array = NDArray[np.float64]
TABLE = ROOT / "reports" / "reference" / "export" / "skylight_sh.npz"


def yard() -> Mesh:
    """A floor, a red wall, and a box before it."""
    return assembled(
        [
            (Part("floor"), (0.5, 0.5, 0.5), box((-3.5, -3.3, -0.2), (3.0, 3.3, 0.0), 0.4)),
            (Part("wall"), (0.7, 0.2, 0.1), box((-3.4, -3.0, 0.001), (-3.0, 3.0, 2.5), 0.4)),
            (Part("box"), (0.1, 0.3, 0.6), box((-1.0, -0.5, 0.001), (0.0, 0.5, 1.2), 0.25)),
        ]
    )


@cache
def lit_yard() -> tuple[Mesh, Array, Array]:
    """The mesh, its transfer without bounces ``(v, N*N)`` and with them ``(v, 3, N*N)``, for three bands."""
    mesh = yard()
    found = precompute(mesh, Options(bands=3, rays=256, gather_rays=64, bounces=2))
    return mesh, found.direct, found.transfer


@cache
def compressed() -> Compressed:
    _, direct, transfer = lit_yard()
    return compression.compress(direct, transfer, *suns(500, 0))


def suns(count: int, seed: int, bands: int = 3) -> tuple[Array, Array]:
    return random_suns(skylight_sh.load(TABLE), bands, count, seed)


def exact(direct: Array, transfer: Array, sky: Array, sun: Array) -> Array:
    """Irradiance / pi ``(v, 3)`` by the definition of transfer: all of the sky, and of the sun what bounces."""
    return np.stack([transfer[:, c] @ sky[c] + (transfer[:, c] - direct) @ sun[c] for c in range(3)], axis=-1)


def relative(got: Array, expected: Array) -> float:
    return float(np.sqrt(np.square(got - expected).sum() / np.square(expected).sum()))


def test_the_error_is_that_of_vertices_lit_one_by_one() -> None:
    _, direct, transfer = lit_yard()
    sky, sun = suns(60, 1)
    stated = compression.errors(compressed(), direct, transfer, sky, sun)
    for i in (0, 17, 59):
        for row, disc in ((0, np.zeros_like(sun[i])), (1, sun[i])):
            got = compression.lit(compressed(), sky[i], disc)
            assert stated[row, i] == pytest.approx(relative(got, exact(direct, transfer, sky[i], disc)), rel=1e-6)


def test_unseen_suns_lose_little() -> None:
    _, direct, transfer = lit_yard()
    sky, both = compression.errors(compressed(), direct, transfer, *suns(60, 1))
    assert sky.max() < 0.02
    assert np.median(sky) < 0.011
    assert both.max() < 0.025


def test_lit_space_serves_suns_better_than_plain_components() -> None:
    """Those of the transfer itself, unrounded, by NumPy's decomposition: at 8 components, where much is lost."""
    _, direct, transfer = lit_yard()
    lights = suns(60, 1)
    ours = compression.errors(compression.compress(direct, transfer, *suns(500, 0), count=8), direct, transfer, *lights)
    values = compression.columns(direct, transfer)
    mean = values.mean(axis=0)
    _, _, rows = np.linalg.svd(values - mean, full_matrices=False)
    plain = mean + (values - mean) @ rows[:8].T @ rows[:8]
    weights = direct.shape[1]
    bounce = plain[:, weights:].reshape(-1, 3, weights)
    theirs = [
        relative(
            exact(plain[:, :weights], plain[:, np.newaxis, :weights] + bounce, sky, sun), exact(direct, transfer, sky, sun)
        )
        for sky, sun in zip(*lights, strict=True)
    ]
    assert ours[1].max() < 0.8 * max(theirs)
    assert np.median(ours[1]) < np.median(theirs)


def test_what_needs_no_more_components_is_kept() -> None:
    """Unshadowed transfer of three bands depends on the normal alone, in nine numbers: rounding is all that is lost."""
    normals = sphere.spiral(400)
    direct = unshadowed(normals, 3)
    transfer = np.repeat(direct[:, np.newaxis], 3, axis=1)
    made = compression.compress(direct, transfer, *suns(300, 0))
    # Nine less the mean; the last four hold quarters of steps of the first.
    assert made.components[:, :8].any(axis=0).all()
    assert not made.components[:, 8:-4].any()
    assert np.abs(made.components[:, -4:]).max() <= 2
    assert compression.errors(made, direct, transfer, *suns(60, 1)).max() < 0.005


def test_one_vertex_and_darkness() -> None:
    direct = unshadowed(np.array([[0.0, 0.0, 1.0]]), 2)
    transfer = np.repeat(direct[:, np.newaxis], 3, axis=1)
    made = compression.compress(direct, transfer, *suns(5, 0, 2))
    assert not made.components.any()
    assert compression.errors(made, direct, transfer, *suns(5, 1, 2)) == pytest.approx(0.0, abs=1e-5)
    dark = compression.compress(0.0 * direct, 0.0 * transfer, *suns(5, 0, 2))
    assert not compression.errors(dark, 0.0 * direct, 0.0 * transfer, *suns(5, 1, 2)).any()


def test_components_fill_a_byte_and_the_matrix_is_the_least_squares_one() -> None:
    _, direct, transfer = lit_yard()
    made = compressed()
    assert made.components.shape == (len(direct), COMPONENTS)
    assert made.components.dtype == np.int8
    assert np.abs(made.components.astype(int)).max() <= STEPS
    assert (np.abs(made.components.astype(int)).max(axis=0) > 0.45 * STEPS).all()
    assert made.matrix.shape == (1 + COMPONENTS, 4 * 9)
    assert made.bands == 3
    values = compression.columns(direct, transfer)
    whole = np.concatenate([np.ones((len(values), 1)), made.components / STEPS], axis=1)
    best = np.linalg.lstsq(whole, values, rcond=None)[0]
    assert np.square(whole @ made.matrix - values).sum() == pytest.approx(np.square(whole @ best - values).sum(), rel=1e-3)


def test_noise_of_the_last_bits_changes_no_byte() -> None:
    """As another machine's library makes it of the lights."""
    _, direct, transfer = lit_yard()
    lights = suns(500, 0)
    for seed in range(2):
        random = np.random.default_rng(seed)
        shaken = [part * (1.0 + 1e-15 * random.standard_normal(part.shape)) for part in lights]
        again = compression.compress(direct, transfer, *shaken)
        assert np.array_equal(again.components, compressed().components)
        assert np.array_equal(again.matrix, compressed().matrix)


def test_uniforms_are_linear_in_the_light() -> None:
    sky, sun = suns(2, 3)
    matrix = compressed().matrix
    both = compression.uniforms(matrix, sky, sun)
    assert both.shape == (2, 1 + COMPONENTS, 3)
    apart = compression.uniforms(matrix, sky, 0.0 * sun) + compression.uniforms(matrix, 0.0 * sky, sun)
    assert both == pytest.approx(apart, rel=1e-9, abs=1e-9)


def test_random_suns_are_the_tables_skies_with_their_discs() -> None:
    table = skylight_sh.load(TABLE)
    sky, sun = random_suns(table, 4, 40, 9)
    random = np.random.default_rng(9)
    zenith, haze, azimuth = (random.uniform(*ends, 40) for ends in ((0.0, np.pi / 2), (2.5, 6.0), (0.0, 2.0 * np.pi)))
    assert np.array_equal(sky, table.weights(zenith, azimuth, haze, bands=4))
    assert np.array_equal(sun, sun_disc.weights(zenith, azimuth, haze, 4))
    with_disc = runtime.Runtime(with_spec(table.table, sun_disc=True))
    assert not random_suns(with_disc, 4, 40, 9)[1].any()
    assert not random_suns(runtime.Runtime(with_spec(table.table, peak_axis=None, parity=False)), 4, 40, 9)[1].any()


def test_tables_that_light_no_transfer_are_refused() -> None:
    table = skylight_sh.load(TABLE)
    with pytest.raises(UserError, match="7 bands, the transfer 8"):
        random_suns(table, 8, 1, 0)
    with pytest.raises(UserError, match="of radiance"):
        random_suns(runtime.Runtime(with_spec(table.table, quantity="irradiance")), 3, 1, 0)


def test_bad_numbers_are_refused() -> None:
    _, direct, transfer = lit_yard()
    sky, sun = suns(3, 0)
    with pytest.raises(ValueError, match="Invalid sky of shape"):
        compression.compress(direct, transfer, sky[:, :2], sun)
    with pytest.raises(ValueError, match="transfer: it holds a number that is not finite"):
        compression.compress(direct, np.where(transfer == transfer.max(), np.nan, transfer), sky, sun)
    with pytest.raises(ValueError, match="0 lights"):
        compression.compress(direct, transfer, sky[:0], sun[:0])
