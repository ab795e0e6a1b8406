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

    ``basis`` ``(n, terms)`` holds all products of basis functions, ``factor`` ``(n, channels, classes)`` what each channel
    takes of each class's sums, ``truth`` ``(n, channels, count)`` the weights. Sums of weight w are multiplied with
    ``sines`` ``(n,)`` to the power ``orders`` ``(count,)``; those are 0 without parity. The first sets are on a grid of
    ``shape``, if on any.
    """

    basis: Array
    factor: Array
    truth: Array
    sines: Array
    orders: Index
    shape: tuple[int, ...] = ()

    @cached_property
    def waves(self) -> dict[int, Array]:
        """The sines to the power of each order that there is, ``(n,)``."""
        return {m: self.sines**m for m in np.unique(self.orders).tolist()}

    @cached_property
    def groups(self) -> list[tuple[int, ...]]:
        """Classes that share a channel: they are fitted together."""
        channels, classes = self.truth.shape[1], self.size[0]
        mixed = np.abs(self.factor).max(axis=0) > 0.0
        if channels == classes and not (mixed & ~np.eye(classes, dtype=bool)).any():
            return [(k,) for k in range(classes)]
        return [tuple(range(classes))]

    @property
    def size(self) -> tuple[int, int, int]:
        """How many classes, weights and terms coefficients have."""
        return len(self.factor[0, 0]), len(self.truth[0, 0]), len(self.basis[0])

    def errors(self, coefficients: Array) -> Array:
        """Return E_mean of every set and channel, ``(n, channels)``, of coefficients ``(classes, count, terms)``."""
        sums = []
        for own in coefficients:
            use = np.flatnonzero(own.any(axis=0))
            made = self.basis[:, use] @ own[:, use].T
            for m, wave in self.waves.items():
                if m:
                    made[:, self.orders == m] *= wave[:, np.newaxis]
            sums.append(made)
        count, channels = len(self.truth), len(self.truth[0])
        out = np.empty((count, channels))
        for channel in range(channels):
            off = -self.truth[:, channel]
            for k, made in enumerate(sums):
                share = self.factor[:, channel, k]
                if share.any():
                    off = off + share[:, np.newaxis] * made
            out[:, channel] = norms(off)
        return out

    def largest(self, coefficients: Array) -> float:
        """Return the largest of ``errors``, between nodes too, rounded far above what differs from machine to machine."""
        return float(significant(peaks.largest(self.errors(coefficients), self.shape), _ERROR_BITS))


@dataclass(frozen=True)
class System:
    """Normal equations of some weights and ``terms`` of some classes: ``gram`` ``(u, u)``, ``right`` ``(outputs, u)``.

    u is classes times terms, the terms of a class after those of another. The error of other coefficients exceeds the least
    one by their distance to the best in ``gram``.
    """

    classes: tuple[int, ...]
    outputs: Index
    terms: Index
    gram: Array
    right: Array


@dataclass(frozen=True)
class Metric:
    """The systems that together give coefficients of shape ``size``, ``(classes, count, terms)``."""

    systems: tuple[System, ...]
    size: tuple[int, int, int]

    @cached_property
    def best(self) -> Array:
        """The best coefficients of all terms, solved for where they are asked for."""
        return self.best_of(np.ones((self.size[0], self.size[2]), dtype=bool))

    def best_of(self, kept: NDArray[np.bool_]) -> Array:
        """Return the best coefficients of the terms ``kept`` ``(classes, terms)`` that systems have, zeros elsewhere.

        >>> truth = np.array([[[3.0]], [[5.0]]])
        >>> sampled = Sampled(np.eye(2), np.ones((2, 1, 1)), truth, np.ones(2), np.zeros(1, dtype=int))
        >>> metric(sampled, np.full((2, 1), 0.5)).best_of(np.array([[False, True]])).round(6).tolist()
        [[[0.0, 5.0]]]
        """
        out = np.zeros(self.size)
        for system in self.systems:
            use = np.flatnonzero(kept[np.ix_(np.array(system.classes), system.terms)].ravel())
            solved = _solved(system.gram[np.ix_(use, use)], system.right[:, use].T).T
            flat = np.zeros(system.right.shape)
            flat[:, use] = solved
            put(out, system, flat)
        return out


def put(coefficients: Array | Index, system: System, flat: Array | Index) -> None:
    """Put what was found for a system, ``(outputs, u)``, where it belongs in ``(classes, count, terms)``."""
    parts = flat.reshape(len(flat), len(system.classes), -1).swapaxes(0, 1)
    coefficients[np.ix_(np.array(system.classes), system.outputs, system.terms)] = parts


def _solved(gram: Array, right: Array) -> Array:
    # Imported here: names that this module gives to others need no SciPy.
    from scipy import linalg

    return np.asarray(linalg.solve(gram, right, assume_a="pos"))


def metric(sampled: Sampled, importance: Array, terms: Index | None = None) -> Metric:
    """Build the metric of ``sum importance * error**2``; ``importance`` ``(n, channels)`` sums to 1.

    Of all terms, or of some, which is quicker.

    >>> sampled = Sampled(np.eye(2), np.ones((2, 1, 1)), np.ones((2, 1, 1)), np.ones(2), np.zeros(1, dtype=int))
    >>> [found] = metric(sampled, np.full((2, 1), 0.5)).systems
    >>> found.gram.round(6).tolist(), found.right.tolist()
    ([[0.5, 0.0], [0.0, 0.5]], [[0.5, 0.5]])
    """
    use = np.arange(sampled.basis.shape[1]) if terms is None else terms
    systems = [_system(sampled, importance, group, m, use) for group in sampled.groups for m in sampled.waves]
    return Metric(tuple(systems), sampled.size)


def _system(sampled: Sampled, importance: Array, group: tuple[int, ...], m: int, use: Index) -> System:
    basis, terms = np.ascontiguousarray(sampled.basis[:, use]), use.size
    outputs = np.flatnonzero(sampled.orders == m)
    wave = sampled.waves[m][:, np.newaxis]
    factors = sampled.factor[:, :, list(group)] * wave[:, :, np.newaxis]
    gram = np.empty((len(group), terms, len(group), terms))
    right = np.empty((outputs.size, len(group), terms))
    truth = sampled.truth[:, :, outputs]
    for i in range(len(group)):
        weighed = importance * factors[:, :, i]
        for j in range(i + 1):
            part = (basis * (weighed * factors[:, :, j]).sum(axis=1)[:, np.newaxis]).T @ basis
            gram[i, :, j], gram[j, :, i] = part, part.T
        right[:, i] = (weighed[:, :, np.newaxis] * truth).sum(axis=1).T @ basis
    flat = gram.reshape(len(group) * terms, -1)
    flat[np.diag_indices(len(flat))] += _RIDGE * np.trace(flat) / len(flat)
    return System(group, outputs, use, flat, right.reshape(outputs.size, -1))


def even(sampled: Sampled) -> Array:
    """Return the importance that prefers no set and no channel.

    >>> even(Sampled(np.ones((2, 1)), np.ones((2, 2, 2)), np.ones((2, 2, 1)), np.ones(2), np.zeros(1, dtype=int))).tolist()
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
