"""Lightmaps: texels of a chart, incident light against closed forms, irradiance for a normal map, files, and losses."""

from __future__ import annotations

import io
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result
from conftest import ROOT
from numpy.typing import NDArray
from scipy.interpolate import interpn
from skylight_sh import UserError, load, sphere
from skylight_sh.cli import main
from skylight_sh.lightmap import evaluation, files, incident, texels
from skylight_sh.mesh import Mesh, Part
from skylight_sh.reflectance.brute_force import relative_rms
from skylight_sh.render.brute_force import Paths, arriving
from skylight_sh.render.surface import Points, Surface
from skylight_sh.studies import lightmaps
from skylight_sh.studies.materials import environment
from skylight_sh.transfer import Options, Rays, precompute

Array = NDArray[np.float64]

MATHEMATICS = (ROOT / "docs" / "mathematics.md").read_text(encoding="utf-8")
MANY = incident.Sampling(rays=4096)
UP = np.array([0.0, 0.0, 1.0])


def quad(
    corner: object, along: object, up: object, name: str = "quad", uv: object = ((0, 0), (1, 0), (1, 1), (0, 1))
) -> Mesh:
    """Two triangles that face along x up."""
    a, u, v = (np.array(part, dtype=np.float64) for part in (corner, along, up))
    normal = np.cross(u, v) / np.linalg.norm(np.cross(u, v))
    return Mesh(
        positions=np.stack([a, a + u, a + u + v, a + v]),
        normals=np.tile(normal, (4, 1)),
        albedo=np.full((4, 3), 0.5),
        triangles=np.array([[0, 1, 2], [0, 2, 3]]),
        part=np.zeros(2, dtype=np.int64),
        parts=(Part(name),),
        uv=np.array(uv, dtype=np.float64),
    )


def together(*meshes: Mesh) -> Mesh:
    starts = np.cumsum([0, *(len(m.positions) for m in meshes)])
    names = ("positions", "normals", "albedo", "uv")
    return Mesh(
        **{name: np.concatenate([getattr(m, name) for m in meshes]) for name in names},
        triangles=np.concatenate([m.triangles + k for m, k in zip(meshes, starts, strict=False)]),
        part=np.concatenate([m.part + k for k, m in enumerate(meshes)]),
        parts=tuple(m.parts[0] for m in meshes),
    )


def closed_box(inwards: bool = True) -> Mesh:
    """A cube of side 2 about the origin, its faces seen from inside, or from outside."""
    faces = []
    for axis in range(3):
        for side in (-1.0, 1.0):
            n = np.zeros(3)
            n[axis] = -side if inwards else side
            u = np.roll(n, 1)
            v = np.cross(n, u)
            faces.append(quad(side * np.eye(3)[axis] - u - v, 2 * u, 2 * v, f"{axis}{side:+.0f}"))
    return together(*faces)


def at(point: object, normal: object = UP) -> texels.Texels:
    n = np.array([normal], dtype=np.float64)
    tangent = np.cross(n, [0.36, 0.48, 0.8])
    return texels.of_points(np.array([point], dtype=np.float64), n, tangent)


def even(radiance: float) -> Callable[[Array], Array]:
    return lambda directions: np.full((len(directions), 3), radiance)


def above(normal: Array, bands: int, radiance: float = 1.0) -> Array:
    """The weights of an even light over the hemisphere above a normal: exact."""
    zonal = (-1.0) ** np.arange(bands) * sphere.lower_hemisphere(bands)
    return radiance * sphere.aim(zonal, normal)


def table_of(name: str) -> list[list[str]]:
    told = re.search(rf"<!-- {name} -->\n(.*?)<!-- /{name} -->", MATHEMATICS, re.DOTALL)
    assert told
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in told[1].splitlines()[2:]]


