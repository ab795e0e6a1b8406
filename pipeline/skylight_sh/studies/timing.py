"""Timing that a shared machine does not spoil: CPU clocks, candidates in turn, medians with their spread, rounds dropped.

A round is judged by what stands outside of what is compared: a wall clock that went on while the thread had no processor,
and a fixed loop of arithmetic that took longer than in other rounds. No round is dropped for its own result.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

NOISY = 0.1
"""A figure whose middle half of rounds spreads by this share of it or more is flagged."""
FEWEST = 5
"""With fewer clean rounds than this all rounds count, and the figure is flagged."""
# What a wall clock may tell beyond the CPU clock: a share of a slice, and reading the clocks.
_WAITED_SHARE, _WAITED = 0.05, 5e-6
_SLOWER = 1.1
# Coarser clocks cannot time a call.
_FINE = 1e-6


@dataclass(frozen=True)
class Spread:
    """A figure over rounds: its ``median``, the quartiles ``low`` and ``high``, and how many of all rounds were ``kept``."""

    median: float
    low: float
    high: float
    kept: int

    @property
    def spread(self) -> float:
        """The interquartile range as a share of the median."""
        return (self.high - self.low) / abs(self.median) if self.median else float("inf")

    @property
    def noisy(self) -> bool:
        """Whether the figure is flagged: its spread reaches ``NOISY``, or fewer than ``FEWEST`` rounds were clean."""
        return self.kept < FEWEST or not self.spread < NOISY


def spread(values: ArrayLike, clean: ArrayLike | None = None) -> Spread:
    """Return the figure over rounds ``(n,)``, of those that are ``clean`` ``(n,)`` where they are enough, or else of all.

    Raises ValueError where there are no rounds.

    >>> spread([1.0, 2.0, 3.0, 4.0, 5.0, 90.0], [True] * 5 + [False])
    Spread(median=3.0, low=2.0, high=4.0, kept=5)
    """
    found = np.asarray(values, dtype=np.float64)
    if found.size == 0:
        raise ValueError("No rounds were timed. Time at least one.")
    mask = np.ones(found.shape, dtype=bool) if clean is None else np.asarray(clean, dtype=bool)
    kept = int(mask.sum())
    low, median, high = np.quantile(found[mask] if kept >= FEWEST else found, [0.25, 0.5, 0.75]).tolist()
    return Spread(median, low, high, kept)


def clean_slices(cpu: ArrayLike, wall: ArrayLike, ticks: ArrayLike) -> NDArray[np.bool_]:
    """Say which slices nothing disturbed, from CPU and wall seconds ``(rounds, candidates)`` and ``ticks`` ``(rounds,)``.

    A slice is disturbed where its wall clock went on without it, and with its whole round where the tick, a fixed loop of
    arithmetic, took a tenth longer than the first quartile of all ticks.

    >>> clean_slices([[1.0, 1.0], [1.0, 1.0]], [[1.0, 1.3], [1.0, 1.0]], [1.0, 1.0]).tolist()
    [[True, False], [True, True]]
    """
    own, told, beat = (np.asarray(a, dtype=np.float64) for a in (cpu, wall, ticks))
    waited = told - own > _WAITED_SHARE * np.abs(own) + _WAITED
    slowed = beat > _SLOWER * np.quantile(beat, 0.25)
    return np.asarray(~(waited | slowed[:, np.newaxis]))


def cpu_seconds() -> float:
    """Return the seconds that this thread has had a processor; a wall clock's where there is no fine one."""
    return time.thread_time() if time.get_clock_info("thread_time").resolution <= _FINE else time.perf_counter()


def rounds(calls: Mapping[str, Callable[[], object]], repeats: int, at_least: float = 0.0) -> dict[str, list[float]]:
    """Return each call's CPU seconds in ``repeats`` rounds after one warm-up; every round times all calls in turn.

    A call shorter than ``at_least`` seconds is repeated inside its round until it is not. Calls that start threads of their
    own are not for this.
    """
    loops: dict[str, int] = {}
    for name, call in calls.items():
        call()
        start = cpu_seconds()
        call()
        loops[name] = max(1, round(at_least / max(cpu_seconds() - start, 1e-9)))
    times: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(repeats):
        for name, call in calls.items():
            start = cpu_seconds()
            for _ in range(loops[name]):
                call()
            times[name].append((cpu_seconds() - start) / loops[name])
    return times


def medians(calls: Mapping[str, Callable[[], object]], repeats: int, at_least: float = 0.0) -> dict[str, float]:
    """Return each call's median of ``rounds``."""
    return {name: statistics.median(found) for name, found in rounds(calls, repeats, at_least).items()}


def ratios(base: Sequence[float], other: Sequence[float]) -> Spread:
    """Return how many times ``base`` takes as long as ``other``, round by round: what slows both slows neither.

    >>> ratios([2.0, 4.0, 6.0], [1.0, 2.0, 3.0]).median
    2.0
    """
    return spread([b / o for b, o in zip(base, other, strict=True)])


def exponent(sizes: Sequence[float], seconds: Sequence[float]) -> float:
    """Return the power p of ``seconds ~ sizes**p`` by least squares in logarithms.

    >>> round(exponent([1, 2, 4], [1, 4, 16]), 9)
    2.0
    """
    return float(np.polyfit(np.log(np.asarray(sizes)), np.log(np.asarray(seconds)), 1)[0])
