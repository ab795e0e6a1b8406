"""The code that a step runs, found by itself: the files its function's module imports, and theirs, to the last one."""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass
from functools import lru_cache, partial
from importlib import import_module
from pathlib import Path
from typing import Any

PACKAGE = __name__.split(".", maxsplit=1)[0]
_ROOT = Path(__file__).resolve().parents[1]
# Whose values stand in a key themselves (a config's), or that decide where and when work is done and never its result.
_ELSEWHERE = (
    "cli",
    "config",
    "store",
    "run/code.py",
    "run/executors.py",
    "run/fingerprint.py",
    "run/plan.py",
    "run/progress.py",
    "run/provenance.py",
    "run/steps.py",
)
_SUFFIXES = (".py", ".j2", ".h", ".c", ".cs", ".mjs", ".css", ".glsl", ".bin", ".webp")
# Each starts with plain letters, which are found much faster than blanks before them: ``_starts_line`` looks at those.
_FROM = re.compile(rf"from[ \t]+({PACKAGE}[\w.]*)[ \t]+import[ \t]+(\([^)]*\)|[^\n(]+)")
_IMPORT = re.compile(rf"import[ \t]+({PACKAGE}[\w.]*)")
# A registry's places.
_NAMED = re.compile(rf"({PACKAGE}[\w.]*):\w+[\"']")


@dataclass(frozen=True)
class Later:
    """A function of this package by its place, ``"module:name"``, with its first arguments; imported when it is called.

    >>> Later("math:hypot", (3.0,))(4.0)
    5.0
    """

    place: str
    arguments: tuple[Any, ...]

    def __call__(self, *others: Any) -> Any:
        """Call the function with ``arguments`` and then the ``others``."""
        module, _, name = self.place.partition(":")
        return getattr(import_module(module), name)(*self.arguments, *others)


def version_of(make: Callable[..., Any]) -> str:
    """Return a hash of all code of this package that ``make`` can run, and of that of the values bound to it.

    >>> version_of(version_of) == version_of(partial(version_of, 1))
    True
    """
    return _digest(closure(sorted(set(_modules(make)))))


@lru_cache(maxsize=1)
def whole_version() -> str:
    """Return a hash of all code of this package."""
    return _digest(tuple(sorted(_sources())))


def closure(modules: Iterable[str]) -> tuple[str, ...]:
    """Return the files of ``modules`` and of what they import, now or later, sorted; templates beside them included.

    Files are paths from the package's folder, with slashes.
    """
    found: set[str] = set()
    todo = [path for name in modules for path in _files(name)]
    while todo:
        path = todo.pop()
        if path not in found and not path.startswith(_ELSEWHERE):
            found.add(path)
            todo += imported(path)
    folders = {path.rpartition("/")[0] for path in found} - {""}
    texts = {path for path in _sources() if not path.endswith(".py") and not folders.isdisjoint(_above(path))}
    return tuple(sorted(found | texts))


@lru_cache(maxsize=512)
def imported(path: str) -> tuple[str, ...]:
    """Return the files of this package that the file at ``path`` imports, or a registry in it names."""
    text = _read(path).decode()
    names: list[str] = []
    for match in _FROM.finditer(text):
        if _starts_line(text, match.start()):
            parts = re.findall(r"\w+", re.sub(r"\bas\s+\w+|#[^\n]*", "", match[2]))
            names += [match[1], *(f"{match[1]}.{part}" for part in parts)]
    names += [match[1] for match in _IMPORT.finditer(text) if _starts_line(text, match.start())]
    names += [match[1] for match in _NAMED.finditer(text) if text[match.start() - 1] in "\"'"]
    return tuple(dict.fromkeys(file for name in names for file in _files(name)))


def _starts_line(text: str, place: int) -> bool:
    return not text[text.rfind("\n", 0, place) + 1 : place].strip()


def _modules(value: Any) -> Iterator[str]:
    """Yield the names of this package's modules that ``value``, a function or bound data, comes from."""
    if isinstance(value, Later):
        yield value.place.partition(":")[0]
        yield from _modules(value.arguments)
    elif isinstance(value, partial):
        yield from _modules(value.func)
        for part in (*value.args, *value.keywords.values()):
            yield from _modules(part)
    elif isinstance(value, Mapping):
        for part in value.values():
            yield from _modules(part)
    elif isinstance(value, list | tuple | set | frozenset):
        for part in value:
            yield from _modules(part)
    else:
        module = getattr(value if callable(value) else type(value), "__module__", "") or ""
        if module.split(".", maxsplit=1)[0] != PACKAGE:
            return
        yield module
        if is_dataclass(value) and not isinstance(value, type):
            yield from _modules([getattr(value, field.name) for field in fields(value)])
        elif hasattr(type(value), "model_fields"):
            yield from _modules([getattr(value, name) for name in type(value).model_fields])


@lru_cache(maxsize=1024)
def _files(name: str) -> tuple[str, ...]:
    """Return the files that importing the module ``name`` runs: its own, and those of the packages about it."""
    parts = name.split(".")[1:]
    places = ["/".join(parts[: i + 1]) for i in range(len(parts))]
    return tuple(f for place in places for f in (f"{place}.py", f"{place}/__init__.py") if f in _sources())


@lru_cache(maxsize=1)
def _sources() -> frozenset[str]:
    """Return all files of code of this package; looked up once, as the modules of a process are read once."""
    found = []
    for folder, folders, names in os.walk(_ROOT):
        folders[:] = [name for name in folders if name != "__pycache__"]
        start = Path(folder).relative_to(_ROOT).as_posix()
        found += [f"{start}/{name}".removeprefix("./") for name in names if name.endswith(_SUFFIXES)]
    return frozenset(found)


def _above(path: str) -> list[str]:
    """Return the folders that a file is in, from its own up."""
    return [path[:i] for i, letter in enumerate(path) if letter == "/"]


@lru_cache(maxsize=512)
def _read(path: str) -> bytes:
    return (_ROOT / path).read_bytes()


@lru_cache(maxsize=64)
def _digest(paths: tuple[str, ...]) -> str:
    state = hashlib.sha256()
    for path in paths:
        state.update(path.encode() + b"\0" + hashlib.sha256(_read(path)).digest())
    return state.hexdigest()
