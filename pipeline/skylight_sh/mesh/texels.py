"""What textures add to the vertices' albedo, at a point and on the average."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh._mesh import Mesh, Part

Array = NDArray[np.float64]
Index = NDArray[np.int64]

# Points of a triangle that its mean colour is taken of, and what makes them even: the plastic number's powers.
_POINTS = 64
_STEPS = (0.7548776662466927, 0.5698402909980532)


def colours(mesh: Mesh, triangle: Index, uv: Array) -> Array:
    """Return the textures' colours ``(n, 3)`` at ``uv`` ``(n, 2)`` of triangles ``(n,)``: ones without a texture.

    The nearest texel counts. Textures repeat; their first row is at v = 1.
    """
    found = np.ones((len(triangle), 3))
    for k, part in enumerate(mesh.parts):
        if part.texture is not None:
            own = mesh.part[triangle] == k
            rows, columns = part.texture.shape[:2]
            column = np.floor((uv[own, 0] % 1.0) * columns).astype(np.int64) % columns
            row = np.floor((1.0 - uv[own, 1] % 1.0) * rows).astype(np.int64) % rows
            found[own] = part.texture[row, column]
    return found


def averaged(mesh: Mesh) -> Mesh:
    """Return the mesh without textures, their mean colour about each vertex in its albedo: what other surfaces see of it.

    A vertex's mean is that of its triangles, by their area; theirs is taken at 64 points spread evenly.
    """
    plain = tuple(Part(part.name) for part in mesh.parts)
    textured = np.array([part.texture is not None for part in mesh.parts])
    own = np.flatnonzero(textured[mesh.part])
    if not own.size:
        return replace(mesh, parts=plain)
    corners = mesh.triangles[own]
    mean = np.zeros((len(own), 3))
    for k in range(_POINTS):
        u, v = ((0.5 + step * k) % 1.0 for step in _STEPS)
        u, v = (u, v) if u + v <= 1.0 else (1.0 - u, 1.0 - v)
        shares = np.array([1.0 - u - v, u, v])
        mean += colours(mesh, own, np.einsum("k,nkc->nc", shares, mesh.uv[corners])) / _POINTS
    a, b, c = np.moveaxis(mesh.corners[own], 1, 0)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=-1)
    total, weight = np.zeros(mesh.albedo.shape), np.zeros(len(mesh.albedo))
    for k in range(3):
        np.add.at(total, corners[:, k], area[:, np.newaxis] * mean)
        np.add.at(weight, corners[:, k], area)
    factor = np.where(weight[:, np.newaxis] > 0.0, total / np.where(weight > 0.0, weight, 1.0)[:, np.newaxis], 1.0)
    return replace(mesh, albedo=mesh.albedo * factor, parts=plain)
