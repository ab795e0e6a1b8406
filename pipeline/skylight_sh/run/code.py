"""The code that a step runs, found by itself: the files its function's module imports, and theirs, to the last one."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from functools import lru_cache, partial
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
)
_SUFFIXES = (".py", ".j2", ".h", ".c")
# A registry's places.
_NAMED = re.compile(rf"[\"']({PACKAGE}[\w.]*):\w+[\"']")
_IMPORT = re.compile(
    rf"^[ \t]*(?:from[ \t]+({PACKAGE}[\w.]*)[ \t]+import[ \t]+(\([^)]*\)|[^\n(]+)|import[ \t]+({PACKAGE}[\w.]*))",
    re.MULTILINE,
)


def version_of(make: Callable[..., Any]) -> str:
    """Return a hash of all code of this package that ``make`` can run, and of that of the values bound to it.

    >>> version_of(version_of) == version_of(partial(version_of, 1))
    True
    """
    return _digest(closure(sorted(set(_modules(make)))))


@lru_cache(maxsize=1)
def whole_version() -> str:
    """Return a hash of all code of this package."""
    return _digest(tuple(path for path in sorted(_ROOT.rglob("*")) if path.suffix in _SUFFIXES))


def closure(modules: Iterable[str]) -> tuple[Path, ...]:
    """Return the files of ``modules`` and of what they import, now or later, sorted; templates beside them included."""
    found: set[Path] = set()
    todo = [path for name in modules for path in _files(name)]
    while todo:
        path = todo.pop()
        relative = path.relative_to(_ROOT).as_posix()
        if path in found or relative.startswith(_ELSEWHERE):
            continue
        found.add(path)
        todo += _imported(path)
    texts = {p for folder in {path.parent for path in found} for p in folder.rglob("*") if p.suffix in _SUFFIXES[1:]}
    return tuple(sorted(found | texts))


def _modules(value: Any) -> Iterator[str]:
    """Yield the names of this package's modules that ``value``, a function or bound data, comes from."""
    if isinstance(value, partial):
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


def _files(name: str) -> list[Path]:
    """Return the files that importing the module ``name`` runs: its own, and those of the packages about it."""
    place, found = _ROOT, []
    for part in name.split(".")[1:]:
        place = place / part
        found += [path for path in (place.with_suffix(".py"), place / "__init__.py") if path.is_file()]
    return found


@lru_cache(maxsize=512)
def _imported(path: Path) -> tuple[Path, ...]:
    found: list[Path] = []
    text = path.read_text(encoding="utf-8")
    for source, names, plain in _IMPORT.findall(text):
        found += _files(source or plain)
        for name in re.findall(r"[\w]+", re.sub(r"\bas\s+\w+|#[^\n]*", "", names)):
            found += _files(f"{source}.{name}")
    for named in _NAMED.findall(text):
        found += _files(named)
    return tuple(dict.fromkeys(found))


@lru_cache(maxsize=512)
def _sum(path: Path) -> bytes:
    return hashlib.sha256(path.read_bytes()).digest()


@lru_cache(maxsize=64)
def _digest(paths: tuple[Path, ...]) -> str:
    state = hashlib.sha256()
    for path in paths:
        state.update(path.relative_to(_ROOT).as_posix().encode() + b"\0")
        state.update(_sum(path))
    return state.hexdigest()
