"""The stage and the command ``transfer``: their file, blocks that a killed run keeps, and bytes without a doubt."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
import xarray
from click.testing import CliRunner
from meshes import CUBE, QUADS, obj
from skylight_sh.cli import main
from skylight_sh.transfer import unshadowed

OPTIONS = ("--bands", "3", "--rays", "64", "--gather-rays", "32", "--bounces", "2")


@pytest.fixture(scope="module")
def scene(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A floor of 4,225 vertices, five blocks, with a box on it."""
    at = np.linspace(-4.0, 4.0, 65)
    floor = np.array([[x, y, 0.0] for y in at for x in at])
    faces = [[j * 65 + i, j * 65 + i + 1, j * 65 + i + 66, j * 65 + i + 65] for j in range(64) for i in range(64)]
    path = tmp_path_factory.mktemp("scene") / "scene.obj"
    path.write_text(f"o floor\n{obj(floor, faces, 1)}o box\n{obj(CUBE, QUADS, 1 + len(floor))}", encoding="utf-8")
    return path


def invoke(*arguments: Any) -> tuple[int, str]:
    result = CliRunner().invoke(main, ["transfer", *map(str, arguments)])
    return result.exit_code, result.output


def made(scene: Path, folder: Path, *more: str) -> bytes:
    folder.mkdir(exist_ok=True)
    output = folder / "t.h5"
    code, told = invoke(scene, *OPTIONS, "--output", output, "--store", folder / "store", *more)
    assert code == 0, told
    return output.read_bytes()


@pytest.fixture(scope="module")
def whole(scene: Path, tmp_path_factory: pytest.TempPathFactory) -> bytes:
    return made(scene, tmp_path_factory.mktemp("whole"), "--workers", "1")


def test_the_file_is_opened_by_xarray(whole: bytes, tmp_path: Path) -> None:
    path = tmp_path / "t.h5"
    path.write_bytes(whole)
    with xarray.open_dataset(path, engine="h5netcdf") as found:
        assert found["transfer"].dims == ("vertex", "channel", "weight")
        assert found["transfer"].shape == (found.sizes["vertex"], 3, 9)
        assert list(found["channel"].values) == ["red", "green", "blue"]
        assert 0.0 < found.attrs["error"] < 0.2
        for name in ("position", "normal", "albedo"):
            assert found[name].shape == (found.sizes["vertex"], 3)
        assert int(found["triangle"].max()) < found.sizes["vertex"]
        # Far from the box the floor sees nearly everything, and the box sends little.
        corner = int(np.abs(found["position"].values - [-4.0, -4.0, 0.0]).sum(axis=1).argmin())
        np.testing.assert_allclose(found["transfer"][corner, 1], unshadowed(np.array([[0.0, 0, 1]]), 3)[0], atol=0.02)


@pytest.mark.parametrize("more", [("--workers", "2"), ("--executor", "processes", "--workers", "2")])
def test_workers_change_no_byte(scene: Path, whole: bytes, tmp_path: Path, more: tuple[str, ...]) -> None:
    assert made(scene, tmp_path, *more) == whole


def blocks(store: Path) -> dict[str, tuple[int, bytes]]:
    """The finished blocks of a store: when each was written, and its bytes."""
    return {path.name: (path.stat().st_mtime_ns, path.read_bytes()) for path in store.glob("transfer/*.blocks/[!.]*.h5")}


def killed(scene: Path, folder: Path, after: int, delay: float) -> None:
    """Start the command, and kill it ``delay`` seconds after it has kept ``after`` blocks, unless it ends before."""
    command = [sys.executable, "-m", "skylight_sh", "transfer", str(scene), *OPTIONS, "--workers", "1"]
    command += ["--output", str(folder / "t.h5"), "--store", str(folder / "store")]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=os.environ)
    before = time.monotonic()
    while process.poll() is None and len(blocks(folder / "store")) < after and time.monotonic() < before + 60.0:
        time.sleep(0.002)
    time.sleep(delay)
    process.send_signal(signal.SIGKILL)
    process.wait()


