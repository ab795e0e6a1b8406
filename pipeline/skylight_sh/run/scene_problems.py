"""What only reading a scene's pictures and summing its lamps can tell is wrong with a config."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from skylight_sh import MissingExtraError
from skylight_sh.config.problem import Problem, refusal
from skylight_sh.config.schema import Config
from skylight_sh.config.surroundings_schema import CloudsSection
from skylight_sh.probe import files
from skylight_sh.probe.layouts import most_bands
from skylight_sh.run.steps import surroundings_bands
from skylight_sh.scene.lamps import Lamp, Probe
from skylight_sh.scene.surroundings import mask_bands

# Beyond it float32 ends.
_BRIGHTEST = 1e30


def check(config: Config) -> None:
    """Raise ConfigError telling every lamp that cannot be and every picture that cannot be used, with its path."""
    found = list(find(config))
    if found:
        raise refusal(f"The scene of {config.name}", found)


def find(config: Config) -> Iterator[Problem]:
    """Yield every problem of a config that has no other; pictures are read."""
    most = surroundings_bands(config)[-1]
    if config.scene.clouds:
        yield from _picture(config, "$.scene.clouds.image", config.scene.clouds, mask_bands(most))
    for i, lamp in enumerate(config.scene.lights):
        path = f"$.scene.lights[{i}]"
        yield from _picture(config, f"{path}.image", lamp, most) if isinstance(lamp, Probe) else _lamp(path, lamp)


def _lamp(path: str, lamp: Lamp) -> Iterator[Problem]:
    try:
        largest = float(np.abs(lamp.weights(2, _unread)).max())
    except ValueError as error:
        yield Problem(path, lamp.kind, str(error))
        return
    if not largest <= _BRIGHTEST:
        told = f"Its weights reach {largest:.3g}. Dim it, or move it away: {_BRIGHTEST:g} is the most."
        yield Problem(path, lamp.kind, told)


def _unread(image: str) -> NDArray[np.floating]:
    raise ValueError(f"{image} is read by a lamp that names no picture.")


def _picture(config: Config, path: str, section: CloudsSection | Probe, needed: int) -> Iterator[Problem]:
    try:
        place = config.file(section.image)
        pixels = files.read_mask(place) if isinstance(section, CloudsSection) else files.read(place).pixels
        most = most_bands(section.layout, *pixels.shape[:2])
        if isinstance(section, Probe):
            # Finds pixels that are none.
            section.weights(1, lambda _: pixels)
            if not section.brightness * float(pixels.max()) <= _BRIGHTEST:
                yield Problem(path, section.image, f"brightness times its largest pixel exceeds {_BRIGHTEST:g}. Lower it.")
    except (ValueError, OSError, MissingExtraError) as error:
        yield Problem(path, section.image, str(error))
        return
    if most < needed:
        yield Problem(path, section.image, f"Resolves {most} bands; the winners need {needed}. Take a larger picture.")
