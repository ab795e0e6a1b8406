"""A lit scene direction by direction: what the first bands of its weights are, without any product of expansions.

A table's surroundings are products of expansions cut to its bands (``table.surroundings``), and a wider sky is cut too: only
the scene itself tells how far its first bands are off. Here every direction of a dense grid is asked what is seen there:
an occluder, the ground, a cloud or the sky; and the basis is integrated over that.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.config.schema import Config
from skylight_sh.probe import files
from skylight_sh.quadrature import sampling
from skylight_sh.run.config_surroundings import build_all
from skylight_sh.scene.lamps import Lamp, Sphere, Spot

Array = NDArray[np.float64]

# Directions held at once.
_BLOCK = 100_000
_NODES = 96


def direct(config: Config, suns: Sequence[tuple[dict[str, float], float]], bands: int, rows: int) -> Array:
    """Return the weights ``(suns, channels, N*N)`` of a config's scene by ``rows`` x ``2 rows`` directions.

    ``suns`` are the light's parameters and the sun's azimuth in radians. Each of ``2 rows`` meridians has Gauss nodes from
    the zenith to the skyline and from there to the nadir, since a skyline that is nearly level would be missed by all
    meridians alike; an occluder's edge and a cloud's texel are met to a node's distance. Knows a skyline, clouds of a
    panorama, occluders, an even ground, spheres and spots; raises ValueError for another light, and for clouds of another
    layout.
    """
    shares, areas = sphere.gauss_unit(rows // 2)
    phi = (np.arange(2 * rows) + 0.5) * np.pi / rows
    ends = np.pi / 2 - _skyline(config.scene.horizon, phi)
    seen = np.zeros((len(suns), len(config.source.channels), bands * bands))
    falling, ground = np.zeros(seen.shape[:2]), np.zeros(bands * bands)
    step = max(1, _BLOCK // rows)
    for start in range(0, phi.size, step):
        end, around = (np.repeat(a[start : start + step], shares.size) for a in (ends, phi))
        share = np.tile(shares, end.size // shares.size)
        weight = np.tile(areas, end.size // shares.size) * np.pi / rows
        polar = end * share
        where, solid = _directions(polar, around), weight * end * np.sin(polar)
        free = ~_occluded(config, where)
        where, polar, around, solid = where[free], polar[free], around[free], solid[free]
        basis = sphere.basis(where, bands) * solid[:, np.newaxis]
        opacity, colour = _clouds(config, polar, around)
        for i, (parameters, azimuth) in enumerate(suns):
            light = (1.0 - opacity)[:, np.newaxis] * _sky(config, where, parameters, azimuth) + np.outer(opacity, colour)
            seen[i] += light.T @ basis
            falling[i] += light.T @ (where[:, 2] * solid)
        below, around = end + (np.pi - end) * share, np.repeat(phi[start : start + step], shares.size)
        where = _directions(below, around)
        free = ~_occluded(config, where)
        ground += (weight * (np.pi - end) * np.sin(below))[free] @ sphere.basis(where[free], bands)
    if not isinstance(config.scene.ground, str):
        seen += (np.array(config.scene.ground) / np.pi * falling)[..., np.newaxis] * ground
    return np.asarray(seen + sum((_lamp(light, bands) for light in config.scene.lights), np.zeros(seen.shape[1:])))


def _directions(polar: Array, around: Array) -> Array:
    return np.stack([np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar)], axis=-1)


def measure(
    config: Config, suns: Sequence[tuple[dict[str, float], float]], bands: int, rows: int
) -> dict[int, tuple[float, float]]:
    """Return, for the first 1, 2, .. ``bands`` bands, the least and largest error of a table of ``bands`` bands.

    Relative L2 over those bands, a channel at a time, over suns and channels: of a scene's exact sky in so many bands behind
    its transfer matrix, against ``direct``. A table's own error is not in it.
    """
    exact = direct(config, suns, bands, rows)
    (around,) = build_all(config, [bands])
    off = np.stack([around.apply(_expansion(config, *sun, bands), bands) for sun in suns]) - exact
    errors = {
        n: np.linalg.norm(off[..., : n * n], axis=-1) / np.linalg.norm(exact[..., : n * n], axis=-1)
        for n in range(1, bands + 1)
    }
    return {n: (float(found.min()), float(found.max())) for n, found in errors.items()}


def _expansion(config: Config, parameters: dict[str, float], azimuth: float, bands: int) -> Array:
    """Return the weights ``(channels, N*N)`` of the sky alone."""
    names = tuple(axis.name for axis in config.axes)
    values = np.array([[[parameters[name] for name in names]]])
    held = sphere.Harmonics.even(bands)
    job = sampling.Job(config.source, names, values, _NODES, held, "sun-centred", config.truth.stated_tolerance)
    weights = held.unmirror(sampling.project_block(job).weights[0, 0])
    return np.asarray(sphere.rotate_azimuth(weights, np.array(azimuth)), dtype=np.float64)


def _sky(config: Config, where: Array, parameters: dict[str, float], azimuth: float) -> Array:
    cosine, sine = np.cos(azimuth), np.sin(azimuth)
    turned = where @ np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    return np.asarray(config.source.radiance(turned, {name: np.array([value]) for name, value in parameters.items()}))


def _skyline(elevations: Sequence[float], around: Array) -> Array:
    """Return the skyline's elevation at azimuths of 0 to 2 pi: straight lines between its corners."""
    if not elevations:
        return np.zeros_like(around)
    return np.interp(around, np.linspace(0.0, 2 * np.pi, len(elevations) + 1), [*elevations, elevations[0]])


