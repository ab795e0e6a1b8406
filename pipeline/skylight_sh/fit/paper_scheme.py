"""The scheme of Habel et al. 2008: stratified samples, and monomials of the raw parameters by one least-squares system.

Here for comparison: how far undersampling and the solver's rounding may explain the error that the paper tells.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import chain, repeat

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit import least_squares
from skylight_sh.fit.errors import Reference, e_mean
from skylight_sh.fit.tensor_product import products
from skylight_sh.formula.bases import BASES
from skylight_sh.light.protocol import Light
from skylight_sh.quadrature import direction_sums, monte_carlo, parameter_points
from skylight_sh.sphere import Harmonics

Array = NDArray[np.float64]
Floats = NDArray[np.floating]

BANDS = 7
_DEGREES = (13, 7)
_FURTHER = 3


def degrees_within(most: Sequence[int]) -> list[int]:
    """Return the paper's degrees (13, 7), 3 for each further axis, an axis at most ``most``.

    >>> degrees_within([20, 5, 9])
    [13, 5, 3]
    """
    return [min(degree, largest) for degree, largest in zip(chain(_DEGREES, repeat(_FURTHER)), most, strict=False)]


def stratified_weights(light: Light, names: Sequence[str], sets: Array, side: int, bands: int, seed: int) -> Array:
    """Return the stratified Monte Carlo weights of ``sets`` ``(n, axes)``, ``(n, channels, N*N)``; all share directions.

    One direction falls into each of ``side`` x ``side`` cells of equal area (Green 2003); ``names`` are the axes'.
    """
    directions, solid = monte_carlo.directions(side, 7919 * side + seed)
    table = direction_sums.tabulate(directions, solid, bands)
    named = {name: sets[:, i, np.newaxis] for i, name in enumerate(names)}
    return np.asarray(light.radiance(directions, named).swapaxes(1, 2) @ table)


@dataclass(frozen=True)
class Scheme:
    """The scheme on a grid: ``nodes`` and degrees an axis, ``bands``, and what its error is measured against.

    ``exact`` ``(n, channels, N*N)`` and ``least`` ``(n,)`` are the converged weights and L_min on the grid.
    """

    nodes: Sequence[Array]
    degrees: Sequence[int]
    bands: int
    exact: Array
    least: Array
    reference: Reference

    def fit(self, values: Array, solver: str) -> Array:
        """Fit ``values`` ``(n, channels, N*N)`` on the grid: coefficients ``(channels, N*N, terms)``."""
        vander = BASES["monomial"].vander
        matrices = [np.asarray(vander(n, d), dtype=np.float64) for n, d in zip(self.nodes, self.degrees, strict=True)]
        shape = tuple(len(m) for m in matrices)
        solution = least_squares.fit_full(values.reshape(*shape, -1), matrices, solver)
        return np.asarray(solution.reshape(*values.shape[1:], -1))

    def evaluate(self, made: Floats, sets: Array) -> Array:
        """Evaluate coefficients at ``sets`` ``(n, axes)`` in their own number type: ``(n, channels, N*N)``."""
        values = sets.astype(made.dtype)
        vander = BASES["monomial"].vander
        product = products([vander(values[:, i], degree) for i, degree in enumerate(self.degrees)])
        out = product @ made.reshape(-1, made.shape[-1]).T
        return np.asarray(out.reshape(len(sets), *made.shape[:2]), dtype=np.float64)

    def error(self, made: Floats) -> float:
        """Return the largest E_mean of coefficients over the sets of the reference."""
        truth = self.reference.weights[..., self.reference.first_bands(self.bands)]
        if truth.shape[-1] != self.bands * self.bands:
            truth = np.asarray(Harmonics.even(self.bands).unmirror(truth))
        return e_mean(self.evaluate(made, self.reference.parameters) - truth, self.reference.headline)

    def undersampling(self, sampled: Array) -> Mapping[str, float]:
        """Say what samples ``(n, channels, N*N)`` on the grid lead to, in fractions.

        ``m_below_0`` is the share of the norm in orders that symmetry makes zero, ``rel_l2`` the samples' own error, medians
        over the sets; ``own`` is the fit's distance (E_mean) from its samples, all that its authors could see, and ``truth``
        that from the truth, which they could not.
        """
        made = self.fit(sampled, "svd")
        fitted = self.evaluate(made, parameter_points.grid(list(self.nodes)))
        norms = np.sqrt((sampled**2).sum(axis=(1, 2)))
        below = np.sqrt((sampled[..., Harmonics(self.bands).orders < 0] ** 2).sum(axis=(1, 2)))
        off = np.sqrt(((sampled - self.exact) ** 2).sum(axis=(1, 2)))
        return {
            "m_below_0": float(np.median(below / norms)),
            "rel_l2": float(np.median(off / norms)),
            "own": e_mean(fitted - sampled, self.least),
            "truth": self.error(made),
        }

    def rounding(self, solver: str) -> tuple[float, float]:
        """Return the error of converged weights fitted by ``solver``, in double and in single precision."""
        made = self.fit(self.exact, solver)
        return self.error(made), self.error(made.astype(np.float32))
