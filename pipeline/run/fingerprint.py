"""What decides what a process computes: this package's code, Python, libraries, and the lights of other packages.

Two processes may share work only where these agree: a worker with other code gives other numbers, which a store would then
serve for ever.
"""

from __future__ import annotations

import hashlib
import platform
import sys
from collections.abc import Mapping
from functools import lru_cache
from importlib.metadata import EntryPoint, PackageNotFoundError, entry_points, version
from importlib.util import find_spec
from pathlib import Path

from pipeline.light.plugin import GROUP
from pipeline.store.keys import code_version

Fingerprint = Mapping[str, str]
# Libraries that decide a light, by the module that is loaded where one is in use.
_OPTIONAL = {"colour": "colour-science", "mitsuba": "mitsuba"}
_SHOWN = 12
# Python writes these itself.
_BYTECODE = (".pyc", ".pyo")


def in_use() -> tuple[str, ...]:
    """Return what decides this process's results beside the package and Python: libraries, and ``light ENTRY``."""
    # Imported here: it loads the config's schema, which a worker can do without.
    from pipeline.run.provenance import libraries

    loaded = [name for module, name in _OPTIONAL.items() if module in sys.modules]
    lights = {f"light {point.name}" for point in entry_points(group=GROUP) if point.module in sys.modules}
    return (*libraries(), *loaded, *sorted(lights))


@lru_cache(maxsize=8)
def fingerprint(used: tuple[str, ...]) -> Fingerprint:
    """Return what decides this process's results, by name; ``used`` is ``in_use`` of whoever asks.

    The first answer stands for the process's whole life, as the modules it has loaded do: one whose files changed since
    then goes on with its old code, and says so.
    """
    found = {
        "the code of skylight-sh": code_version((".",))[:_SHOWN],
        "Python": ".".join(platform.python_version_tuple()[:2]),
    }
    return found | {name: _light(name[6:]) if name.startswith("light ") else _version(name) for name in used}


def differences(found: Fingerprint, expected: Fingerprint) -> str:
    """Say where ``found``, a worker's, differs from ``expected``, one's own: an empty text where it does not."""
    names = [name for name in {**expected, **found} if found.get(name) != expected.get(name)]
    return "; ".join(f"{name} is {found.get(name, 'missing')} there and {expected.get(name, 'missing')} here" for name in names)


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "missing"


def _light(entry: str) -> str:
    """Return the package that offers the light ``entry``, its version and its code's hash."""
    points = {point.name: point for point in entry_points(group=GROUP)}
    if entry not in points:
        return "missing"
    package = points[entry].dist
    told = f"{package.name} {package.version}" if package else "of an unknown package"
    return f"{told} ({_code(points[entry])})"


def _code(point: EntryPoint) -> str:
    """Return the hash of a light's files: all of its package, data too, or of its one module."""
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
    files = [p for p in folder.rglob("*") if p.is_file()] if spec.submodule_search_locations else [origin]
    state = hashlib.sha256()
    try:
        for path in sorted(p for p in files if p.suffix not in _BYTECODE):
            state.update(path.relative_to(folder).as_posix().encode() + b"\0")
            state.update(hashlib.sha256(path.read_bytes()).digest())
    except OSError:
        return "code not found"
    return f"code {state.hexdigest()[:_SHOWN]}"
