"""Compressed transfer as files: the GLB read back, the validator, shaders and routines against the transfer itself."""

from __future__ import annotations

import json
import struct
import subprocess
import zlib
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import OpenImageIO
import pytest
import shader_tools
import skylight_sh
from conftest import run_quietly, scene_config
from skylight_sh import UserError
from skylight_sh.export import gltf, transfer_files, transfer_shader
from skylight_sh.export.shader_dialects import DIALECTS
from skylight_sh.formula.printers import single as number
from skylight_sh.mesh import Mesh, Part, read
from skylight_sh.probe.files import to_srgb
from skylight_sh.run.steps import steps
from skylight_sh.transfer import compression
from test_cli import invoke
from test_shader_values import TYPES
from test_shader_values import run as run_as_cpp
from test_transfer_engines import TABLE, Array, compressed, exact, lit_yard, relative, suns

VALIDATOR, THREE = "gltf-validator@2.0.0-dev.3.10", "three@0.180.0"
KINDS = {5120: "i1", 5121: "u1", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


@cache
def files() -> dict[str, bytes]:
    mesh, direct, transfer = lit_yard()
    made = compressed()
    return transfer_files.pack(mesh, made, transfer_files.losses(compression.errors(made, direct, transfer, *suns(60, 1))))


def opened(data: bytes) -> tuple[dict[str, Any], bytes]:
    """The document and the buffer of a GLB, as chapter 4.4 of the specification lays them out."""
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size, kind = struct.unpack_from("<I4s", data, 12)
    assert (kind, size % 4) == (b"JSON", 0)
    rest, other = struct.unpack_from("<I4s", data, 20 + size)
    assert (other, rest % 4, 28 + size + rest) == (b"BIN\0", 0, len(data))
    return json.loads(data[20 : 20 + size]), data[28 + size :]


def values(document: dict[str, Any], data: bytes, index: int) -> np.ndarray[Any, Any]:
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    kind, width = KINDS[accessor["componentType"]], WIDTHS[accessor["type"]]
    start = view["byteOffset"] + accessor.get("byteOffset", 0)
    out = np.frombuffer(data, kind, accessor["count"] * width, start).reshape(-1, width)
    return out / np.iinfo(out.dtype).max if accessor.get("normalized") else out


def attributes(data: bytes) -> dict[str, Array]:
    """Every attribute of a file whose parts' vertices follow each other."""
    document, binary = opened(data)
    parts = [one["primitives"][0]["attributes"] for one in document["meshes"]]
    return {name: np.concatenate([values(document, binary, part[name]) for part in parts]) for name in parts[0]}


def test_a_glb_holds_the_mesh_and_its_components() -> None:
    mesh = lit_yard()[0]
    document, data = opened(files()["transfer.glb"])
    assert [one["name"] for one in document["meshes"]] == ["floor", "wall", "box"]
    got = attributes(files()["transfer.glb"])
    east, up, south = got["POSITION"].T
    assert np.stack([east, -south, up], axis=-1) == pytest.approx(mesh.positions, abs=1e-6)
    assert got["NORMAL"][:, [0, 2, 1]] * [1, -1, 1] == pytest.approx(mesh.normals, abs=1e-6)
    assert got["COLOR_0"][:, :3] == pytest.approx(mesh.albedo, abs=1e-5)
    components = np.concatenate([got[name] for name in document["extras"]["skylight_sh_transfer"]["attributes"]], axis=1)
    assert np.array_equal(components, compressed().components / 127)
    first = 0
    for i, one in enumerate(document["meshes"]):
        primitive = one["primitives"][0]
        triangles = values(document, data, primitive["indices"]).reshape(-1, 3)
        assert np.array_equal(triangles + first, mesh.triangles[mesh.part == i])
        first += document["accessors"][primitive["attributes"]["POSITION"]]["count"]


def test_parts_that_share_vertices_keep_them() -> None:
    mesh = lit_yard()[0]
    mixed = replace(mesh, part=np.arange(len(mesh.triangles)) % 2, parts=(Part("even"), Part("odd")))
    document, data = opened(gltf.write(mixed, {}, {}))
    for i, one in enumerate(document["meshes"]):
        primitive = one["primitives"][0]
        points = values(document, data, primitive["attributes"]["POSITION"])
        corners = points[values(document, data, primitive["indices"]).reshape(-1, 3)]
        assert corners[..., [0, 2, 1]] * [1, -1, 1] == pytest.approx(mixed.corners[mixed.part == i], abs=1e-6)


def test_our_own_reader_reads_it_back(tmp_path: Path) -> None:
    """Which knows glTF from files of others: axes, winding, names and colours."""
    mesh = lit_yard()[0]
    (tmp_path / "made.glb").write_bytes(files()["transfer.glb"])
    found, findings = read(tmp_path / "made.glb")
    assert findings == ()
    assert [part.name for part in found.parts] == ["floor", "wall", "box"]
    assert len(found.triangles) == len(mesh.triangles)
    assert found.corners.min(axis=(0, 1)) == pytest.approx(mesh.positions.min(axis=0), abs=1e-5)
    assert found.corners.max(axis=(0, 1)) == pytest.approx(mesh.positions.max(axis=0), abs=1e-5)
    assert sorted(map(tuple, np.unique(found.albedo, axis=0).round(3).tolist())) == sorted(
        map(tuple, np.unique(mesh.albedo, axis=0).tolist())
    )


def test_twenty_bytes_a_vertex_in_the_buffer() -> None:
    mesh = lit_yard()[0]
    document, data = opened(files()["transfer.glb"])
    names = document["extras"]["skylight_sh_transfer"]["attributes"]
    first = document["meshes"][0]["primitives"][0]["attributes"]
    views = [document["bufferViews"][document["accessors"][first[name]]["bufferView"]] for name in names]
    assert sum(view["byteLength"] for view in views) == 20 * len(mesh.positions)
    parts = [data[view["byteOffset"] : view["byteOffset"] + view["byteLength"]] for view in views]
    assert len(zlib.compress(b"".join(parts), 9)) < 19 * len(mesh.positions)


def test_what_is_told_of_the_error_is_measured() -> None:
    _, direct, transfer = lit_yard()
    table = skylight_sh.load(TABLE)
    written = transfer_files.write(lit_yard()[0], direct, transfer, table)
    whole = written.files
    assert set(whole) == {
        *("transfer.glb", "transfer_uniforms.json", "transfer_uniforms.mjs"),
        *(f"transfer_shader.{name}" for name in ("glsl", "hlsl", "wgsl")),
    }
    told = json.loads(whole["transfer_uniforms.json"])
    assert opened(whole["transfer.glb"])[0]["extras"]["skylight_sh_transfer"]["error"] == told["error"]
    got = attributes(whole["transfer.glb"])
    vertices = np.concatenate([got[f"_TRANSFER{i}"] for i in range(5)], axis=1)
    lights = suns(60, 1)
    lost = []
    for sky, sun in zip(*lights, strict=True):
        for disc in (0.0 * sun, sun):
            frame = compression.uniforms(np.array(told["matrix"]), sky, disc)
            lost.append(relative(frame[0] + vertices @ frame[1:], exact(direct, transfer, sky, disc)))
    sky_alone, both = np.array(lost).reshape(60, 2).T
    expected = [sky_alone.max(), np.median(sky_alone), both.max(), np.median(both)]
    names = ("sky_worst", "sky_median", "sky_and_sun_bounces_worst", "sky_and_sun_bounces_median")
    assert [told["error"][name] for name in names] == pytest.approx(expected, rel=1e-3)
    assert told["error"] == written.lost
    assert files() == transfer_files.pack(
        lit_yard()[0], compressed(), json.loads(files()["transfer_uniforms.json"])["error"]
    )
    renamed = transfer_files.pack(lit_yard()[0], compressed(), {}, "yard")
    assert json.loads(renamed["yard_uniforms.json"])["matrix"] == json.loads(files()["transfer_uniforms.json"])["matrix"]
    assert opened(renamed["yard.glb"])[0]["extras"]["skylight_sh_transfer"]["uniforms"] in renamed


def test_a_table_of_too_few_bands_is_refused() -> None:
    direct = np.zeros((3, 64))
    mesh = lit_yard()[0]
    with pytest.raises(UserError, match="Give a table of at least 8"):
        transfer_files.write(mesh, direct, np.zeros((3, 3, 64)), skylight_sh.load(TABLE))


def pictured() -> Mesh:
    """The yard with a texture on its floor and wall, and a relief on the floor."""
    mesh = lit_yard()[0]
    random = np.random.default_rng(3)
    texture = random.uniform(0.0, 1.0, (4, 8, 3))
    relief = random.standard_normal((8, 4, 3)) * [0.2, 0.2, 0.0] + [0.0, 0.0, 1.0]
    relief /= np.linalg.norm(relief, axis=-1, keepdims=True)
    parts = (Part("floor", texture, relief), Part("wall", texture), Part("box", texture))
    return replace(mesh, parts=parts, uv=random.uniform(0.0, 1.0, (len(mesh.positions), 2)))


def test_textures_and_reliefs_are_pictures_within(tmp_path: Path) -> None:
    mesh = pictured()
    document, data = opened(gltf.write(mesh, {}, {}))
    assert len(document["materials"]) == 2  # wall and box share one
    assert [one.get("normalTexture") for one in document["materials"]] == [{"index": 1}, None]
    for one, expected in zip(
        document["images"], (to_srgb(mesh.parts[0].texture), 0.5 + 0.5 * mesh.parts[0].relief), strict=True
    ):
        view = document["bufferViews"][one["bufferView"]]
        got = pixels(data[view["byteOffset"] : view["byteOffset"] + view["byteLength"]], tmp_path / "one.png")
        assert got == pytest.approx(255 * expected, abs=0.51)
    assert attributes(gltf.write(mesh, {}, {}))["TEXCOORD_0"] == pytest.approx(mesh.uv * [1, -1] + [0, 1], abs=1e-6)


def pixels(data: bytes, place: Path) -> Array:
    """A PNG's pixels by OpenImageIO."""
    place.write_bytes(data)
    reader = OpenImageIO.ImageInput.open(str(place))
    return np.asarray(reader.read_image("uint8"), dtype=np.float64)


def test_many_vertices_take_indices_of_32_bits() -> None:
    mesh = lit_yard()[0]
    count = len(mesh.positions)
    times = 65535 // count + 2
    many = replace(
        mesh,
        **{name: np.tile(getattr(mesh, name), (times, 1)) for name in ("positions", "normals", "albedo", "uv")},
        triangles=np.concatenate([mesh.triangles + i * count for i in range(times)]),
        part=np.tile(mesh.part, times),
    )
    document, data = opened(gltf.write(many, {}, {}))
    last = values(document, data, document["meshes"][2]["primitives"][0]["indices"]).reshape(-1, 3)
    assert last.max() > 65535
    assert np.array_equal(last, many.triangles[many.part == 2] - many.triangles[many.part == 2].min())


def frame() -> tuple[Array, Array, Array, Array]:
    """A sky, its sun, the uniforms that they make, and what the vertices get by the definition."""
    _, direct, transfer = lit_yard()
    sky, sun = (part[4] for part in suns(60, 1))
    return sky, sun, compression.uniforms(compressed().matrix, sky, sun), exact(direct, transfer, sky, sun)


def vectors(rows: Array, language: str) -> list[str]:
    return [DIALECTS[language].vector([number(v) for v in row]) for row in np.asarray(rows, np.float32).tolist()]


@pytest.mark.parametrize("language", ["glsl", "hlsl"])
def test_the_shader_lights_vertices(tmp_path: Path, language: str) -> None:
    """Compiled as C++, in single precision."""
    _, _, made, expected = frame()
    some = slice(None, None, 19)
    components = compressed().components[some] / 127
    text = transfer_shader.write(language, 20).replace(
        "#ifdef GL_ES\nprecision highp float;\nprecision highp int;\n#endif", ""
    )
    light = ", ".join(vectors(made, language))
    fours = [", ".join(vectors(four, language)) for row in components for four in [row.reshape(5, 4)]]
    main = f"""
static vec3 light[21] = {{{light}}};
static const vec4 given[][5] = {{{", ".join("{" + four + "}" for four in fours)}}};
int main() {{
    for (auto &g : given) {{
        const vec3 lit = skylight_sh_transfer(light, g[0], g[1], g[2], g[3], g[4]);
        fwrite(&lit, sizeof lit, 1, stdout);
    }}
}}
"""
    got = np.frombuffer(run_as_cpp(TYPES + text + main, tmp_path), dtype="<f4").reshape(-1, 3)
    assert relative(got, made[0] + components @ made[1:]) < 1e-6
    assert relative(got, expected[some]) < 0.025


def test_shaders_are_short_and_take_any_count() -> None:
    for language in DIALECTS:
        text = transfer_shader.write(language, 20)
        assert len([line for line in text.splitlines() if line and not line.startswith("//")]) <= 20
        assert "b.y * light[6];" in transfer_shader.write(language, 6)
    with pytest.raises(ValueError, match="Invalid prefix"):
        transfer_shader.write("glsl", 20, "gl_sky")


@pytest.mark.tools
def test_shaders_run_where_they_belong(tmp_path: Path) -> None:
    """GLSL by WebGL 2, WGSL by WebGPU, HLSL by way of SPIR-V, a row of 64 vertices each."""
    _, _, made, _ = frame()
    components = compressed().components[:64] / 127
    programs = {}
    for language, d in DIALECTS.items():
        lines = [
            transfer_shader.write(language, 20),
            d.constants("vec3", "test_light", vectors(made / 1000.0, language), 4),
            d.constants("vec4", "test_given", vectors(components.reshape(-1, 4), language), 4),
            shader_tools.HEADS[language].format(),
            d.fixed(
                "vec3", "v", f"skylight_sh_transfer(test_light, {', '.join(f'test_given[5 * i + {k}]' for k in range(5))})"
            ),
            shader_tools.ENDS[language].format(d.vector(["v.x", "v.y", "v.z", "1.0"]), width=64),
        ]
        version = "#version 300 es\n" if language == "glsl" else ""
        one = shader_tools.Program(language, version + "\n".join(lines), 64, 1)
        folder = tmp_path / language
        folder.mkdir()
        programs[language] = shader_tools.as_glsl(one, folder) if language == "hlsl" else one
    for image in shader_tools.run(programs, tmp_path).values():
        assert relative(1000.0 * image[0, :, :3], made[0] + components @ made[1:]) < 1e-5


def node(folder: Path, packages: list[str], program: str, *arguments: str) -> str:
    """Run a program of Node's with packages from npm."""
    install = ["npm", "install", "--prefix", str(folder), "--ignore-scripts", "--no-audit", "--no-fund", "--silent"]
    if packages:
        subprocess.run([*install, *packages], check=True)
    (folder / "program.mjs").write_text(program, encoding="utf-8")
    done = subprocess.run(["node", "program.mjs", *arguments], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


VALIDATE = """
import { readFileSync } from "node:fs";
import validator from "gltf-validator";
const told = [];
for (const file of process.argv.slice(2)) {
  told.push((await validator.validateBytes(new Uint8Array(readFileSync(file)))).issues);
}
console.log(JSON.stringify(told));
"""


@pytest.mark.tools
def test_khronos_validator_finds_nothing(tmp_path: Path) -> None:
    (tmp_path / "plain.glb").write_bytes(files()["transfer.glb"])
    (tmp_path / "pictured.glb").write_bytes(gltf.write(pictured(), {}, {}))
    broken = files()["transfer.glb"].replace(b'"VEC4"', b'"VEC5"')
    (tmp_path / "broken.glb").write_bytes(broken)
    plain, with_pictures, wrong = json.loads(
        node(tmp_path, [VALIDATOR], VALIDATE, "plain.glb", "pictured.glb", "broken.glb")
    )
    assert wrong["numErrors"] > 0
    assert plain["messages"] == []
    # Readers make tangents of the texture coordinates, as reliefs here mean.
    assert [one["code"] for one in with_pictures["messages"]] == ["MESH_PRIMITIVE_GENERATED_TANGENT_SPACE"]


THREE_READS = """
import { readFileSync } from "node:fs";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { uniforms } from "./transfer_uniforms.mjs";
globalThis.self = globalThis;
const bytes = readFileSync("transfer.glb");
const data = JSON.parse(readFileSync("transfer_uniforms.json", "utf8"));
const { sky, sun } = JSON.parse(readFileSync("light.json", "utf8"));
const light = uniforms(data, sky, sun);
const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
const { scene } = await new GLTFLoader().parseAsync(buffer, "");
const names = scene.children.map((mesh) => mesh.name);
const read = ["getX", "getY", "getZ", "getW"];
const lit = [];
for (const { geometry: { attributes } } of scene.children) {
  for (let v = 0; v < attributes.position.count; ++v) {
    const sum = [light[0], light[1], light[2]];
    for (let k = 0; k < data.components; ++k) {
      const value = attributes[`_transfer${k >> 2}`][read[k & 3]](v);
      for (let c = 0; c < 3; ++c) sum[c] += value * light[3 * (1 + k) + c];
    }
    lit.push(sum);
  }
}
console.log(JSON.stringify({ names, lit, dark: [...uniforms(data, sky)] }));
"""


@pytest.mark.tools
def test_three_js_reads_it_and_the_routine_lights_it(tmp_path: Path) -> None:
    for name, content in files().items():
        (tmp_path / name).write_bytes(content)
    sky, sun, made, expected = frame()
    wider = [np.concatenate([part, np.full((3, 7), 9e9)], axis=1).ravel().tolist() for part in (sky, sun)]
    (tmp_path / "light.json").write_text(json.dumps(dict(zip(("sky", "sun"), wider, strict=True))), encoding="utf-8")
    out = json.loads(node(tmp_path, [THREE], THREE_READS))
    assert out["names"] == ["floor", "wall", "box"]
    assert relative(np.array(out["lit"]), made[0] + compressed().components / 127 @ made[1:]) < 1e-5
    assert relative(np.array(out["lit"]), expected) < 0.025
    alone = compression.uniforms(compressed().matrix, sky, 0.0 * sun)
    assert relative(np.array(out["dark"]).reshape(-1, 3), alone) < 1e-5


def placed(folder: Path) -> Path:
    """The yard as a file."""
    (folder / "yard.glb").write_bytes(gltf.write(lit_yard()[0], {}, {}))
    return folder / "yard.glb"


def read_back(folder: Path, stem: str, published: Path) -> float:
    """What the published files lose of one sky's light, of the transfer in the HDF5 file beside them."""
    got = attributes((folder / f"{stem}.glb").read_bytes())
    told = json.loads((folder / f"{stem}_uniforms.json").read_text(encoding="utf-8"))
    vertices = np.concatenate([got[f"_TRANSFER{i}"] for i in range(5)], axis=1)
    with h5py.File(published) as file:
        direct, transfer = (np.asarray(file[name], dtype=np.float64) for name in ("direct", "transfer"))
    sky, sun = (part[7] for part in suns(60, 1, told["bands"]))
    frame = compression.uniforms(np.array(told["matrix"]), sky, sun)
    return relative(frame[0] + vertices @ frame[1:], exact(direct, transfer, sky, sun))


def test_a_run_of_a_scene_with_a_mesh_publishes_it(tmp_path: Path) -> None:
    placed(tmp_path)
    lines = 'mesh = { file = "yard.glb", rays = 64, gather_rays = 16, bounces = 1, bands = 3 }'
    made = run_quietly(scene_config(lines, folder=tmp_path), tmp_path)
    names = json.loads((made.folder / "run.json").read_text(encoding="utf-8"))["files"]
    assert set(files()) <= set(names)
    assert not any("transfer" in line for line in (made.folder / "SHA256SUMS").read_text(encoding="utf-8").splitlines())
    # The table is a small config's own, with skies other than the released one's.
    assert read_back(made.folder, "transfer", made.folder / "transfer.h5") < 0.1


def test_a_table_that_lights_nothing_in_three_colours_makes_no_files(tmp_path: Path) -> None:
    placed(tmp_path)
    lines = 'mesh = { file = "yard.glb", bands = 3 }'
    assert "engines" in [step.name for step in steps(scene_config(lines, folder=tmp_path))]
    for other in (lines.replace("3 }", "9 }"), f'{lines}\nquantity = "irradiance"'):
        names = [step.name for step in steps(scene_config(other, folder=tmp_path))]
        assert "transfer" in names
        assert "engines" not in names


def test_the_command_writes_it_too(tmp_path: Path) -> None:
    mesh, store = placed(tmp_path), str(tmp_path / "store")
    few = ("--bands", "3", "--rays", "64", "--gather-rays", "16", "--store", store, "--output", str(tmp_path / "yard.h5"))
    place = ("--gltf", str(tmp_path / "lit.glb"), "--table", str(TABLE))
    code, out, err = invoke("transfer", str(mesh), *few, *place)
    assert (code, err) == (0, "")
    assert "of 60 unseen suns compression loses" in out
    assert read_back(tmp_path, "lit", tmp_path / "yard.h5") < 0.03
    for wrong, message in (
        (place[:2], "Give both"),
        (("--gltf", str(tmp_path / "no" / "lit.glb"), *place[2:]), "Invalid --gltf"),
        ((*place, "--bands", "8"), "Give a table of at least 8"),
    ):
        code, _, err = invoke("transfer", str(mesh), *few, *wrong)
        assert code == 2
        assert message in err
