"""Transfer against closed forms: spheres, walls, cylinders, bowls; contact lines; and how honest its error is."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh import sphere
from skylight_sh.mesh import Mesh, Part
from skylight_sh.mesh.shapes import Piece, assembled, box, lathe, sheet
from skylight_sh.transfer import Options, Rays, bounced, gather, precompute, shadowed, unshadowed
from skylight_sh.transfer.sampling import frames
from skylight_sh.transfer.shadowing import to_world
from skylight_sh.transfer.whole import open_transfer, prepare, see, spread_of

Array = NDArray[np.float64]
UP = np.array([0.0, 0.0, 1.0])
# The dot product of a light of radiance 1 all around, with 1 band.
UNIFORM = np.sqrt(4.0 * np.pi)


def sector(bands: int, azimuth: float, zenith: float = np.pi / 2) -> Array:
    """cos / pi in SH over directions up to ``zenith`` from z and up to ``azimuth`` from x, by Gauss's rule.

    The integrands are polynomials of cosines and sines: 64 nodes leave nothing to see.
    """
    nodes, weights = np.polynomial.legendre.leggauss(64)
    theta, phi = np.meshgrid(0.5 * zenith * (nodes + 1.0), azimuth * nodes, indexing="ij")
    directions = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1)
    measure = np.outer(0.5 * zenith * weights, azimuth * weights) * np.sin(theta) * np.cos(theta) / np.pi
    return np.asarray(measure.ravel() @ sphere.basis(directions.reshape(-1, 3), bands))


def relative(found: Array, exact: Array) -> float:
    """The relative RMS of weights ``(v, N*N)``."""
    exact = np.broadcast_to(exact, found.shape)
    return float(np.sqrt(np.square(found - exact).sum() / np.square(exact).sum()))


def meshed(*pieces: Piece, albedo: float | tuple[float, float, float] = 0.5) -> Mesh:
    return assembled([(Part(f"part {i}"), np.broadcast_to(albedo, 3), piece) for i, piece in enumerate(pieces)])


def inside_out(piece: Piece) -> Piece:
    return Piece(piece.positions, -piece.normals, piece.uv, piece.triangles[:, ::-1])


def plane(u: Array, v: Array, across: tuple[int, int]) -> Piece:
    """A plane through the origin, whose axes ``across`` have these places; it faces their cross product."""
    points = np.zeros((len(v), len(u), 3))
    points[..., across[0]], points[..., across[1]] = u[np.newaxis], v[:, np.newaxis]
    return sheet(points)


def repeated(mesh: Mesh, point: Array, normal: Array, bands: int, rays: int = 1024, chunks: int = 32) -> Array:
    """Both halves of what one point sees, again and again: in so many chunks, each a lattice that is spun 8 times."""
    cast = Rays(mesh)
    points, normals = np.tile(point, (8, 1)), np.tile(normal, (8, 1))
    found = [shadowed(cast, points, normals, bands, count=rays, seed=1, first=i) for i in range(chunks)]
    return np.concatenate(found, axis=1)


def bowl(around: int = 256, rows: int = 24, albedo: float | tuple[float, float, float] = 0.8) -> Mesh:
    """The lower half of a sphere of radius 1, open above, seen from within."""
    angle = np.linspace(0.0, np.pi / 2, rows + 1)
    piece = inside_out(lathe(np.stack([np.sin(angle), -np.cos(angle)], axis=-1), around))
    return meshed(replace(piece, normals=-piece.positions), albedo=albedo)


def test_the_closed_forms_are_those_of_clamped_cosines() -> None:
    """The sector's own integrals: a whole hemisphere is the clamped cosine, half of one has half its first weight."""
    np.testing.assert_allclose(sector(12, np.pi), unshadowed(UP[np.newaxis], 12)[0], atol=1e-12)
    assert sector(1, np.pi / 2)[0] == pytest.approx(0.5 / UNIFORM, rel=1e-12)
    assert sector(1, np.pi, 0.5)[0] == pytest.approx(np.sin(0.5) ** 2 / UNIFORM, rel=1e-12)


