"""Targets of the export, one file a target, named here. What a target writes, its file's first line says."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from skylight_sh.export.shader_dialects import DIALECTS
from skylight_sh.registry import Registry

if TYPE_CHECKING:
    from skylight_sh.export.c_header import Facts
    from skylight_sh.export.target import Target
    from skylight_sh.runtime import Table

TARGETS: Registry[Target] = Registry(
    {
        "c": "skylight_sh.export.targets.c:TARGET",
        "direct": "skylight_sh.export.targets.direct:TARGET",
        "csharp": "skylight_sh.export.targets.csharp:TARGET",
        "javascript": "skylight_sh.export.targets.javascript:TARGET",
        "npz": "skylight_sh.export.targets.npz:TARGET",
        "vectors": "skylight_sh.export.targets.vectors:TARGET",
    }
) | DIALECTS.beside("TARGET")
# What every run ships.
ALWAYS = ("c", "npz")


def write(names: Sequence[str], table: Table, facts: Facts, prefix: str) -> dict[str, bytes]:
    """Return the files of ``table`` by name for the targets ``names``, but for those that have an obstacle."""
    targets = [TARGETS[name] for name in dict.fromkeys(names)]
    shipped = [target.write(table, facts, prefix) for target in targets if target.obstacle(table) is None]
    return {name: data for files in shipped for name, data in files.items()}
