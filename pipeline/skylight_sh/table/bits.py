"""Whole numbers as bits, least significant bit of each byte first: fixed widths, unary counts and Rice codes.

``runtime.BitReader`` reads them back.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Index = NDArray[np.int64]


def zigzag(values: Index) -> Index:
    """Map 0, -1, 1, -2, .. to 0, 1, 2, 3, ...

    >>> zigzag(np.array([0, -1, 1, -2])).tolist()
    [0, 1, 2, 3]
    """
    return np.where(values >= 0, 2 * values, -2 * values - 1)


def rice_bits(folded: Index, low_bits: Index) -> Index:
    """Return how many bits a Rice code takes: ``folded >> low_bits`` ones, a zero, ``low_bits`` bits.

    >>> rice_bits(np.array([0, 3, 9]), np.array([1, 1, 1])).tolist()
    [2, 3, 6]
    """
    return 1 + low_bits + (folded >> low_bits)


class Writer:
    """Appends numbers to a string of bits.

    >>> from skylight_sh.runtime import BitReader
    >>> writer = Writer()
    >>> writer.rice(-3, 1)
    >>> BitReader(writer.bytes()).rice(1)
    -3
    """

    def __init__(self) -> None:
        self._bits: list[int] = []

    def fixed(self, value: int, width: int) -> None:
        """Write ``value``, at least 0, in ``width`` bits, low bit first."""
        self._bits.extend((value >> i) & 1 for i in range(width))

    def rice(self, value: int, low_bits: int) -> None:
        """Write a signed number: its folded high part as that many ones and a zero, then its low bits."""
        folded = 2 * value if value >= 0 else -2 * value - 1
        self._bits.extend([1] * (folded >> low_bits) + [0])
        self.fixed(folded & ((1 << low_bits) - 1), low_bits)

    def bytes(self) -> bytes:
        """Return what was written, the last byte filled up with zeros."""
        return np.packbits(np.array(self._bits, dtype=np.uint8), bitorder="little").tobytes()
