"""Interreflection: light that other surfaces send on (Sloan, Kautz and Snyder 2002; Green 2003)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from skylight_sh.mesh import Mesh
from skylight_sh.transfer.rays import Rays
from skylight_sh.transfer.sampling import chunks, cosine_fibonacci, frames, generator

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_PURPOSE = 2
# As many rays at once as memory should hold.
_AT_ONCE = 2**16


def gather(mesh: Mesh, rays: Rays, points: Array, normals: Array, *, count: int, seed: int, first: int) -> sparse.csr_array:
    """Return the rows ``(n, v)`` of the matrix that gathers light for a chunk of vertices, as ``shadowed`` takes them.

    Applied to what the vertices of the mesh send out, it gives the cosine-weighted mean over ``count`` rays of what they
    meet, interpolated within triangles. What is met from behind sends nothing.
    """
    random = generator(seed, _PURPOSE, first)
    # Not shifted along its spiral: a shift moves all of the lattice outwards or inwards, by up to half a ray's share.
    local = cosine_fibonacci(count, spin=2.0 * np.pi * random.random())
    turned = frames(normals, 2.0 * np.pi * random.random(len(points)))
    rows = [
        _rows(mesh, rays, points[some], local @ turned[some].transpose(0, 2, 1))
        for some in chunks(len(points), max(1, _AT_ONCE // count))
    ]
    return sparse.csr_array(sparse.vstack(rows))


def _rows(mesh: Mesh, rays: Rays, points: Array, directions: Array) -> sparse.csr_array:
    """Return rows of the matrix for ``points`` ``(n, 3)``, each with rays along its ``directions`` ``(n, count, 3)``."""
    count = directions.shape[1]
    along = directions.reshape(-1, 3)
    hits = rays.nearest(np.repeat(points, count, axis=0), along)
    front = hits.met & (np.einsum("nk,nk->n", along, mesh.facing[hits.triangle]) < 0.0)
    row = np.repeat(np.arange(len(points)), count)[front]
    u, v = hits.u[front], hits.v[front]
    share = np.stack([1.0 - u - v, u, v], axis=-1) / count
    return _summed(row, mesh.triangles[hits.triangle[front]], share, (len(points), len(mesh.positions)))


def _summed(row: Index, columns: Index, share: Array, shape: tuple[int, int]) -> sparse.csr_array:
    """Return the matrix whose entries are summed in the rays' order."""
    key: Index = (row[:, np.newaxis] * shape[1] + columns).ravel()
    # An entry's place behind its key: whole numbers that are all different are sorted in one way only, and fast.
    digits = max(1, int(key.size - 1).bit_length())
    ordered: Index = np.sort((key << digits) + np.arange(key.size))
    key, order = ordered >> digits, ordered & ((1 << digits) - 1)
    starts = np.flatnonzero(np.diff(key, prepend=-1))
    found = key[starts]
    place = np.repeat(np.arange(len(starts)), np.diff(starts, append=key.size))
    data = np.bincount(place, weights=share.ravel()[order], minlength=len(found))
    rows = np.searchsorted(found, np.arange(shape[0] + 1) * shape[1])
    return sparse.csr_array((data, (found % shape[1]).astype(np.int32), rows.astype(np.int32)), shape=shape)


def bounced(direct: Array, albedo: Array, matrix: sparse.csr_array, bounces: int) -> Array:
    """Return the transfer ``(v, 3, N*N)`` with so many bounces: T_{b+1} = G (albedo T_b), summed.

    ``direct`` ``(v, N*N)`` is the shadowed transfer, ``albedo`` ``(v, 3)`` linear RGB, ``matrix`` ``(v, v)`` what ``gather``
    gives for all vertices. The vertex's own albedo is not in it.
    """
    now = np.repeat(direct[:, np.newaxis], albedo.shape[1], axis=1)
    total = now.copy()
    for _ in range(bounces):
        sent = albedo[:, :, np.newaxis] * now
        now = (matrix @ sent.reshape(len(sent), -1)).reshape(now.shape)
        total += now
    return total
