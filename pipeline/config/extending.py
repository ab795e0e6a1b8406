"""Configs that extend another: ``extends = "other.toml"``, and then only what differs."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

Raw = dict[str, Any]
_DEEPEST = 8


def read(path: Path, depth: int = 0) -> Raw:
    """Return the parsed TOML at ``path`` laid over what it extends, a file of its own folder or below.

    Tables are merged key by key, arrays of tables by their ``name``; anything else replaces what it extends. Raises OSError
    and UnicodeDecodeError where a file cannot be read, and ValueError (TOMLDecodeError is one) telling what is wrong.
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
    below = path.parent / base
    if not below.resolve().is_relative_to(path.parent.resolve()):
        raise ValueError(f"{path}: extends = {base!r} leaves the config's folder. Extend a config beside it, or below.")
    merged: Raw = _over(read(below, depth + 1), raw)
    return merged


def _over(base: Any, own: Any) -> Any:
    """Lay ``own`` over ``base``."""
    if isinstance(base, dict) and isinstance(own, dict):
        return {**base, **{key: _over(base[key], value) if key in base else value for key, value in own.items()}}
    if _named(base) and _named(own):
        by_name = {table["name"]: table for table in own}
        known = [_over(table, by_name.pop(table["name"])) if table["name"] in by_name else table for table in base]
        return [*known, *by_name.values()]
    return own


def _named(value: Any) -> bool:
    """Whether ``value`` is an array of tables with names, each once."""
    if not isinstance(value, list) or not all(
        isinstance(table, dict) and isinstance(table.get("name"), str) for table in value
    ):
        return False
    return len({table["name"] for table in value}) == len(value)
