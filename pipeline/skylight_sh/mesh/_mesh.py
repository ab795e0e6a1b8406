"""A mesh: vertices, triangles, and the parts that they belong to."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.int64]


@dataclass(frozen=True)
class Part:
    """A named piece of a mesh, as its file names it.

    ``texture`` ``(rows, columns, 3)`` is linear RGB by which the vertices' albedo is multiplied, its first row at v = 1;
    ``relief`` ``(rows, columns, 3)`` are unit normals in the tangent frame (x along u, y along v, z outward). Either may
    be absent.
    """

    name: str
    texture: Array | None = field(default=None, repr=False)
    relief: Array | None = field(default=None, repr=False)


@dataclass(frozen=True)
class Mesh:
    """Vertices ``(v,)`` and triangles ``(t,)``; right-handed, z up, lengths in the file's unit.

    ``positions`` and unit ``normals`` are ``(v, 3)``, ``albedo`` ``(v, 3)`` linear RGB from 0 to 1, ``triangles`` ``(t, 3)``
    indices of vertices, anticlockwise seen from outside. ``part`` ``(t,)`` indexes ``parts``. ``uv`` ``(v, 2)`` are texture
    coordinates, zeros where a mesh has none. Where a surface has a crease, its vertices are there once for each side.
    """

    positions: Array
    normals: Array
    albedo: Array
    triangles: Index
    part: Index
    parts: tuple[Part, ...]
    uv: Array

    @cached_property
    def corners(self) -> Array:
        """The triangles' corners, ``(t, 3, 3)``: triangle, corner, coordinate."""
        return self.positions[self.triangles]

    @cached_property
    def facing(self) -> Array:
        """The triangles' own unit normals, ``(t, 3)``."""
        a, b, c = np.moveaxis(self.corners, 1, 0)
        cross = np.cross(b - a, c - a)
        return np.asarray(cross / np.linalg.norm(cross, axis=-1, keepdims=True))
