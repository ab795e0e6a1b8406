"""The fast body of a table: one row of coefficients a term, one column an output, in the order of ``layout``.

All outputs keep the same terms, so that an evaluation is a sum of rows, each times one number: no reduction, no index.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.floating]
Lengths = NDArray[np.integer]


@dataclass(frozen=True)
class Rows:
    """``rows`` ``(terms, columns)``; ``lengths`` ``(rest,)``: terms of the first axis for each product of the others'.

    Terms run over ``rest`` (the other axes' powers, last axis fastest), then over the first axis.
    """

    lengths: NDArray[np.uint8]
    rows: Floats

    @property
    def kind(self) -> str:
        """Name of this body in files."""
        return "rows"

    @property
    def dtype(self) -> np.dtype[np.floating]:
        """Number type of coefficients and arithmetic."""
        return self.rows.dtype

    @property
    def numbers(self) -> int:
        """How many coefficients are stored, padding included."""
        return int(self.rows.size)


def terms(lengths: Lengths) -> NDArray[np.int64]:
    """Return the kept terms' places in a dense ``(first, rest)`` array, in the order of ``Rows``: ``(terms,)``."""
    rest = lengths.size
    return np.concatenate([np.arange(int(n)) * rest + r for r, n in enumerate(lengths)]).astype(np.int64)


def arrange(dense: Floats, lengths: Lengths, columns: NDArray[np.int64], width: int, dtype: str) -> Rows:
    """Make rows of ``dense`` ``(channels, count, first, rest)``, whose columns are ``(channels, count)`` of ``width``."""
    kept = terms(lengths)
    flat = dense.reshape(*dense.shape[:2], -1)[..., kept]
    rows = np.zeros((kept.size, width), dtype=dtype)
    placed = columns.ravel() >= 0
    rows[:, columns.ravel()[placed]] = flat.reshape(-1, kept.size).T[:, placed].astype(dtype)
    return Rows(lengths.astype(np.uint8), rows)


def used_degrees(lengths: Lengths, degrees: Sequence[int]) -> tuple[int, ...]:
    """Return the largest degree that ``lengths`` ``(rest,)`` keep on every axis; ``degrees`` are those of ``rest``."""
    shape = [d + 1 for d in degrees[1:]]
    kept = np.nonzero(np.reshape(lengths, shape)) if shape else ()
    return (max(1, int(np.max(lengths))) - 1, *(int(np.max(index, initial=0)) for index in kept))
