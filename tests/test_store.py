"""The store: round trips, checksums, atomic publication, keys, and files that others can open."""

from __future__ import annotations

import os
from pathlib import Path

import h5py
import numpy as np
import pytest
import xarray
from hypothesis import given
from hypothesis import strategies as st
from skylight_sh.run.runner import Result
from skylight_sh.store import hdf5
from skylight_sh.store.dataset import Dataset, Variable, checksum
from skylight_sh.store.hdf5 import CorruptArtifactError
from skylight_sh.store.keys import digest
from skylight_sh.store.store import Store

KEY = "a" * 64


def sample() -> Dataset:
    return Dataset(
        {
            "x": Variable(("x",), np.linspace(0.0, 1.0, 4), {"units": "rad"}),
            "channel": Variable(("channel",), np.array(["red", "grün"])),
            "group/values": Variable(("x", "channel"), np.arange(8.0).reshape(4, 2)),
            "single": Variable((), np.array(3)),
        },
        {"note": "ü", "flag": True, "count": 7, "share": 0.25},
    )


def same(one: Dataset, other: Dataset) -> bool:
    return one.variables.keys() == other.variables.keys() and checksum(one) == checksum(other)


def test_what_is_put_comes_back(tmp_path: Path) -> None:
    store = Store(tmp_path)
    store.put("truth", KEY, sample())
    got = store.get("truth", KEY)
    assert same(got, sample())
    assert got.variables["x"].attrs == {"units": "rad"}
    assert [(e.stage, e.key) for e in store.entries()] == [("truth", KEY)]


@given(st.integers(0, 10**6))
def test_checksum_sees_every_part(seed: int) -> None:
    rng = np.random.default_rng(seed)
    data = sample()
    name = sorted(data.variables)[seed % 4]
    old = data.variables[name]
    if old.data.dtype.kind == "U":
        changed = Variable(old.dims, np.array(["red", "green"]))
    else:
        flat = old.data.copy().reshape(-1)
        flat[rng.integers(flat.size)] += 1
        changed = Variable(old.dims, flat.reshape(old.data.shape), old.attrs)
    assert checksum(Dataset({**data.variables, name: changed}, data.attrs)) != checksum(data)
    assert checksum(Dataset(data.variables, {**data.attrs, "count": 8})) != checksum(data)


def test_equal_content_gives_equal_bytes(tmp_path: Path) -> None:
    paths = [tmp_path / "a.h5", tmp_path / "b.h5"]
    data = sample()
    for path, variables in zip(paths, (data.variables, dict(reversed(data.variables.items()))), strict=True):
        hdf5.write(path, Dataset(variables, data.attrs))
    assert paths[0].read_bytes() == paths[1].read_bytes()


def test_a_flipped_number_is_noticed(tmp_path: Path) -> None:
    store = Store(tmp_path)
    store.put("truth", KEY, sample())
    with h5py.File(store.path("truth", KEY), "r+") as file:
        file["group/values"][0, 0] += 1e-9
    with pytest.raises(CorruptArtifactError, match="checksum"):
        store.get("truth", KEY)


@pytest.mark.parametrize("keep", [0, 100, 2000])
def test_a_cut_file_is_noticed(tmp_path: Path, keep: int) -> None:
    store = Store(tmp_path)
    store.put("truth", KEY, sample())
    path = store.path("truth", KEY)
    path.write_bytes(path.read_bytes()[:keep])
    with pytest.raises(CorruptArtifactError):
        store.get("truth", KEY)


def test_a_failed_write_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    store = Store(tmp_path)
    with pytest.raises(TypeError):
        store.put("truth", KEY, Dataset({"bad": Variable((), np.array(1j, dtype="V8"))}, {"what": object()}))
    monkeypatch.setattr(os, "replace", lambda *_: (_ for _ in ()).throw(OSError("disk full")))
    with pytest.raises(OSError, match="disk full"):
        store.put("truth", KEY, sample())
    assert not any(p.is_file() for p in tmp_path.rglob("*"))


def test_collect_keeps_what_runs_use(tmp_path: Path) -> None:
    store = Store(tmp_path)
    other = "b" * 64
    for key in (KEY, other):
        store.put("truth", key, sample())
    store.keep("mine", [KEY])
    assert [e.key for e in store.collect()] == [other]
    assert [e.key for e in store.entries()] == [KEY]
    with pytest.raises(KeyError, match="No artifact"):
        store.find("b")
    assert store.find("aa").key == KEY


def test_keys_are_canonical() -> None:
    assert digest({"b": 1, "a": [1.5, "x"]}) == digest({"a": (1.5, "x"), "b": 1})
    assert digest({"a": 1}) != digest({"a": 1.0})
    with pytest.raises(ValueError, match="JSON"):
        digest(float("nan"))
    with pytest.raises(TypeError):
        digest(object())


def test_xarray_opens_a_truth_file_with_named_coordinates(small_run: Result) -> None:
    store = Store(small_run.folder.parents[1] / "artifacts")
    grid = next(e for e in store.entries() if store.get(e.stage, e.key).attrs["step"] == "truth/grid")
    with xarray.open_dataset(grid.path, engine="h5netcdf") as opened:
        assert opened["weights"].dims == ("sun_zenith", "turbidity", "channel", "weight")
        assert opened["weights"].shape == (12, 8, 3, 10)
        assert opened["sun_zenith"].attrs["units"] == "rad"
        assert opened["weights"].attrs["units"] == "cd m-2 sr0.5"
        assert opened["channel"].values.tolist() == ["red", "green", "blue"]
        assert opened["order"].values.tolist() == [0, 0, 1, 0, 1, 2, 0, 1, 2, 3]
        assert float(opened["least_luminance"].min()) > 0
        nearest = opened["weights"].sel(sun_zenith=0.8, turbidity=3.0, method="nearest")
        assert nearest.shape == (3, 10)
        assert "provenance" in opened.attrs
