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

TENSOR = "tensor"
"""The solver of one small system an axis; the others, ``least_squares.SOLVERS``, solve one over all points of the grid."""


@dataclass(frozen=True)
class GridFit:
    """Coefficients ``dense`` ``(channels, count, d_1+1, .., d_D+1)`` of products of a ``basis`` over ``axes``.

    ``scale`` multiplies the polynomials; ``condition`` is the condition number of the whole system of equations.
    """

    dense: Array
    axes: tuple[Axis, ...]
    basis: str
    scale: Scale | None
    condition: float

    def products(self, sets: Array) -> Array:
        """Return all products of basis functions at parameter sets ``(n, axes)``: ``(n, terms)``."""
        degrees = [size - 1 for size in self.dense.shape[2:]]
        return np.asarray(tables.products(self.basis, self.axes, sets, degrees), dtype=np.float64)


def factor_at(scale: Scale | None, sets: Array) -> Array:
    """Return the factor at parameter sets ``(n, axes)`` in double precision, ``(n,)``; ones where there is none.

    >>> factor_at(None, np.zeros((2, 1))).tolist()
    [1.0, 1.0]
    """
    return np.asarray(prefactor.evaluate(scale, sets), dtype=np.float64)


def system(
    samples: Array, axes: Sequence[Axis], nodes: Sequence[Array], degrees: Sequence[int], basis: str, scale: Scale | None
) -> tuple[Array, list[Array]]:
    """Return the right side ``(n_1, .., n_D, outputs)`` and the basis ``(n_a, d_a+1)`` at each axis's ``nodes``.

    ``samples`` ``(n_1, .., n_D, channels, count)`` are divided by the factor.
    """
    shape = samples.shape[:-2]
    right = samples / factor_at(scale, parameter_points.grid(list(nodes))).reshape(*shape, 1, 1)
    vander = BASES[basis].vander
    matrices = [np.asarray(vander(a.scaled(n), d), dtype=np.float64) for a, n, d in zip(axes, nodes, degrees, strict=True)]
    return right.reshape(*shape, -1), matrices


def fit(
    samples: Array,
    axes: tuple[Axis, ...],
    nodes: Sequence[Array],
    degrees: Sequence[int],
    basis: str,
    solver: str,
    scale: Scale | None,
) -> GridFit:
    """Fit ``samples`` as ``system`` sets it up. Raises LinAlgError where the solver gives up, ValueError for another one.

    >>> axis = Axis("height", 0.0, 1.0)
    >>> nodes = [axis.fit_nodes(3, "chebyshev")]
    >>> samples = (1.0 + nodes[0])[:, np.newaxis, np.newaxis]
    >>> fit(samples, (axis,), nodes, (1,), "chebyshev", TENSOR, None).dense.round(12).tolist()
    [[[1.5, 0.5]]]
    """
    right, matrices = system(samples, axes, nodes, degrees, basis, scale)
    if solver == TENSOR:
        solution = least_squares.fit_tensor(right, matrices)
    else:
        solution = least_squares.fit_full(right, matrices, solver)
    dense = solution.reshape(*samples.shape[-2:], *solution.shape[1:])
    return GridFit(dense, axes, basis, scale, least_squares.condition(matrices))


def swept(made: GridFit, reference: Reference, degrees: Sequence[Sequence[int]], bands: int) -> Worst:
    """Measure every combination of ``degrees`` (a list an axis) for 1 to ``bands`` bands, truncations of the one fit."""
    vander = BASES[made.basis].vander
    vanders = [
        vander(axis.scaled(reference.parameters[:, i]), size - 1)
        for i, (axis, size) in enumerate(zip(made.axes, made.dense.shape[2:], strict=True))
    ]
    factor = factor_at(made.scale, reference.parameters)
    return sweep(made.dense, vanders, factor, reference, degrees, bands)
