"""Transfer of a whole mesh: block by block, and what the blocks amount to."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from skylight_sh import sphere
from skylight_sh.mesh import Mesh
from skylight_sh.mesh.texels import averaged
from skylight_sh.transfer.bounces import bounced, gather
from skylight_sh.transfer.options import Options
from skylight_sh.transfer.rays import Rays
from skylight_sh.transfer.sampling import chunks
from skylight_sh.transfer.shadowing import shadowed, unshadowed
from skylight_sh.transfer.start_points import StartPoints, healing, start_points

Array = NDArray[np.float64]
Arrays = Mapping[str, NDArray[Any]]
# Applies a function to slices of the vertices, wherever it likes, and returns the results in order.
Mapper = Callable[[Callable[[slice], Arrays], Sequence[slice]], Sequence[Arrays]]

# Vertices whose random numbers are drawn together, and those of a block: what one task computes.
CHUNK, BLOCK = 256, 1024


@dataclass(frozen=True)
class Setup:
    """What every block needs; textures are averaged into the albedo of ``mesh``."""

    mesh: Mesh
    rays: Rays
    start: StartPoints
    options: Options


@dataclass(frozen=True)
class Transfer:
    """What each vertex makes of the light.

    ``transfer`` ``(v, 3, N*N)``: its dot product with the light's weights is irradiance / pi, bounces included, before the
    vertex's own albedo. ``direct`` ``(v, N*N)`` is the same without bounces; ``spread`` ``(v,)`` the relative RMS of half
    the difference of two halves of the rays, ``error`` that of all vertices together. ``matrix`` ``(v, v)`` gathers what
    vertices send out, healed like transfer itself; it is empty where there are no bounces.
    """

    transfer: Array
    direct: Array
    spread: Array
    error: float
    start: StartPoints
    matrix: sparse.csr_array


def precompute(mesh: Mesh, options: Options, mapper: Mapper | None = None) -> Transfer:
    """Return the transfer of every vertex of ``mesh``."""
    setup = prepare(mesh, options)
    apply: Mapper = mapper or (lambda function, parts: [function(part) for part in parts])
    parts = blocks_of(mesh)
    direct = apply(partial(see, setup), parts)
    indirect = apply(partial(collect, setup), parts) if options.bounces else []
    return finish(setup, direct, indirect)


def prepare(mesh: Mesh, options: Options) -> Setup:
    """Return what every block needs."""
    mesh = averaged(mesh)
    rays = Rays(mesh)
    return Setup(mesh, rays, start_points(mesh, rays, options.seed), options)


def blocks_of(mesh: Mesh) -> list[slice]:
    """Return the vertices of each block."""
    return chunks(len(mesh.positions), BLOCK)


def see(setup: Setup, block: slice) -> dict[str, NDArray[Any]]:
    """Return the shadowed transfer of a block's vertices by either half of their rays, ``halves`` ``(2, n, N*N)``."""
    options = setup.options
    found = [
        shadowed(
            setup.rays,
            setup.start.points[part],
            setup.mesh.normals[part],
            options.bands,
            count=options.rays,
            seed=options.seed,
            first=part.start,
        )
        for part in _chunks_of(block)
    ]
    return {"halves": np.concatenate(found, axis=1)}


def collect(setup: Setup, block: slice) -> dict[str, NDArray[Any]]:
    """Return a block's rows of the matrix that gathers light, as a sparse matrix's ``data``, ``indices`` and ``indptr``."""
    options = setup.options
    found = [
        gather(
            setup.mesh,
            setup.rays,
            setup.start.points[part],
            setup.mesh.normals[part],
            count=options.gather_rays,
            seed=options.seed,
            first=part.start,
        )
        for part in _chunks_of(block)
    ]
    rows = sparse.csr_array(sparse.vstack(found))
    # Half the memory; a share of one ray in 256 needs no more digits.
    return {"data": rows.data.astype(np.float32), "indices": rows.indices, "indptr": rows.indptr}


def finish(setup: Setup, direct: Sequence[Arrays], indirect: Sequence[Arrays]) -> Transfer:
    """Return the transfer that blocks of ``see`` and of ``collect`` amount to; the latter may be none, without bounces."""
    heal = healing(setup.mesh, setup.start.buried)
    halves = np.concatenate([block["halves"] for block in direct], axis=1)
    shadows = heal @ halves.mean(axis=0)
    matrix = gather_matrix(setup, indirect)
    whole = bounced(shadows, setup.mesh.albedo, matrix, setup.options.bounces)
    spread, error = spread_of(halves, ~setup.start.buried)
    return Transfer(whole, shadows, spread, error, setup.start, matrix)


def gather_matrix(setup: Setup, indirect: Sequence[Arrays]) -> sparse.csr_array:
    """Return the whole matrix ``(v, v)`` that gathers light, healed, of blocks of ``collect``; an empty one of none."""
    count = len(setup.mesh.positions)
    if not indirect:
        return sparse.csr_array((count, count))
    rows = [
        sparse.csr_array(
            (block["data"].astype(np.float64), block["indices"], block["indptr"]), shape=(len(block["indptr"]) - 1, count)
        )
        for block in indirect
    ]
    whole = sparse.csr_array(sparse.vstack(rows))
    buried = setup.start.buried
    if not buried.any():
        return whole
    return sparse.csr_array(healing(setup.mesh, buried) @ whole)


def spread_of(halves: Array, valid: NDArray[np.bool_]) -> tuple[Array, float]:
    """Return how far the mean of two halves ``(2, v, N*N)`` may be off: for each vertex ``(v,)``, and for all valid ones.

    That is the root of the sum of squares of half their difference over that of their mean; 0 where no light comes in.
    """
    off = np.square(0.5 * (halves[0] - halves[1])).sum(axis=1)
    mean = np.square(halves.mean(axis=0)).sum(axis=1)
    spread = np.sqrt(np.divide(off, mean, out=np.zeros_like(off), where=mean > 0.0))
    whole = float(mean[valid].sum())
    return spread, float(np.sqrt(off[valid].sum() / whole)) if whole > 0.0 else 0.0


def open_transfer(mesh: Mesh, bands: int) -> Array:
    """Return the transfer ``(v, 3, N*N)`` of a mesh that blocks nothing."""
    sphere.check_bands(bands)
    return np.repeat(unshadowed(mesh.normals, bands)[:, np.newaxis], 3, axis=1)


def _chunks_of(block: slice) -> list[slice]:
    return [slice(start, min(start + CHUNK, block.stop)) for start in range(block.start, block.stop, CHUNK)]
