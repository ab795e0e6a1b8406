"""Legendre polynomials."""

from __future__ import annotations

from skylight_sh.formula.bases.protocol import Basis

BASIS = Basis(
    function=lambda k, u, t: ((2 * k - 1) * u * t[k - 1] - (k - 1) * t[k - 2]) / k if k > 1 else u,
)
