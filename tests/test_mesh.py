"""Meshes read from files: what is in them, what is healed and told, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from meshes import CUBE, QUADS, TRIANGLES, cube_gltf, kinds, obj, ply, read, volume
from skylight_sh import mesh

KINDS = ("ascii", "binary_little_endian", "binary_big_endian")


def cubes(tmp_path: Path) -> dict[str, Path]:
    """The same cube in every way of writing it."""
    files = {"quads.obj": obj(CUBE, QUADS).encode(), "triangles.obj": obj(CUBE, TRIANGLES).encode()}
    files |= {f"{kind}{len(faces)}.ply": ply(CUBE, faces, kind) for kind in KINDS for faces in (QUADS, TRIANGLES)}
    files |= {"box.glb": cube_gltf().glb(), "box.gltf": cube_gltf().text().encode()}
    files["mixed.ply"] = ply(CUBE, [*QUADS[:3], *TRIANGLES[6:]], "binary_little_endian")
    files["negative.obj"] = obj(CUBE, QUADS, -8).encode()
    for name, data in files.items():
        (tmp_path / name).write_bytes(data)
    return {name: tmp_path / name for name in files}


def test_a_cube_is_a_cube_in_every_format(tmp_path: Path) -> None:
    for name, path in cubes(tmp_path).items():
        found, told = mesh.read(path)
        assert volume(found) == pytest.approx(1.0), name
        assert len(found.triangles) == 12
        assert len(found.positions) == 24
        # Each face has its own normals, those of its triangles.
        assert np.array_equal(found.normals[found.triangles], np.repeat(found.facing[:, np.newaxis], 3, axis=1))
        assert np.allclose(np.linalg.norm(found.facing, axis=-1), 1.0)
        assert [part.name for part in found.parts] == [path.stem]
        assert kinds((found, told)) == {}
        assert {(one.kind, one.count) for one in told} == {("no albedo", 8), ("no normals", 8)}


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_an_inverted_part_is_turned_at_any_scale_and_place(tmp_path: Path, scale: float) -> None:
    wound = [face[::-1] for face in QUADS]
    found = read(tmp_path / "cube.obj", obj(scale * (CUBE + 100.0), wound))
    assert volume(found[0]) == pytest.approx(scale**3, rel=1e-6)
    assert kinds(found) == {"inverted": 12}
    assert found[0].normals[:, 2].max() == 1.0
    assert np.allclose(found[0].normals[found[0].triangles[:, 0]], found[0].facing)
