"""Test vectors, and a C program that holds the header against them."""

from __future__ import annotations

from skylight_sh.export import vectors
from skylight_sh.export.target import Target

TARGET = Target(
    lambda table, _, prefix: {
        "skylight_sh_vectors.txt": vectors.write(table).encode(),
        "skylight_sh_selftest.c": vectors.self_test(table, prefix).encode(),
    }
)
