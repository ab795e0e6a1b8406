"""The order of a table's outputs in a row: what lets the C code add, turn and store four at a time."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.runtime import Specification
from skylight_sh.sphere import Harmonics

Place = tuple[int, int, int]
_FOUR = 4
_PAD = 8


@dataclass(frozen=True)
class RowLayout:
    """``places``: the (degree l, channel, order m) of every column, or None for padding.

    ``widths`` ``(bands,)``: how many columns the first 1, 2, .. bands take; columns of a band follow those of the
    bands before it, but for some that fill gaps.
    """

    places: tuple[Place | None, ...]
    widths: tuple[int, ...]

    def columns(self, harmonics: Harmonics, channels: int) -> NDArray[np.int64]:
        """Return each stored weight's column, ``(channels, count)``; -1 where its degree carries nothing."""
        found = {place: column for column, place in enumerate(self.places) if place}
        degrees, orders = harmonics.degrees.tolist(), harmonics.orders.tolist()
        return np.array([[found.get((l, c, m), -1) for l, m in zip(degrees, orders, strict=True)] for c in range(channels)])


def stored(spec: Specification, bands: int) -> Harmonics:
    """Return which SH weights a table of ``bands`` bands stores."""
    return Harmonics(bands, spec.mirrored)


def carried(quantity: str, bands: int) -> tuple[int, ...]:
    """Return the degrees l that carry any of ``quantity``: all, or l = 1 and the even ones for diffuse irradiance.

    >>> carried("irradiance", 7)
    (0, 1, 2, 4, 6)
    """
    return tuple(l for l in range(bands) if quantity == "radiance" or l == 1 or l % 2 == 0)


def layout(spec: Specification, bands: int) -> RowLayout:
    """Lay out the outputs of a table of ``bands`` bands that carry anything.

    Where orders m < 0 are not stored, every run m = 0..l of one band and channel splits into a remainder m < (l+1) % 4
    and fours that start at multiples of 4, which a compiler turns by the azimuth and stores as one vector. Gaps before
    a four are filled with remainders of later bands, so that little is padding.
    """
    places: list[Place | None] = []
    kept, channels = carried(spec.quantity, bands), len(spec.channels)
    if spec.mirrored:
        rest = [(l, c, m) for l in kept for c in range(channels) for m in range((l + 1) % _FOUR)]
        for l in kept:
            while rest and rest[0][0] <= l:
                places.append(rest.pop(0))
            for c in range(channels):
                for start in range((l + 1) % _FOUR, l + 1, _FOUR):
                    while len(places) % _FOUR:
                        places.append(rest.pop(0) if rest else None)
                    places += [(l, c, start + k) for k in range(_FOUR)]
    else:
        places += [(l, c, m) for l in kept for c in range(channels) for m in range(-l, l + 1)]
    places += [None] * (-len(places) % _PAD)
    last = [max(k for k, place in enumerate(places) if place and place[0] < b) for b in range(1, bands + 1)]
    return RowLayout(tuple(places), tuple(-(-(k + 1) // _PAD) * _PAD for k in last))
