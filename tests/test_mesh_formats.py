"""OBJ and PLY against trimesh and by hand; files beside a mesh; and files with errors strewn over them."""

from __future__ import annotations

import json
import time
from pathlib import Path

import numpy as np
import pytest
import trimesh
from meshes import CUBE, QUADS, TRIANGLES, Gltf, cube_gltf, kinds, obj, ply, read, volume
from numpy.typing import NDArray
from skylight_sh import UserError, mesh
from skylight_sh.mesh.findings import told
from skylight_sh.run.mesh_source import MeshSource
from skylight_sh.transfer.options import Options

Array = NDArray[np.float64]


@pytest.mark.parametrize("ending", ["obj", "ply", "glb"])
def test_a_mesh_that_trimesh_writes_is_read_as_it_was(tmp_path: Path, ending: str) -> None:
    ring = trimesh.creation.torus(2.0, 0.7, major_sections=24, minor_sections=12)
    normals = ring.vertex_normals.copy()
    path = tmp_path / f"ring.{ending}"
    wanted = {"vertex_normal": True} if ending == "ply" else {"include_normals": True}
    data = ring.export(file_type=ending, **wanted)
    path.write_bytes(data if isinstance(data, bytes) else data.encode())
    made, found = mesh.read(path, "z")
    assert np.allclose(made.corners, ring.vertices[ring.faces], atol=1e-6)
    assert np.allclose(made.normals[made.triangles], normals[ring.faces], atol=1e-6)
    assert volume(made) == pytest.approx(ring.volume, rel=1e-5)
    assert kinds((made, found)) == {}


def test_objects_groups_and_materials_name_parts(tmp_path: Path) -> None:
    (tmp_path / "two words.mtl").write_text("newmtl red\nKd 0.8 0.1 0.05\nnewmtl grey\nKd 0.25\nTr 0.5\nillum 2\n")
    text = "mtllib two words.mtl\n# a comment\n" + obj(CUBE, [])
    faces = ["f " + " \\\n ".join(str(i + 1) for i in quad) for quad in QUADS]
    text += "\n".join([
        "o house", "usemtl red", "s 1", faces[0], faces[1], "usemtl grey", faces[2],
        "g roof", "usemtl red", faces[3], "o garden", faces[4], "usemtl lost", faces[5], "o house", "usemtl red",
    ])  # fmt: skip
    made, found = read(tmp_path / "named.obj", text + "\n" + obj(CUBE, [[0, 1, 2]], 1))
    # An object that comes back goes on where it was.
    assert [part.name for part in made.parts] == ["house/red", "house/grey", "house/roof", "garden/red", "garden/lost"]
    assert np.bincount(made.part).tolist() == [5, 2, 2, 2, 2]
    albedo = [np.unique(made.albedo[made.triangles[made.part == i]].reshape(-1, 3), axis=0).tolist() for i in range(5)]
    assert albedo == [[[0.8, 0.1, 0.05]], [[0.25] * 3], [[0.8, 0.1, 0.05]], [[0.8, 0.1, 0.05]], [[0.5] * 3]]
    assert {
        (one.part, one.kind, one.healed) for one in found if one.kind in ("no material", "transparent", "no albedo")
    } == {
        ("garden/lost", "no material", False),
        ("garden/lost", "no albedo", True),
        ("house/grey", "transparent", False),
    }


def test_colours_of_vertices_are_srgb_where_they_are_whole_numbers(tmp_path: Path) -> None:
    """A half of sRGB is 0.2140 of the light (IEC 61966-2-1)."""
    half = ((0.5 + 0.055) / 1.055) ** 2.4
    lines = [f"{line} 0.5 0.5 0.5" if line.startswith("v") else line for line in obj(CUBE, QUADS).splitlines()]
    assert np.allclose(read(tmp_path / "a.obj", "\n".join(lines))[0].albedo, half)
    for kind, values, expected in (
        ("uchar", "188 0 255", [((188 / 255 + 0.055) / 1.055) ** 2.4, 0.0, 1.0]),
        ("float", "0.5 0 1", [0.5, 0, 1]),
    ):
        table = (
            ply(CUBE, QUADS)
            .decode()
            .replace("double z\n", "double z\n" + "".join(f"property {kind} {c}\n" for c in ("red", "green", "blue")))
        )
        head, _, body = table.partition("end_header\n")
        rows = body.splitlines()
        rows[:8] = [f"{row} {values}" for row in rows[:8]]
        assert np.allclose(read(tmp_path / "a.ply", head + "end_header\n" + "\n".join(rows))[0].albedo, expected)


