"""The smallest table of whole numbers under an error budget: one step, staircase lengths, importance sharpened."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.minimax import OF_ROUNDED, Metric, even, metric, sharpen
from skylight_sh.fit.nearest_plane import lengths_above, round_kept
from skylight_sh.fit.sampled import Sampled
from skylight_sh.reproducible import significant

Array = NDArray[np.float64]
Index = NDArray[np.int64]

# Staircases keep what exceeds this many steps. Which one wins is a matter of chance within a few per cent.
_THRESHOLDS = (0.75, 0.9, 1.05)
_ROUNDS = 4
_AIMED = 2
_SCAN = np.geomspace(0.95, 1.2, 8)
_FARTHEST = 8.0
# A reader's whole numbers have 32 bits.
_LARGEST = 0.98 * 2.0**30
# Of a step. The error is proportional to it but for chance, and chance multiplies a change of the step by up to 1,000:
# fed back through the next step without rounding, a last bit would grow to another table within ten attempts.
_STEP_BITS = 7


@dataclass(frozen=True)
class Rounded:
    """Whole numbers ``(classes, count, first, rest)``, their step, their largest E_mean and their cost."""

    numbers: Index
    step: float
    error: float
    cost: int


def smallest(
    grid: Sampled,
    checked: Sampled,
    shape: Sequence[int],
    first: int,
    budget: float,
    cost: Callable[[Index], int],
) -> tuple[Rounded | None, list[Rounded]]:
    """Return the cheapest numbers found whose largest error over ``checked`` stays within ``budget``, and all tried there.

    ``grid``, of ``shape``, is what is fitted; ``first`` is the size of the first axis' basis; ``cost`` gives bytes.
    The error grows about linearly with the step, so a few aimed steps reach the budget; importance then moves to the
    sets with large errors, and again. At last steps around the best are scanned: the largest error is partly chance.
    The first result is None where nothing meets the budget.
    """
    start = metric(grid, even(grid))
    # To start from: all numbers off by half a step.
    finest = float(np.abs(start.best).max()) / _LARGEST
    best: Rounded | None = None
    tried: list[Rounded] = []

    def rounded(step: float) -> float:
        return float(significant(max(finest, step), _STEP_BITS))

    def attempt(normal: Metric, threshold: float, step: float) -> Rounded:
        nonlocal best
        lengths = lengths_above(normal.best.reshape(*normal.best.shape[:2], first, -1), threshold * step)
        numbers = round_kept(normal, lengths, first, step)
        values = _values(numbers, step)
        # All sets are asked where the fit's own grid does not say no.
        error = grid.largest(values)
        if error > budget:
            return Rounded(numbers, step, error, 0)
        error = max(error, checked.largest(values))
        made = Rounded(numbers, step, error, cost(numbers))
        tried.append(replace(made, numbers=numbers[:0]))
        if error <= budget and (best is None or made.cost < best.cost):
            best = made
        return made

    step = rounded(budget / np.sqrt(np.prod(grid.truth.shape[1:])))
    for threshold in _THRESHOLDS:
        importance, normal = even(grid), start
        for _ in range(_ROUNDS):
            for _ in range(_AIMED):
                made = attempt(normal, threshold, step)
                if 0.97 * budget <= made.error <= budget:
                    break
                step = rounded(step * float(np.clip(0.985 * budget / made.error, 1.0 / _FARTHEST, _FARTHEST)))
            importance = sharpen(importance, grid.errors(_values(made.numbers, made.step)), shape, OF_ROUNDED)
            normal = metric(grid, importance, _around(made.numbers))
        for scale in _SCAN:
            attempt(normal, threshold, rounded(step * float(scale)))
    return best, tried


def _around(numbers: Index) -> NDArray[np.bool_]:
    """Return the terms ``(classes, terms)`` that any class of ``numbers`` keeps, and one more of each run."""
    classes, _, first, _ = numbers.shape
    kept = (numbers != 0).any(axis=(0, 1))
    lengths = np.where(kept.any(axis=0), first - np.argmax(kept[::-1], axis=0), 0)
    return np.tile((np.arange(first)[:, np.newaxis] <= lengths).ravel(), (classes, 1))


def _values(numbers: Index, step: float) -> Array:
    return numbers.reshape(*numbers.shape[:2], -1).astype(np.float64) * step