def test_texels_of_a_chart_lie_where_their_texture_coordinates_say() -> None:
    mesh = quad((1, 2, 3), (4, 0, 0), (0, 0, 2))
    found = texels.chart(mesh, "quad", 4, 8)
    assert found.covered.all()
    # Row 0 is the top, v = 1.
    assert found.points[0, 0].tolist() == pytest.approx([1.25, 2.0, 4.75])
    assert found.points[3, 7].tolist() == pytest.approx([4.75, 2.0, 3.25])
    assert np.abs(found.frames - np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])).max() < 1e-12


def test_a_chart_may_be_turned_mirrored_and_part_of_the_texture() -> None:
    mesh = quad((0, 0, 0), (2, 0, 0), (0, 2, 0), uv=((1.0, 0.5), (1.0, 1.0), (0.5, 1.0), (0.5, 0.5)))
    found = texels.chart(mesh, "quad", 8, 8)
    assert found.covered.sum() == 16
    assert found.covered[:4, 4:].all()
    # u runs along -y, v along x.
    assert np.abs(found.frames[0, 4] - np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])).max() < 1e-12
    assert found.points[3, 7].tolist() == pytest.approx([0.25, 0.25, 0.0])
    mirrored = quad((0, 0, 0), (2, 0, 0), (0, 2, 0), uv=((1, 0), (0, 0), (0, 1), (1, 1)))
    assert np.linalg.det(texels.chart(mirrored, "quad", 2, 2).frames) == pytest.approx(-1.0)


def test_normals_are_interpolated_across_a_chart() -> None:
    mesh = quad((0, 0, 0), (1, 0, 0), (0, 1, 0))
    leaning = np.array([[-0.6, 0, 0.8], [0.6, 0, 0.8], [0.6, 0, 0.8], [-0.6, 0, 0.8]])
    found = texels.chart(replace(mesh, normals=leaning), "quad", 3, 3)
    assert found.frames[1, 1, 2].tolist() == pytest.approx([0, 0, 1])
    assert found.frames[1, 2, 2, 0] > 0.3
    assert np.abs(found.frames @ found.frames.swapaxes(-1, -2) - np.eye(3)).max() < 1e-12


@pytest.mark.parametrize(
    ("uv", "told"),
    [
        (((0, 0), (0, 0), (0, 0), (0, 0)), "no texture coordinates"),
        (((0, 0), (3, 0), (3, 1), (0, 1)), "run from 0 to 3"),
        (((0, 0), (1, 0), (1, 1), (0.9, 0)), "covers a texel twice"),
    ],
)
def test_a_bad_chart_is_refused(uv: object, told: str) -> None:
    with pytest.raises(UserError, match=told):
        texels.chart(quad((0, 0, 0), (1, 0, 0), (0, 1, 0), uv=uv), "quad", 16, 16)
    with pytest.raises(UserError, match=r"none of that name\. Take one of quad"):
        texels.chart(quad((0, 0, 0), (1, 0, 0), (0, 1, 0)), "roof", 4, 4)


def test_bad_points_and_reliefs_are_refused() -> None:
    with pytest.raises(ValueError, match="Should be one"):
        texels.of_points(np.zeros((2, 3)), np.zeros(3), np.zeros(3))
    with pytest.raises(ValueError, match="not finite"):
        texels.of_points(np.full(3, np.nan), UP, np.eye(3)[0])
    with pytest.raises(ValueError, match="Invalid tangent"):
        texels.of_points(np.zeros(3), UP, UP)
    with pytest.raises(ValueError, match="no length"):
        texels.world_normals(np.eye(3), np.zeros(3))
    with pytest.raises(ValueError, match="a ray or more"):
        incident.Sampling(rays=0)


