"""Adaptive quadrature of SH weights for a light that tells nothing: sampled until the result converges.

Cells of zenith angle and azimuth cover the upper hemisphere. A cell's rule is compared with the sum over its four
quarters, and cells whose difference the tolerance does not allow are replaced by their quarters. The result is the sum
of the cells' own rules, not the better one of their quarters: so every difference is a measured error of what is
returned, and no model of one. The sum of the differences is the error itself but for the quarters' errors, which a
second rule on the quarters measures: at a cusp a cell's own error may be small by luck, and theirs are then what counts.
Neighbours differ by one halving at most, lest an edge pass unseen between the nodes of a large cell beside small ones.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.light.protocol import Light, Parameters
from skylight_sh.quadrature.rule import Rule
from skylight_sh.quadrature.samples import NotConvergedError, Samples, keep_least

Array = NDArray[np.float64]
Cells = NDArray[np.int64]

# Gauss nodes of a cell in each direction, of the second rule, and first cells over the zenith angle and half a turn.
_NODES = 6
_SECOND = 5
_FIRST = (3, 4)
# What sums of samples lose to float64 whatever the cells, relative to the largest weight.
_ROUNDING = 2e-14
# The most halvings (a place must fit its key) and cells of a set.
_DEEPEST = 24
_MOST_CELLS = 20_000
# Floats held for the cells' differences (128 MB) and for the samples taken at once (64 MB), of these for one sample.
_FLOATS = 16_000_000
_BATCH = 8_000_000
_HELD = 40


@dataclass(frozen=True)
class _Integrand:
    """One parameter set's integrand, and the running least luminance ``(1,)`` with its direction ``(1, 3)``."""

    light: Light
    parameters: Parameters
    harmonics: sphere.Harmonics
    least: Array
    least_direction: Array


def project(light: Light, parameters: Parameters, *, tolerance: float, harmonics: sphere.Harmonics) -> Samples:
    """Integrate radiance times ``y_lm`` over the upper hemisphere to ``tolerance``, with no hint but the symmetry.

    Every parameter has shape ``(g, k)`` or broadcasts to it. ``tolerance`` is relative to the largest weight of each
    set and channel, and ``estimate`` of the result is the error measured. Where the ``harmonics`` are those even in y
    alone, half the azimuths are sampled. A feature that lies wholly between the nodes of the first mesh, some 0.1 rad
    apart with a cell's quarters, is not seen. Raises NotConvergedError where a set needs more cells than fit;
    ``integrate`` returns what it reached.

    The zonal weights of an overcast sky, (1 + 2 z) / 3:

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> sky, at = CieTraditional(sky="overcast"), {"sun_zenith": np.array([[0.4]])}
    >>> project(sky, at, tolerance=1e-6, harmonics=sphere.Harmonics.even(2)).weights[0, 0, 0, :2].round(4).tolist()
    [1.1816, 1.1939]
    """
    samples = integrate(light, parameters, tolerance=tolerance, harmonics=harmonics)
    worst = float(samples.estimate.max())
    if not worst <= tolerance:
        raise NotConvergedError(
            f"The adaptive truth did not converge: its error is still {worst:.2g} of the largest weight, but "
            f"truth.tolerance is {tolerance:.2g}. Raise truth.tolerance, lower truth.bands or narrow the axes' ranges."
        )
    return samples


def integrate(light: Light, parameters: Parameters, *, tolerance: float, harmonics: sphere.Harmonics) -> Samples:
    """Like ``project``, but a set that does not converge keeps its ``estimate`` above ``tolerance``.

    The zonal weights of an overcast sky, (1 + 2 z) / 3:

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> sky, at = CieTraditional(sky="overcast"), {"sun_zenith": np.array([[0.4]])}
    >>> bool(integrate(sky, at, tolerance=1e-6, harmonics=sphere.Harmonics.even(2)).estimate[0, 0] < 1e-6)
    True
    """
    sets = np.broadcast_shapes(*(values.shape for values in parameters.values()))
    spread = {name: np.broadcast_to(values, sets) for name, values in parameters.items()}
    samples = Samples(
        np.empty((*sets, len(light.channels), harmonics.count)), np.full(sets, np.inf), np.zeros((*sets, 3)), np.empty(sets)
    )
    for at in np.ndindex(*sets):
        one = {name: np.full((1, 1, 1), values[at]) for name, values in spread.items()}
        integrand = _Integrand(light, one, harmonics, np.full(1, np.inf), np.zeros((1, 3)))
        samples.weights[at], samples.estimate[at] = _refine(integrand, tolerance)
        samples.least[at], samples.least_direction[at] = integrand.least[0], integrand.least_direction[0]
    return samples


