"""Changes of variable: monotone maps of a parameter's range onto [-1, 1]. One file each, named here."""

from __future__ import annotations

from typing import TYPE_CHECKING

from skylight_sh.registry import Registry

if TYPE_CHECKING:
    from skylight_sh.formula.variables.protocol import Variable

# By their names in a config's ``axes.map``.
VARIABLES: Registry[Variable] = Registry(
    {
        "raw": "skylight_sh.formula.variables.raw:VARIABLE",
        "identity": "skylight_sh.formula.variables.identity:VARIABLE",
        "log": "skylight_sh.formula.variables.log:VARIABLE",
        "reciprocal": "skylight_sh.formula.variables.reciprocal:VARIABLE",
        "cbrt": "skylight_sh.formula.variables.cbrt:VARIABLE",
        "even": "skylight_sh.formula.variables.even:VARIABLE",
    }
)
