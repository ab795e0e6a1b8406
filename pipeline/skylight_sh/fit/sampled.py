"""Parameter sets as a table sees them: what its coefficients come to there, and how far that is from the weights."""

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

# Of an error that a search acts on: what differs from machine to machine must not feed back.
_ERROR_BITS = 24


@dataclass(frozen=True)
class Sampled:
    """``n`` parameter sets as a table sees them, everything in units of each set's L_min.

    ``basis`` ``(n, terms)`` holds all products of basis functions, ``factor`` ``(n, channels, classes)`` what each channel
    takes of each class's sums, ``truth`` ``(n, channels, count)`` the weights. Sums of weight w are multiplied with
    ``sines`` ``(n,)`` to the power ``orders`` ``(count,)``; those are 0 without parity. The first sets are on a grid of
    ``shape``, if on any; ``along`` is the basis at the nodes of each of its axes, ``(n_a, t_a)``, the products of which
    are the first rows of ``basis``: sums over a grid are quick by one axis after another.
    """

    basis: Array
    factor: Array
    truth: Array
    sines: Array
    orders: Index
    shape: tuple[int, ...] = ()
    along: tuple[Array, ...] = ()

    @property
    def axes(self) -> tuple[Array, ...]:
        """The basis along each axis of the grid; sets that are on none are one axis."""
        return self.along or (self.basis,)

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

    @cached_property
    def shares(self) -> Array:
        """``factor``, the sets of each channel and class side by side: ``(channels, classes, n)``."""
        return np.ascontiguousarray(np.moveaxis(self.factor, 0, -1))

    @cached_property
    def weights(self) -> Array:
        """``truth``, the sets of each channel and weight side by side: ``(channels, count, n)``."""
        return np.ascontiguousarray(np.moveaxis(self.truth, 0, -1))

    @cached_property
    def pairs(self) -> list[tuple[Array, Index]]:
        """An axis its products of two functions, ``(n_a, pairs)``, and the number of any two of them, ``(t_a, t_a)``."""
        found = []
        for own in self.axes:
            one, other = np.triu_indices(own.shape[1])
            found.append((own[:, one] * own[:, other], pair_numbers(own.shape[1])))
        return found

    @cached_property
    def _powers(self) -> Array:
        return np.stack([self.waves[m] for m in self.orders.tolist()])

    def sums(self, coefficients: Array) -> Array:
        """Return the sums of each class and weight, ``(classes, count, n)``, of coefficients ``(classes, count, terms)``."""
        sizes = [own.shape[1] for own in self.axes]
        gridded = contracted(coefficients.reshape(-1, *sizes), [own.T for own in self.axes])
        gridded = gridded.reshape(*coefficients.shape[:2], -1)
        others = self.basis[gridded.shape[2] :]
        return np.concatenate([gridded, coefficients @ others.T], axis=2) if len(others) else gridded

    def errors(self, coefficients: Array) -> Array:
        """Return E_mean of every set and channel, ``(n, channels)``, of coefficients ``(classes, count, terms)``."""
        sums = self.sums(coefficients)
        sums *= self._powers
        out = np.empty(self.truth.shape[:2])
        for channel, truth in enumerate(self.weights):
            off, part = -truth, np.empty_like(truth)
            for share, made in zip(self.shares[channel], sums, strict=True):
                if share.any():
                    off += np.multiply(share, made, out=part)
            out[:, channel] = norms(off.T)
        return out

    def largest(self, coefficients: Array) -> float:
        """Return the largest of ``errors``, between nodes too, rounded far above what differs from machine to machine."""
        return self.largest_of(self.errors(coefficients))

    def largest_of(self, errors: Array) -> float:
        """Return the same of ``errors`` that are known, ``(n, channels)``."""
        return float(significant(peaks.largest(errors, self.shape), _ERROR_BITS))


def pair_numbers(count: int) -> Index:
    """Return the number of each pair of ``count`` things, ``(count, count)``, in the order of ``np.triu_indices``.

    >>> pair_numbers(2).tolist()
    [[0, 1], [1, 2]]
    """
    one, other = np.triu_indices(count)
    numbers = np.empty((count, count), dtype=np.int64)
    numbers[one, other] = numbers[other, one] = np.arange(one.size)
    return numbers


def contracted(values: Array, matrices: Sequence[Array]) -> Array:
    """Sum ``values`` ``(b, n_1, .., n_D)`` over all axes but the first, each with its matrix ``(n_a, p_a)``.

    >>> contracted(np.array([[[1.0, 2.0], [3.0, 4.0]]]), [np.ones((2, 1)), np.eye(2)]).tolist()
    [[[4.0, 6.0]]]
    """
    for matrix in matrices:
        values = np.tensordot(values, matrix, axes=(1, 0))
    return values
