"""Keys of artifacts: SHA-256 of canonical JSON."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable
from functools import lru_cache
from pathlib import Path
from typing import Any

_PACKAGE = Path(__file__).resolve().parents[1]


def digest(value: Any) -> str:
    """Return the SHA-256 of ``value`` as canonical JSON. Raises TypeError for what JSON cannot hold, ValueError for NaN."""
    text = json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=True, allow_nan=False)
    return hashlib.sha256(text.encode()).hexdigest()


@lru_cache(maxsize=64)
def code_version(parts: tuple[str, ...]) -> str:
    """Return a hash of the source files of ``parts``: folders or files of the package, e.g. ``("light", "truth")``."""
    state = hashlib.sha256()
    for path in sorted(set(_sources(parts))):
        state.update(path.relative_to(_PACKAGE).as_posix().encode() + b"\0")
        state.update(hashlib.sha256(path.read_bytes()).digest())
    return state.hexdigest()


def _sources(parts: Iterable[str]) -> Iterable[Path]:
    for part in parts:
        place = _PACKAGE / part
        if place.is_file():
            yield place
        elif place.is_dir():
            yield from (p for p in place.rglob("*") if p.suffix in (".py", ".j2"))
        else:
            raise ValueError(f"The package has no part {part!r}.")
