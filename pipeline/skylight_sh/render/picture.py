"""A picture: what a camera sees, point by point, several a pixel, before what is behind it all."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh.render.camera import Camera, spread
from skylight_sh.render.emitters import Emitter
from skylight_sh.render.relief import carved
from skylight_sh.render.sunlight import even, straight
from skylight_sh.render.surface import Points, Surface
from skylight_sh.transfer.sampling import chunks, generator

Array = NDArray[np.float64]
Mapper = Callable[[Callable[[Any], Any], Sequence[Any]], Sequence[Any]]
# Irradiance / pi (n, 3) at points; the number tells chunks apart.
Lighting = Callable[[Points, int], Array]
# Irradiance / pi (n, 3) straight from emitters, by numbers (n, s, 2).
Straight = Callable[[Surface, Points, Sequence[Emitter], Array], Array]

_PURPOSE = 8
# Points looked at together.
_CHUNK = 16384


@dataclass(frozen=True)
class Sampling:
    """How finely: ``pixel`` points in each pixel, ``shadow`` shadow rays of each point, and a ``seed``."""

    pixel: int = 16
    shadow: int = 2
    seed: int = 0


@dataclass(frozen=True)
class Picture:
    """Linear ``radiance`` ``(rows, columns, 3)``, and the ``share`` ``(rows, columns)`` of pixels that shows surfaces."""

    radiance: Array
    share: Array


def take(
    camera: Camera,
    surface: Surface,
    lighting: Lighting,
    behind: Callable[[Array], Array],
    emitters: Sequence[Emitter],
    sampling: Sampling,
    shining: Straight = straight,
    mapper: Mapper | None = None,
) -> Picture:
    """Return a picture of ``surface`` under ``lighting``, with the straight light of ``emitters``, ``behind`` it the rest.

    ``behind`` gives the radiance of unit vectors ``(n, 3)``. Emitters show themselves too; ``shining`` is how they shine.
    Every pixel has the same points within it, and its own turn of one even set of shadow rays. ``mapper`` applies a function
    to chunks, in order.
    """
    pixels = np.arange(camera.height * camera.width).reshape(camera.height, camera.width)[:, camera.shown].ravel()
    within = spread(sampling.pixel)
    # Not in step with where in the pixel they are.
    order = generator(sampling.seed, _PURPOSE, 0).permutation(sampling.pixel * sampling.shadow)

    def chunk(part: slice) -> tuple[Array, Array]:
        own = pixels[part]
        along = camera.through(own, within).reshape(-1, 3)
        eye = np.asarray(camera.eye, dtype=np.float64)
        origins = np.broadcast_to(eye, along.shape)
        hits = surface.rays.nearest(origins, along)
        points, front = surface.met(hits, along)
        points = carved(surface.mesh, points, hits.triangle[front])
        colour = np.zeros(along.shape)
        colour[~hits.met] = behind(along[~hits.met])
        shifts = generator(sampling.seed, _PURPOSE, 1 + part.start).random((len(own), 2))
        unit = even(len(order), shifts)[:, order].reshape(len(along), sampling.shadow, 2)[front]
        light = lighting(points, part.start * sampling.pixel)
        if emitters:
            light = light + shining(surface, points, emitters, unit)
        colour[front] = points.albedo * light
        for emitter in emitters:
            at, radiance = emitter.seen(eye, along)
            with np.errstate(invalid="ignore"):
                shown = (at < hits.distance) | (np.isinf(at) & ~hits.met)
            colour[shown] = radiance
        return colour.reshape(len(own), -1, 3).mean(axis=1), front.reshape(len(own), -1).mean(axis=1)

    apply: Mapper = mapper or (lambda function, items: [function(item) for item in items])
    done = apply(chunk, chunks(len(pixels), max(1, _CHUNK // sampling.pixel)))
    radiance, share = (np.concatenate(parts) for parts in zip(*done, strict=True))
    return Picture(radiance.reshape(camera.height, -1, 3), share.reshape(camera.height, -1))
