"""Stages' results as files: their bytes live in the store, or are made of it, and are published under ``reports/``."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from skylight_sh.store.dataset import Dataset, Variable

TRANSFER_FILE = "transfer.h5"
_PLACE = "files/"
# What an artifact tells of itself and its maker, which no result hangs on.
_OF_THE_STORE = ("step", "key", "provenance")


def to_dataset(files: Mapping[str, bytes]) -> Dataset:
    """Hold ``files`` (relative path to content) as an artifact."""
    return Dataset({_PLACE + path: Variable(("byte",), np.frombuffer(data, dtype=np.uint8)) for path, data in files.items()})


def from_dataset(dataset: Dataset) -> dict[str, bytes]:
    """Return the files of an artifact.

    >>> from_dataset(to_dataset({"a.txt": b"told"}))
    {'a.txt': b'told'}
    """
    return {name.removeprefix(_PLACE): v.data.tobytes() for name, v in dataset.variables.items() if name.startswith(_PLACE)}


def transfer_file(dataset: Dataset) -> bytes:
    """Return the file that is published of a mesh's transfer: the artifact without what tells of its maker."""
    from skylight_sh.store import hdf5

    attrs = {name: value for name, value in dataset.attrs.items() if name not in _OF_THE_STORE}
    return hdf5.content(Dataset(dataset.variables, attrs), "transfer")
