"""Registries: a thing is added by one file and one line, and then works from a config, end to end."""

from __future__ import annotations

import difflib
import json
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest
from conftest import ROOT
from skylight_sh.export.targets import TARGETS
from skylight_sh.light import LIGHTS
from skylight_sh.quadrature.registry import RULES
from skylight_sh.registry import Registry
from skylight_sh.report.figures import PICTURES

PACKAGE = ROOT / "pipeline" / "skylight_sh"

CONFIG = """
name = "tried"
[light]
{light}
[[axes]]
name = "sun_zenith"
range = [0.0, 1.5707963267948966]
nodes = 5
verification = 9
degrees = [1, 2]
[truth]
bands = 2
tolerance = 1e-3
rule = "{rule}"
random = 0
held_out = 16
held_out_edge = 1
[[winners]]
bands = 2
degrees = [2]
[export]
recommended = "2-bands-degrees-2"
targets = {targets}
[report]
figures = {figures}
"""
PLAIN = {"light": 'model = "cie_general"\nsky = 5', "rule": "zenith", "targets": '["c", "npz"]', "figures": "[]"}

LIGHT = '''"""A sky that is as bright everywhere as the sun is high."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from skylight_sh.light.mixins import Relative
from skylight_sh.light.protocol import Array, Hints, Parameters


@dataclass(frozen=True)
class Even(Relative):
    """The even sky."""

    scale: float = 1.0
    """luminance in cd/m2 with the sun in the zenith"""
    model: Literal["even"] = "even"
    """A sky that is as bright everywhere as the sun is high."""

    @property
    def title(self) -> str:
        return "even sky"

    @property
    def hints(self) -> Hints:
        return Hints(mirrored=True, peak_zenith=0.0)

    def radiance(self, directions: Array, parameters: Parameters) -> Array:
        height = np.cos(parameters["sun_zenith"]) + 1.0
        return (self.scale * (height + 0.0 * directions[..., 2]))[..., np.newaxis]
'''
RULE = '''"""Midpoints of rings and azimuths of equal area, for lights that neither peak nor jump."""

from __future__ import annotations

import numpy as np

from skylight_sh.quadrature import direction_sums
from skylight_sh.quadrature.rule import Rule, steps


def project(light, parameters, *, nodes, harmonics):
    z, phi = np.meshgrid((np.arange(nodes) + 0.5) / nodes, (np.arange(nodes) + 0.5) / nodes * 2 * np.pi)
    solid_angles = np.full(nodes * nodes, 2 * np.pi / (nodes * nodes))
    directions = direction_sums.towards(z.ravel(), phi.ravel())
    return direction_sums.project(light, parameters, (directions, solid_angles), harmonics)


RULE = Rule("midpoints", project, steps(32, 64, 128))
'''
TARGET = '''"""How many bands a table has, as JSON."""

from __future__ import annotations

import json

from skylight_sh.export.target import Target

TARGET = Target(lambda table, facts, prefix: {f"{prefix}.json": json.dumps({"bands": table.bands}).encode()})
'''
LANGUAGE = '''"""Slang functions of tables of layout rows in float32."""

from __future__ import annotations

from dataclasses import replace

from skylight_sh.export.targets import shader
from skylight_sh.export.targets.hlsl import DIALECT as HLSL

DIALECT = replace(HLSL, title="Slang", extension="slang")
TARGET = shader.target(DIALECT)
'''
PICTURE = '''"""One dot."""

from __future__ import annotations

from skylight_sh.report import style
from skylight_sh.report.figures.picture import Picture


def draw(data):
    figure = style.figure(2, 2)
    figure.subplots().plot([data.held_out], [1.0], "o")
    return figure


PICTURE = Picture("A dot", "How many sets errors are measured on.", draw)
'''


@dataclass(frozen=True)
class Addition:
    """A new ``file`` of ``text`` and a new ``line`` in ``registry``; a run with ``edits`` of the config makes ``made``."""

    file: str
    text: str
    registry: str
    line: str
    edits: dict[str, str]
    made: str


