"""Rays against a mesh, by Embree; the optional extra ``transfer`` has it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError
from skylight_sh.mesh import Mesh

Array = NDArray[np.float64]
Index = NDArray[np.int64]


@dataclass(frozen=True)
class Hits:
    """Where rays ``(n,)`` first meet a mesh.

    ``triangle`` is an index, -1 where a ray meets nothing; ``u``, ``v`` are the barycentric weights of the triangle's second
    and third corner; ``distance`` is in the mesh's unit, infinite where nothing is met.
    """

    triangle: Index
    u: Array
    v: Array
    distance: Array

    @property
    def met(self) -> NDArray[np.bool_]:
        """Which rays meet anything."""
        return self.triangle >= 0


class Rays:
    """A mesh made ready for rays. Threads may ask it at the same time.

    Embree computes in single precision: the mesh is moved and scaled to a box of size 1 about the origin before, so that a
    mesh of any size, anywhere, is treated alike. It says which triangle a ray meets; where it does is worked out in
    double precision, since Embree's own figures have more or fewer digits by the processor's kind. Raises UserError where
    Embree is not installed.
    """

    def __init__(self, mesh: Mesh) -> None:
        try:
            from embreex.mesh_construction import TriangleMesh
            from embreex.rtcore_scene import EmbreeScene
        except ImportError as error:
            raise UserError("Rays need Embree. Install it: pip install 'skylight-sh[transfer]'.") from error
        low, high = mesh.positions.min(axis=0), mesh.positions.max(axis=0)
        self.centre: Array = 0.5 * (low + high)
        self.size = float((high - low).max())
        self._of = mesh
        self._corners = mesh.corners
        self._scene: Any = EmbreeScene()
        # Kept: Embree reads the arrays where they are.
        self._mesh = TriangleMesh(
            self._scene,
            np.ascontiguousarray(self._placed(mesh.positions)),
            np.ascontiguousarray(mesh.triangles, dtype=np.int32),
        )

    def __reduce__(self) -> tuple[type[Rays], tuple[Mesh]]:
        """Send the mesh to another process, which makes it ready anew."""
        return Rays, (self._of,)

    def occluded(self, origins: Array, directions: Array, near: float = 0.0) -> NDArray[np.bool_]:
        """Say ``(n,)`` which rays from ``origins`` ``(n, 3)`` along unit ``directions`` ``(n, 3)`` meet anything.

        What is nearer than ``near``, in the mesh's unit, does not count.
        """
        found = self._scene.run(*self._started(origins, directions, near), query="OCCLUDED")
        return np.asarray(found) >= 0

    def first(self, origins: Array, directions: Array, near: float = 0.0) -> Index:
        """Return the triangle ``(n,)`` that each ray meets first, as ``nearest`` takes them; -1 where it meets nothing."""
        return np.asarray(self._scene.run(*self._started(origins, directions, near), query="INTERSECT"), dtype=np.int64)

    def nearest(self, origins: Array, directions: Array, near: float = 0.0) -> Hits:
        """Return where rays from ``origins`` ``(n, 3)`` along unit ``directions`` ``(n, 3)`` first meet the mesh.

        What is nearer than ``near``, in the mesh's unit, does not count.
        """
        triangle = self.first(origins, directions, near)
        u, v, distance = np.zeros(triangle.size), np.zeros(triangle.size), np.full(triangle.size, np.inf)
        met = triangle >= 0
        along = np.broadcast_to(directions, origins.shape)[met]
        u[met], v[met], distance[met] = _met(self._corners[triangle[met]], origins[met], along)
        return Hits(triangle, u, v, distance)

    def _placed(self, points: Array) -> NDArray[np.float32]:
        return np.asarray((points - self.centre) / self.size, dtype=np.float32)

    def _started(self, origins: Array, directions: Array, near: float) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        along = np.ascontiguousarray(np.broadcast_to(directions, origins.shape), dtype=np.float32)
        starts = origins + near * directions if near else origins
        return np.ascontiguousarray(self._placed(starts)), along


def _met(corners: Array, origins: Array, directions: Array) -> tuple[Array, Array, Array]:
    """Return ``u``, ``v`` and distance ``(n,)`` of rays that meet triangles ``(n, 3, 3)`` (Moeller and Trumbore 1997).

    A ray that meets an edge may miss it by a rounding; its weights are moved onto the triangle.
    """
    a = corners[:, 0]
    b, c, from_a = corners[:, 1] - a, corners[:, 2] - a, origins - a
    across, along = np.cross(directions, c), np.cross(from_a, b)
    whole = np.einsum("nk,nk->n", across, b)
    # A ray in its triangle's plane meets it nowhere in particular.
    scale = np.divide(1.0, whole, out=np.zeros_like(whole), where=whole != 0.0)
    u = np.clip(np.einsum("nk,nk->n", across, from_a) * scale, 0.0, 1.0)
    v = np.clip(np.einsum("nk,nk->n", along, directions) * scale, 0.0, 1.0 - u)
    return u, v, np.einsum("nk,nk->n", along, c) * scale
