"""Tables as NPZ files: fixed key order, no compression, no dates, no pickle. ``runtime.read`` reads them.

``header`` is JSON: ``format`` and ``table``, every dataclass of ``runtime`` as an object that says which it ``is``; arrays
and bytes stand beside it under their fields' names.
"""

from __future__ import annotations

import io
import json
import zipfile
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh.runtime import FORMAT, Table

_NO_DATE = (1980, 1, 1, 0, 0, 0)
# Their small whole numbers take a byte.
_BYTES = ("rest_profile", "channel_profile")


def write(table: Table) -> bytes:
    """Return the bytes of ``table`` as an NPZ archive; equal tables give equal bytes."""
    arrays: dict[str, NDArray[Any]] = {}
    header = {"format": FORMAT, "table": _encoded(table, "table", arrays)}
    return archive({"header": np.array(json.dumps(header, sort_keys=True)), **arrays})


def archive(arrays: Mapping[str, NDArray[Any]]) -> bytes:
    """Return the bytes of an NPZ of ``arrays``: in their order, uncompressed, without dates.

    >>> archive({"one": np.ones(3)}) == archive({"one": np.ones(3)})
    True
    """
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_STORED) as file:
        for key, array in arrays.items():
            member = io.BytesIO()
            np.lib.format.write_array(member, np.ascontiguousarray(array) if array.ndim else array, allow_pickle=False)
            file.writestr(zipfile.ZipInfo(f"{key}.npy", _NO_DATE), member.getvalue())
    return out.getvalue()


def _encoded(value: Any, name: str, arrays: dict[str, NDArray[Any]]) -> Any:
    """Return ``value`` as JSON-like data; arrays are put aside under the names of the fields that hold them."""
    if is_dataclass(value) and not isinstance(value, type):
        parts = {f.name: _encoded(getattr(value, f.name), f.name, arrays) for f in fields(value)}
        return {"is": type(value).__name__, **parts}
    if isinstance(value, np.ndarray):
        arrays[name] = value.astype(np.int8) if name in _BYTES else value
        return {"array": name}
    if isinstance(value, bytes):
        arrays[name] = np.frombuffer(value, dtype=np.uint8)
        return {"bytes": name}
    if isinstance(value, Mapping):
        return {"json": value}
    if isinstance(value, tuple | list):
        return [_encoded(part, name, arrays) for part in value]
    return value
