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
    mesh of any size, anywhere, is treated alike. Raises UserError where Embree is not installed.
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
        self._scene: Any = EmbreeScene()
        # Kept: Embree reads the arrays where they are.
        self._mesh = TriangleMesh(
            self._scene,
            np.ascontiguousarray(self._placed(mesh.positions)),
            np.ascontiguousarray(mesh.triangles, dtype=np.int32),
        )

    def occluded(self, origins: Array, directions: Array, near: float = 0.0) -> NDArray[np.bool_]:
        """Say ``(n,)`` which rays from ``origins`` ``(n, 3)`` along unit ``directions`` ``(n, 3)`` meet anything.

        What is nearer than ``near``, in the mesh's unit, does not count.
        """
        found = self._scene.run(*self._started(origins, directions, near), query="OCCLUDED")
        return np.asarray(found) >= 0

    def nearest(self, origins: Array, directions: Array, near: float = 0.0) -> Hits:
        """Return where rays from ``origins`` ``(n, 3)`` along unit ``directions`` ``(n, 3)`` first meet the mesh.

        What is nearer than ``near``, in the mesh's unit, does not count.
        """
        found = self._scene.run(*self._started(origins, directions, near), query="INTERSECT", output=True)
        triangle = np.asarray(found["primID"], dtype=np.int64)
        distance = np.where(triangle >= 0, np.asarray(found["tfar"], np.float64) * self.size + near, np.inf)
        return Hits(triangle, np.asarray(found["u"], np.float64), np.asarray(found["v"], np.float64), distance)

    def _placed(self, points: Array) -> NDArray[np.float32]:
        return np.asarray((points - self.centre) / self.size, dtype=np.float32)

    def _started(self, origins: Array, directions: Array, near: float) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        along = np.ascontiguousarray(np.broadcast_to(directions, origins.shape), dtype=np.float32)
        starts = origins + near * directions if near else origins
        return np.ascontiguousarray(self._placed(starts)), along