ADDITIONS = {
    "light": Addition(
        "light/even.py",
        LIGHT,
        "light/__init__.py",
        '"even": "skylight_sh.light.even:Even",',
        {"light": 'model = "even"\nscale = 2.0'},
        "export/skylight_sh.h",
    ),
    "truth rule": Addition(
        "quadrature/midpoints.py",
        RULE,
        "quadrature/registry.py",
        '"midpoints": "skylight_sh.quadrature.midpoints:RULE",',
        {"rule": "midpoints"},
        "export/skylight_sh.npz",
    ),
    "export target": Addition(
        "export/targets/json.py",
        TARGET,
        "export/targets/__init__.py",
        '"json": "skylight_sh.export.targets.json:TARGET",',
        {"targets": '["c", "npz", "json"]'},
        "export/skylight_sh.json",
    ),
    "shading language": Addition(
        "export/targets/slang.py",
        LANGUAGE,
        "export/shader_dialects.py",
        '"slang": "skylight_sh.export.targets.slang:DIALECT",',
        {"targets": '["c", "npz", "slang"]'},
        "export/skylight_sh.slang",
    ),
    "picture": Addition(
        "report/figures/dot.py",
        PICTURE,
        "report/figures/__init__.py",
        '"dot": "skylight_sh.report.figures.dot:PICTURE",',
        {"figures": '["dot"]'},
        "figures/dot.png",
    ),
}


def changes(before: Path, after: Path) -> tuple[list[str], list[str]]:
    """Return the files that are new, and the lines that differ in others."""
    names = {p.relative_to(after).as_posix() for p in after.rglob("*.py")}
    old = {p.relative_to(before).as_posix() for p in before.rglob("*.py")}
    assert old <= names
    lines = []
    for name in sorted(old):
        texts = [(root / name).read_text(encoding="utf-8").splitlines() for root in (before, after)]
        lines += [line for line in difflib.ndiff(*texts) if line[0] in "+-"]
    return sorted(names - old), lines


@pytest.mark.parametrize("what", ADDITIONS)
def test_one_file_and_one_line_add_a_thing_that_works_from_a_config(what: str, tmp_path: Path) -> None:
    added = ADDITIONS[what]
    package = tmp_path / "pipeline" / "skylight_sh"
    shutil.copytree(PACKAGE, package, ignore=shutil.ignore_patterns("__pycache__"))
    (package / added.file).write_text(added.text, encoding="utf-8")
    registry = (package / added.registry).read_text(encoding="utf-8")
    first = next(line for line in registry.splitlines(keepends=True) if line.lstrip().startswith('"') and ': "sky' in line)
    (package / added.registry).write_text(registry.replace(first, f"        {added.line}\n{first}", 1), encoding="utf-8")
    assert changes(PACKAGE, package) == ([added.file], [f"+         {added.line}"])

    config = tmp_path / "tried.toml"
    config.write_text(CONFIG.format(**{**PLAIN, **added.edits}), encoding="utf-8")
    environment = {**os.environ, "PYTHONPATH": str(package.parent)}

    def call(*arguments: str) -> str:
        command = [sys.executable, "-m", "skylight_sh", *arguments]
        done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout

    call("run", str(config), "--store", "store", "--reports", "reports")
    assert (tmp_path / "reports" / "tried" / added.made).stat().st_size
    name, about = added.line.split('"')[1], added.text.split('"""')[1].partition("\n")[0].removesuffix(".")
    told = f'"description": "{about}."' if what == "light" else f"{name}: {about}"
    assert told in json.dumps(json.loads(call("config", "schema")), ensure_ascii=False)


@pytest.mark.parametrize("registry", [LIGHTS, RULES, TARGETS, PICTURES], ids=["lights", "rules", "targets", "pictures"])
def test_every_entry_loads_and_says_in_one_line_what_it_is(registry: Registry[object]) -> None:
    for name in registry:
        assert registry[name]
        assert 10 < len(registry.about(name)) < 125, name
        assert "\n" not in registry.about(name)


def test_a_light_has_its_own_name() -> None:
    assert {name: light.__dataclass_fields__["model"].default for name, light in LIGHTS.items()} == {n: n for n in LIGHTS}


def test_an_unknown_name_is_told_with_the_known_ones() -> None:
    with pytest.raises(KeyError, match="'polar' is none of sun-centred, rings"):
        RULES["polar"]
    assert "polar" not in RULES
