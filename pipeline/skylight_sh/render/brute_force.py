"""The same light by path tracing: nothing expanded, nothing interpolated; what pictures through transfer are held against.

From each point a cosine-weighted Fibonacci set of paths is followed, later directions are drawn at random. A path that
leaves the scene reads the light itself; emitters are asked by a shadow ray wherever a path meets a surface, since none would
meet them by chance. What is met from behind sends nothing, and paths end after ``bounces``: in both transfer does the same.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.render.emitters import Emitter
from skylight_sh.render.sunlight import straight
from skylight_sh.render.surface import Points, Surface
from skylight_sh.transfer.sampling import cosine_fibonacci, frames, generator

Array = NDArray[np.float64]

_PURPOSE = 7


@dataclass(frozen=True)
class Paths:
    """How paths are followed: ``count`` from each point, ``bounces`` of them, with a ``seed``."""

    count: int
    bounces: int
    seed: int = 0


@dataclass(frozen=True)
class Source:
    """What shines: the ``radiance`` ``(k, 3)`` of unit vectors ``(k, 3)``, and ``emitters``."""

    radiance: Callable[[Array], Array]
    emitters: Sequence[Emitter] = ()


def arriving(
    surface: Surface,
    points: Points,
    radiance: Callable[[Array], Array],
    emitters: Sequence[Emitter],
    paths: Paths,
    first: int,
) -> Array:
    """Return irradiance / pi ``(n, 3)`` at ``points``, without what comes straight from ``emitters``.

    ``radiance`` gives what comes from unit vectors ``(k, 3)``, ``(k, 3)``; ``first`` tells chunks of points apart.
    """
    return np.asarray(by_bounces(surface, points, [Source(radiance, emitters)], paths, first)[0].sum(axis=0))


def by_bounces(surface: Surface, points: Points, sources: Sequence[Source], paths: Paths, first: int) -> Array:
    """Return the same of several ``sources`` along one set of paths, ``(sources, bounces + 1, n, 3)``.

    The second axis is the number of surfaces that the light came by.
    """
    random, n, count = generator(paths.seed, _PURPOSE, first), len(points.positions), paths.count
    along = _first(points, count, random)
    starts = np.repeat(surface.starts(points), count, axis=0)
    owner, throughput = np.repeat(np.arange(n), count), np.ones((n * count, 3))
    total = np.zeros((len(sources), paths.bounces + 1, n, 3))
    for bounce in range(paths.bounces + 1):
        hits = surface.rays.nearest(starts, along)
        free = ~hits.met
        for k, source in enumerate(sources):
            total[k, bounce] += _sums(owner[free], source.radiance(along[free]) * throughput[free], n)
        if bounce == paths.bounces:
            break
        met, front = surface.met(hits, along)
        owner, throughput = owner[front], throughput[front] * met.albedo
        unit = random.random((len(owner), 1, 2))
        for k, source in enumerate(sources):
            if source.emitters:
                total[k, bounce + 1] += _sums(owner, straight(surface, met, source.emitters, unit) * throughput, n)
        starts, along = surface.starts(met), _about(met.normals, random)
    return total / count


def unshadowed(points: Points, sources: Sequence[Source], paths: Paths, first: int) -> Array:
    """Return what would arrive along the same first directions if nothing stood about, ``(sources, n, 3)``."""
    n, count = len(points.positions), paths.count
    along = _first(points, count, generator(paths.seed, _PURPOSE, first))
    owner = np.repeat(np.arange(n), count)
    return np.stack([_sums(owner, source.radiance(along), n) for source in sources]) / count


def _first(points: Points, count: int, random: np.random.Generator) -> Array:
    """Return the first directions of ``count`` paths from each point, ``(n * count, 3)``."""
    local = cosine_fibonacci(count, start=random.random(), spin=2.0 * np.pi * random.random())
    turned = frames(points.normals, 2.0 * np.pi * random.random(len(points.normals)))
    return np.asarray(local @ turned.transpose(0, 2, 1)).reshape(-1, 3)


def _sums(owner: NDArray[np.int64], values: Array, count: int) -> Array:
    return np.stack([np.bincount(owner, weights=values[:, c], minlength=count) for c in range(3)], axis=-1)


def _about(normals: Array, random: np.random.Generator) -> Array:
    """Return directions ``(n, 3)`` about ``normals`` with density cos / pi (Malley's method)."""
    square, angle = random.random(len(normals)), 2.0 * np.pi * random.random(len(normals))
    radius = np.sqrt(square)
    local = np.stack([radius * np.cos(angle), radius * np.sin(angle), np.sqrt(1.0 - square)], axis=-1)
    return np.asarray(np.einsum("nij,nj->ni", frames(normals, np.zeros(len(normals))), local))
