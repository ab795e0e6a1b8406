"""Bad meshes, each a file: what is healed and told with its part and count, what is told and left, and what is refused."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT
from meshes import CUBE, QUADS, TRIANGLES, Gltf, cube_gltf, kinds, obj, ply, read, volume
from skylight_sh import UserError, mesh
from skylight_sh.mesh import orientation, polygons, topology
from skylight_sh.mesh.formats import obj as obj_format
from skylight_sh.mesh.formats import protocol

SQUARE = np.array([[0.0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]])
LINED = "vn 0 0 1\n"


def boxes(*placed: tuple[float, float, bool]) -> str:
    """Cubes of a size, at a shift, wound inward or not, in one part."""
    text = ""
    for i, (size, shift, inward) in enumerate(placed):
        text += obj(size * CUBE + shift, [q[::-1] if inward else q for q in QUADS], 8 * i + 1)
    return text


def square(normal: str) -> str:
    """A square of two triangles that faces up, with one normal."""
    return obj(SQUARE, []) + f"vn {normal}\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n"


# A file, and how often each kind of finding is counted.
HEALED: dict[str, tuple[str, dict[str, int]]] = {
    "zero area": (obj(CUBE, [*QUADS, [0, 1, 1], [0, 0, 0]]), {"zero area": 2}),
    "collinear": (obj(np.vstack([CUBE, [[0.5, 0, 0]]]), [*QUADS, [0, 1, 8]]), {"zero area": 1}),
    "sliver": (obj(np.vstack([CUBE, [[0.3, 0.3, 0.3 + 1e-9]]]), [*QUADS, [0, 6, 8]]), {"zero area": 1}),
    "speck": (
        obj(np.vstack([CUBE, 0.5 + 1e-8 * CUBE[:4]]), [*QUADS, [8, 9, 10]]),
        {"zero area": 1},
    ),
    "duplicate faces": (obj(CUBE, [*TRIANGLES, TRIANGLES[0], np.roll(TRIANGLES[3], 1).tolist()]), {"duplicate": 2}),
    "unused vertices": (obj(np.vstack([CUBE, [[9.0, 9, 9], [np.nan, 0, np.inf]]]), QUADS), {"unused": 0}),
    "inverted": (boxes((1.0, 0.0, True)), {"inverted": 12}),
    "one of two inverted": (boxes((1.0, 0.0, False), (1.0, 5.0, True)), {"inverted": 12}),
    "cavity": (boxes((3.0, 0.0, False), (1.0, 1.0, True)), {}),
    "cavity of an inverted solid": (boxes((3.0, 0.0, True), (1.0, 1.0, False)), {"inverted": 24}),
    "solid in a cavity": (boxes((9.0, 0.0, False), (5.0, 1.0, True), (1.0, 2.0, True)), {"inverted": 12}),
    "one triangle turned": (obj(CUBE, [TRIANGLES[0][::-1], *TRIANGLES[1:]]), {"winding": 1}),
    "long normals": (square("0 0 7"), {"long normals": 4, "open edge": 4}),
    "zero normals": (square("0 0 0"), {"open edge": 4}),
    "NaN normals": (square("nan 0 1"), {"open edge": 4}),
    "opposing normals": (square("0 0 -1"), {"inverted": 2, "open edge": 4}),
    "few corners": (obj(CUBE, [*QUADS, [0, 1], [2]]), {"few corners": 2}),
    "albedo": (obj(CUBE, QUADS).replace("v 0.0 0.0 0.0", "v 0 0 0 1.5 0 0"), {"albedo": 1}),
    "duplicate vertices": (
        obj(CUBE[np.ravel(TRIANGLES)], np.arange(36).reshape(12, 3).tolist()),
        {"duplicate vertices": 28},
    ),
}
TOLD: dict[str, tuple[str, dict[str, int]]] = {
    "open box": (obj(CUBE, QUADS[1:]), {"open edge": 4}),
    # A room without a floor: its volume is negative, and it is not closed.
    "open and inward": (obj(CUBE, [face[::-1] for face in QUADS[1:]]), {"open edge": 4}),
    "narrow but not flat": (obj(np.array([[0.0, 0, 0], [1, 0, 0], [0.5, 1e-5, 0]]), [[0, 1, 2]]), {"open edge": 3}),
    "beside an edge": (
        obj(np.vstack([SQUARE, [[1.0, -0.001, 0], [0, -1, 0], [2, -1, 0]]]), [[0, 1, 2, 3], [5, 6, 4]]),
        {"open edge": 7},
    ),
    "T-junction": (
        obj(np.vstack([SQUARE, [[1.0, 0, 0], [0, -1, 0], [2, -1, 0]]]), [[0, 1, 2, 3], [5, 4, 0], [5, 6, 4], [6, 1, 4]]),
        # The square's own open edge, and those below: four sides, and both halves of the edge that meets the square.
        {"open edge": 9, "T-junction": 1},
    ),
    "coincident sheets": (obj(SQUARE, [[0, 1, 2, 3], [2, 1, 0, 3]]), {"coincident": 4, "non-manifold edge": 1}),
    "non-manifold edge": (obj(np.vstack([SQUARE, [[1.0, 1, 2]]]), [[0, 1, 2], [0, 2, 3], [0, 2, 4]]), {
        "non-manifold edge": 1, "open edge": 6,
    }),
    # A ridge of three sides, one of them large, whose shared normal looks along the small one's back.
    "slanted normals": (
        obj(np.array([[0.0, 0, 0], [9, 0, 0], [9, 9, 0], [0, 9, 0], [0, 0, -1], [9, 0, -1]]), [])
        + "vn 0 0.6 0.8\nvn 0 -1 0\nvn 0 0 1\nf 1//1 2//1 3//3\nf 1//1 3//3 4//3\nf 5//2 6//2 2//1\nf 5//2 2//1 1//1\n",
        {"slanted normals": 2, "open edge": 6},
    ),
    "y up": (obj(SQUARE[:, [0, 2, 1]] - [0, 0, 1], [[3, 2, 1, 0]]), {"up": 1, "open edge": 4}),
    "no material": ("usemtl red\n" + obj(CUBE, QUADS), {"no material": 1}),
    "no materials": ("mtllib lost.mtl\nusemtl red\n" + obj(CUBE, QUADS), {"no materials": 1}),
    "bright albedo": (
        "\n".join(f"{line} 0.99 0.99 0.99" if line.startswith("v") else line for line in obj(CUBE, QUADS).splitlines()),
        {"bright albedo": 8},
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", HEALED)
@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_what_is_healed_is_told_with_part_and_count(tmp_path: Path, name: str, scale: float) -> None:
    text, expected = HEALED[name]
    if scale != 1.0:
        text = re.sub(
            r"^v (\S+) (\S+) (\S+)", lambda m: "v " + " ".join(repr(scale * float(x)) for x in m.groups()), text, flags=re.M
        )
    made, told = read(tmp_path / "tried.obj", "o thing\n" + text)
    assert kinds((made, told)) == {kind: count for kind, count in expected.items() if count}
    assert all("'thing'" in one.sentence and f"{one.count:,}" in one.sentence for one in told)
    assert all(one.healed for one in told if one.kind != "open edge")
    assert np.allclose(np.linalg.norm(made.normals, axis=-1), 1.0)
    assert (np.einsum("ti,tki->tk", made.facing, made.normals[made.triangles]) > 0.0).all()
    if "open edge" not in expected:
        cavities = {"cavity": 26.0, "cavity of an inverted solid": 26.0, "solid in a cavity": 729.0 - 125 + 1}
        solid = cavities.get(name, 2.0 if name == "one of two inverted" else 1.0)
        assert volume(made) == pytest.approx(solid * scale**3, rel=1e-9)


@pytest.mark.parametrize("name", TOLD)
@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_what_is_unusual_is_told_and_left(tmp_path: Path, name: str, scale: float) -> None:
    text, expected = TOLD[name]
    text = re.sub(
        r"^v (\S+) (\S+) (\S+)", lambda m: "v " + " ".join(repr(scale * float(x)) for x in m.groups()), text, flags=re.M
    )
    made, told = read(tmp_path / "tried.obj", "o thing\n" + text)
    assert kinds((made, told)) == expected
    assert not any(one.healed for one in told if one.kind in expected)
    assert len(made.triangles) == text.count("\nf ") + sum(
        len(line.split()) > 4 for line in text.splitlines() if line[0] == "f"
    )


REFUSED = {
    "index.obj": (obj(CUBE, [*QUADS, [0, 1, 99]]), r"part 'index': 1 indices out of range, such as 99 .*from 0 to 7"),
    "back.obj": (obj(CUBE, QUADS) + "f -1 -2 -99\n", "1 indices out of range"),
    "zero.obj": (obj(CUBE, QUADS) + "f 0 1 2\n", "1 indices out of range, such as -1"),
    "uv.obj": (obj(CUBE, QUADS) + "vt 0 0\nf 1/1 2/1 3/2\n", "texture coordinates"),
    "normal.obj": (obj(CUBE, QUADS) + "f 1//1 2//1 3//1\n", "has 0 normals"),
    "nan.obj": (obj(CUBE, QUADS).replace("v 0.0 0.0 0.0", "v nan 0 0"), r"part 'nan': 1 vertices .* no number"),
    "inf.obj": (obj(CUBE, QUADS).replace("v 0.0 0.0 0.0", "v 0 inf 0"), "no number"),
    "huge.obj": (obj(1e200 * CUBE, QUADS), "1e.200 long"),
    "tiny.obj": (obj(1e-200 * CUBE, QUADS), "Export it in another unit"),
    "flat.obj": (obj(CUBE, [[0, 1, 1], [0, 0, 0]]), "All 2 triangles have no area"),
    "empty.obj": ("", "no triangles"),
    "points.obj": (obj(CUBE, []), "no triangles"),
    "lines.obj": (obj(CUBE, []) + "l 1 2\n", "no triangles"),
    "word.obj": (obj(CUBE, QUADS) + "f a b c\n", "no index"),
    "big.obj": (obj(CUBE, QUADS) + "f 1 2 99999999999999999999\n", "no index"),
    "short.obj": (obj(CUBE, QUADS) + "v 1 2\n", "line 15 cannot be read: 'v 1 2'"),
    "unknown.obj": (obj(CUBE, QUADS).replace("v 1.0 1.0 1.0", "w 1 1 1"), "line 7"),
    "curved.obj": (obj(CUBE, QUADS) + "cstype bezier\n", "curved"),
    "noise.obj": (bytes(range(256)), "line"),
    "noise.ply": (bytes(range(256)), "header"),
    "noise.glb": (b"glTF" + bytes(range(256)), "version"),
    "noise.gltf": (bytes(range(256)), "JSON"),
    "empty.ply": (b"", "header"),
    "cloud.ply": (ply(CUBE, QUADS).split(b"element face")[0] + b"end_header\n" + b"0 0 0\n" * 8, "points alone"),
    "count.ply": (ply(CUBE, QUADS).replace(b"vertex 8", b"vertex 7"), "header counts"),
    "count2.ply": (ply(CUBE, QUADS).replace(b"face 6", b"face 5"), "more follows"),
    "count3.ply": (ply(CUBE, QUADS, "binary_little_endian").replace(b"face 6", b"face 7"), "7 rows of the element 'face'"),
    "memory.ply": (ply(CUBE, QUADS).replace(b"vertex 8", b"vertex 999999999999"), "999,999,999,999 vertex rows"),
    "index.ply": (ply(CUBE, [*QUADS, [0, 1, 99]]), "part 'index'"),
    "word.ply": (ply(CUBE, QUADS).replace(b"0.0 0.0 0.0", b"0.0 zero 0.0"), "not all numbers"),
    "strips.ply": (ply(CUBE, QUADS).replace(b"element face 6", b"element tristrips 6"), "triangle strips"),
    "twice.ply": (ply(CUBE, QUADS).replace(b"double y", b"double x"), "something twice"),
    "truncated.obj": (obj(CUBE, QUADS)[:-3] + "\nf 1 2 3 4 5 6 7 88", "out of range"),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_what_would_give_wrong_light_is_refused(tmp_path: Path, name: str) -> None:
    content, told = REFUSED[name]
    with pytest.raises(UserError, match=told) as refused:
        read(tmp_path / name, content)
    assert refused.value.code == 2
    assert name in str(refused.value)


@pytest.mark.parametrize("kind", ["obj", "ascii", "binary_little_endian", "glb", "gltf"])
def test_a_truncated_file_is_refused_wherever_it_ends(tmp_path: Path, kind: str) -> None:
    """But for OBJ, which cannot know its end: what is left of it may be a mesh, and its open edges are told."""
    made = {"glb": cube_gltf().glb(), "gltf": cube_gltf().text().encode(), "obj": obj(CUBE, QUADS).encode()}
    data = made.get(kind) or ply(CUBE, QUADS, kind)
    ending = kind if kind in made else "ply"
    for end in range(0, len(data) - 3, 7):
        try:
            found = read(tmp_path / f"cut.{ending}", data[:end])
        except UserError:
            continue
        assert kind == "obj"
        assert kinds(found)["open edge"] > 0


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    (tmp_path / "folder.obj").mkdir()
    for name, told in (
        ("lost.ply", "no such file"),
        ("folder.obj", "a folder"),
        ("mesh.fbx", r"\.glb, \.gltf, \.obj, \.ply"),
    ):
        with pytest.raises(UserError, match=told):
            mesh.read(tmp_path / name)
    with pytest.raises(UserError, match=r"Invalid up axis 'x'. Should be y or z"):
        read(tmp_path / "cube.obj", obj(CUBE, QUADS), "x")


def test_more_vertices_than_memory_holds_are_refused_before_they_are_made(tmp_path: Path) -> None:
    made = cube_gltf()
    made.root["accessors"][0] = {"componentType": 5126, "type": "VEC3", "count": 1 << 40}
    with pytest.raises(UserError, match=r"Should be at most 6,000,000"):
        read(tmp_path / "zeros.glb", made.glb())
    many = protocol.MOST_VERTICES // 8 + 1
    instanced = Gltf(nodes=[{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 2}}}}])
    instanced.root["meshes"] = [
        {
            "primitives": [
                {
                    "attributes": {"POSITION": instanced.accessor(CUBE)},
                    "indices": instanced.accessor(np.ravel(TRIANGLES), "u2"),
                }
            ]
        }
    ]
    instanced.root["accessors"].append({"componentType": 5126, "type": "VEC3", "count": many})
    with pytest.raises(UserError, match=r"2,000,008 vertices. Should be at most 2,000,000"):
        read(tmp_path / "instances.glb", instanced.glb())


def test_creases_split_vertices_and_round_shapes_do_not() -> None:
    """A prism of n sides: its sides' normals are those of a cylinder where they meet at less than 40 degrees."""
    for sides, smooth in ((8, False), (10, True), (64, True)):
        angle = 2.0 * np.pi * np.arange(sides) / sides
        ring = np.stack([np.cos(angle), np.sin(angle), 0.0 * angle], axis=-1)
        after = (np.arange(sides) + 1) % sides
        faces = [[i, j, j + sides, i + sides] for i, j in enumerate(after.tolist())]
        faces += [list(range(sides))[::-1], list(range(sides, 2 * sides))]
        points = np.vstack([ring, ring + np.array([0.0, 0.0, 1.0])])
        made = read_in_memory(points, faces)
        side = np.abs(made.normals[:, 2]) < 0.5
        radial = made.positions[side] * [1.0, 1.0, 0.0]
        cosine = np.einsum("vi,vi->v", made.normals[side], radial)
        assert side.sum() == 2 * sides * (1 if smooth else 2)
        # By symmetry exact at every vertex but for the diagonals' uneven areas.
        assert cosine.min() > (0.5 * (1.0 + np.cos(np.pi / sides)) if smooth else np.cos(np.pi / sides) - 1e-12)
        assert np.array_equal(np.unique(made.normals[~side], axis=0), [[0.0, 0, -1], [0, 0, 1]])