def test_a_sphere_sees_all_of_its_hemispheres() -> None:
    """No point of a convex solid sees the solid: what is lost at 1,024 rays is sampling, and facets' tilt."""
    angle = np.linspace(0.0, np.pi, 97)
    ball = meshed(lathe(np.stack([np.sin(angle), -np.cos(angle)], axis=-1), 192))
    setup = prepare(ball, Options(bands=5, bounces=0))
    seen = [slice(start, start + 256) for start in (0, 8192, 16384)]
    found = np.concatenate([see(setup, some)["halves"].mean(axis=0) for some in seen])
    normals = np.concatenate([ball.normals[some] for some in seen])
    assert relative(found, unshadowed(normals, 5)) < 0.0025


@pytest.mark.parametrize(("bands", "bound"), [(1, 0.005), (5, 0.005), (12, 0.012)])
def test_the_foot_of_an_infinite_wall_sees_a_quarter_of_the_sphere(bands: int, bound: float) -> None:
    along, away = np.linspace(-300.0, 300.0, 65), np.array([0.0, 5.0, 1e5])
    far = np.concatenate([[-1e5], along, [1e5]])
    ground, wall = plane(away, far, (0, 1)), plane(far, away, (1, 2))
    found = precompute(meshed(ground, wall), Options(bands=bands, bounces=0))
    positions, normals = np.concatenate([ground.positions, wall.positions]), np.concatenate([ground.normals, wall.normals])
    foot = (np.abs(positions[:, [0, 2]]).max(axis=1) == 0.0) & (np.abs(positions[:, 1]) < 1e3)
    of_ground, of_wall = foot & (normals[:, 2] > 0.5), foot & (normals[:, 0] > 0.5)
    assert of_ground.sum() == of_wall.sum() == 65
    assert not found.start.buried[foot].any()
    exact = sector(bands, np.pi / 2)
    assert relative(found.direct[of_ground], exact) < bound
    # The wall sees the same quarter: its mirror image about the plane between them, x and z exchanged.
    probe = sphere.spiral(4 * bands * bands)
    mirrored = np.linalg.lstsq(sphere.basis(probe, bands), sphere.basis(probe[:, [2, 1, 0]], bands) @ exact, rcond=None)[0]
    assert relative(found.direct[of_wall], mirrored) < bound


@pytest.mark.parametrize("opening", [0.5, np.pi / 4, 1.2])
def test_the_bottom_of_a_cylinder_sees_a_cone(opening: float) -> None:
    well = meshed(inside_out(lathe([[1.0, 0.0], [1.0, 1.0 / np.tan(opening)]], 720)))
    halves = repeated(well, np.array([0.0, 0.0, 1e-6]), UP, 5)
    assert relative(halves.mean(axis=0), sector(5, np.pi, opening)) < 0.004


def test_a_sphere_over_a_point_is_left_out_of_its_view() -> None:
    """A ball straight above a plane's point covers a cone of it."""
    angle = np.linspace(0.0, np.pi, 193)
    ball = lathe(np.stack([np.sin(angle), 2.0 - np.cos(angle)], axis=-1), 384)
    halves = repeated(meshed(ball), np.zeros(3), UP, 5)
    # Seen from two radii below its middle it reaches 30 degrees from the zenith.
    assert relative(halves.mean(axis=0), sector(5, np.pi) - sector(5, np.pi, np.pi / 6)) < 0.0025


@pytest.mark.parametrize("rays", [256, 1024])
def test_the_error_that_is_told_is_the_error(rays: int) -> None:
    """Half the difference of two halves, against the closed form: within a fifth, in either direction."""
    well = meshed(inside_out(lathe([[1.0, 0.0], [1.0, 1.0]], 720)))
    halves = repeated(well, np.array([0.3, 0.0, 1e-6]), UP, 5, rays)
    truth = repeated(well, np.array([0.3, 0.0, 1e-6]), UP, 5, 16384, chunks=2).mean(axis=(0, 1))
    told = spread_of(halves, np.ones(halves.shape[1], bool))[1]
    assert 0.8 < told / relative(halves.mean(axis=0), truth) < 1.2


def test_more_rays_see_better_and_twenty_bands_work() -> None:
    well = meshed(inside_out(lathe([[1.0, 0.0], [1.0, 1.0]], 720)))
    exact = sector(20, np.pi, np.pi / 4)
    errors = [relative(repeated(well, 1e-6 * UP, UP, 20, rays, 3).mean(axis=0), exact) for rays in (64, 512, 4096)]
    assert errors[0] > 3.0 * errors[1] > 9.0 * errors[2]
    assert errors[2] < 0.005


