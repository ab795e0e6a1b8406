"""A config's pictures as the plain objects that the numerics take: camera, sun, light, and the scene of its artifacts."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import date, datetime
from functools import partial
from itertools import pairwise
from zoneinfo import ZoneInfo

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from skylight_sh import UserError
from skylight_sh.config.schema import Config
from skylight_sh.config.views_schema import SkySunSection, ViewSection
from skylight_sh.light import spherical_lights, sun_disc
from skylight_sh.light.preetham import Preetham
from skylight_sh.light.protocol import Light as Model
from skylight_sh.mesh.texels import averaged
from skylight_sh.probe import files
from skylight_sh.render import emitters, sky, tone
from skylight_sh.render.camera import Camera
from skylight_sh.render.scene import Light, Scene, Surroundings
from skylight_sh.render.surface import Surface
from skylight_sh.run.from_config import scene_of as folded
from skylight_sh.run.mesh_source import MeshSource
from skylight_sh.runtime import Runtime, zonal_sinc
from skylight_sh.scene import lamps, solar
from skylight_sh.store.dataset import Dataset
from skylight_sh.table.twilight import BEGIN, DEPTH, fade
from skylight_sh.transfer.start_points import healing

Array = NDArray[np.float64]

# A day's pictures begin and end with the sun so high, degrees.
_LOWEST = 2.0


@dataclass(frozen=True)
class Sun:
    """Where a sun stands, in radians, and the clock's time there, where it is known."""

    zenith: float
    azimuth: float
    clock: str = ""


@dataclass(frozen=True)
class Lit:
    """A light, and the illuminance in lux that it gives the horizontal: what a picture is exposed by."""

    light: Light
    lux: float


def camera_of(view: ViewSection, columns: tuple[int, int] | None = None) -> Camera:
    """Return a view's camera, or that of some of its columns."""
    return Camera(view.eye, view.target, view.field, view.width, view.height, columns)


def sun_of(sun: SkySunSection) -> Sun:
    """Return where a view's sun stands; at the zenith where nothing is said. Raises MissingExtraError without Astral."""
    if sun.time is not None:
        return at_moment(place_of(sun), datetime.fromisoformat(sun.time), sun.timezone)
    height = 90.0 if sun.height is None else sun.height
    return Sun(math.radians(90.0 - height), math.radians(sun.azimuth or 0.0))


def place_of(sun: SkySunSection) -> solar.Place:
    """Return the place of a view. Raises UserError where it has none."""
    if sun.latitude is None or sun.longitude is None:
        raise UserError("A time needs a place. Give --place LATITUDE,LONGITUDE, or both in the view's sun.")
    return solar.Place(sun.latitude, sun.longitude)


def at_moment(place: solar.Place, moment: datetime, timezone: str) -> Sun:
    """Return where the sun stands; a moment without an offset is one of the clocks of ``timezone``."""
    aware = moment if moment.tzinfo else moment.replace(tzinfo=ZoneInfo(timezone))
    zenith, azimuth = solar.position(place, aware)
    return Sun(zenith, azimuth, aware.strftime("%H:%M"))