def read_in_memory(points: np.ndarray, faces: list[list[int]]) -> mesh.Mesh:
    """A mesh healed as a file's would be."""
    from skylight_sh.mesh import assembly, healing

    triangles = polygons.triangulate(points, np.concatenate(faces), np.array([len(face) for face in faces]))
    return healing.heal(assembly.assemble([protocol.Surface("made", points, triangles)], "z")[0])[0]


def test_a_soup_of_triangles_becomes_as_smooth_as_one_with_shared_vertices(tmp_path: Path) -> None:
    at = np.linspace(-1.0, 1.0, 9)
    points = np.array([[x, y, 0.1 * x * x] for y in at for x in at])
    faces = [[9 * j + i, 9 * j + i + 1, 9 * (j + 1) + i] for j in range(8) for i in range(8)]
    faces += [[9 * j + i + 1, 9 * (j + 1) + i + 1, 9 * (j + 1) + i] for j in range(8) for i in range(8)]
    shared, _ = read(tmp_path / "shared.ply", ply(points, faces))
    soup, told = read(tmp_path / "soup.ply", ply(points[np.ravel(faces)], np.arange(3 * len(faces)).reshape(-1, 3).tolist()))
    assert kinds((soup, told))["duplicate vertices"] == 3 * len(faces) - 81
    assert np.allclose(soup.normals[soup.triangles], shared.normals[shared.triangles])


