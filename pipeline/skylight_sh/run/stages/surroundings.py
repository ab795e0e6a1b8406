"""Surroundings: what stands in the scene beside its sky, as maps of the weights, one for each winner's number of bands."""

from __future__ import annotations

import hashlib
from functools import partial
from importlib.metadata import version

import numpy as np
from numpy.typing import NDArray

from skylight_sh import probe, sphere
from skylight_sh.config.schema import Config
from skylight_sh.config.surroundings_schema import LightSection, ProbeLight, weights
from skylight_sh.light import spherical_lights
from skylight_sh.probe import files
from skylight_sh.reproducible import to_grid
from skylight_sh.run.executors import Advance
from skylight_sh.run.plan import Inputs, Step
from skylight_sh.store.dataset import Dataset, Variable
from skylight_sh.table.surroundings import MOST_BANDS, PARTS, build, mask_bands

Array = NDArray[np.float64]

# Of the largest number of a part, as in single precision: finer ones would be the last bits of who computed them.
_GRID_BITS = 24


def steps(config: Config) -> list[Step]:
    """Return the step; nothing where nothing surrounds the scene."""
    if not config.scene.surrounded:
        return []
    scene = config.scene
    pictures = [light.image for light in scene.lights if isinstance(light, ProbeLight)]
    pictures += [scene.clouds.image] if scene.clouds else []
    parameters = {
        "scene": scene.model_dump(mode="json"),
        "pictures": [hashlib.sha256(config.file(image).read_bytes()).hexdigest() for image in pictures],
        "reader": version("OpenImageIO") if pictures else "",
        "bands": _bands(config),
        "channels": config.source.channels,
    }
    return [Step("truth", "surroundings", (), parameters, partial(_make, config))]


def _bands(config: Config) -> list[int]:
    """Return the winners' numbers of bands, and that of a wider sky to hold their products against."""
    asked = {winner.bands for winner in config.winners}
    return sorted(asked | {min(config.truth.bands, MOST_BANDS)} if config.scene.masked else asked)


def _make(config: Config, _: Inputs, advance: Advance) -> Dataset:
    scene, found, asked = config.scene, dict[str, Variable](), _bands(config)
    # Pictures are read once: the weights of fewer bands are the first of those of more.
    clouds, lights = _clouds(config, mask_bands(asked[-1])), _lights(config, asked[-1])
    for done, bands in enumerate(asked):
        advance(done, len(asked))
        built = build(
            bands,
            skyline=scene.horizon,
            clouds=clouds and (clouds[0][: mask_bands(bands) ** 2], clouds[1]),
            occluders=_occluders(config),
            albedo=None if isinstance(scene.ground, str) else scene.ground,
            lights=lights[..., : bands * bands],
        )
        for part in PARTS:
            array = to_grid(getattr(built, part), _GRID_BITS)
            dims = tuple(f"{part}_{bands}_{axis}" for axis in range(array.ndim))
            found[f"{part}/{bands}"] = Variable(dims, array)
    return Dataset(found, {})


def _lights(config: Config, bands: int) -> Array:
    """Return the SH weights of all lamps and captured light, ``(channels, N*N)``; of size 0 where there are none."""
    scene = config.scene
    if not scene.lights:
        return np.zeros(0)
    radiance = np.sum([_light(config, light, bands) for light in scene.lights], axis=0)
    if scene.quantity == "radiance":
        return np.asarray(radiance)
    return sphere.scale_degrees(radiance, sphere.clamped_cosine(bands))


def _light(config: Config, light: LightSection, bands: int) -> Array:
    if not isinstance(light, ProbeLight):
        return weights(light, bands)
    pixels = files.read(config.file(light.image)).pixels
    captured = probe.blur(probe.project(pixels, light.layout, bands), light.blur)
    # A grey picture is given to all channels.
    return np.broadcast_to(light.brightness * captured, (len(config.source.channels), bands * bands))


def _occluders(config: Config) -> tuple[Array, Array] | None:
    """Return half-angles and directions of the occluders, if there are any."""
    found = config.scene.occluders
    return spherical_lights.half_angles([o.centre for o in found], [o.radius for o in found]) if found else None


def _clouds(config: Config, bands: int) -> tuple[Array, tuple[float, ...]] | None:
    """Return the SH weights of the clouds' opacity, ``(N*N,)``, and their radiance, if there are any."""
    clouds = config.scene.clouds
    if clouds is None:
        return None
    pixels = files.read_mask(config.file(clouds.image))
    return clouds.opacity * probe.project(pixels, clouds.layout, bands)[0], clouds.colour
