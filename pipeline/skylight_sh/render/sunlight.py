"""Light straight from emitters, by shadow rays: at the points of a picture and at vertices, with soft shadows."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from skylight_sh.render.emitters import Emitter
from skylight_sh.render.surface import Points, Surface

Array = NDArray[np.float64]

_GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)
# Of the distance to a lamp, beyond which what is met no longer shades.
_SHORT = 1.0 - 1e-4


def straight(surface: Surface, points: Points, emitters: Sequence[Emitter], unit: Array) -> Array:
    """Return irradiance / pi ``(n, 3)`` at ``points`` straight from ``emitters``, by numbers ``unit`` ``(n, s, 2)``.

    A shadow ray starts at the surface that the interpolated normals suggest, a little above the triangle: shadows then end
    where a smooth surface turns away, not at edges (Hanika 2021).
    """
    total = np.zeros((len(points.positions), 3))
    starts = surface.smooth_starts(points)
    for emitter in emitters:
        found = emitter.towards(points.positions, unit)
        cosine = np.einsum("nsk,nk->ns", found.along, points.normals)
        lit = (cosine > 0.0) & (np.einsum("nsk,nk->ns", found.along, points.facing) > 0.0)
        owner, sample = np.nonzero(lit)
        lit[owner, sample] = _free(surface, starts[owner], found.along[owner, sample], found.distance[owner, sample])
        total += np.einsum("nsc,ns->nc", found.lux, cosine * lit) / (np.pi * unit.shape[1])
    return total


def unshaded(_: Surface, points: Points, emitters: Sequence[Emitter], unit: Array) -> Array:
    """Return the same as ``straight`` where nothing casts a shadow."""
    total = np.zeros((len(points.positions), 3))
    for emitter in emitters:
        found = emitter.towards(points.positions, unit)
        cosine = np.maximum(np.einsum("nsk,nk->ns", found.along, points.normals), 0.0)
        total += np.einsum("nsc,ns->nc", found.lux, cosine) / (np.pi * unit.shape[1])
    return total


def even(count: int, shifts: Array) -> Array:
    """Return ``count`` numbers of the unit square for each of ``shifts`` ``(n, 2)``, by which a Fibonacci lattice is moved.

    The result is ``(n, count, 2)``: each covers the square evenly.
    """
    k = np.arange(count)
    lattice = np.stack([(k + 0.5) / count, k * _GOLDEN], axis=-1)
    return np.asarray((lattice + shifts[:, np.newaxis]) % 1.0)


def _free(surface: Surface, starts: Array, along: Array, distance: Array) -> NDArray[np.bool_]:
    """Say which rays meet nothing before ``distance``."""
    if not len(starts):
        return np.zeros(0, dtype=bool)
    if np.isinf(distance).all():
        return ~surface.rays.occluded(starts, along)
    return np.asarray(surface.rays.nearest(starts, along).distance > _SHORT * distance)