def test_a_killed_run_goes_on_from_its_blocks(scene: Path, whole: bytes, tmp_path: Path) -> None:
    """Killed three times while it computes, then run to the end: no block is made twice, and no byte differs."""
    draw = np.random.default_rng(7)
    kept: dict[str, tuple[int, bytes]] = {}
    for after in (1, 4, 7):
        killed(scene, tmp_path, after, draw.uniform(0.0, 0.03))
        assert not (tmp_path / "t.h5").exists()
        now = blocks(tmp_path / "store")
        assert len(now) >= after
        assert kept.items() <= now.items()
        kept = now
    assert made(scene, tmp_path, "--workers", "2") == whole
    assert not list((tmp_path / "store").glob("transfer/*.blocks"))


def test_a_damaged_block_is_made_again_with_a_warning(scene: Path, whole: bytes, tmp_path: Path) -> None:
    killed(scene, tmp_path, 3, 0.0)
    damaged = sorted((tmp_path / "store").glob("transfer/*.blocks/[!.]*.h5"))[0]
    with h5py.File(damaged, "r+") as file:
        numbers = next(array for array in file.values() if array.dtype.kind == "f")
        numbers[(0,) * numbers.ndim] += 1.0
    code, told = invoke(scene, *OPTIONS, "--output", tmp_path / "t.h5", "--store", tmp_path / "store")
    assert code == 0
    assert "checksum" in told
    assert (tmp_path / "t.h5").read_bytes() == whole


def test_the_store_tells_of_blocks_and_clears_old_ones(scene: Path, tmp_path: Path) -> None:
    killed(scene, tmp_path, 2, 0.0)
    store = tmp_path / "store"
    count = len(blocks(store))
    listed = CliRunner().invoke(main, ["artifacts", "ls", "--store", str(store)]).output
    assert f"unfinished, {count} blocks" in listed
    CliRunner().invoke(main, ["artifacts", "gc", "--store", str(store)])
    # They may belong to a run under way.
    assert len(blocks(store)) == count
    for path in store.glob("transfer/*.blocks/*"):
        os.utime(path, (0, 0))
    assert CliRunner().invoke(main, ["artifacts", "gc", "--store", str(store)]).exit_code == 0
    assert not list(store.glob("transfer/*.blocks"))


def test_what_is_asked_decides_the_file(scene: Path, tmp_path: Path) -> None:
    """Another seed has other rays; without bounces channels are alike; unshadowed is the normals' own transfer."""

    def asked(name: str, *more: str) -> h5py.File:
        path = tmp_path / name
        code, told = invoke(scene, "--bands", 2, "--rays", 16, "--output", path, "--store", tmp_path / "store", *more)
        assert code == 0, told
        return h5py.File(path, "r")

    with asked("a.h5", "--bounces", "0") as one, asked("b.h5", "--bounces", "0", "--seed", "1") as other:
        assert np.ptp(one["transfer"][()], axis=1).max() == 0.0
        assert 0.0 < np.abs(one["transfer"][()] - other["transfer"][()]).mean() < 0.05
        assert one.attrs["bounces"] == 0
    with asked("c.h5", "--unshadowed") as found:
        expected = unshadowed(found["normal"][()], 2)[:, np.newaxis]
        np.testing.assert_allclose(found["transfer"][()], np.repeat(expected, 3, axis=1), atol=1e-7)
        assert found.attrs["error"] == 0.0


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("missing.obj", "--output", "t.h5"), "missing.obj"),
        (("courtyard", "--output", "nowhere/t.h5"), "nowhere"),
        (("courtyard", "--bands", "0", "--output", "t.h5"), "--bands"),
        (("courtyard", "--rays", "2", "--output", "t.h5"), "--rays"),
        (("courtyard",), "--output"),
    ],
)
def test_bad_input_is_told_and_nothing_is_written(
    arguments: tuple[str, ...], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    code, told = invoke(*arguments)
    assert code == 2
    assert said in told
    assert not list(tmp_path.iterdir())
