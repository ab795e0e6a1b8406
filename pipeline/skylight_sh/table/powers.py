"""A table's polynomials in powers of its variables instead of orthogonal functions: what Horner's scheme reads."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.polynomial import chebyshev, legendre
from numpy.typing import NDArray

from skylight_sh.formula.bases import BASES
from skylight_sh.runtime import ClassRows, Table, kept_terms

Array = NDArray[np.float64]

POWERS = "monomial"
_CONVERTERS: Mapping[str, Callable[[Any], Any]] = {"chebyshev": chebyshev.cheb2poly, "legendre": legendre.leg2poly}
# Coefficients' magnitudes may grow by this much on the way, and with them what rounding loses.
_GROWTH = 6.0


def in_powers(table: Table) -> Table:
    """Return ``table`` with rows of single precision in powers of the variables, as it is where that would cost precision.

    Magnitudes of the coefficients of one sum may add up to 6 times what they do in the table's own basis.
    """
    body, basis = table.body, table.spec.basis
    if not isinstance(body, ClassRows) or body.dtype != np.float32 or basis not in _CONVERTERS:
        return table
    matrices = [_conversion(basis, degree) for degree in table.degrees]
    before = [_spread(table, body, k) for k in range(len(body.lengths))]
    after = [_converted(dense, matrices) for dense in before]
    magnitudes = [max(float(np.abs(d).sum(axis=tuple(range(d.ndim - 1))).max()) for d in sides) for sides in (before, after)]
    if magnitudes[1] > _GROWTH * magnitudes[0]:
        return table
    flat = [dense.reshape(dense.shape[0], -1, dense.shape[-1]) for dense in after]
    kept = np.stack([np.any(dense != 0, axis=2) for dense in flat])
    # Of each run the last that is not 0.
    lengths = np.where(kept.any(axis=1), kept.shape[1] - np.argmax(kept[:, ::-1], axis=1), 0)
    rows = [
        dense.reshape(-1, dense.shape[-1])[kept_terms(length)].astype(np.float32)
        for dense, length in zip(flat, lengths, strict=True)
    ]
    return replace(
        table,
        spec=replace(table.spec, basis=POWERS),
        terms=tuple(BASES[POWERS].program(degree) for degree in table.degrees),
        body=ClassRows(lengths.astype(np.uint8), np.concatenate(rows), body.columns),
    )


def _conversion(basis: str, degree: int) -> Array:
    """Return of each function, a column, its coefficients of the powers, ``(degree+1, degree+1)``."""
    columns = [_CONVERTERS[basis](np.eye(degree + 1)[k, : k + 1]) for k in range(degree + 1)]
    return np.stack([np.pad(np.atleast_1d(c), (0, degree + 1 - np.size(c))) for c in columns], axis=1)


def _spread(table: Table, body: ClassRows, k: int) -> Array:
    """Return the coefficients of class ``k`` with zeros where it keeps none, ``(d_1+1, .., d_D+1, width)``."""
    start, end = body.starts[k : k + 2]
    sizes = [degree + 1 for degree in table.degrees]
    dense = np.zeros((int(np.prod(sizes)), body.rows.shape[1]))
    dense[kept_terms(body.lengths[k])] = body.rows[start:end]
    return dense.reshape(*sizes, -1)


def _converted(dense: Array, matrices: list[Array]) -> Array:
    """Return ``dense`` with each axis converted, sums in a fixed order."""
    for axis, matrix in enumerate(matrices):
        moved = np.moveaxis(dense, axis, 0)
        out = np.zeros_like(moved)
        for column, part in zip(matrix.T, moved, strict=True):
            for place in np.flatnonzero(column):
                out[place] += column[place] * part
        dense = np.moveaxis(out, 0, axis)
    return np.ascontiguousarray(dense)
