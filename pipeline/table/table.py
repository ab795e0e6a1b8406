"""A table: the polynomial coefficients of a light's SH weights, and their evaluation in the table's own arithmetic."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from pipeline import sphere
from pipeline.fit.axes import Axis
from pipeline.fit.bases import BASES
from pipeline.light import PREFACTORS

Array = NDArray[np.float64]
Floats = NDArray[np.floating]

_SETS_AT_ONCE = 2048
# Beyond this share of the range (or of 1, if that is more) an input counts as outside: float32 pi/2 exceeds pi/2.
SLACK = 1e-6


@dataclass(frozen=True)
class Table:
    """Polynomial coefficients of SH weights over named axes.

    ``lengths`` ``(count, channels, rest)`` says how many coefficients of the first axis each product of the other
    axes' powers has; ``coefficients`` holds them one after another in that order, so that a prefix serves fewer
    bands. ``degrees`` are the largest ones, an axis; ``rest`` is the product of ``degree + 1`` over all but the first.
    ``count`` is N(N+1)/2 where ``mirrored`` (m >= 0 alone), else N*N. ``prefactor`` is a name and its constants, or
    None. ``provenance`` is JSON-like and says where the table comes from.
    """

    axes: tuple[Axis, ...]
    channels: tuple[str, ...]
    bands: int
    mirrored: bool
    basis: str
    degrees: tuple[int, ...]
    lengths: NDArray[np.uint8]
    coefficients: Floats
    prefactor: tuple[str, tuple[float, ...]] | None = None
    provenance: Mapping[str, object] = field(default_factory=dict)

    @property
    def dtype(self) -> np.dtype[np.floating]:
        """Number type of the coefficients and of the arithmetic."""
        return self.coefficients.dtype

    @property
    def bytes(self) -> int:
        """Size of every constant an evaluation reads: coefficients, lengths, axes, prefactor, numbers in the code."""
        return self.bytes_at(self.bands)

    def bytes_at(self, bands: int) -> int:
        """Size of what the first ``bands`` bands alone need: a table of fewer bands is a prefix of this one."""
        count = sphere.count(bands, mirrored=self.mirrored)
        numbers = int(self.lengths[:count].sum()) + sum(2 + len(axis.constants) for axis in self.axes)
        if self.prefactor:
            name, constants = self.prefactor
            numbers += len(constants) + PREFACTORS[name].literals
        lengths = 0 if self.is_rectangular else self.lengths[:count].nbytes
        return lengths + numbers * self.dtype.itemsize

    @property
    def is_rectangular(self) -> bool:
        """Whether every weight keeps every power, so that no lengths need to be stored."""
        return bool(np.all(self.lengths == self.degrees[0] + 1))

    @cached_property
    def _dense(self) -> Floats:
        """Coefficients with dropped ones as zeros: ``(terms, count * channels)``, first axis slowest."""
        first = self.degrees[0] + 1
        kept = np.arange(first) < self.lengths[..., np.newaxis]
        full = np.zeros(kept.shape, dtype=self.dtype)
        full[kept] = self.coefficients
        return np.ascontiguousarray(np.moveaxis(full, -1, 0).swapaxes(1, 3).reshape(first * self.lengths.shape[2], -1))

    def evaluate(self, values: Array) -> Floats:
        """Return the stored weights at parameter sets ``(n, axes)``, azimuth 0: ``(n, channels, count)``.

        Works in the table's dtype throughout. Values must lie in the axes' ranges.
        """
        count, channels = self.lengths.shape[:2]
        out = np.empty((len(values), channels, count), dtype=self.dtype)
        for start in range(0, len(values), _SETS_AT_ONCE):
            part = values[start : start + _SETS_AT_ONCE].astype(self.dtype)
            product = products(self.basis, self.axes, part, self.degrees)
            sums = (product @ self._dense).reshape(len(part), channels, count)
            if self.prefactor:
                name, constants = self.prefactor
                named = {axis.name: part[:, i] for i, axis in enumerate(self.axes)}
                sums *= PREFACTORS[name].evaluate(named, constants)[:, np.newaxis, np.newaxis].astype(self.dtype)
            out[start : start + _SETS_AT_ONCE] = sums
        return out

    def clamp(self, values: Array) -> tuple[Array, NDArray[np.bool_]]:
        """Clamp ``(n, axes)`` to the ranges; the second result marks sets with a value beyond the slack."""
        low = np.array([axis.low for axis in self.axes])
        high = np.array([axis.high for axis in self.axes])
        slack = SLACK * np.maximum(high - low, 1.0)
        outside = np.any((values < low - slack) | (values > high + slack), axis=-1)
        return np.clip(values, low, high), outside


def products(basis: str, axes: Sequence[Axis], values: Floats, degrees: Sequence[int]) -> Floats:
    """Return all products of one basis function an axis: ``(n, terms)``, first axis slowest, in the values' dtype."""
    out = np.ones((len(values), 1), dtype=values.dtype)
    for i, (axis, degree) in enumerate(zip(axes, degrees, strict=True)):
        vander = BASES[basis].vander(axis.scaled(values[:, i]), degree)
        out = (out[:, :, np.newaxis] * vander[:, np.newaxis, :]).reshape(len(values), -1)
    return out


def pack(
    dense: Array,
    lengths: NDArray[np.integer],
    *,
    axes: tuple[Axis, ...],
    channels: tuple[str, ...],
    bands: int,
    mirrored: bool,
    basis: str,
    dtype: str,
    prefactor: tuple[str, tuple[float, ...]] | None,
) -> Table:
    """Make a table of coefficients ``(channels, count, d_1+1, .., d_D+1)``, keeping ``lengths`` of the first axis.

    ``lengths`` has shape ``(channels, count, d_2+1, .., d_D+1)``; powers that no weight keeps are dropped.
    """
    used = [1 + int(np.max(np.nonzero(lengths)[axis], initial=0)) for axis in range(2, lengths.ndim)]
    first = max(1, int(lengths.max()))
    lengths = lengths[(slice(None), slice(None), *(slice(u) for u in used))]
    dense = dense[(slice(None), slice(None), slice(first), *(slice(u) for u in used))]
    last = np.moveaxis(dense, 2, -1).swapaxes(0, 1).reshape(lengths.shape[1], lengths.shape[0], -1, first)
    counts = lengths.swapaxes(0, 1).reshape(last.shape[:3]).astype(np.uint8)
    return Table(
        axes=axes,
        channels=channels,
        bands=bands,
        mirrored=mirrored,
        basis=basis,
        degrees=(first - 1, *(u - 1 for u in used)),
        lengths=counts,
        coefficients=last[np.arange(first) < counts[..., np.newaxis]].astype(dtype),
        prefactor=prefactor,
    )


def full_weights(table: Table, stored: Floats, bands: int) -> Floats:
    """Spread stored weights over all N*N of the first ``bands`` bands: ``(n, channels, bands**2)``."""
    cut = stored[..., : sphere.count(bands, mirrored=table.mirrored)]
    return sphere.unmirror(cut, bands) if table.mirrored else cut
