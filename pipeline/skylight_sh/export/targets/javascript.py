"""An ES module for browsers and Node, and its types."""

from __future__ import annotations

from skylight_sh.export import javascript, javascript_types
from skylight_sh.export.target import Target

TARGET = Target(
    lambda table, facts, _: {
        "skylight_sh.mjs": javascript.write(table, facts).encode(),
        "skylight_sh.d.mts": javascript_types.write(table, facts.title).encode(),
    }
)
