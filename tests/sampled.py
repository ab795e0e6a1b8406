"""Samples as a fit sees them, for tests: plain ones, whose classes are their channels."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from skylight_sh.fit.sampled import Sampled

Array = NDArray[np.float64]


def plain(basis: Array, truth: Array) -> Sampled:
    """Return samples of ``truth`` ``(n, channels, count)`` in a ``basis`` ``(n, terms)``, each channel a class."""
    count, channels, outputs = truth.shape
    factor = np.tile(np.eye(channels), (count, 1, 1))
    return Sampled(basis, factor, truth, np.ones(count), np.zeros(outputs, dtype=np.int64))
