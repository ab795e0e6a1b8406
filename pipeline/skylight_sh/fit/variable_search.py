"""Changes of variable and a prefactor found from the samples, for a light that tells nothing about itself."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.axis import Axis
from skylight_sh.fit.least_squares import fit_tensor
from skylight_sh.fit.tensor_product import grid_products, products
from skylight_sh.formula.bases import BASES

Array = NDArray[np.float64]

_VANDER = BASES["chebyshev"].vander
# Distances of a singular point from the range, in ranges: nearer ones leave nothing of the range's other end.
_DISTANCES = np.geomspace(0.06, 6.0, 10)
_ITERATIONS = 5
# Degrees of the denominator, and by how much a fit's degrees fall short of what the budget asks without it.
_DENOMINATORS = (3, 5)
_SHORT = (0.3, 0.4, 0.5, 0.6, 0.7, 0.8)
# Pull towards a denominator that makes all sets equally bright, relative to the mean residual.
_PULLS = (1e-7, 1e-6, 1e-5)


@dataclass(frozen=True)
class Found:
    """Axes with their changes of variable; ``denominator`` ``(d_1+1, .., d_D+1)``, Chebyshev in those variables.

    The prefactor is the denominator's reciprocal.
    """

    axes: tuple[Axis, ...]
    denominator: Array


def search(
    axes: Sequence[Axis],
    nodes: Sequence[Array],
    samples: Array,
    least: Array,
    budget: float,
    *,
    free: Sequence[bool],
    factor: bool,
) -> Found:
    """Search maps and prefactor for samples ``(n_1, .., n_D, channels, count)`` over ``least`` ``(n_1, .., n_D)``.

    ``budget`` is the E_mean aimed at, ``free`` the axes whose map is searched, ``factor`` whether a denominator is (it is
    1 otherwise). Maps come first, an axis at a time, by how few bits the coefficients along that axis alone would take;
    then the denominator, by the bits of the whole fit; then both once more.
    """
    relative = samples / least[..., np.newaxis, np.newaxis]
    step = budget / np.sqrt(relative[..., 0, :].shape[-1] * relative.shape[-2])
    mapped = _mapped(axes, nodes, relative, step, free)
    one = np.ones([1] * len(axes))
    if not factor:
        return Found(mapped, one)
    denominator = _best_denominator(mapped, nodes, samples, least, budget, step)
    values = _evaluate(denominator, mapped, nodes)
    mapped = _mapped(mapped, nodes, samples * values[..., np.newaxis, np.newaxis], step / _spread(values * least), free)
    return Found(mapped, _best_denominator(mapped, nodes, samples, least, budget, step))


def _mapped(
    axes: Sequence[Axis], nodes: Sequence[Array], values: Array, step: float, free: Sequence[bool]
) -> tuple[Axis, ...]:
    return tuple(_best_map(axis, nodes, i, values, step) if free[i] else axis for i, axis in enumerate(axes))


def _evaluate(denominator: Array, axes: Sequence[Axis], nodes: Sequence[Array]) -> Array:
    """Return the denominator on the grid of ``nodes``, ``(n_1, .., n_D)``."""
    out = denominator
    for i, (axis, where) in enumerate(zip(axes, nodes, strict=True)):
        matrix = _VANDER(axis.scaled(where), denominator.shape[i] - 1)
        out = np.moveaxis(np.tensordot(matrix, out, axes=(1, i)), 0, i)
    return np.asarray(out)


def _best_map(axis: Axis, nodes: Sequence[Array], index: int, values: Array, step: float) -> Axis:
    lines = np.moveaxis(values, index, 0).reshape(nodes[index].size, -1)
    span = axis.high - axis.low
    points = [*(axis.low - d * span for d in _DISTANCES), *(axis.high + d * span for d in _DISTANCES)]
    tried = [replace(axis, map="identity", point=0.0)]
    tried += [replace(axis, map=kind, point=float(f"{point:.3g}")) for kind in ("log", "reciprocal") for point in points]
    return min(tried, key=lambda a: _line_bits(a, nodes[index], lines, step))


def _line_bits(axis: Axis, nodes: Array, lines: Array, step: float) -> float:
    matrix = _VANDER(axis.scaled(nodes), _degree(nodes.size))
    return _bits(np.linalg.pinv(matrix) @ lines, step)


def _bits(coefficients: Array, step: float) -> float:
    return float(np.log2(1.0 + np.abs(coefficients) / step).sum())


def _degree(nodes: int) -> int:
    # Beyond about a third of the nodes, a change of variable away from the nodes' own makes the fit ill-conditioned.
    return max(2, min(nodes - 1, nodes // 3 + 2))


def _best_denominator(
    axes: tuple[Axis, ...], nodes: Sequence[Array], samples: Array, least: Array, budget: float, step: float
) -> Array:
    shape = least.shape
    scaled_nodes = [a.scaled(n) for a, n in zip(axes, nodes, strict=True)]
    degrees = [_degree(n.size) for n in nodes]
    matrices = [np.asarray(_VANDER(u, d), dtype=np.float64) for u, d in zip(scaled_nodes, degrees, strict=True)]
    relative = samples / least[..., np.newaxis, np.newaxis]
    needed = [_needed(m, relative, i, budget) for i, m in enumerate(matrices)]
    # The lowest degrees l carry the light's brightness; they tell the denominator.
    few = samples[..., : min(samples.shape[-1], 6)].reshape(least.size, -1)
    options = []
    for degree, short, pull in itertools.product(_DENOMINATORS, _SHORT, _PULLS):
        high = grid_products([m[:, : max(2, int(np.ceil(n * short)))] for m, n in zip(matrices, needed, strict=True)])
        low = [np.asarray(_VANDER(u, degree), dtype=np.float64) for u in scaled_nodes]
        found = _denominator(grid_products(low), high, few, least.ravel(), pull)
        if found is not None:
            options.append(found.reshape([degree + 1] * len(axes)))
    options.append(np.ones([1] * len(axes)))

    def bits(option: Array) -> float:
        values = _evaluate(option, axes, nodes)
        scaled = (samples * values[..., np.newaxis, np.newaxis]).reshape(*shape, -1)
        return _bits(fit_tensor(scaled, matrices), step / _spread(values * least)) + 32 * option.size

    return min(options, key=bits)


def _denominator(low: Array, high: Array, samples: Array, least: Array, pull: float) -> Array | None:
    """Return the coefficients of q with q * samples nearest to polynomials ``high``, errors over q and least; or None.

    Linearised as Sanathanan and Koerner do: the division by q uses the one found before. ``pull`` keeps q * least near
    its mean, for what q cannot change it must not make worse.
    """
    q = 1.0 / least
    q /= q.mean()
    coefficients = np.linalg.lstsq(low, q, rcond=None)[0]
    q = low @ coefficients
    if q.min() <= 0.0:
        coefficients, q = np.eye(low.shape[1])[0], np.ones(len(low))
    for _ in range(_ITERATIONS):
        weight = 1.0 / (q * least)
        orthonormal, _ = np.linalg.qr(high * weight[:, np.newaxis])
        columns = products([samples * weight[:, np.newaxis], low])
        columns = columns - orthonormal @ (orthonormal.T @ columns)
        rows = columns.reshape(-1, low.shape[1])
        normal = rows.T @ rows
        level = float(np.sum((samples * weight[:, np.newaxis]) ** 2)) / len(low)
        even = low * least[:, np.newaxis] / (q * least).mean()
        normal += pull * level * even.T @ even
        right = pull * level * even.sum(axis=0)
        solved = np.linalg.lstsq(normal, right, rcond=1e-15)[0]
        fresh = low @ solved
        share = 1.0
        while (q + share * (fresh - q)).min() <= 0.02 * q.min():
            share *= 0.7
            if share < 0.01:
                return None
        coefficients = coefficients + share * (solved - coefficients)
        coefficients /= float(np.mean(low @ coefficients))
        q = low @ coefficients
    return np.asarray(coefficients)


def _needed(matrix: Array, relative: Array, index: int, budget: float) -> int:
    lines = np.linalg.pinv(matrix) @ np.moveaxis(relative, index, 0).reshape(len(matrix), -1)
    above = np.flatnonzero(np.abs(lines).max(axis=1) > budget)
    return int(above.max(initial=1)) + 1


def _spread(brightness: Array) -> float:
    """Return by how much a rounding error grows, root mean square: 1 / (q * least), with its own scale."""
    return float(np.sqrt(np.mean(1.0 / brightness**2)))