def _refine(integrand: _Integrand, tolerance: float) -> tuple[Array, float]:
    """Return one set's weights ``(channels, count)`` and their estimated relative error."""
    cells = _first_mesh(len(integrand.harmonics.sides))
    total, differences, doubts = _measure(integrand, cells)
    most = min(_MOST_CELLS, _FLOATS // (2 * total.size))
    while True:
        scale = np.maximum(np.abs(total).max(axis=-1, keepdims=True), np.finfo(np.float64).tiny)
        error, spread, doubt = (
            np.abs(differences.sum(axis=0)) / scale,
            np.sqrt(np.square(differences).sum(axis=0)) / scale,
            np.sqrt(np.square(doubts).sum(axis=0)) / scale,
        )
        estimate = float((error + doubt).max()) + _ROUNDING
        # Errors of opposite signs may cancel by chance: the estimate believes it, the decision to stop does not.
        worst = max(estimate, float(spread.max()))
        if worst <= tolerance or not np.isfinite(worst):
            return total, estimate
        size = (np.maximum(np.abs(differences), np.abs(doubts)) / scale).max(axis=(1, 2))
        split = _to_split(size, worst / tolerance)
        split = _balanced(cells, split, turn=2 * _FIRST[1] if len(integrand.harmonics.sides) == 2 else 0)
        if len(cells) + 3 * np.count_nonzero(split) > most or cells[split, 0].max() >= _DEEPEST:
            return total, worst
        quarters = _quarters(cells[split])
        _, finer, finer_doubts = _measure(integrand, quarters)
        total = total + differences[split].sum(axis=0)
        cells = np.concatenate([cells[~split], quarters])
        differences = np.concatenate([differences[~split], finer])
        doubts = np.concatenate([doubts[~split], finer_doubts])


def _to_split(size: Array, excess: float) -> NDArray[np.bool_]:
    """Mark all cells but the smallest ones, whose root sum of squares is below half the whole's over ``excess``.

    ``excess`` is the error over the tolerance, so that the cells left alone could stay for good. It counts errors of one
    sign as well: where many small ones add up, a root sum of squares alone would find nothing to split.
    """
    order = np.argsort(size)
    below = np.sqrt(np.cumsum(np.square(size[order])))
    split = np.empty(size.size, dtype=np.bool_)
    split[order] = below > 0.5 * below[-1] / excess
    return split


def _measure(integrand: _Integrand, cells: Cells) -> tuple[Array, Array, Array]:
    """Return the sum of the cells' rules ``(channels, count)`` and what each lacks ``(cells, channels, count)``.

    First its quarters' sum minus itself, then the difference between two rules on its quarters.
    """
    weights = (len(integrand.light.channels), integrand.harmonics.count)
    step = max(1, _BATCH // (5 * _NODES * (_NODES * _HELD + 2 * weights[0] * weights[1])))
    total, differences, doubts = np.zeros(weights), np.empty((len(cells), *weights)), np.empty((len(cells), *weights))
    for start in range(0, len(cells), step):
        some = cells[start : start + step]
        quarters = _quarters(some)
        values = _integrals(integrand, np.concatenate([some, quarters]), _NODES).reshape(5, len(some), *weights)
        others = _integrals(integrand, quarters, _SECOND).reshape(4, len(some), *weights)
        finer = values[1:].sum(axis=0)
        total += values[0].sum(axis=0)
        differences[start : start + step] = finer - values[0]
        doubts[start : start + step] = finer - others.sum(axis=0)
    return total, differences, doubts


def _integrals(integrand: _Integrand, cells: Cells, nodes: int) -> Array:
    """Return the Gauss rule of every cell, ``(cells, channels, count)``."""
    light = integrand.light
    x, w = sphere.gauss_unit(nodes)
    halved = 0.5 ** cells[:, :1]
    width, turn = np.pi / 2 / _FIRST[0] * halved, np.pi / _FIRST[1] * halved
    zenith, azimuth = (cells[:, 1:2] + x) * width, (cells[:, 2:] + x) * turn
    width, turn = width * w, turn * w
    flat, up = np.sin(zenith), np.maximum(np.cos(zenith), 0.0)
    directions = np.empty((*zenith.shape, nodes, 3))
    directions[..., 0] = flat[:, :, np.newaxis] * np.cos(azimuth)[:, np.newaxis]
    directions[..., 1] = flat[:, :, np.newaxis] * np.sin(azimuth)[:, np.newaxis]
    directions[..., 2] = up[:, :, np.newaxis]
    radiance = np.broadcast_to(
        light.radiance(directions, integrand.parameters), (*directions.shape[:-1], len(light.channels))
    )
    luminance = (radiance @ light.luminance_row).reshape(1, -1)
    keep_least(luminance, directions.reshape(-1, 3), integrand.least, integrand.least_direction)

    held = integrand.harmonics
    m = np.arange(held.orders.min(), held.bands)
    angle = azimuth[..., np.newaxis] * np.abs(m)
    waves = np.where(m < 0, np.sin(angle), np.cos(angle)) * turn[..., np.newaxis]
    rings = (width * flat * (2.0 / len(held.sides)))[:, :, np.newaxis, np.newaxis]
    sums = (radiance * rings).swapaxes(2, 3).reshape(len(cells), -1, nodes) @ waves
    factors = sphere.legendre(up, flat, held.bands)[held.triangle]
    sums = sums.reshape(len(cells), nodes, len(light.channels), m.size)[..., held.orders - m[0]]
    return np.asarray(np.einsum("bicw,wbi->bcw", sums, factors))


def _first_mesh(sides: int) -> Cells:
    """Cells ``(cells, 3)``: how often halved, and their place in steps of their own size: zenith angle, azimuth.

    They cover the azimuths from 0 to pi, or on both ``sides`` of the peak all of them.
    """
    rows, columns = _FIRST[0], _FIRST[1] * sides
    zenith, azimuth = np.divmod(np.arange(rows * columns), columns)
    return np.stack([np.zeros_like(zenith), zenith, azimuth], axis=-1)


def _quarters(cells: Cells) -> Cells:
    """All first quarters, then all second ones, and so on: ``(4 * cells, 3)``."""
    halves = cells * np.array([1, 2, 2])
    return np.concatenate([halves + np.array([1, i, j]) for i in (0, 1) for j in (0, 1)])


def _balanced(cells: Cells, split: NDArray[np.bool_], turn: int) -> NDArray[np.bool_]:
    """Return ``split`` and with it every cell larger than a neighbour to be split.

    ``turn`` is the number of first cells around the whole circle, or 0 where azimuths end at a mirror.
    """
    split = split.copy()
    keys = _keys(cells)
    fresh = split
    while fresh.any():
        level, zenith, azimuth = cells[fresh].T
        beside = [(level, zenith + i, azimuth + j) for i in (-1, 0, 1) for j in (-1, 0, 1) if i or j]
        level, zenith, azimuth = (np.concatenate(column) for column in zip(*beside, strict=True))
        if turn:
            azimuth %= turn << level
        larger = np.zeros_like(split)
        for up in range(1, int(level.max()) + 1):
            deep = level >= up
            parents = np.stack([level[deep] - up, zenith[deep] >> up, azimuth[deep] >> up], axis=-1)
            larger |= np.isin(keys, _keys(parents))
        fresh = larger & ~split
        split |= fresh
    return split


def _keys(cells: Cells) -> Cells:
    """One number a cell; places outside the hemisphere get numbers that no cell has."""
    # 28 bits hold a place after 24 halvings, finer than a tolerance in float64 can ask for.
    return (cells[:, 0] << 57) + (cells[:, 1] << 28) + cells[:, 2]


RULE = Rule("adaptive cells", project, None)
