"""glTF: transforms, instances, accessors of every form, materials and pictures; what is compressed is refused by name."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from meshes import CUBE, QUADS, TRIANGLES, Gltf, cube_gltf, kinds, obj, ply, read, volume
from numpy.typing import NDArray
from skylight_sh import UserError, mesh
from skylight_sh.probe import files

Array = NDArray[np.float64]
# A half turn about (1, 1, 0), as x, y, z, w.
HALF_TURN = [np.sqrt(0.5), np.sqrt(0.5), 0.0, 0.0]


def z_up(points: Array) -> Array:
    return points[:, [0, 2, 1]] * [1.0, -1.0, 1.0]


def triangles_of(corners: Array) -> Array:
    """Triangles' corners in an order that does not hang on where they begin or which comes first."""
    rounded = corners.round(6) + 0.0
    turned = np.array(
        [min((np.roll(one, k, axis=0) for k in range(3)), key=lambda t: t.ravel().tolist()) for one in rounded]
    )
    return turned[np.lexsort(turned.reshape(len(turned), -1).T)]


def primitive(made: Gltf) -> dict[str, Any]:
    found: dict[str, Any] = made.root["meshes"][0]["primitives"][0]
    return found


def test_y_is_up_unless_told(tmp_path: Path) -> None:
    data = cube_gltf().glb()
    assert np.array_equal(
        np.unique(read(tmp_path / "a.glb", data)[0].positions, axis=0), np.unique(z_up(CUBE) + 0.0, axis=0)
    )
    assert np.array_equal(np.unique(read(tmp_path / "a.glb", data, "z")[0].positions, axis=0), np.unique(CUBE, axis=0))
    turned = read(tmp_path / "a.obj", obj(CUBE, QUADS), "y")[0]
    assert np.array_equal(np.unique(turned.positions, axis=0), np.unique(z_up(CUBE) + 0.0, axis=0))
    assert volume(turned) == pytest.approx(1.0)


def test_nodes_instances_and_mirrors_agree_with_trimesh(tmp_path: Path) -> None:
    """A tree of random transforms, some of them mirrors: the same triangles in the same places, outside still outside."""
    random = np.random.default_rng(3)
    scene = trimesh.Scene()
    shape = trimesh.creation.icosphere(subdivisions=1)
    for i in range(6):
        quaternion = random.normal(size=4)
        matrix = trimesh.transformations.quaternion_matrix(quaternion / np.linalg.norm(quaternion))
        matrix[:3, :3] *= random.uniform(0.5, 2.0, 3) * [1.0, (-1.0) ** i, 1.0]
        matrix[:3, 3] = random.uniform(-20.0, 20.0, 3)
        below = None if i < 2 else f"ball {i - 2}"
        scene.add_geometry(shape, node_name=f"ball {i}", geom_name="ball", parent_node_name=below, transform=matrix)
    made, told = read(tmp_path / "scene.glb", scene.export(file_type="glb"))
    assert sorted(part.name for part in made.parts) == [f"ball {i}" for i in range(6)]
    expected = []
    for name in scene.graph.nodes_geometry:
        matrix = scene.graph.get(name)[0]
        corners = (shape.vertices @ matrix[:3, :3].T + matrix[:3, 3])[shape.faces]
        expected.append(corners[:, ::-1] if np.linalg.det(matrix[:3, :3]) < 0.0 else corners)
    whole = z_up(np.concatenate(expected).reshape(-1, 3)).reshape(-1, 3, 3)
    # Files have single precision.
    assert np.allclose(triangles_of(made.corners.round(3)), triangles_of(whole.round(3)), atol=2e-3)
    assert "inverted" not in kinds((made, told))
    assert volume(made) > 0.0


