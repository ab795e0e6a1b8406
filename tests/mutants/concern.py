"""Which tests concern a mutant: those that run its lines, as recorded once for each test module."""

from __future__ import annotations

import hashlib
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from .generate import Mutant

# Tests of these hold the tool itself, or the text of the repository.
_NOT_ASKED = ("tests/test_mutants.py", "tests/test_readme.py")


def files(root: Path) -> list[str]:
    """Return the repository's files: those git tracks or would."""
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=root,
        check=True,
        capture_output=True,
        text=True,
    )
    return sorted(path for path in set(listed.stdout.splitlines()) if (root / path).is_file())


def environment(copy: Path) -> dict[str, str]:
    """Return what tests in a copy run under: its own package, the same examples each time, and this tool's plugins."""
    tools = Path(__file__).resolve().parents[1]
    return {**os.environ, "CI": "1", "PYTHONPATH": os.pathsep.join([str(copy / "pipeline"), str(tools)])}


class Record:
    """What was recorded of all test modules."""

    def __init__(self, parts: Iterable[dict[str, Any]]) -> None:
        self.seconds: dict[str, float] = {}
        self.lines: dict[str, dict[int, set[str]]] = {}
        self.templates: dict[str, set[str]] = {}
        self.failed: set[str] = set()
        self.tools: set[str] = set()
        for part in parts:
            self._add(part)

    def _add(self, part: dict[str, Any]) -> None:
        self.failed |= set(part["failed"])
        self.tools |= set(part["tools"])
        tests = [test for test in part["fixtures"] if test not in self.failed]
        of: dict[str, set[str]] = {f"test {test}": {test} for test in tests}
        for test in tests:
            own = part["seconds"][f"test {test}"]
            of.setdefault(f"module {test.split('::')[0]}", set()).add(test)
            for name in part["fixtures"][test]:
                of.setdefault(f"fixture {name}", set()).add(test)
            # A test pays for its fixtures where nobody did before it.
            self.seconds[test] = own + sum(part["seconds"].get(f"fixture {name}", 0.0) for name in part["fixtures"][test])
        for path, lines in part["lines"].items():
            known = self.lines.setdefault(path, {})
            for line, contexts in lines.items():
                known.setdefault(int(line), set()).update(*(of.get(context, set()) for context in contexts))
        for name, contexts in part["templates"].items():
            self.templates.setdefault(name, set()).update(*(of.get(context, set()) for context in contexts))

    def concerned(self, mutant: Mutant, read: Callable[[str], str]) -> list[str]:
        """Return the tests that concern a mutant: those that run its lines or use its names, then others of its file."""
        if not mutant.path.endswith(".py"):
            return self._by_cost(self.templates.get(Path(mutant.path).name, set()))
        lines = self.lines.get(mutant.path, {})
        first, last = mutant.lines
        near = set().union(*(lines.get(line, set()) for line in range(first, last + 1)))
        for name in mutant.names:
            near |= self._users(name, mutant.path, read)
        far = set().union(*lines.values()) - near if mutant.wide else set()
        # Of a long statement, such as a table of functions, its own line's tests know most.
        own = lines.get(mutant.line, set())
        return self._by_cost(own) + self._by_cost(near - own) + self._by_cost(far - own)

    def _users(self, name: str, path: str, read: Callable[[str], str]) -> set[str]:
        found: set[str] = set()
        for other, lines in self.lines.items():
            if other == path or not name.startswith("_"):
                for number, text in enumerate(read(other).splitlines(), start=1):
                    if re.search(rf"\b{name}\b", text):
                        found |= lines.get(number, set())
        return found

    def _by_cost(self, tests: set[str]) -> list[str]:
        return sorted(tests, key=lambda test: (self.seconds[test], test))


def measure(root: Path, copies: Sequence[Path], cache: Path, say: Callable[[str], None]) -> Record:
    """Return the record of copies of ``root``; what ``cache`` knows of the same files is not run again."""
    cache.mkdir(parents=True, exist_ok=True)
    listed = [path for path in files(root) if not path.startswith("tests/mutants/")]
    modules = [path for path in listed if re.fullmatch(r"tests/(.+/)?test_\w+\.py", path) and path not in _NOT_ASKED]
    common = re.compile(r"(pipeline|configs|reports/reference)/|tests/(?!\w+\.py$)|tests/conftest\.py")
    inside = [path for path in listed if common.match(path)]
    shared = hashlib.sha256()
    for path in inside:
        shared.update(path.encode() + (root / path).read_bytes())
    places = {}
    for module in modules:
        name = module.replace("/", "-").removesuffix(".py")
        own = b"".join((root / path).read_bytes() for path in sorted(_imported(root, module)))
        places[module] = cache / f"{name}-{hashlib.sha256(shared.digest() + own).hexdigest()[:16]}.json"
        if not places[module].is_file():
            for old in cache.glob(f"{name}-*.json"):
                old.unlink()
    waiting = [module for module in modules if not places[module].is_file()]

    def work(copy: Path) -> None:
        while waiting:
            module = waiting.pop()
            say(f"recording {module}")
            _record(copy, module, places[module])

    with ThreadPoolExecutor(len(copies)) as pool:
        list(pool.map(work, copies))
    return Record(json.loads(place.read_text(encoding="utf-8")) for place in places.values())


def _imported(root: Path, module: str) -> set[str]:
    """Return a test module and the files beside it that it imports, and so on."""
    found, new = set(), {module}
    while new:
        found |= new
        text = "\n".join((root / path).read_text(encoding="utf-8") for path in new)
        names = re.findall(r"^(?:from|import) (\w+)", text, re.MULTILINE)
        new = {path for name in names if (root / (path := f"tests/{name}.py")).is_file()} - found
    return found


def _record(copy: Path, module: str, place: Path) -> None:
    command = [sys.executable, "-m", "pytest", "-q", "-m", "", "-p", "mutants.recording", module]
    more = {"RECORD_TO": str(place), "RECORD_SOURCES": json.dumps([str(copy / "pipeline")])}
    done = subprocess.run(command, cwd=copy, env={**environment(copy), **more}, check=False, capture_output=True, text=True)
    if not place.is_file():
        raise RuntimeError(f"{module} could not be recorded:\n{done.stdout}\n{done.stderr}")
