"""Timing that a shared machine does not spoil: warm-up, medians, and candidates in turn."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Mapping, Sequence


def medians(calls: Mapping[str, Callable[[], object]], repeats: int, at_least: float = 0.0) -> dict[str, float]:
    """Return each call's median seconds over ``repeats`` rounds after one warm-up; every round times all calls in turn.

    A call shorter than ``at_least`` seconds is repeated inside its round until it is not.
    """
    loops: dict[str, int] = {}
    for name, call in calls.items():
        call()
        start = time.perf_counter()
        call()
        loops[name] = max(1, round(at_least / max(time.perf_counter() - start, 1e-9)))
    times: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(repeats):
        for name, call in calls.items():
            start = time.perf_counter()
            for _ in range(loops[name]):
                call()
            times[name].append((time.perf_counter() - start) / loops[name])
    return {name: statistics.median(found) for name, found in times.items()}


def exponent(sizes: Sequence[float], seconds: Sequence[float]) -> float:
    """Return the power p of ``seconds ~ sizes**p`` by least squares in logarithms."""
    import numpy as np

    return float(np.polyfit(np.log(np.asarray(sizes)), np.log(np.asarray(seconds)), 1)[0])
