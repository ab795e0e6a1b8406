"""Reading a config file: TOML in, a frozen Config out, or every error at once."""

from __future__ import annotations

import copy
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from skylight_sh.config import extending, schema_errors, sun_range, validation
from skylight_sh.config.problem import ConfigError, Problem, refusal
from skylight_sh.config.schema import Config


def load(path: str | Path, run: Mapping[str, Any] | None = None) -> Config:
    """Read and check the config at ``path``; ``run`` overrides keys of its [run] section.

    Raises ConfigError naming every field, value and remedy.
    """
    try:
        raw = extending.read(Path(path))
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is not UTF-8 text"
        which = error.filename if isinstance(error, OSError) and error.filename else path
        raise ConfigError(f"{which} cannot be read ({reason}). Give the path of a TOML file.") from error
    except ValueError as error:
        raise ConfigError(str(error)) from error
    if run and isinstance(raw.get("run", {}), dict):
        raw["run"] = {**raw.get("run", {}), **run}
    return parse(raw, str(path), Path(path).parent)


def parse(raw: dict[str, Any], where: str, folder: Path = Path()) -> Config:
    """Check the parsed TOML ``raw``; ``where`` names it in errors, paths in it start from ``folder``."""
    raw = copy.deepcopy(raw)
    try:
        # JSON mode is strict about types but takes arrays for tuples, as TOML has no tuples.
        config = Config.model_validate_json(json.dumps(raw, default=str))
    except ValidationError as error:
        found = schema_errors.problems(error, raw)
    else:
        try:
            config = sun_range.narrowed(config).within(folder)
        except ValueError as error:
            found = [Problem("$.scene.sun", raw["scene"]["sun"], str(error))]
        else:
            found = validation.find(config)
            if not found:
                return config
    raise refusal(where, found)
