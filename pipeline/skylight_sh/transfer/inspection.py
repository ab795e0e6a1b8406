"""What rays find wrong in a mesh: parts seen from behind, vertices within solids, sheets that coincide."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh import Finding, Mesh
from skylight_sh.mesh.findings import by_part
from skylight_sh.transfer.rays import Hits, Rays
from skylight_sh.transfer.sampling import chunks, cosine_fibonacci, frames, generator
from skylight_sh.transfer.start_points import StartPoints

Array = NDArray[np.float64]
Index = NDArray[np.int64]

# Vertices that look around, and their rays: enough to tell a part that is a thousandth of the view.
_LOOKERS, _LOOKS = 8192, 32
_CHUNK = 4096
_PURPOSE = 7
# A part is told where this share of the rays that meet it come from behind, of at least so many.
_BEHIND, _FEWEST = 0.25, 16
# Of the mesh's size: from where sheets are looked at, and how near two of them coincide.
_ABOVE, _SAME = 1e-4, 1e-6


def inspect(mesh: Mesh, rays: Rays, start: StartPoints, seed: int = 0) -> tuple[Finding, ...]:
    """Return what rays find in a mesh that is made ready for them, with the points where its vertices' rays start.

    Nothing is changed. Buried vertices are healed when transfer is computed; an open part that is inside out is found by the
    rays of others that meet its back.
    """
    return (*buried(mesh, start), *seen_from_behind(mesh, rays, start, seed), *coincident_sheets(mesh, rays))


def buried(mesh: Mesh, start: StartPoints) -> tuple[Finding, ...]:
    """Count the vertices of each part that lie within solids or see the inside of something."""
    part = np.zeros(len(mesh.positions), np.int64)
    part[mesh.triangles] = mesh.part[:, np.newaxis]
    inside = np.bincount(part[start.buried], minlength=len(mesh.parts))
    whole = inside == np.bincount(part, minlength=len(mesh.parts))
    names = [one.name for one in mesh.parts]
    noun = "vertex/vertices within something"
    told = by_part(names, part[start.buried & ~whole[part]], "buried", noun, "lit as their neighbours outside", healed=True)
    lost = "all that the part has: it is hidden, or inside out, and stays dark"
    return (*told, *by_part(names, part[start.buried & whole[part]], "buried part", noun, lost, healed=False))


def seen_from_behind(mesh: Mesh, rays: Rays, start: StartPoints, seed: int = 0) -> tuple[Finding, ...]:
    """Count the rays, of vertices that see out, that meet a part from behind, for parts where that is a quarter or more."""
    open_eyed = np.flatnonzero(~start.buried)
    chosen = np.unique(np.linspace(0, len(open_eyed), _LOOKERS, endpoint=False).astype(np.int64))
    lookers = open_eyed[chosen[: len(open_eyed)]]
    met, behind = np.zeros(len(mesh.parts), np.int64), np.zeros(len(mesh.parts), np.int64)
    facing, local = mesh.facing, cosine_fibonacci(_LOOKS)
    for block in chunks(len(lookers), _CHUNK):
        mine = lookers[block]
        spins = 2.0 * np.pi * generator(seed, _PURPOSE, block.start).random(len(mine))
        along = (local @ frames(mesh.normals[mine], spins).transpose(0, 2, 1)).reshape(-1, 3)
        hits = rays.nearest(np.repeat(start.points[mine], _LOOKS, axis=0), along)
        triangle, from_behind = _behind(hits, along, facing)
        met += np.bincount(mesh.part[triangle], minlength=len(met))
        behind += np.bincount(mesh.part[triangle[from_behind]], minlength=len(met))
    return tuple(
        Finding(
            mesh.parts[i].name,
            "seen from behind",
            int(behind[i]),
            False,
            f"Part {mesh.parts[i].name!r}: {behind[i] / met[i]:.0%} of the rays that meet it come from behind, where it "
            "gives no light. It may be inside out: turn its faces, or give it a back.",
        )
        for i in np.flatnonzero((behind >= _BEHIND * met) & (behind >= _FEWEST)).tolist()
    )


def coincident_sheets(mesh: Mesh, rays: Rays) -> tuple[Finding, ...]:
    """Count the triangles whose middle lies on another one that faces the same way.

    Where two coincide a ray meets either, so that of each pair at least one is counted. Two that face each other touch, as a
    box and the floor under it: nothing is seen of either.
    """
    facing, corners = mesh.facing, mesh.corners
    above = corners.mean(axis=1) + _ABOVE * rays.size * facing
    found = []
    for block in chunks(len(facing), _CHUNK):
        hits = rays.nearest(above[block], -facing[block])
        other = hits.met & (hits.triangle != np.arange(block.start, block.stop))
        same = np.abs(hits.distance - _ABOVE * rays.size) < _SAME * rays.size
        alike = np.einsum("nk,nk->n", facing[block], facing[hits.triangle]) > 0.0
        found.append(np.flatnonzero(other & same & alike) + block.start)
    part = mesh.part[np.concatenate(found)]
    noun = "triangle/triangles on top of others"
    names = [one.name for one in mesh.parts]
    return by_part(names, part, "coincident sheets", noun, "so that chance decides which one is seen", healed=False)


def _behind(hits: Hits, along: Array, facing: Array) -> tuple[Index, NDArray[np.bool_]]:
    """Return the triangles that rays met, and which of these were met from behind."""
    triangle = hits.triangle[hits.met]
    return triangle, np.einsum("nk,nk->n", along[hits.met], facing[triangle]) > 0.0