@pytest.mark.parametrize("bands", [1, 2, 5, 12, 20])
def test_weights_are_turned_into_the_world_exactly(bands: int) -> None:
    """A function in a vertex's frame has in the world the values that it has in the frame."""
    rng = np.random.default_rng(5)
    normals = rng.normal(size=(6, 3))
    normals = np.concatenate([normals / np.linalg.norm(normals, axis=1, keepdims=True), [UP, -UP]])
    turned, weights = frames(normals, rng.uniform(0.0, 6.0, 8)), rng.normal(size=(8, bands * bands))
    np.testing.assert_allclose(np.linalg.det(turned), 1.0, atol=1e-12)
    local = sphere.spiral(50)
    world = to_world(weights, turned)
    for frame, own, found in zip(turned, weights, world, strict=True):
        np.testing.assert_allclose(
            sphere.basis(local @ frame.T, bands) @ found, sphere.basis(local, bands) @ own, atol=1e-10 * bands**2
        )


def test_a_bowl_under_a_uniform_light_is_lit_alike_everywhere() -> None:
    """Every point of half a sphere sees half of it: 1/2 at once, 1/2 (albedo / 2)^b after b bounces, channel by channel."""
    albedo = np.array([0.8, 0.5, 0.0])
    mesh = bowl(albedo=(0.8, 0.5, 0.0))
    found = precompute(mesh, Options(bands=2, bounces=3))
    inner = mesh.positions[:, 2] < -0.15
    now = np.repeat(UNIFORM * found.direct[:, :1], 3, axis=1)
    total = np.zeros_like(now)
    for bounce in range(4):
        exact = 0.5 * (0.5 * albedo) ** bounce
        off = now[inner] - exact
        assert np.abs(off.mean(axis=0)).max() < 1e-4
        assert np.abs(off).max() < 0.012
        total += now
        now = found.matrix @ (albedo * now)
    np.testing.assert_allclose(UNIFORM * found.transfer[:, :, 0], total, atol=1e-12)


def test_points_of_a_bowl_come_as_near_as_rays_are_spent() -> None:
    """At 2^17 rays each of some points is within 1e-4 of a half, and what it gathers is as near."""
    mesh = bowl(1024, 96)
    rays = Rays(mesh)
    height = np.array([-0.99, -0.7, -0.4])
    normals = -np.stack([np.sqrt(1.0 - height**2), np.zeros(3), height], axis=-1)
    # Just within the polyhedron, whose faces lie up to 3.4e-5 within the sphere.
    points = -(1.0 - 4e-5) * normals
    seen = shadowed(rays, points, normals, 1, count=2**17, seed=0, first=0).mean(axis=0)[:, 0]
    np.testing.assert_allclose(UNIFORM * seen, 0.5, atol=1e-4)
    met = gather(mesh, rays, points, normals, count=2**17, seed=0, first=0)
    np.testing.assert_allclose(met.sum(axis=1), 0.5, atol=1e-4)
    assert bounced(seen[:, np.newaxis], np.ones((3, 3)), met[:, :3], 0).shape == (3, 3, 1)


def test_what_is_met_from_behind_blocks_but_sends_nothing() -> None:
    floor = plane(np.linspace(-1.0, 1.0, 5), np.linspace(-1.0, 1.0, 5), (0, 1))
    away = plane(np.linspace(-1.0, 1.0, 3), np.linspace(-1.0, 1.0, 3), (1, 0)).moved((0.0, 0.0, 0.5))
    towards = plane(np.linspace(-1.0, 1.0, 3), np.linspace(-1.0, 1.0, 3), (0, 1)).moved((0.0, 0.0, 0.5))
    points, normals = np.array([[0.05, 0.02, 1e-6]]), UP[np.newaxis]
    sums, seen = [], []
    for lid in (away, towards):
        mesh = meshed(floor, lid)
        rays = Rays(mesh)
        sums.append(gather(mesh, rays, points, normals, count=1024, seed=0, first=0).sum())
        seen.append(UNIFORM * shadowed(rays, points, normals, 1, count=1024, seed=0, first=0).mean())
    assert sums[1] == 0.0
    assert sums[0] > 0.7
    # Either blocks as much: one minus what the square above covers.
    np.testing.assert_allclose(seen, 1.0 - sums[0], atol=0.01)


