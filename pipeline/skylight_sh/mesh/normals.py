"""Normals of vertices from the triangles around them, with creases."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh._mesh import Mesh
from skylight_sh.mesh.topology import components, group, topology

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

# Between the walls of a house, 90 degrees, and the sides of a round column.
CREASE = np.radians(40.0)
# What rounding to single precision leaves of a unit normal's length, with room.
_UNIT = 1e-3


def areas(mesh: Mesh) -> Array:
    """Return the triangles' normals ``(t, 3)``, as long as twice their areas."""
    a, b, c = np.moveaxis(mesh.corners, 1, 0)
    return np.cross(b - a, c - a)


def around(mesh: Mesh) -> Array:
    """Return for each vertex ``(v, 3)`` the sum of the normals of its triangles, by area."""
    weights = areas(mesh)
    index = mesh.triangles.ravel()
    return np.stack([np.bincount(index, np.repeat(w, 3), minlength=len(mesh.positions)) for w in weights.T], axis=-1)


def judge(mesh: Mesh) -> tuple[Mask, Mask, Mask]:
    """Say which vertices ``(v,)`` have no normal, one that opposes their triangles, and one that is not of unit length."""
    length = np.linalg.norm(mesh.normals, axis=-1)
    missing = ~(np.isfinite(length) & (length > 0.0))
    opposed = ~missing & (np.einsum("vi,vi->v", np.where(missing[:, np.newaxis], 0.0, mesh.normals), around(mesh)) < 0.0)
    return missing, opposed, ~missing & ~opposed & (np.abs(length - 1.0) > _UNIT)


def unit(vectors: Array) -> Array:
    """Return vectors ``(v, 3)`` at unit length; none may be 0."""
    scaled = vectors / np.abs(vectors).max(axis=-1, keepdims=True)
    return np.asarray(scaled / np.linalg.norm(scaled, axis=-1, keepdims=True))


def compute(mesh: Mesh, which: Mask, crease: float = CREASE) -> Mesh:
    """Give the vertices ``which`` ``(v,)`` the mean normal of the triangles around them, by area.

    Triangles belong together where they share an edge across which the surface bends by less than ``crease``, in radians; a
    vertex between others is split, once for each side. Other normals are left as they are.
    """
    touching, facing = topology(mesh), mesh.facing
    one, other = touching.pairs.T
    smooth = np.einsum("pi,pi->p", facing[one // 3], facing[other // 3]) > np.cos(crease)
    one, other = one[smooth], other[smooth]
    # A half-edge is named as the corner it starts from; where two run opposite ways, one's start is the other's end.
    along = touching.forward[one] == touching.forward[other]
    after_one, after_other = one - one % 3 + (one + 1) % 3, other - other % 3 + (other + 1) % 3
    a, b = np.where(along, other, after_other), np.where(along, after_other, other)
    side = components(3 * len(facing), np.concatenate([one, after_one]), np.concatenate([a, b]))
    weights = np.repeat(areas(mesh), 3, axis=0)
    mean = np.stack([np.bincount(side, w) for w in weights.T], axis=-1)
    vertex = mesh.triangles.ravel()
    new, first = group(np.stack([vertex, np.where(which[vertex], side, -1)], axis=-1))
    old = vertex[first]
    normals = np.where(which[old, np.newaxis], 0.0, mesh.normals[old])
    chosen = which[old]
    sums = mean[side[first[chosen]]]
    # Two sides that cancel: the triangle's own will do.
    lost = np.linalg.norm(sums, axis=-1) <= 1e-9 * np.linalg.norm(weights[first[chosen]], axis=-1)
    normals[chosen] = unit(np.where(lost[:, np.newaxis], weights[first[chosen]], sums))
    return replace(
        mesh,
        positions=mesh.positions[old],
        normals=normals,
        albedo=mesh.albedo[old],
        uv=mesh.uv[old],
        triangles=new.reshape(-1, 3),
    )