def test_elements_that_are_not_wanted_are_passed_over(tmp_path: Path) -> None:
    table = ply(CUBE, QUADS).replace(
        b"element face", b"element strip 2\nproperty list uchar int a\nproperty float b\nelement face"
    )
    head, _, body = table.partition(b"end_header\n")
    rows = body.splitlines()
    text = head + b"end_header\n" + b"\n".join([*rows[:8], b"2 7 7 0.5", b"0 0.5", *rows[8:]])
    assert volume(read(tmp_path / "more.ply", text)[0]) == pytest.approx(1.0)


def test_all_files_of_a_mesh_are_named(tmp_path: Path) -> None:
    """What a result hangs on: materials, buffers and pictures too."""
    (tmp_path / "a.mtl").write_text("newmtl x\nmap_Kd a.png\nnorm lost.png\n")
    (tmp_path / "a.png").write_bytes(b"")
    (tmp_path / "a.bin").write_bytes(b"")
    (tmp_path / "a.obj").write_text("mtllib a.mtl\nmtllib lost.mtl\n")
    (tmp_path / "a.ply").write_bytes(ply(CUBE, QUADS).replace(b"1.0\n", b"1.0\ncomment TextureFile a.png\n", 1))
    root = {
        **cube_gltf().root,
        "buffers": [{"uri": "a.bin"}, {"uri": "data:,x"}],
        "images": [{"uri": "a.png"}, {"bufferView": 0}],
    }
    (tmp_path / "a.gltf").write_text(json.dumps(root))
    (tmp_path / "bad.glb").write_bytes(b"glTF")
    for name, expected in (
        ("a.obj", ["a.obj", "a.mtl", "a.png"]),
        ("a.ply", ["a.ply", "a.png"]),
        ("a.gltf", ["a.gltf", "a.bin", "a.png"]),
        ("bad.glb", ["bad.glb"]),
    ):
        assert mesh.files(tmp_path / name) == tuple(tmp_path / one for one in expected)
    assert mesh.files(tmp_path / "lost.obj") == (tmp_path / "lost.obj",)


def test_many_parts_are_told_in_one_sentence(tmp_path: Path) -> None:
    text = "".join(f"o box {i}\n{obj(CUBE + 2.0 * i, QUADS[i % 2 :], 8 * i + 1)}" for i in range(9))
    sentences = told(read(tmp_path / "many.obj", text)[1])
    assert len(sentences) == 3
    assert sentences[-1].endswith("Likewise in 3 other parts, 16 in all.")


def sphere(rings: int) -> tuple[Array, list[list[int]]]:
    """A sphere of quadrilaterals and two polygons."""
    polar, turn = np.meshgrid(np.linspace(0.0, np.pi, rings + 2)[1:-1], np.arange(2 * rings) * np.pi / rings, indexing="ij")
    points = np.stack([np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), np.cos(polar)], axis=-1).reshape(-1, 3)
    n = 2 * rings
    faces = [
        [i * n + j, (i + 1) * n + j, (i + 1) * n + (j + 1) % n, i * n + (j + 1) % n]
        for i in range(rings - 1)
        for j in range(n)
    ]
    return points, [*faces, list(range(n)), list(range(len(points) - 1, len(points) - 1 - n, -1))]


@pytest.mark.parametrize("ending", ["obj", "ply", "glb"])
def test_a_hundred_thousand_triangles_take_seconds(tmp_path: Path, ending: str) -> None:
    points, faces = sphere(158)
    made = Gltf(nodes=[{"mesh": 0}])
    flat = [[f[0], f[i], f[i + 1]] for f in faces for i in range(1, len(f) - 1)]
    attributes = {"POSITION": made.accessor(points)}
    made.root["meshes"] = [{"primitives": [{"attributes": attributes, "indices": made.accessor(np.ravel(flat), "u4")}]}]
    content = {"obj": lambda: obj(points, faces), "ply": lambda: ply(points, flat), "glb": made.glb}[ending]()
    before = time.process_time()
    found = read(tmp_path / f"sphere.{ending}", content)
    # A second on an idle core; the bound is for a busy one.
    assert time.process_time() - before < 6.0
    assert len(found[0].triangles) == len(flat) > 99_000
    assert volume(found[0]) == pytest.approx(4.0 * np.pi / 3.0, rel=1e-3)
    assert kinds(found) == {}


