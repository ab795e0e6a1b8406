"""The courtyard: closed solids that face outwards, colours that exist, and as many vertices as it says."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh.mesh import Mesh, studies, textures
from skylight_sh.mesh.courtyard import courtyard, views

# Floors, and what has one for its lid.
OPEN = {"terrace", "terrace floor", "paving", "earth"}


@pytest.fixture(scope="module")
def mesh() -> Mesh:
    return courtyard()


def own(mesh: Mesh, name: str) -> NDArray[np.int64]:
    """Return the triangles of a part."""
    return mesh.triangles[mesh.part == [part.name for part in mesh.parts].index(name)]


def unmatched(mesh: Mesh, triangles: NDArray[np.int64]) -> int:
    """Count directed edges, by place, that lack their opposite."""
    _, place = np.unique(np.round(mesh.positions, 6), axis=0, return_inverse=True)
    corners = place.ravel()[triangles]
    edges = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    count = len(mesh.positions)
    there, back = edges[:, 0] * count + edges[:, 1], edges[:, 1] * count + edges[:, 0]
    return int(np.setxor1d(there, back).size) + sum(
        int((np.unique(e, return_counts=True)[1] > 1).sum()) for e in (there, back)
    )


def volume(mesh: Mesh, triangles: NDArray[np.int64]) -> float:
    a, b, c = mesh.positions[triangles].transpose(1, 0, 2)
    return float(np.einsum("nk,nk->", a, np.cross(b, c)) / 6.0)


def test_there_are_about_21_000_vertices(mesh: Mesh) -> None:
    assert 20_500 <= len(mesh.positions) <= 21_500
    assert np.array_equal(np.unique(mesh.triangles), np.arange(len(mesh.positions)))
    assert [mesh.part.min(), mesh.part.max()] == [0, len(mesh.parts) - 1]


@pytest.mark.parametrize(("detail", "least", "most"), [(0.5, 0.25, 0.6), (1.5, 1.5, 2.25)])
def test_detail_counts_by_less_than_its_square(mesh: Mesh, detail: float, least: float, most: float) -> None:
    other = courtyard(detail)
    assert least < len(other.positions) / len(mesh.positions) < most
    assert [part.name for part in other.parts] == [part.name for part in mesh.parts]
    for part in other.parts:
        assert part.name in OPEN or unmatched(other, own(other, part.name)) == 0


def test_solids_are_closed_and_face_outwards(mesh: Mesh) -> None:
    names = {part.name for part in mesh.parts}
    assert len(names) == len(mesh.parts)
    assert names > OPEN
    for name in names - OPEN:
        assert unmatched(mesh, own(mesh, name)) == 0, name
        assert volume(mesh, own(mesh, name)) > 1e-3, name
    assert all(unmatched(mesh, own(mesh, name)) > 0 for name in OPEN)
    for name in OPEN - {"terrace"}:
        assert mesh.facing[mesh.part == [part.name for part in mesh.parts].index(name), 2].min() > 0.999, name


def test_a_column_weighs_what_its_profile_says(mesh: Mesh) -> None:
    # By Pappus: a ring of frustums of 16 sides, between a plinth and an abacus.
    from skylight_sh.mesh.courtyard._arcade import _COLUMN

    radius, height = np.array(_COLUMN).T
    frustums = (height[1:] - height[:-1]) * (radius[1:] ** 2 + radius[1:] * radius[:-1] + radius[:-1] ** 2) / 3.0
    sides = 16 / 2.0 * np.sin(2.0 * np.pi / 16)
    boxes = 0.58**2 * (0.14 - 0.003) + 0.57**2 * (2.5 - 0.003 - 2.352)
    assert volume(mesh, own(mesh, "column 1")) == pytest.approx(frustums.sum() * sides + boxes, rel=1e-5)


def test_normals_are_units_that_agree_with_their_faces(mesh: Mesh) -> None:
    assert np.abs(np.linalg.norm(mesh.normals, axis=1) - 1.0).max() < 1e-12
    agreement = np.einsum("tk,tck->tc", mesh.facing, mesh.normals[mesh.triangles])
    assert agreement.min() > 0.2
    # Sharper bends are creases.
    assert np.quantile(agreement, 0.02) > np.cos(np.radians(40.0))


def test_no_triangle_is_degenerate(mesh: Mesh) -> None:
    a, b, c = mesh.corners.transpose(1, 0, 2)
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    longest = np.max([np.linalg.norm(b - a, axis=1), np.linalg.norm(c - b, axis=1), np.linalg.norm(a - c, axis=1)], axis=0)
    assert area.min() > 1e-7
    assert (2.0 * area / longest**2).min() > 1e-3


def test_colours_are_those_of_matter(mesh: Mesh) -> None:
    assert mesh.albedo.min() > 0.02
    for k, part in enumerate(mesh.parts):
        colour = mesh.albedo[np.unique(mesh.triangles[mesh.part == k])].max(axis=0)
        if part.texture is not None:
            assert part.texture.min() > 0.05
            colour = colour * part.texture.reshape(-1, 3).max(axis=0)
        assert colour.max() < 0.85, part.name


def test_it_is_the_same_each_time(mesh: Mesh) -> None:
    other = courtyard()
    for name in ("positions", "normals", "albedo", "triangles", "part", "uv"):
        assert np.array_equal(getattr(mesh, name), getattr(other, name)), name


def test_the_ground_reaches_the_horizon(mesh: Mesh) -> None:
    far = mesh.positions[own(mesh, "earth")].reshape(-1, 3)
    assert np.degrees(1.75 / np.linalg.norm(far[:, :2], axis=1).max()) < 0.4
    assert mesh.positions[:, 2].min() > -0.05


@pytest.mark.parametrize("view", [views.ENTRANCE, views.WALK, views.BENCH])
def test_views_are_a_walkers(mesh: Mesh, view: views.View) -> None:
    assert view.eye[2] == pytest.approx(1.75, abs=0.2)
    assert 37.0 <= view.field <= 42.0
    # Nothing stands in one's way.
    near = mesh.positions[np.abs(mesh.positions[:, 2] - view.eye[2]) < 0.5] - view.eye
    assert np.linalg.norm(near[:, :2], axis=1).min() > 0.4


@pytest.mark.parametrize("make", [studies.wall_with_relief, studies.cavities, studies.hall])
def test_studies_are_closed_solids_on_a_floor(make: Callable[[], Mesh]) -> None:
    mesh = make()
    for part in mesh.parts:
        inside = unmatched(mesh, own(mesh, part.name)) == 0
        assert inside == (part.name != "floor"), part.name
        assert not inside or volume(mesh, own(mesh, part.name)) > 1e-3, part.name
    agreement = np.einsum("tk,tck->tc", mesh.facing, mesh.normals[mesh.triangles])
    assert agreement.min() > 0.3
    assert mesh.positions[:, 2].min() == 0.0


def test_a_ball_has_its_volume() -> None:
    mesh = studies.cavities()
    # 36 meridians and 21 bands lose this share of a sphere, to second order: 2 / 3 (pi / 36)^2 + (pi / 42)^2 / 2 or so.
    assert volume(mesh, own(mesh, "blue ball")) == pytest.approx(4.0 / 3.0 * np.pi * 0.17**3, rel=0.02)


def test_lamps_hang_clear() -> None:
    mesh = studies.hall()
    places = np.array(studies.LAMPS)
    assert places.shape == (10, 3)
    # No vertex nearer than a lamp's radius; flat faces are nowhere wider than their vertices' spacing.
    away = np.linalg.norm(mesh.positions[:, np.newaxis] - places, axis=-1)
    assert away.min() > 0.25


def relief_slopes(relief: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(-relief[..., :2] / relief[..., 2:])


def test_a_relief_has_the_slopes_of_its_height() -> None:
    # A wave along u, three times in 2 m, and one along v, twice.
    pixels, side, low = 256, 2.0, 0.003
    u = (np.arange(pixels) + 0.5) / pixels * side
    v = u[::-1, np.newaxis]
    height = low * (np.sin(3.0 * np.pi * u) + np.sin(2.0 * np.pi * v))
    slopes = relief_slopes(textures.relief(height, side))
    expected = np.stack(np.broadcast_arrays(3.0 * np.cos(3.0 * np.pi * u), 2.0 * np.cos(2.0 * np.pi * v)), axis=-1)
    assert np.abs(slopes - low * np.pi * expected).max() < 1e-4


@pytest.mark.parametrize("make", [studies.wall_with_relief, courtyard])
def test_reliefs_are_unit_normals_that_face_outwards(make: Callable[[], Mesh]) -> None:
    wall = make().parts[0]
    assert wall.relief is not None
    assert np.abs(np.linalg.norm(wall.relief, axis=-1) - 1.0).max() < 1e-12
    assert wall.relief[..., 2].min() > 0.1
    # The mean slope of what repeats is none.
    assert np.abs(relief_slopes(wall.relief).mean(axis=(0, 1))).max() < 1e-9


def test_a_walls_texture_is_laid_on_along_its_tangents() -> None:
    mesh = studies.wall_with_relief()
    front = mesh.triangles[(mesh.part == 0) & (mesh.facing[:, 1] < -0.999)]
    (a, b, c), (p, q, r) = (np.moveaxis(values[front], 1, 0) for values in (mesh.positions, mesh.uv))
    # Areas on the wall and in the texture have one ratio and one sense.
    flat = (q - p)[:, 0] * (r - p)[:, 1] - (q - p)[:, 1] * (r - p)[:, 0]
    solid = -np.cross(b - a, c - a)[:, 1]
    assert np.allclose(solid / flat, 1.2**2, rtol=1e-4)
