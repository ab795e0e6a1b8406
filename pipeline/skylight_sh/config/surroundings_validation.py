"""What the schema cannot see of a scene's surroundings: whether they fit the light and each other. No picture is read."""

from __future__ import annotations

import math
from collections.abc import Iterator

from skylight_sh.config.problem import Problem
from skylight_sh.config.schema import Config
from skylight_sh.config.surroundings_schema import OccluderSection
from skylight_sh.scene.lamps import Lamp, Sphere
from skylight_sh.scene.surroundings import MOST_BANDS

_RGB = ("red", "green", "blue")


def find(config: Config) -> Iterator[Problem]:
    """Yield every problem."""
    yield from _together(config)
    yield from _spheres(config)
    yield from _files(config)


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
        if light.image and (names != _RGB or getattr(config.light, "colour_space", "srgb") != "srgb"):
            remedy = "A picture is in linear sRGB. Use a light of red, green and blue in that space."
            yield Problem(f"{path}.image", light.image, remedy)


def _spheres(config: Config) -> Iterator[Problem]:
    """Yield what cannot be seen from the origin."""
    balls: dict[str, Sphere | OccluderSection] = {}
    balls |= {path: light for path, light in _lights(config) if isinstance(light, Sphere)}
    balls |= {f"$.scene.occluders[{i}]": occluder for i, occluder in enumerate(config.scene.occluders)}
    for path, ball in balls.items():
        away = math.hypot(*ball.centre)
        if not ball.radius <= away:
            told = f"The receiver, at the origin, lies inside: its centre is {away:g} away. Make it smaller."
            yield Problem(f"{path}.radius", ball.radius, told)


def _files(config: Config) -> Iterator[Problem]:
    """Yield the files that lie elsewhere; none is read."""
    named = [("$.scene.clouds.image", config.scene.clouds.image)] if config.scene.clouds else []
    named += [(f"{path}.image", light.image) for path, light in _lights(config) if light.image]
    named += [("$.scene.mesh.file", config.scene.mesh.file)] if config.scene.mesh else []
    folder = config.folder.resolve()
    for path, file in named:
        if "\0" in file or not (folder / file).resolve().is_relative_to(folder):
            yield Problem(path, file, "Leaves the config's folder. Put the file beside the config, or below.")
