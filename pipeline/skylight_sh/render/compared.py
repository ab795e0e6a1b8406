"""The same points of a scene lit through transfer and by paths, so that each source of error stands alone.

Transfer is linear in the light, and every shortcut it takes can be undone one at a time: weights of a table for true ones,
transfer interpolated between vertices for transfer at the point itself, few bands for many, no bounces, no shadows.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh.texels import averaged
from skylight_sh.render import scene as lit_scene
from skylight_sh.render.brute_force import Paths, Source, by_bounces
from skylight_sh.render.brute_force import unshadowed as unshadowed_paths
from skylight_sh.render.emitters import Emitter
from skylight_sh.render.sunlight import even, straight
from skylight_sh.render.surface import Points, Surface
from skylight_sh.transfer import Options, Transfer, bounced, gather, shadowed, unshadowed
from skylight_sh.transfer.sampling import generator
from skylight_sh.transfer.start_points import healing

Array = NDArray[np.float64]

_PURPOSE, _SEED = 10, 1
# Shadow rays of a point.
_SHADOW = 16


@dataclass(frozen=True)
class Scene:
    """A mesh with its transfer ``(v, 3, N*N)``, that without bounces ``direct`` ``(v, N*N)``, and what vertices send out.

    ``sent`` ``(v, 3, N*N)`` is albedo times the transfer of all bounces but the last.
    """

    surface: Surface
    options: Options
    transfer: Transfer
    sent: Array


@dataclass(frozen=True)
class Sky:
    """A light with its SH weights ``(3, N*N)``: ``true`` ones, and others by name, which may have fewer bands."""

    source: Source
    true: Array
    tables: Mapping[str, Array]


def scene(surface: Surface, found: Transfer, options: Options) -> Scene:
    """Return the scene of a mesh whose transfer was ``found`` with ``options``, colours of textures averaged."""
    albedo = averaged(surface.mesh).albedo
    last = max(options.bounces - 1, 0)
    sent = albedo[:, :, np.newaxis] * bounced(found.direct, albedo, found.matrix, last)
    return Scene(surface, options, found, sent if options.bounces else np.zeros_like(sent))


def through_transfer(
    on: Scene, points: Points, skies: Sequence[Sky], bands: Sequence[int], *, first: int
) -> dict[str, Array]:
    """Return irradiance / pi ``(skies, n, 3)`` at a chunk of ``points`` by name.

    For each N of ``bands``, with the first table's weights: ``interreflected N``, the vertices' transfer interpolated,
    ``shadowed N``, the same without bounces, and ``unshadowed N``, without shadows; with true weights ``points N``, transfer
    computed at the point itself. With the middle number of bands, true weights: ``true``, the vertices' transfer, and
    ``sampling``, half the difference of two halves of the rays at the points. And what weights are off by each table,
    through the vertices' transfer, under the table's name.
    """
    options, surface = on.options, on.surface
    middle = sorted(bands)[len(bands) // 2]
    mixed, straight = points.interpolate(on.transfer.transfer), points.interpolate(on.transfer.direct)
    starts = surface.starts(points)
    known = {"seed": options.seed + _SEED, "first": first}
    halves = shadowed(surface.rays, starts, points.normals, options.bands, count=options.rays, **known)
    rows = gather(surface.mesh, surface.rays, starts, points.normals, count=options.gather_rays, **known)
    back = (rows @ on.sent.reshape(len(on.sent), -1)).reshape(mixed.shape)
    own = halves.mean(axis=0)[:, np.newaxis] + back
    found = {}
    table = [next(iter(sky.tables.values())) for sky in skies]
    true, bare = [sky.true for sky in skies], unshadowed(points.normals, options.bands)
    for n in bands:
        found[f"interreflected {n}"] = _lit(mixed, table, n)
        found[f"shadowed {n}"] = _lit(straight[:, np.newaxis], table, n)
        found[f"unshadowed {n}"] = _lit(bare[:, np.newaxis], table, n)
        found[f"points {n}"] = _lit(own, true, n)
    found["true"] = _lit(mixed, true, middle)
    for name in skies[0].tables:
        found[name] = _lit(mixed, [_off(sky.tables[name], sky.true) for sky in skies], middle)
    found["sampling"] = _lit(0.5 * (halves[0] - halves[1])[:, np.newaxis], true, middle)
    return found


def by_paths(on: Scene, points: Points, sources: Sequence[Source], *, count: int, first: int) -> dict[str, Array]:
    """Return irradiance / pi ``(sources, n, 3)`` at a chunk of ``points`` by name, by ``count`` paths each.

    ``unshadowed``, ``shadowed`` and ``interreflected``, all without what comes straight from emitters, and that alone,
    ``straight``.
    """
    paths = Paths(count, on.options.bounces, on.options.seed + _SEED)
    found = by_bounces(on.surface, points, sources, paths, first)
    shifts = generator(paths.seed, _PURPOSE, first).random((len(points.positions), 2))
    unit = even(_SHADOW, shifts)
    return {
        "unshadowed": unshadowed_paths(points, sources, paths, first),
        "shadowed": found[:, 0],
        "interreflected": found.sum(axis=1),
        "straight": np.stack([straight(on.surface, points, source.emitters, unit) for source in sources]),
    }


def sent_on(on: Scene, emitters: Sequence[Emitter]) -> Array:
    """Return irradiance / pi ``(v, 3)`` at the vertices by light of ``emitters`` that other surfaces send on."""
    mesh, found = on.surface.mesh, on.transfer
    between = lit_scene.Surroundings(found.start.points, healing(mesh, found.start.buried), found.matrix, on.options.bounces)
    whole = lit_scene.Scene(on.surface, averaged(mesh).albedo, found.transfer, between)
    return lit_scene.sunlight_sent_on(whole, emitters, on.options.seed)


def _off(weights: Array, true: Array) -> Array:
    bands = min(weights.shape[1], true.shape[1])
    return weights[:, :bands] - true[:, :bands]


def _lit(transfer: Array, weights: Sequence[Array], bands: int) -> Array:
    """Return transfer ``(n, 3 or 1, N*N)`` times each of ``weights`` ``(3, M*M)``, ``(lights, n, 3)``, in so many bands."""
    return np.stack(
        [
            np.einsum("pcw,cw->pc", np.broadcast_to(transfer, (len(transfer), 3, transfer.shape[2]))[..., :k], one[:, :k])
            for one in weights
            for k in [min(bands * bands, one.shape[1], transfer.shape[2])]
        ]
    )