def test_an_open_plane_under_an_even_sky() -> None:
    """The hemisphere's weights, and irradiance pi (1 + cos) / 2, which two bands hold exactly."""
    mesh = quad((-1, -1, 0), (2, 0, 0), (0, 2, 0))
    weights = incident.bake(mesh, Rays(mesh), at((0.1, 0.2, 0.0)), even(3.0), np.zeros((4, 3)), 3, MANY)
    assert np.abs(weights[0] - above(UP, 3, 3.0)).max() < 2e-3
    normals = sphere.spiral(50)
    exact = 3.0 * np.pi * (1 + normals[:, 2]) / 2
    found = evaluation.evaluate(above(UP, 2, 3.0)[np.newaxis], normals)[:, 0]
    assert np.abs(found - exact).max() < 1e-12
    baked = evaluation.evaluate(weights[0, :, :4], normals)
    assert np.abs(baked - exact[:, np.newaxis]).max() < 0.01
    fresh = incident.irradiance(
        mesh, Rays(mesh), at((0.1, 0.2, 0.0)), normals[np.newaxis], even(3.0), np.zeros((4, 3)), MANY
    )
    assert np.abs(fresh[0] - exact[:, np.newaxis]).max() < 0.01


def test_inside_a_closed_box_surfaces_are_all_there_is() -> None:
    mesh = closed_box()
    rays, leaving = Rays(mesh), np.tile([1.0, 2.0, 0.0], (24, 1))
    for normal in (UP, np.array([0.48, -0.6, 0.64])):
        weights = incident.bake(mesh, rays, at((0.3, -0.2, 0.1), normal), even(100.0), leaving, 4, MANY)[0]
        exact = above(normal, 4)
        assert np.abs(weights - np.multiply.outer([1.0, 2.0, 0.0], exact)).max() < 3e-3
    # Seen from behind, faces send nothing, and hide the sky all the same.
    outer = closed_box(inwards=False)
    assert not incident.bake(outer, Rays(outer), at((0.3, -0.2, 0.1)), even(100.0), leaving, 2, MANY).any()


def test_the_foot_of_an_endless_wall_sees_half_the_sky() -> None:
    """And the wall, of radiance 2, is the other half: the lune's weights by Gauss's rule in each quarter."""
    wall = quad((0, -2000, 0), (0, 4000, 0), (0, 0, 2000), "wall")
    ground = quad((0, -10, 0), (10, 0, 0), (0, 20, 0), "ground")
    mesh = together(wall, ground)
    rays = Rays(mesh)
    spot = at((0.05, 0, 0))
    weights = incident.bake(mesh, rays, spot, even(1.0), np.full((8, 3), 2.0), 3, incident.Sampling(8192, height=1e-7))[0, 0]
    z, area = sphere.gauss_unit(20)
    azimuth, arc = sphere.gauss(20)
    exact = np.zeros(9)
    for middle, radiance in ((0.0, 1.0), (np.pi, 2.0)):
        turn = middle + azimuth * np.pi / 2
        flat = np.sqrt(1 - z**2)[:, np.newaxis]
        where = np.stack(np.broadcast_arrays(flat * np.cos(turn), flat * np.sin(turn), z[:, np.newaxis]), axis=-1)
        exact += radiance * np.einsum("i,k,ikw->w", area, arc * np.pi / 2, sphere.basis(where, 3))
    assert np.abs(weights - exact).max() < 5e-3
    irradiance = evaluation.evaluate(weights[np.newaxis], UP[np.newaxis])[0, 0]
    assert irradiance == pytest.approx(1.5 * np.pi, rel=2e-3)


def test_surfaces_are_interpolated_between_their_vertices() -> None:
    """A ceiling whose radiance rises linearly in x is seen as that, wherever a ray meets it."""
    mesh = quad((-50, 50, 1), (100, 0, 0), (0, -100, 0))
    leaving = np.repeat((5.0 + 0.05 * mesh.positions[:, :1]), 3, axis=1)
    seen = next(incident.meet(mesh, Rays(mesh), at((0.7, 0.3, 0)), incident.Sampling(4096, height=0.0)))
    x = np.sum(seen.weights * mesh.positions[seen.corners][..., 0], axis=-1)[0]
    hit = ~seen.free[0]
    straight = 0.7 + seen.directions[0, :, 0] / seen.directions[0, :, 2]
    assert np.abs(x - straight)[hit].max() < 1e-9
    assert hit.mean() > 0.95
    weights = incident.bake(mesh, Rays(mesh), at((0, 0, 0)), even(5.0), leaving, 2, MANY)[0, 0]
    # x is odd about the middle: the mean is the ceiling's 5, and the light leans towards +x.
    assert weights[0] == pytest.approx(above(UP, 2, 5.0)[0], rel=1e-3)
    assert weights[3] > 0.05


