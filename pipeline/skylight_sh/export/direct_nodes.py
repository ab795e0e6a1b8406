"""How many nodes a sum over the sky itself needs for an error budget: the fewest samples of the sun-centred rule.

Rings stand in groups of ``SIDE``, as the evaluator sums them side by side; three of eight are circles about the sun, graded
less than the rule's own, which the Preetham sky at few nodes asks for.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.errors import e_means, l_min, mean_luminance, norms
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import parameter_points, sun_centred
from skylight_sh.quadrature.least_luminance import refine
from skylight_sh.quadrature.sun_centred import Nodes
from skylight_sh.reproducible import significant
from skylight_sh.sphere import Harmonics

Array = NDArray[np.float64]
Ranges = tuple[tuple[float, float], ...]

SIDE = 8
# What float32 adds, as a share of the norm of a set and channel: up to 1.2e-6 was measured.
ROUNDING = 1.5e-6

_MOST_RINGS, _LEAST_WAVES, _MOST_WAVES = 96, 4, 60
_CIRCLES, _POWER = 3 / 8, 2
# Nodes of what passes for the truth, whose error is a thousandth of the least that float32 holds.
_CONVERGED = 56
# The sets of a choice: a grid for the search, then held-out ones.
_GRID = (15, 5)
_HELD_OUT, _EDGE, _SEED = 192, 24, 1999
# Errors that decide are rounded to so many bits.
_BITS = 20


class _Truth:
    """Converged weights of parameter sets ``(n, axes)``, and what errors are shares of."""

    def __init__(self, light: Preetham, sets: Array, bands: int) -> None:
        self._light, self._sets, self._harmonics = light, sets, Harmonics.even(bands)
        self._blocks = parameter_points.chunks(sets, 0, 64)
        least, mean = np.empty(len(sets)), np.empty(len(sets))
        self._weights = np.empty((len(sets), len(light.channels), self._harmonics.count))
        for block in self._blocks:
            parameters = self._parameters(block)
            found = sun_centred.project(light, parameters, nodes=_CONVERGED + bands, harmonics=self._harmonics)
            flat = {name: values.ravel() for name, values in parameters.items()}
            darkest = refine(light, flat, found.least_direction.reshape(-1, 3), found.least.ravel())
            self._weights[block], least[block] = found.weights, darkest.reshape(block.shape)
        mean[:] = mean_luminance(self._weights[..., 0], light.luminance_row)
        self._l_min = next(iter(l_min(least, mean).values()))

    def _parameters(self, block: NDArray[np.int64]) -> dict[str, Array]:
        return {name: self._sets[block, axis] for axis, name in enumerate(self._light.domains)}

    def e_mean(self, nodes: Nodes) -> float:
        """Return the largest E_mean of the rule with these ``nodes`` in float32, rounded as what decides is."""
        off = np.empty_like(self._weights)
        for block in self._blocks:
            found = sun_centred.project(self._light, self._parameters(block), nodes=nodes, harmonics=self._harmonics)
            off[block] = found.weights - self._weights[block]
        noise = ROUNDING * norms(self._weights) / self._l_min[:, np.newaxis]
        return float(significant((e_means(off, self._l_min) + noise).max(), _BITS))


def nodes_of(rings: int, waves: int) -> Nodes:
    """Return the nodes for so many rings, a multiple of ``SIDE``, and so many waves.

    >>> nodes_of(32, 14)
    Nodes(circles=12, arcs=20, waves=14, power=2)
    """
    circles = round(_CIRCLES * rings)
    return Nodes(circles, rings - circles, waves, _POWER)


@lru_cache(maxsize=16)
def choose(light: Preetham, ranges: Ranges, bands: int, budget: float) -> tuple[Nodes, float]:
    """Return the nodes of the fewest samples whose E_mean stays within ``budget``, and that E_mean.

    ``ranges`` are those of the light's axes, the sun's zenith angle first. E_mean, in float32, is the largest over held-out
    sets with edges and corners, which the search has not seen. The number of waves grows for as long as they miss the
    budget. Raises ValueError for a budget that no number of nodes tried reaches.
    """
    search, held_out = _searched(light, ranges, bands), _held_out(light, ranges, bands)
    best: tuple[Nodes, float] | None = None
    most = _MOST_RINGS * _MOST_WAVES
    for rings in range(2 * SIDE, _MOST_RINGS + 1, SIDE):
        limit = min(_MOST_WAVES, (most - 1) // rings)
        # More waves than fewer samples allow would not help these rings.
        if limit < _LEAST_WAVES or search.e_mean(nodes_of(rings, limit)) > budget:
            continue
        for waves in range(_LEAST_WAVES, limit + 1):
            nodes = nodes_of(rings, waves)
            if search.e_mean(nodes) <= budget and (measured := held_out.e_mean(nodes)) <= budget:
                best, most = (nodes, measured), rings * waves
                break
    if best is None:
        raise ValueError(
            f"No number of nodes sums this sky to an E_mean of {budget:g} in float32. The least that one can ask for is "
            f"about {search.e_mean(nodes_of(_MOST_RINGS, _MOST_WAVES)):.2g}."
        )
    return best


@lru_cache(maxsize=16)
def e_mean(light: Preetham, ranges: Ranges, bands: int, nodes: Nodes) -> float:
    """Return the largest E_mean, in float32, of a sum with these ``nodes`` over held-out sets of the ``ranges``."""
    return _held_out(light, ranges, bands).e_mean(nodes)


@lru_cache(maxsize=4)
def _searched(light: Preetham, ranges: Ranges, bands: int) -> _Truth:
    """Return the truth on a grid that crowds at the ends of the ranges."""
    ends = [(1 - np.cos(np.linspace(0.0, np.pi, count))) / 2 for count in _GRID]
    lines = [low + (high - low) * at for (low, high), at in zip(ranges, ends, strict=True)]
    return _Truth(light, np.unique(parameter_points.grid(lines), axis=0), bands)


@lru_cache(maxsize=4)
def _held_out(light: Preetham, ranges: Ranges, bands: int) -> _Truth:
    return _Truth(light, parameter_points.held_out(ranges, _HELD_OUT, _EDGE, _SEED), bands)
