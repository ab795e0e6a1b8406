"""Dropping coefficients that an error budget does not need, per weight and per power ("staircase")."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Lengths = NDArray[np.int64]

_HALVINGS = 18
_SCANNED = 48
_SCAN_FACTOR = 1.6


def lengths_above(dense: Array, threshold: float) -> Lengths:
    """Return how many coefficients of the first axis to keep so that every magnitude above ``threshold`` stays.

    ``dense`` has shape ``(channels, count, d_1+1, ..)``; the result drops axis 2. In an orthogonal basis a dropped
    coefficient costs its own magnitude, so one threshold for all treats every weight alike.
    """
    kept = np.abs(dense) > threshold
    last = dense.shape[2] - np.argmax(kept[:, :, ::-1], axis=2)
    return np.where(kept.any(axis=2), last, 0)


def shortest(dense: Array, budget: float, measure: Callable[[Lengths], float]) -> Lengths | None:
    """Return the shortest staircase found whose ``measure`` stays within ``budget``.

    Bisection over the threshold finds the neighbourhood. The largest error is not monotone in the threshold, since dropped
    coefficients of opposite sign cancel, so larger thresholds are then scanned for shorter ones.
    None where even the whole fit exceeds the budget.
    """
    best = lengths_above(dense, 0.0)
    if measure(best) > budget:
        return None
    magnitudes = np.abs(dense[dense != 0.0])
    if magnitudes.size == 0:
        return best
    low, high = np.log(magnitudes.min()), np.log(magnitudes.max())
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        lengths = lengths_above(dense, float(np.exp(middle)))
        if measure(lengths) <= budget:
            best, low = lengths, middle
        else:
            high = middle
    for threshold in np.exp(low) * np.geomspace(1.0, _SCAN_FACTOR, _SCANNED):
        lengths = lengths_above(dense, float(threshold))
        if lengths.sum() < best.sum() and measure(lengths) <= budget:
            best = lengths
    return best