def test_matrices_light_as_a_bake_of_the_same_sky_does() -> None:
    """A sky that is an expansion itself, with bounces: the same rays give the same numbers."""
    street = lightmaps.street(2, 3)
    made = precompute(street.mesh, Options(bands=4, rays=64, gather_rays=32, bounces=2))
    weights = np.random.default_rng(9).normal(size=(3, 16))
    sampling = incident.Sampling(rays=300, seed=5)
    back = street.mesh.albedo[:, :, np.newaxis] * made.transfer
    matrices = incident.matrices(street.mesh, street.rays, street.texels, back, 3, sampling)
    assert matrices.shape == (2, 3, 3, 9, 16)
    leaving = np.einsum("vcw,cw->vc", back, weights)

    def sky(directions: Array) -> Array:
        return sphere.evaluate(weights, directions).T

    baked = incident.bake(street.mesh, street.rays, street.texels, sky, leaving, 3, sampling)
    lit = incident.apply(matrices, np.concatenate([weights, np.ones((3, 9))], axis=-1))
    assert np.abs(lit - baked).max() < 1e-12 * np.abs(baked).max()


def test_texels_beside_the_chart_stay_dark_and_others_do_not_change() -> None:
    whole = quad((0, 0, 0), (2, 0, 0), (0, 2, 0), uv=((0, 0.5), (1, 0.5), (1, 1), (0, 1)))
    found = texels.chart(whole, "quad", 8, 4)
    weights = incident.bake(whole, Rays(whole), found, even(1.0), np.zeros((4, 3)), 2, incident.Sampling(64))
    assert not weights[4:].any()
    assert weights[:4].all(axis=(2, 3)).any() or (weights[:4, :, :, 0] > 0).all()
    normals = np.broadcast_to(UP, (8, 4, 1, 3))
    alone = incident.irradiance(whole, Rays(whole), found, normals, even(1.0), np.zeros((4, 3)), incident.Sampling(64))
    assert not alone[4:].any()
    assert alone[:4].min() > 3.0


def test_two_bands_are_the_tutorials_packed_form() -> None:
    """A quarter of the radiance's integral, and half of those against y, z and x; a dot product with the normal."""
    directions, powers = sphere.spiral(30), np.linspace(0.5, 2.0, 30)
    weights = (powers @ sphere.basis(directions, 3))[np.newaxis]
    lightmap = evaluation.Lightmap(weights[np.newaxis, np.newaxis], np.eye(3)[np.newaxis, np.newaxis], np.ones((1, 1), bool))
    exact = [0.25 * powers.sum(), *(0.5 * powers @ directions[:, [1, 2, 0]])]
    assert lightmap.packed[0, 0, 0].tolist() == pytest.approx(exact)
    normal = np.array([0.48, 0.6, 0.64])
    found = evaluation.evaluate(weights[:, :4], normal)
    assert found[0] == pytest.approx(exact[0] + np.dot(exact[1:], normal[[1, 2, 0]]))


def test_three_bands_are_the_irradiance_of_the_light() -> None:
    """Against the integral of a light that three bands hold, which a clamped cosine convolves exactly."""
    rng = np.random.default_rng(1)
    weights = rng.normal(size=(2, 9))
    z, w = sphere.gauss(40)
    phi = (np.arange(60) + 0.5) * np.pi / 30
    flat = np.sqrt(1 - z**2)[:, np.newaxis]
    where = np.stack(np.broadcast_arrays(flat * np.cos(phi), flat * np.sin(phi), z[:, np.newaxis]), axis=-1).reshape(-1, 3)
    normals = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
    light = sphere.evaluate(weights, where) * np.repeat(w * np.pi / 30, 60)
    # Gauss's rule on each half meets the clamp at z = 0 to its nodes' number.
    exact = (light @ np.maximum(where @ normals.T, 0.0)).T
    assert np.abs(evaluation.evaluate(weights, normals) - exact).max() < 1e-2


