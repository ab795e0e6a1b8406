"""The packed layout: a table's whole numbers as one stream of Rice codes, read in one forward loop.

Everything a reader needs beside the stream: the number of bands, which orders are stored, the channels, the basis sizes
of the axes, ``rest_profile`` (one small whole number a product of the other axes' powers), ``channel_profile`` (one a
channel) and the step. The stream, low bit of each byte first, is for each band in turn:

1. 5 bits, ``used``: the longest run of the band. Then ``used`` times 5 bits: the band's profile.
2. For each weight of the band in flat order, for each channel, for each product ``r`` of the other axes' powers:
   - the run's length as its difference from the same channel's and product's length at the weight before (0 at the
     start): a Rice code without low bits;
   - that many coefficients of the first axis, Rice codes of ``k = max(0, profile[i] + rest_profile[r] +
     channel_profile[channel]) >> 1`` low bits.

A Rice code of k low bits is a folded number u (0, -1, 1, -2 -> 0, 1, 2, 3): ``u >> k`` ones, a zero, the low k bits.
Profiles count half bits: they say how large coefficients are on average, and only the length of the code depends on
how well. A prefix of the stream serves fewer bands: nothing refers forward.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.runtime import Packed
from skylight_sh.table.bits import Writer, rice_bits, zigzag

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_FIELD = 5
_LARGEST = (1 << _FIELD) - 1
_LARGEST_NUMBER = (1 << 30) - 1
_ROUNDS = 6
# A typical number's folded magnitude exceeds the best Rice divisor by this many half bits.
_ABOVE_DIVISOR = 1.2
_STEPS = np.array([0, -1, 1, -2, 2])


@dataclass(frozen=True)
class _Runs:
    """Numbers to write, flat, with each one's band, place in the run, rest and channel; and the runs' lengths."""

    folded: Index
    band: Index
    place: Index
    rest: Index
    channel: Index
    lengths: Index


def lengths_of(numbers: Index) -> Index:
    """Return how many numbers of the first axis stand before the last one that is not 0: ``(count, channels, rest)``.

    >>> lengths_of(np.array([5, 0, 2, 0]).reshape(1, 1, 4, 1)).tolist()
    [[[3]]]
    """
    kept = numbers != 0
    return np.where(kept.any(axis=2), numbers.shape[2] - np.argmax(kept[:, :, ::-1], axis=2), 0)


def _lay_out(numbers: Index, degrees: Index) -> _Runs:
    first = numbers.shape[2]
    lengths = lengths_of(numbers)
    # Products of powers that no weight uses are not part of the table.
    used = 1 + int(np.max(np.nonzero(lengths.any(axis=(0, 1)))[0], initial=0))
    lengths = lengths[:, :, :used]
    inside = np.arange(first)[:, np.newaxis] < lengths[:, :, np.newaxis, :]
    weight, channel, place, rest = np.nonzero(inside)
    return _Runs(zigzag(numbers[..., :used][inside]), degrees[weight], place, rest, channel, lengths)


@dataclass(frozen=True)
class _Profiles:
    band: Index
    rest: Index
    channel: Index

    def low_bits(self, layout: _Runs) -> Index:
        total = self.band[layout.band, layout.place] + self.rest[layout.rest] + self.channel[layout.channel]
        return np.asarray(np.maximum(total, 0) >> 1)


def _profiles(layout: _Runs, first: int) -> _Profiles:
    """Fit the profiles: an additive model of the numbers' logarithms, then each entry moved while bits are saved."""
    bands = int(layout.band.max(initial=0)) + 1
    shapes = ((bands, first), (layout.lengths.shape[2],), (layout.lengths.shape[1],))
    indices = (layout.band * first + layout.place, layout.rest, layout.channel)
    sizes = tuple(int(np.prod(shape)) for shape in shapes)
    # Rounded, since libraries' logarithms differ in the last bit and a profile's entry hangs on it.
    logarithms = np.ldexp(np.rint(np.ldexp(np.log2(layout.folded + 1.0), 25)), -24)
    means = [np.zeros(size) for size in sizes]
    for _ in range(_ROUNDS):
        for a, (index, size) in enumerate(zip(indices, sizes, strict=True)):
            others = sum((means[b][indices[b]] for b in range(3) if b != a), start=np.zeros(index.size))
            number = np.maximum(np.bincount(index, minlength=size), 1)
            means[a] = np.bincount(index, logarithms - others, size) / number
    # The band profiles are stored without a sign; what that shifts goes to the channels.
    means[0] -= _ABOVE_DIVISOR
    shift = min(float(means[0][np.unique(indices[0])].min(initial=0.0)), 0.0)
    entries = [np.rint(means[0] - shift), np.rint(means[1]), np.rint(means[2] + shift)]
    whole = [np.clip(entries[0], 0, _LARGEST).astype(np.int64), *(e.astype(np.int64) for e in entries[1:])]
    for _ in range(_ROUNDS):
        for a, (index, size) in enumerate(zip(indices, sizes, strict=True)):
            now = sum((whole[b][indices[b]] for b in range(3)), start=np.zeros(index.size, dtype=np.int64))
            costs = [np.bincount(index, rice_bits(layout.folded, np.maximum(now + d, 0) >> 1), size) for d in _STEPS]
            whole[a] = whole[a] + _STEPS[np.argmin(costs, axis=0)]
            if a == 0:
                whole[0] = np.clip(whole[0], 0, _LARGEST)
    return _Profiles(whole[0].reshape(shapes[0]), whole[1], whole[2])


