"""The fast body of a table: for each class a row of coefficients a term, one column an output.

All outputs of a class keep the same terms, so that an evaluation is a sum of rows, each times one number: no reduction, no
index.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from skylight_sh.runtime import ClassRows, Rows, Table, kept_terms

Floats = NDArray[np.floating]
Lengths = NDArray[np.integer]


def arrange(dense: Floats, lengths: Lengths, columns: NDArray[np.int16], dtype: str) -> ClassRows:
    """Make rows of ``dense`` ``(classes, count, first, rest)``, with ``lengths`` ``(classes, rest)`` terms."""
    used = columns >= 0
    rows = [
        own.reshape(len(own), -1)[used][:, kept_terms(length)].T.astype(dtype)
        for own, length in zip(dense, lengths, strict=True)
    ]
    return ClassRows(lengths.astype(np.uint8), np.concatenate(rows), columns)


def by_class(table: Table) -> Table:
    """Return ``table`` with each class's own rows, where an earlier version wrote one row for all channels."""
    body = table.body
    if not isinstance(body, Rows):
        return table
    used = body.columns[0] >= 0
    columns = np.where(used, np.cumsum(used) - 1, -1).astype(np.int16)
    rows = np.concatenate([body.rows[:, own[used]] for own in body.columns])
    return replace(table, body=ClassRows(np.tile(body.lengths, (len(body.columns), 1)), rows, columns))


def used_degrees(lengths: Lengths, degrees: Sequence[int]) -> tuple[int, ...]:
    """Return the largest degree that ``lengths`` ``(rest,)`` keep on every axis; ``degrees`` are those of ``rest``.

    >>> used_degrees(np.array([4, 2, 0]), [9, 2])
    (3, 1)
    """
    shape = [d + 1 for d in degrees[1:]]
    kept = np.nonzero(np.reshape(lengths, shape)) if shape else ()
    return (max(1, int(np.max(lengths))) - 1, *(int(np.max(index, initial=0)) for index in kept))
