"""Least squares in the metric that a table is judged by: every set's error over its least radiance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit import peaks
from skylight_sh.fit.errors import norms
from skylight_sh.reproducible import significant

Array = NDArray[np.float64]
Index = NDArray[np.int64]

# Far below any rounding step, far above what Cholesky needs.
_RIDGE = 1e-12
# Of an importance and of an error that a search acts on: what differs from machine to machine must not feed back.
_IMPORTANCE_BITS = 4
_ERROR_BITS = 24


@dataclass(frozen=True)
class Sampled:
    """``n`` parameter sets as a table sees them, everything in units of each set's L_min.

    ``basis`` ``(n, terms)`` holds all products of basis functions times the table's factor, ``truth`` ``(n, channels,
    count)`` the weights. The first sets are on a grid of ``shape``, if on any.
    """

    basis: Array
    truth: Array
    shape: tuple[int, ...] = ()

    def errors(self, coefficients: Array) -> Array:
        """Return E_mean of every set and channel, ``(n, channels)``, of coefficients ``(channels, count, terms)``."""
        channels, count = coefficients.shape[:2]
        flat = coefficients.reshape(channels * count, -1)
        use = np.flatnonzero(flat.any(axis=0))
        made = self.basis[:, use] @ flat[:, use].T
        return norms(made.reshape(-1, channels, count) - self.truth)

    def largest(self, coefficients: Array) -> float:
        """Return the largest of ``errors``, between nodes too, rounded far above what differs from machine to machine."""
        return float(significant(peaks.largest(self.errors(coefficients), self.shape), _ERROR_BITS))


@dataclass(frozen=True)
class Metric:
    """Normal equations, a channel each: ``gram`` ``(channels, terms, terms)``, ``right`` ``(channels, count, terms)``.

    ``best``, of the same shape as ``right``, minimises the weighted squared error without any limit on the coefficients.
    The error of other coefficients exceeds the least one by their distance to ``best`` in ``gram``.
    """

    gram: Array
    right: Array

    @cached_property
    def best(self) -> Array:
        """The best coefficients of all terms, solved for where they are asked for."""
        return np.stack([_solved(g, r.T).T for g, r in zip(self.gram, self.right, strict=True)])

    def best_of(self, kept: Index) -> Array:
        """Return the best coefficients of the terms ``kept`` alone, zeros elsewhere: ``(channels, count, terms)``.

        >>> normal = metric(Sampled(np.eye(2), np.array([[[3.0]], [[5.0]]])), np.full((2, 1), 0.5))
        >>> normal.best_of(np.array([1])).round(6).tolist()
        [[[0.0, 5.0]]]
        """
        out = np.zeros_like(self.right)
        for channel, gram in enumerate(self.gram):
            right = self.right[channel][:, kept].T
            out[channel][:, kept] = _solved(gram[np.ix_(kept, kept)], right).T
        return out


def _solved(gram: Array, right: Array) -> Array:
    # Imported here: names that this module gives to others need no SciPy.
    from scipy import linalg

    return np.asarray(linalg.solve(gram, right, assume_a="pos"))


def metric(sampled: Sampled, importance: Array) -> Metric:
    """Build the metric of ``sum importance * error**2``; ``importance`` ``(n, channels)`` sums to 1.

    >>> normal = metric(Sampled(np.eye(2), np.ones((2, 1, 1))), np.full((2, 1), 0.5))
    >>> normal.gram.round(6).tolist(), normal.right.tolist()
    ([[[0.5, 0.0], [0.0, 0.5]]], [[[0.5, 0.5]]])
    """
    terms = sampled.basis.shape[1]
    grams = np.empty((importance.shape[1], terms, terms))
    right = np.empty((*sampled.truth.shape[1:], terms))
    for channel, gram in enumerate(grams):
        weighed = (sampled.basis * importance[:, channel, np.newaxis]).T
        gram[:] = weighed @ sampled.basis
        gram[np.diag_indices(terms)] += _RIDGE * np.trace(gram) / terms
        right[channel] = (weighed @ sampled.truth[:, channel]).T
    return Metric(grams, right)


def even(sampled: Sampled) -> Array:
    """Return the importance that prefers no set and no channel.

    >>> even(Sampled(np.ones((2, 1)), np.ones((2, 2, 1)))).tolist()
    [[0.25, 0.25], [0.25, 0.25]]
    """
    shape = sampled.truth.shape[:2]
    return np.full(shape, 1.0 / np.prod(shape))


def sharpen(importance: Array, errors: Array, shape: Sequence[int]) -> Array:
    """Move importance to where errors are large (Lawson 1961), so that the largest error falls.

    ``errors`` ``(n, channels)`` on a grid of ``shape``; squared, they are averaged over neighbours first, since
    rounding makes single sets' errors a matter of chance. The result grows with the error itself, and is rounded to few
    bits: importance need not be exact, and what follows from it must not hang on the last bits of errors.

    >>> errors = np.array([[1.0], [1.0], [4.0], [1.0], [1.0]])
    >>> bool(sharpen(np.full((5, 1), 0.2), errors, (5,)).argmax() == 2)
    True
    """
    smooth = (errors * errors).reshape(*shape, -1)
    for axis in range(len(shape)):
        for _ in range(4):
            padded = np.pad(smooth, [(1, 1) if a == axis else (0, 0) for a in range(smooth.ndim)], mode="edge")
            size = smooth.shape[axis]
            smooth = (padded.take(range(size), axis) + 2 * smooth + padded.take(range(2, size + 2), axis)) / 4
    grown = importance * np.sqrt(smooth.reshape(errors.shape) / smooth.max())
    return significant(grown / grown.sum(), _IMPORTANCE_BITS)
