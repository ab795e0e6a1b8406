"""Textures and reliefs made by formulas: slabs of paving, plaster, boards, rings, leaves, bricks."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# Metres that one copy of the paving's texture covers, and its pixels.
PAVING_SIDE = 8.0
_PIXELS = 1024
_ROW, _JOINT = 0.5, 0.011


def slabs(seed: int = 5) -> Array:
    """Return the paving's texture ``(rows, columns, 3)``: slabs in rows, each with a tint of its own, and darker joints.

    It repeats every ``PAVING_SIDE`` metres either way.
    """
    random = np.random.default_rng(seed)
    place = (np.arange(_PIXELS) + 0.5) * PAVING_SIDE / _PIXELS
    cloud = _clouds(_PIXELS, (6, 24, 90), (0.5, 0.3, 0.2), seed + 1)
    picture = np.empty((_PIXELS, _PIXELS, 3))
    for row in range(round(PAVING_SIDE / _ROW)):
        cuts = np.cumsum(random.uniform(0.45, 0.95, 14))
        cuts = cuts[cuts < PAVING_SIDE - 0.4] + random.uniform(0.0, 0.4)
        slab = np.searchsorted(cuts, place) % len(cuts)
        tint = 0.38 * random.uniform(0.76, 1.12, (len(cuts), 1)) * (1.0 + random.uniform(-0.05, 0.05, (len(cuts), 3)))
        tint *= np.array([1.05, 0.99, 0.90])
        across = np.abs((place[:, np.newaxis] - cuts + 0.5 * PAVING_SIDE) % PAVING_SIDE - 0.5 * PAVING_SIDE).min(axis=1)
        here = (place >= row * _ROW) & (place < (row + 1) * _ROW)
        along = np.minimum(place[here] - row * _ROW, (row + 1) * _ROW - place[here])
        joint = np.clip(np.minimum(along[:, np.newaxis], across) / _JOINT, 0.0, 1.0)[..., np.newaxis]
        picture[here] = tint[slab] * (0.5 + 0.5 * joint)
    picture *= 1.0 + 0.1 * cloud[..., np.newaxis]
    # The first row of a texture is its upper edge.
    return picture[::-1]


def plaster(strength: float, seed: int, pixels: int = 512) -> Array:
    """Return clouds of paler and darker plaster ``(pixels, pixels, 3)``, 0.94 in the mean, never above 1; it repeats."""
    cloud = _clouds(pixels, (3, 9, 27, 96), (0.45, 0.25, 0.18, 0.12), seed)
    return np.repeat(np.clip(0.94 + strength * cloud, 0.5, 1.0)[..., np.newaxis], 3, axis=2)


def boards(count: int, seed: int, pixels: int = 256) -> Array:
    """Return upright boards ``(pixels, pixels, 3)`` with dark joints and grain, over one repeat."""
    random = np.random.default_rng(seed)
    place = (np.arange(pixels) + 0.5) / pixels * count
    tint = random.uniform(0.8, 1.0, count)[place.astype(np.int64) % count]
    edge = np.minimum(place % 1.0, 1.0 - place % 1.0) / count
    line = tint * np.where(edge < 0.006, 0.35, 1.0) * (1.0 - 0.08 * random.random(pixels))
    return np.repeat(np.tile(line, (pixels, 1))[..., np.newaxis], 3, axis=2)


def rings(bands: Sequence[tuple[float, float]], colour: Sequence[float], rows: int = 512) -> Array:
    """Return white ``(rows, 1, 3)`` but for ``bands`` from one height to another, shares of the whole, in a ``colour``."""
    height = 1.0 - (np.arange(rows) + 0.5) / rows
    painted = np.any([(height > low) & (height < high) for low, high in bands], axis=0)
    return np.where(painted[:, np.newaxis, np.newaxis], np.asarray(colour, dtype=float), np.ones(3))


def leaves(seed: int, pixels: int = 128) -> Array:
    """Return the speckle of small leaves ``(pixels, pixels, 3)``, from 0.45 to 1; it repeats."""
    cloud = _clouds(pixels, (16, 40), (0.5, 0.5), seed)
    return np.repeat(np.clip(0.75 + 0.35 * cloud, 0.45, 1.0)[..., np.newaxis], 3, axis=2)


def relief(height: Array, side: float) -> Array:
    """Return unit normals ``(rows, columns, 3)`` of a ``height`` ``(rows, columns)`` in metres that repeats every ``side``.

    The height's first row is its upper edge; normals are in the frame of x with u, y with v, z outward.
    """
    rows, columns = height.shape
    slope_u = (np.roll(height, -1, axis=1) - np.roll(height, 1, axis=1)) * columns / (2.0 * side)
    slope_v = (np.roll(height, 1, axis=0) - np.roll(height, -1, axis=0)) * rows / (2.0 * side)
    normal = np.stack([-slope_u, -slope_v, np.ones_like(height)], axis=-1)
    return np.asarray(normal / np.linalg.norm(normal, axis=-1, keepdims=True))


def trowelled(seed: int, pixels: int = 512) -> Array:
    """Return the height ``(pixels, pixels)`` of hand-laid plaster in metres, a few millimetres either way."""
    return 0.004 * _clouds(pixels, (5, 14, 40, 110), (0.5, 0.28, 0.14, 0.08), seed)


def bricks(seed: int, rows: int = 16, pixels: int = 512) -> tuple[Array, Array]:
    """Return a brick wall's height ``(pixels, pixels)`` in metres and its colours ``(pixels, pixels, 3)``, about 0.9."""
    random = np.random.default_rng(seed)
    columns = rows // 2
    v = (np.arange(pixels)[::-1, np.newaxis] + 0.5) / pixels * rows
    u = (np.arange(pixels) + 0.5) / pixels * columns + 0.5 * (np.floor(v) % 2)
    across, along = np.minimum(u % 1.0, 1.0 - u % 1.0) * 2.0, np.minimum(v % 1.0, 1.0 - v % 1.0)
    inside = np.clip((np.minimum(across, along) - 0.06) / 0.07, 0.0, 1.0)
    rounded = inside * inside * (3.0 - 2.0 * inside)
    brick = (np.floor(v).astype(np.int64) % rows, np.floor(u).astype(np.int64) % columns)
    out, tint = random.uniform(-0.2, 0.2, (rows, columns))[brick], random.uniform(0.72, 1.0, (rows, columns))[brick]
    height = 0.012 * (rounded * (1.0 + out) + 0.12 * _clouds(pixels, (30, 90), (0.5, 0.5), seed + 1))
    colour = np.where(rounded > 0.5, tint, 0.95)
    return height, np.repeat(colour[..., np.newaxis], 3, axis=2)


def _clouds(pixels: int, cells: tuple[int, ...], shares: tuple[float, ...], seed: int) -> Array:
    """Return smooth noise ``(pixels, pixels)`` of mean 0 that repeats, ``shares`` of it in ``cells`` across."""
    total = np.zeros((pixels, pixels))
    for number, (count, share) in enumerate(zip(cells, shares, strict=True)):
        values = np.random.default_rng((seed, number)).uniform(-1.0, 1.0, (count, count))
        place = np.arange(pixels) * count / pixels
        low = place.astype(np.int64)
        step = place - low
        step = step * step * (3.0 - 2.0 * step)
        mixed = values[low] * (1.0 - step)[:, np.newaxis] + values[(low + 1) % count] * step[:, np.newaxis]
        total += share * (mixed[:, low] * (1.0 - step) + mixed[:, (low + 1) % count] * step)
    return np.asarray(total - total.mean())
