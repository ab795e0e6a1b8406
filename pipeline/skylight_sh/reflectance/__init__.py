"""How surfaces reflect: glossy lobes, microfacet models and measured tables, in SH."""

from __future__ import annotations

from typing import Any

from skylight_sh.registry import Registry

MODELS: Registry[Any] = Registry(
    {
        "lambert": "skylight_sh.reflectance.models.lambert:Lambert",
        "oren-nayar": "skylight_sh.reflectance.models.oren_nayar:OrenNayar",
        "ggx": "skylight_sh.reflectance.models.ggx:Ggx",
    }
)
"""Dataclasses that keep to ``reflectance/models/protocol.py``; their fields are a surface's numbers."""
