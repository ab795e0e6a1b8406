"""Precomputed transfer (Sloan, Kautz and Snyder 2002): what the vertices of a mesh make of the light around it, in SH.

A name is looked up in the modules below when it is asked for, so that who names options loads no ray caster.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from skylight_sh.transfer.bounces import bounced, gather
    from skylight_sh.transfer.options import Options
    from skylight_sh.transfer.rays import Rays
    from skylight_sh.transfer.shadowing import shadowed, unshadowed
    from skylight_sh.transfer.whole import Transfer, open_transfer, precompute

__all__ = ["Options", "Rays", "Transfer", "bounced", "gather", "open_transfer", "precompute", "shadowed", "unshadowed"]

_PLACES = {
    "bounced": "skylight_sh.transfer.bounces",
    "gather": "skylight_sh.transfer.bounces",
    "Options": "skylight_sh.transfer.options",
    "Transfer": "skylight_sh.transfer.whole",
    "open_transfer": "skylight_sh.transfer.whole",
    "precompute": "skylight_sh.transfer.whole",
    "Rays": "skylight_sh.transfer.rays",
    "shadowed": "skylight_sh.transfer.shadowing",
    "unshadowed": "skylight_sh.transfer.shadowing",
}


def __getattr__(name: str) -> Any:
    if name not in _PLACES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_PLACES[name]), name)
