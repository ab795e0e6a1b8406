"""Shadowed transfer: what of the light the mesh does not block (Sloan, Kautz and Snyder 2002; Green 2003)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.transfer.rays import Rays
from skylight_sh.transfer.sampling import Cells, Index, cells, chunks, frames, generator, nearest

Array = NDArray[np.float64]

_PURPOSE = 1
# Directions of a cell: as many rays go into it where the mesh's outline crosses it.
_EACH = 3
# Of all rays, those that look where outlines are; how many of the other half's cells a cell asks.
_COARSE, _ABOUT = 0.7, 7
# As many rays at once as the caches hold.
_AT_ONCE = 2**16


def unshadowed(normals: Array, bands: int) -> Array:
    """Return the transfer ``(v, N*N)`` of surfaces of unit ``normals`` ``(v, 3)`` that see everything before them.

    That is cos / pi in SH: its dot product with the light's weights is irradiance / pi (Green 2003, "Diffuse Unshadowed
    Transfer").

    >>> unshadowed(np.array([[0.0, 0.0, 1.0]]), 2).round(4).tolist()
    [[0.2821, 0.0, 0.3257, 0.0]]
    """
    return sphere.scale_degrees(sphere.basis(normals, bands), sphere.clamped_cosine(bands)) / np.pi


def shadowed(rays: Rays, points: Array, normals: Array, bands: int, *, count: int, seed: int, first: int) -> Array:
    """Return the transfer of a chunk of vertices from either half of their rays, ``(2, n, N*N)``; the whole is the mean.

    ``points`` ``(n, 3)`` are where rays start, ``normals`` ``(n, 3)`` unit vectors, ``count`` about as many rays as a vertex
    gets, ``first`` the index of the chunk's first vertex. Either half has a lattice of its own, shifted and spun at random:
    half their difference tells the error of their mean, as halves of one lattice would not.

    Directions lie in the vertex's own frame, so that one product of visibility and basis projects a whole chunk; each
    vertex's weights are then turned into the world by their values in fixed directions, which is exact.
    """
    random = generator(seed, _PURPOSE, first)
    coarse = max(2, round(_COARSE * count / 2))
    halves = [cells(coarse, _EACH, random) for _ in range(2)]
    turned = frames(normals, 2.0 * np.pi * random.random(len(points)))
    basis = [(sphere.basis(half.directions, bands) / len(half.directions)).astype(np.float32) for half in halves]
    near = [nearest(half, other, _ABOUT) for half, other in zip(halves, halves[::-1], strict=True)]
    found = np.empty((2, len(points), bands * bands))
    for some in chunks(len(points), max(1, _AT_ONCE // count)):
        for half, seen in enumerate(_visible(rays, points[some], turned[some], halves, near)):
            found[half, some] = seen @ basis[half]
    return to_world(found, turned)


def _visible(rays: Rays, points: Array, turned: Array, halves: list[Cells], near: list[Index]) -> list[NDArray[np.float32]]:
    """Return which directions ``(n, directions)`` of either half are open, as 0 and 1.

    There is a ray for each cell. Where an outline crosses a cell there is one for all of its directions; whether it does is
    asked of the other half's rays in the cells ``near``, since a cell that looks at its own would pass over what it just
    misses.
    """
    blocked = [_cast(rays, points, turned, half) for half in halves]
    seen = []
    for own, other, half, about in zip(blocked, blocked[::-1], halves, near, strict=True):
        around = other[:, about]
        crossed = np.asarray(around.any(axis=2) & ~around.all(axis=2))
        asked = crossed[:, half.cell]
        asked[:, half.first] = False
        whole = own[:, half.cell]
        row, column = np.nonzero(asked)
        whole[row, column] = rays.occluded(points[row], np.einsum("nij,nj->ni", turned[row], half.directions[column]))
        seen.append((~whole).astype(np.float32))
    return seen


def _cast(rays: Rays, points: Array, turned: Array, half: Cells) -> NDArray[np.bool_]:
    along = half.directions[half.first] @ turned.transpose(0, 2, 1)
    count = len(half.first)
    return rays.occluded(np.repeat(points, count, axis=0), along.reshape(-1, 3)).reshape(-1, count)


def to_world(weights: Array, turned: Array) -> Array:
    """Return SH weights ``(..., n, N*N)`` of functions in ``n`` frames ``(n, 3, 3)`` in the world's axes.

    The functions' values in fixed directions of the world are projected by a rule that is exact for them: Gauss's in z,
    and even steps in azimuth.
    """
    bands = sphere.bands_of(weights)
    z, share = sphere.gauss(bands)
    azimuth = 2.0 * np.pi * np.arange(2 * bands - 1) / (2 * bands - 1)
    ring = np.sqrt(1.0 - z * z)[:, np.newaxis] * np.stack([np.cos(azimuth), np.sin(azimuth)])[:, np.newaxis]
    fixed = np.stack([*ring, np.broadcast_to(z[:, np.newaxis], ring.shape[1:])], axis=-1).reshape(-1, 3)
    project = sphere.basis(fixed, bands) * np.repeat(2.0 * np.pi / (2 * bands - 1) * share, 2 * bands - 1)[:, np.newaxis]
    values = np.einsum("nki,...ni->...nk", sphere.basis(_unit(fixed @ turned), bands), weights)
    return np.asarray(values @ project)


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))
