"""Meshes written as files by tests: a cube and what is done to it."""

from __future__ import annotations

import base64
import json
import struct
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from skylight_sh import mesh

CUBE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
# Anticlockwise from outside.
QUADS = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
TRIANGLES = [[q[0], q[i], q[i + 1]] for q in QUADS for i in (1, 2)]

Read = tuple[mesh.Mesh, tuple[mesh.Finding, ...]]


def obj(positions: NDArray[np.float64], faces: Sequence[Sequence[int]], start: int = 1) -> str:
    """Lines of an OBJ file; ``start`` is the first vertex's number."""
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in np.asarray(positions, float).tolist()]
    return "\n".join([*lines, *("f " + " ".join(str(i + start) for i in face) for face in faces), ""])


def ply(positions: NDArray[np.float64], faces: Sequence[Sequence[int]], kind: str = "ascii") -> bytes:
    """Bytes of a PLY file of doubles."""
    head = (
        f"ply\nformat {kind} 1.0\nelement vertex {len(positions)}\nproperty double x\nproperty double y\nproperty double z\n"
    )
    head += f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    points = np.asarray(positions, float)
    if kind == "ascii":
        rows = [" ".join(map(repr, point)) for point in points.tolist()]
        rows += [" ".join(map(str, [len(face), *face])) for face in faces]
        return (head + "\n".join([*rows, ""])).encode()
    order = "<" if "little" in kind else ">"
    body = points.astype(order + "f8").tobytes()
    return head.encode() + body + b"".join(bytes([len(f)]) + np.array(f, order + "i4").tobytes() for f in faces)


class Gltf:
    """A glTF file in the making: ``root`` and its one buffer."""

    def __init__(self, **root: Any) -> None:
        self.root: dict[str, Any] = {"asset": {"version": "2.0"}, "bufferViews": [], "accessors": [], **root}
        self.data = b""

    def view(self, data: bytes, **more: Any) -> int:
        """Add bytes, aligned to 4, and return their view's number."""
        self.data += bytes(-len(self.data) % 4)
        self.root["bufferViews"].append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data), **more})
        self.data += data
        return len(self.root["bufferViews"]) - 1

    def accessor(self, values: Any, kind: str = "f4", **more: Any) -> int:
        """Add numbers and return their accessor's number."""
        array = np.asarray(values).astype("<" + kind)
        component = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123, "u4": 5125, "f4": 5126}[kind]
        shape = "SCALAR" if array.ndim == 1 else f"VEC{array.shape[1]}"
        told = {"bufferView": self.view(array.tobytes()), "componentType": component, "type": shape, "count": len(array)}
        self.root["accessors"].append({key: value for key, value in {**told, **more}.items() if value is not None})
        return len(self.root["accessors"]) - 1

    def glb(self) -> bytes:
        """Return the whole as one binary file."""
        text = json.dumps({**self.root, "buffers": [{"byteLength": len(self.data)}]}).encode()
        text += b" " * (-len(text) % 4)
        data = self.data + bytes(-len(self.data) % 4)
        chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(data), 0x004E4942) + data
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks

    def text(self) -> str:
        """Return the whole as text, its buffer inside."""
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
        return json.dumps({**self.root, "buffers": [{"byteLength": len(self.data), "uri": uri}]})


def cube_gltf(**root: Any) -> Gltf:
    """A glTF file of one mesh, the cube, and one node ``box``, unless told otherwise."""
    made = Gltf(**{"nodes": [{"mesh": 0, "name": "box"}], **root})
    attributes = {"POSITION": made.accessor(CUBE)}
    made.root["meshes"] = [{"primitives": [{"attributes": attributes, "indices": made.accessor(np.ravel(TRIANGLES), "u2")}]}]
    return made


def read(path: Path, content: str | bytes, up: str | None = None) -> Read:
    """Write a file and read it as a mesh."""
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return mesh.read(path, up)


def kinds(read: Read) -> dict[str, int]:
    """How often each kind of finding was counted, over all parts, but for what a bare file lacks."""
    found: dict[str, int] = {}
    for one in read[1]:
        if one.kind not in ("no albedo", "no normals"):
            found[one.kind] = found.get(one.kind, 0) + one.count
    return found


def volume(found: mesh.Mesh) -> float:
    """The signed volume that a mesh encloses, by the divergence theorem."""
    a, b, c = np.moveaxis(found.corners, 1, 0)
    return float(np.einsum("ti,ti->", a, np.cross(b, c))) / 6.0
