"""Least squares of sampled weights by products of one-variable polynomials, over any number of axes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.tensor_product import grid_products

Array = NDArray[np.float64]
Floats = NDArray[np.floating]


def fit_tensor(samples: Array, matrices: Sequence[Floats]) -> Array:
    """Fit samples on a tensor grid axis by axis.

    ``samples`` has shape ``(n_1, .., n_D, outputs)`` and ``matrices[a]``, the basis at axis a's nodes, ``(n_a,
    d_a+1)``. Returns ``(outputs, d_1+1, .., d_D+1)``. The pseudo-inverse of a Kronecker product is that of its
    factors, so this is the full least-squares solution at the cost of one small SVD an axis.

    >>> nodes = np.array([0.0, 1.0, 2.0])
    >>> fit_tensor((1.0 + 2.0 * nodes)[:, np.newaxis], [np.vander(nodes, 2, increasing=True)]).round(12).tolist()
    [[1.0, 2.0]]
    """
    out = samples
    for axis, matrix in enumerate(matrices):
        out = np.moveaxis(np.tensordot(np.linalg.pinv(matrix), out, axes=(1, axis)), 0, axis)
    return np.moveaxis(out, -1, 0)


def fit_full(samples: Array, matrices: Sequence[Floats], solver: str) -> Array:
    """Fit by one system over all grid points: what the paper's description amounts to. Shapes as ``fit_tensor``.

    Raises ValueError for a ``solver`` that is none of ``SOLVERS``.

    >>> nodes = np.array([0.0, 1.0, 2.0])
    >>> fit_full((1.0 + 2.0 * nodes)[:, np.newaxis], [np.vander(nodes, 2, increasing=True)], "qr").round(12).tolist()
    [[1.0, 2.0]]
    """
    if solver not in SOLVERS:
        raise ValueError(f"Unknown solver {solver!r}. Should be one of: {', '.join(SOLVERS)}.")
    system = grid_products(matrices)
    solution = SOLVERS[solver](system, samples.reshape(len(system), -1))
    return np.asarray(solution.T.reshape(-1, *(m.shape[1] for m in matrices)))


def condition(matrices: Sequence[Floats]) -> float:
    """Return the condition number of the whole least-squares system: the product of its factors'.

    >>> round(condition([np.diag([1.0, 4.0]), np.diag([1.0, 3.0])]), 9)
    12.0
    """
    return float(np.prod([np.linalg.cond(m) for m in matrices]))


def _svd(system: Floats, right: Array) -> Floats:
    """Drop directions lost in rounding."""
    return np.asarray(np.linalg.lstsq(system, right, rcond=None)[0])


def _qr(system: Floats, right: Array) -> Floats:
    """Triangularise the system itself."""
    q, r = np.linalg.qr(system)
    return np.asarray(np.linalg.solve(r, q.T @ right))


def _normal(system: Floats, right: Array) -> Floats:
    """Solve the normal equations by LU, rounding and all."""
    return np.asarray(np.linalg.solve(system.T @ system, system.T @ right))


# Each solves ``system`` ``(points, functions)`` for ``right`` ``(points, outputs)``: ``(functions, outputs)``.
SOLVERS: Mapping[str, Callable[[Floats, Array], Floats]] = {"svd": _svd, "qr": _qr, "normal": _normal}
