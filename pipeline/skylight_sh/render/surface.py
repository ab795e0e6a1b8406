"""Points on a mesh: where rays meet it, with normals and the colours of textures."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh import Mesh, texels
from skylight_sh.transfer.rays import Hits, Rays

Array = NDArray[np.float64]

# Of the mesh's size, above the surface: beyond what single precision loses.
_ABOVE = 2e-6


@dataclass(frozen=True)
class Points:
    """``positions`` ``(n, 3)`` with unit ``normals``, interpolated, and ``facing``, the triangles' own.

    ``albedo`` ``(n, 3)`` has the textures in it. ``corners`` ``(n, 3)`` are the triangles' vertices, ``shares`` ``(n, 3)``
    their barycentric weights.
    """

    positions: Array
    normals: Array
    facing: Array
    albedo: Array
    corners: NDArray[np.int64]
    shares: Array

    def some(self, which: NDArray[np.bool_] | slice) -> Points:
        """Return some of the points."""
        return Points(*(getattr(self, part.name)[which] for part in fields(self)))

    def interpolate(self, values: NDArray[np.floating]) -> Array:
        """Return vertices' ``values`` ``(v, ...)`` at the points, ``(n, ...)``."""
        flat = values.reshape(len(values), -1)
        found = sum(self.shares[:, k, np.newaxis] * flat[self.corners[:, k]] for k in range(3))
        return np.asarray(found).reshape(-1, *values.shape[1:])


class Surface:
    """A mesh with its rays and its triangles' normals, all made ready once. Threads may ask it at the same time."""

    def __init__(self, mesh: Mesh) -> None:
        self.mesh, self.rays, self.facing = mesh, Rays(mesh), mesh.facing

    def met(self, hits: Hits, along: Array) -> tuple[Points, NDArray[np.bool_]]:
        """Return the points that rays ``along`` ``(n, 3)`` meet from their front, and which rays ``(n,)`` do."""
        front = hits.met.copy()
        front[front] = np.einsum("nk,nk->n", along[front], self.facing[hits.triangle[front]]) < 0.0
        triangle, mesh = hits.triangle[front], self.mesh
        u, v = hits.u[front], hits.v[front]
        shares, corners = np.stack([1.0 - u - v, u, v], axis=-1), mesh.triangles[triangle]
        positions, normals, albedo = (
            np.einsum("nk,nkc->nc", shares, values[corners]) for values in (mesh.positions, mesh.normals, mesh.albedo)
        )
        normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
        albedo *= texels.colours(mesh, triangle, np.einsum("nk,nkc->nc", shares, mesh.uv[corners]))
        return Points(positions, normals, self.facing[triangle], albedo, corners, shares), front

    def starts(self, points: Points) -> Array:
        """Return where rays that leave the surface at ``points`` start, ``(n, 3)``."""
        return np.asarray(points.positions + _ABOVE * self.rays.size * points.facing)

    def smooth_starts(self, points: Points) -> Array:
        """Return where shadow rays start, ``(n, 3)``: on the surface that the vertices' normals round off (Hanika 2021).

        A point is projected onto the plane of each of its triangle's vertices where it lies below it, and the projections
        are interpolated. Where a triangle is flat, or hollow, that is the point itself.
        """
        mesh, moved = self.mesh, np.zeros(points.positions.shape)
        for k in range(3):
            corner = points.corners[:, k]
            depth = np.einsum("nk,nk->n", points.positions - mesh.positions[corner], mesh.normals[corner])
            moved -= (points.shares[:, k] * np.minimum(depth, 0.0))[:, np.newaxis] * mesh.normals[corner]
        return np.asarray(self.starts(points) + moved)
