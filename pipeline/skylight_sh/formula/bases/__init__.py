"""Bases in one scaled variable u, -1 to 1 (``monomial`` takes any). One file each, named here."""

from __future__ import annotations

from typing import TYPE_CHECKING

from skylight_sh.registry import Registry

if TYPE_CHECKING:
    from skylight_sh.formula.bases.protocol import Basis

BASES: Registry[Basis] = Registry(
    {
        "chebyshev": "skylight_sh.formula.bases.chebyshev:BASIS",
        "legendre": "skylight_sh.formula.bases.legendre:BASIS",
        "monomial": "skylight_sh.formula.bases.monomial:BASIS",
        "fourier": "skylight_sh.formula.bases.fourier:BASIS",
    }
)
