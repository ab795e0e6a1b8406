"""What is wrong with a mesh made right where that can be done without a doubt, and told."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError
from skylight_sh.mesh import normals, orientation
from skylight_sh.mesh._mesh import Mesh
from skylight_sh.mesh.findings import Finding, by_part
from skylight_sh.mesh.topology import group

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Mask = NDArray[np.bool_]
Findings = tuple[Finding, ...]

# A triangle whose height is this share of its longest side, or whose longest side is this share of the mesh, is below the
# single precision of files and of rays.
FLAT = 1e-7


def heal(mesh: Mesh) -> tuple[Mesh, Findings]:
    """Return a mesh with unit normals on the side from which its triangles are anticlockwise, and what was done.

    Removes triangles without area and duplicates, turns those that are wound the wrong way (``orientation``), computes
    normals where they are missing or wrong, and joins vertices that are alike in everything. Raises UserError where nothing
    is left.
    """
    findings: Findings = ()
    steps: tuple[Callable[[Mesh], tuple[Mesh, Findings]], ...] = (
        without_flat,
        without_duplicates,
        orientation.wind_alike,
        orientation.turn_outward,
        joined,
        with_normals,
    )
    for step in steps:
        mesh, told = step(mesh)
        findings += told
    return mesh, findings


def without_flat(mesh: Mesh) -> tuple[Mesh, Findings]:
    """Remove triangles without area: they stop no light. Raises UserError where there are no others."""
    corners = mesh.corners
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=-1).max(axis=-1)
    size = float((mesh.positions.max(axis=0) - mesh.positions.min(axis=0)).max())
    flat = np.linalg.norm(normals.areas(mesh), axis=-1) <= FLAT * longest * longest
    flat |= longest <= FLAT * size
    if flat.all():
        raise UserError(f"All {len(flat):,} triangles have no area. Should have one. Export the mesh anew.")
    return _without(mesh, flat, "zero area", "triangle/triangles without area")


def without_duplicates(mesh: Mesh) -> tuple[Mesh, Findings]:
    """Remove triangles that a part has more than once, wound the same way, but for the first."""
    place, _ = group(mesh.positions)
    corners = place[mesh.triangles]
    first = corners.argmin(axis=-1)
    turned = np.take_along_axis(corners, (first[:, np.newaxis] + np.arange(3)) % 3, axis=1)
    again = np.ones(len(turned), bool)
    again[group(np.column_stack([mesh.part, turned]))[1]] = False
    return _without(mesh, again, "duplicate", "triangle/triangles that stand there already")


def with_normals(mesh: Mesh) -> tuple[Mesh, Findings]:
    """Give every vertex a unit normal on its triangles' front: computed where there is none or one on the back."""
    names = [part.name for part in mesh.parts]
    part = vertex_parts(mesh)
    missing, opposed, long = normals.judge(mesh)
    findings = (
        *by_part(names, part[missing], "no normals", "vertex/vertices without a normal", "computed", healed=True),
        *by_part(
            names,
            part[opposed],
            "opposing normals",
            "vertex/vertices whose normal opposes the faces",
            "computed anew",
            healed=True,
        ),
        *by_part(
            names, part[long], "long normals", "vertex/vertices whose normal is not of length 1", "scaled", healed=True
        ),
    )
    wrong = missing | opposed
    scaled = mesh.normals.copy()
    scaled[~wrong] = normals.unit(scaled[~wrong])
    mesh = replace(mesh, normals=scaled)
    # Where a surface ends at its own vertex, both sides may have the same normal.
    return (joined(normals.compute(mesh, wrong))[0] if wrong.any() else mesh), findings


def joined(mesh: Mesh) -> tuple[Mesh, Findings]:
    """Join vertices of a part that are alike in position, normal (or have none), albedo and texture coordinates."""
    part = vertex_parts(mesh)
    number, first = group(np.column_stack([part, mesh.positions, np.nan_to_num(mesh.normals), mesh.albedo, mesh.uv]))
    names = [one.name for one in mesh.parts]
    again = np.ones(len(part), bool)
    again[first] = False
    noun = "vertex/vertices alike in everything"
    told = by_part(names, part[again], "duplicate vertices", noun, "joined with another", healed=True)
    # In the file's order.
    order = np.argsort(first)
    rank = np.empty(len(first), np.int64)
    rank[order] = np.arange(len(first))
    return _chosen(mesh, first[order], rank[number][mesh.triangles]), told


def vertex_parts(mesh: Mesh) -> Index:
    """Return the part that each vertex belongs to, ``(v,)``."""
    part = np.zeros(len(mesh.positions), np.int64)
    part[mesh.triangles] = mesh.part[:, np.newaxis]
    return part


def _without(mesh: Mesh, lost: Mask, kind: str, noun: str) -> tuple[Mesh, Findings]:
    """Leave out triangles, and the vertices that no others use."""
    if not lost.any():
        return mesh, ()
    told = by_part([part.name for part in mesh.parts], mesh.part[lost], kind, noun, "removed", healed=True)
    used, triangles = np.unique(mesh.triangles[~lost], return_inverse=True)
    kept = _chosen(mesh, used, np.asarray(triangles).reshape(-1, 3))
    return replace(kept, part=mesh.part[~lost]), told


def _chosen(mesh: Mesh, vertices: Index, triangles: Index) -> Mesh:
    return replace(
        mesh,
        positions=mesh.positions[vertices],
        normals=mesh.normals[vertices],
        albedo=mesh.albedo[vertices],
        uv=mesh.uv[vertices],
        triangles=triangles,
    )
