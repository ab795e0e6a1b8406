"""A released table as sources of other languages, so that nobody must run anything to use it."""

from __future__ import annotations

import json
from pathlib import Path

from skylight_sh import runtime
from skylight_sh.export import targets
from skylight_sh.run.stages.export import told_of
from skylight_sh.run.verify import released_config

TARGETS = ("glsl", "hlsl", "wgsl", "javascript", "csharp")


def of(folder: Path) -> dict[str, bytes]:
    """Return the recommended table of the released run in ``folder`` as files of every language but C, by name.

    They are what a run writes whose config asks for these targets. Raises ValueError where the folder holds no result.
    """
    config = released_config(folder)
    rows = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["tables"]
    row = next(row for row in rows if row["name"] == config.export.recommended)
    table = runtime.read(folder / row["path"] / "skylight_sh.npz")
    return targets.write(TARGETS, table, told_of(config, row), row["prefix"])
