"""What the schema cannot see of a scene's surroundings: whether they fit the light, each other, and their pictures."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from skylight_sh import MissingExtraError
from skylight_sh.config.problem import Problem
from skylight_sh.config.schema import Config
from skylight_sh.config.surroundings_schema import CloudsSection, OccluderSection
from skylight_sh.probe import files, project
from skylight_sh.probe.layouts import most_bands, patches
from skylight_sh.scene.lamps import Lamp, Probe, Sphere
from skylight_sh.scene.surroundings import MOST_BANDS, mask_bands

Array = NDArray[np.float64]

# Beyond it float32 ends.
_BRIGHTEST = 1e30
_RGB = ("red", "green", "blue")


def find(config: Config) -> Iterator[Problem]:
    """Yield every problem."""
    yield from _together(config)
    yield from _spheres_and_lamps(config)
    most = max((winner.bands for winner in config.winners), default=1)
    most = max(most, min(config.truth.bands, MOST_BANDS)) if config.scene.masked else most
    if config.scene.clouds:
        yield from _picture(config, "$.scene.clouds.image", config.scene.clouds, mask_bands(most))
    for path, light in _lights(config):
        if isinstance(light, Probe):
            yield from _picture(config, f"{path}.image", light, most)


def _lights(config: Config) -> list[tuple[str, Lamp]]:
    return [(f"$.scene.lights[{i}]", light) for i, light in enumerate(config.scene.lights)]


def _together(config: Config) -> Iterator[Problem]:
    """Yield what does not go together, or not with the light."""
    scene, names = config.scene, config.source.channels
    if scene.masked and scene.quantity == "irradiance":
        remedy = 'What hides the sky acts on its radiance. Use "radiance", and take irradiance from the weights.'
        yield Problem("$.scene.quantity", scene.quantity, remedy)
    if scene.surrounded and scene.window:
        yield Problem("$.scene.window", True, "A window comes after the surroundings. Use false, and window at run time.")
    if scene.masked and scene.ground == "mirror":
        yield Problem("$.scene.ground", "mirror", "It would show a sky without what hides it. Use black, or albedos.")
    if scene.clouds and scene.twilight:
        remedy = "Clouds shine alike whatever the sun does. Leave twilight out, or the clouds."
        yield Problem("$.scene.twilight", True, remedy)
    for i, winner in enumerate(config.winners):
        if scene.masked and winner.bands > MOST_BANDS:
            remedy = (
                f"What hides the sky takes tables of at most {MOST_BANDS} bands: its products cost seconds and gigabytes."
            )
            yield Problem(f"$.winners[{i}].bands", winner.bands, f"{remedy} Ask for fewer.")
    coloured = [(path, light.colour) for path, light in _lights(config) if not light.image]
    coloured += [("$.scene.clouds.colour", scene.clouds.colour)] if scene.clouds else []
    for path, numbers in coloured:
        if len(numbers) != len(names):
            yield Problem(path, list(numbers), f"Give one number for each of the channels {', '.join(names)}.")
    for path, light in _lights(config):
        if isinstance(light, Probe) and (names != _RGB or getattr(config.light, "colour_space", "srgb") != "srgb"):
            remedy = "A picture is in linear sRGB. Use a light of red, green and blue in that space."
            yield Problem(f"{path}.image", light.image, remedy)


def _spheres_and_lamps(config: Config) -> Iterator[Problem]:
    """Yield what cannot be seen from the origin."""
    balls: dict[str, Sphere | OccluderSection] = {}
    balls |= {path: light for path, light in _lights(config) if isinstance(light, Sphere)}
    balls |= {f"$.scene.occluders[{i}]": occluder for i, occluder in enumerate(config.scene.occluders)}
    inside = {path: ball for path, ball in balls.items() if not ball.radius <= np.linalg.norm(ball.centre)}
    for path, ball in inside.items():
        away = f"its centre is {np.linalg.norm(ball.centre):g} away"
        yield Problem(f"{path}.radius", ball.radius, f"The receiver, at the origin, lies inside: {away}. Make it smaller.")
    for path, light in _lights(config):
        if light.image or path in inside:
            continue
        try:
            largest = float(np.abs(light.weights(2, _unread)).max())
        except ValueError as error:
            yield Problem(path, light.kind, str(error))
            continue
        if not largest <= _BRIGHTEST:
            told = f"Its weights reach {largest:.3g}. Dim it, or move it away: {_BRIGHTEST:g} is the most."
            yield Problem(path, light.kind, told)


def _unread(image: str) -> Array:
    raise ValueError(f"{image} is read by a lamp that names no picture.")


def _picture(config: Config, path: str, section: CloudsSection | Probe, needed: int) -> Iterator[Problem]:
    try:
        if "\0" in section.image or not (config.folder / section.image).resolve().is_relative_to(config.folder.resolve()):
            yield Problem(path, section.image, "Leaves the config's folder. Put the picture beside the config, or below.")
            return
        place = config.file(section.image)
        pixels = files.read_mask(place) if isinstance(section, CloudsSection) else files.read(place).pixels
        most = most_bands(patches(section.layout, *pixels.shape[:2]))
        if isinstance(section, Probe):
            project(pixels, section.layout, 1)
            if not section.brightness * float(pixels.max()) <= _BRIGHTEST:
                yield Problem(path, section.image, f"brightness times its largest pixel exceeds {_BRIGHTEST:g}. Lower it.")
    except (ValueError, OSError, MissingExtraError) as error:
        yield Problem(path, section.image, str(error))
        return
    if most < needed:
        yield Problem(path, section.image, f"Resolves {most} bands; the winners need {needed}. Take a larger picture.")
