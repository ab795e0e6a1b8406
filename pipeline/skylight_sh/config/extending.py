"""Configs that extend another: ``extends = "other.toml"``, or a shipped config by its name, and then only what differs."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

from skylight_sh import shipped

Raw = dict[str, Any]
_DEEPEST = 8


def read(path: Path, depth: int = 0) -> Raw:
    """Return the parsed TOML at ``path`` laid over what it extends: a file beside it, or a shipped config.

    Tables are merged key by key, unless they are of another ``model`` or ``kind``; arrays of tables by their ``name``;
    anything else replaces what it extends, as an empty array does. A parameter that is fixed is no axis any more. Raises
    OSError and UnicodeDecodeError where a file cannot be read, and ValueError telling what else is wrong.
    """
    try:
        raw = tomllib.loads(path.read_text(encoding="utf-8"))
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"{path} is not valid TOML: {error}. Mend that line.") from error
    base = raw.get("extends")
    if not isinstance(base, str) or not base:
        return raw
    if depth == _DEEPEST:
        raise ValueError(f"{path}: extends = {base!r} is the {_DEEPEST + 1}th in a row, or one in a circle. Extend fewer.")
    place = path.parent / base
    if Path(base).name != base or "\0" in base or place.resolve().parent != path.parent.resolve():
        raise ValueError(
            f"{path}: extends = {base!r} leaves the config's folder. Name a config beside it, or a shipped one."
        )
    if "name" not in raw:
        raise ValueError(f"{path}: name is missing. A config that extends another needs its own: reports go under it.")
    below = read(place if place.is_file() else shipped.path(base) or place, depth + 1)
    fixed = raw.get("scene", {}).get("fixed", {}) if isinstance(raw.get("scene", {}), dict) else {}
    if isinstance(fixed, dict) and _named(below.get("axes")):
        below["axes"] = [axis for axis in below["axes"] if axis["name"] not in fixed]
    merged: Raw = _over(below, raw)
    return merged


def _over(base: Any, own: Any) -> Any:
    """Lay ``own`` over ``base``."""
    if isinstance(base, dict) and isinstance(own, dict):
        if any(key in own and own[key] != base.get(key) for key in ("model", "kind")):
            return own
        return {**base, **{key: _over(base[key], value) if key in base else value for key, value in own.items()}}
    if _named(base) and _named(own):
        by_name = {table["name"]: table for table in own}
        known = [_over(table, by_name.pop(table["name"])) if table["name"] in by_name else table for table in base]
        return [*known, *by_name.values()]
    return own


def _named(value: Any) -> bool:
    """Whether ``value`` is an array of tables with names, each once, and not empty."""
    if (
        not value
        or not isinstance(value, list)
        or not all(isinstance(table, dict) and isinstance(table.get("name"), str) for table in value)
    ):
        return False
    return len({table["name"] for table in value}) == len(value)
