"""One fit of the samples in a basis, by a solver, in plain or the config's own variables: what the stresses vary."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain, repeat

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit import least_squares
from skylight_sh.fit.axis import Axis
from skylight_sh.formula.bases import BASES
from skylight_sh.quadrature import parameter_points
from skylight_sh.runtime import Scale, Table
from skylight_sh.studies.grid_samples import Samples
from skylight_sh.table import prefactor
from skylight_sh.table import table as tables
from skylight_sh.table.table import specification, whole

Array = NDArray[np.float64]
OWN = "config"


@dataclass(frozen=True)
class Trial:
    """A fit: ``dense`` ``(channels, count, d_1+1, ..)``, its axes, factor and the system's condition number."""

    dense: Array
    axes: tuple[Axis, ...]
    basis: str
    factor: Scale | None
    condition: float

    def products(self, where: Array) -> Array:
        """Return all products of basis functions at parameter sets ``(n, axes)``: ``(n, terms)``."""
        degrees = [size - 1 for size in self.dense.shape[2:]]
        return np.asarray(tables.products(self.basis, self.axes, where, degrees), dtype=np.float64)


def paper_degrees(samples: Samples) -> list[int]:
    """Return the paper's degrees (13, 7), or as many as the config sweeps, 3 for further axes."""
    return [min(d, axis.degrees[1]) for d, axis in zip(chain((13, 7), repeat(3)), samples.config.axes, strict=False)]


def factor_of(samples: Samples, kind: str, where: Array) -> Array:
    """Return what the weights at ``where`` ``(n, axes)`` are divided by, ``(n,)``."""
    return np.asarray(prefactor.evaluate(samples.spec.scale if kind == OWN else None, where), dtype=np.float64)


def system(
    samples: Samples, values: Array, degrees: Sequence[int], basis: str, kind: str
) -> tuple[Array, list[Array], tuple[Axis, ...]]:
    """Return the right side ``(n_1, .., n_D, outputs)``, the basis at each axis's nodes, and the axes of one fit.

    ``values`` has the shape of ``samples.half``; ``kind`` is a change of variable for every axis, or ``config`` for the
    config's own and its prefactor.
    """
    config = samples.config
    axes = samples.axes if kind == OWN else tuple(Axis(a.name, *a.range, map=kind) for a in config.axes)
    shape = values.shape[:-2]
    grid = parameter_points.grid(samples.nodes)
    right = values / factor_of(samples, kind, grid).reshape(*shape, 1, 1)
    vander = BASES[basis].vander
    matrices = [
        np.asarray(vander(a.scaled(n), d), dtype=np.float64) for a, n, d in zip(axes, samples.nodes, degrees, strict=True)
    ]
    return right.reshape(*shape, -1), matrices, axes


def fit(samples: Samples, values: Array, degrees: Sequence[int], basis: str, solver: str, kind: str) -> Trial:
    """Fit ``values`` as ``system`` sets it up. Raises LinAlgError where the solver gives up."""
    right, matrices, axes = system(samples, values, degrees, basis, kind)
    solution = least_squares.fit_full(right, matrices, solver)
    return Trial(
        dense=solution.reshape(*values.shape[-2:], *solution.shape[1:]),
        axes=axes,
        basis=basis,
        factor=samples.spec.scale if kind == OWN else None,
        condition=least_squares.condition(matrices),
    )


def table_of(samples: Samples, made: Trial, dtype: str) -> Table:
    """Return a trial as a table of all its coefficients in ``dtype``."""
    spec = specification(made.axes, samples.spec.channels, True, made.basis, made.factor)
    return whole(spec, made.dense, samples.config.truth.bands, dtype)
