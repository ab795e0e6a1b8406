"""What rays find in meshes: walls that are inside out, vertices within solids, sheets that coincide."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from meshes import CUBE, QUADS, obj, read
from skylight_sh import mesh, transfer
from skylight_sh.transfer import inspection
from skylight_sh.transfer.start_points import start_points


def found(made: mesh.Mesh) -> dict[tuple[str, str], int]:
    rays = transfer.Rays(made)
    told = inspection.inspect(made, rays, start_points(made, rays))
    assert all(one.part in one.sentence for one in told)
    return {(one.part, one.kind): one.count for one in told}


def grid(count: int, size: float, height: float) -> tuple[np.ndarray, list[list[int]]]:
    """A floor of quadrilaterals about the origin, facing up."""
    at = np.linspace(-size, size, count + 1)
    points = np.array([[x, y, height] for y in at for x in at])
    n = count + 1
    return points, [
        [j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i] for j in range(count) for i in range(count)
    ]


def scene(tmp_path: Path, *named: tuple[str, np.ndarray, list[list[int]]], scale: float = 1.0) -> mesh.Mesh:
    text, start = "", 1
    for name, points, faces in named:
        text += f"o {name}\n{obj(scale * points, faces, start)}"
        start += len(points)
    return read(tmp_path / "scene.obj", text)[0]


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_a_wall_that_is_inside_out_is_seen_from_behind(tmp_path: Path, scale: float) -> None:
    floor = grid(8, 4.0, 0.0)
    wall = np.array([[-4.0, 4, 0.01], [4, 4, 0.01], [4, 4, 4], [-4, 4, 4]])
    for faces, expected in (([[0, 1, 2, 3]], {}), ([[3, 2, 1, 0]], {"wall"})):
        told = found(scene(tmp_path, ("floor", *floor), ("wall", wall, faces), scale=scale))
        assert {part for part, kind in told if kind == "seen from behind"} == set(expected)


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_vertices_within_a_solid_are_counted(tmp_path: Path, scale: float) -> None:
    floor, box = grid(9, 4.0, 0.0), CUBE * 2.0 - [1.0, 1.0, 0.5]
    told = found(scene(tmp_path, ("floor", *floor), ("box", box, QUADS), scale=scale))
    # Four of the floor's vertices lie within the box; the feet of the box's sides see the floor
    # from below, those of its bottom look into the void.
    assert told[("floor", "buried")] == 4
    assert told[("box", "buried")] == 8
    assert {kind for _, kind in told} == {"buried"}


def test_a_part_within_another_is_buried_whole(tmp_path: Path) -> None:
    told = found(scene(tmp_path, ("out", 4.0 * CUBE, QUADS), ("in", CUBE + 1.0, QUADS)))
    assert told == {("in", "buried part"): 24}


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_sheets_that_coincide_are_counted_however_they_are_cut(tmp_path: Path, scale: float) -> None:
    fine, coarse = grid(6, 1.0, 1.0), grid(1, 1.0, 1.0)
    told = found(scene(tmp_path, ("fine", *fine), ("coarse", *coarse), scale=scale))
    # A ray at the middle of one meets it or what lies on it; whichever it is, the other is counted.
    assert sum(count for (_, kind), count in told.items() if kind == "coincident sheets") >= 2
    upside_down = (coarse[0], [face[::-1] for face in coarse[1]])
    assert found(scene(tmp_path, ("fine", *fine), ("coarse", *upside_down), scale=scale)) == {}
    apart = (fine[0] + [0.0, 0.0, 1e-3], fine[1])
    # The lower one sees the upper one's back.
    assert found(scene(tmp_path, ("fine", *apart), ("coarse", *coarse), scale=scale)) == {("coarse", "buried part"): 4}