@pytest.mark.parametrize("bands", [2, 3])
def test_nonnegative_forms_are_nowhere_negative(bands: int) -> None:
    """Lights from one direction, the worst there is; two bands keep the mean, and the peak of a single light."""
    rng = np.random.default_rng(7)
    sides = rng.normal(size=(6, 3))
    sides /= np.linalg.norm(sides, axis=-1, keepdims=True)
    one = sphere.basis(sides[:, np.newaxis], bands) * np.array([1.0, 0.3, 2.0])[:, np.newaxis]
    two = one + 0.4 * sphere.basis(sides[::-1, np.newaxis], bands)
    normals = sphere.spiral(600)
    for weights in (one, two):
        linear = evaluation.evaluate(weights[:, np.newaxis], normals)
        assert linear.min() < -0.01
        clamped = evaluation.evaluate(weights[:, np.newaxis], normals, "clamped")
        assert np.array_equal(clamped, np.maximum(linear, 0.0))
        found = evaluation.evaluate(weights[:, np.newaxis], normals, "nonnegative")
        assert found.min() >= -1e-12
        mean = found.mean(axis=1)
        assert np.abs(mean / (np.sqrt(np.pi) / 2 * weights[..., 0]) - 1).max() < 0.01
    if bands == 2:
        peak = evaluation.evaluate(one[0], sides[0], "nonnegative")
        assert peak[0] == pytest.approx(1.0)  # what a beam gives that falls straight on a surface


def test_deringing_serves_all_channels_of_a_texel_by_one_window() -> None:
    side = np.array([0.6, 0.0, 0.8])
    red, blue = sphere.basis(side, 3), 0.9 * np.eye(9)[0] + 0.1 * sphere.basis(-side, 3)
    found = evaluation.deringed(np.stack([red, blue]))
    assert sphere.minimum(sphere.irradiance(found))[0].min() >= -1e-12
    degree_1, degree_2 = slice(1, 4), slice(4, 9)
    for degree in (degree_1, degree_2):
        shares = [
            np.linalg.norm(after[degree]) / np.linalg.norm(before[degree])
            for after, before in zip(found, (red, blue), strict=True)
        ]
        assert shares[0] == pytest.approx(shares[1])
        assert shares[0] < 1.0


def test_a_fit_to_the_normals_of_a_relief_is_the_nearest() -> None:
    """Within its cap nothing of so few bands is nearer: its error is at right angles to all of them."""
    rng = np.random.default_rng(3)
    light = rng.normal(size=(3, 25)) * 0.3 ** np.sqrt(np.arange(25))
    normal = np.array([0.48, 0.6, 0.64])
    cap = np.array([n for n in sphere.spiral(4000) if n @ normal > 0.5])
    exact = evaluation.evaluate(light, cap)
    for bands in (2, 3):
        found = evaluation.fitted(light, normal, bands)
        assert found.shape == (3, bands * bands)
        off = evaluation.evaluate(found, cap) - exact
        cut = evaluation.evaluate(light[:, : bands * bands], cap) - exact
        assert np.sqrt(np.mean(off**2)) < 0.8 * np.sqrt(np.mean(cut**2))
        best = np.linalg.lstsq(sphere.basis(cap, bands), exact, rcond=None)[0]
        nearest = sphere.basis(cap, bands) @ best - exact
        assert np.sqrt(np.mean(off**2)) < 1.02 * np.sqrt(np.mean(nearest**2))
    # What has no more bands is left as it is.
    assert np.abs(evaluation.fitted(light[:, :9], normal, 3) - light[:, :9]).max() < 1e-9


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: evaluation.evaluate(np.ones((1, 4)), UP, "rosy"), "form 'rosy'"),  # type-checkers see to it elsewhere
        (lambda: evaluation.fitted(np.ones((1, 9)), UP, 4), "from 2 to 3 bands"),
        (lambda: evaluation.fitted(np.ones((1, 9)), UP, 2, tilt=1.6), "tilt 1.6"),
        (lambda: evaluation.fitted(np.ones((1, 9)), UP, 2, tilt=0.0), "tilt 0.0"),
        (lambda: evaluation.Lightmap(np.ones((1, 1, 4)), np.eye(3), np.ones(1)), r"shape \(1, 1, 4\)"),
        (lambda: evaluation.Lightmap(np.ones((2, 2, 1, 4)), np.eye(3), np.ones((2, 2), bool)), "frames or cover"),
        (
            lambda: evaluation.Lightmap(np.full((1, 1, 1, 4), np.nan), np.eye(3)[None, None], np.ones((1, 1), bool)),
            "not finite",
        ),
    ],
)
def test_what_makes_no_sense_is_told(call: Callable[[], object], told: str) -> None:
    with pytest.raises(ValueError, match=told):
        call()


