"""Lights: parametric radiance on the upper hemisphere, one file a light, named here."""

from __future__ import annotations

from skylight_sh import MissingExtraError
from skylight_sh.light.cie_general import CieGeneral
from skylight_sh.light.cie_traditional import CieTraditional
from skylight_sh.light.mitsuba_sunsky import MitsubaSunsky
from skylight_sh.light.perez import Perez
from skylight_sh.light.plugin import Plugin
from skylight_sh.light.preetham import Preetham
from skylight_sh.light.protocol import Domain, Hints, Light, LightError, Prefactor
from skylight_sh.light.wrappers import BlackBox, Fixed, Luminance

# A light's dataclass fields are its options in a config's [light] section; ``model`` tells the lights apart.
LIGHTS = {
    "preetham": Preetham,
    "cie_general": CieGeneral,
    "cie_traditional": CieTraditional,
    "perez": Perez,
    "mitsuba_sunsky": MitsubaSunsky,
    "plugin": Plugin,
}
# Every prefactor a table may name.
PREFACTORS = {p.name: p for p in (Preetham().hints.prefactor, Perez(category=8).hints.prefactor) if p}

__all__ = [
    "LIGHTS",
    "PREFACTORS",
    "BlackBox",
    "CieGeneral",
    "CieTraditional",
    "Domain",
    "Fixed",
    "Hints",
    "Light",
    "LightError",
    "Luminance",
    "MissingExtraError",
    "MitsubaSunsky",
    "Perez",
    "Plugin",
    "Preetham",
    "Prefactor",
]
