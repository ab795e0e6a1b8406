"""The fast body of a table: one row of coefficients a term, one column an output, in the order of ``row_layout``.

All outputs keep the same terms, so that an evaluation is a sum of rows, each times one number: no reduction, no index.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from skylight_sh.runtime import Rows, kept_terms

Floats = NDArray[np.floating]
Lengths = NDArray[np.integer]


def arrange(dense: Floats, lengths: Lengths, columns: NDArray[np.int64], width: int, dtype: str) -> Rows:
    """Make rows of ``dense`` ``(channels, count, first, rest)``, whose columns are ``(channels, count)`` of ``width``."""
    kept = kept_terms(lengths)
    flat = dense.reshape(*dense.shape[:2], -1)[..., kept]
    rows = np.zeros((kept.size, width), dtype=dtype)
    placed = columns.ravel() >= 0
    rows[:, columns.ravel()[placed]] = flat.reshape(-1, kept.size).T[:, placed].astype(dtype)
    return Rows(lengths.astype(np.uint8), rows, columns.astype(np.int16))


def used_degrees(lengths: Lengths, degrees: Sequence[int]) -> tuple[int, ...]:
    """Return the largest degree that ``lengths`` ``(rest,)`` keep on every axis; ``degrees`` are those of ``rest``.

    >>> used_degrees(np.array([4, 2, 0]), [9, 2])
    (3, 1)
    """
    shape = [d + 1 for d in degrees[1:]]
    kept = np.nonzero(np.reshape(lengths, shape)) if shape else ()
    return (max(1, int(np.max(lengths))) - 1, *(int(np.max(index, initial=0)) for index in kept))
