"""Parameter sets: grids, seeded random sets, and their split into chunks that share quadrature nodes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.int64]


def grid(nodes: Sequence[Array]) -> Array:
    """Return all combinations of one value per axis, first axis slowest: shape ``(sets, axes)``."""
    return np.stack(np.meshgrid(*nodes, indexing="ij"), axis=-1).reshape(-1, len(nodes))


def random(ranges: Sequence[tuple[float, float]], count: int, seed: int) -> Array:
    """Return ``count`` uniform random sets inside ``ranges``, shape ``(count, axes)``; the seed decides them."""
    low, high = np.array(ranges, dtype=np.float64).T
    return np.asarray(low + (high - low) * np.random.default_rng(seed).random((count, len(ranges))))


def chunks(sets: Array, shared: int | None, size: int) -> list[Index]:
    """Split sets into blocks of indices ``(g, k)`` whose rows agree on the axis ``shared``.

    ``sets`` has shape ``(n, axes)``. Every set is in exactly one block of at most ``size`` sets, and the blocks
    depend on the sets alone, never on who works on them. ``shared=None``: all sets may share nodes.
    """
    if size < 1:
        raise ValueError(f"Invalid chunk size {size}. Should be at least 1.")
    values = np.zeros(len(sets)) if shared is None else sets[:, shared]
    order = np.argsort(values, kind="stable").astype(np.int64)
    starts = np.flatnonzero(np.diff(values[order], prepend=np.nan) != 0)
    rows = [row[i : i + size] for row in np.split(order, starts[1:]) for i in range(0, row.size, size)]
    by_length: dict[int, list[Index]] = {}
    for row in rows:
        by_length.setdefault(row.size, []).append(row)
    blocks = []
    for length, group in sorted(by_length.items()):
        step = max(1, size // length)
        blocks += [np.stack(group[i : i + step]) for i in range(0, len(group), step)]
    return blocks
