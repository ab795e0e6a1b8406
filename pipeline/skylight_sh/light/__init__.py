"""Lights: parametric radiance on the upper hemisphere, one file a light, named here."""

from __future__ import annotations

from skylight_sh import MissingExtraError
from skylight_sh.light.protocol import Domain, Hints, Light, LightError, OptionsOfLight, Prefactor
from skylight_sh.light.wrappers import BlackBox, Fixed, Luminance
from skylight_sh.registry import Registry

# A light's dataclass fields are its options in a config's [light] section; its field ``model`` is its name here.
LIGHTS: Registry[type[OptionsOfLight]] = Registry(
    {
        "preetham": "skylight_sh.light.preetham:Preetham",
        "cie_general": "skylight_sh.light.cie_general:CieGeneral",
        "cie_traditional": "skylight_sh.light.cie_traditional:CieTraditional",
        "perez": "skylight_sh.light.perez:Perez",
        "mitsuba_sunsky": "skylight_sh.light.mitsuba_sunsky:MitsubaSunsky",
        "plugin": "skylight_sh.light.plugin:Plugin",
    }
)

__all__ = [
    "LIGHTS",
    "BlackBox",
    "Domain",
    "Fixed",
    "Hints",
    "Light",
    "LightError",
    "Luminance",
    "MissingExtraError",
    "OptionsOfLight",
    "Prefactor",
]
