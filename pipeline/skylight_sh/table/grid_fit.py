"""One fit of weights sampled on a grid, in the axes' own variables and over a factor, and its sweep over degrees."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit import least_squares
from skylight_sh.fit.axis import Axis
from skylight_sh.fit.errors import Reference
from skylight_sh.fit.sweep import Worst, sweep
from skylight_sh.formula.bases import BASES
from skylight_sh.quadrature import parameter_points
from skylight_sh.runtime import Scale
from skylight_sh.table import prefactor
from skylight_sh.table import table as tables

Array = NDArray[np.float64]
Index = NDArray[np.int64]

TENSOR = "tensor"
"""The solver of one small system an axis; the others, ``least_squares.SOLVERS``, solve one over all points of the grid."""


@dataclass(frozen=True)
class GridFit:
    """Coefficients ``dense`` ``(classes, count, d_1+1, .., d_D+1)`` of products of a ``basis`` over ``axes``.

    ``scale`` turns the polynomials into weights; with ``parity`` about the axis of that name, the powers ``orders``
    ``(count,)`` of its sine too. ``condition`` is the condition number of the whole system of equations.
    """

    dense: Array
    axes: tuple[Axis, ...]
    basis: str
    scale: Scale | None
    condition: float
    orders: Index
    parity: str = ""

    def products(self, sets: Array) -> Array:
        """Return all products of basis functions at parameter sets ``(n, axes)``: ``(n, terms)``."""
        degrees = [size - 1 for size in self.dense.shape[2:]]
        return np.asarray(tables.products(self.basis, self.axes, sets, degrees), dtype=np.float64)

    def weights(self, sets: Array, sums: Array, channels: int) -> Array:
        """Return the weights ``(n, channels, count)`` that ``sums`` ``(n, classes, count)`` make at ``sets``."""
        waves = self.waves(sets)[:, : sums.shape[2]]
        return np.asarray(factor_at(self.scale, sets, channels) @ sums * waves[:, np.newaxis])

    def waves(self, sets: Array) -> Array:
        """Return what each weight's polynomial is multiplied with beside the scale, ``(n, count)``: ones without parity."""
        return np.asarray(sines_at(self.axes, self.parity, sets)[:, np.newaxis] ** np.abs(self.orders))


def factor_at(scale: Scale | None, sets: Array, channels: int) -> Array:
    """Return what each channel takes of each class at parameter sets ``(n, axes)``: ``(n, channels, classes)``.

    In double precision; ones on the diagonal where there is no factor.

    >>> factor_at(None, np.zeros((1, 1)), 2).tolist()
    [[[1.0, 0.0], [0.0, 1.0]]]
    """
    found = np.asarray(prefactor.evaluate(scale, sets), dtype=np.float64)
    if found.shape[1] > 1:
        return found.reshape(len(sets), channels, -1)
    return np.asarray(found[:, :, np.newaxis] * np.eye(channels))


def sines_at(axes: Sequence[Axis], parity: str, sets: Array) -> Array:
    """Return the sine of the axis ``parity`` at parameter sets ``(n, axes)``, ``(n,)``; ones where that names none."""
    names = [axis.name for axis in axes]
    return np.sin(sets[:, names.index(parity)]) if parity else np.ones(len(sets))


def system(
    samples: Array, axes: Sequence[Axis], nodes: Sequence[Array], degrees: Sequence[int], basis: str, scale: Scale | None
) -> tuple[Array, list[Array]]:
    """Return the right side ``(n_1, .., n_D, outputs)`` and the basis ``(n_a, d_a+1)`` at each axis's ``nodes``.

    ``samples`` ``(n_1, .., n_D, channels, count)`` are divided by the factor: outputs are those of classes.
    """
    shape, channels = samples.shape[:-2], samples.shape[-2]
    factor = factor_at(scale, parameter_points.grid(list(nodes)), channels)
    flat = samples.reshape(len(factor), channels, -1)
    right = np.linalg.solve(factor, flat) if factor.shape[1] == factor.shape[2] else np.linalg.pinv(factor) @ flat
    vander = BASES[basis].vander
    matrices = [np.asarray(vander(a.scaled(n), d), dtype=np.float64) for a, n, d in zip(axes, nodes, degrees, strict=True)]
    return np.asarray(right, dtype=np.float64).reshape(*shape, -1), matrices


def fit(
    samples: Array,
    axes: tuple[Axis, ...],
    nodes: Sequence[Array],
    degrees: Sequence[int],
    basis: str,
    solver: str,
    scale: Scale | None,
    parity: str = "",
    orders: Index | None = None,
) -> GridFit:
    """Fit ``samples`` as ``system`` sets it up. Raises LinAlgError where the solver gives up, ValueError for another one.

    With ``parity`` about the axis of that name, polynomials of a weight of order m, of ``orders`` ``(count,)``, are fitted
    times sin^m of its value.

    >>> axis = Axis("height", 0.0, 1.0)
    >>> nodes = [axis.fit_nodes(3, "chebyshev")]
    >>> samples = (1.0 + nodes[0])[:, np.newaxis, np.newaxis]
    >>> fit(samples, (axis,), nodes, (1,), "chebyshev", TENSOR, None).dense.round(12).tolist()
    [[[1.5, 0.5]]]
    """
    right, matrices = system(samples, axes, nodes, degrees, basis, scale)
    count = samples.shape[-1]
    powers = np.abs(orders) if parity and orders is not None else np.zeros(count, dtype=np.int64)
    place = [axis.name for axis in axes].index(parity) if parity else 0
    split = right.reshape(*right.shape[:-1], -1, count)
    dense = np.empty((*split.shape[-2:], *(m.shape[1] for m in matrices)))
    for m in np.unique(powers).tolist():
        use = np.flatnonzero(powers == m)
        weighed = list(matrices)
        weighed[place] = np.sin(nodes[place])[:, np.newaxis] ** m * matrices[place] if m else matrices[place]
        part = split[..., use].reshape(*split.shape[:-2], -1)
        if solver == TENSOR:
            found = least_squares.fit_tensor(part, weighed)
        else:
            found = least_squares.fit_full(part, weighed, solver)
        dense[:, use] = found.reshape(split.shape[-2], use.size, *found.shape[1:])
    return GridFit(dense, axes, basis, scale, least_squares.condition(matrices), powers, parity)


def swept(made: GridFit, reference: Reference, degrees: Sequence[Sequence[int]], bands: int) -> Worst:
    """Measure every combination of ``degrees`` (a list an axis) for 1 to ``bands`` bands, truncations of the one fit."""
    vander = BASES[made.basis].vander
    vanders = [
        vander(axis.scaled(reference.parameters[:, i]), size - 1)
        for i, (axis, size) in enumerate(zip(made.axes, made.dense.shape[2:], strict=True))
    ]
    factor = factor_at(made.scale, reference.parameters, reference.weights.shape[1])
    return sweep(made.dense, vanders, factor, made.waves(reference.parameters), reference, degrees, bands)
