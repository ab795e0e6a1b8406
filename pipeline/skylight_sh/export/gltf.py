"""Meshes as binary glTF 2.0: one set of vertices, one mesh a part, and what else a shader wants of a vertex."""

from __future__ import annotations

import json
import struct
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh import __version__
from skylight_sh.mesh import Mesh
from skylight_sh.probe.files import to_srgb
from skylight_sh.render.files import png

Array = NDArray[np.float64]
Number = str | int | float | bool

AXES = "x=+x,y=-z,z=+y"
"""Where east, north and up go: glTF has y up; see ``engines.parse_axes``."""

_MAGIC, _VERSION = b"glTF", 2
_JSON, _BINARY = b"JSON", b"BIN\0"
_VERTICES, _INDICES = 34962, 34963
_COMPONENT = {"i1": 5120, "u1": 5121, "u2": 5123, "u4": 5125, "f4": 5126}
_KIND = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}
# The largest index of 16 bits restarts a strip.
_MOST_SHORT = 65535


def write(mesh: Mesh, bytes_of: Mapping[str, NDArray[np.int8]], extras: Mapping[str, Any]) -> bytes:
    """Return ``mesh`` as a GLB file (Khronos glTF 2.0, chapter 4): the same input gives the same bytes.

    ``bytes_of`` holds attributes of the vertices by name, ``(v, 4)`` each, which count as numbers from -1 to 1 (steps of
    1 / 127); names of one's own begin with an underscore. Every part is a mesh of its own, with its name, over the same
    vertices; albedo is ``COLOR_0``, linear, in 16 bits; textures and reliefs are PNG files inside. ``extras`` are the whole
    file's.
    """
    made = _Buffer()
    attributes = {
        "POSITION": made.vertices(_turned(mesh.positions), bounds=True),
        "NORMAL": made.vertices(_turned(mesh.normals)),
        "COLOR_0": made.vertices(_shorts(mesh.albedo), normalized=True),
    }
    if any(part.texture is not None or part.relief is not None for part in mesh.parts):
        # Their first row is at v = 1 here, at v = 0 in glTF.
        attributes["TEXCOORD_0"] = made.vertices((mesh.uv * [1.0, -1.0] + [0.0, 1.0]).astype("<f4"))
    attributes |= {name: made.vertices(values.astype("i1"), normalized=True) for name, values in bytes_of.items()}
    materials, material_of = _materials(mesh, made)
    primitives = made.triangles(mesh)
    meshes = [
        {
            "name": mesh.parts[i].name,
            "primitives": [{"attributes": attributes, "indices": indices, "material": material_of[i]}],
        }
        for i, indices in primitives.items()
    ]
    document = {
        "asset": {"version": "2.0", "generator": f"skylight-sh {__version__}"},
        "extras": dict(extras),
        "scene": 0,
        "scenes": [{"nodes": list(range(len(meshes)))}],
        "nodes": [{"name": one["name"], "mesh": i} for i, one in enumerate(meshes)],
        "meshes": meshes,
        "materials": materials,
        **made.listed(),
    }
    return _container(document, bytes(made.data))