def day_of(sun: SkySunSection, count: int) -> list[Sun]:
    """Return ``count`` suns of the day of a view, from sunrise to sunset, evenly in time.

    The first and the last stand about 2 degrees high. Raises UserError where the sun does not rise so high, or for a view
    without date and place.
    """
    if sun.time is None:
        raise UserError("A day needs a date and a place. Give --time 2026-06-21 --place LATITUDE,LONGITUDE, or a view's.")
    place, when = place_of(sun), datetime.fromisoformat(sun.time)
    minutes = list(solar.moments(date(when.year, when.month, when.day), sun.timezone, 5))
    up = [moment for moment in minutes if solar.position(place, moment)[0] <= math.radians(90.0 - _LOWEST)]
    if len(up) < 2:
        raise UserError(f"The sun stays below {_LOWEST:g} degrees on {when.date()} there. Choose another day or place.")
    steps = np.linspace(0, len(up) - 1, count).round().astype(int).tolist() if count > 1 else [len(up) // 2]
    return [at_moment(place, up[step], sun.timezone) for step in steps]


def scene_of(source: MeshSource, transfer: Dataset, gathered: Dataset) -> Scene:
    """Return the scene of a mesh and of what the steps ``transfer`` and ``transfer/gather`` found of it."""
    mesh = source.mesh()
    count = len(mesh.positions)
    places = (gathered["data"].astype(np.float64), gathered["column"], gathered["row_start"])
    matrix = sparse.csr_array(places, shape=(count, count))
    heal = healing(mesh, gathered["healed"].astype(bool))
    between = Surroundings(gathered["start"], heal, matrix, source.options.bounces)
    return Scene(Surface(mesh), averaged(mesh).albedo, transfer["transfer"], between)


def light_of(config: Config, table: Runtime | None, view: ViewSection, sun: Sun) -> Lit:
    """Return the light of a view under a sun, with the weights of ``table``, or none without one.

    What shines from few directions, the sun's disc and lamps, is taken out of the weights: it shines by shadow rays. Raises
    UserError for a sun, parameters or bands that light or table do not have.
    """
    channels = len(config.source.channels)
    parameters, dim = _parameters(config, view, sun)
    disc = _disc(config, view, sun, parameters)
    over, around = _sky(config, sun, parameters, dim), _captured(config)
    ground = config.scene.ground
    if disc is not None:
        disc = _behind(config, over, disc)
    straight = np.zeros(3) if disc is None else _lux(disc)
    if not isinstance(ground, str):
        over = over.on_ground(ground, straight if config.scene.sun_disc else np.zeros(3))
    shining: list[emitters.Emitter] = [disc] if disc is not None else []
    shining += [made for lamp in config.scene.lights if (made := emitters.of_lamp(lamp)) is not None]
    falling = over.falling() + sum(_lux(one) for one in shining)
    earth = np.array(view.ground) * falling / np.pi
    weights = np.zeros((3, 1)) if table is None else _weights(config, table, view, sun, dim)
    if channels == 1:
        weights = np.broadcast_to(weights, (3, weights.shape[1]))
    light = Light(weights, sky.together([over.radiance, *around]), tuple(shining), earth)
    return Lit(light, float(falling @ tone.LUMINANCE))


def _parameters(config: Config, view: ViewSection, sun: Sun) -> tuple[dict[str, float], float]:
    """Return the light's parameters and what twilight multiplies it with."""
    peak = config.light.hints.peak_axis
    values = dict(view.at)
    if peak is None or peak in config.scene.fixed:
        return values, 1.0
    depth = sun.zenith - BEGIN
    if depth > 0.0 and not config.scene.twilight:
        raise UserError(
            f"The sun is {math.degrees(depth):.2g} degrees below the horizon, where this scene has no light. Choose another "
            "time, or set twilight = true in [scene]."
        )
    values[peak] = min(sun.zenith, BEGIN)
    return values, float(fade(min(depth / DEPTH, 1.0))) if depth > 0.0 else 1.0


def _weights(config: Config, table: Runtime, view: ViewSection, sun: Sun, dim: float) -> Array:
    """Return the weights ``(channels, N*N)`` of all that comes from everywhere."""
    peak = config.light.hints.peak_axis
    # Beyond the end of twilight there is nothing left of the sky.
    zenith = min(sun.zenith, BEGIN + DEPTH) if config.scene.twilight else sun.zenith
    known = {**view.at, "sun_azimuth": sun.azimuth, **({peak: zenith} if peak else {})}
    missing = [name for name in table.inputs if name not in known]
    if missing:
        raise UserError(f"The table needs {', '.join(missing)}. Give --at {missing[0]}=VALUE, or `at` in the view.")
    if table.table.spec.quantity != "radiance":
        raise UserError(f"This table holds {table.table.spec.quantity}; transfer takes radiance. Give another table.")
    weights, status = table.weights_and_status(*(known[name] for name in table.inputs))
    if status:
        ranges = ", ".join(
            f"{axis.name} [{low:.6g}, {high:.6g}]"
            for axis, (low, high) in zip(table.table.axes, table.table.ranges, strict=True)
        )
        raise UserError(f"The sun or the weather lies outside the table: {ranges}. Choose others.")
    found, bands = np.asarray(weights, dtype=np.float64), table.table.bands
    few = [lamp for lamp in config.scene.lights if not isinstance(lamp, lamps.Probe)]
    if few:
        found = found - lamps.total(few, bands, len(found), "radiance", partial(_pixels, config))
    folded_in = folded(config).sun
    if folded_in is not None:
        theta, tau = min(sun.zenith, BEGIN), {**config.scene.fixed, **view.at}[folded_in.turbidity]
        colour = folded_in.radiance(np.array(theta), np.array(tau))
        shape = sun_disc.disc(theta, _turned(table, sun), bands)
        window = zonal_sinc(bands) if table.table.spec.windowed else 1.0
        found = found - dim * colour[:, np.newaxis] * shape * window
    if view.bands > bands:
        raise UserError(f"Invalid bands {view.bands}. Should be 1 to {bands}, the bands of the table.")
    return found[:, : (view.bands or bands) ** 2]


def _turned(table: Runtime, sun: Sun) -> float:
    return sun.azimuth if table.table.spec.azimuth is None else table.table.spec.azimuth


def _disc(config: Config, view: ViewSection, sun: Sun, parameters: dict[str, float]) -> emitters.Disc | None:
    """Return the sun's disc; none below the horizon, where the view has none, or of a light without one."""
    if not view.disc or not isinstance(config.light, Preetham) or sun.zenith > BEGIN + sun_disc.HALF_ANGLE:
        return None
    azimuth = sun.azimuth if config.scene.azimuth is None else config.scene.azimuth
    flat = math.sin(sun.zenith)
    towards = np.array([flat * math.cos(azimuth), flat * math.sin(azimuth), math.cos(sun.zenith)])
    tau = {**config.scene.fixed, **parameters}["turbidity"]
    # A low sun's blue lies outside sRGB.
    colour = np.maximum(sun_disc.radiance(min(sun.zenith, BEGIN), tau), 0.0)
    if len(config.source.channels) == 1:
        colour = np.full(3, float(colour @ tone.LUMINANCE))
    return emitters.Disc(towards, sun_disc.HALF_ANGLE, colour)


def _behind(config: Config, over: sky.Sky, disc: emitters.Disc) -> emitters.Disc | None:
    """Return the disc as far as skyline, occluders and clouds let it through."""
    towards = disc.direction[np.newaxis]
    if config.scene.masked and not over.shows(towards)[0]:
        return None
    if over.opacity is None:
        return disc
    return emitters.Disc(disc.direction, disc.half_angle, (1.0 - float(over.opacity(towards)[0])) * disc.radiance)


def _lux(shining: emitters.Emitter) -> Array:
    """Return what far emitters give the horizontal, ``(3,)``; near ones have no one illuminance."""
    if isinstance(shining, emitters.Disc):
        return np.asarray(shining.radiance * np.pi * np.sin(shining.half_angle) ** 2 * max(shining.direction[2], 0.0))
    if isinstance(shining, emitters.Parallel):
        return np.asarray(shining.illuminance * max(shining.direction[2], 0.0))
    return np.zeros(3)


def _sky(config: Config, sun: Sun, parameters: dict[str, float], dim: float) -> sky.Sky:
    """Return the sky and what hides it, over black ground or a mirrored sky."""
    scene = config.scene
    model: Model = config.source
    hidden = None
    if scene.clouds:
        look = sky.texels(files.read_mask(config.file(scene.clouds.image)), scene.clouds.layout)
        hidden = partial(_opacity, look, scene.clouds.opacity)
    found = scene.occluders
    black = spherical_lights.half_angles([o.centre for o in found], [o.radius for o in found]) if found else None
    return sky.Sky(
        model,
        parameters,
        sun.azimuth if scene.azimuth is None else scene.azimuth,
        dim,
        "mirror" if scene.ground == "mirror" else (0.0, 0.0, 0.0),
        scene.horizon,
        hidden,
        tuple(np.broadcast_to(scene.clouds.colour, (3,)).tolist()) if scene.clouds else (0.0, 0.0, 0.0),
        black,
    )


def _opacity(look: sky.Lookup, share: float, directions: Array) -> Array:
    return share * look(directions)[:, 0]


def _captured(config: Config) -> list[sky.Lookup]:
    """Return the radiance of the scene's probes; their blur is for weights alone."""
    probes = [lamp for lamp in config.scene.lights if isinstance(lamp, lamps.Probe)]
    looks = [(sky.texels(_pixels(config, probe.image), probe.layout), probe.brightness) for probe in probes]
    return [partial(_bright, look, brightness) for look, brightness in looks]


def _bright(look: sky.Lookup, brightness: float, directions: Array) -> Array:
    return brightness * look(directions)


def _pixels(config: Config, image: str) -> NDArray[np.floating]:
    return files.read(config.file(image)).pixels


def edges(width: int, count: int) -> Iterator[tuple[int, int]]:
    """Yield the first column and one past the last of each of ``count`` slices of a picture.

    >>> list(edges(10, 3))
    [(0, 3), (3, 7), (7, 10)]
    """
    marks: Sequence[int] = np.linspace(0, width, count + 1).round().astype(int).tolist()
    yield from pairwise(marks)
