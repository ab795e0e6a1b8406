"""The documentation, done: its figures measured again, and its examples of extensions run in a copy of the package."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT
from numpy.typing import NDArray
from skylight_sh.export import direct_nodes
from skylight_sh.fit.axis import Axis
from skylight_sh.fit.errors import e_mean
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import parameter_points, rings, sampling, sun_centred
from skylight_sh.quadrature.registry import RULES
from skylight_sh.sphere import Harmonics
from skylight_sh.table import grid_fit
from skylight_sh.table.prefactor import closed_form
from skylight_sh.table.table import products

PACKAGE = ROOT / "pipeline" / "skylight_sh"
MATHEMATICS = (ROOT / "docs" / "mathematics.md").read_text(encoding="utf-8")
EXTENDING = (ROOT / "docs" / "extending.md").read_text(encoding="utf-8")

Array = NDArray[np.float64]

EVEN = Harmonics.even(7)
RANGES = {"sun_zenith": (0.0, float(np.pi / 2)), "turbidity": (2.5, 6.0)}


def rows_of(name: str) -> list[list[str]]:
    """The cells of the table between two marks of the mathematics, but for its heading."""
    told = re.search(rf"<!-- {name} -->\n(.*?)<!-- /{name} -->", MATHEMATICS, re.DOTALL)
    assert told
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in told[1].splitlines()[2:]]


def test_rules_converge_as_told() -> None:
    """The table of errors, measured again: its samples exactly, its errors within a factor of two."""
    light, where = Preetham(), {"sun_zenith": np.array([[1.2]]), "turbidity": np.array([[3.0]])}
    exact = sun_centred.project(light, where, nodes=160, harmonics=EVEN).weights
    samples = {
        "sun-centred": lambda n: len(sun_centred.half_sky(1.2, n)[1]),
        "rings": lambda n: len(rings.half_sky(1.2, n, 7)[1]),
        "zenith": lambda n: 2 * n * n,
        "stratified": lambda n: n * n,
    }
    rows = rows_of("convergence")
    assert len(rows) > 10
    for rule, nodes, count, error in rows:
        n = int(nodes)
        found = RULES[rule].project(light, where, nodes=n, harmonics=EVEN).weights
        off = float((np.abs(found - exact).max(axis=-1) / np.abs(exact).max(axis=-1)).max())
        assert samples[rule](n) == int(count.replace(",", "")), (rule, n)
        assert off < 2 * float(error), (rule, n, off)
        # Rounding has no lower bound.
        assert off > float(error) / 2 or float(error) < 1e-13, (rule, n, off)


def test_few_nodes_reach_their_budgets_as_told() -> None:
    """The sums of the target ``direct``: their nodes exactly, their errors to the digits shown."""
    ranges, domain = ((0.0, float(np.pi / 2)), (2.5, 6.0)), ((0.0, float(np.pi / 2)), (1.7, 10.0))
    found = rows_of("direct")
    assert len(found) == 3
    for budget, ring_count, turns, *told in (row[:5] for row in found):
        asked = float(budget.removesuffix(" %")) / 100
        nodes, within = direct_nodes.choose(Preetham(), ranges, 7, asked)
        assert (nodes.circles + nodes.arcs, nodes.waves) == (int(ring_count), int(turns))
        anywhere = direct_nodes.e_mean(Preetham(), domain, 7, nodes)
        assert told == [f"{100 * value:.2g} %" for value in (within, anywhere)]


def sampled(nodes: list[Array]) -> tuple[Array, Array, Array]:
    """The sets of a grid, their weights and least luminances."""
    sets = parameter_points.grid(nodes)
    weights, least = np.empty((len(sets), 3, EVEN.count)), np.empty(len(sets))
    for block in parameter_points.chunks(sets, 0, 64):
        samples = sampling.sample_block(sampling.Job(Preetham(), tuple(RANGES), sets[block], 48, EVEN))
        weights[block], least[block] = samples.weights, samples.least
    return sets, weights, least


def changed(name: str, cell: str) -> Axis:
    """An axis by what its cell says: ``log`` about 0.5."""
    kind, _, point = cell.replace("`", "").partition(" about ")
    return Axis(name, *RANGES[name], map=kind, point=float(point or 0.0))


def test_changes_of_variable_and_the_prefactor_help_as_told() -> None:
    plain = [Axis(name, *ends) for name, ends in RANGES.items()]
    none = np.full(1, np.inf)
    seen, truth, least = sampled([axis.verification_nodes(n, none) for axis, n in zip(plain, (29, 17), strict=True)])
    found = rows_of("fits")
    assert len(found) == 4
    for zenith, turbidity, factor, error in found:
        axes = (changed("sun_zenith", zenith), changed("turbidity", turbidity))
        hint = Preetham().hints.prefactor
        assert hint
        scale = closed_form(hint, [axis.specified for axis in axes]) if factor == "yes" else None
        nodes = [axis.fit_nodes(n, "chebyshev") for axis, n in zip(axes, (28, 16), strict=True)]
        samples = sampled(nodes)[1].reshape(28, 16, 3, EVEN.count)
        made = grid_fit.fit(samples, axes, nodes, (13, 7), "chebyshev", grid_fit.TENSOR, scale)
        assert made.condition == pytest.approx(2.0)
        basis = products("chebyshev", axes, seen, (13, 7))
        sums = np.einsum("nt,cwt->ncw", basis, made.dense.reshape(3, EVEN.count, -1))
        off = grid_fit.factor_at(scale, seen, 3) @ sums - truth
        assert 100 * e_mean(off, least) == pytest.approx(float(error.removesuffix(" %")), rel=0.03)


@dataclass(frozen=True)
class Example:
    """A fenced block of extending.md: its language, the words before it and its text."""

    language: str
    before: str
    code: str


def examples() -> list[Example]:
    found = re.findall(r"^([^\n]+)\n\n```(python|toml)\n(.*?)^```", EXTENDING, re.DOTALL | re.MULTILINE)
    return [Example(language, before, code) for before, language, code in found]


def test_what_extends_the_package_works_as_shown(tmp_path: Path) -> None:
    """All files and lines of the page in one copy, its config run, and then its checks."""
    package = tmp_path / "source" / "skylight_sh"
    shutil.copytree(PACKAGE, package, ignore=shutil.ignore_patterns("__pycache__"))
    checks = []
    for example in examples():
        place = re.fullmatch(r"(File|Line in) `(.+)`:", example.before)
        if place and place[1] == "File":
            assert not (package / place[2]).exists(), place[2]
            (package / place[2]).write_text(example.code, encoding="utf-8")
        elif place:
            registry = (package / place[2]).read_text(encoding="utf-8")
            first = re.search(r'^ +"[\w-]+": "skylight_sh\..*\n', registry, re.MULTILINE)
            assert first, place[2]
            (package / place[2]).write_text(registry.replace(first[0], example.code + first[0], 1), encoding="utf-8")
        elif example.language == "python":
            checks.append(example.code)
        elif example.code.startswith("name ="):
            (tmp_path / "extended.toml").write_text(example.code, encoding="utf-8")

    def call(*arguments: str) -> str:
        environment = {**os.environ, "PYTHONPATH": str(package.parent)}
        command = [sys.executable, *arguments]
        done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout

    schema = call("-m", "skylight_sh", "config", "schema")
    for name in ("even", "midpoints", "chebyshev-2", "square", "json", "slang", "dot"):
        assert f'"{name}"' in schema
    call("-m", "skylight_sh", "run", "extended.toml")
    assert len(checks) >= 5
    for check in checks:
        call("-c", check)


def test_the_light_of_another_package_is_registered_as_shown() -> None:
    shown = [tomllib.loads(e.code) for e in examples() if e.language == "toml" and not e.code.startswith("name =")]
    packaged = tomllib.loads((ROOT / "tests" / "example_light" / "pyproject.toml").read_text(encoding="utf-8"))
    assert shown[0]["project"]["entry-points"] == packaged["project"]["entry-points"]
    assert shown[1]["light"]["entry"] in packaged["project"]["entry-points"]["skylight_sh.lights"]
