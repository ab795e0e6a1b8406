"""A C header that sums the Preetham sky itself, without a table: for any turbidity that the model allows."""

from __future__ import annotations

from skylight_sh.export import direct
from skylight_sh.export.target import Target

TARGET = Target(
    lambda table, facts, prefix: {"skylight_sh_direct.h": direct.write(table, facts.provenance, prefix).encode()},
    direct.obstacle,
    direct.misfit,
)
