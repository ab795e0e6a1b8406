"""Reading a config file: TOML in, a frozen Config out, or every error at once."""

from __future__ import annotations

import copy
import difflib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from pipeline.config import extending, problems, sun
from pipeline.config.problem import Problem
from pipeline.config.schema import Config


class ConfigError(ValueError):
    """A config that cannot be run; its text has one line a problem."""


def load(path: str | Path, run: Mapping[str, Any] | None = None) -> Config:
    """Read and check the config at ``path``; ``run`` overrides keys of its [run] section.

    Raises ConfigError naming every field, value and remedy.
    """
    try:
        raw = extending.read(Path(path))
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is not UTF-8 text"
        which = error.filename if isinstance(error, OSError) and error.filename else path
        raise ConfigError(
            f"{which} cannot be read ({reason}). Give the path of a TOML file, such as configs/preetham.toml."
        ) from error
    except ValueError as error:
        raise ConfigError(str(error)) from error
    if run and isinstance(raw.get("run", {}), dict):
        raw["run"] = {**raw.get("run", {}), **run}
    return parse(raw, str(path), Path(path).parent)


def parse(raw: dict[str, Any], where: str, folder: Path = Path()) -> Config:
    """Check the parsed TOML ``raw``; ``where`` names it in errors, paths in it start from ``folder``."""
    raw = copy.deepcopy(raw)
    wrong = sun.narrow(raw)
    if wrong:
        raise ConfigError(f"{where} has 1 problem:\n  {Problem('$.scene.sun', raw['scene']['sun'], wrong)}")
    try:
        # JSON mode is strict about types but takes arrays for tuples, as TOML has no tuples.
        config = Config.model_validate_json(json.dumps(raw, default=str)).within(folder)
    except ValidationError as error:
        found = [_problem(e, raw) for e in error.errors(include_url=False)]
    else:
        found = problems.find(config)
        if not found:
            return config
    lines = [f"{where} has {len(found)} problem{'s' if len(found) > 1 else ''}:", *(f"  {p}" for p in found)]
    raise ConfigError("\n".join(lines))


def _problem(error: Any, raw: dict[str, Any]) -> Problem:
    # A tagged union puts the tag into the location, which no config spells out.
    location = [part for i, part in enumerate(error["loc"]) if not (i == 1 and error["loc"][0] == "light")]
    path = "$" + "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in location)
    schema = Config.model_json_schema()
    if error["type"] in ("extra_forbidden", "unexpected_keyword_argument", "unexpected_property"):
        known = sorted(_describe(schema, location[:-1], raw).get("properties", {}))
        close = difflib.get_close_matches(str(location[-1]), known, n=1)
        hint = f"Did you mean {close[0]!r}?" if close else "Remove it."
        return Problem(path, error["input"], f"Unknown key. {hint} Known here: {', '.join(known)}.")
    described = _describe(schema, location, raw).get("description", "")
    if error["type"] == "missing":
        return Problem(path, None, f"This key is required. Add it: {described or 'see `python -m pipeline config schema`'}.")
    return Problem(
        path, error["input"], f"{error['msg']}. Allowed: {described or 'see `python -m pipeline config schema`'}."
    )


def _describe(schema: dict[str, Any], location: list[Any], raw: Any) -> dict[str, Any]:
    """Follow a location through the JSON Schema as far as it goes; the last description met comes along."""
    node: dict[str, Any] = schema
    description = ""
    for part in location:
        node = _resolve(schema, node, raw)
        raw = raw[part] if isinstance(raw, dict) and part in raw else raw[part] if _has(raw, part) else None
        node = node.get("properties", {}).get(part, {}) if isinstance(part, str) else node.get("items", {}) or node
        description = node.get("description", description)
    return {**_resolve(schema, node, raw), "description": description}


def _has(raw: Any, part: Any) -> bool:
    return isinstance(raw, list) and isinstance(part, int) and part < len(raw)


def _resolve(schema: dict[str, Any], node: dict[str, Any], raw: Any) -> dict[str, Any]:
    if "discriminator" in node:
        tag = raw.get("model") if isinstance(raw, dict) else None
        node = {"$ref": node["discriminator"]["mapping"].get(tag, "")}
    reference = node.get("$ref", "")
    return schema["$defs"][reference.rsplit("/", 1)[-1]] if reference else node
