"""Workers that would compute something else than their client: refused by name before a result is used."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import pytest
from click.testing import CliRunner
from conftest import ROOT, SMALL
from skylight_sh.cli import main
from skylight_sh.light import LightError
from skylight_sh.light.plugin import Plugin
from skylight_sh.run import executors
from skylight_sh.run.executors import WorkerError, map_tasks
from skylight_sh.run.fingerprint import fingerprint, in_use
from skylight_sh.store.store import Store

PACKAGE = ROOT / "pipeline" / "skylight_sh"


@dataclass(frozen=True)
class Place:
    """A folder that a worker imports from first, and its scheduler's address."""

    folder: Path
    scheduler: str


def other_code(folder: Path) -> None:
    """A copy of the package with one constant of the sky changed in its last digit."""
    shutil.copytree(PACKAGE, folder / "skylight_sh", ignore=shutil.ignore_patterns("__pycache__"))
    source = folder / "skylight_sh" / "light" / "preetham.py"
    text = source.read_text(encoding="utf-8")
    assert "4.0453 * tau" in text
    source.write_text(text.replace("4.0453 * tau", "4.0454 * tau"), encoding="utf-8")


def other_numpy(folder: Path) -> None:
    """The same package, and metadata of a NumPy that was never released."""
    (folder / "skylight_sh").symlink_to(PACKAGE)
    (folder / "numpy-1.2.3.dist-info").mkdir()
    (folder / "numpy-1.2.3.dist-info" / "METADATA").write_text("Name: numpy\nVersion: 1.2.3\n", encoding="utf-8")


def no_package(folder: Path) -> None:
    """Somebody else's module of that name: a package of theirs would be filled up by an editable installation of ours."""
    (folder / "skylight_sh.py").touch()


def other_light(folder: Path) -> None:
    """The same package, and another state of the other package's light, of the same version."""
    (folder / "skylight_sh").symlink_to(PACKAGE)
    text = (ROOT / "tests" / "example_light" / "example_light.py").read_text(encoding="utf-8")
    assert "1000.0 * glow" in text
    (folder / "example_light.py").write_text(text.replace("1000.0 * glow", "1001.0 * glow"), encoding="utf-8")


WORKERS = {make.__name__: make for make in (other_code, other_numpy, no_package, other_light)}


def start(place: Place) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "distributed.cli.dask_worker", place.scheduler, "--nthreads", "1", "--no-nanny"]
    options = ["--no-dashboard", "--host", "127.0.0.1", "--local-directory", str(place.folder / "scratch")]
    environment = {**os.environ, "PYTHONPATH": str(place.folder)}
    quiet = subprocess.DEVNULL
    return subprocess.Popen([*command, *options], cwd=place.folder, env=environment, stdout=quiet, stderr=quiet)


def stop(process: subprocess.Popen[bytes]) -> None:
    process.kill()
    process.wait()


@pytest.fixture(scope="module")
def places(tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, Place]]:
    """A cluster of one wrong worker for each way to be wrong, and one without any worker: all start at once."""
    from distributed import LocalCluster

    with ExitStack() as stack:
        made, clusters = {}, {}
        for name in (*WORKERS, "late"):
            options = {"n_workers": 0, "protocol": "tcp", "host": "127.0.0.1", "dashboard_address": ":0"}
            clusters[name] = stack.enter_context(LocalCluster(**options))
            made[name] = Place(tmp_path_factory.mktemp(name), clusters[name].scheduler_address)
        for name, prepare in WORKERS.items():
            prepare(made[name].folder)
            stack.callback(stop, start(made[name]))
        deadline = time.monotonic() + 60
        for name in WORKERS:
            while not clusters[name].scheduler.workers and time.monotonic() < deadline:
                time.sleep(0.02)
            assert clusters[name].scheduler.workers, name
        yield made


