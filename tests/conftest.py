"""One small run of the whole pipeline, shared by the tests that look at its results."""

from __future__ import annotations

import os
import tomllib
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings
from skylight_sh.config import Config, load, parse
from skylight_sh.run.runner import Result, run
from skylight_sh.runtime import Table
from skylight_sh.store.store import Store

# Examples are drawn anew on a developer's machine, and are the same ones on every CI run.
settings.register_profile("ci", derandomize=True, deadline=None)
settings.register_profile("dev", deadline=None)
settings.load_profile("ci" if os.environ.get("CI") else "dev")

ROOT = Path(__file__).resolve().parents[1]
SMALL = Path(__file__).parent / "small.toml"


# Of tests/small.toml, one table a budget.
ONE_LAYOUT = SMALL.read_text(encoding="utf-8").replace('layouts = ["rows", "packed"]\n', "")


def scene_config(scene: str, text: str = ONE_LAYOUT, folder: Path = Path()) -> Config:
    """Return the config ``text`` with a [scene] of these lines; its paths start from ``folder``."""
    return parse(tomllib.loads(f"{text}\n[scene]\n{scene}\n"), "a config", folder)


def with_spec(table: Table, **changes: Any) -> Table:
    """Return ``table`` with other fields of its specification."""
    return replace(table, spec=replace(table.spec, **changes))


def run_quietly(config: Config, place: Path) -> Result:
    """Run a config with its store and reports under ``place``; a warning is an error."""

    def warn(text: str) -> None:
        raise AssertionError(text)

    return run(config, Store(place / "artifacts"), place / "reports", warn)


@pytest.fixture(scope="session")
def small_run(tmp_path_factory: pytest.TempPathFactory) -> Result:
    """A run of tests/small.toml in a folder of its own."""
    return run_quietly(load(SMALL), tmp_path_factory.mktemp("small"))
