"""What arrives at texels, in SH: the sky where it is seen, and what surfaces send back where it is not.

Sloan, Kautz and Snyder 2002 for incident radiance as a linear function of the light's weights; O'Donnell 2018 for keeping it
at the texels of a lightmap. Rays go over the hemisphere above each texel, evenly, so that a surface's own lower half is
dark, whatever a normal map says. The sun's own disc belongs to the renderer and its shadows, not to a lightmap; what it
sends back from surfaces may be among ``leaving``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.lightmap.texels import Texels
from skylight_sh.mesh import Mesh
from skylight_sh.sphere import bands_of, basis, check_bands, spiral
from skylight_sh.transfer.rays import Rays
from skylight_sh.transfer.sampling import chunks, generator

Array = NDArray[np.float64]

# Texels of a chunk; each chunk has random numbers of its own.
_CHUNK = 16
_PURPOSE = 4


@dataclass(frozen=True)
class Sampling:
    """How rays are chosen: ``rays`` a texel, a ``seed``, and how far above the surface they start, over the mesh's size."""

    rays: int = 1024
    seed: int = 1
    height: float = 1e-5

    def __post_init__(self) -> None:
        if self.rays < 1 or not 0 <= self.height < 1:
            raise ValueError(f"Invalid sampling {self}. Should have a ray or more, and a height from 0 to 1.")


@dataclass(frozen=True)
class Seen:
    """What a chunk's rays meet: ``texels``, k of those covered, ``directions`` ``(k, n, 3)`` of ``solid_angle`` (sr) each.

    ``weights`` ``(k, n, 3)`` are those of the triangle's ``corners`` ``(k, n, 3)`` (indices of vertices) that a ray meets; 0
    where it meets none, or its back. ``free`` ``(k, n)`` says where the sky is seen.
    """

    texels: slice
    directions: Array
    solid_angle: float
    corners: NDArray[np.int64]
    weights: Array
    free: NDArray[np.bool_]


def bake(
    mesh: Mesh, rays: Rays, texels: Texels, sky: Callable[[Array], Array], leaving: Array, bands: int, sampling: Sampling
) -> Array:
    """Return the incident radiance's SH weights ``(..., channels, M*M)`` of ``bands`` bands, for one light.

    Beside the chart they are 0.
    ``sky`` takes unit vectors ``(n, 3)`` and returns their radiance ``(n, channels)``, the ground's below the horizon if
    there is any; ``leaving`` ``(v, channels)`` is what the mesh's vertices send back: albedo times irradiance over pi.
    """
    check_bands(bands)
    out = np.zeros((*texels.covered.shape, leaving.shape[1], bands * bands))
    flat = np.zeros((int(texels.covered.sum()), *out.shape[-2:]))
    for seen in meet(mesh, rays, texels, sampling):
        light = arriving(seen, sky, leaving)
        flat[seen.texels] = seen.solid_angle * (light.swapaxes(1, 2) @ basis(seen.directions, bands))
    out[texels.covered] = flat
    return out


def matrices(mesh: Mesh, rays: Rays, texels: Texels, leaving: Array, bands: int, sampling: Sampling) -> Array:
    """Return matrices ``(..., channels, M*M, N*N)`` that take a light's SH weights to those of the incident radiance.

    ``leaving`` ``(v, channels, N*N)`` is the mesh's transfer times its vertices' albedo: its dot product with the light's
    weights is the radiance that a vertex sends back. N is the light's number of bands, ``bands`` that of the result, M: 2 or
    3 hold an irradiance. One set of matrices serves any light; ``apply`` lights them. The sky is that of N bands, which
    overshoots where ``bake`` does not.
    """
    check_bands(bands)
    channels, size = leaving.shape[1:]
    light_bands = bands_of(leaving)
    out = np.zeros((*texels.covered.shape, channels, bands * bands, size))
    flat = np.zeros((int(texels.covered.sum()), *out.shape[-3:]))
    for seen in meet(mesh, rays, texels, sampling):
        above = basis(seen.directions, max(bands, light_bands))
        rows = seen.solid_angle * above[..., : bands * bands].swapaxes(1, 2)
        sky = rows @ (above[..., :size] * seen.free[..., np.newaxis])
        for channel in range(channels):
            back = np.einsum("knj,knjw->knw", seen.weights, leaving[:, channel][seen.corners])
            flat[seen.texels, channel] = sky + rows @ back
    out[texels.covered] = flat
    return out


