"""Who imports whom: the layers that docs/architecture.md draws, no circles, and what numerics leave to others."""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path
from typing import NamedTuple

import pytest
from conftest import ROOT

SOURCE = ROOT / "pipeline"
PACKAGE = "skylight_sh"
ARCHITECTURE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")

NUMERICS = {
    *("runtime", "registry", "reproducible", "formula", "sphere", "light"),
    *("probe", "quadrature", "fit", "table", "scene"),
    *("mesh", "transfer", "lightmap", "reflectance", "render"),
}
# Captured light is read from files by one module, which nothing but itself is asked of.
READS_FILES = "skylight_sh.probe.files"
# What numerics stand on (annotated_types holds plain values, the ranges of fields), and what some lights and places ask for
# where they are used.
FOR_NUMERICS = sys.stdlib_module_names | {"numpy", "scipy", "annotated_types"}
LATER = {"astral", "colour", "mitsuba", "embreex", "flip_evaluator"}
ROOMS_ABOVE = {"config", "run", "store", "report", "cli", "export", "studies"}


class Import(NamedTuple):
    """What a module imports: a module of ours or another package's, when it is itself imported (``now``) or later."""

    name: str
    now: bool
    line: int


@cache
def modules() -> dict[str, Path]:
    """Every module of the package by its dotted name."""
    found = {}
    for path in sorted((SOURCE / PACKAGE).rglob("*.py")):
        parts = path.relative_to(SOURCE).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


@cache
def imports(name: str) -> tuple[Import, ...]:
    return tuple(_imports(ast.parse(modules()[name].read_text(encoding="utf-8")), now=True))


def _imports(node: ast.AST, now: bool) -> Iterator[Import]:
    for child in ast.iter_child_nodes(node):
        later = isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda) or (
            isinstance(child, ast.If) and "TYPE_CHECKING" in ast.unparse(child.test)
        )
        if isinstance(child, ast.Import):
            yield from (Import(alias.name, now, child.lineno) for alias in child.names)
        elif isinstance(child, ast.ImportFrom):
            assert child.module
            assert not child.level, "imports name the whole package"
            whole = [f"{child.module}.{alias.name}" for alias in child.names]
            yield from (Import(one if one in modules() else child.module, now, child.lineno) for one in whole)
        elif isinstance(child, ast.Constant) and isinstance(child.value, str):
            # A registry's place is imported when it is asked for.
            if re.fullmatch(rf"{PACKAGE}[\w.]*:\w+", child.value):
                yield Import(child.value.partition(":")[0], False, child.lineno)
        else:
            yield from _imports(child, now and not later)


def ours(name: str) -> bool:
    return name.partition(".")[0] == PACKAGE


def room(name: str) -> str:
    """The part of the package that a module belongs to; the package's own file is ``skylight_sh``."""
    return name.split(".")[1] if "." in name else PACKAGE


def layers() -> list[list[str]]:
    """The rooms of each layer, the lowest first, as the page draws them."""
    drawn = re.search(r"```layers\n(.*?)```", ARCHITECTURE, re.DOTALL)
    assert drawn
    rows = [line.partition("|")[0].split() for line in drawn[1].splitlines()]
    return [row for row in reversed(rows) if row]


def test_every_room_is_drawn_once() -> None:
    drawn = [room for row in layers() for room in row]
    assert sorted(drawn) == sorted({room(name) for name in modules()}), "say in docs/architecture.md where a new room stands"


def test_nothing_imports_upwards() -> None:
    height = {room: level for level, row in enumerate(layers()) for room in row}
    wrong = [
        f"{name}:{found.line} imports {found.name}"
        for name in modules()
        for found in imports(name)
        if ours(found.name) and room(found.name) != room(name) and height[room(found.name)] >= height[room(name)]
    ]
    assert wrong == []


def test_no_circle_of_imports() -> None:
    graph = {name: {i.name for i in imports(name) if ours(i.name) and i.now} - {name} for name in modules()}
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as circle:
        pytest.fail(" <- ".join(circle.args[1]))


def test_what_is_imported_exists() -> None:
    missing = [
        f"{name}:{found.line} {found.name}"
        for name in modules()
        for found in imports(name)
        if ours(found.name) and found.name not in modules()
    ]
    assert missing == []


def test_numerics_leave_tasks_files_pictures_and_configs_to_others() -> None:
    wrong = [
        f"{name}:{found.line} imports {found.name}"
        for name in modules()
        if room(name) in NUMERICS and name != READS_FILES
        for found in imports(name)
        if not (
            room(found.name) not in ROOMS_ABOVE
            if ours(found.name)
            else found.name.partition(".")[0] in (FOR_NUMERICS if found.now else FOR_NUMERICS | LATER)
        )
    ]
    assert wrong == []


def test_the_runtime_is_one_file_for_any_project() -> None:
    roots = {found.name.partition(".")[0] for found in imports(f"{PACKAGE}.runtime")}
    assert roots <= sys.stdlib_module_names | {"numpy"}
    assert "numpy" in roots


def test_stages_alone_are_in_stages() -> None:
    """Every file there makes a step, by each of its public functions or for another stage; a step names what is there."""
    made = set(re.findall(r'"(\w+:make\w*)"', modules()[f"{PACKAGE}.run.steps"].read_text(encoding="utf-8")))
    found = set()
    for name in modules():
        stage = name.removeprefix(f"{PACKAGE}.run.stages.")
        if stage != name:
            body = ast.parse(modules()[name].read_text(encoding="utf-8")).body
            named = {node.name for node in body if isinstance(node, ast.FunctionDef) and node.name.startswith("make")}
            assert named, name
            found |= {f"{stage}:{function}" for function in named}
    assert found == made