class _Buffer:
    """The file's one buffer in the making, and its views, accessors and pictures."""

    def __init__(self) -> None:
        self.data = bytearray()
        self.views: list[dict[str, Number]] = []
        self.accessors: list[dict[str, Any]] = []
        self.images: list[dict[str, Number]] = []
        self.pictures: dict[bytes, int] = {}

    def view(self, data: bytes, target: int | None = None) -> int:
        """Add bytes, from a multiple of four on, and return their view's number."""
        self.data += bytes(-len(self.data) % 4)
        view: dict[str, Number] = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)}
        self.views.append(view if target is None else view | {"target": target})
        self.data += data
        return len(self.views) - 1

    def vertices(self, values: NDArray[Any], *, normalized: bool = False, bounds: bool = False) -> int:
        """Add an attribute ``(v, 2 to 4)`` of the vertices and return its accessor's number."""
        found: dict[str, Any] = {
            "bufferView": self.view(np.ascontiguousarray(values).tobytes(), _VERTICES),
            "componentType": _COMPONENT[values.dtype.str[1:]],
            "count": len(values),
            "type": _KIND[values.shape[1]],
        }
        if normalized:
            found["normalized"] = True
        if bounds:
            found |= {"min": values.min(axis=0).tolist(), "max": values.max(axis=0).tolist()}
        self.accessors.append(found)
        return len(self.accessors) - 1

    def triangles(self, mesh: Mesh) -> dict[int, int]:
        """Add the indices, part by part, and return the accessor of each part that has triangles."""
        order = np.argsort(mesh.part, kind="stable")
        kind = "<u2" if len(mesh.positions) <= _MOST_SHORT else "<u4"
        view = self.view(mesh.triangles[order].astype(kind).tobytes(), _INDICES)
        ends = np.searchsorted(mesh.part[order], np.arange(len(mesh.parts) + 1))
        found = {}
        for i, (start, stop) in enumerate(zip(ends[:-1].tolist(), ends[1:].tolist(), strict=True)):
            if start < stop:
                self.accessors.append(
                    {
                        "bufferView": view,
                        "byteOffset": 3 * start * np.dtype(kind).itemsize,
                        "componentType": _COMPONENT[kind[1:]],
                        "count": 3 * (stop - start),
                        "type": "SCALAR",
                    }
                )
                found[i] = len(self.accessors) - 1
        return found

    def picture(self, srgb: Array) -> int:
        """Add a picture ``(rows, columns, 3)`` of numbers from 0 to 1 as they are to be stored; return its texture."""
        data = png(srgb)
        if data not in self.pictures:
            self.pictures[data] = len(self.images)
            self.images.append({"bufferView": self.view(data), "mimeType": "image/png"})
        return self.pictures[data]

    def listed(self) -> dict[str, Any]:
        """Return what the document says of the buffer."""
        out: dict[str, Any] = {
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": len(self.data)}],
        }
        if self.images:
            out |= {"images": self.images, "textures": [{"source": i} for i in range(len(self.images))]}
        return out


def _materials(mesh: Mesh, made: _Buffer) -> tuple[list[dict[str, Any]], list[int]]:
    """Return the materials, and which is each part's: parts of the same pictures share one."""
    found: dict[tuple[bytes, bytes], int] = {}
    materials: list[dict[str, Any]] = []
    of_part = []
    for part in mesh.parts:
        key = (_key(part.texture), _key(part.relief))
        if key not in found:
            found[key] = len(materials)
            rough: dict[str, Any] = {"metallicFactor": 0.0, "roughnessFactor": 1.0}
            material: dict[str, Any] = {"pbrMetallicRoughness": rough}
            if part.texture is not None:
                rough["baseColorTexture"] = {"index": made.picture(to_srgb(np.clip(part.texture, 0.0, 1.0)))}
            if part.relief is not None:
                material["normalTexture"] = {"index": made.picture(0.5 + 0.5 * part.relief)}
            materials.append(material)
        of_part.append(found[key])
    return materials, of_part


def _key(picture: Array | None) -> bytes:
    return b"" if picture is None else repr(picture.shape).encode() + np.ascontiguousarray(picture).tobytes()


def _turned(vectors: Array) -> NDArray[np.float32]:
    """Return vectors ``(v, 3)`` in glTF's axes."""
    return np.stack([vectors[:, 0], vectors[:, 2], -vectors[:, 1]], axis=-1).astype("<f4")


def _shorts(albedo: Array) -> NDArray[np.uint16]:
    """Return linear RGB as RGBA of 16 bits."""
    colours = np.concatenate([np.clip(albedo, 0.0, 1.0), np.ones((len(albedo), 1))], axis=1)
    return np.asarray(np.rint(65535 * colours), dtype="<u2")


def _container(document: Mapping[str, Any], data: bytes) -> bytes:
    text = json.dumps(document, separators=(",", ":"), ensure_ascii=False, allow_nan=False).encode()
    chunks = [(_JSON, text + b" " * (-len(text) % 4)), (_BINARY, data + bytes(-len(data) % 4))]
    body = b"".join(struct.pack("<I4s", len(part), kind) + part for kind, part in chunks)
    return struct.pack("<4sII", _MAGIC, _VERSION, 12 + len(body)) + body
