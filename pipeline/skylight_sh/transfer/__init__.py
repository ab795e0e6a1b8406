"""Precomputed transfer (Sloan, Kautz and Snyder 2002): what the vertices of a mesh make of the light around it, in SH."""

from skylight_sh.transfer.bounces import bounced, gather
from skylight_sh.transfer.precompute import Options, Transfer, open_transfer, precompute
from skylight_sh.transfer.rays import Rays
from skylight_sh.transfer.shadowed import shadowed, unshadowed

__all__ = ["Options", "Rays", "Transfer", "bounced", "gather", "open_transfer", "precompute", "shadowed", "unshadowed"]
