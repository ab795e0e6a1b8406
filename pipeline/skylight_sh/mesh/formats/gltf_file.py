"""What a glTF file holds, as JSON and bytes: containers, buffers, accessors, each looked at before it is believed."""

from __future__ import annotations

import base64
import json
import math
import struct
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import unquote, unquote_to_bytes

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError
from skylight_sh.mesh.formats.protocol import MOST_VERTICES, check_count

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Json = dict[str, Any]

_MAGIC, _JSON, _BIN = b"glTF", 0x4E4F534A, 0x004E4942
_KINDS = {5120: "i1", 5121: "u1", 5122: "i2", 5123: "u2", 5125: "u4", 5126: "f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
_ANEW = "Export it anew."


def whole(values: Json, key: str, default: int | None = None) -> int:
    """Return a whole number of at least 0. Raises UserError where there is none, and no default."""
    found = values.get(key, default)
    if isinstance(found, bool) or not isinstance(found, int) or not 0 <= found < 1 << 53:
        raise UserError(f"glTF: {key!r} is {str(found)[:40]}. Should be a whole number. {_ANEW}")
    return found


def numbers(values: Json, key: str, default: list[float]) -> Array:
    """Return as many finite numbers as the default has. Raises UserError for anything else."""
    found = values.get(key, default)
    right = isinstance(found, list) and len(found) == len(default)
    if not right or not all(isinstance(n, int | float) and abs(n) < 1e300 and not math.isnan(n) for n in found):
        raise UserError(f"glTF: {key!r} is {str(found)[:40]}. Should be {len(default)} finite numbers. {_ANEW}")
    return np.array(found, np.float64)


def number(values: Json, key: str, default: float) -> float:
    """Return one finite number. Raises UserError for anything else."""
    return float(numbers({key: [values.get(key, default)]}, key, [default])[0])


def inner(values: Json, key: str) -> Json:
    """Return an object inside another, empty where there is none. Raises UserError where it is something else."""
    found = values.get(key, {})
    if not isinstance(found, dict):
        raise UserError(f"glTF: {key!r} is {str(found)[:40]}. Should be an object. {_ANEW}")
    return found


def listed(values: Json, key: str) -> list[Any]:
    """Return a list inside an object, empty where there is none. Raises UserError where it is something else."""
    found = values.get(key, [])
    if not isinstance(found, list):
        raise UserError(f"glTF: {key!r} is {str(found)[:40]}. Should be a list. {_ANEW}")
    return found


def objects(values: Json, key: str) -> list[Json]:
    """Return a list of objects, as ``listed`` does."""
    found = listed(values, key)
    if not all(isinstance(one, dict) for one in found):
        raise UserError(f"glTF: {key!r} should be a list of objects. {_ANEW}")
    return found


def name_of(values: Json, default: str) -> str:
    """Return an object's name."""
    found = values.get("name")
    return found if isinstance(found, str) and found else default


@dataclass
class Document:
    """A glTF file: its ``root``, the folder that it names files from, and a GLB's own bytes."""

    root: Json
    folder: Path
    chunk: bytes | None = None
    _buffers: dict[int, bytes] = field(default_factory=dict)

    def one(self, kind: str, index: int) -> Json:
        """Return an entry of a list of the root. Raises UserError where there is none."""
        entries = objects(self.root, kind)
        if not 0 <= index < len(entries):
            raise UserError(
                f"glTF: index {index} out of range. Should be below {len(entries)}, the number of {kind}. {_ANEW}"
            )
        return entries[index]

    def data(self, values: Json) -> bytes | Path:
        """Return the bytes of a buffer or an image, or the file that it names."""
        uri = values.get("uri")
        if not isinstance(uri, str):
            raise UserError(f"glTF: 'uri' is {str(uri)[:40]}. Should be a text. {_ANEW}")
        if uri.startswith("data:"):
            head, _, text = uri.partition(",")
            try:
                return base64.b64decode(text, validate=True) if head.endswith(";base64") else unquote_to_bytes(text)
            except ValueError as error:
                raise UserError(f"glTF: a data URI cannot be decoded ({error}). {_ANEW}") from error
        if "://" in uri:
            raise UserError(f"glTF: {uri[:60]!r} is on the network. Should be a file beside the mesh. Copy it there.")
        return self.folder / unquote(uri)

    def buffer(self, index: int) -> bytes:
        """Return the bytes of a buffer. Raises UserError where they are missing or fewer than told."""
        if index not in self._buffers:
            values = self.one("buffers", index)
            length = whole(values, "byteLength")
            if "uri" not in values and index == 0 and self.chunk is not None:
                found: bytes | Path = self.chunk
            else:
                found = self.data(values)
            if isinstance(found, Path):
                if not found.is_file():
                    raise UserError(f"glTF: no file {found.name!r} beside the mesh. Copy it there.")
                found = found.read_bytes()
            if len(found) < length:
                raise UserError(f"glTF: buffer {index} has {len(found)} bytes. Should have {length}. {_ANEW}")
            self._buffers[index] = found[:length]
        return self._buffers[index]

    def view(self, index: int) -> tuple[bytes, int]:
        """Return the bytes of a view of a buffer, and its stride or 0."""
        values = self.one("bufferViews", index)
        number = whole(values, "buffer")
        for extension in inner(values, "extensions"):
            told = inner(inner(self.one("buffers", number), "extensions"), extension)
            if "meshopt" in extension and (told.get("fallback") or "uri" not in self.one("buffers", number)):
                raise UserError(f"glTF: its data are compressed by {extension}. Export without compression.")
        data = self.buffer(number)
        start, length = whole(values, "byteOffset", 0), whole(values, "byteLength")
        if start + length > len(data):
            raise UserError(f"glTF: view {index} ends at byte {start + length} of {len(data)}. {_ANEW}")
        return data[start : start + length], whole(values, "byteStride", 0)

    def accessor(self, index: int, widths: tuple[int, ...]) -> Array:
        """Return the numbers ``(n, width)`` of an accessor, whose width must be one of ``widths``; normalised if it says so.

        Sparse accessors have their replacements in place, those without a view are 0 elsewhere.
        """
        values = self.one("accessors", index)
        kind, width = _KINDS.get(whole(values, "componentType")), _WIDTHS.get(str(values.get("type")))
        if kind is None or width not in widths:
            raise UserError(
                f"glTF: accessor {index} holds {str(values.get('type'))[:20]} of component type "
                f"{values.get('componentType')}. Should be of {' or '.join(map(str, widths))} components. {_ANEW}"
            )
        count = whole(values, "count")
        # Three indices a triangle.
        check_count(count, "elements of an accessor", 3 * MOST_VERTICES)
        found = np.zeros((count, width), kind)
        if "bufferView" in values:
            found = self._strided(values, kind, count, width)
        if "sparse" in values:
            sparse = inner(values, "sparse")
            places, some = inner(sparse, "indices"), whole(sparse, "count")
            check_count(some, "elements of an accessor", 3 * MOST_VERTICES)
            at_kind = _KINDS.get(whole(places, "componentType"), "f4")
            at = self._strided(places, at_kind, some, 1)[:, 0]
            if at_kind == "f4" or (at >= count).any():
                raise UserError(
                    f"glTF: a sparse index of accessor {index} is out of range. Should be below {count}. {_ANEW}"
                )
            found = found.copy()
            found[at] = self._strided(inner(sparse, "values"), kind, some, width)
        if values.get("normalized") is True and kind != "f4":
            return np.maximum(found.astype(np.float64) / np.iinfo(kind).max, -1.0)
        return found.astype(np.float64)

    def _strided(self, values: Json, kind: str, count: int, width: int) -> NDArray[Any]:
        data, stride = self.view(whole(values, "bufferView"))
        offset, dtype = whole(values, "byteOffset", 0), np.dtype("<" + kind)
        element = dtype.itemsize * width
        stride = stride or element
        if stride < element or (count and offset + stride * (count - 1) + element > len(data)):
            raise UserError(
                f"glTF: an accessor of {count} elements needs more than the {len(data)} bytes of its view. {_ANEW}"
            )
        if not count:
            return np.zeros((0, width), dtype)
        return np.ndarray((count, width), dtype, data, offset, (stride, dtype.itemsize))


def load(path: Path) -> Document:
    """Return a file's JSON and bytes, whether it is text or a GLB. Raises UserError for anything else."""
    data = path.read_bytes()
    text, chunk = _chunks(data) if data.startswith(_MAGIC) else (data, None)
    try:
        root = json.loads(text.decode("utf-8-sig"), parse_constant=_no_number)
    except (ValueError, RecursionError) as error:
        raise UserError(f"The file is no glTF: its JSON cannot be read ({error}). {_ANEW}") from error
    if not isinstance(root, dict):
        raise UserError(f"The file is no glTF: its JSON is no object. {_ANEW}")
    version = inner(root, "asset").get("version")
    if not (isinstance(version, str) and version.startswith("2.")):
        raise UserError(f"The file is glTF of version {str(version)[:20]}. Should be 2.0. Export it as that.")
    return Document(root, path.parent, chunk)


def _no_number(name: str) -> None:
    raise ValueError(f"{name} is no number")


def _chunks(data: bytes) -> tuple[bytes, bytes | None]:
    """Return the JSON and the bytes of a GLB."""
    version, length = struct.unpack("<II", data[4:12]) if len(data) >= 12 else (2, 12)
    if version != 2:
        raise UserError(f"The GLB is of version {version}. Should be 2. Export it as that.")
    if length > len(data) or len(data) < 20:
        raise UserError(f"The GLB ends after {len(data)} bytes. Should have {length}. Copy or export it anew.")
    found: dict[int, bytes] = {}
    at = 12
    while at + 8 <= length:
        size, kind = struct.unpack("<II", data[at : at + 8])
        if at + 8 + size > length:
            raise UserError(f"A chunk of the GLB ends at byte {at + 8 + size} of {length}. Copy or export it anew.")
        found.setdefault(kind, data[at + 8 : at + 8 + size])
        at += 8 + size
    if _JSON not in found:
        raise UserError(f"The GLB has no JSON. {_ANEW}")
    return found[_JSON], found.get(_BIN)
