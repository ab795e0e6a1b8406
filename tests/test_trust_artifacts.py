"""Artifacts under another's name: whatever is swapped for whatever, it is refused or made again, and the bytes are right."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import numpy as np
import pytest
from conftest import SMALL
from skylight_sh.config import Config, load
from skylight_sh.run import plan
from skylight_sh.run.runner import run
from skylight_sh.run.steps import steps
from skylight_sh.store import hdf5
from skylight_sh.store.hdf5 import CorruptArtifactError
from skylight_sh.store.store import Entry, Store
from test_cli import invoke
from test_run import published

SWAPS = 100
# What of tests/small.toml each config changes: some artifacts are shared, most are not.
EDITS = (("seed = 2008", "seed = 2008"), ("seed = 2008", "seed = 9"), ('"preetham"', '"preetham"\nconstants = "smits"'))


def configs(folder: Path) -> list[Config]:
    text = SMALL.read_text(encoding="utf-8")
    for old, new in (
        ("random = 40", "random = 20\nseed = 2008"),
        ("bands = 4\ntolerance = 1e-8", "bands = 3\ntolerance = 1e-6"),
        ('[[winners]]\nbands = 4\nbudgets = [0.05, 0.01]\nlayouts = ["rows", "packed"]\n', ""),
        ("nodes = 12\nverification = 37\ndegrees = [3, 9]", "nodes = 8\nverification = 25\ndegrees = [6, 6]"),
        ("nodes = 8\nverification = 25\ndegrees = [1, 6]", "nodes = 6\nverification = 17\ndegrees = [4, 4]"),
        ('recommended = "4-bands-1pct"', 'recommended = "3-bands-degrees-6-4-float64"'),
        ('figures = ["bands"]', "figures = []"),
    ):
        assert old in text, old
        text = text.replace(old, new)
    text = text[: text.index("[[report.cases]]")]
    made = []
    for i, (old, new) in enumerate(EDITS):
        path = folder / f"{i}.toml"
        path.write_text(text.replace('name = "small"', f'name = "swap{i}"').replace(old, new), encoding="utf-8")
        made.append(load(path))
    return made


class World:
    """Three configs' runs in one store, with a copy of it as it should be."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.configs = folder, configs(folder)
        self.store = Store(folder / "artifacts")
        self.right = [self.run(config) for config in self.configs]
        assert len({files["export/skylight_sh.npz"] for files in self.right}) == len(self.configs)
        shutil.copytree(self.store.root, folder / "right")
        self.entries = self.store.entries()
        self.owners: dict[str, list[int]] = {}
        for i, config in enumerate(self.configs):
            for key in plan.keys(steps(config)).values():
                self.owners.setdefault(key, []).append(i)

    def run(self, config: Config, warnings: list[str] | None = None) -> dict[str, bytes]:
        told: list[str] = []
        shutil.rmtree(self.folder / "reports", ignore_errors=True)
        files = published(run(config, self.store, self.folder / "reports", told.append).folder)
        assert told == [] if warnings is None else True
        if warnings is not None:
            warnings += told
        return files

    def restore(self) -> None:
        shutil.rmtree(self.store.root)
        shutil.copytree(self.folder / "right", self.store.root)


@pytest.fixture(scope="module")
def world(tmp_path_factory: pytest.TempPathFactory) -> World:
    return World(tmp_path_factory.mktemp("world"))


def swap(one: Entry, other: Entry) -> None:
    aside = one.path.with_suffix(".aside")
    os.replace(one.path, aside)
    os.replace(other.path, one.path)
    os.replace(aside, other.path)


