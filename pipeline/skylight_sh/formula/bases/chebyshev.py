"""Chebyshev polynomials of the first kind."""

from __future__ import annotations

from skylight_sh.formula.bases.protocol import Basis

BASIS = Basis(
    function=lambda k, u, t: 2 * u * t[k - 1] - t[k - 2] if k > 1 else u,
    nested=True,
    # T_(h+k) = 2 T_h T_k - T_|h-k|.
    shallow=lambda k, u, t: 2 * t[k // 2] * t[k - k // 2] - t[k % 2] if k > 1 else u,
)
