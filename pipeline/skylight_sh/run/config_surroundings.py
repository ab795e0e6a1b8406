"""A config's surroundings as the numerics know them: pictures read, occluders seen from the origin, lamps added up."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from skylight_sh import probe
from skylight_sh.config.schema import Config
from skylight_sh.light import spherical_lights
from skylight_sh.probe import files
from skylight_sh.runtime import Surroundings
from skylight_sh.scene import lamps
from skylight_sh.scene.surroundings import Clouds, build, mask_bands, rounded

Array = NDArray[np.float64]


def build_all(config: Config, asked: Sequence[int]) -> Iterator[Surroundings]:
    """Yield the surroundings for each number of bands ``asked``, rising; pictures are read once.

    The weights of fewer bands are the first of those of more. Raises ValueError or OSError for a picture that is none.
    """
    scene = config.scene
    clouds = _clouds(config, mask_bands(asked[-1]))
    lights = lamps.total(scene.lights, asked[-1], len(config.source.channels), scene.quantity, partial(_read, config))
    for bands in asked:
        yield rounded(
            build(
                bands,
                skyline=scene.horizon,
                clouds=clouds.first(mask_bands(bands)) if clouds else None,
                occluders=_occluders(config),
                albedo=None if isinstance(scene.ground, str) else scene.ground,
                lights=lights[..., : bands * bands],
            )
        )


def _read(config: Config, image: str) -> NDArray[np.floating]:
    return files.read(config.file(image)).pixels


def _occluders(config: Config) -> tuple[Array, Array] | None:
    """Return half-angles and directions of the occluders, if there are any."""
    found = config.scene.occluders
    return spherical_lights.half_angles([o.centre for o in found], [o.radius for o in found]) if found else None


def _clouds(config: Config, bands: int) -> Clouds | None:
    clouds = config.scene.clouds
    if clouds is None:
        return None
    pixels = files.read_mask(config.file(clouds.image))
    return Clouds(clouds.opacity * probe.project(pixels, clouds.layout, bands)[0], clouds.colour)
