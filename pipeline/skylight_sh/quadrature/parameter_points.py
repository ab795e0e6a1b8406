"""Parameter sets: grids, seeded random and held-out sets, and their split into chunks that share quadrature nodes."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from skylight_sh.quadrature import sobol

Array = NDArray[np.float64]
Index = NDArray[np.int64]


def grid(nodes: Sequence[Array]) -> Array:
    """Return all combinations of one value per axis, first axis slowest: shape ``(sets, axes)``.

    >>> grid([np.array([0.0, 1.0]), np.array([2.0, 3.0])]).tolist()
    [[0.0, 2.0], [0.0, 3.0], [1.0, 2.0], [1.0, 3.0]]
    """
    return np.stack(np.meshgrid(*nodes, indexing="ij"), axis=-1).reshape(-1, len(nodes))


def random(
    ranges: Sequence[tuple[float, float]], count: int, seed: int, *, shared: int | None = None, each: int = 1
) -> Array:
    """Return ``count`` uniform random sets inside ``ranges``, shape ``(count, axes)``; the seed decides them.

    Of every ``each`` sets in turn all have the first one's value on the axis ``shared``, if there is one.

    >>> random([(0.0, 1.0), (2.0, 3.0)], 5, seed=1).shape
    (5, 2)
    >>> len(set(random([(0.0, 1.0), (2.0, 3.0)], 5, seed=1, shared=0, each=2)[:, 0].tolist()))
    3
    """
    low, high = np.array(ranges, dtype=np.float64).T
    unit = np.random.default_rng(seed).random((count, len(ranges)))
    if shared is not None:
        unit[:, shared] = np.repeat(unit[::each, shared], each)[:count]
    return np.asarray(low + (high - low) * unit)


def held_out(ranges: Sequence[tuple[float, float]], count: int, edge: int, seed: int) -> Array:
    """Return ``count`` scrambled Sobol sets, ``edge`` more on each edge of the ranges, and the corners: ``(n, axes)``.

    An edge holds one axis at an end of its range while the others are a Sobol sequence of their own. Axes of no width
    and, of a single axis, edges (they are its corners) add nothing. The seed decides all.

    >>> held_out([(0.0, 1.0), (2.0, 3.0)], 8, 4, seed=1).shape
    (28, 2)
    """
    low, high = np.array(ranges, dtype=np.float64).T
    axes = len(ranges)
    wide = np.flatnonzero(high > low).tolist()
    parts = [_sobol(axes, count, seed)]
    for place, axis in enumerate(wide if len(wide) > 1 else ()):
        for end in (0.0, 1.0):
            others = _sobol(axes - 1, edge, seed + 1 + 2 * place + int(end))
            parts.append(np.insert(others, axis, end, axis=1))
    ends = [(0.0, 1.0) if axis in wide else (0.0,) for axis in range(axes)]
    parts.append(np.array(list(itertools.product(*ends))))
    unit = np.concatenate(parts)
    # An end of the range is met to the last bit.
    return np.asarray(np.where(unit == 1.0, high, low + (high - low) * unit))


def _sobol(axes: int, count: int, seed: int) -> Array:
    if axes <= sobol.MOST:
        return sobol.scrambled(axes, count, seed)
    from scipy.stats import qmc  # it takes a third of a second

    sequence = qmc.Sobol(axes, scramble=True, bits=30, rng=np.random.default_rng(seed))
    return np.asarray(sequence.random_base2(max(0, count - 1).bit_length())[:count])


def chunks(sets: Array, shared: int | None, size: int) -> list[Index]:
    """Split sets into blocks of indices ``(g, k)`` whose rows agree on the axis ``shared``.

    ``sets`` has shape ``(n, axes)``. Every set is in exactly one block of at most ``size`` sets, and the blocks
    depend on the sets alone, never on who works on them. ``shared=None``: all sets may share nodes.

    >>> [block.tolist() for block in chunks(np.array([[0.1, 2.0], [0.2, 2.0], [0.1, 3.0]]), shared=0, size=2)]
    [[[1]], [[0, 2]]]
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
        # A row's nodes take about as much memory as a set.
        step = max(1, size // (length + 1))
        blocks += [np.stack(group[i : i + step]) for i in range(0, len(group), step)]
    return blocks
