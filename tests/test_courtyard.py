"""The courtyard: closed solids that face outwards, colours that exist, and as many vertices as it says."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh.mesh import Mesh
from skylight_sh.mesh.courtyard import ENTRANCE, WALK, courtyard, views

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


@pytest.mark.parametrize("view", [ENTRANCE, WALK])
def test_views_are_a_walkers(view: views.View) -> None:
    assert view.eye[2] == pytest.approx(1.75, abs=0.2)
    assert 37.0 <= view.field <= 42.0
