"""Surroundings: what stands in the scene beside its sky, as maps of the weights, one for each winner's number of bands."""

from __future__ import annotations

import hashlib
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from skylight_sh.config.schema import Config
from skylight_sh.run import scene_problems
from skylight_sh.run.config_surroundings import build_all
from skylight_sh.run.executors import Advance
from skylight_sh.run.plan import Inputs, Step
from skylight_sh.run.scene_problems import bands_of
from skylight_sh.store.dataset import Dataset, Variable
from skylight_sh.table.surroundings import PARTS


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
    found, asked = dict[str, Variable](), bands_of(config)
    for done, (bands, built) in enumerate(zip(asked, build_all(config, asked), strict=True)):
        advance(done, len(asked))
        for part in PARTS:
            array = getattr(built, part)
            dims = tuple(f"{part}_{bands}_{axis}" for axis in range(array.ndim))
            found[f"{part}/{bands}"] = Variable(dims, array)
    return Dataset(found, {})
