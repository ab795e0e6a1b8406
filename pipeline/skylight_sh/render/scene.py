"""A whole scene in a picture: surfaces with their transfer, a light with its sun and lamps, through transfer or by paths."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from skylight_sh.render.brute_force import Paths, arriving
from skylight_sh.render.camera import Camera
from skylight_sh.render.emitters import Emitter
from skylight_sh.render.picture import Mapper, Picture, Sampling, Straight, take
from skylight_sh.render.relief import brightened
from skylight_sh.render.shading import lit, sent_on
from skylight_sh.render.sky import Lookup
from skylight_sh.render.sunlight import even, straight, unshaded
from skylight_sh.render.surface import Points, Surface
from skylight_sh.transfer import unshadowed
from skylight_sh.transfer.sampling import chunks, generator

Array = NDArray[np.float64]

_PURPOSE = 9
# Shadow rays of a vertex, and vertices looked at together.
_SHADOW, _CHUNK = 64, 2048


@dataclass(frozen=True)
class Light:
    """What shines: ``weights`` ``(3, N*N)`` of what transfer carries, the same as exact ``radiance``, and ``emitters``.

    ``ground`` ``(3,)`` is the radiance that a camera sees below the horizon beyond the surfaces; it lights nothing.
    """

    weights: Array
    radiance: Lookup
    emitters: tuple[Emitter, ...]
    ground: Array

    def behind(self, directions: Array) -> Array:
        """Return what a camera sees along unit vectors ``(n, 3)`` where there are no surfaces, ``(n, 3)``."""
        return np.where(directions[:, 2:] > 0.0, self.radiance(directions), self.ground)


@dataclass(frozen=True)
class Surroundings:
    """What light does between surfaces: where the vertices' rays start ``(v, 3)``, and two matrices ``(v, v)``.

    ``heal`` gives buried vertices their neighbours' light, ``gather`` collects what vertices send out, so often as
    ``bounces`` says.
    """

    starts: Array
    heal: sparse.csr_array
    gather: sparse.csr_array
    bounces: int


@dataclass(frozen=True)
class Scene:
    """Surfaces, their vertices' mean ``albedo`` ``(v, 3)``, their ``transfer`` ``(v, 3, N*N)`` and what is between them."""

    surface: Surface
    albedo: Array
    transfer: NDArray[np.floating]
    between: Surroundings


def through_transfer(
    scene: Scene, light: Light, camera: Camera, sampling: Sampling, mapper: Mapper | None = None
) -> Picture:
    """Return the picture by transfer; emitters shine by shadow rays, and on by the matrix that transfer gathers with."""
    values = lit(scene.transfer, light.weights)
    if light.emitters and scene.between.bounces:
        values = values + sunlight_sent_on(scene, light.emitters, sampling.seed, mapper)
    return _take(scene.surface, light, camera, values, sampling, straight, mapper)


def without_shadows(surface: Surface, light: Light, camera: Camera, sampling: Sampling, mapper: Mapper | None) -> Picture:
    """Return the picture whose surfaces see nothing of each other, emitters' shadows left out as well."""
    bands = round(np.sqrt(light.weights.shape[-1]))
    values = lit(unshadowed(surface.mesh.normals, bands), light.weights)
    return _take(surface, light, camera, values, sampling, unshaded, mapper)


def by_paths(
    surface: Surface, light: Light, camera: Camera, sampling: Sampling, paths: Paths, mapper: Mapper | None = None
) -> Picture:
    """Return the same picture by path tracing, ``paths.count`` from each point of each pixel."""

    def lighting(points: Points, first: int) -> Array:
        return arriving(surface, points, light.radiance, light.emitters, paths, first)

    return take(camera, surface, lighting, light.behind, light.emitters, sampling, mapper=mapper)


def sunlight_sent_on(scene: Scene, emitters: Sequence[Emitter], seed: int, mapper: Mapper | None = None) -> Array:
    """Return irradiance / pi ``(v, 3)`` at the vertices by light of ``emitters`` that other surfaces send on."""
    mesh, between = scene.surface.mesh, scene.between
    count = len(mesh.positions)
    corners, shares = np.repeat(np.arange(count)[:, np.newaxis], 3, axis=1), np.tile([1.0, 0.0, 0.0], (count, 1))
    vertices = Points(between.starts, mesh.normals, mesh.normals, scene.albedo, corners, shares)

    def chunk(part: slice) -> Array:
        shifts = generator(seed, _PURPOSE, part.start).random((part.stop - part.start, 2))
        return straight(scene.surface, vertices.some(part), emitters, even(_SHADOW, shifts))

    apply: Mapper = mapper or (lambda function, items: [function(item) for item in items])
    falling = between.heal @ np.concatenate(list(apply(chunk, chunks(count, _CHUNK))))
    return sent_on(falling, scene.albedo, between.gather, between.bounces)


def _take(
    surface: Surface,
    light: Light,
    camera: Camera,
    values: Array,
    sampling: Sampling,
    shining: Straight,
    mapper: Mapper | None,
) -> Picture:
    def lighting(points: Points, _: int) -> Array:
        return brightened(surface.mesh, points, points.interpolate(values), light.weights)

    return take(camera, surface, lighting, light.behind, light.emitters, sampling, shining, mapper)
