"""What one walks on: level floors with more vertices where things stand on them, and the ground out to the horizon."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import Delaunay

from skylight_sh.mesh.shapes import Piece
from skylight_sh.mesh.textures import PAVING_SIDE

Array = NDArray[np.float64]
# West, south, east, north.
Area = tuple[float, float, float, float]

# Rings of vertices about what stands on a floor, metres from its foot.
_RINGS: tuple[float, ...] = (0.01, 0.05, 0.12, 0.25, 0.45)
# By how many metres a ring's vertices are further apart for each metre that it is from its foot.
_APART = 0.45
# Metres: an edge that is a wall's.
_LONG = 3.0


@dataclass(frozen=True)
class Foot:
    """Where something stands: a convex outline ``(k, 2)``, anticlockwise."""

    outline: Array

    def beyond(self, distance: float, spacing: float) -> Array:
        """Return points ``(n, 2)`` about the outline at a distance from it."""
        following = np.roll(self.outline, -1, axis=0)
        edge = following - self.outline
        length = np.linalg.norm(edge, axis=1)
        outward = np.stack([edge[:, 1], -edge[:, 0]], axis=1) / length[:, np.newaxis]
        found = []
        for start, along, out, long, after in zip(
            self.outline, edge, outward, length, np.roll(outward, -1, axis=0), strict=True
        ):
            # Along walls light changes slowly.
            steps = max(1, round(long / (spacing if long < _LONG else 2.5 * spacing)))
            found.append(start + distance * out + np.arange(steps + 1)[:, np.newaxis] / steps * along)
            middle = out + after
            found.append((start + along + distance * middle / np.linalg.norm(middle))[np.newaxis])
        return np.concatenate(found)

    def distance(self, points: Array) -> Array:
        """Return how far ``points`` ``(n, 2)`` are outside, negative within; exact beside edges, less at corners."""
        edge = np.roll(self.outline, -1, axis=0) - self.outline
        outward = np.stack([edge[:, 1], -edge[:, 0]], axis=1) / np.linalg.norm(edge, axis=1)[:, np.newaxis]
        return np.asarray(((points[:, np.newaxis] - self.outline) * outward).sum(axis=-1).max(axis=1))


def round_foot(x: float, y: float, radius: float, sides: int = 20) -> Foot:
    """Return the foot of something round."""
    angle = 2.0 * np.pi * np.arange(sides) / sides
    return Foot(np.stack([x + radius * np.cos(angle), y + radius * np.sin(angle)], axis=-1))


def box_foot(west: float, south: float, east: float, north: float) -> Foot:
    """Return the foot of something with four sides."""
    return Foot(np.array([[west, south], [east, south], [east, north], [west, north]]))


def floor(area: Area, height: float, spacing: float, feet: Sequence[Foot], *, dense: Area | None = None) -> Piece:
    """Return a level floor over ``(west, south, east, north)`` with vertices about ``feet`` and none beneath them.

    Outside ``dense``, if given, vertices of the lattice are twice as far apart.
    """
    inner = _lattice(area, spacing)
    if dense is not None:
        coarse = _lattice(area, 2.0 * spacing)
        inner = np.concatenate([inner[_within(inner, dense)], coarse[~_within(coarse, dense)]])
    rings = []
    for i, distance in enumerate(_RINGS):
        apart = min(spacing, 0.3 * spacing + _APART * distance)
        # One ring gives way to another foot's nearer ones.
        for number, foot in enumerate(feet):
            points = foot.beyond(distance, apart)
            others = [other.distance(points) for k, other in enumerate(feet) if k != number]
            free = np.min(others, axis=0) > _RINGS[min(i, 1)] * 0.9 if others else np.ones(len(points), dtype=bool)
            rings.append(points[free])
    near = np.concatenate(rings) if rings else np.zeros((0, 2))
    near = near[_within(near, area)]
    if feet:
        gap = np.min([foot.distance(inner) for foot in feet], axis=0)
        inner = inner[gap > _RINGS[-1] + 0.4 * spacing]
    points = _thinned(np.concatenate([_border(area, spacing), near, inner]), 0.035)
    # No four points lie on a circle, so that no rounding decides on triangles.
    moved = points + np.random.default_rng(1).uniform(-2e-3, 2e-3, points.shape)
    triangles = Delaunay(moved).simplices.astype(np.int64)
    a, b, c = points[triangles].transpose(1, 0, 2)
    turn = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    triangles = np.where(turn[:, np.newaxis] > 0.0, triangles, triangles[:, ::-1])[np.abs(turn) > 1e-9]
    triangles = triangles[np.lexsort(np.sort(triangles, axis=1).T[::-1])]
    positions = np.concatenate([points, np.full((len(points), 1), height)], axis=1)
    return Piece(positions, np.tile([0.0, 0.0, 1.0], (len(points), 1)), points / PAVING_SIDE, triangles)


def earth(far: float, hole: Area) -> Piece:
    """Return the ground about a court, out to ``far`` metres, a little below it: rings of ever larger quads."""
    west, south, east, north = hole
    corners = np.array([[west, south], [east, south], [east, north], [west, north]])
    sides = np.concatenate([np.linspace(a, b, 6)[:-1] for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True)])
    middle = corners.mean(axis=0)
    scale = np.geomspace(1.0, far / np.abs(sides - middle).max(), 9)
    points = middle + (sides - middle) * scale[:, np.newaxis, np.newaxis]
    positions = np.concatenate([points, np.full((*points.shape[:2], 1), -0.03)], axis=-1)
    index = np.arange(positions.shape[0] * positions.shape[1]).reshape(positions.shape[:2])
    index = np.concatenate([index, index[:, :1]], axis=1)
    a, b, c, d = (part.ravel() for part in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]))
    triangles = np.concatenate([np.stack([a, c, b], axis=1), np.stack([a, d, c], axis=1)])
    flat = positions.reshape(-1, 3)
    return Piece(flat, np.tile([0.0, 0.0, 1.0], (len(flat), 1)), np.zeros((len(flat), 2)), triangles)


def _lattice(area: Area, spacing: float) -> Array:
    """Every other row is moved by half a step: no four points lie on a circle, so that their triangles are given."""
    west, south, east, north = area
    rows = np.arange(south + spacing * 0.8, north - spacing * 0.5, spacing * 0.9)
    found = []
    for i, y in enumerate(rows):
        x = np.arange(west + spacing * (0.5 + 0.5 * (i % 2)), east - spacing * 0.4, spacing)
        found.append(np.stack([x, np.full(x.shape, y)], axis=-1))
    return np.concatenate(found)


def _within(points: Array, area: Area) -> NDArray[np.bool_]:
    west, south, east, north = area
    return (points[:, 0] > west) & (points[:, 0] < east) & (points[:, 1] > south) & (points[:, 1] < north)


def _border(area: Area, spacing: float) -> Array:
    west, south, east, north = area
    x = np.linspace(west, east, max(2, round((east - west) / spacing) + 1))
    y = np.linspace(south, north, max(2, round((north - south) / spacing) + 1))[1:-1]
    ends = [np.stack([x, np.full(x.shape, at)], axis=-1) for at in (south, north)]
    return np.concatenate([*ends, *(np.stack([np.full(y.shape, at), y], axis=-1) for at in (west, east))])


def _thinned(points: Array, least: float) -> Array:
    """Return the points without those that come within ``least`` of an earlier one."""
    from scipy.spatial import cKDTree

    pairs = cKDTree(points).query_pairs(least, output_type="ndarray")
    keep = np.ones(len(points), dtype=bool)
    for first, second in pairs[np.lexsort(pairs.T[::-1])]:
        if keep[first] and keep[second]:
            keep[second] = False
    return np.asarray(points[keep])