def test_no_swap_among_keys_stages_and_configs_is_believed(world: World) -> None:
    rng = np.random.default_rng(2008)
    kinds = set()
    for count in range(SWAPS):
        one, other = (world.entries[i] for i in rng.choice(len(world.entries), 2, replace=False))
        kinds.add((one.stage == other.stage, bool(set(world.owners[one.key]) & set(world.owners[other.key]))))
        swap(one, other)
        for entry in (one, other):
            with pytest.raises(CorruptArtifactError, match=f"not '{entry.stage}/{entry.key}'"):
                world.store.get(entry.stage, entry.key)
        if count % 8 == 0:
            # All that is made of it is gone, so that a run would have to read it.
            for owner in world.owners[one.key]:
                for stage in ("export", "report"):
                    key = plan.keys(steps(world.configs[owner]))[stage]
                    if key not in (one.key, other.key):
                        world.store.path(stage, key).unlink(missing_ok=True)
                warnings: list[str] = []
                assert world.run(world.configs[owner], warnings) == world.right[owner]
                assert all("holds the artifact" in text for text in warnings)
            world.restore()
        else:
            swap(one, other)
    # Of one stage or of two, of one config or of two.
    assert len(kinds) == 4
    assert all(world.store.get(e.stage, e.key) for e in world.entries)


def test_many_swaps_at_once_leave_the_right_bytes(world: World) -> None:
    order = np.random.default_rng(7).permutation(len(world.entries))
    data = [entry.path.read_bytes() for entry in world.entries]
    for entry, i in zip(world.entries, order, strict=True):
        entry.path.write_bytes(data[i])
    for config, right in zip(world.configs, world.right, strict=True):
        warnings: list[str] = []
        assert world.run(config, warnings) == right
        assert warnings
    # A warning each, and no more once all is made again.
    assert [world.run(config) for config in world.configs] == world.right
    world.restore()


def test_a_dataset_put_under_another_name_is_refused(world: World) -> None:
    stages = {entry.stage: entry for entry in world.entries}
    first, second = [entry for entry in world.entries if entry.stage == "fit"][:2]
    world.store.put("fit", first.key, world.store.get("fit", second.key))
    with pytest.raises(CorruptArtifactError, match=f"is of the key '{second.key}', not '{first.key}'"):
        world.store.get("fit", first.key)
    key = stages["truth"].key
    dataset = world.store.get("truth", key)
    with pytest.raises(CorruptArtifactError, match="is of the step"):
        world.store.get("truth", key, "truth/another")
    assert world.store.get("truth", key, str(dataset.attrs["step"]))
    world.store.put("fit", key, dataset)
    with pytest.raises(CorruptArtifactError, match="is of the stage 'truth', not 'fit'"):
        world.store.get("fit", key)
    world.restore()


def test_the_identity_is_under_the_checksum_and_the_layout_is_asked_for(world: World) -> None:
    import h5py

    one, other = [entry for entry in world.entries if entry.stage == "fit"][:2]
    swap(one, other)
    with h5py.File(one.path, "r+") as file:
        file.attrs["artifact"] = f"{one.stage}/{one.key}"
        file.attrs["key"] = one.key
    with pytest.raises(CorruptArtifactError, match="checksum"):
        world.store.get(one.stage, one.key)
    with h5py.File(other.path, "r+") as file:
        file.attrs["schema_version"] = hdf5.SCHEMA_VERSION - 1
    with pytest.raises(CorruptArtifactError, match="has the layout 1, not 2"):
        world.store.get(other.stage, other.key)
    world.restore()


def test_the_command_line_tells_of_a_swap(world: World) -> None:
    one, other = (next(e for e in world.entries if e.stage == stage) for stage in ("truth", "select"))
    swap(one, other)
    place = ("--store", str(world.store.root))
    code, out, err = invoke("artifacts", "verify", *place)
    assert code == 1
    assert out == f"{len(world.entries) - 2} of {len(world.entries)} artifacts hold.\n"
    assert len(err.splitlines()) == 2
    assert str(one.path) in err
    assert str(other.path) in err
    code, out, err = invoke("artifacts", "show", one.key, *place)
    assert code == 1
    assert not out
    assert f"holds the artifact 'select/{other.key}', not 'truth/{one.key}'" in err
    world.restore()
