"""Rounding to whole steps in a metric: each rounding error is passed on to the coefficients not yet rounded."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.minimax import Metric
from skylight_sh.reproducible import significant

Array = NDArray[np.float64]
Index = NDArray[np.int64]

# A value within this share of a step becomes 0: a zero is the cheapest number, and its neighbours take up the rest.
_DEAD = 0.6


def lengths_above(coefficients: Array, threshold: float) -> Index:
    """Return ``(channels, count, rest)``: how many of the first axis' terms to keep of ``(.., .., first, rest)``.

    >>> lengths_above(np.array([9.0, 0.1, 3.0, 0.2]).reshape(1, 1, 4, 1), 1.0).tolist()
    [[[3]]]
    """
    kept = np.abs(coefficients) > threshold
    last = coefficients.shape[2] - np.argmax(kept[:, :, ::-1], axis=2)
    return np.where(kept.any(axis=2), last, 0)


def round_kept(metric: Metric, lengths: Index, first: int, step: float) -> Index:
    """Return whole numbers ``(channels, count, first, rest)`` near the best ones in the metric, 0 beyond ``lengths``.

    The kept coefficients are solved for anew without the others, then rounded one by one, each after the errors of
    those before it (Babai's nearest plane): first those that weigh most in the metric, so that those whose own
    rounding costs least take up what is left. Plain rounding needs a step about 1.5 times finer for the same error.

    >>> gram, right = np.array([[[2.0, 1.0], [1.0, 2.0]]]), np.array([[[4.2, 4.2]]])  # the best: 1.4 and 1.4
    >>> round_kept(Metric(gram, right), np.full((1, 1, 1), 2), 2, 1.0).ravel().tolist()
    [2, 1]
    """
    from scipy import linalg

    channels, count, rest = lengths.shape
    keep = (np.arange(first)[:, np.newaxis] < lengths[:, :, np.newaxis, :]).reshape(channels, count, -1)
    out = np.zeros((channels, count, first * rest), dtype=np.int64)
    for channel, gram in enumerate(metric.gram):
        # Terms that weigh the same must rank the same on every machine.
        ranked = np.argsort(significant(np.diag(gram), 20), kind="stable")
        for w in range(count):
            use = ranked[keep[channel, w, ranked]]
            if use.size:
                factor = linalg.cholesky(gram[np.ix_(use, use)], check_finite=False)
                # factor @ solution, of which each row names one coefficient given all later ones.
                target = linalg.solve_triangular(factor, metric.right[channel, w, use], trans="T", check_finite=False)
                diagonal = np.diag(factor).copy()
                out[channel, w, use] = _nearest_plane(factor / diagonal[:, np.newaxis], target / (diagonal * step))
    return out.reshape(channels, count, first, rest)


def _nearest_plane(unit: Array, target: Array) -> Index:
    rounded = np.zeros(target.size)
    for i in range(target.size - 1, -1, -1):
        value = target[i] - unit[i, i + 1 :] @ rounded[i + 1 :]
        rounded[i] = 0.0 if abs(value) < _DEAD else np.rint(value)
    return rounded.astype(np.int64)