def test_a_moebius_strip_has_no_winding_and_says_so(tmp_path: Path) -> None:
    count = 24
    turn = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    spoke = np.stack([np.cos(turn / 2) * np.cos(turn), np.cos(turn / 2) * np.sin(turn), np.sin(turn / 2)], axis=-1)
    ring = np.stack([np.cos(turn), np.sin(turn), 0.0 * turn], axis=-1)
    points = np.vstack([ring - 0.3 * spoke, ring + 0.3 * spoke])
    faces = [[i, i + 1, i + 1 + count, i + count] for i in range(count - 1)] + [[count - 1, count, 0, 2 * count - 1]]
    found = read(tmp_path / "strip.obj", obj(points, faces))
    assert kinds(found)["one-sided"] == 2 * count


def test_polygons_become_triangles_of_their_area() -> None:
    star = np.array([[0.0, 0], [4, 1], [5, 5], [3, 2], [1, 4], [2, 1.5]])
    comb = np.array([[0.0, 0], [9, 0], *[[9 - i, 5.0 if i % 2 else 1.0] for i in range(10)]])
    for plane in (star, comb, star[::-1], np.array([[0.0, 0], [4, 0], [1, 1], [0, 4]])):
        for first in range(len(plane)):
            outline = np.roll(plane, first, axis=0)
            points = np.stack([outline[:, 0], 0.3 * outline[:, 0] - 0.2 * outline[:, 1], outline[:, 1]], axis=-1)
            made = polygons.triangulate(points, np.arange(len(points)), np.array([len(points)]))
            a, b, c = np.moveaxis(points[made], 1, 0)
            cross = np.cross(b - a, c - a)
            whole = np.cross(points, np.roll(points, -1, axis=0)).sum(axis=0)
            assert len(made) == len(points) - 2
            # No triangle faces the other way, and together they have the polygon's area: none overlap.
            assert np.allclose(cross.sum(axis=0), whole)
            assert np.linalg.norm(cross, axis=-1).sum() == pytest.approx(np.linalg.norm(whole))


