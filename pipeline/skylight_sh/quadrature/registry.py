"""Every truth rule by name, and which one suits a light."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from skylight_sh.light.protocol import Light
from skylight_sh.quadrature import adaptive, fixed, rings, sun_centred
from skylight_sh.quadrature.samples import Samples

# From this many bands on, rings cost less than nodes about the sun (`make bench` shows both).
_MANY_BANDS = 16


@dataclass(frozen=True)
class Rule:
    """A way to integrate.

    ``project(light, parameters, *, nodes | tolerance, bands, mirrored)`` returns ``Samples``. A rule with fixed nodes
    has ``ladder(bands)``, the numbers of nodes to try in turn until two runs agree; an adaptive one has none, and is
    told the tolerance itself.
    """

    title: str
    project: Callable[..., Samples]
    ladder: Callable[[int], tuple[int, ...]] | None


def _steps(*nodes: int, least: Callable[[int], int] = lambda _: 0) -> Callable[[int], tuple[int, ...]]:
    return lambda bands: tuple(n for n in nodes if n >= least(bands))


_FINE = (24, 32, 40, 48, 56, 64, 72, 88, 104, 128, 160, 200, 256)
RULES = {
    "sun-centred": Rule("sun-centred Gauss", sun_centred.project, _steps(*_FINE, least=lambda bands: bands + 12)),
    "rings": Rule("graded rings about the zenith", rings.project, _steps(*_FINE, least=lambda bands: bands + 8)),
    "zenith": Rule("Gauss about the zenith", fixed.project_zenith, _steps(16, 32, 64, 128, 256, 512, 1024)),
    "stratified": Rule("stratified Monte Carlo", fixed.project_stratified, _steps(32, 64, 128, 256, 512, 1024, 2048)),
    "adaptive": Rule("adaptive cells", adaptive.project, None),
}


def suited(light: Light, bands: int) -> str:
    """Return the name of the rule for a light's hints: one about its peak, rings for many bands, or the adaptive one."""
    if light.hints.peak_axis is None and light.hints.peak_zenith is None:
        return "adaptive"
    return "sun-centred" if bands < _MANY_BANDS else "rings"
