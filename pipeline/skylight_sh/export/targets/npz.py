"""An archive that NumPy and ``skylight_sh.load`` read, always."""

from __future__ import annotations

from skylight_sh.export.target import Target
from skylight_sh.table import npz

TARGET = Target(lambda table, _, __: {"skylight_sh.npz": npz.write(table)})
