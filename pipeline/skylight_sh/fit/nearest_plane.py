"""Rounding to whole steps in a metric: each rounding error is passed on to the coefficients not yet rounded."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.minimax import Metric, System
from skylight_sh.reproducible import significant

Array = NDArray[np.float64]
Index = NDArray[np.int64]

# A value within this share of a step becomes 0: a zero is the cheapest number, and its neighbours take up the rest.
_DEAD = 0.6


def lengths_above(coefficients: Array, threshold: float) -> Index:
    """Return ``(classes, count, rest)``: how many of the first axis' terms to keep of ``(.., .., first, rest)``.

    >>> lengths_above(np.array([9.0, 0.1, 3.0, 0.2]).reshape(1, 1, 4, 1), 1.0).tolist()
    [[[3]]]
    """
    kept = np.abs(coefficients) > threshold
    last = coefficients.shape[2] - np.argmax(kept[:, :, ::-1], axis=2)
    return np.where(kept.any(axis=2), last, 0)


def round_kept(metric: Metric, lengths: Index, first: int, step: float) -> Index:
    """Return whole numbers ``(classes, count, first, rest)`` near the best ones in the metric, 0 beyond ``lengths``.

    The kept coefficients are solved for anew without the others, then rounded one by one, each after the errors of
    those before it (Babai's nearest plane): first those that weigh most in the metric, so that those whose own
    rounding costs least take up what is left. Plain rounding needs a step about 1.5 times finer for the same error.

    >>> gram, right = np.array([[2.0, 1.0], [1.0, 2.0]]), np.array([[4.2, 4.2]])  # the best: 1.4 and 1.4
    >>> metric = Metric((System(np.array([0]), np.array([0, 0]), np.arange(2), gram, right),), (1, 1, 2))
    >>> round_kept(metric, np.full((1, 1, 1), 2), 2, 1.0).ravel().tolist()
    [2, 1]
    """
    classes, count, rest = lengths.shape
    keep = (np.arange(first)[:, np.newaxis] < lengths[:, :, np.newaxis, :]).reshape(classes, count, -1)
    out = np.zeros((classes, count, first * rest), dtype=np.int64)
    rows = [row for system in metric.systems for row in _rows(system, keep)]
    size = max((len(row.target) for row in rows), default=0)
    unit, target = np.zeros((len(rows), size, size)), np.zeros((len(rows), size))
    for w, row in enumerate(rows):
        # Shorter ones stand at the end, from where rounding begins.
        start = size - len(row.target)
        unit[w, start:, start:], target[w, start:] = row.unit, row.target / step
    for row, rounded in zip(rows, _nearest_plane(unit, target), strict=True):
        out[row.classes, row.output, row.terms] = rounded[size - len(row.target) :]
    return out.reshape(classes, count, first, rest)


class _Row(NamedTuple):
    """One weight's u coefficients: a triangle with a diagonal of 1 that, times the best ones, gives ``target``."""

    output: int
    classes: Index
    terms: Index
    unit: Array
    target: Array


def _rows(system: System, keep: NDArray[np.bool_]) -> Iterator[_Row]:
    """Yield the weights of a system, of the coefficients ``keep`` ``(classes, count, terms)``."""
    from scipy import linalg

    # Terms that weigh the same must rank the same on every machine.
    ranked = np.argsort(significant(np.diag(system.gram), 20), kind="stable")
    for w, output in enumerate(system.outputs.tolist()):
        use = ranked[keep[system.classes[ranked], output, system.terms[ranked]]]
        if use.size:
            factor = np.linalg.cholesky(system.gram[use[:, np.newaxis], use])
            # Its transpose times the solution, of which each row names one coefficient given all later ones.
            found = linalg.solve_triangular(factor, system.right[w, use], lower=True, check_finite=False)
            diagonal = np.diag(factor)
            yield _Row(output, system.classes[use], system.terms[use], factor.T / diagonal[:, np.newaxis], found / diagonal)


def _nearest_plane(unit: Array, target: Array) -> Index:
    """Round ``target`` ``(outputs, size)`` from its end, by triangles ``(outputs, size, size)`` with a diagonal of 1."""
    rounded = np.zeros(target.shape)
    for i in range(target.shape[1] - 1, -1, -1):
        value = target[:, i] - np.einsum("wj,wj->w", unit[:, i, i + 1 :], rounded[:, i + 1 :])
        rounded[:, i] = np.where(np.abs(value) < _DEAD, 0.0, np.rint(value))
    return rounded.astype(np.int64)
