"""Every truth rule by name, and which one suits a light."""

from __future__ import annotations

from typing import TYPE_CHECKING

from skylight_sh.registry import Registry

if TYPE_CHECKING:
    from skylight_sh.light.protocol import Light
    from skylight_sh.quadrature.rule import Rule

# From this many bands on, rings cost less than nodes about the sun (`make bench` shows both).
_MANY_BANDS = 16

RULES: Registry[Rule] = Registry(
    {
        "sun-centred": "skylight_sh.quadrature.sun_centred:RULE",
        "rings": "skylight_sh.quadrature.rings:RULE",
        "zenith": "skylight_sh.quadrature.zenith_gauss:RULE",
        "stratified": "skylight_sh.quadrature.monte_carlo:RULE",
        "adaptive": "skylight_sh.quadrature.adaptive:RULE",
    }
)


def suited(light: Light, bands: int) -> str:
    """Return the name of the rule for a light's hints: one about its peak, rings for many bands, or the adaptive one.

    >>> from skylight_sh.light.preetham import Preetham
    >>> suited(Preetham(), 7), suited(Preetham(), 32)
    ('sun-centred', 'rings')
    """
    if light.hints.peak_axis is None and light.hints.peak_zenith is None:
        return "adaptive"
    return "sun-centred" if bands < _MANY_BANDS else "rings"
