"""Shadowed transfer: what of the light the mesh does not block (Sloan, Kautz and Snyder 2002; Green 2003)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.transfer.rays import Rays
from skylight_sh.transfer.sampling import cosine_fibonacci, frames, generator

Array = NDArray[np.float64]

_PURPOSE = 1


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

    ``points`` ``(n, 3)`` are where rays start, ``normals`` ``(n, 3)`` unit vectors, ``count`` the number of rays, an even
    one, ``first`` the index of the chunk's first vertex. Either half is a lattice of its own, shifted and spun at random, so
    that half their difference tells the error of their mean honestly; halves of one lattice would make it too large.

    Directions lie in the vertex's own frame, so that one product of visibility and basis projects a whole chunk; each
    vertex's weights are then turned into the world by their values in fixed directions, which is exact.
    """
    random = generator(seed, _PURPOSE, first)
    return np.stack([_half(rays, points, normals, bands, count // 2, random) for _ in range(2)])


def _half(rays: Rays, points: Array, normals: Array, bands: int, count: int, random: np.random.Generator) -> Array:
    local = cosine_fibonacci(count, start=random.random(), spin=2.0 * np.pi * random.random())
    turned = frames(normals, 2.0 * np.pi * random.random(len(points)))
    visible = np.empty((len(points), count))
    # As many rays at once as the caches hold.
    for i in range(0, len(points), 32):
        some = slice(i, i + 32)
        along = (local @ turned[some].transpose(0, 2, 1)).reshape(-1, 3)
        blocked = rays.occluded(np.repeat(points[some], count, axis=0), along)
        visible[some] = ~blocked.reshape(-1, count)
    return to_world(visible @ sphere.basis(local, bands) / count, turned)


def to_world(weights: Array, turned: Array) -> Array:
    """Return SH weights ``(n, N*N)`` of functions in ``n`` frames ``(n, 3, 3)`` in the world's axes."""
    bands = sphere.bands_of(weights)
    fixed = sphere.spiral(2 * bands * bands)
    back = np.linalg.pinv(sphere.basis(fixed, bands))
    matrices = back @ sphere.basis(_unit(fixed @ turned), bands)
    return np.asarray(np.einsum("nij,nj->ni", matrices, weights))


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))
