"""Bases in one scaled variable u, -1 to 1 (``monomial`` takes any). One file each, named here."""

from __future__ import annotations

from skylight_sh.formula.bases.protocol import Basis
from skylight_sh.registry import Registry

BASES: Registry[Basis] = Registry(
    {
        "chebyshev": "skylight_sh.formula.bases.chebyshev:BASIS",
        "legendre": "skylight_sh.formula.bases.legendre:BASIS",
        "monomial": "skylight_sh.formula.bases.monomial:BASIS",
        "fourier": "skylight_sh.formula.bases.fourier:BASIS",
    }
)

__all__ = ["BASES", "Basis"]