def ramp(rows: int, columns: int, bands: int = 2) -> evaluation.Lightmap:
    """A lightmap whose weights rise linearly across and down; its frames turn u to y and v to z."""
    weights = np.zeros((rows, columns, 3, bands * bands))
    weights[..., 0] = 10.0 + np.arange(columns)[:, np.newaxis] + 2 * np.arange(rows)[:, np.newaxis, np.newaxis]
    weights[..., 1:4] = weights[..., :1] * np.array([0.1, 0.2, 0.3])
    frames = np.broadcast_to(np.array([[0.0, 1, 0], [0, 0, 1], [1, 0, 0]]), (rows, columns, 3, 3)).copy()
    return evaluation.Lightmap(weights, frames, np.ones((rows, columns), bool))


def test_a_relief_finer_than_its_lightmap() -> None:
    """Between texels' centres the light is what a line between them gives; normals are those of the relief, in the world."""
    lightmap = ramp(4, 5)
    relief = np.broadcast_to(np.array([0.6, 0.0, 0.8]), (12, 15, 3)).copy()
    relief[5, 7] = (0.0, 0.0, 1.0)
    found = evaluation.shade(lightmap, relief)
    assert found.shape == (12, 15, 3)
    for i, k in ((5, 7), (4, 3), (7, 10)):
        x, y = (k + 0.5) / 3 - 0.5, (i + 0.5) / 3 - 0.5
        weights = (10 + x + 2 * y) * np.array([[1.0, 0.1, 0.2, 0.3]])
        normal = np.array([1.0, 0.0, 0.0]) if (i, k) == (5, 7) else np.array([0.8, 0.6, 0.0])
        assert found[i, k, 0] == pytest.approx(evaluation.evaluate(weights, normal)[0])
    # Beyond the outermost centres it stays as there.
    assert found[0, 0, 0] == pytest.approx(evaluation.evaluate(lightmap.weights[0, 0], np.array([0.8, 0.6, 0.0]))[0])
    assert np.abs(evaluation.shade(lightmap, relief[::3, ::3])[0, 0] - found[0, 0]).max() < 1e-9


def test_light_between_texels_is_bilinear() -> None:
    """Against SciPy's interpolation of a lightmap without any order, centres beyond the outermost held to them."""
    rows, columns = 5, 4
    weights = np.random.default_rng(12).normal(size=(rows, columns, 3, 4))
    lightmap = replace(ramp(rows, columns), weights=weights)
    found = evaluation.shade(lightmap, np.broadcast_to(UP, (15, 8, 3)))
    y = np.clip((np.arange(15) + 0.5) / 3 - 0.5, 0, rows - 1)
    x = np.clip((np.arange(8) + 0.5) / 2 - 0.5, 0, columns - 1)
    grid = np.stack(np.meshgrid(y, x, indexing="ij"), axis=-1)
    between = interpn((np.arange(rows), np.arange(columns)), weights, grid)
    # The relief's own normal, outward, is x in the world.
    assert np.abs(found - evaluation.evaluate(between, np.array([1.0, 0.0, 0.0]))).max() < 1e-12


