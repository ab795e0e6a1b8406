"""An ES module for browsers and Node."""

from __future__ import annotations

from skylight_sh.export import javascript
from skylight_sh.export.target import Target

TARGET = Target(lambda table, facts, _: {"skylight_sh.mjs": javascript.write(table, facts).encode()})
