"""Which way triangles are wound: alike within a shell, and anticlockwise from outside where it is closed."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh import normals
from skylight_sh.mesh._mesh import Mesh
from skylight_sh.mesh.findings import Finding, by_part
from skylight_sh.mesh.topology import Topology, components, topology

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Mask = NDArray[np.bool_]
Findings = tuple[Finding, ...]

# Relative to area^(3/2): a folded sheet encloses nothing, but for rounding.
_NO_VOLUME = 1e-9


def wind_alike(mesh: Mesh) -> tuple[Mesh, Findings]:
    """Turn the triangles of each shell that are wound against the larger part of it, by area.

    A shell that cannot be wound alike, as a Moebius strip, is told and left.
    """
    touching = topology(mesh)
    count = len(mesh.triangles)
    one, other = touching.pairs.T
    against = touching.forward[one] == touching.forward[other]
    if not against.any():
        return mesh, ()
    one, other = one // 3, other // 3
    # Every triangle twice, as it is (t) and turned (t + count): what touches must be in one of two consistent states.
    shifted = other + np.where(against, count, 0)
    back = other + np.where(against, 0, count)
    state = components(2 * count, np.concatenate([one, one + count]), np.concatenate([shifted, back]))
    as_is, turned = state[:count], state[count:]
    names = [part.name for part in mesh.parts]
    one_sided = as_is == turned
    area = np.linalg.norm(normals.areas(mesh), axis=-1)
    held = np.bincount(state, np.concatenate([area, np.zeros(count)]), minlength=int(state.max()) + 1)
    # On a tie, the state of the first triangle stays.
    less = held[as_is] - held[turned]
    tied = np.abs(less) <= 1e-9 * (held[as_is] + held[turned])
    flip = ~one_sided & np.where(tied, as_is > turned, less < 0.0)
    findings = (
        *by_part(
            names,
            mesh.part[flip],
            "winding",
            "triangle/triangles wound against the larger part of a surface",
            "turned",
            healed=True,
        ),
        *by_part(
            names,
            mesh.part[one_sided],
            "one-sided",
            "triangle/triangles of a surface with one side only",
            "left as they are: no winding fits",
            healed=False,
        ),
    )
    return turn(mesh, flip), findings


def turn_outward(mesh: Mesh) -> tuple[Mesh, Findings]:
    """Turn closed shells that are inside out, and open ones all of whose normals oppose their triangles.

    A closed shell is inside out where it encloses a negative volume and lies in no other shell of its part, or in an even
    number of them; in an odd number it bounds a cavity, and is right. A cavity of a solid that is inside out is so as well.
    """
    touching = topology(mesh)
    found = shells(mesh, touching)
    corners = mesh.corners
    inverted = np.zeros(len(found.whole), bool)
    for number in np.flatnonzero(found.whole & (found.volume < 0.0)).tolist():
        inverted[number] = len(enclosing(corners, found, number, found.whole)) % 2 == 0
    if inverted.any():
        outer = inverted.copy()
        for number in np.flatnonzero(found.whole & (found.volume > 0.0)).tolist():
            if enclosing(corners, found, number, outer):
                inverted[number] = len(enclosing(corners, found, number, found.whole)) % 2 == 1
    opposed = normals.judge(mesh)[1][mesh.triangles].all(axis=-1)
    inverted |= ~found.whole & (np.bincount(touching.shell, ~opposed) == 0)
    flip = inverted[touching.shell]
    noun = "triangle/triangles of shells that are inside out"
    names = [part.name for part in mesh.parts]
    return turn(mesh, flip), by_part(names, mesh.part[flip], "inverted", noun, "turned", healed=True)


def turn(mesh: Mesh, flip: Mask) -> Mesh:
    """Wind the triangles ``flip`` ``(t,)`` the other way, and turn the normals that then are on the back of all theirs."""
    triangles = np.where(flip[:, np.newaxis], mesh.triangles[:, ::-1], mesh.triangles)
    turned = replace(mesh, triangles=triangles)
    touched = np.zeros(len(mesh.positions), bool)
    touched[mesh.triangles[flip]] = True
    _, opposed, _ = normals.judge(turned)
    return replace(turned, normals=np.where((touched & opposed)[:, np.newaxis], -mesh.normals, mesh.normals))


@dataclass(frozen=True)
class Shells:
    """The shells ``(s,)`` of a mesh: their signed ``volume``, which are ``whole`` (closed, and enclose anything), and boxes.

    ``order`` ``(t,)`` lists triangles shell by shell, each beginning at ``starts`` ``(s + 1,)``; ``low`` and ``high``
    ``(s, 3)`` are the boxes' corners, ``part`` ``(s,)`` indexes the mesh's parts.
    """

    volume: Array
    whole: Mask
    order: Index
    starts: Index
    low: Array
    high: Array
    part: Index

    def triangles(self, number: int) -> Index:
        """Return the triangles of one shell."""
        return self.order[self.starts[number] : self.starts[number + 1]]


def shells(mesh: Mesh, touching: Topology) -> Shells:
    """Return the shells of a mesh."""
    shell = touching.shell
    order = np.argsort(shell, kind="stable")
    starts = np.concatenate([[0], np.cumsum(np.bincount(shell))])
    corners = mesh.corners
    # Volumes about a corner of the shell's own, so that one far from the origin keeps its digits.
    a, b, c = np.moveaxis(corners - corners[order[starts[:-1]], :1][shell], 1, 0)
    cross = np.cross(b - a, c - a)
    volume = np.asarray(np.bincount(shell, np.einsum("ti,ti->t", a, cross) / 6.0), np.float64)
    area = np.bincount(shell, np.linalg.norm(cross, axis=-1) / 2.0)
    return Shells(
        volume=volume,
        whole=touching.closed & (np.abs(volume) > _NO_VOLUME * area**1.5),
        order=order,
        starts=starts,
        low=np.minimum.reduceat(corners.min(axis=1)[order], starts[:-1]),
        high=np.maximum.reduceat(corners.max(axis=1)[order], starts[:-1]),
        part=mesh.part[order[starts[:-1]]],
    )


def enclosing(corners: Array, found: Shells, number: int, among: Mask) -> list[int]:
    """Return the other shells, ``among`` ``(s,)`` and of its part, that a shell lies in; ``corners`` are ``(t, 3, 3)``."""
    around = among & (found.part == found.part[number])
    around &= (found.low <= found.low[number]).all(axis=-1) & (found.high >= found.high[number]).all(axis=-1)
    around[number] = False
    point = corners[found.triangles(number)[0]].mean(axis=0)[np.newaxis]
    others = np.flatnonzero(around).tolist()
    return [n for n in others if abs(winding_number(point, corners[found.triangles(n)])[0]) > 0.5]


def winding_number(points: Array, corners: Array) -> Array:
    """Return how often triangles ``(t, 3, 3)`` wind around points ``(n, 3)``: 1 inside a closed surface, 0 outside.

    The solid angle of a triangle is Van Oosterom and Strackee 1983, eq. 8.

    >>> corners = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])[[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]]
    >>> winding_number(np.array([[0.1, 0.1, 0.1], [2.0, 2.0, 2.0]]), corners).round(12).tolist()
    [1.0, 0.0]
    """
    found = np.empty(len(points))
    for i, point in enumerate(points):
        a, b, c = np.moveaxis(corners - point, 1, 0)
        la, lb, lc = (np.linalg.norm(v, axis=-1) for v in (a, b, c))
        above = np.einsum("ti,ti->t", a, np.cross(b, c))
        below = la * lb * lc + sum(np.einsum("ti,ti->t", u, v) * w for u, v, w in ((a, b, lc), (b, c, la), (c, a, lb)))
        found[i] = np.arctan2(above, below).sum() / (2.0 * np.pi)
    return found
