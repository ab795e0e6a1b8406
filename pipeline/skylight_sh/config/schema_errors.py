"""What pydantic finds wrong with a config, told in the config's own spelling, with what the schema allows there."""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from skylight_sh.config.problem import Problem
from skylight_sh.config.schema import Config


def problems(error: ValidationError, raw: dict[str, Any]) -> list[Problem]:
    """Return what is wrong with the parsed TOML ``raw``, each place once."""
    schema = Config.model_json_schema()
    # A value that fits no branch of a union fails in each: the first failure that goes deepest tells enough.
    found = [_problem(detail, raw, schema) for detail in error.errors(include_url=False)]
    told = {problem.path: problem for problem in reversed(found)}
    return [p for path, p in reversed(told.items()) if not any(q.startswith((f"{path}.", f"{path}[")) for q in told)]


def _problem(error: ErrorDetails, raw: dict[str, Any], schema: dict[str, Any]) -> Problem:
    location, node = _follow(schema, error["loc"], raw)
    path = "$" + "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in location)
    if error["type"] in ("extra_forbidden", "unexpected_keyword_argument", "unexpected_property"):
        known = sorted(_follow(schema, error["loc"][:-1], raw)[1].get("properties", {}))
        close = difflib.get_close_matches(str(location[-1]), known, n=1)
        hint = f"Did you mean {close[0]!r}?" if close else "Remove it."
        return Problem(path, error["input"], f"Unknown key. {hint} Known here: {', '.join(known)}.")
    described = node.get("description", "") or "see `skylight-sh config schema`"
    if error["type"] == "missing":
        return Problem(path, None, f"This key is required. Add it: {described}.")
    return Problem(path, error["input"], f"{error['msg']}. Allowed: {described}.")


def _follow(schema: dict[str, Any], location: Sequence[Any], raw: Any) -> tuple[list[Any], dict[str, Any]]:
    """Follow an error's location through the JSON Schema as far as it goes.

    Returns the location as a config spells it, without the tags of unions that pydantic puts in, and what the schema says
    there; the last description met comes along.
    """
    node = _resolve(schema, schema, raw)
    spelt: list[Any] = []
    description = ""
    for part in location:
        if part == _tag(node) and part not in node.get("properties", {}):
            continue
        if isinstance(part, str) and "anyOf" in node and part not in node.get("properties", {}):
            # pydantic's label of a union's branch.
            continue
        spelt.append(part)
        raw = raw[part] if (isinstance(raw, dict) and part in raw) or _has(raw, part) else None
        inside = node.get("properties", {}).get(part, {}) if isinstance(part, str) else node.get("items", {}) or node
        description = inside.get("description", description)
        node = _resolve(schema, inside, raw)
    return spelt, {**node, "description": description}


def _tag(branch: dict[str, Any]) -> object:
    """Return the constant that tells a branch of a union from the others, if it has one."""
    properties = branch.get("properties", {})
    return next((properties[key]["const"] for key in ("model", "kind") if "const" in properties.get(key, {})), None)


def _has(raw: Any, part: Any) -> bool:
    return isinstance(raw, list) and isinstance(part, int) and part < len(raw)


def _resolve(schema: dict[str, Any], node: dict[str, Any], raw: Any) -> dict[str, Any]:
    """Return what a node refers to: by name, by the tag in ``raw``, or as the only alternative to null."""
    if "discriminator" in node and isinstance(raw, dict):
        tag = raw.get(node["discriminator"]["propertyName"])
        node = {"$ref": node["discriminator"]["mapping"].get(tag, "")}
    only = [branch for branch in node.get("anyOf", []) if branch.get("type") != "null"]
    if len(only) == 1:
        node = {**node, **only[0]}
    reference = node.get("$ref", "")
    return schema["$defs"][reference.rsplit("/", 1)[-1]] if reference else node
