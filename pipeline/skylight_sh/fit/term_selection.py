"""The fewest terms that each class needs under an error budget: what a table laid out for speed keeps.

All weights of a class keep the same terms, so that an evaluation is a sum of rows.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.minimax import OF_FITTED, even, metric, sharpen
from skylight_sh.fit.sampled import Sampled
from skylight_sh.reproducible import significant

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_ROUNDS = 6
# Of rounds where lengths are known, or where the last corner is at stake.
_LONG_ROUNDS = 12
# After so many rounds, an error this much above the budget does not come down to it.
_HOPELESS = ((1, 1.3), (2, 1.1), (3, 1.03))
# Corners that are tried last: those that squared errors need least.
_CORNERS = 2
# Of the energy of a class's coefficients where only their order matters.
_ENERGY_BITS = 20
# Of the budget's square: a growth of squared errors below that is none.
_NO_GROWTH = 1e-8


@dataclass(frozen=True)
class Kept:
    """``lengths`` ``(classes, rest)``, ``dense`` ``(classes, count, first, rest)`` and its largest E_mean.

    ``gridded`` ``(n, channels)`` are the errors on the fit's own grid.
    """

    lengths: Index
    dense: Array
    error: float
    gridded: Array

    @property
    def terms(self) -> int:
        """How many terms all classes keep."""
        return int(self.lengths.sum())


# What a search found, and all that it tried.
Known = tuple[Kept, list[Kept]]


class _Search:
    """Fits of chosen terms, with the importance of sets sharpened for the last terms fitted."""

    def __init__(self, grid: Sampled, checked: Sampled, shape: Sequence[int], first: int) -> None:
        self.grid, self.checked, self.shape, self.first = grid, checked, shape, first
        self.importance = even(grid)
        self.start = self.normal = metric(grid, self.importance)
        # What a class's coefficients are worth in the channels.
        self.worth = np.square(grid.factor).sum(axis=1).mean(axis=0)
        self.tried: list[Kept] = []

    def fit(self, lengths: Index, budget: float) -> Kept:
        """Fit the terms of ``lengths`` with the importance as it stands.

        Where the fit's own grid, which is quickly asked, exceeds the budget already, its error is told, and the fit is none
        of those ``tried``.
        """
        found = self.normal.best_of(_kept(lengths, self.first))
        dense, gridded = found.reshape(*found.shape[:2], self.first, -1), self.grid.errors(found)
        error = self.grid.largest_of(gridded)
        if error > budget:
            return Kept(lengths, dense, error, gridded)
        made = Kept(lengths, dense, max(error, self.checked.largest(found)), gridded)
        self.tried.append(made)
        return made

    def sharpened(self, lengths: Index, budget: float, rounds: int = _ROUNDS) -> Kept:
        """Fit with the importance moved to the worst sets until the budget is met or no round helps; return the best."""
        best = made = self.fit(lengths, budget)
        importance, normal = self.importance, self.normal
        kept = np.tile(_kept(lengths, self.first).any(axis=0), (len(lengths), 1))
        for done in range(rounds):
            if best.error <= budget or any(done >= after and best.error > much * budget for after, much in _HOPELESS):
                break
            self.importance = sharpen(self.importance, made.gridded, self.shape, OF_FITTED)
            self.normal = metric(self.grid, self.importance, kept)
            made = self.fit(lengths, budget)
            best = min(best, made, key=lambda k: k.error)
        if best.error > budget:
            self.importance, self.normal = importance, normal
        return best

    def energy(self, dense: Array) -> Array:
        """Return what coefficients ``(classes, count, ..)`` are worth, summed over the weights: ``(classes, ..)``."""
        found = np.square(dense).sum(axis=1)
        return significant(found * self.worth.reshape(-1, *(1,) * (found.ndim - 1)), _ENERGY_BITS)


def _kept(lengths: Index, first: int) -> NDArray[np.bool_]:
    """Return which terms ``(classes, first * rest)`` lengths ``(classes, rest)`` keep."""
    return (np.arange(first)[:, np.newaxis] < lengths[:, np.newaxis, :]).reshape(len(lengths), -1)


def fewest(
    grid: Sampled, checked: Sampled, shape: Sequence[int], first: int, budget: float, known: Known | None = None
) -> tuple[Kept | None, list[Kept]]:
    """Return the fewest terms found whose largest error over ``checked`` stays within ``budget``, and all tried there.

    ``grid``, of ``shape``, is what is fitted; ``first`` is the size of the first axis' basis. Terms are ranked by the
    coefficients that drop with them; a bisection finds how many are needed, corners that the budget does not need are then
    taken away one by one, and the worst sets' importance is sharpened where that saves another. What a search with a
    larger budget found and tried is the start where it is ``known``: corners are added until they are enough, or as many
    as were so when tried. The first result is None where all terms together exceed the budget.
    """
    search = _Search(grid, checked, shape, first)
    if known is None:
        return _searched(search, budget), search.tried
    kept, tried = known
    met = [k for k in tried if k.error <= budget]
    most = min(met, key=lambda k: k.terms, default=None)
    made = search.sharpened(kept.lengths, budget, _LONG_ROUNDS)
    while made.error > budget:
        if most is not None and most.terms <= made.terms + 1:
            return most, search.tried
        options = [search.fit(lengths, 0.0) for lengths in _with_a_corner(made.lengths, first)]
        if not options:
            return None, search.tried
        made = search.sharpened(min(options, key=lambda k: k.error).lengths, budget)
    return made, search.tried


def _searched(search: _Search, budget: float) -> Kept | None:
    size = search.normal.size
    ranked = _ranking(search.energy(search.normal.best.reshape(*size[:2], search.first, -1)))
    low, high = 1, len(ranked)
    if search.fit(ranked[-1], budget).error > budget:
        return None
    while low < high:
        middle = (low + high) // 2
        if search.fit(ranked[middle - 1], budget).error <= budget:
            high = middle
        else:
            low = middle + 1
    return _reduced(search, search.fit(ranked[low - 1], budget), budget)


def _reduced(search: _Search, best: Kept, budget: float) -> Kept:
    """Take away the corner that is needed least, again and again; at last one of a few, from even importance."""
    rounds, tried = _ROUNDS, 1
    while True:
        for lengths in _without_a_corner(search, best.lengths, budget)[:tried]:
            made = search.sharpened(lengths, budget, rounds)
            if made.error <= budget:
                best, rounds, tried = made, _ROUNDS, 1
                break
        else:
            if tried > 1:
                return best
            rounds, tried = _LONG_ROUNDS, _CORNERS
            search.importance, search.normal = even(search.grid), search.start


def _ranking(energy: Array) -> list[Index]:
    """Return lengths ``(classes, rest)`` of 1, 2, .. terms, each with the one more whose tail is worth most.

    >>> _ranking(np.array([[[4.0, 1.0], [2.0, 0.5]]]))[1].tolist()
    [[2, 0]]
    """
    classes, _, rest = energy.shape
    tails = np.maximum.accumulate(energy[:, ::-1], axis=1)[:, ::-1]
    tails = np.concatenate([tails, np.full((classes, 1, rest), -1.0)], axis=1)
    lengths = np.zeros((classes, rest), dtype=np.int64)
    found = []
    for _ in range(energy.size):
        worth = np.take_along_axis(tails, lengths[:, np.newaxis], axis=1)[:, 0]
        lengths = lengths.copy()
        lengths[np.unravel_index(int(np.argmax(worth)), worth.shape)] += 1
        found.append(lengths)
    return found


def _without_a_corner(search: _Search, lengths: Index, budget: float) -> list[Index]:
    """Return the lengths without one corner, for each; first those without which squared errors grow least."""
    if lengths.sum() == 1:
        return []
    corners = np.arange(search.first)[:, np.newaxis] == lengths[:, np.newaxis] - 1
    classes, _, rest = np.nonzero(corners)
    grown = search.normal.growths(_kept(lengths, search.first), corners.reshape(len(lengths), -1))
    # What hardly changes errors is the last bits of the machine.
    grown = significant(np.maximum(grown, _NO_GROWTH * budget**2), _ENERGY_BITS)
    found = []
    for place in np.argsort(grown, kind="stable"):
        out = lengths.copy()
        out[classes[place], rest[place]] -= 1
        found.append(out)
    return found


def _with_a_corner(lengths: Index, first: int) -> Iterator[Index]:
    """Yield the lengths with one more term, of runs that are shorter than the one before them."""
    for k, r in zip(*np.nonzero(lengths < first), strict=True):
        if r == 0 or lengths[k, r] < lengths[k, r - 1]:
            out = lengths.copy()
            out[k, r] += 1
            yield out
