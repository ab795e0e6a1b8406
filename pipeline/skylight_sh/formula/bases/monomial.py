"""Powers, as the paper has them."""

from __future__ import annotations

from skylight_sh.formula.bases.protocol import Basis

BASIS = Basis(
    function=lambda k, u, t: u * t[k - 1] if k > 1 else u,
)
