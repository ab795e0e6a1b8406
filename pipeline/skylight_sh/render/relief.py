"""Normal maps in pictures: the normals that a part's relief gives points, and what light from everywhere makes of them.

The sun and lamps shine on a relief's own normal. Precomputed transfer knows the vertices' normals alone: its light is taken
as much brighter or darker as the same light would be on a surface that stands alone, turned from one normal to the other.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh import Mesh
from skylight_sh.render.shading import lit
from skylight_sh.render.surface import Points
from skylight_sh.transfer import unshadowed

Array = NDArray[np.float64]
Index = NDArray[np.int64]

# What a relief may at most do to the light of everywhere, either way: beyond it few bands tell little.
_MOST = 2.0


def carved(mesh: Mesh, points: Points, triangle: Index) -> Points:
    """Return ``points`` of triangles ``(n,)`` with the normals of their parts' relief, as they are where a part has none.

    Tangents run along u and v of the triangle, upright on the interpolated normal. The nearest texel counts.
    """
    normals = points.normals.copy()
    for k, part in enumerate(mesh.parts):
        own = np.flatnonzero(mesh.part[triangle] == k) if part.relief is not None else np.zeros(0, dtype=np.int64)
        if part.relief is None or not own.size:
            continue
        uv = np.einsum("nk,nkc->nc", points.shares[own], mesh.uv[points.corners[own]])
        rows, columns = part.relief.shape[:2]
        column = np.floor((uv[:, 0] % 1.0) * columns).astype(np.int64) % columns
        row = np.floor((1.0 - uv[:, 1] % 1.0) * rows).astype(np.int64) % rows
        bent = part.relief[row, column]
        along_u, along_v = _tangents(mesh, triangle[own], normals[own])
        turned = bent[:, :1] * along_u + bent[:, 1:2] * along_v + bent[:, 2:] * normals[own]
        normals[own] = turned / np.linalg.norm(turned, axis=-1, keepdims=True)
    return replace(points, normals=normals)


def brightened(mesh: Mesh, points: Points, light: Array, weights: NDArray[np.floating]) -> Array:
    """Return ``light`` ``(n, 3)``, irradiance / pi by everything on the vertices' normals, as on those of ``points``.

    ``weights`` ``(3, N*N)`` are the light's.
    """
    smooth = points.interpolate(mesh.normals)
    smooth /= np.linalg.norm(smooth, axis=-1, keepdims=True)
    changed = np.flatnonzero(np.abs(points.normals - smooth).max(axis=-1) > 1e-9)
    if not changed.size:
        return light
    bands = round(np.sqrt(weights.shape[-1]))
    before, after = (lit(unshadowed(normals[changed], bands), weights) for normals in (smooth, points.normals))
    ratio = np.divide(after, before, out=np.ones_like(after), where=before > 0.0)
    out = light.copy()
    out[changed] *= np.clip(ratio, 1.0 / _MOST, _MOST)
    return out


def _tangents(mesh: Mesh, triangle: Index, normals: Array) -> tuple[Array, Array]:
    """Return unit vectors ``(n, 3)`` along u and along v, upright on ``normals`` and on each other."""
    corners, uv = mesh.corners[triangle], mesh.uv[mesh.triangles[triangle]]
    one, other = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    (u1, v1), (u2, v2) = (np.moveaxis(uv[:, k] - uv[:, 0], -1, 0) for k in (1, 2))
    # Up to the factor 1 / (u1 v2 - u2 v1), of which the sign alone matters.
    sign = np.where(u1 * v2 - u2 * v1 < 0.0, -1.0, 1.0)[:, np.newaxis]
    along_u = sign * (v2[:, np.newaxis] * one - v1[:, np.newaxis] * other)
    along_u -= np.einsum("nk,nk->n", along_u, normals)[:, np.newaxis] * normals
    length = np.linalg.norm(along_u, axis=-1, keepdims=True)
    along_u = np.divide(along_u, length, out=np.zeros_like(along_u), where=length > 0.0)
    # A mirrored chart's v runs the other way.
    return along_u, sign * np.cross(normals, along_u)