def test_winding_numbers_are_those_of_nested_spheres() -> None:
    corners = CUBE[np.array(TRIANGLES)] - 0.5
    points = np.random.default_rng(5).uniform(-1.5, 1.5, (200, 3))
    inside = (np.abs(points)[:, :, np.newaxis] < [0.5, 1.0]).all(axis=1).sum(axis=-1)
    assert np.allclose(orientation.winding_number(points, np.concatenate([corners, 2.0 * corners])), inside)


def test_touching_cubes_are_two_shells(tmp_path: Path) -> None:
    """Cubes that share an edge: it has four triangles, and each cube is a closed shell of its own."""
    shifted = CUBE + np.array([1.0, 1.0, 0.0])
    made, told = read(tmp_path / "two.obj", obj(CUBE, QUADS) + obj(shifted, [face[::-1] for face in QUADS], 9))
    assert kinds((made, told)) == {"inverted": 12, "non-manifold edge": 1, "duplicate vertices": 2}
    assert volume(made) == pytest.approx(2.0)
    assert topology.topology(made).closed.tolist() == [True, True]


def test_every_kind_is_explained() -> None:
    page = (ROOT / "docs" / "formats.md").read_text(encoding="utf-8")
    explained = set(re.findall(r"^\| `([^`]+)` \| (?:yes|no) \|", page, re.MULTILINE))
    source = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "pipeline" / "skylight_sh").rglob("*.py"))
    for kind in explained:
        assert f'"{kind}"' in source, kind
    for cases in (HEALED, TOLD):
        assert {kind for _, expected in cases.values() for kind in expected} <= explained


def test_files_too_large_for_any_mesh_are_refused_unread(tmp_path: Path) -> None:
    path = tmp_path / "sparse.ply"
    with path.open("wb") as file:
        file.truncate(1 << 32)
    with pytest.raises(UserError, match=r"has 4,294,967,296 bytes. Should have at most"):
        mesh.read(path)
    text = "v 0 0 0\n" * 4 + "f 1 2 3 4\n" * ((1 << 18) + 8)
    most, protocol_check = 1 << 18, obj_format.check_count
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(obj_format, "check_count", lambda count, noun: protocol_check(count, noun, most))
        with pytest.raises(UserError, match=r"triangles. Should be at most 262,144"):
            read(tmp_path / "long.obj", text)


def test_the_command_refuses_by_exit_code_2(tmp_path: Path) -> None:
    (tmp_path / "bad.obj").write_text(obj(CUBE, [*QUADS, [0, 1, 99]]))
    command = [sys.executable, "-m", "skylight_sh", "transfer", "bad.obj", "--output", "bad.h5"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "bad.obj: part 'bad': 1 indices out of range" in done.stderr
    assert not (tmp_path / "bad.h5").exists()
