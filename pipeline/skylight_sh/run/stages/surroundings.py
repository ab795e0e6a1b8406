"""Surroundings: what stands in the scene beside its sky, as maps of the weights, one for each winner's number of bands."""

from __future__ import annotations

import hashlib
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh import probe
from skylight_sh.config.schema import Config
from skylight_sh.light import spherical_lights
from skylight_sh.probe import files
from skylight_sh.run import scene_problems
from skylight_sh.run.executors import Advance
from skylight_sh.run.plan import Inputs, Step
from skylight_sh.run.scene_problems import bands_of
from skylight_sh.scene import lamps
from skylight_sh.scene.surroundings import Clouds, build, mask_bands, rounded
from skylight_sh.store.dataset import Dataset, Variable
from skylight_sh.table.surroundings import PARTS

Array = NDArray[np.float64]


def steps(config: Config) -> list[Step]:
    """Return the step; nothing where nothing surrounds the scene."""
    if not config.scene.surrounded:
        return []
    scene = config.scene
    pictures = [lamp.image for lamp in scene.lights if lamp.image]
    pictures += [scene.clouds.image] if scene.clouds else []
    parameters = {
        "scene": scene.model_dump(mode="json"),
        "pictures": [_sum(config.file(image)) for image in pictures],
        "reader": _reader() if pictures else "",
        "bands": bands_of(config),
        "channels": config.source.channels,
    }
    return [Step("truth", "surroundings", (), parameters, partial(_make, config))]


def _reader() -> str:
    try:
        return version("OpenImageIO")
    except PackageNotFoundError:
        return ""


def _sum(picture: Path) -> str:
    """Return the SHA-256 of a picture, or nothing where it cannot be read: the step then tells why."""
    try:
        return hashlib.sha256(picture.read_bytes()).hexdigest()
    except OSError:
        return ""


def _make(config: Config, _: Inputs, advance: Advance) -> Dataset:
    scene_problems.check(config)
    scene, asked = config.scene, bands_of(config)
    # Pictures are read once: the weights of fewer bands are the first of those of more.
    clouds = _clouds(config, mask_bands(asked[-1]))
    lights = lamps.total(scene.lights, asked[-1], len(config.source.channels), scene.quantity, partial(_read, config))
    found: dict[str, Variable] = {}
    for done, bands in enumerate(asked):
        advance(done, len(asked))
        built = rounded(
            build(
                bands,
                skyline=scene.horizon,
                clouds=clouds.first(mask_bands(bands)) if clouds else None,
                occluders=_occluders(config),
                albedo=None if isinstance(scene.ground, str) else scene.ground,
                lights=lights[..., : bands * bands],
            )
        )
        for part in PARTS:
            array = getattr(built, part)
            dims = tuple(f"{part}_{bands}_{axis}" for axis in range(array.ndim))
            found[f"{part}/{bands}"] = Variable(dims, array)
    return Dataset(found, {})


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
