"""Light by paths against closed forms: a bowl, a sun on the ground, a sky; points and colours of a mesh that rays meet."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh.light import sun_disc
from skylight_sh.light.preetham import Preetham
from skylight_sh.mesh import Mesh, Part
from skylight_sh.mesh.texels import averaged
from skylight_sh.quadrature import sampling
from skylight_sh.render import sensitivity
from skylight_sh.render.brute_force import Paths, Source, by_bounces, unshadowed
from skylight_sh.render.emitters import Disc
from skylight_sh.render.sunlight import even, straight
from skylight_sh.render.surface import Points, Surface
from skylight_sh.sphere import Harmonics

Array = NDArray[np.float64]
EVEN = Source(lambda along: np.where(along[:, 2:] > 0.0, np.ones(3), 0.0))


def mesh(positions: Array, triangles: NDArray[np.int64], normals: Array, albedo: float, uv: Array | None = None) -> Mesh:
    """A mesh of one part and colour."""
    places = np.zeros((len(positions), 2)) if uv is None else uv
    parts = (Part("all"),)
    part = np.zeros(len(triangles), dtype=np.int64)
    return Mesh(positions, normals, np.full(positions.shape, albedo), triangles, part, parts, places)


def bowl(albedo: float, rows: int = 60, columns: int = 120) -> Mesh:
    """The lower half of a unit sphere, seen from inside."""
    polar = np.pi / 2 + np.pi / 2 * np.arange(rows + 1)[:, np.newaxis] / rows
    azimuth = 2 * np.pi * np.arange(columns) / columns
    flat = np.sin(polar)
    grid = np.stack(np.broadcast_arrays(flat * np.cos(azimuth), flat * np.sin(azimuth), np.cos(polar)), axis=-1)
    index = np.arange((rows + 1) * columns).reshape(rows + 1, columns)
    a, b = index[:-1], np.roll(index, -1, axis=1)[:-1]
    c, d = index[1:], np.roll(index, -1, axis=1)[1:]
    triangles = np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([b, d, c], -1)[:-1].reshape(-1, 3)])
    points = grid.reshape(-1, 3)
    return mesh(points, triangles, -points, albedo)


def floor(half: float, height: float = 0.0, albedo: float = 0.5) -> Mesh:
    corners = np.array([[-half, -half, height], [half, -half, height], [half, half, height], [-half, half, height]])
    up = np.tile([0.0, 0.0, 1.0], (4, 1))
    uv = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    return mesh(corners, np.array([[0, 1, 2], [0, 2, 3]]), up, albedo, uv)


def looked_at(surface: Surface, eyes: Array, along: Array) -> Points:
    return surface.met(surface.rays.nearest(eyes, along), along)[0]


def test_every_bounce_in_a_bowl_below_an_even_sky() -> None:
    """Direct light is 1/2 at every point of it, and each bounce half the albedo of the last."""
    surface = Surface(bowl(0.8))
    assert np.all(np.einsum("tk,tk->t", surface.facing, -surface.mesh.corners.mean(axis=1)) > 0)
    towards = np.array([[0.0, 0.0, -1.0], [0.5, 0.0, -0.8], [0.0, -0.9, -0.5], [-0.6, 0.6, -0.6]])
    towards /= np.linalg.norm(towards, axis=1, keepdims=True)
    points = looked_at(surface, np.zeros((4, 3)), towards)
    paths = Paths(8192, 3, 1)
    found = by_bounces(surface, points, [EVEN], paths, 0)
    for bounce in range(4):
        assert np.abs(found[0, bounce] - 0.5 * 0.4**bounce).max() < 6e-3
    # Half of what is about a steep wall is below the horizon, and black.
    height = points.normals[:, 2:]
    assert np.abs(unshadowed(points, [EVEN], paths, 0)[0] - 0.5 * (1 + height)).max() < 6e-3


def test_what_arrives_hangs_on_the_chunk_alone() -> None:
    surface = Surface(bowl(0.5, 12, 24))
    points = looked_at(surface, np.zeros((2, 3)), np.array([[0.0, 0.6, -0.8], [0.6, 0.0, -0.8]]))
    one, same, other = (
        by_bounces(surface, points, [EVEN], Paths(64, 1, seed), first) for seed, first in ((3, 7), (3, 7), (3, 8))
    )
    assert np.array_equal(one, same)
    assert not np.array_equal(one, other)


def test_the_sky_on_an_open_floor() -> None:
    """Its irradiance by quadrature, for two skies along the same paths."""
    sky, theta = Preetham(), 1.1
    lights, expected = [], []
    for tau in (2.5, 5.0):
        parameters = {"sun_zenith": np.array([theta]), "turbidity": np.array([tau])}
        lights.append(Source(lambda along, known=parameters: sky.radiance(along, known)))
        harmonics = Harmonics.even(3)
        job = sampling.Job(sky, ("sun_zenith", "turbidity"), np.array([[[theta, tau]]]), 64, harmonics, "sun-centred")
        weights = np.asarray(harmonics.unmirror(sampling.project_block(job).weights[0, 0]))
        # Of the irradiance towards the zenith the first bands tell all but what is below the horizon, which is black.
        expected.append(weights[:, 2] * np.sqrt(4 * np.pi / 3) / np.pi)
    surface = Surface(floor(1.0))
    point = looked_at(surface, np.array([[0.2, 0.1, 1.0]]), np.array([[0.0, 0.0, -1.0]]))
    paths = Paths(16384, 0, 2)
    found = by_bounces(surface, point, lights, paths, 0)
    assert np.abs(found[:, 0, 0] / np.array(expected) - 1).max() < 5e-3
    assert np.array_equal(found[:, 0], unshadowed(point, lights, paths, 0))


def test_the_sun_on_the_floor_and_behind_a_screen() -> None:
    theta, disc = 0.7, np.array([3.0, 2.0, 1.0]) * 1e9
    towards = np.array([np.sin(theta), 0.0, np.cos(theta)])
    sun = Disc(towards, sun_disc.HALF_ANGLE, disc)
    low, high = floor(10.0), floor(1.0, 2.0)
    both = Mesh(
        np.concatenate([low.positions, high.positions]),
        np.concatenate([low.normals, high.normals]),
        np.concatenate([low.albedo, high.albedo]),
        np.concatenate([low.triangles, high.triangles + 4]),
        np.zeros(4, dtype=np.int64),
        low.parts,
        np.concatenate([low.uv, high.uv]),
    )
    surface = Surface(both)
    shadow = 2.0 * np.tan(theta)
    edge = -1.0 - shadow
    eyes = np.array([[5.0, 5.0, 1.0], [-shadow, 0.0, 1.0], [edge, 0.0, 1.0]])
    points = looked_at(surface, eyes, np.tile([0.0, 0.0, -1.0], (3, 1)))
    found = straight(surface, points, [sun], even(512, np.full((3, 2), 0.3)))
    whole = disc * np.sin(sun_disc.HALF_ANGLE) ** 2 * np.cos(theta)
    assert np.abs(found[0] / whole - 1).max() < 1e-4
    assert not found[1].any()
    # Where the screen's edge halves the disc.
    assert np.abs(found[2] / whole - 0.5).max() < 0.02


def test_the_sun_bounces_off_what_it_shines_on() -> None:
    """In a bowl with the sun straight above, the first bounce is that of an even diffuser: albedo times its mean."""
    disc = np.full(3, 1e6)
    sun = Source(np.zeros_like, [Disc(np.array([0.0, 0.0, 1.0]), sun_disc.HALF_ANGLE, disc)])
    surface = Surface(bowl(0.6))
    points = looked_at(surface, np.zeros((1, 3)), np.array([[0.3, 0.0, -0.95]]))
    found = by_bounces(surface, points, [sun], Paths(8192, 1, 4), 0)
    # A point of a sphere sends the same to every other one: a mean over the half's area, over twice that area.
    direct = disc * np.sin(sun_disc.HALF_ANGLE) ** 2
    expected = 0.6 * 0.5 * direct * 0.5
    assert np.abs(found[0, 1, 0] / expected - 1).max() < 0.02
    assert not found[0, 0].any()


def test_textures_colour_points_and_their_mean_vertices() -> None:
    plain = floor(1.0, albedo=0.8)
    texture = np.zeros((2, 2, 3))
    texture[0, 0], texture[0, 1], texture[1, 0], texture[1, 1] = 0.1, 0.2, 0.3, 0.4
    textured = Mesh(
        plain.positions, plain.normals, plain.albedo, plain.triangles, plain.part, (Part("all", texture),), plain.uv
    )
    surface = Surface(textured)
    # Looked at from above: the first row is the upper one, v = 1 and y = 1.
    eyes = np.array([[-0.5, 0.5, 1.0], [0.5, 0.5, 1.0], [-0.5, -0.5, 1.0], [0.5, -0.5, 1.0]])
    points = looked_at(surface, eyes, np.tile([0.0, 0.0, -1.0], (4, 1)))
    assert points.albedo[:, 0] == pytest.approx(0.8 * np.array([0.1, 0.2, 0.3, 0.4]))
    found = averaged(textured)
    assert found.albedo.mean(axis=0) == pytest.approx(0.8 * 0.25 * np.ones(3), rel=0.02)
    assert found.parts[0].texture is None
    assert averaged(found).albedo == pytest.approx(found.albedo)
    assert points.interpolate(textured.positions) == pytest.approx(points.positions)
    # From below there is nothing.
    assert not len(looked_at(surface, eyes - np.array([0.0, 0.0, 2.0]), np.tile([0.0, 0.0, 1.0], (4, 1))).positions)


def test_a_form_is_the_picture_it_stands_for() -> None:
    draw = np.random.default_rng(8)
    transfer, albedo = draw.normal(size=(5000, 3, 16)), draw.random((5000, 3))
    form = sensitivity.gram(transfer, albedo)
    true, off = draw.normal(size=(2, 7, 3, 16))
    pictures = [albedo * np.einsum("pcw,ncw->npc", transfer, weights) for weights in (true, off)]
    expected = np.sqrt(np.square(pictures[1]).mean(axis=(1, 2)) / np.square(pictures[0]).mean(axis=(1, 2)))
    assert sensitivity.relative_rmse(form, off, true) == pytest.approx(expected)
    grey = sensitivity.gram(transfer[:, :1], albedo)
    assert grey[2] == pytest.approx(sensitivity.gram(np.repeat(transfer[:, :1], 3, axis=1), albedo)[2])
    # Fewer bands are more bands with nothing in them.
    few = off[..., :9]
    assert sensitivity.difference(form, few, true) == pytest.approx(
        sensitivity.relative_rmse(form, np.concatenate([few, np.zeros((7, 3, 7))], axis=-1), true)
    )