def test_holes_of_a_chart_do_not_darken_their_neighbours() -> None:
    lightmap = ramp(4, 4)
    covered = lightmap.covered.copy()
    covered[:, 2:] = False
    weights = np.where(covered[..., np.newaxis, np.newaxis], lightmap.weights, 0.0)
    found = evaluation.shade(replace(lightmap, weights=weights, covered=covered), np.broadcast_to(UP, (8, 8, 3)))
    assert found[:, :4].min() > 5.0
    assert np.abs(found[2, 4] - found[2, 3]).max() < 1.5
    assert not found[:, 6:].any()


def test_a_relief_is_never_lit_negatively_where_that_is_asked() -> None:
    for bands in (2, 3):
        lightmap = ramp(2, 2, bands)
        hard = replace(lightmap, weights=np.tile(sphere.basis(np.array([0.0, 0.6, 0.8]), bands), (2, 2, 3, 1)))
        relief = sphere.spiral(64).reshape(8, 8, 3)
        assert evaluation.shade(hard, relief).min() < -0.01
        lit = evaluation.shade(hard, relief, "nonnegative")
        assert lit.min() >= -1e-12
        alone = evaluation.evaluate(hard.weights[:1, :1], texels.world_normals(hard.frames[0, 0], relief), "nonnegative")
        assert np.abs(lit - alone).max() < 1e-9
        assert evaluation.shade(hard, relief, "clamped").min() == 0.0


def test_a_file_gives_back_its_lightmap(tmp_path: Path) -> None:
    lightmap = ramp(3, 2, 3)
    data = files.write(lightmap)
    assert data == files.write(lightmap)
    (tmp_path / "wall.npz").write_bytes(data)
    again = files.read(tmp_path / "wall.npz")
    assert np.abs(again.weights - lightmap.weights).max() < 1e-6 * lightmap.weights.max()
    assert np.array_equal(again.frames, lightmap.frames)
    assert np.array_equal(again.covered, lightmap.covered)
    with np.load(io.BytesIO(data)) as held:
        assert list(held) == ["format", "weights", "packed", "tangent", "bitangent", "normal", "covered"]
        assert np.abs(held["packed"] - lightmap.packed).max() < 1e-6 * lightmap.packed.max()
        assert held["weights"].dtype == np.float32


@pytest.mark.parametrize(
    ("edit", "told"),
    [
        ({"weights": None}, "no array 'weights'"),
        ({"format": np.array(2)}, "has format 2"),
        ({"normal": np.zeros((3, 2, 3))}, "not unit vectors"),
        ({"weights": np.zeros((3, 2, 3, 5))}, "is no lightmap"),
        ({"weights": np.full((3, 2, 3, 4), np.inf)}, "not finite"),
        ({"covered": np.ones(3, bool)}, "frames or cover"),
    ],
)
def test_a_bad_file_is_refused(edit: dict[str, object], told: str, tmp_path: Path) -> None:
    with np.load(io.BytesIO(files.write(ramp(3, 2)))) as held:
        arrays = {**dict(held), **edit}
    np.savez(tmp_path / "bad.npz", **{name: value for name, value in arrays.items() if value is not None})
    with pytest.raises(UserError, match=told):
        files.read(tmp_path / "bad.npz")
    (tmp_path / "text.npz").write_text("none")
    with pytest.raises(UserError, match="is no lightmap"):
        files.read(tmp_path / "text.npz")


def test_lightmaps_lose_what_the_page_says() -> None:
    """One of its suns, measured again."""
    rows = table_of("lightmaps")
    found = lightmaps.errors(lightmaps.street(), lightmaps.SUNS[1])
    assert [row[0] for row in rows] == list(found)
    for row in rows:
        rms, worst = (float(number) for number in re.findall(r"[\d.e+]+(?= %)", row[2]))
        assert rms == pytest.approx(100 * found[row[0]][0], rel=0.06, abs=0.02), row
        assert worst == pytest.approx(100 * found[row[0]][1], rel=0.1, abs=0.1), row