def apply(made: Array, weights: Array) -> Array:
    """Return incident weights ``(..., channels, M*M)`` of matrices ``(..., channels, M*M, N*N)`` under a light.

    ``weights`` ``(channels, N*N)`` are the light's; its bands beyond the matrices' are left out.

    >>> apply(np.ones((1, 4, 9)), np.ones((1, 16))).tolist()
    [[9.0, 9.0, 9.0, 9.0]]
    """
    return np.asarray(np.einsum("...cij,cj->...ci", made, weights[:, : made.shape[-1]]))


def irradiance(
    mesh: Mesh,
    rays: Rays,
    texels: Texels,
    normals: Array,
    sky: Callable[[Array], Array],
    leaving: Array,
    sampling: Sampling,
) -> Array:
    """Return the irradiance ``(..., k, channels)`` on ``normals`` ``(..., k, 3)`` of each texel, without any expansion.

    As if each of the k normals of a texel had been baked; not divided by pi. ``sky`` and ``leaving`` are those of ``bake``.
    """
    out = np.zeros((*normals.shape[:-1], leaving.shape[1]))
    held = normals[texels.covered]
    flat = np.zeros((*held.shape[:-1], leaving.shape[1]))
    for seen in meet(mesh, rays, texels, sampling):
        cosine = np.maximum(held[seen.texels] @ seen.directions.swapaxes(1, 2), 0.0)
        flat[seen.texels] = seen.solid_angle * (cosine @ arriving(seen, sky, leaving))
    out[texels.covered] = flat
    return out


def meet(mesh: Mesh, rays: Rays, texels: Texels, sampling: Sampling) -> Iterator[Seen]:
    """Yield what the rays of the covered texels meet, chunk by chunk.

    Each texel has the same even spiral of directions, turned about its normal by an angle of its own. The back of a
    triangle sends nothing.
    """
    points, frames = texels.points[texels.covered], texels.frames[texels.covered]
    local = spiral(2 * sampling.rays)[: sampling.rays]
    facing = mesh.facing
    for block in chunks(len(points), _CHUNK):
        turn = 2 * np.pi * generator(sampling.seed, _PURPOSE, block.start).random((block.stop - block.start, 1))
        c, s = np.cos(turn), np.sin(turn)
        x, y, z = local.T
        spun = np.stack(np.broadcast_arrays(c * x - s * y, s * x + c * y, z), axis=-1)
        directions = spun @ frames[block]
        starts = points[block] + sampling.height * rays.size * frames[block, 2]
        along = directions.reshape(-1, 3)
        hits = rays.nearest(np.repeat(starts, sampling.rays, axis=0), along)
        met = hits.met
        triangle = np.where(met, hits.triangle, 0)
        front = met & (np.sum(along * facing[triangle], axis=-1) < 0)
        weights = np.stack([1 - hits.u - hits.v, hits.u, hits.v], axis=-1)
        shape = directions.shape[:2]
        yield Seen(
            block,
            directions,
            2 * np.pi / sampling.rays,
            mesh.triangles[triangle].reshape(*shape, 3),
            np.where(front[:, np.newaxis], weights, 0.0).reshape(*shape, 3),
            ~met.reshape(shape),
        )


def arriving(seen: Seen, sky: Callable[[Array], Array], leaving: Array) -> Array:
    """Return the radiance ``(k, n, channels)`` that comes along a chunk's rays; ``sky`` and ``leaving`` as in ``bake``."""
    light: Array = np.einsum("knj,knjc->knc", seen.weights, leaving[seen.corners])
    light[seen.free] = sky(seen.directions[seen.free])
    return light
