"""Texels of a lightmap: where on the surface each is, and the frame in which a normal map is given there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh import UserError
from skylight_sh.mesh import Mesh

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

# Of a triangle's uv area, below which its texels have no tangent.
_FLAT = 1e-12
# How far beyond a triangle's edge, in barycentric weights, a texel's centre still counts as on it.
_EDGE = 1e-9


@dataclass(frozen=True)
class Texels:
    """Points of a surface with their frames, in world axes: ``(..., 3)`` and ``(..., 3, 3)``.

    A frame's rows are the tangent (along u), the bitangent (along v) and the normal, unit vectors at right angles.
    ``covered`` ``(...)`` says which texels lie on the surface; the others' points are 0, their frames those of the world.
    """

    points: Array
    frames: Array
    covered: Mask


def of_points(points: Array, normals: Array, tangents: Array) -> Texels:
    """Return texels at ``points`` with unit ``normals`` and ``tangents``, all ``(..., 3)``, for which v runs along n x t.

    Tangents are turned to right angles with the normals. Raises ValueError for another shape, and where a tangent lies
    along its normal or a number is not finite.

    >>> found = of_points(np.zeros(3), np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.5]))
    >>> found.frames.tolist()
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    """
    where, n, t = (np.asarray(part, dtype=np.float64) for part in (points, normals, tangents))
    if not where.shape == n.shape == t.shape or where.shape[-1:] != (3,):
        raise ValueError(f"Invalid shapes {where.shape}, {n.shape}, {t.shape}. Should be one, (..., 3).")
    if not np.all(np.isfinite(where)):
        raise ValueError("Invalid points: some are not finite. Leave them out.")
    return Texels(where, _frames(n, t, np.cross(n, t)), np.ones(where.shape[:-1], dtype=bool))


def chart(mesh: Mesh, part: str, rows: int, columns: int) -> Texels:
    """Return the texels ``(rows, columns)`` of a part of a mesh, by its texture coordinates.

    The centre of texel (i, k) is u = (k + 1/2) / columns, v = 1 - (i + 1/2) / rows, so that row 0 is the top, as in the
    part's own pictures; it lies on the triangle whose texture coordinates hold it, normals interpolated, tangents along that
    triangle's u. Nothing is made for texels beside the chart: no seams are padded. Raises UserError for a part that is not
    there, one without texture coordinates in [0, 1], or a chart that covers a texel twice.
    """
    names = [one.name for one in mesh.parts]
    if part not in names:
        raise UserError(f"part {part!r}: the mesh has none of that name. Take one of {', '.join(names)}.")
    triangles = mesh.triangles[mesh.part == names.index(part)]
    uv = mesh.uv[triangles]
    if not triangles.size or np.ptp(uv[..., 0]) == 0 or np.ptp(uv[..., 1]) == 0:
        raise UserError(f"part {part!r}: it has no texture coordinates. Unwrap it first, or bake at points.")
    if uv.min() < -1e-6 or uv.max() > 1 + 1e-6:
        raise UserError(
            f"part {part!r}: its texture coordinates run from {uv.min():g} to {uv.max():g}. A lightmap needs them once, in "
            "[0, 1]: unwrap it without repeating."
        )
    points, normals = np.zeros((rows, columns, 3)), np.zeros((rows, columns, 3))
    tangents, bitangents = np.zeros((rows, columns, 3)), np.zeros((rows, columns, 3))
    inner, covered = np.zeros((rows, columns), dtype=bool), np.zeros((rows, columns), dtype=bool)
    for corners, at in zip(triangles, uv, strict=True):
        window, weights = _inside(at, rows, columns)
        hit = np.all(weights >= -_EDGE, axis=-1)
        # An edge that two triangles share is no overlap.
        within = np.all(weights > _EDGE, axis=-1)
        if np.any(inner[window] & within):
            raise UserError(f"part {part!r}: its chart covers a texel twice. Unwrap it without overlaps.")
        inner[window] |= within
        fresh = hit & ~covered[window]
        covered[window] |= hit
        edges, sides = at[1:] - at[0], mesh.positions[corners[1:]] - mesh.positions[corners[0]]
        along = np.linalg.solve(edges, sides) if hit.any() else np.zeros((2, 3))
        points[window][fresh] = weights[fresh] @ mesh.positions[corners]
        normals[window][fresh] = weights[fresh] @ mesh.normals[corners]
        tangents[window][fresh], bitangents[window][fresh] = along
    frames = np.broadcast_to(np.eye(3), (rows, columns, 3, 3)).copy()
    frames[covered] = _frames(normals[covered], tangents[covered], bitangents[covered])
    return Texels(points, frames, covered)


def world_normals(frames: Array, relief: ArrayLike) -> Array:
    """Return a normal map's unit vectors ``(..., 3)`` (x along the tangent, y along the bitangent, z outward) in the world.

    ``frames`` ``(..., 3, 3)`` broadcast. Vectors are brought to length 1. Raises ValueError for one of length 0.

    >>> world_normals(np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]), [0.6, 0.0, 0.8]).tolist()
    [0.8, 0.6, 0.0]
    """
    known = np.asarray(relief, dtype=np.float64)
    length = np.linalg.norm(known, axis=-1, keepdims=True)
    if not np.all(length > 0):
        raise ValueError("Invalid normal map: some of its vectors have no length. Write (0, 0, 1) where it is flat.")
    return np.asarray(((known / length)[..., np.newaxis, :] @ frames)[..., 0, :])


def _inside(at: Array, rows: int, columns: int) -> tuple[tuple[slice, slice], Array]:
    """Return the texels about a triangle of texture coordinates ``(3, 2)``, and their barycentric weights ``(i, k, 3)``."""
    # In texels, from the upper left corner.
    x, y = at[:, 0] * columns, (1 - at[:, 1]) * rows
    left, right = max(0, int(np.floor(x.min()))), min(columns, int(np.ceil(x.max())))
    top, bottom = max(0, int(np.floor(y.min()))), min(rows, int(np.ceil(y.max())))
    window = (slice(top, bottom), slice(left, right))
    area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])
    px, py = np.meshgrid(np.arange(left, right) + 0.5 - x[0], np.arange(top, bottom) + 0.5 - y[0])
    if abs(area) < _FLAT * rows * columns:
        return window, np.full((*px.shape, 3), -1.0)
    second = (px * (y[2] - y[0]) - py * (x[2] - x[0])) / area
    third = (py * (x[1] - x[0]) - px * (y[1] - y[0])) / area
    return window, np.stack([1 - second - third, second, third], axis=-1)


def _frames(normals: Array, tangents: Array, bitangents: Array) -> Array:
    """Return frames ``(..., 3, 3)``: the normal kept, the tangent at right angles, the bitangent on its own side of both."""
    n = _unit(normals, "normal")
    t = _unit(tangents - np.sum(tangents * n, axis=-1, keepdims=True) * n, "tangent")
    b = np.cross(n, t)
    side = np.where(np.sum(b * bitangents, axis=-1, keepdims=True) < 0, -1.0, 1.0)
    return np.stack([t, side * b, n], axis=-2)


def _unit(vectors: Array, name: str) -> Array:
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    if not np.all(length > 1e-12) or not np.all(np.isfinite(length)):
        raise ValueError(f"Invalid {name}: some have no length, or lie along another axis. Give unit vectors at an angle.")
    return np.asarray(vectors / length)
