"""Stages whose result is files: their bytes live in the store, and are published under ``reports/``."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from skylight_sh.store.dataset import Dataset, Variable

_PLACE = "files/"


def to_dataset(files: Mapping[str, bytes]) -> Dataset:
    """Hold ``files`` (relative path to content) as an artifact."""
    return Dataset({_PLACE + path: Variable(("byte",), np.frombuffer(data, dtype=np.uint8)) for path, data in files.items()})


def from_dataset(dataset: Dataset) -> dict[str, bytes]:
    """Return the files of an artifact.

    >>> from_dataset(to_dataset({"a.txt": b"told"}))
    {'a.txt': b'told'}
    """
    return {name.removeprefix(_PLACE): v.data.tobytes() for name, v in dataset.variables.items() if name.startswith(_PLACE)}
