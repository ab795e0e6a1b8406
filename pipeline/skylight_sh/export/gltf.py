"""Meshes as binary glTF 2.0: one set of vertices, one mesh a part, and what else a shader wants of a vertex."""

from __future__ import annotations

import json
import struct
from collections.abc import Callable, Mapping
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
    1 / 127); names of one's own begin with an underscore. Every part is a mesh of its own, with its name, over its range of
    the vertices, which stand in the mesh's order; albedo is ``COLOR_0``, linear, in 16 bits; textures and reliefs are PNG
    files inside. ``extras`` are the whole file's.
    """
    made = _Buffer()
    # Which count as numbers from -1 or 0 to 1.
    whole = {"COLOR_0": _shorts(mesh.albedo), **{name: values.astype("i1") for name, values in bytes_of.items()}}
    real = {"POSITION": _turned(mesh.positions), "NORMAL": _turned(mesh.normals)}
    if any(part.texture is not None or part.relief is not None for part in mesh.parts):
        # Their first row is at v = 1 here, at v = 0 in glTF.
        real["TEXCOORD_0"] = (mesh.uv * [1.0, -1.0] + [0.0, 1.0]).astype("<f4")
    attributes = {name: made.vertices(name, values) for name, values in (real | whole).items()}
    materials, material_of = _materials(mesh, made)
    meshes = []
    for part, (first, stop, indices) in made.triangles(mesh).items():
        own = {name: attribute(first, stop, normalized=name in whole) for name, attribute in attributes.items()}
        primitive = {"attributes": own, "indices": indices, "material": material_of[part]}
        meshes.append({"name": mesh.parts[part].name, "primitives": [primitive]})
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

    def view(self, data: bytes, **more: Number) -> int:
        """Add bytes, from a multiple of four on, and return their view's number."""
        self.data += bytes(-len(self.data) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data), **more})
        self.data += data
        return len(self.views) - 1

    def vertices(self, name: str, values: NDArray[Any]) -> Callable[..., int]:
        """Add an attribute ``(v, 2 to 4)`` of all vertices; return what makes the accessor of a range of them."""
        stride = values.itemsize * values.shape[1]
        view = self.view(np.ascontiguousarray(values).tobytes(), byteStride=stride, target=_VERTICES)

        def accessor(first: int, stop: int, *, normalized: bool) -> int:
            found = self._accessor(view, first * stride, values.dtype, stop - first, _KIND[values.shape[1]])
            if normalized:
                found["normalized"] = True
            if name == "POSITION":
                part = values[first:stop]
                found |= {"min": part.min(axis=0).tolist(), "max": part.max(axis=0).tolist()}
            self.accessors.append(found)
            return len(self.accessors) - 1

        return accessor

    def triangles(self, mesh: Mesh) -> dict[int, tuple[int, int, int]]:
        """Add the indices, part by part; return of each part that has triangles its vertices' range and its accessor.

        A part counts its vertices from the first one that it uses.
        """
        parts = {i: mesh.triangles[mesh.part == i] for i in range(len(mesh.parts))}
        ranges = {i: (int(one.min()), int(one.max()) + 1) for i, one in parts.items() if one.size}
        kind = np.dtype("<u2" if all(stop - first <= _MOST_SHORT for first, stop in ranges.values()) else "<u4")
        rebased = {i: parts[i].astype(np.int64) - first for i, (first, _) in ranges.items()}
        view = self.view(np.concatenate(list(rebased.values())).astype(kind).tobytes(), target=_INDICES)
        found, start = {}, 0
        for i, one in rebased.items():
            self.accessors.append(self._accessor(view, start, kind, one.size, "SCALAR"))
            found[i] = (*ranges[i], len(self.accessors) - 1)
            start += one.size * kind.itemsize
        return found

    def _accessor(self, view: int, start: int, kind: np.dtype[Any], count: int, shape: str) -> dict[str, Any]:
        of = {"componentType": _COMPONENT[kind.str[1:]], "count": count, "type": shape}
        return {"bufferView": view, **({"byteOffset": start} if start else {}), **of}

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
