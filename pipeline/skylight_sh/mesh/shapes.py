"""Pieces of meshes made by formulas: sheets, strips, solids of revolution, prisms, tubes, boxes and blades.

All are right-handed and face outwards; lengths are metres. A piece has a normal for each of its vertices; where a surface
has a crease, the vertices are there once for each side.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh.mesh._mesh import Mesh, Part

Array = NDArray[np.float64]
Index = NDArray[np.int64]

# A profile's corner sharper than this is a crease.
_CREASE = np.cos(np.radians(40.0))


@dataclass(frozen=True)
class Piece:
    """Vertices ``positions``, unit ``normals`` ``(v, 3)``, coordinates ``uv`` ``(v, 2)`` and ``triangles`` ``(t, 3)``."""

    positions: Array
    normals: Array
    uv: Array
    triangles: Index

    def moved(self, offset: ArrayLike = (0.0, 0.0, 0.0), turn: float = 0.0) -> Piece:
        """Return the piece turned by ``turn`` radians about z, anticlockwise from above, then moved by ``offset``."""
        cos, sin = np.cos(turn), np.sin(turn)
        matrix = np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])
        return replace(self, positions=self.positions @ matrix.T + np.asarray(offset), normals=self.normals @ matrix.T)

    def flipped(self) -> Piece:
        """Return the piece facing the other way."""
        return replace(self, normals=-self.normals, triangles=self.triangles[:, ::-1])

    def towards(self, direction: ArrayLike) -> Piece:
        """Return the piece turned inside out where it faces away from ``direction`` in the mean."""
        a, b, c = self.positions[self.triangles].transpose(1, 0, 2)
        return self if np.cross(b - a, c - a).sum(axis=0) @ np.asarray(direction) > 0.0 else self.flipped()

    def mapped(self, along: ArrayLike, up: ArrayLike, side: float) -> Piece:
        """Return the piece with a texture laid on flat: u runs with ``along``, v with ``up``, once in ``side`` metres."""
        axes = np.stack([np.asarray(along, dtype=float), np.asarray(up, dtype=float)], axis=-1)
        return replace(self, uv=self.positions @ axes / side)


def joined(pieces: Sequence[Piece]) -> Piece:
    """Return pieces as one."""
    starts = np.cumsum([0, *(len(piece.positions) for piece in pieces[:-1])])
    return Piece(
        np.concatenate([piece.positions for piece in pieces]),
        np.concatenate([piece.normals for piece in pieces]),
        np.concatenate([piece.uv for piece in pieces]),
        np.concatenate([piece.triangles + start for piece, start in zip(pieces, starts, strict=True)]),
    )


def assembled(named: Sequence[tuple[Part, ArrayLike, Piece]]) -> Mesh:
    """Return a mesh of parts, each with its albedo ``(3,)`` or ``(v, 3)`` and its piece."""
    whole = joined([piece for _, _, piece in named])
    # Far above the last bits in which machines differ.
    positions = np.round(whole.positions, 7)
    albedo = [np.broadcast_to(np.asarray(colour, dtype=float), piece.positions.shape) for _, colour, piece in named]
    part = [np.full(len(piece.triangles), i) for i, (_, _, piece) in enumerate(named)]
    return Mesh(
        positions,
        whole.normals,
        np.concatenate(albedo),
        whole.triangles,
        np.concatenate(part),
        tuple(one for one, _, _ in named),
        whole.uv,
    )


def sheet(points: Array, *, around: bool = False, along: bool = False, uv: Array | None = None) -> Piece:
    """Return a smooth sheet through ``points`` ``(rows, columns, 3)``.

    It faces the cross product of what follows in a row and what follows in a column. ``around`` joins the last column to the
    first, ``along`` the last row to the first. Triangles without an area, as at a pole, are left out.
    """
    rows, columns = points.shape[:2]
    index = np.arange(rows * columns).reshape(rows, columns)
    if around:
        index = np.concatenate([index, index[:, :1]], axis=1)
    if along:
        index = np.concatenate([index, index[:1]], axis=0)
    a, b, c, d = (part.ravel() for part in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]))
    triangles = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    positions = points.reshape(-1, 3)
    if uv is not None:
        triangles = triangles[_area(positions, triangles) > 1e-12]
        return Piece(positions, smooth_normals(positions, triangles), uv.reshape(-1, 2), triangles)
    return _surface(positions, triangles)


def strip(one: Array, other: Array, places: tuple[Array, Array] | None = None) -> Piece:
    """Return the smooth strip between two lines ``(n, 3)`` and ``(m, 3)``, which may have any numbers of points.

    It faces the cross product of the lines' direction and the way from ``one`` to ``other``. ``places``, rising numbers for
    either line, say which points lie beside which; without, the shares of the lines' lengths do.
    """
    places = places or (_shares(one), _shares(other))
    i, j, triangles = 0, 0, []
    while i < len(one) - 1 or j < len(other) - 1:
        ahead = i < len(one) - 1 and (j == len(other) - 1 or places[0][i + 1] <= places[1][j + 1] + 1e-9)
        triangles.append([i, i + 1 if ahead else len(one) + j + 1, len(one) + j])
        i, j = (i + 1, j) if ahead else (i, j + 1)
    return _surface(np.concatenate([one, other]), np.array(triangles))


def disc(rim: Array) -> Piece:
    """Return the flat face within a closed ``rim`` ``(n, 3)`` that its mean sees all of, anticlockwise to who sees it."""
    count = len(rim)
    first = np.arange(count)
    triangles = np.stack([first, (first + 1) % count, np.full(count, count)], axis=1)
    return _surface(np.concatenate([rim, rim.mean(axis=0, keepdims=True)]), triangles)


def prism(section: ArrayLike, places: ArrayLike, along: str = "x") -> Piece:
    """Return the solid that a closed ``section`` ``(k, 2)`` makes along ``x`` or ``y``, with a ring at each of ``places``.

    The section's points are the other horizontal coordinate and the height, anticlockwise in that plane; it starts at a
    crease, and its mean sees all of it. Where it bends by more than 40 degrees there is a crease.
    """
    line = np.asarray(section, dtype=float)
    at = np.asarray(places, dtype=float)

    def placed(part: Array) -> Array:
        points = np.empty((len(at), len(part), 3))
        points[..., 0 if along == "x" else 1] = at[:, np.newaxis]
        points[..., 1 if along == "x" else 0], points[..., 2] = part[:, 0], part[:, 1]
        return points

    sides = [sheet(placed(part)) for part in _smooth_parts(np.concatenate([line, line[:1]]))]
    rim = placed(line)
    solid = joined([*sides, disc(rim[0][::-1]), disc(rim[-1])])
    return solid if along == "x" else solid.flipped()


def smooth_normals(positions: Array, triangles: Index) -> Array:
    """Return unit normals ``(v, 3)``: the mean of the triangles' own, weighted by their area.

    Vertices at one place, as the many of a pole, share a normal.
    """
    a, b, c = positions[triangles].transpose(1, 0, 2)
    cross = np.cross(b - a, c - a)
    _, place = np.unique(np.round(positions, 9), axis=0, return_inverse=True)
    place = place.ravel()
    total = np.zeros((place.max() + 1, 3))
    for corner in range(3):
        np.add.at(total, place[triangles[:, corner]], cross)
    normals = total[place]
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    return np.asarray(np.where(length > 0.0, normals / np.where(length > 0.0, length, 1.0), [0.0, 0.0, 1.0]))


def lathe(profile: ArrayLike, around: int, radius: Callable[[Array], Array] | None = None) -> Piece:
    """Return the solid that a ``profile`` ``(k, 2)`` of radius and height makes about z, with ``around`` columns.

    The profile runs from the bottom to the top along the outside. Where it bends by more than 40 degrees there is a crease.
    ``radius(azimuth)``, if given, is what radii are multiplied with: flutes, or a polygon.
    """
    line = np.asarray(profile, dtype=float)
    azimuth = 2.0 * np.pi * np.arange(around) / around
    wave = np.ones(around) if radius is None else radius(azimuth)
    circle = np.stack([np.cos(azimuth) * wave, np.sin(azimuth) * wave], axis=-1)
    pieces = []
    for part in _smooth_parts(line):
        ring = part[:, np.newaxis, :1] * circle
        height = np.broadcast_to(part[:, np.newaxis, 1:], (*ring.shape[:2], 1))
        pieces.append(sheet(np.concatenate([ring, height], axis=-1), around=True))
    return joined(pieces)


def tube(path: Array, section: Callable[[Array], Array], around: int) -> Piece:
    """Return a closed tube about a closed ``path`` ``(n, 3)``.

    ``section(turns)`` ``(n, around, 2)`` are its outlines for the paths' places from 0 to 1, in frames that are carried
    along the path with the least turning, what they lack at the end being spread evenly.
    """
    count = len(path)
    tangent = np.roll(path, -1, axis=0) - np.roll(path, 1, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    normal = np.empty_like(path)
    start = np.cross(tangent[0], [0.3, -0.5, 0.81])
    normal[0] = start / np.linalg.norm(start)
    for i in range(1, count):
        carried = normal[i - 1] - (normal[i - 1] @ tangent[i]) * tangent[i]
        normal[i] = carried / np.linalg.norm(carried)
    last = normal[-1] - (normal[-1] @ tangent[0]) * tangent[0]
    other = np.cross(tangent[0], normal[0])
    lack = -np.arctan2(last @ other, last @ normal[0])
    angle = lack * np.arange(count) / count
    binormal = np.cross(tangent, normal)
    one = np.cos(angle)[:, np.newaxis] * normal + np.sin(angle)[:, np.newaxis] * binormal
    two = np.cross(tangent, one)
    outline = section(np.arange(count) / count)
    points = path[:, np.newaxis] + outline[..., :1] * one[:, np.newaxis] + outline[..., 1:] * two[:, np.newaxis]
    return sheet(points[:, :around], around=True, along=True)


def box(low: ArrayLike, high: ArrayLike, spacing: float, *, without: str = "", finer: float = 0.0) -> Piece:
    """Return a box from corner ``low`` to corner ``high``, its faces divided at ``spacing``.

    ``without`` names faces that are left out, of ``-x +x -y +y -z +z``. ``finer``, if given, is the distance from the edges
    of one more row of vertices, where light varies fastest.
    """
    a, b = np.asarray(low, dtype=float), np.asarray(high, dtype=float)
    pieces = []
    for axis, name in enumerate("xyz"):
        first, second = (axis + 1) % 3, (axis + 2) % 3
        u, v = (ticks(a[i], b[i], spacing, finer) for i in (first, second))
        for sign, place in (("-", a), ("+", b)):
            if f"{sign}{name}" in without:
                continue
            points = np.empty((len(v), len(u), 3))
            points[..., axis] = place[axis]
            points[..., first], points[..., second] = u[np.newaxis], v[:, np.newaxis]
            pieces.append(sheet(points if sign == "+" else points[:, ::-1]))
    return joined(pieces)


def ticks(low: float, high: float, spacing: float, finer: float = 0.0) -> Array:
    """Return places from ``low`` to ``high``, evenly at about ``spacing``, with one ``finer`` from either end."""
    even = np.linspace(low, high, max(2, round((high - low) / spacing) + 1))
    if finer and high - low > 4.0 * finer:
        even = even[(even < low + 1e-9) | (even > high - 1e-9) | ((even > low + 1.8 * finer) & (even < high - 1.8 * finer))]
        even = np.sort(np.concatenate([even, [low + finer, high - finer]]))
    return even


def blade(length: float, width: float, thickness: float, lift: float, droop: float, rows: int = 9) -> Piece:
    """Return a leaf that leaves the origin along +x, rises at ``lift`` radians and bends down by ``droop`` radians in all.

    Its section is a flat lozenge with a fold, closed at both ends.
    """
    s = np.linspace(0.0, 1.0, rows)
    angle = lift - droop * s * s
    step = length / (rows - 1)
    x = np.concatenate([[0.0], np.cumsum(np.cos(angle[:-1]) * step)])
    z = np.concatenate([[0.0], np.cumsum(np.sin(angle[:-1]) * step)])
    wide = width * (0.35 + 0.65 * np.sin(np.pi * np.minimum(0.12 + 0.88 * s, 1.0)) ** 0.8) * (1.0 - s**6)
    wide[-1] = 0.0
    thick = thickness * (1.0 - 0.8 * s)
    thick[-1] = 0.0
    centre = np.stack([x, np.zeros(rows), z], axis=-1)
    up = np.stack([-np.sin(angle), np.zeros(rows), np.cos(angle)], axis=-1)
    side = np.array([0.0, 1.0, 0.0])
    edge = 0.28 * wide[:, np.newaxis] * up
    left, right = centre + wide[:, np.newaxis] * side + edge, centre - wide[:, np.newaxis] * side + edge
    top, bottom = centre + thick[:, np.newaxis] * up, centre - thick[:, np.newaxis] * up
    upper = sheet(np.stack([right, top, left], axis=1).transpose(1, 0, 2))
    lower = sheet(np.stack([left, bottom, right], axis=1).transpose(1, 0, 2))
    root = disc(np.stack([right[0], bottom[0], left[0], top[0]])).towards((-1.0, 0.0, 0.0))
    return joined([upper, lower, root])


def _surface(points: Array, triangles: Index) -> Piece:
    """Return a smooth surface, its vertices at one place joined, as those of a pole are, its flat triangles left out."""
    _, first, place = np.unique(np.round(points, 9), axis=0, return_index=True, return_inverse=True)
    joint = first[place.ravel()][triangles]
    joint = joint[(joint[:, 0] != joint[:, 1]) & (joint[:, 1] != joint[:, 2]) & (joint[:, 2] != joint[:, 0])]
    joint = joint[_area(points, joint) > 1e-12]
    used, renumbered = np.unique(joint, return_inverse=True)
    positions, kept = points[used], renumbered.reshape(-1, 3)
    return Piece(positions, smooth_normals(positions, kept), np.zeros((len(positions), 2)), kept)


def _shares(line: Array) -> Array:
    """Return how far along a line its points are, from 0 to 1."""
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    return np.asarray(length / length[-1])


def _smooth_parts(line: Array) -> list[Array]:
    step = np.diff(line, axis=0)
    step /= np.linalg.norm(step, axis=1, keepdims=True)
    sharp = np.flatnonzero((step[:-1] * step[1:]).sum(axis=1) < _CREASE) + 1
    ends = [0, *sharp.tolist(), len(line) - 1]
    return [line[start : end + 1] for start, end in pairwise(ends)]


def _area(positions: Array, triangles: Index) -> Array:
    a, b, c = positions[triangles].transpose(1, 0, 2)
    return np.asarray(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1))
