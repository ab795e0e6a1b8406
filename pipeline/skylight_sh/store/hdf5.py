"""Datasets as HDF5 files that xarray (h5netcdf) opens with named, unit-carrying coordinates."""

from __future__ import annotations

import os
import uuid
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from skylight_sh.store.dataset import Dataset, Variable, checksum

# 1: first layout. 2: what the artifact is (stage and key) and this version are under the checksum.
SCHEMA_VERSION = 2


class CorruptArtifactError(RuntimeError):
    """An artifact that cannot be read, does not match its checksum, or is another one than its file's name says."""


def write(path: Path, dataset: Dataset, identity: str = "") -> None:
    """Publish ``dataset`` at ``path`` atomically: a temporary file beside it, synced, then renamed.

    ``identity`` says which artifact this is; the checksum covers it, and ``read`` asks for it. Raises ValueError where the
    dataset has an attribute that the file needs itself.
    """
    sealed = _sealed(dataset, identity)
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.stem}.{uuid.uuid4().hex}.partial")
    try:
        with h5py.File(temporary, "w", libver="v110", track_order=False) as file:
            _fill(file, sealed)
        with open(temporary, "rb+") as written:
            os.fsync(written.fileno())
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def content(dataset: Dataset, identity: str = "") -> bytes:
    """Return the bytes of the file that ``write`` would publish."""
    with h5py.File("memory", "w", driver="core", backing_store=False, libver="v110", track_order=False) as file:
        _fill(file, _sealed(dataset, identity))
        file.flush()
        return bytes(file.id.get_file_image())


def read(path: Path, identity: str = "") -> Dataset:
    """Read a dataset and check its content, and that it is what was written as ``identity``.

    Raises CorruptArtifactError where it does not hold.
    """
    try:
        with h5py.File(path, "r") as file:
            variables: dict[str, Variable] = {}

            def visit(name: str, item: object) -> None:
                if isinstance(item, h5py.Dataset):
                    variables[name] = _read_variable(item)

            file.visititems(visit)
            attrs = {key: _plain(value) for key, value in file.attrs.items()}
        expected = attrs.pop(_CHECKSUM, None)
        found = checksum(Dataset(variables, attrs))
        version, told = (attrs.pop(name, None) for name in ("schema_version", "artifact"))
    except (OSError, KeyError, RuntimeError, ValueError, TypeError) as error:
        raise CorruptArtifactError(f"{path} cannot be read ({error}). Delete it; the next run makes it again.") from error
    # Before the checksum, which another version may have taken over something else.
    if str(version) != str(SCHEMA_VERSION):
        raise CorruptArtifactError(
            f"{path} has the layout {version!r}, not {SCHEMA_VERSION}. Delete it; the next run makes what it needs."
        )
    if found != expected:
        raise CorruptArtifactError(f"{path} does not match its checksum. Delete it; the next run makes it again.")
    if str(told) != identity:
        raise CorruptArtifactError(
            f"{path} holds the artifact {told!r}, not {identity!r}. Delete it; the next run makes it again."
        )
    return Dataset(variables, attrs)


def attributes(path: Path) -> dict[str, Any]:
    """Read the attributes of the whole, without a check of its content; none where the file cannot be read."""
    try:
        with h5py.File(path, "r") as file:
            return {key: _plain(value) for key, value in file.attrs.items()}
    except OSError:
        return {}


def _sealed(dataset: Dataset, identity: str) -> Dataset:
    taken = [name for name in (*_FILE_ATTRIBUTES, _CHECKSUM) if name in dataset.attrs]
    if taken:
        raise ValueError(f"Invalid attribute {taken[0]!r}. Should have another name: the store writes its own.")
    return Dataset(dataset.variables, {**dataset.attrs, "artifact": identity, "schema_version": SCHEMA_VERSION})


def _fill(file: Any, sealed: Dataset) -> None:
    for name in sorted(sealed.variables):
        _write_variable(file, name, sealed.variables[name])
    _attach_scales(file, sealed)
    for key in sorted(sealed.attrs):
        file.attrs[key] = sealed.attrs[key]
    file.attrs[_CHECKSUM] = checksum(sealed)


def _write_variable(file: Any, name: str, variable: Variable) -> None:
    data = variable.data
    kind = {"dtype": h5py.string_dtype()} if data.dtype.kind in "OUT" else {}
    item = file.create_dataset(name, data=data.astype(object) if kind else data, track_times=False, **kind)
    item.attrs["dims"] = " ".join(variable.dims)
    for key in sorted(variable.attrs):
        item.attrs[key] = variable.attrs[key]


def _attach_scales(file: Any, dataset: Dataset) -> None:
    scales = [name for name, v in dataset.variables.items() if v.dims == (name,)]
    for name in sorted(scales):
        file[name].make_scale(name)
    for name in sorted(dataset.variables):
        variable = dataset.variables[name]
        if variable.dims != (name,):
            for i, dim in enumerate(variable.dims):
                if dim in scales:
                    file[name].dims[i].attach_scale(file[dim])


# Of the file: under the checksum, and the checksum itself.
_FILE_ATTRIBUTES = ("artifact", "schema_version")
_CHECKSUM = "content_sha256"
# Of a variable.
_OWN_ATTRIBUTES = ("dims", "CLASS", "NAME", "DIMENSION_LIST", "REFERENCE_LIST")


def _read_variable(item: Any) -> Variable:
    data = item.asstr()[()] if h5py.check_string_dtype(item.dtype) else item[()]
    attrs = {key: _plain(value) for key, value in item.attrs.items() if key not in _OWN_ATTRIBUTES}
    return Variable(tuple(str(item.attrs["dims"]).split()), np.asarray(data), attrs)


def _plain(value: Any) -> Any:
    return value.item() if isinstance(value, np.generic) else value
