"""Packed tables beside the entropy of their own numbers: how many bytes another coder could still save."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from skylight_sh.runtime import Packed, Table, unpack
from skylight_sh.studies import outcomes
from skylight_sh.studies.page import Row, Section
from skylight_sh.table.bits import zigzag
from skylight_sh.table.size import bytes_of

Array = NDArray[np.float64]
Index = NDArray[np.int64]

TEXT = (
    "The whole numbers of each packed table, and the bits that an ideal coder of single numbers would take for them. How "
    "large a number is follows its place: an additive model of the logarithm by degree and place in its run, by product of "
    "the other axes' functions and by channel, like the table's own profiles. Numbers of one expected size (in half bits) "
    "share a distribution; `entropy` is the sum of their entropies, with the correction of Miller and Madow for few "
    "samples, and of the runs' lengths. Neither profiles nor distributions are charged for, so that no coder of single "
    "numbers gets there. `over` is the stream, profiles in it, over that; below 0 the correction exceeds what few numbers "
    "can tell."
)
_ROUNDS = 8
# High parts are told apart down to this many bits below a number's expected size; what is lower is noise.
_FINE = 3


def section(tables: Mapping[str, Table]) -> Section:
    """Measure every packed table."""
    rows: list[Row] = []
    for name, table in tables.items():
        if isinstance(table.body, Packed):
            degrees = np.sqrt(table.places).astype(np.int64)
            bound = bits(unpack(table.body, table.places), degrees) / 8
            stream = len(table.body.stream)
            rows.append(
                {
                    "table": name,
                    "bytes": bytes_of(table),
                    "stream": stream,
                    "entropy": bound,
                    "over": stream / bound - 1,
                    "constants": bytes_of(table) - stream,
                }
            )
    return Section("entropy", "Packed bytes over the measured entropy", TEXT, rows, told=outcomes.packed(rows))


def bits(numbers: Index, degrees: Index) -> float:
    """Return the bits of entropy of whole numbers ``(count, channels, first, rest)`` of weights of ``degrees`` ``(count,)``.

    Runs along the first axis end at their last number that is not 0; their lengths are told from one weight to the next.
    """
    used = numbers != 0
    lengths = np.where(used.any(axis=2), numbers.shape[2] - np.argmax(used[:, :, ::-1], axis=2), 0)
    weight, channel, place, rest = np.nonzero(np.arange(numbers.shape[2])[:, np.newaxis] < lengths[:, :, np.newaxis])
    folded = zigzag(numbers[weight, channel, place, rest])
    steps = zigzag(np.diff(lengths, axis=0, prepend=np.zeros_like(lengths[:1]))).ravel()
    expected = _expected(folded, [degrees[weight] * numbers.shape[2] + place, rest, channel])
    total = entropy(steps)
    for level in np.unique(expected).tolist():
        low = max((level >> 1) - _FINE, 0)
        mine = folded[expected == level]
        total += entropy(mine >> low) + low * mine.size
    return total


def entropy(symbols: Index) -> float:
    """Return the bits of all symbols by their own frequencies, with half a bit (in nats) for each but one that occurs.

    >>> round(entropy(np.array([0, 1] * 500)) - 1000, 3)  # 1 / (2 ln 2)
    0.721
    """
    counts = np.unique(symbols, return_counts=True)[1]
    plain = float((counts * np.log2(symbols.size / counts)).sum()) if symbols.size else 0.0
    return plain + (max(counts.size, 1) - 1) / (2 * math.log(2))


def _expected(folded: Index, indices: list[Index]) -> Index:
    """Return each number's expected size in half bits, by an additive model of logarithms over ``indices``."""
    logarithms = 2 * np.log2(folded + 1.0)
    parts = [np.zeros(int(index.max(initial=0)) + 1) for index in indices]
    for _ in range(_ROUNDS):
        for i, index in enumerate(indices):
            others = sum((part[at] for j, (part, at) in enumerate(zip(parts, indices, strict=True)) if j != i), np.zeros(1))
            number = np.maximum(np.bincount(index, minlength=parts[i].size), 1)
            parts[i] = np.bincount(index, logarithms - others, parts[i].size) / number
    model: Array = sum((part[at] for part, at in zip(parts, indices, strict=True)), np.zeros(folded.size))
    return np.maximum(np.rint(model), 0).astype(np.int64)
