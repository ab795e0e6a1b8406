"""What a target of the export is: files that a renderer, or its tests, read of one table."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from skylight_sh.export.c_header import Facts
    from skylight_sh.light.protocol import Light
    from skylight_sh.runtime import Table


@dataclass(frozen=True)
class Target:
    """A way to ship a table.

    ``write(table, facts, prefix)`` returns the files' bytes by name, equal ones for equal tables; every global name in them
    starts with ``prefix``. ``obstacle(table)`` says why a table cannot be shipped so, or nothing where it can: a run leaves
    it out. ``misfit(light, scene)`` says why no table of a config's light and scene (its section as plain values) can, and
    the remedy, or nothing: the config is refused.
    """

    write: Callable[[Table, Facts, str], Mapping[str, bytes]]
    obstacle: Callable[[Table], str | None] = lambda _: None
    misfit: Callable[[Light, Mapping[str, Any]], str | None] = lambda _, __: None
