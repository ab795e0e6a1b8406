"""Which lights installed packages offer, and what tells one state of such a package from another."""

from __future__ import annotations

import hashlib
from functools import lru_cache
from importlib.metadata import EntryPoint, entry_points
from importlib.util import find_spec
from pathlib import Path

GROUP = "skylight_sh.lights"
_SHOWN = 12
# Python writes these itself.
_BYTECODE = (".pyc", ".pyo")


def points() -> dict[str, EntryPoint]:
    """Return the entry points of the group ``skylight_sh.lights`` by name."""
    return {point.name: point for point in entry_points(group=GROUP)}


@lru_cache(maxsize=64)
def identity(entry: str) -> str:
    """Return the package that offers the light ``entry``, its version and a hash of its code, or ``missing``.

    The first answer stands for the process's whole life, as the modules it has loaded do.
    """
    point = points().get(entry)
    if point is None:
        return "missing"
    package = f"{point.dist.name} {point.dist.version}" if point.dist else "unknown"
    return f"{package} {_code(point)}"


def _code(point: EntryPoint) -> str:
    """Return a hash of a light's files: all of its package, data too, or its one module."""
    try:
        spec = find_spec(point.module.partition(".")[0])
        if spec is not None and spec.origin is None:
            # A namespace, which several packages may share.
            spec = find_spec(point.module)
    except (ImportError, ValueError, AttributeError):
        spec = None
    if spec is None or spec.origin is None:
        return "code not found"
    origin = Path(spec.origin)
    folder = origin.parent
    state = hashlib.sha256()
    try:
        files = [p for p in folder.rglob("*") if p.is_file()] if spec.submodule_search_locations else [origin]
        for path in sorted(p for p in files if p.suffix not in _BYTECODE):
            state.update(path.relative_to(folder).as_posix().encode() + b"\0")
            state.update(hashlib.sha256(path.read_bytes()).digest())
    except OSError:
        return "code not found"
    return f"code {state.hexdigest()[:_SHOWN]}"
