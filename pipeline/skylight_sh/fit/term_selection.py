"""The fewest terms that all outputs need together under an error budget: what a table laid out for speed keeps."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.minimax import Sampled, even, metric, sharpen

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_ROUNDS = 8
# Of rounds where four terms, a whole group, are at stake.
_LONG_ROUNDS = 32
# After the first rounds, an error this much above the budget does not come down to it.
_HOPELESS = 1.1
# Terms are summed four at a time.
_GROUP = 4
# Corners that are tried before one is taken away: those with the smallest coefficients.
_CORNERS = 6


@dataclass(frozen=True)
class Kept:
    """``lengths`` ``(rest,)`` of the first axis, ``dense`` ``(channels, count, first, rest)`` and its largest E_mean."""

    lengths: Index
    dense: Array
    error: float


class _Search:
    """Fits of chosen terms, with the importance of sets sharpened for the last terms fitted."""

    def __init__(self, grid: Sampled, checked: Sampled, shape: Sequence[int], first: int) -> None:
        self.grid, self.checked, self.shape, self.first = grid, checked, shape, first
        self.importance = even(grid)
        self.normal = metric(grid, self.importance)

    def fit(self, lengths: Index) -> Kept:
        """Fit the terms of ``lengths`` with the importance as it stands."""
        rest = lengths.size
        kept = np.flatnonzero((np.arange(self.first)[:, np.newaxis] < lengths).ravel())
        found = self.normal.best_of(kept)
        error = self.checked.largest(found)
        return Kept(lengths, found.reshape(*found.shape[:2], self.first, rest), error)

    def sharpened(self, lengths: Index, budget: float, rounds: int = _ROUNDS) -> Kept:
        """Fit with the importance moved to the worst sets until the budget is met or no round helps; return the best."""
        best = made = self.fit(lengths)
        importance, normal = self.importance, self.normal
        for done in range(rounds):
            if best.error <= budget or (done >= _ROUNDS and best.error > _HOPELESS * budget):
                break
            errors = self.grid.errors(made.dense.reshape(*made.dense.shape[:2], -1))
            self.importance = sharpen(self.importance, errors, self.shape)
            self.normal = metric(self.grid, self.importance)
            made = self.fit(lengths)
            best = min(best, made, key=lambda k: k.error)
        if best.error > budget:
            self.importance, self.normal = importance, normal
        return best


def fewest(
    grid: Sampled, checked: Sampled, shape: Sequence[int], first: int, budget: float, known: Index | None = None
) -> tuple[Kept | None, list[Kept]]:
    """Return the fewest terms found whose largest error over ``checked`` stays within ``budget``, and all tried.

    ``grid``, of ``shape``, is what is fitted; ``first`` is the size of the first axis' basis. Terms are ranked by the
    largest coefficients that drop with them; a bisection finds how many are needed, corners that the budget does not
    need are then taken away one by one, and the worst sets' importance is sharpened where that saves another. What is
    left is filled up to a multiple of four terms, unless long sharpening meets the budget with the multiple below. Lengths
    ``known`` from a search with a larger budget are taken where sharpening is enough. The first result is None where all
    terms together exceed the budget.
    """
    if known is not None:
        made = _Search(grid, checked, shape, first).sharpened(known, budget, _LONG_ROUNDS)
        if made.error <= budget:
            return made, [made]
    search = _Search(grid, checked, shape, first)
    best, tried = _searched(search, budget)
    while best is not None and best.lengths.sum() % _GROUP:
        options = [search.fit(lengths) for lengths in _with_a_corner(best.lengths, first)]
        tried += options
        if not options:
            break
        best = min(options, key=lambda k: k.error)
    if best is not None and best.error > budget:
        best = search.sharpened(best.lengths, budget)
    return best, tried


def _searched(search: _Search, budget: float) -> tuple[Kept | None, list[Kept]]:
    """Return the fewest terms found, not yet filled up to whole groups, and all tried."""
    first = search.first
    ranked = _ranking(search.normal.best.reshape(*search.normal.best.shape[:2], first, -1))
    tried: list[Kept] = []

    def attempt(lengths: Index) -> Kept:
        tried.append(search.fit(lengths))
        return tried[-1]

    low, high = 1, len(ranked)
    if attempt(ranked[-1]).error > budget:
        return None, tried
    while low < high:
        middle = (low + high) // 2
        if attempt(ranked[middle - 1]).error <= budget:
            high = middle
        else:
            low = middle + 1
    best = search.fit(ranked[low - 1])
    while True:
        smaller = min((attempt(lengths) for lengths in _without_a_corner(best)), key=lambda k: k.error, default=None)
        if smaller is not None and smaller.error > budget:
            smaller = search.sharpened(smaller.lengths, budget)
        if smaller is None or smaller.error > budget:
            break
        best = smaller
    while (group := _a_group_less(search, ranked, best, attempt, budget)) is not None:
        best = group
    return best, tried


def _a_group_less(
    search: _Search, ranked: Sequence[Index], best: Kept, attempt: Callable[[Index], Kept], budget: float
) -> Kept | None:
    """Return a fit within ``budget`` with the next lower multiple of four terms, if one is found.

    Two staircases are sharpened for long: the one that taking corner after corner away leaves, and the ranking's.
    """
    target = (int(best.lengths.sum()) - 1) // _GROUP * _GROUP
    if target < _GROUP:
        return None
    fewer = best
    while fewer.lengths.sum() > target:
        fewer = min((attempt(lengths) for lengths in _without_a_corner(fewer)), key=lambda k: k.error)
    for lengths in (fewer.lengths, ranked[target - 1]):
        made = search.sharpened(lengths, budget, _LONG_ROUNDS)
        if made.error <= budget:
            return made
    return None


def _ranking(dense: Array) -> list[Index]:
    """Return lengths ``(rest,)`` of 1, 2, .. terms, each with the one more whose tail holds the largest coefficients."""
    energy = (dense**2).sum(axis=1).max(axis=0)
    first, rest = energy.shape
    tails = np.maximum.accumulate(energy[::-1], axis=0)[::-1]
    lengths = np.zeros(rest, dtype=np.int64)
    found = []
    for _ in range(first * rest):
        worth = [tails[n, r] if n < first else -1.0 for r, n in enumerate(lengths)]
        lengths = lengths.copy()
        lengths[int(np.argmax(worth))] += 1
        found.append(lengths)
    return found


def _without_a_corner(kept: Kept) -> Iterator[Index]:
    """Yield the lengths without one corner, for the corners with the smallest coefficients."""
    lengths = kept.lengths
    if lengths.sum() > 1:
        corners = np.flatnonzero(lengths)
        energy = (kept.dense[:, :, lengths[corners] - 1, corners] ** 2).sum(axis=1).max(axis=0)
        for r in corners[np.argsort(energy, kind="stable")[:_CORNERS]]:
            out = lengths.copy()
            out[r] -= 1
            yield out


def _with_a_corner(lengths: Index, first: int) -> Iterator[Index]:
    for r in np.flatnonzero(lengths < first):
        out = lengths.copy()
        out[r] += 1
        yield out
