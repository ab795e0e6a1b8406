"""The package as others install it: a wheel, in an environment that has NumPy and click alone, or the rest too."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import sysconfig
import venv
import zipfile
from dataclasses import dataclass
from pathlib import Path

import click
import numpy as np
import pytest
from conftest import ROOT
from skylight_sh import __version__, runtime
from skylight_sh.export.engine_profiles import PROFILES
from skylight_sh.run.runner import Result

SPEED = Path("reports", "reference", "speed.json")
SOURCE = ("pipeline", "configs", "pyproject.toml", "setup.py", "MANIFEST.in", "README.md", "LICENSE")
OFFLINE = ["--quiet", "--disable-pip-version-check", "--no-deps", "--no-index"]
# All that a base installation may load of ours to print a sky in an engine's form.
MOST_MODULES = 10
SUN = ("--sun-zenith", "0.8", "--turbidity", "3")
FOREIGN = ("scipy", "pydantic", "h5py", "dask", "threadpoolctl", "matplotlib", "pandas", "jinja2", "rich")
# Prints what a program has loaded of ours, and of what the base installation lacks.
COUNT = f"""
import json, sys
{{body}}
print(json.dumps([sorted(m for m in sys.modules if m.split(".")[0] == "skylight_sh"),
                  [m for m in {FOREIGN} if m in sys.modules]]))
