"""Least squares in the metric that a table is judged by: every set's error over its least radiance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.sampled import Sampled, contracted, pair_numbers
from skylight_sh.reproducible import significant

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Mask = NDArray[np.bool_]

# Far below any rounding step, far above what Cholesky needs.
_RIDGE = 1e-12
# Of an importance that a search acts on, for rounded numbers and for fitted ones: what differs from machine to machine must
# not feed back.
_IMPORTANCE_BITS = 4, 6


class Sharpening(NamedTuple):
    """How importance moves: with the error to a ``power``, over neighbours ``averaged`` so many times, kept in ``bits``."""

    averaged: int
    power: int
    bits: int


# Rounding makes single sets' errors a matter of chance; those of a fit are smooth themselves.
OF_ROUNDED = Sharpening(4, 1, _IMPORTANCE_BITS[0])
OF_FITTED = Sharpening(1, 2, _IMPORTANCE_BITS[1])


@dataclass(frozen=True)
class System:
    """Normal equations of the weights ``outputs`` and u terms: ``gram`` ``(u, u)``, ``right`` ``(outputs, u)``.

    ``classes`` and ``terms``, ``(u,)``, say what they are terms of. The error of other coefficients exceeds the least one
    by their distance to the best in ``gram``.
    """

    outputs: Index
    classes: Index
    terms: Index
    gram: Array
    right: Array

    def some(self, kept: Mask) -> System:
        """Return the equations of the terms ``kept`` ``(classes, terms)`` alone."""
        use = kept[self.classes, self.terms]
        if use.all():
            return self
        gram = self.gram[np.ix_(use, use)]
        return System(self.outputs, self.classes[use], self.terms[use], gram, self.right[:, use])


@dataclass(frozen=True)
class Metric:
    """The systems that together give coefficients of shape ``size``, ``(classes, count, terms)``."""

    systems: tuple[System, ...]
    size: tuple[int, int, int]

    @cached_property
    def best(self) -> Array:
        """The best coefficients of all terms, solved for where they are asked for."""
        return self.best_of(np.ones((self.size[0], self.size[2]), dtype=bool))

    def best_of(self, kept: Mask) -> Array:
        """Return the best coefficients of the terms ``kept`` ``(classes, terms)`` that systems have, zeros elsewhere.

        >>> truth = np.array([[[3.0]], [[5.0]]])
        >>> sampled = Sampled(np.eye(2), np.ones((2, 1, 1)), truth, np.ones(2), np.zeros(1, dtype=int))
        >>> metric(sampled, np.full((2, 1), 0.5)).best_of(np.array([[False, True]])).round(6).tolist()
        [[[0.0, 5.0]]]
        """
        # Imported here: names that this module gives to others need no SciPy.
        from scipy import linalg

        out = np.zeros(self.size)
        for system in self.systems:
            own = system.some(kept)
            if own.terms.size:
                factor = linalg.cho_factor(own.gram, check_finite=False)
                put(out, own, linalg.cho_solve(factor, own.right.T, check_finite=False).T)
        return out

    def growths(self, kept: Mask, without: Mask) -> Array:
        """Return by how much the sum of importance times squared errors grows without one of the terms ``kept``.

        Both ``(classes, terms)``; for each of ``without``, as ``np.nonzero`` lists them, of which all are kept, the best
        coefficients of the others found anew. A term's coefficient squared over its entry of the inverse Gram matrix.

        >>> truth = np.array([[[3.0]], [[5.0]]])
        >>> sampled = Sampled(np.eye(2), np.ones((2, 1, 1)), truth, np.ones(2), np.zeros(1, dtype=int))
        >>> kept = np.array([[True, True]])
        >>> metric(sampled, np.full((2, 1), 0.5)).growths(kept, kept).round(6).tolist()
        [4.5, 12.5]
        """
        from scipy import linalg

        grown = np.zeros(without.shape)
        for system in self.systems:
            own = system.some(kept)
            places = np.flatnonzero(without[own.classes, own.terms])
            if not places.size:
                continue
            unit = np.zeros((own.terms.size, places.size))
            unit[places, np.arange(places.size)] = 1.0
            factor = linalg.cho_factor(own.gram, check_finite=False)
            columns = linalg.cho_solve(factor, unit, check_finite=False)
            entries = columns[places, np.arange(places.size)]
            found = np.square(own.right @ columns).sum(axis=0) / entries
            grown[own.classes[places], own.terms[places]] += found
        return grown[without]


def put(coefficients: Array | Index, system: System, flat: Array | Index) -> None:
    """Put what was found for a system, ``(outputs, u)``, where it belongs in ``(classes, count, terms)``."""
    coefficients[system.classes[:, np.newaxis], system.outputs, system.terms[:, np.newaxis]] = flat.T


def metric(sampled: Sampled, importance: Array, kept: Mask | None = None) -> Metric:
    """Build the metric of ``sum importance * error**2``; ``importance`` ``(n, channels)`` sums to 1.

    Of all terms, or of some, ``kept`` ``(classes, terms)``, which is quicker. All sets are on the grid of ``sampled``: sums
    over it are taken axis by axis, of each axis's products of two basis functions.

    >>> sampled = Sampled(np.eye(2), np.ones((2, 1, 1)), np.ones((2, 1, 1)), np.ones(2), np.zeros(1, dtype=int))
    >>> [found] = metric(sampled, np.full((2, 1), 0.5)).systems
    >>> found.gram.round(6).tolist(), found.right.tolist()
    ([[0.5, 0.0], [0.0, 0.5]], [[0.5, 0.5]])
    """
    used = np.ones((sampled.size[0], sampled.size[2]), dtype=bool) if kept is None else kept
    rights = _rights(sampled, importance)
    systems = [system for group in sampled.groups for system in _systems(sampled, importance, group, used, rights)]
    return Metric(tuple(systems), sampled.size)


def _rights(sampled: Sampled, importance: Array) -> Array:
    """Return the right sides of all terms, ``(classes, count, terms)``."""
    shape = [len(own) for own in sampled.axes]
    shares = sampled.shares * importance.T[:, np.newaxis]
    weighed = np.einsum("ckn,cwn->kwn", shares, sampled.weights)
    for m, wave in sampled.waves.items():
        if m:
            weighed[:, sampled.orders == m] *= wave
    return contracted(weighed.reshape(-1, *shape), sampled.axes).reshape(sampled.size)


def _systems(sampled: Sampled, importance: Array, group: tuple[int, ...], kept: Mask, rights: Array) -> list[System]:
    shape = [len(own) for own in sampled.axes]
    shares = sampled.shares[:, list(group)]
    one, other = np.triu_indices(len(group))
    weighed = np.einsum("nc,cpn,cpn->pn", importance, shares[:, one], shares[:, other])
    waves = np.stack(list(sampled.waves.values()))
    moments = contracted(
        (np.square(waves)[:, np.newaxis] * weighed).reshape(-1, *shape), [matrix for matrix, _ in sampled.pairs]
    ).reshape(len(waves), -1)
    own = np.zeros_like(kept)
    own[list(group)] = kept[list(group)]
    classes, terms = np.nonzero(own)
    places = _places(sampled, np.searchsorted(group, classes), terms, len(group))
    made = []
    for m, of_order in zip(sampled.waves, moments, strict=True):
        gram = of_order[places]
        gram[np.diag_indices(len(gram))] += _RIDGE * np.trace(gram) / max(len(gram), 1)
        outputs = np.flatnonzero(sampled.orders == m)
        made.append(System(outputs, classes, terms, gram, rights[classes, :, terms][:, outputs].T))
    return made


def _places(sampled: Sampled, members: Index, terms: Index, count: int) -> Index:
    """Return where each entry of a Gram matrix stands among the flat moments, ``(u, u)``."""
    places = pair_numbers(count)[members[:, np.newaxis], members]
    digits = np.unravel_index(terms, [own.shape[1] for own in sampled.axes])
    for digit, (matrix, numbers) in zip(digits, sampled.pairs, strict=True):
        places = places * matrix.shape[1] + numbers[digit[:, np.newaxis], digit]
    return places


def even(sampled: Sampled) -> Array:
    """Return the importance that prefers no set and no channel.

    >>> even(Sampled(np.ones((2, 1)), np.ones((2, 2, 2)), np.ones((2, 2, 1)), np.ones(2), np.zeros(1, dtype=int))).tolist()
    [[0.25, 0.25], [0.25, 0.25]]
    """
    shape = sampled.truth.shape[:2]
    return np.full(shape, 1.0 / np.prod(shape))


def sharpen(importance: Array, errors: Array, shape: Sequence[int], how: Sharpening) -> Array:
    """Move importance to where errors are large (Lawson 1961), so that the largest error falls.

    ``errors`` ``(n, channels)`` are on a grid of ``shape``; squared, they are averaged over neighbours first. The result
    is rounded to few bits: importance need not be exact, and what follows from it must not hang on the last bits of errors.

    >>> errors = np.array([[1.0], [1.0], [4.0], [1.0], [1.0]])
    >>> bool(sharpen(np.full((5, 1), 0.2), errors, (5,), OF_ROUNDED).argmax() == 2)
    True
    """
    smooth = (errors * errors).reshape(*shape, -1)
    for axis in range(len(shape)):
        for _ in range(how.averaged):
            padded = np.pad(smooth, [(1, 1) if a == axis else (0, 0) for a in range(smooth.ndim)], mode="edge")
            size = smooth.shape[axis]
            smooth = (padded.take(range(size), axis) + 2 * smooth + padded.take(range(2, size + 2), axis)) / 4
    grown = importance * np.sqrt(smooth.reshape(errors.shape) / smooth.max()) ** how.power
    return significant(grown / grown.sum(), how.bits)