def test_other_code_ends_a_run_with_one_message_and_nothing_of_it_is_kept(places: dict[str, Place], tmp_path: Path) -> None:
    folders = ["--store", str(tmp_path / "s"), "--reports", str(tmp_path / "r")]
    result = CliRunner().invoke(main, ["run", str(SMALL), "--executor", places["other_code"].scheduler, *folders])
    assert result.exit_code == 1
    assert isinstance(result.exception, SystemExit)
    (message,) = result.stderr.splitlines()
    assert message.startswith("Error: The worker tcp://127.0.0.1:")
    assert "the code of skylight-sh is" in message
    assert "start the worker anew" in message
    # The rule is this process's own; no sample is there.
    store = Store(tmp_path / "s")
    assert [store.get(e.stage, e.key).attrs["step"] for e in store.entries()] == ["truth/rule"]
    assert not (tmp_path / "r").exists()


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("other_code", r"worker tcp://127\.0\.0\.1:\d+ .*the code of skylight-sh is \w{12} there and \w{12} here"),
        ("other_numpy", r"worker tcp://127\.0\.0\.1:\d+ .*: numpy is 1\.2\.3 there and \d.* here\. "),
        ("no_package", r"worker tcp://127\.0\.0\.1:\d+ has no skylight-sh.*No module named 'skylight_sh\.run.*Install"),
        (
            "other_light",
            r"light example_glow is example-light 1\.0 code \w{12} there and example-light 1\.0 code \w{12} here",
        ),
    ],
)
def test_a_wrong_worker_is_refused_by_name(places: dict[str, Place], name: str, told: str) -> None:
    # In use, so that workers have to have it too; this light is the same for all but one.
    assert Plugin("example_glow").channels == ("luminance",)
    done: list[int] = []
    began = time.monotonic()
    with pytest.raises(WorkerError, match=told):
        map_tasks(abs, [-1, 2], executor=places[name].scheduler, workers=0, advance=lambda i, _: done.append(i))
    assert not done
    assert time.monotonic() - began < 20


def test_a_worker_that_began_with_other_code_goes_on_with_it(places: dict[str, Place]) -> None:
    def ask() -> str:
        with pytest.raises(WorkerError, match="the code of skylight-sh") as caught:
            map_tasks(abs, [-1], executor=places["other_code"].scheduler, workers=0, advance=lambda *_: None)
        return str(caught.value)

    before = ask()
    source = places["other_code"].folder / "skylight_sh" / "light" / "preetham.py"
    other = source.read_bytes()
    # Its files are now as here; what it has loaded is not.
    shutil.copy(PACKAGE / "light" / "preetham.py", source)
    try:
        assert ask() == before
    finally:
        source.write_bytes(other)


@pytest.mark.parametrize("name", ["other_code", "no_package"])
def test_a_worker_that_comes_later_is_refused_as_well(places: dict[str, Place], name: str) -> None:
    caught: list[BaseException] = []

    def work() -> None:
        try:
            map_tasks(abs, [-1, 2], executor=places["late"].scheduler, workers=0, advance=lambda *_: None)
        except WorkerError as error:
            caught.append(error)

    thread = threading.Thread(target=work)
    thread.start()
    # Nobody is there to ask or to work; then one comes.
    time.sleep(1.0)
    process = start(Place(places[name].folder, places["late"].scheduler))
    try:
        thread.join(60)
        assert not thread.is_alive()
    finally:
        stop(process)
    assert len(caught) == 1
    assert "The worker tcp://127.0.0.1:" in str(caught[0])
    assert ("the code of skylight-sh is" if name == "other_code" else "has no skylight-sh") in str(caught[0])


def test_a_process_with_other_libraries_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(executors, "fingerprint", lambda used: {**fingerprint(used), "numpy": "0.1"})
    with pytest.raises(WorkerError, match=r"The worker process \d+ .*: numpy is \d.* there and 0\.1 here"):
        map_tasks(abs, [-1, 2], executor="processes", workers=1, advance=lambda *_: None)


def refuse(item: int) -> int:
    """A task that fails for one item."""
    if item == 2:
        raise LightError("two is too much")
    return -item


def test_what_a_task_raises_comes_back_as_it_is() -> None:
    with pytest.raises(LightError) as caught:
        map_tasks(refuse, [1, 2, 3], executor="processes", workers=1, advance=lambda *_: None)
    # The worker's traceback is a note, which only a traceback shows.
    assert str(caught.value) == "two is too much"
    assert "in refuse" in caught.value.__notes__[0]


def test_a_fingerprint_names_what_decides_results() -> None:
    Plugin("example_glow")
    found = fingerprint(in_use())
    assert {"the code of skylight-sh", "Python", "numpy", "scipy", "light example_glow"} <= set(found)
    assert fingerprint(("nowhere", "light nowhere")) | {"nowhere": "missing", "light nowhere": "missing"} == fingerprint(
        ("nowhere", "light nowhere")
    )
