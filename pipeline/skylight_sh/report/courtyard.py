"""The courtyard as the report's page draws it: one small file of whole numbers, by columns, that a browser unpacks.

``courtyard.bin`` ships with the package, so that a run needs no ray caster. It holds what one camera sees, with transfer in
a few components a vertex (``transfer/compression.py``), what else casts shadows, and textures.
"""

from __future__ import annotations

import json
import struct
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

import numpy as np
from numpy.typing import NDArray

Ints = NDArray[np.int64]

FILE, POSTER = "courtyard.bin", "courtyard.webp"
BANDS = 7
"""Bands of its transfer."""
_LEVEL = 9


@dataclass(frozen=True)
class Packed:
    """Named columns of whole numbers, each ``(n,)``, ``blobs`` of bytes, such as pictures, and ``facts`` for JSON."""

    columns: Mapping[str, Ints]
    blobs: Mapping[str, bytes]
    facts: Mapping[str, Any]


def pack(packed: Packed) -> bytes:
    """Return the file: compressed, a header in JSON, then each column's differences, byte plane by byte plane, then blobs.

    A column takes as many bytes a number as its largest asks for; differences wrap.

    >>> unpack(pack(Packed({"a": np.array([7, -300, 70000])}, {}, {"b": 1}))).columns["a"].tolist()
    [7, -300, 70000]
    """
    listed, planes = [], []
    for name, values in packed.columns.items():
        whole = np.asarray(values, dtype=np.int64)
        steps = whole - np.concatenate([[0], whole[:-1]])
        size = _size(values)
        raw = (steps & ((1 << 8 * size) - 1)).astype("<u8").view(np.uint8).reshape(-1, 8)[:, :size]
        listed.append({"name": name, "count": len(values), "bytes": size})
        planes.append(np.ascontiguousarray(raw.T).tobytes())
    sizes = {name: len(blob) for name, blob in packed.blobs.items()}
    head = json.dumps({**packed.facts, "columns": listed, "blobs": sizes}, separators=(",", ":")).encode()
    return zlib.compress(struct.pack("<I", len(head)) + head + b"".join([*planes, *packed.blobs.values()]), _LEVEL)


def unpack(data: bytes) -> Packed:
    """Return what ``pack`` was given."""
    raw = zlib.decompress(data)
    (length,) = struct.unpack_from("<I", raw)
    facts = json.loads(raw[4 : 4 + length])
    start, columns = 4 + length, {}
    for column in facts.pop("columns"):
        count, size = column["count"], column["bytes"]
        planes = np.frombuffer(raw, np.uint8, count * size, start).reshape(size, count).astype(np.int64)
        start += count * size
        whole = np.cumsum(sum(planes[i] << 8 * i for i in range(size)))
        half = 1 << (8 * size - 1)
        columns[column["name"]] = (whole + half) % (2 * half) - half
    blobs = {}
    for name, size in facts.pop("blobs").items():
        blobs[name] = raw[start : start + size]
        start += size
    return Packed(columns, blobs, facts)


def shipped(name: str = FILE) -> bytes:
    """Return the bytes of a file that ships beside this module."""
    return files(__package__).joinpath(name).read_bytes()


def _size(values: Ints) -> int:
    """Return how many bytes hold each of the signed ``values``."""
    most = int(np.abs(values).max(initial=0))
    return next(size for size in range(1, 7) if most < 1 << (8 * size - 1))
