"""What is unusual in a mesh and left as it is, counted by part: it may be meant, or let light through."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from skylight_sh.mesh import normals
from skylight_sh.mesh._mesh import Mesh
from skylight_sh.mesh.findings import Finding, by_part
from skylight_sh.mesh.topology import Topology, group, topology

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Findings = tuple[Finding, ...]

# How near an edge a vertex is on it, relative to the edge's length: single precision with room.
_ON_EDGE = 1e-5
# Edges whose neighbourhoods are looked at in one go.
_CHUNK = 4096


def check(mesh: Mesh) -> Findings:
    """Return what is unusual: open edges, T-junctions, crowded edges, coincident triangles and slanted normals."""
    touching = topology(mesh)
    return (*open_edges(mesh, touching), *crowded_edges(mesh, touching), *coincident(mesh), *slanted(mesh))


def open_edges(mesh: Mesh, touching: Topology) -> Findings:
    """Count the edges of one triangle alone, and the vertices that lie inside such an edge."""
    names = [part.name for part in mesh.parts]
    alone = np.flatnonzero(touching.uses[touching.edge] == 1)
    part = mesh.part[alone // 3]
    told = by_part(
        names, part, "open edge", "edge/edges of one triangle alone", "as one-sided walls and floors have them", healed=False
    )
    start, end = mesh.triangles[alone // 3, alone % 3], mesh.triangles[alone // 3, (alone + 1) % 3]
    on = _on_edges(mesh, touching, start, end, part)
    noun = "vertex/vertices inside an edge of a neighbour (T-junctions)"
    return (*told, *by_part(names, on, "T-junction", noun, "where light may leak through a crack", healed=False))


def crowded_edges(mesh: Mesh, touching: Topology) -> Findings:
    """Count the edges of more than two triangles."""
    first = np.unique(touching.edge, return_index=True)[1]
    crowded = mesh.part[first[touching.uses > 2] // 3]
    names = [part.name for part in mesh.parts]
    return by_part(
        names, crowded, "non-manifold edge", "edge/edges of more than two triangles", "left as they are", healed=False
    )


def coincident(mesh: Mesh) -> Findings:
    """Count triangles with the same three corners as another, of their part or of another one."""
    corners = np.sort(group(mesh.positions)[0][mesh.triangles], axis=-1)
    number, _ = group(corners)
    shared = np.bincount(number)[number] > 1
    names = [part.name for part in mesh.parts]
    noun = "triangle/triangles that coincide with another one"
    return by_part(names, mesh.part[shared], "coincident", noun, "so that chance decides which one is seen", healed=False)


def slanted(mesh: Mesh) -> Findings:
    """Count triangles that have a corner whose normal is on their back, though it is on the front of those around it."""
    behind = (np.einsum("ti,tki->tk", mesh.facing, mesh.normals[mesh.triangles]) < 0.0).any(axis=-1)
    names = [part.name for part in mesh.parts]
    noun = "triangle/triangles with a normal on the back"
    done = "where shading and shape disagree; a crease may want to be split"
    return by_part(names, mesh.part[behind], "slanted normals", noun, done, healed=False)


def _on_edges(mesh: Mesh, touching: Topology, start: Index, end: Index, part: Index) -> Index:
    """Return the parts of the places that lie inside an open edge of their part."""
    if not len(start):
        return np.zeros(0, np.int64)
    ends = np.unique(np.concatenate([start, end]))
    first = np.unique(touching.place[ends], return_index=True)[1]
    points = mesh.positions[ends[first]]
    of_part = np.zeros(len(mesh.positions), np.int64)
    of_part[mesh.triangles] = mesh.part[:, np.newaxis]
    point_part = of_part[ends[first]]
    a, b = mesh.positions[start], mesh.positions[end]
    length = np.linalg.norm(b - a, axis=-1)
    tree = cKDTree(points)
    found = np.zeros(len(points), bool)
    for block in range(0, len(start), _CHUNK):
        now = slice(block, block + _CHUNK)
        near = tree.query_ball_point(0.5 * (a[now] + b[now]), 0.5 * length[now])
        counts = np.array([len(one) for one in near])
        edge, point = np.repeat(np.arange(len(near)), counts) + block, np.concatenate(near).astype(np.int64)
        edge, point = (x[point_part[point] == part[edge]] for x in (edge, point))
        along = (b[edge] - a[edge]) / length[edge, np.newaxis]
        off = points[point] - a[edge]
        at = np.einsum("ei,ei->e", off, along)
        aside = np.linalg.norm(off - at[:, np.newaxis] * along, axis=-1)
        slack = _ON_EDGE * length[edge]
        found[point[(aside < slack) & (at > slack) & (at < length[edge] - slack)]] = True
    return np.asarray(point_part[found])


def up_hint(mesh: Mesh) -> Findings:
    """Suspect that a mesh has y up: much of its surface faces y, and little of it -y or z."""
    weights = normals.areas(mesh)
    area = np.linalg.norm(weights, axis=-1)
    facing = weights / area[:, np.newaxis]
    towards_y, towards_minus_y, towards_z = (
        float(area[one > 0.9].sum()) for one in (facing[:, 1], -facing[:, 1], facing[:, 2])
    )
    if towards_y > 0.2 * area.sum() and towards_y > 2.0 * max(towards_minus_y, towards_z):
        sentence = f"The mesh may have y up: {towards_y / area.sum():.0%} of its surface faces y. If so, say up = y."
        return (Finding("", "up", 1, False, sentence),)
    return ()