@pytest.mark.parametrize(
    "node",
    [
        {"scale": [-1, 2, 3]},
        {"scale": [-1, -1, -1]},
        {"rotation": HALF_TURN, "translation": [7, 8, 9]},
        {"matrix": [0, 0, -1, 0, 0, 2, 0, 0, 1, 0, 0, 0, 5, 5, 5, 1]},
        {"matrix": [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1]},
    ],
)
def test_transforms_keep_outside_outside_and_normals_upright(tmp_path: Path, node: dict[str, Any]) -> None:
    made = Gltf(nodes=[{"mesh": 0, **node}])
    points, normals = CUBE[np.ravel(TRIANGLES)] - 0.5, np.repeat(np.cross(*_edges()), 3, axis=0)
    attributes = {"POSITION": made.accessor(points), "NORMAL": made.accessor(normals)}
    made.root["meshes"] = [{"primitives": [{"attributes": attributes}]}]
    found, told = read(tmp_path / "node.glb", made.glb())
    linear = np.array(node["matrix"]).reshape(4, 4).T[:3, :3] if "matrix" in node else np.diag(node.get("scale", [1, 1, 1]))
    assert volume(found) == pytest.approx(abs(np.linalg.det(linear)), rel=1e-6)
    assert set(kinds((found, told))) <= {"duplicate vertices"}
    assert np.allclose(np.einsum("ti,tki->tk", found.facing, found.normals[found.triangles]), 1.0)


def _edges() -> tuple[Array, Array]:
    a, b, c = np.moveaxis(CUBE[np.array(TRIANGLES)], 1, 0)
    return b - a, c - a


def test_gpu_instances(tmp_path: Path) -> None:
    attributes = {"TRANSLATION": 2, "SCALE": 3}
    made = cube_gltf(extensionsRequired=["EXT_mesh_gpu_instancing"])
    made.root["nodes"][0]["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": attributes}}
    made.accessor([[0, 0, 0], [5, 0, 0], [0, 9, 0]])
    made.accessor([[1, 1, 1], [2, 2, 2], [-1, 1, 1]])
    found, told = read(tmp_path / "many.glb", made.glb())
    assert volume(found) == pytest.approx(1 + 8 + 1)
    assert [part.name for part in found.parts] == ["box", "box 2", "box 3"]
    assert kinds((found, told)) == {}


def test_sparse_quantised_and_strided_accessors(tmp_path: Path) -> None:
    whole = read(tmp_path / "whole.glb", cube_gltf().glb())[0]
    for sparse_of in (None, CUBE * [0, 1, 1]):
        made = cube_gltf()
        at, values = made.view(np.arange(8, dtype="<u1").tobytes()), made.view(CUBE.astype("<f4").tobytes())
        sparse = {"count": 8, "indices": {"bufferView": at, "componentType": 5121}, "values": {"bufferView": values}}
        view = {} if sparse_of is None else {"bufferView": made.view(sparse_of.astype("<f4").tobytes())}
        made.root["accessors"][0] = {"componentType": 5126, "type": "VEC3", "count": 8, "sparse": sparse, **view}
        assert np.array_equal(read(tmp_path / "sparse.glb", made.glb())[0].positions, whole.positions)
    for kind, normalised, scale in (
        ("u1", True, 255),
        ("u2", True, 65535),
        ("i1", True, 127),
        ("i2", True, 32767),
        ("u2", False, 1),
    ):
        made = cube_gltf(extensionsRequired=["KHR_mesh_quantization"])
        width = 4
        padded = np.zeros((8, width))
        padded[:, :3] = CUBE * scale
        data = padded.astype("<" + kind)
        component = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123}[kind]
        view = made.view(data.tobytes(), byteStride=data.itemsize * width)
        made.root["accessors"][0] = {
            **{"bufferView": view, "componentType": component, "type": "VEC3", "count": 8},
            "normalized": normalised,
        }
        assert np.array_equal(read(tmp_path / "small.glb", made.glb())[0].positions, whole.positions)