def test_lobes_in_a_scene_lose_what_the_page_says() -> None:
    """One of the suns, measured again."""
    rows = table_of("glossy-shadowed")
    found = lightmaps.glossy_errors(lightmaps.street(), lightmaps.SUNS[0])
    assert [(row[0], row[1]) for row in rows] == [(f"cos^{n}", str(bands)) for n, bands in found]
    for row, error in zip(rows, found.values(), strict=True):
        assert float(row[2].removesuffix(" %")) == pytest.approx(100 * error, rel=0.06, abs=0.05), row


def test_a_baked_street_is_what_paths_find() -> None:
    """Paths that bounce five times, without transfer, vertices or expansions: the facade's own normals, all texels."""
    street = lightmaps.street()
    weights, seen = environment(80.0, 0.0)
    made = precompute(street.mesh, Options(bands=7, rays=256, gather_rays=128, bounces=3))
    leaving = street.mesh.albedo * np.einsum("vcw,cw->vc", made.transfer, weights[:, :49])
    normals = street.texels.frames[..., 2, :]
    baked = incident.bake(street.mesh, street.rays, street.texels, seen.radiance, leaving, 7, incident.Sampling(2048))
    found = evaluation.evaluate(baked, normals).reshape(-1, 3)
    flat, none = normals.reshape(-1, 3), np.zeros((24, 3))
    points = Points(street.texels.points.reshape(-1, 3), flat, flat, none, none.astype(np.int64), none)
    exact = np.pi * arriving(Surface(street.mesh), points, seen.radiance, [], Paths(2048, 4, 3), 0)
    assert relative_rms(found, exact) < 0.01


OBJ = """v -4 -4 0
v 4 -4 0
v 4 4 0
v -4 4 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
g floor
f 1/1 2/2 3/3
f 1/1 3/3 4/4
"""
SKY = ROOT / "reports" / "reference" / "export" / "skylight_sh.npz"
SUN = ("--sun-zenith", "0.8", "--turbidity", "3")


def called(*arguments: object) -> Result:
    return CliRunner().invoke(main, ["lightmap", *map(str, arguments)])


@pytest.mark.parametrize("fit", [(), ("--fit", "40")])
def test_the_command_bakes_an_open_floor(fit: tuple[str, ...], tmp_path: Path) -> None:
    """Its irradiance is that of the table's own weights, which rays only sample; all texels alike."""
    (tmp_path / "floor.obj").write_text(OBJ)
    output = tmp_path / "floor.npz"
    done = called(
        tmp_path / "floor.obj", SKY, "--part", "floor", "--rows", 2, "--columns", 3, *SUN, *fit, "--output", output
    )
    assert done.exit_code == 0, done.output
    assert "2 x 3 texels, 6 covered, 3 bands" in done.output
    found = files.read(output)
    light = load(SKY).weights(sun_zenith=0.8, sun_azimuth=0.0, turbidity=3.0)
    exact = sphere.evaluate(sphere.irradiance(light), UP[np.newaxis])[:, 0]
    lit = evaluation.shade(found, np.broadcast_to(UP, (2, 3, 3)))
    assert np.abs(lit / exact - 1).max() < (0.02 if fit else 0.05)


@pytest.mark.parametrize(
    ("edit", "told"),
    [
        ({"--part": "roof"}, "none of that name"),
        ({"--fit": 90}, "Invalid --fit 90"),
        ({"--sun-zenith": None}, "sun_zenith=VALUE is missing"),
        ({"--sun-zenith": "nan"}, "finite"),
        ({"--bands": 1}, "1 is not in the range"),
    ],
)
def test_the_command_says_what_is_wrong(edit: dict[str, object], told: str, tmp_path: Path) -> None:
    (tmp_path / "floor.obj").write_text(OBJ)
    options = {"--part": "floor", "--sun-zenith": 0.8, "--turbidity": 3, "--output": tmp_path / "x.npz", **edit}
    words = [word for name, value in options.items() if value is not None for word in (name, value)]
    done = called(tmp_path / "floor.obj", SKY, *words)
    assert done.exit_code == 2
    assert told in done.output
    assert not (tmp_path / "x.npz").exists()
