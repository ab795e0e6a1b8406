"""Polygons as triangles: fans where they are convex, ears cut off where they are not."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError

Array = NDArray[np.float64]
Index = NDArray[np.int64]

# Cutting ears takes the square of the corners.
MOST_CONCAVE_CORNERS = 500
_LARGEST = 1e60


def triangulate(positions: Array, corners: Index, counts: Index) -> Index:
    """Return triangles ``(t, 3)`` of polygons, in the polygons' order and turning the way they do.

    ``corners`` are the polygons' indices into ``positions`` ``(v, 3)`` one after the other, ``counts`` ``(p,)`` how many
    each has. One of fewer than 3 corners gives none. Raises
    UserError for a concave one of more than ``MOST_CONCAVE_CORNERS``.

    >>> square = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    >>> triangulate(square, np.arange(4), np.array([4])).tolist()
    [[0, 1, 2], [0, 2, 3]]
    """
    starts = np.cumsum(counts) - counts
    triangles, owners = [np.zeros((0, 3), np.int64)], [np.zeros(0, np.int64)]
    for size in np.unique(counts[counts >= 3]).tolist():
        which = np.flatnonzero(counts == size)
        polygons = corners[starts[which, np.newaxis] + np.arange(size)]
        if size > 3:
            polygons = _reflex_first(positions, polygons) if size == 4 else polygons
            concave = _turns(positions, polygons).min(axis=-1) < 0.0 if size > 4 else np.zeros(len(which), bool)
            for owner, polygon in zip(which[concave].tolist(), polygons[concave], strict=True):
                cut = _ears(positions, polygon)
                triangles.append(cut)
                owners.append(np.full(len(cut), owner))
            which, polygons = which[~concave], polygons[~concave]
        fan = np.stack([polygons[:, [0, k, k + 1]] for k in range(1, size - 1)], axis=1)
        triangles.append(fan.reshape(-1, 3))
        owners.append(np.repeat(which, size - 2))
    owner = np.concatenate(owners)
    return np.asarray(np.concatenate(triangles)[np.argsort(owner, kind="stable")], dtype=np.int64)


def _turns(positions: Array, polygons: Index) -> Array:
    """Return ``(p, n)`` how far each corner turns left about its polygon's normal, as twice a triangle's area."""
    points = _used(positions, polygons)
    points = points - points[:, :1]
    normal = np.cross(points, np.roll(points, -1, axis=1)).sum(axis=1)
    length = np.linalg.norm(normal, axis=-1, keepdims=True)
    unit = np.divide(normal, length, out=np.zeros_like(normal), where=length > 0.0)
    into, out = points - np.roll(points, 1, axis=1), np.roll(points, -1, axis=1) - points
    turns: Array = np.einsum("pni,pi->pn", np.cross(into, out), unit)
    # Corners on a straight line turn by rounding alone.
    slack = 1e-9 * np.linalg.norm(into, axis=-1) * np.linalg.norm(out, axis=-1)
    return np.where(np.abs(turns) <= slack, 0.0, turns)


def _used(positions: Array, polygons: Index) -> Array:
    # Indices out of range, what is no number and what is too large are told later, by part; here they must not stop reading.
    if not len(positions):
        return np.zeros((*polygons.shape, 3))
    return np.clip(np.nan_to_num(positions[np.clip(polygons, 0, len(positions) - 1)]), -_LARGEST, _LARGEST)


def _reflex_first(positions: Array, quads: Index) -> Index:
    """Roll quadrilaterals so that a corner that turns right comes first: the fan from there stays inside."""
    turns = _turns(positions, quads)
    first = np.where(turns.min(axis=-1) < 0.0, turns.argmin(axis=-1), 0)
    return np.asarray(np.take_along_axis(quads, (first[:, np.newaxis] + np.arange(4)) % 4, axis=1))


def _ears(positions: Array, polygon: Index) -> Index:
    """Cut ears off one polygon ``(n,)``: corners that turn left and hold no other corner."""
    if len(polygon) > MOST_CONCAVE_CORNERS:
        raise UserError(
            f"A concave polygon has {len(polygon)} corners. Should have at most {MOST_CONCAVE_CORNERS}. Export triangles."
        )
    points = _used(positions, polygon[np.newaxis])[0]
    plane = _flat(points)
    left, cut = list(range(len(polygon))), []
    while len(left) > 3:
        ear = next((k for k in range(len(left)) if _is_ear(plane, left, k)), 0)
        cut.append([left[ear - 1], left[ear], left[(ear + 1) % len(left)]])
        del left[ear]
    return np.asarray(polygon[np.array([*cut, left])])


def _flat(points: Array) -> Array:
    """Project a polygon along the largest axis of its normal, kept anticlockwise; ``(n, 2)``."""
    normal = np.cross(points - points[0], np.roll(points, -1, axis=0) - points[0]).sum(axis=0)
    axis = int(np.abs(normal).argmax())
    plane = points[:, [(axis + 1) % 3, (axis + 2) % 3]]
    return plane if normal[axis] >= 0.0 else plane[:, ::-1]


def _is_ear(plane: Array, left: list[int], k: int) -> bool:
    """Whether the corner ``k`` of those ``left`` turns left and its triangle holds none of the others."""
    a, b, c = (plane[left[i % len(left)]] for i in (k - 1, k, k + 1))
    if _area(a, b, c) <= 0.0:
        return False
    others = plane[[left[(k + 2 + i) % len(left)] for i in range(len(left) - 3)]]
    inside = (_area(a, b, others) >= 0.0) & (_area(b, c, others) >= 0.0) & (_area(c, a, others) >= 0.0)
    corner = (others == a).all(axis=-1) | (others == c).all(axis=-1)
    return not bool((inside & ~corner).any())


def _area(a: Array, b: Array, c: Array) -> Array:
    """Twice the signed area of plane triangles."""
    return np.asarray((b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0]))