def _occluded(config: Config, where: Array) -> NDArray[np.bool_]:
    found = np.zeros(len(where), dtype=bool)
    for occluder in config.scene.occluders:
        found |= _inside(where, occluder.centre, occluder.radius)
    return found


def _inside(where: Array, centre: Sequence[float], radius: float) -> NDArray[np.bool_]:
    """Say which rays from the origin meet a sphere: those that pass its centre, before them, within its radius."""
    along = where @ np.array(centre)
    return np.asarray((along > 0) & (np.dot(centre, centre) - along**2 < radius**2))


def _clouds(config: Config, polar: Array, around: Array) -> tuple[Array, Array]:
    """Return the clouds' opacity in directions, that of the texel there, and their radiance."""
    clouds = config.scene.clouds
    if clouds is None:
        return np.zeros_like(polar), np.zeros(len(config.source.channels))
    if clouds.layout != "equirect":
        raise ValueError(f"Invalid layout {clouds.layout!r} of the clouds' picture. Should be 'equirect' here.")
    picture = files.read_mask(config.file(clouds.image))[..., 0]
    height, width = picture.shape
    # Azimuth pi stands on the left edge, and falls to the right.
    column = np.floor((np.pi - around) / (2 * np.pi) * width).astype(int) % width
    row = np.minimum((polar / np.pi * height).astype(int), height - 1)
    return clouds.opacity * picture[row, column], np.array(clouds.colour)


def _lamp(light: Lamp, bands: int) -> Array:
    """Return a lamp's weights ``(channels, N*N)``, a sphere's by directions of its own about its centre."""
    if isinstance(light, Sphere):
        where, solid = _cone(np.array(light.centre), light.radius)
        return np.asarray(np.multiply.outer(np.array(light.radiance), solid @ sphere.basis(where, bands)))
    if not isinstance(light, Spot):
        raise ValueError(f"Invalid light of kind {light.kind!r}. Should be a sphere or a spot here.")
    centre, axis = np.array(light.centre), np.array(light.axis)
    distance = float(np.linalg.norm(centre))
    cosine = -centre @ axis / (distance * float(np.linalg.norm(axis)))
    share = np.clip((cosine - np.cos(light.outer)) / (np.cos(light.inner) - np.cos(light.outer)), 0.0, 1.0)
    falling = np.array(light.intensity) * share**2 * (3 - 2 * share) / distance**2
    return np.asarray(np.multiply.outer(falling, sphere.basis(centre / distance, bands)))


def _cone(centre: Array, radius: float) -> tuple[Array, Array]:
    """Return directions ``(n, 3)`` that fill a sphere's disc as seen from the origin, and their solid angles ``(n,)``."""
    distance = float(np.linalg.norm(centre))
    ahead = centre / distance
    across = np.cross(ahead, np.eye(3)[np.abs(ahead).argmin()])
    across /= np.linalg.norm(across)
    x, areas = sphere.gauss(_NODES)
    least = np.sqrt(1.0 - (radius / distance) ** 2)
    cosine, areas = (1 + least + (1 - least) * x) / 2, (1 - least) / 2 * areas
    turn = (np.arange(_NODES) + 0.5) * 2 * np.pi / _NODES
    sine = np.sqrt(1 - cosine**2)[:, np.newaxis, np.newaxis]
    round_ = np.cos(turn)[:, np.newaxis] * across + np.sin(turn)[:, np.newaxis] * np.cross(ahead, across)
    where = cosine[:, np.newaxis, np.newaxis] * ahead + sine * round_
    return where.reshape(-1, 3), np.repeat(areas * 2 * np.pi / _NODES, _NODES)
