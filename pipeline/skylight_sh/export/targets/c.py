"""A header, C99 and C++11, always."""

from __future__ import annotations

from skylight_sh.export import c_header
from skylight_sh.export.target import Target

TARGET = Target(lambda table, facts, prefix: {"skylight_sh.h": c_header.write(table, facts, prefix).encode()})
