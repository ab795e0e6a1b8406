"""Light on points of a scene by paths, without any expansion: one set of paths for several lights, and by bounces.

What no expansion has touched is what pictures through transfer are held to. A point's first directions are a cosine-weighted
Fibonacci set, later ones are drawn at random; what a path meets sends on its albedo's share, from its front alone. The sun's
disc is asked for by shadow rays at every point of a path, since no path would meet it by chance.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.render.surface import Points, Surface
from skylight_sh.transfer.sampling import cosine_fibonacci, frames, generator

Array = NDArray[np.float64]

_PURPOSE = 5
# Shadow rays of a point that is looked at.
_SUN = 16


@dataclass(frozen=True)
class Light:
    """A sky, ``radiance`` of unit vectors ``(n, 3)`` above the horizon as ``(n, 3)``, black below, and perhaps a sun's disc.

    ``sun`` is a unit vector, ``half_angle`` the disc's in radians, ``disc`` its radiance ``(3,)``.
    """

    radiance: Callable[[Array], Array]
    sun: Array | None = None
    half_angle: float = 0.0
    disc: Array | None = None


@dataclass(frozen=True)
class Arrived:
    """Irradiance / pi at points: ``bounced`` ``(lights, bounces + 1, points, 3)`` by the number of surfaces that sent it on.

    ``unshadowed`` ``(lights, points, 3)`` is what would arrive if nothing stood about, ``sun`` ``(lights, points, 3)`` what
    comes straight from the discs, which ``bounced[:, 0]`` leaves out.
    """

    bounced: Array
    unshadowed: Array
    sun: Array


def arriving(
    surface: Surface,
    points: Points,
    lights: Sequence[Light],
    *,
    bounces: int,
    count: int,
    seed: int,
    first: int,
) -> Arrived:
    """Follow ``count`` paths from each of a chunk of ``points``; ``first`` is the index of the chunk's first point."""
    random = generator(seed, _PURPOSE, first)
    n = len(points.positions)
    local = cosine_fibonacci(count, start=random.random(), spin=2.0 * np.pi * random.random())
    along = (local @ frames(points.normals, 2.0 * np.pi * random.random(n)).transpose(0, 2, 1)).reshape(-1, 3)
    starts = np.repeat(surface.starts(points), count, axis=0)
    owner, throughput = np.repeat(np.arange(n), count), np.ones((n * count, 3))
    bounced = np.zeros((len(lights), bounces + 1, n, 3))
    unshadowed = np.stack([_mean(owner, _sky(light, along), n, count) for light in lights])
    sun = np.stack([_sunlit(surface, points, light, random, _SUN) for light in lights])
    for bounce in range(bounces + 1):
        hits = surface.rays.nearest(starts, along)
        free = ~hits.met
        for k, light in enumerate(lights):
            bounced[k, bounce] += _mean(owner[free], _sky(light, along[free]) * throughput[free], n, count)
        if bounce == bounces:
            break
        met, front = surface.met(hits, along)
        owner, throughput = owner[front], throughput[front] * met.albedo
        for k, light in enumerate(lights):
            # The sun's share of the next bounce: it shines on what was met.
            bounced[k, bounce + 1] += _mean(owner, _sunlit(surface, met, light, random, 1) * throughput, n, count)
        starts, along = surface.starts(met), _cosine(met.normals, random)
    return Arrived(bounced, unshadowed, sun)


def sunlight(surface: Surface, points: Points, light: Light, *, samples: int, seed: int, first: int) -> Array:
    """Return irradiance / pi ``(points, 3)`` straight from the sun's disc, by ``samples`` shadow rays a point."""
    return _sunlit(surface, points, light, generator(seed, _PURPOSE + 1, first), samples)


def _sunlit(surface: Surface, points: Points, light: Light, random: np.random.Generator, samples: int) -> Array:
    """Return irradiance / pi ``(n, 3)`` from the disc, its directions spread evenly and turned at random for each point."""
    n = len(points.positions)
    if light.sun is None or light.disc is None:
        return np.zeros((n, 3))
    k = np.arange(samples) + random.random((n, 1))
    height = 1.0 - (1.0 - np.cos(light.half_angle)) * k / samples
    angle = np.pi * (3.0 - np.sqrt(5.0)) * k + 2.0 * np.pi * random.random((n, 1))
    flat = np.sqrt(1.0 - height * height)
    disc = np.stack([flat * np.cos(angle), flat * np.sin(angle), height], axis=-1)
    along = disc.reshape(-1, 3) @ frames(light.sun[np.newaxis], np.zeros(1))[0].T
    cosine = np.maximum(np.einsum("nsk,nk->ns", along.reshape(n, samples, 3), points.normals), 0.0)
    lit = ~surface.rays.occluded(np.repeat(surface.starts(points), samples, axis=0), along).reshape(n, samples)
    # Where the surface itself turns away, no interpolated normal sees the sun.
    lit &= np.einsum("nsk,nk->ns", along.reshape(n, samples, 3), points.facing) > 0.0
    area = 2.0 * (1.0 - np.cos(light.half_angle))
    return np.asarray(area * (cosine * lit).mean(axis=1)[:, np.newaxis] * light.disc)


def _sky(light: Light, along: Array) -> Array:
    above = along[:, 2] > 0.0
    found = np.zeros(along.shape)
    found[above] = light.radiance(along[above])
    return found


def _mean(owner: NDArray[np.int64], values: Array, points: int, count: int) -> Array:
    """Return the sums of ``values`` ``(n, 3)`` by their owners over ``count``, ``(points, 3)``."""
    return np.stack([np.bincount(owner, weights=values[:, c], minlength=points) for c in range(3)], axis=-1) / count


def _cosine(normals: Array, random: np.random.Generator) -> Array:
    """Return directions about ``normals`` with density cos / pi: a unit vector at random, added."""
    height, angle = 2.0 * random.random(len(normals)) - 1.0, 2.0 * np.pi * random.random(len(normals))
    flat = np.sqrt(1.0 - height * height)
    summed = normals + np.stack([flat * np.cos(angle), flat * np.sin(angle), height], axis=-1)
    length = np.linalg.norm(summed, axis=-1, keepdims=True)
    return np.asarray(np.where(length > 1e-9, summed, normals) / np.where(length > 1e-9, length, 1.0))
