"""What an artifact holds: named arrays over named dimensions, with attributes. A plain value, no file behind it."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Attributes = Mapping[str, Any]


@dataclass(frozen=True)
class Variable:
    """An array over named dimensions; one whose only dimension is its own name gives that dimension's coordinates."""

    dims: tuple[str, ...]
    data: NDArray[Any]
    attrs: Attributes = field(default_factory=dict)


@dataclass(frozen=True)
class Dataset:
    """Variables by name (``/`` groups them) and attributes of the whole: numbers, booleans, strings, JSON."""

    variables: Mapping[str, Variable]
    attrs: Attributes = field(default_factory=dict)

    def __getitem__(self, name: str) -> NDArray[Any]:
        """Return the array called ``name``."""
        return self.variables[name].data


def checksum(dataset: Dataset) -> str:
    """Return the SHA-256 of a dataset's logical content: names, dims, dtypes, shapes, bytes and attributes.

    File layout, write order and HDF5 versions do not enter.

    >>> one = Dataset({"a": Variable(("n",), np.arange(2.0))})
    >>> checksum(one) == checksum(Dataset({"a": Variable(("n",), np.arange(2.0))}))
    True
    """
    digest = hashlib.sha256()
    for name in sorted(dataset.variables):
        variable = dataset.variables[name]
        _feed(digest, name, *variable.dims, *_pairs(variable.attrs))
        if variable.data.dtype.kind in "OUT":
            _feed(digest, "text", str(variable.data.shape), *(str(v) for v in variable.data.ravel()))
        else:
            data = np.ascontiguousarray(variable.data)
            _feed(digest, data.dtype.str, str(data.shape))
            digest.update(data.tobytes())
    _feed(digest, *_pairs(dataset.attrs))
    return digest.hexdigest()


def _pairs(attrs: Attributes) -> list[str]:
    return [text for key in sorted(attrs) for text in (key, repr(_plain(attrs[key])))]


def _plain(value: Any) -> Any:
    return value.tolist() if isinstance(value, np.ndarray | np.generic) else value


def _feed(digest: Any, *texts: str) -> None:
    for text in texts:
        encoded = text.encode()
        digest.update(len(encoded).to_bytes(8, "little"))
        digest.update(encoded)