def test_strips_and_fans(tmp_path: Path) -> None:
    points = np.array([[0.0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [2, 0, 0]])
    for mode, order, area in ((5, [0, 2, 1, 3], 1.0), (6, [0, 2, 3, 1], 1.0), (5, [1, 0, 3, 2, 4], 1.5)):
        made = Gltf(nodes=[{"mesh": 0}])
        attributes, indices = {"POSITION": made.accessor(points)}, made.accessor(order, "u1")
        made.root["meshes"] = [{"primitives": [{"attributes": attributes, "indices": indices, "mode": mode}]}]
        found, told = read(tmp_path / "strip.glb", made.glb(), "z")
        assert "winding" not in kinds((found, told))
        a, b, c = np.moveaxis(found.corners, 1, 0)
        assert np.allclose(0.5 * np.cross(b - a, c - a).sum(axis=0), [0.0, 0.0, area])
    made = cube_gltf()
    made.root["meshes"][0]["primitives"].append({"attributes": primitive(made)["attributes"], "mode": 1})
    assert kinds(read(tmp_path / "lines.glb", made.glb())) == {"no triangles": 1}


def test_colours_names_and_what_is_told_of_materials(tmp_path: Path) -> None:
    look = {"baseColorFactor": [0.2, 0.4, 0.6, 1.0], "metallicFactor": 0.0}
    made = cube_gltf(materials=[{"name": "paint", "pbrMetallicRoughness": look}, {"name": "glass", "alphaMode": "BLEND"}])
    shared = primitive(made)
    shared["material"] = 0
    colour = made.accessor(np.tile([255, 51, 0, 255], (8, 1)), "u1", normalized=True)
    made.root["meshes"][0]["primitives"].append(
        {**shared, "attributes": {**shared["attributes"], "COLOR_0": colour}, "material": 1}
    )
    found, told = read(tmp_path / "look.glb", made.glb())
    assert [part.name for part in found.parts] == ["box/paint", "box/glass"]
    assert np.allclose(found.albedo[found.triangles[found.part == 0]], [0.2, 0.4, 0.6])
    assert np.allclose(found.albedo[found.triangles[found.part == 1]], [1.0, 0.2, 0.0])
    assert kinds((found, told)) == {"transparent": 1, "bright albedo": 8, "coincident": 24}
    look["metallicFactor"] = 1.0
    assert kinds(read(tmp_path / "look.glb", made.glb()))["metal"] == 1


def picture(path: Path, pixels: Array) -> Path:
    """Write an 8-bit PNG."""
    import OpenImageIO

    out = OpenImageIO.ImageOutput.create(str(path))
    rows, columns, channels = pixels.shape
    assert out.open(str(path), OpenImageIO.ImageSpec(columns, rows, channels, "uint8"))
    assert out.write_image((255.0 * pixels).round().astype(np.uint8))
    out.close()
    return path


def test_pictures_lie_alike_in_every_format(tmp_path: Path) -> None:
    """The upper left texel is where the file says, the first row of a texture at v = 1."""
    texels = np.random.default_rng(2).integers(0, 256, (2, 4, 3)) / 255.0
    file = picture(tmp_path / "wall.png", texels)
    picture(tmp_path / "bumps.png", np.tile([0.5, 1.0, 0.5], (2, 2, 1)))
    points = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    upward = points[:, :2]
    (tmp_path / "a.mtl").write_text("newmtl wall\nKd 0.5 0.5 0.5\nmap_Kd -s 1 1 1 wall.png\nnorm bumps.png\n")
    text = "mtllib a.mtl\n" + obj(points, []) + "".join(f"vt {u} {v}\n" for u, v in upward)
    made = Gltf(
        nodes=[{"mesh": 0}],
        materials=[{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.5, 1], "metallicFactor": 0}}],
        textures=[{"source": 0}, {"source": 1}],
    )
    material = made.root["materials"][0]
    material["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    material["normalTexture"] = {"index": 1}
    made.root["images"] = [{"bufferView": made.view(file.read_bytes()), "mimeType": "image/png"}, {"uri": "bumps.png"}]
    downward = np.stack([upward[:, 0], 1.0 - upward[:, 1]], axis=-1)
    attributes = {"POSITION": made.accessor(points), "TEXCOORD_0": made.accessor(downward)}
    made.root["meshes"] = [
        {"primitives": [{"attributes": attributes, "indices": made.accessor([0, 1, 2, 0, 2, 3], "u1"), "material": 0}]}
    ]
    table = ply(points, [[0, 1, 2, 3]]).replace(b"double z\n", b"double z\nproperty float s\nproperty float t\n")
    head, _, body = table.partition(b"end_header\n")
    rows = body.decode().splitlines()
    rows[:4] = [f"{row} {u} {v}" for row, (u, v) in zip(rows[:4], upward, strict=True)]
    table = head.replace(b"1.0\n", b"1.0\ncomment TextureFile wall.png\n", 1) + b"end_header\n" + "\n".join(rows).encode()
    found = {
        "obj": read(tmp_path / "a.obj", text + "usemtl wall\nf 1/1 2/2 3/3 4/4\n"),
        "glb": read(tmp_path / "a.glb", made.glb(), "z"),
        "ply": read(tmp_path / "a.ply", table),
    }
    linear = files.from_srgb(texels.astype(np.float32))
    for name, (one, told) in found.items():
        assert kinds((one, told)) == {"open edge": 4}, name
        assert one.parts[0].texture is not None
        assert np.allclose(one.parts[0].texture, linear, atol=1e-6)
        assert np.allclose(one.uv, one.positions[:, :2])
        assert np.allclose(one.albedo, 1.0 if name == "ply" else 0.5)
        if name != "ply":
            assert one.parts[0].relief is not None
            assert np.allclose(one.parts[0].relief[0, 0], [0.0, 1.0, 0.0], atol=0.01)
    file.unlink()
    bare, told = read(tmp_path / "a.obj", text + "usemtl wall\nf 1/1 2/2 3/3 4/4\n")
    assert bare.parts[0].texture is None
    assert kinds((bare, told)) == {"open edge": 4, "no picture": 1}
    file.write_bytes(b"no picture")
    with pytest.raises(UserError, match=r"wall\.png is no picture"):
        read(tmp_path / "a.obj", text + "usemtl wall\nf 1/1 2/2 3/3 4/4\n")


def test_texture_transforms_turn_anticlockwise_about_the_upper_left(tmp_path: Path) -> None:
    """KHR_texture_transform: offset, rotation and scale of coordinates whose v is downwards."""
    picture(tmp_path / "wall.png", np.zeros((2, 2, 3)))
    made = cube_gltf(materials=[{}], textures=[{"source": 0}], images=[{"uri": "wall.png"}])
    moved = {"offset": [0.25, 0.5], "rotation": np.pi / 2, "scale": [2.0, 3.0]}
    used = {"index": 0, "extensions": {"KHR_texture_transform": moved}}
    made.root["materials"][0]["pbrMetallicRoughness"] = {"baseColorTexture": used, "metallicFactor": 0.0}
    primitive(made)["material"] = 0
    primitive(made)["attributes"]["TEXCOORD_0"] = made.accessor(np.tile([0.5, 0.25], (8, 1)))
    found, _ = read(tmp_path / "moved.glb", made.glb())
    # Scaled (1, 0.75); a quarter turn anticlockwise, with v down, takes u to -v and v to u; then moved.
    assert np.allclose(found.uv, [0.75 + 0.25, 1.0 - (-1.0 + 0.5)])


REFUSED: dict[str, tuple[dict[str, Any], str]] = {
    "draco": (
        {"extensionsRequired": ["KHR_draco_mesh_compression"]},
        "KHR_draco_mesh_compression.*Export without compression",
    ),
    "meshopt": ({"extensionsRequired": ["EXT_meshopt_compression"]}, "EXT_meshopt_compression.*Export without compression"),
    "basis": ({"extensionsRequired": ["KHR_texture_basisu"]}, "KHR_texture_basisu.*Export without compression"),
    "unknown": ({"extensionsRequired": ["ACME_shape"]}, "ACME_shape, which is not read. Export without it"),
    "version": ({"asset": {"version": "1.0"}}, "version 1.0. Should be 2.0"),
    "circle": ({"nodes": [{"mesh": 0, "children": [0]}], "scenes": [{"nodes": [0]}]}, "below itself"),
    "shared": ({"nodes": [{"mesh": 0}, {"children": [0]}, {"children": [0]}]}, "below more than one other"),
    "node": ({"scenes": [{"nodes": [7]}]}, "index 7 out of range. Should be below 1, the number of nodes"),
    "mesh": ({"nodes": [{"mesh": -1}]}, "'mesh' is -1. Should be a whole number"),
    "scale": ({"nodes": [{"mesh": 0, "scale": [1, 1]}]}, "'scale' is .*Should be 3 finite numbers"),
    "list": ({"nodes": 5}, "'nodes' is 5. Should be a list"),
    "nothing": ({"nodes": []}, "no triangles"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_not_known_is_refused_by_name(tmp_path: Path, name: str) -> None:
    root, told = REFUSED[name]
    with pytest.raises(UserError, match=told):
        read(tmp_path / f"{name}.glb", cube_gltf(**root).glb())


def test_indices_views_and_buffers_out_of_range_are_refused(tmp_path: Path) -> None:
    made = cube_gltf()
    primitive(made)["indices"] = made.accessor([0, 1, 99], "u1")
    with pytest.raises(UserError, match=r"part 'box': 1 indices out of range, such as 99"):
        read(tmp_path / "index.glb", made.glb())
    sparse = cube_gltf()
    sparse.root["accessors"][0]["sparse"] = {
        "count": 1,
        "indices": {"bufferView": sparse.view(b"\x08"), "componentType": 5121},
        "values": {"bufferView": sparse.view(bytes(12))},
    }
    with pytest.raises(UserError, match=r"sparse index of accessor 0 is out of range. Should be below 8"):
        read(tmp_path / "sparse.glb", sparse.glb())
    for key, value, told in (
        ("count", 9, "9 elements needs more"),
        ("type", "MAT4", "MAT4"),
        ("componentType", 7, "component type 7"),
    ):
        long = cube_gltf()
        long.root["accessors"][0][key] = value
        with pytest.raises(UserError, match=told):
            read(tmp_path / "long.glb", long.glb())
    root = json.loads(cube_gltf().text())
    root["buffers"][0]["byteLength"] += 1
    with pytest.raises(UserError, match=r"buffer 0 has .* bytes"):
        read(tmp_path / "buffer.gltf", json.dumps(root))
    root["buffers"][0]["uri"] = "lost.bin"
    with pytest.raises(UserError, match=r"no file 'lost\.bin' beside the mesh"):
        read(tmp_path / "buffer.gltf", json.dumps(root))
    root["buffers"][0]["uri"] = "https://example.org/a.bin"
    with pytest.raises(UserError, match="on the network"):
        read(tmp_path / "buffer.gltf", json.dumps(root))


def test_compressed_views_and_primitives_without_a_fallback_are_refused(tmp_path: Path) -> None:
    made = cube_gltf()
    made.root["bufferViews"][0]["extensions"] = {"EXT_meshopt_compression": {"buffer": 0}}
    with pytest.raises(UserError, match=r"compressed by EXT_meshopt_compression. Export without compression"):
        read(tmp_path / "packed.glb", made.glb())
    made = cube_gltf()
    primitive(made)["extensions"] = {"KHR_draco_mesh_compression": {"bufferView": 0}}
    # With its plain data beside it, a compressed form that is not required may be left alone.
    assert volume(read(tmp_path / "both.glb", made.glb())[0]) == pytest.approx(1.0)
    del made.root["accessors"][0]["bufferView"]
    with pytest.raises(UserError, match="compressed by KHR_draco_mesh_compression"):
        read(tmp_path / "draco.glb", made.glb())


def test_external_buffers_and_plain_text(tmp_path: Path) -> None:
    made = cube_gltf()
    (tmp_path / "the data.bin").write_bytes(made.data)
    text = json.dumps({**made.root, "buffers": [{"byteLength": len(made.data), "uri": "the%20data.bin"}]})
    assert volume(read(tmp_path / "cube.gltf", text)[0]) == pytest.approx(1.0)
    assert mesh.read(tmp_path / "cube.gltf")[0].parts[0].name == "box"