WORDS = [b"-1", b"1e400", b"nan", b"99999999999999999999", b"null", b"{}", b"[]", b'""', b"0", b"-0.5", b"\xff", b"[[["]


def seeds() -> list[tuple[str, bytes]]:
    """Files with something of everything that readers know."""
    made = cube_gltf(
        materials=[{"name": "m", "pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 1]}}],
        nodes=[{"mesh": 0, "scale": [-1, 1, 1], "children": [1]}, {"mesh": 0, "rotation": [0, 0, 0, 1]}],
        scenes=[{"nodes": [0]}],
    )
    attributes = made.root["meshes"][0]["primitives"][0]["attributes"]
    attributes |= {
        "NORMAL": made.accessor(CUBE - 0.5),
        "COLOR_0": made.accessor(200 * np.ones((8, 3)), "u1", normalized=True),
    }
    made.root["meshes"][0]["primitives"][0]["material"] = 0
    made.root["accessors"][0]["sparse"] = {
        "count": 2,
        "indices": {"bufferView": made.view(b"\x00\x01"), "componentType": 5121},
        "values": {"bufferView": made.view(CUBE[:2].astype("<f4").tobytes())},
    }
    text = "o a\nusemtl x\n" + obj(CUBE, QUADS) + "vn 0 0 1\nvt 0 1\nf 1/1/1 2/1/1 3//1\nf -1 -2 -3\n"
    tables = [ply(CUBE, TRIANGLES, kind) for kind in ("ascii", "binary_little_endian", "binary_big_endian")]
    tables.append(ply(CUBE, [*QUADS[:3], *TRIANGLES[6:]], "binary_little_endian"))
    return [
        ("obj", text.encode()),
        ("glb", made.glb()),
        ("gltf", made.text().encode()),
        *(("ply", table) for table in tables),
    ]


def damaged(data: bytes, random: np.random.Generator) -> bytes:
    """Cut a file short, flip some of its bits, or put another word in place of a digit."""
    how, spoilt = random.integers(3), bytearray(data)
    if how == 0:
        return data[: random.integers(len(data))]
    for _ in range(random.integers(1, 5)):
        at = int(random.integers(len(spoilt)))
        if how == 1:
            spoilt[at] ^= 1 << int(random.integers(8))
        else:
            digits = [i for i, byte in enumerate(spoilt[:2000]) if 48 <= byte < 58] or [0]
            at = digits[random.integers(len(digits))]
            spoilt[at : at + 1] = WORDS[random.integers(len(WORDS))]
    return bytes(spoilt)


def test_damaged_files_are_refused_or_are_meshes(tmp_path: Path) -> None:
    random, refused, end = np.random.default_rng(7), 0, time.monotonic() + 4.0
    files = seeds()
    for count in range(1200):
        ending, data = files[count % len(files)]
        path = tmp_path / f"damaged.{ending}"
        path.write_bytes(damaged(data, random))
        try:
            made, _ = mesh.read(path)
        except UserError as error:
            refused += str(path) in str(error)
            continue
        assert np.isfinite(made.positions).all()
        assert np.isfinite(made.facing).all()
        assert np.allclose(np.linalg.norm(made.normals, axis=-1), 1.0)
        assert made.albedo.min() >= 0.0
        assert made.albedo.max() <= 1.0
        assert made.triangles.max() < len(made.positions)
        if time.monotonic() > end and count > 200:
            break
    assert refused > 100


def test_a_transfer_hangs_on_the_files_beside_its_mesh(tmp_path: Path) -> None:
    (tmp_path / "a.mtl").write_text("newmtl x\nKd 0.1 0.1 0.1\n")
    (tmp_path / "a.obj").write_text("mtllib a.mtl\nusemtl x\n" + obj(CUBE, QUADS))
    source = MeshSource(tmp_path / "a.obj", Options())
    before = source.parameters()
    assert source.parameters() == before
    (tmp_path / "a.mtl").write_text("newmtl x\nKd 0.9 0.9 0.9\n")
    assert source.parameters() != before
