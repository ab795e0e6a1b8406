"""Where the rays of a vertex start, and whether it can see out at all."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from skylight_sh.mesh import Mesh
from skylight_sh.transfer.rays import Rays
from skylight_sh.transfer.sampling import chunks, cosine_fibonacci, frames, generator

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Bool = NDArray[np.bool_]

# Of the way from a vertex to the middle of its triangle: off the edges that it shares with others; and in flat ones out of
# what lies so near a contact line that interpolation would spread its shade over the whole triangle. Where a surface bends,
# going so far would meet the view of another normal.
_INSIDE, _INSIDE_FLAT = 0.02, 0.2
# Cosine between normals of a flat triangle's corners.
_FLAT = 1.0 - 1e-6
# Above the surface, of how far the vertex is from the mesh's middle and how large its triangle: what single precision loses,
# and no more, since rays must not start beyond what touches the surface.
_ABOVE = 2e-6
_PROBES = 64
_CHUNK = 4096
# A vertex that sees this share of back faces lies inside something.
_BURIED = 0.25
_PURPOSE = 3


@dataclass(frozen=True)
class StartPoints:
    """Where rays start, ``(v, 3)``; ``behind`` ``(v,)`` is the share of a vertex's rays that meet a triangle from behind.

    ``buried`` ``(v,)`` says which vertices lie in contact lines or within solids, whatever triangle of theirs the rays start
    from: what rays say there is of the solid's inside.
    """

    points: Array
    behind: Array
    buried: Bool


def start_points(mesh: Mesh, rays: Rays, seed: int = 0) -> StartPoints:
    """Return where the rays of each vertex start: on the way to the middle of a triangle of its own, just above it.

    That is 2 % of the way, 20 % in a flat triangle. A vertex where two solids meet lies on both; a step into its own
    triangles tells on which side it is. The largest triangle is tried first, then the others, for those that still see a
    quarter of back faces: the inside of something.
    """
    own = _incident(mesh)
    corners, facing = mesh.corners, mesh.facing
    middles = corners.mean(axis=1)
    lost = _ABOVE * np.abs(mesh.positions - rays.centre).max(axis=1)
    above = _ABOVE * np.abs(corners - middles[:, np.newaxis]).max(axis=(1, 2))
    normals = mesh.normals[mesh.triangles]
    flat = np.einsum("tck,tck->tc", normals, np.roll(normals, 1, axis=1)).min(axis=1) > _FLAT
    inside = np.where(flat, _INSIDE_FLAT, _INSIDE)[:, np.newaxis]
    points = mesh.positions + mesh.normals * lost[:, np.newaxis]
    behind = np.ones(len(points))
    for turn in range(own.shape[1]):
        to_try = np.flatnonzero((behind > _BURIED) & (own[:, turn] >= 0))
        if not to_try.size:
            continue
        triangles = own[to_try, turn]
        height = (lost[to_try] + above[triangles])[:, np.newaxis]
        step = inside[triangles] * (middles[triangles] - mesh.positions[to_try])
        moved = mesh.positions[to_try] + step + height * facing[triangles]
        found = _behind(mesh, rays, moved, mesh.normals[to_try], seed)
        better = found < behind[to_try]
        points[to_try[better]], behind[to_try[better]] = moved[better], found[better]
    return StartPoints(points, behind, behind > _BURIED)


def healing(mesh: Mesh, buried: Bool) -> sparse.csr_array:
    """Return the matrix ``(v, v)`` that gives buried vertices the mean of their nearest valid neighbours along the surface.

    Rings of neighbours are walked outwards until they meet valid vertices; a piece that is buried whole gets nothing, its
    rows are empty.
    """
    count = len(buried)
    edges = mesh.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    ones = np.ones(2 * len(edges))
    ends = (np.concatenate([edges[:, 0], edges[:, 1]]), np.concatenate([edges[:, 1], edges[:, 0]]))
    neighbours = sparse.csr_array((ones, ends), shape=(count, count))
    neighbours.data[:] = 1.0
    known = ~buried
    heal = sparse.csr_array(sparse.diags_array(known.astype(np.float64)))
    while True:
        reached = neighbours @ known.astype(np.float64)
        ring = ~known & (reached > 0.0)
        if not ring.any():
            return heal
        share = sparse.diags_array(np.where(ring, 1.0 / np.maximum(reached, 1.0), 0.0))
        heal = sparse.csr_array(heal + share @ neighbours @ sparse.diags_array(known.astype(np.float64)) @ heal)
        known = known | ring


def _incident(mesh: Mesh, most: int = 8) -> Index:
    """Return up to ``most`` triangles of each vertex ``(v, most)``, the largest first, -1 where there are no more."""
    a, b, c = np.moveaxis(mesh.corners, 1, 0)
    # Rounded, so that triangles of one size keep their order on every machine.
    area = np.linalg.norm(np.cross(b - a, c - a), axis=-1).astype(np.float32)
    vertex, triangle = mesh.triangles.ravel(), np.repeat(np.arange(len(mesh.triangles)), 3)
    order = np.lexsort((triangle, -area[triangle], vertex))
    vertex, triangle = vertex[order], triangle[order]
    first = np.searchsorted(vertex, np.arange(len(mesh.positions)))
    place = np.arange(len(vertex)) - first[vertex]
    own = np.full((len(mesh.positions), most), -1)
    few = place < most
    own[vertex[few], place[few]] = triangle[few]
    return own


def _behind(mesh: Mesh, rays: Rays, points: Array, normals: Array, seed: int) -> Array:
    """Return the share ``(n,)`` of rays that meet a triangle from behind."""
    share = np.empty(len(points))
    facing = mesh.facing
    local = cosine_fibonacci(_PROBES)
    for part in chunks(len(points), _CHUNK):
        spins = 2.0 * np.pi * generator(seed, _PURPOSE, part.start).random(part.stop - part.start)
        along = (local @ frames(normals[part], spins).transpose(0, 2, 1)).reshape(-1, 3)
        triangle = rays.first(np.repeat(points[part], _PROBES, axis=0), along)
        back = (triangle >= 0) & (np.einsum("nk,nk->n", along, facing[triangle]) > 0.0)
        share[part] = back.reshape(-1, _PROBES).mean(axis=1)
    return share