def test_interpolation_at_hits_is_exact_for_linear_light() -> None:
    """Over a floor that sends out its own x, a wall's points gather the mean x of what they meet: of all rays, by hand."""
    floor = plane(np.linspace(0.0, 50.0, 6), np.linspace(-50.0, 50.0, 9), (0, 1))
    mesh, point, normal = meshed(floor), np.array([[10.0, 0.0, 0.3]]), np.array([[0.6, 0.0, -0.8]])
    matrix = gather(mesh, Rays(mesh), point, normal, count=4096, seed=0, first=0)
    constant = np.ones(len(mesh.positions))
    share, mean = float((matrix @ constant)[0]), float((matrix @ mesh.positions[:, 0])[0])
    rng = np.random.default_rng(0)
    radius, azimuth = np.sqrt(rng.random(400_000)), 2.0 * np.pi * rng.random(400_000)
    local = np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), np.sqrt(1.0 - radius**2)], axis=-1)
    along = local @ frames(normal, np.zeros(1))[0].T
    x, y = (point[0, i] - point[0, 2] * along[:, i] / along[:, 2] for i in (0, 1))
    met = (along[:, 2] < 0.0) & (x > 0.0) & (x < 50.0) & (np.abs(y) < 50.0)
    assert share == pytest.approx(met.mean(), abs=2e-3)
    assert mean == pytest.approx((x * met).mean(), abs=0.03)


def floor_and_box(sunk: float) -> Mesh:
    ticks = np.linspace(-2.0, 2.0, 17)
    return meshed(plane(ticks, ticks, (0, 1)), box((-0.6, -0.5, -sunk), (0.5, 0.75, 1.0), 0.25))


@pytest.mark.parametrize("sunk", [0.0, 0.1])
def test_no_dark_halo_surrounds_what_stands_on_a_floor(sunk: float) -> None:
    """Outside a convex thing a floor sees at least a quarter of the sphere, and so does the thing's side above the floor.

    That holds in contact lines too, where vertices lie in two surfaces at once; the floor below the box is healed.
    """
    mesh = floor_and_box(sunk)
    found = precompute(mesh, Options(bands=1, bounces=0, rays=512))
    seen = UNIFORM * found.direct[:, 0]
    x, y, z = mesh.positions.T
    floor = (np.arange(len(x)) < 17 * 17) & ~((x > -0.6) & (x < 0.5) & (y > -0.5) & (y < 0.75))
    side = (np.arange(len(x)) >= 17 * 17) & (np.abs(mesh.normals[:, 2]) < 0.5)
    assert seen[floor].min() > 0.49
    assert seen[side & (z > -0.01)].min() > 0.48
    under = (np.arange(len(x)) < 17 * 17) & (x > -0.55) & (x < 0.45) & (y > -0.45) & (y < 0.7)
    assert found.start.buried[under].all()
    assert seen[under].min() > 0.3
    assert not found.start.buried[floor].any()


def test_errors_count_valid_vertices_alone() -> None:
    halves = np.array([[[1.0, 0.0], [9.0, 0.0]], [[1.0, 0.2], [1.0, 0.0]]])
    spread, error = spread_of(halves, np.array([True, False]))
    assert error == pytest.approx(0.1 / np.hypot(1.0, 0.1))
    np.testing.assert_allclose(spread, [error, 0.8])


def test_a_mesh_that_blocks_nothing_sees_everything() -> None:
    mesh = floor_and_box(0.0)
    found = open_transfer(mesh, 4)
    assert found.shape == (len(mesh.positions), 3, 16)
    light = np.random.default_rng(2).normal(size=16)
    np.testing.assert_allclose(found @ light, np.repeat((unshadowed(mesh.normals, 4) @ light)[:, np.newaxis], 3, axis=1))


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_size_and_place_change_nothing(scale: float) -> None:
    mesh = floor_and_box(0.1)
    moved = Mesh(
        scale * (mesh.positions + np.array([3.0, -7.0, 11.0])),
        mesh.normals,
        mesh.albedo,
        mesh.triangles,
        mesh.part,
        mesh.parts,
        mesh.uv,
    )
    options = Options(bands=2, rays=64, gather_rays=32, bounces=1)
    one, other = precompute(mesh, options), precompute(moved, options)
    # Single precision flips a ray here and there, at edges.
    assert np.abs(one.transfer - other.transfer).mean() < 2e-3