def _used(layout: _Runs, degrees: Index) -> Index:
    longest = layout.lengths.max(axis=(1, 2), initial=0)
    return np.array([longest[degrees == band].max() for band in range(int(degrees.max()) + 1)])


def cost(numbers: Index, degrees: Index) -> int:
    """Return the bytes that ``pack`` would take, without packing."""
    layout = _lay_out(numbers, degrees)
    profiles = _profiles(layout, numbers.shape[2])
    steps = np.diff(layout.lengths, axis=0, prepend=np.zeros_like(layout.lengths[:1]))
    bits = int(rice_bits(layout.folded, profiles.low_bits(layout)).sum()) + int((zigzag(steps) + 1).sum())
    bits += int((_FIELD * (_used(layout, degrees) + 1)).sum())
    return (bits + 7) // 8 + profiles.rest.size + profiles.channel.size


def pack(numbers: Index, degrees: Index, step: float = 1.0) -> Packed:
    """Pack whole numbers ``(count, channels, first, rest)`` of weights in flat order, ``degrees`` ``(count,)`` rising.

    Raises ValueError where the first axis has more terms than a length field holds, or a number is no C ``int`` once folded.

    >>> from skylight_sh.runtime import unpack
    >>> numbers = np.array([[[[7], [-2], [0]]]])
    >>> unpack(pack(numbers, np.array([0])), np.array([0])).ravel().tolist()
    [7, -2]
    """
    if numbers.shape[2] > _LARGEST:
        raise ValueError(f"A packed table holds at most {_LARGEST} terms of its first axis, not {numbers.shape[2]}.")
    if numbers.size and np.abs(numbers).max() > _LARGEST_NUMBER:
        raise ValueError(f"A packed table holds whole numbers up to {_LARGEST_NUMBER}, not {np.abs(numbers).max()}.")
    layout = _lay_out(numbers, degrees)
    profiles = _profiles(layout, numbers.shape[2])
    used = _used(layout, degrees)
    writer = Writer()
    before = np.zeros_like(layout.lengths[0])
    for w, band in enumerate(degrees.tolist()):
        if w == 0 or band != degrees[w - 1]:
            writer.fixed(int(used[band]), _FIELD)
            for i in range(int(used[band])):
                writer.fixed(int(profiles.band[band, i]), _FIELD)
        for channel, rest in np.ndindex(*before.shape):
            length = int(layout.lengths[w, channel, rest])
            writer.rice(length - int(before[channel, rest]), 0)
            for i in range(length):
                level = int(profiles.band[band, i] + profiles.rest[rest] + profiles.channel[channel])
                writer.rice(int(numbers[w, channel, i, rest]), max(level, 0) >> 1)
        before = layout.lengths[w]
    return Packed(writer.bytes(), max(1, int(used.max())), profiles.rest, profiles.channel, step)