"""


@dataclass(frozen=True)
class Installed:
    """An environment with the wheel in it, seen from a folder that has a ``pipeline/`` of its own."""

    place: Path
    folder: Path

    def run(self, *command: str | Path, everything: bool = False) -> subprocess.CompletedProcess[str]:
        """Run a program of the environment; ``everything`` lends it what the tests' own environment has."""
        environment = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
        if everything:
            environment["PYTHONPATH"] = sysconfig.get_path("purelib")
        program = [str(self.place / "bin" / command[0]), *map(str, command[1:])]
        return subprocess.run(program, cwd=self.folder, env=environment, capture_output=True, text=True, check=False)

    def skylight(self, *arguments: str | Path, everything: bool = False) -> tuple[int, str, str]:
        """Run the console command; return its exit code, output and errors."""
        done = self.run("skylight-sh", *arguments, everything=everything)
        return done.returncode, done.stdout, done.stderr


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the wheel from a copy: a build leaves files behind."""
    place = tmp_path_factory.mktemp("wheel")
    for name in SOURCE:
        copy = shutil.copytree if (ROOT / name).is_dir() else shutil.copy
        copy(ROOT / name, place / name)
    (place / SPEED).parent.mkdir(parents=True)
    shutil.copy(ROOT / SPEED, place / SPEED)
    for cache in (place / "pipeline").rglob("__pycache__"):
        shutil.rmtree(cache)
    # Of a module that is no more.
    (place / "build" / "lib" / "skylight_sh").mkdir(parents=True)
    (place / "build" / "lib" / "skylight_sh" / "gone.py").touch()
    command = [sys.executable, "-m", "pip", "wheel", *OFFLINE, "--no-build-isolation", "--wheel-dir", str(place / "out")]
    subprocess.run([*command, str(place)], check=True, capture_output=True)
    (found,) = (place / "out").glob("*.whl")
    return found


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Installed:
    """Install the wheel where NumPy and click are, and nothing else."""
    place = tmp_path_factory.mktemp("installed")
    venv.create(place / "env", symlinks=True)
    (library,) = (place / "env").glob("lib/python*/site-packages")
    for module in (np, click):
        package = Path(module.__file__ or "").parent
        for part in (package, package.with_suffix(".libs")):
            if part.exists():
                (library / part.name).symlink_to(part)
    pip = [sys.executable, "-m", "pip", "--python", str(place / "env" / "bin" / "python")]
    subprocess.run([*pip, "install", *OFFLINE, str(wheel)], check=True, capture_output=True)
    trap = place / "elsewhere" / "pipeline"
    trap.mkdir(parents=True)
    (trap / "__init__.py").write_text("raise RuntimeError('another one')\n", encoding="utf-8")
    return Installed(place / "env", trap.parent)


@pytest.fixture(scope="module")
def table(small_run: Result) -> Path:
    return small_run.folder / "export" / "skylight_sh.npz"


def test_the_wheel_holds_every_file_of_the_package_and_every_shipped_config(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        held = {name.removeprefix("skylight_sh/") for name in archive.namelist() if name.startswith("skylight_sh/")}
        metadata = archive.read(f"skylight_sh-{__version__}.dist-info/METADATA").decode()
    package = ROOT / "pipeline" / "skylight_sh"
    files = {path.relative_to(package).as_posix() for path in package.rglob("*") if path.is_file()}
    shipped = {f"configs/{path.name}" for path in (ROOT / "configs").iterdir()}
    assert held == {name for name in files if "__pycache__" not in name} | shipped | {"speed.json"}
    needed = [line.split()[1] for line in metadata.splitlines() if line.startswith("Requires-Dist:") and "extra" not in line]
    assert sorted(name.partition(">")[0] for name in needed) == ["click", "numpy"]


def test_help_and_version_need_no_numpy(installed: Installed) -> None:
    assert installed.skylight("--version") == (0, f"skylight-sh, version {__version__}\n", "")
    code, out, _ = installed.skylight("--help")
    assert code == 0
    assert "skylight-sh run preetham" in out
    assert installed.run("python", "-m", "skylight_sh", "--help").stdout == out
    body = "from skylight_sh.cli import main\nmain(['--help'], standalone_mode=False)\nassert 'numpy' not in sys.modules"
    done = installed.run("python", "-c", COUNT.format(body=body))
    assert json.loads(done.stdout.splitlines()[-1]) == [["skylight_sh", "skylight_sh.cli"], []], done.stderr


def test_a_table_is_read_with_numpy_alone(installed: Installed, table: Path) -> None:
    body = f"import skylight_sh\nprint(skylight_sh.load({str(table)!r}).weights(0.8, 0.3, 3.0).sum())"
    done = installed.run("python", "-c", COUNT.format(body=body))
    value, found = done.stdout.splitlines()
    assert float(value) == pytest.approx(float(runtime.load(table).weights(0.8, 0.3, 3.0).sum()), rel=1e-6)
    assert json.loads(found) == [["skylight_sh", "skylight_sh.runtime"], []]


@pytest.mark.parametrize("form", PROFILES)
def test_an_engine_s_form_needs_few_modules_and_numpy_alone(installed: Installed, table: Path, form: str) -> None:
    arguments = ["evaluate", str(table), *SUN, "--format", form]
    done = installed.run(
        "python", "-c", COUNT.format(body=f"from skylight_sh.cli import main\nmain({arguments}, standalone_mode=False)")
    )
    assert done.returncode == 0, done.stderr
    ours, foreign = json.loads(done.stdout.splitlines()[-1])
    assert not foreign
    assert len(ours) <= MOST_MODULES, ours


def test_the_base_commands_work(installed: Installed, table: Path) -> None:
    code, out, _ = installed.skylight("configs")
    assert code == 0
    assert [line.split()[0] for line in out.splitlines()] == sorted(path.stem for path in (ROOT / "configs").glob("*.toml"))
    code, out, _ = installed.skylight("evaluate", table, *SUN)
    assert code == 0
    assert len(out.splitlines()) == 17
    assert installed.skylight("init", "base.toml")[0] == 0
    assert 'extends = "preetham"' in (installed.folder / "base.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("arguments", "extra"),
    [
        (("run", "preetham"), "pipeline"),
        (("verify", "reports"), "pipeline"),
        (("config", "check", "preetham"), "pipeline"),
        (("config", "schema"), "pipeline"),
        (("artifacts", "ls"), "pipeline"),
        (("bench",), "pipeline"),
        (("stability",), "pipeline"),
        (("project", "probe.exr", "--bands", "3"), "images"),
        (("lightmap", "yard.obj", "sky.npz", "--part", "wall", "--output", "wall.npz"), "transfer"),
    ],
)
def test_a_command_that_lacks_its_extra_says_which(installed: Installed, arguments: tuple[str, ...], extra: str) -> None:
    (installed.folder / "probe.exr").touch()
    code, out, err = installed.skylight(*arguments)
    assert (code, out) == (2, "")
    assert f"pip install 'skylight-sh[{extra}]'" in err
    assert len(err.splitlines()) == 1


def test_a_day_says_that_it_lacks_the_sun_s_place(installed: Installed, table: Path) -> None:
    place = ("--latitude", "48", "--longitude", "16", "--date", "2024-06-21", "--turbidity", "3")
    arguments = ("export", table, "--format", "unity", *place, "--output", "day.json")
    code, _, err = installed.skylight(*arguments)
    assert code == 2
    assert err == "Error: The sun's position needs Astral: pip install 'skylight-sh[solar]'.\n"
    code, out, err = installed.skylight(*arguments, everything=True)
    assert (code, err) == (0, "")
    assert "16 skies  day.json" in out


def test_a_shipped_config_runs_in_a_folder_with_a_pipeline_of_its_own(installed: Installed) -> None:
    code, out, err = installed.skylight("run", "cie-overcast", everything=True)
    assert (code, err) == (0, "")
    assert "report  reports/cie-overcast/index.html" in out
    for path in ("reports/cie-overcast/index.html", "reports/cie-overcast/export/skylight_sh.h", "artifacts/truth"):
        assert (installed.folder / path).exists(), path
    # A second run loads what reads configs and artifacts, and none of what computes or draws.
    body = "from skylight_sh.cli import main\nmain(['run', 'cie-overcast'], standalone_mode=False)"
    done = installed.run("python", "-c", COUNT.format(body=body), everything=True)
    ours, foreign = json.loads(done.stdout.splitlines()[-1])
    assert sorted(foreign) == ["h5py", "pydantic"]
    assert not [name for name in ours if name.startswith(("skylight_sh.run.stages", "skylight_sh.run.executors"))]
    # A picture that a shipped config names lies beside it.
    assert installed.skylight("init", "own.toml")[0] == 0
    for name, run in (("own.toml", "own"), ("valley", "valley")):
        expected = (0, f"{name} holds: run '{run}'.\n", "")
        assert installed.skylight("config", "check", name, everything=True) == expected


def test_the_runtime_is_one_file(table: Path, tmp_path: Path) -> None:
    """Copied beside a table, it needs NumPy, and nothing else of ours or of others."""
    shutil.copy(runtime.__file__, tmp_path / "sky.py")
    shutil.copy(table, tmp_path / "table.npz")
    program = (
        "import sys, sky\nprint(sky.load('table.npz').weights(0.8, 0.3, 3.0).sum())\nassert 'skylight_sh' not in sys.modules"
    )
    # Without the site: of installed packages NumPy alone is seen.
    (tmp_path / "numpy").symlink_to(Path(np.__file__).parent)
    done = subprocess.run(
        [sys.executable, "-S", "-c", program], cwd=tmp_path, capture_output=True, text=True, check=False, env={}
    )
    assert done.returncode == 0, done.stderr
    assert float(done.stdout) == pytest.approx(float(runtime.load(table).weights(0.8, 0.3, 3.0).sum()), rel=1e-6)
