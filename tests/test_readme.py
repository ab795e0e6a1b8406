"""The README: its commands, programs and numbers, tried as a reader would."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from conftest import ROOT, SMALL
from skylight_sh import runtime
from skylight_sh.cli import main
from skylight_sh.config import load
from skylight_sh.run.runner import Result
from skylight_sh.studies.claims import day, gradient, measured, readme, sources

README = (ROOT / "README.md").read_text(encoding="utf-8")
RESULTS = (ROOT / "docs" / "results.md").read_text(encoding="utf-8")
REFERENCE = ROOT / "reports" / "reference"


def block(name: str) -> str:
    """The text between two marks of the README, without its fence."""
    found = re.search(rf"<!-- {name} -->\n(.*?)<!-- /{name} -->", README, re.DOTALL)
    assert found, name
    return re.sub(r"```\w*\n", "", found[1]).strip()


def code(language: str, holding: str) -> str:
    return next(c for c in re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL) if holding in c)


def test_every_figure_is_the_released_one() -> None:
    """`make reference`, `make speed` and `make times` write the blocks; no figure in them is typed."""
    for name in readme.PAGES:
        page = (ROOT / name).read_text(encoding="utf-8")
        found = readme.rewrite(name, page, readme.released(REFERENCE))
        assert found == page, "run `python -m skylight_sh.studies.claims write`"
    assert not [line for line in README.splitlines() if len(line) > 127]


def test_a_run_ends_with_the_lines_that_are_shown(small_run: Result) -> None:
    store = small_run.folder.parents[1] / "artifacts"
    places = ["--store", str(store), "--reports", str(small_run.folder.parent)]
    done = CliRunner().invoke(main, ["run", str(SMALL), *places])
    assert done.exit_code == 0, done.output
    assert done.output.splitlines()[-len(readme.printed(small_run.summary, "")) :] == readme.printed(
        small_run.summary, str(small_run.folder)
    )


def test_the_claims_hold() -> None:
    """What was released, measured anew: three digits where arithmetic alone may differ, coarser where less is sampled."""
    claims = json.loads((REFERENCE / "claims.json").read_text(encoding="utf-8"))
    assert set(claims) == {"gradient", "pictures", "ringing", "valley", "lighting", "day", "daylight"}
    assert measured.daylight() == near(claims["daylight"], rel=1e-3)
    assert measured.ringing(7) == near(claims["ringing"], rel=6e-3)
    found = measured.pictures((512,))
    # 2,048 pixels take a minute; test_probe has its bound.
    assert 0 < claims["pictures"]["exact"].pop("2048") < 1e-5
    assert found == near(claims["pictures"], rel=0.02)


def test_the_gradient_is_as_right_as_told() -> None:
    claim = json.loads((REFERENCE / "claims.json").read_text(encoding="utf-8"))["gradient"]
    found = gradient.measure(runtime.load(REFERENCE / "export" / "skylight_sh.npz").table)
    assert set(found) == set(claim)
    # Rounding, another CPU's may be twice as large.
    for place, value in found.items():
        assert 0 < value < 2 * claim[place] < 1e-5
    told = re.search(r"right to (\S+) of the largest derivative", " ".join(RESULTS.split()))
    assert told
    assert float(told[1]) == pytest.approx(max(claim.values()), rel=0.5)


def test_surfaces_lose_as_much_as_told() -> None:
    """All of it measured anew: another CPU's rays and rounding move the finest tables' figures."""
    claim = json.loads((REFERENCE / "claims.json").read_text(encoding="utf-8"))["lighting"]
    assert measured.lighting(ROOT / "configs" / "preetham.toml", REFERENCE) == near(claim, rel=0.1)


def test_the_valley_is_as_far_as_told() -> None:
    """By an eighth of the meridians and of their nodes: within a tenth of each figure."""
    claim = json.loads((REFERENCE / "claims.json").read_text(encoding="utf-8"))["valley"]
    assert measured.valley(ROOT / "configs" / "valley.toml", 128) == near(claim, rel=0.1)


def test_the_day_is_as_exact_as_told(tmp_path: Path) -> None:
    """By fewer pixels, paths and rays: most of the error is that of few bands and of vertices."""
    claim = json.loads((REFERENCE / "claims.json").read_text(encoding="utf-8"))["day"]
    config = load(ROOT / "configs" / "courtyard.toml")
    assert config.scene.mesh is not None
    mesh = config.scene.mesh.model_copy(update={"rays": 256, "gather_rays": 64})
    coarse = config.model_copy(update={"scene": config.scene.model_copy(update={"mesh": mesh})})
    found = day.measure(coarse, tmp_path, 36, 16)
    assert {"table", "bytes", "bands", "slices"} < set(claim)
    for errors in ("error", "from_table"):
        assert found.pop(errors) == pytest.approx(claim.pop(errors), rel=0.25)
    assert found == claim
    picture = (REFERENCE / "day.png").read_bytes()
    assert len(picture) <= 400_000
    assert 800 <= int.from_bytes(picture[16:20], "big") <= 1200


def test_the_days_picture_is_the_one_measured() -> None:
    """`make reference` and the README name the same command."""
    asked = f"render courtyard --slices {day.SLICES} --size 1024x576 --turbidity {day.TURBIDITY} --output"
    assert asked in README
    assert asked in (ROOT / "Makefile").read_text(encoding="utf-8")


def test_sources_of_the_recommended_table_are_released() -> None:
    """What `make reference` writes beside the headers, held to the table by the tests of their own languages."""
    released = {path.name: path.read_bytes() for path in (REFERENCE / "code").iterdir()}
    assert sources.of(REFERENCE) == released
    assert {path.rpartition(".")[2] for path in released} == {"glsl", "hlsl", "wgsl", "mjs", "mts", "cs"}


def near(value: Any, rel: float) -> Any:
    """JSON-like data whose floats compare within ``rel`` of themselves."""
    if isinstance(value, dict):
        return {key: near(inner, rel) for key, inner in value.items()}
    if isinstance(value, list):
        return [near(inner, rel) for inner in value]
    return pytest.approx(value, rel=rel, abs=1e-9) if isinstance(value, float) else value


def test_c_example_prints_what_it_says(tmp_path: Path) -> None:
    (tmp_path / "sky.c").write_text(code("c", "int main"), encoding="utf-8")
    (tmp_path / "reports").symlink_to(ROOT / "reports")
    command, _, program = code("sh", "cc -std").strip().partition(" && ")
    subprocess.run([*command.split(), "-Wall", "-Wextra", "-Werror"], cwd=tmp_path, check=True)
    done = subprocess.run([program], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == block("c-output")


def test_python_example_prints_what_it_says() -> None:
    program = code("python", "skylight_sh.load")
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == block("py-output")


def test_links_and_targets_exist() -> None:
    for link in re.findall(r"\]\(([^)#]+)\)", README):
        assert "://" in link or (ROOT / link).exists(), link
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    for target in set(re.findall(r"`make (\w+)`", README)) | set(re.findall(r"^make (\w+)", README, re.MULTILINE)):
        assert re.search(rf"^{target}:", makefile, re.MULTILINE), target
    for link in re.findall(r"^\[[\w.-]+\]: (\S+)$", README, re.MULTILINE):
        assert (ROOT / link).is_file(), link
    listed = re.findall(r"^\| `([\w-]+)` \|", README.split("## Configs")[1].split("## ")[0], re.MULTILINE)
    assert len(listed) >= 15
    for name in listed:
        assert (ROOT / "configs" / f"{name}.toml").is_file(), name


def test_the_picture_to_project_is_the_sky_of_the_programs() -> None:
    command = next(line for line in code("sh", "skylight-sh project").splitlines() if line.startswith("skylight-sh project"))
    _, name, picture, *rest = command.split()
    done = CliRunner().invoke(main, [name, str(ROOT / picture), *rest, "--json"])
    assert done.exit_code == 0, done.output
    found = np.array([json.loads(done.output)[channel] for channel in ("red", "green", "blue")])
    true = runtime.load(REFERENCE / "export" / "skylight_sh.npz").weights(0.8, 0.0, 3.0)[:, : found.shape[1]]
    assert np.abs(found - true).max() < 2e-3 * np.abs(true).max()
