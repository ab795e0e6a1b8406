"""Transfer of a whole mesh: its pieces, chunk by chunk, and what they amount to."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from skylight_sh import sphere
from skylight_sh.mesh import Mesh
from skylight_sh.transfer.bounces import bounced, gather
from skylight_sh.transfer.rays import Rays
from skylight_sh.transfer.sampling import chunks
from skylight_sh.transfer.shadowed import shadowed, unshadowed
from skylight_sh.transfer.start_points import StartPoints, healing, start_points

Array = NDArray[np.float64]
Mapper = Callable[[Callable[[Any], Any], Sequence[Any]], Sequence[Any]]

# Vertices whose random numbers are drawn together, by whoever computes them.
CHUNK = 256


@dataclass(frozen=True)
class Options:
    """How transfer is computed: ``bands`` of the light, ``rays`` and ``gather_rays`` a vertex, and ``bounces``."""

    bands: int = 5
    rays: int = 1024
    gather_rays: int = 256
    bounces: int = 3
    seed: int = 0


@dataclass(frozen=True)
class Transfer:
    """What each vertex makes of the light.

    ``transfer`` ``(v, 3, N*N)``: its dot product with the light's weights is irradiance / pi, bounces included, before the
    vertex's own albedo. ``direct`` ``(v, N*N)`` is the same without bounces; ``spread`` ``(v,)`` the relative RMS of half
    the difference of two halves of the rays, ``error`` that of all vertices together. ``matrix`` ``(v, v)`` gathers what
    vertices send out, healed like transfer itself.
    """

    transfer: Array
    direct: Array
    spread: Array
    error: float
    start: StartPoints
    matrix: sparse.csr_array


def precompute(mesh: Mesh, options: Options, mapper: Mapper | None = None) -> Transfer:
    """Return the transfer of every vertex of ``mesh``; ``mapper`` applies a function to chunks, in order, where it likes."""
    rays = Rays(mesh)
    start = start_points(mesh, rays, options.seed)
    parts = chunks(len(mesh.positions), CHUNK)
    apply: Mapper = mapper or (lambda function, items: [function(item) for item in items])

    def seen(part: slice) -> Array:
        return shadowed(
            rays,
            start.points[part],
            mesh.normals[part],
            options.bands,
            count=options.rays,
            seed=options.seed,
            first=part.start,
        )

    def gathered(part: slice) -> sparse.csr_array:
        return gather(
            mesh,
            rays,
            start.points[part],
            mesh.normals[part],
            count=options.gather_rays,
            seed=options.seed,
            first=part.start,
        )

    heal = healing(mesh, start.buried)
    halves = np.concatenate(list(apply(seen, parts)), axis=1)
    direct = heal @ halves.mean(axis=0)
    if options.bounces:
        matrix = sparse.csr_array(heal @ sparse.csr_array(sparse.vstack(list(apply(gathered, parts)))))
    else:
        matrix = sparse.csr_array((len(direct), len(direct)))
    spread, error = spread_of(halves, ~start.buried)
    return Transfer(bounced(direct, mesh.albedo, matrix, options.bounces), direct, spread, error, start, matrix)


def spread_of(halves: Array, valid: NDArray[np.bool_]) -> tuple[Array, float]:
    """Return how far the mean of two halves ``(2, v, N*N)`` may be off: for each vertex ``(v,)``, and for all valid ones.

    That is the root of the sum of squares of half their difference over that of their mean.
    """
    off = np.square(0.5 * (halves[0] - halves[1])).sum(axis=1)
    mean = np.square(halves.mean(axis=0)).sum(axis=1)
    spread = np.sqrt(np.divide(off, mean, out=np.zeros_like(off), where=mean > 0.0))
    return spread, float(np.sqrt(off[valid].sum() / mean[valid].sum()))


def open_transfer(mesh: Mesh, bands: int) -> Array:
    """Return the transfer ``(v, 3, N*N)`` of a mesh that blocks nothing."""
    sphere.check_bands(bands)
    return np.repeat(unshadowed(mesh.normals, bands)[:, np.newaxis], 3, axis=1)
