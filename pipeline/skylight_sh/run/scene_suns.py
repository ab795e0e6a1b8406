"""Suns over the courtyard: the config's sky at one turbidity, its true weights, and those of the run's tables."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.config.schema import Config
from skylight_sh.config.wanted import table_names
from skylight_sh.light import sun_disc
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import sampling
from skylight_sh.quadrature.registry import suited
from skylight_sh.render.brute_force import Source
from skylight_sh.render.compared import Sky
from skylight_sh.render.emitters import Disc
from skylight_sh.run.from_config import read_table
from skylight_sh.run.plan import Inputs
from skylight_sh.runtime import Table
from skylight_sh.sphere import Harmonics
from skylight_sh.table.size import bytes_of

Array = NDArray[np.float64]

TURBIDITY = 3.0
_NODES = 96


@dataclass(frozen=True)
class Sun:
    """Where a sun stands: ``height`` and ``azimuth`` in degrees, from east (+x) towards north."""

    height: float
    azimuth: float

    @property
    def zenith(self) -> float:
        """Its zenith angle in radians."""
        return float(np.radians(90.0 - self.height))


# At noon, in the morning, and on the horizon, whose skies errors are told of; and as the sun sets on the arches alone.
SUNS = (Sun(52.0, -75.0), Sun(10.0, 10.0), Sun(2.0, -155.0))
SUNSET = Sun(7.0, -155.0)


def tables_of(config: Config, inputs: Inputs) -> dict[str, Table]:
    """Return the tables that light the scene: the recommended one, ``table``, and the smallest, ``smallest table``."""
    known = {name: read_table(inputs["select"], f"tables/{name}") for name in table_names(config)}
    return {"table": known[config.export.recommended], "smallest table": min(known.values(), key=bytes_of)}


def sky_of(config: Config, tables: dict[str, Table], sun: Sun, bands: int) -> Sky:
    """Return the sky of ``sun``, its disc left out, with ``bands`` bands of true weights and the tables' own."""
    names = [axis.name for axis in config.axes]
    values = np.array([{**config.scene.fixed, "sun_zenith": sun.zenith, "turbidity": TURBIDITY}[name] for name in names])
    harmonics, azimuth = Harmonics.even(bands), np.radians(sun.azimuth)
    job = sampling.Job(config.source, tuple(names), values.reshape(1, 1, -1), _NODES, harmonics, suited(config.light, bands))
    true = np.asarray(harmonics.unmirror(sampling.project_block(job).weights[0, 0]), dtype=np.float64)
    own = {
        name: np.asarray(table.whole(table.evaluate(values[np.newaxis])[0]), dtype=np.float64)
        for name, table in tables.items()
    }
    turned = {name: _turned(weights, azimuth) for name, weights in own.items()}
    return Sky(Source(_radiance(config, values, azimuth)), _turned(true, azimuth), turned)


def disc_of(config: Config, sun: Sun) -> Disc:
    """Return the sun's disc alone, dimmed by the air of the same turbidity."""
    light = config.light
    space = light.colour_space if isinstance(light, Preetham) else "srgb"
    azimuth, flat = np.radians(sun.azimuth), np.sin(sun.zenith)
    towards = np.array([flat * np.cos(azimuth), flat * np.sin(azimuth), np.cos(sun.zenith)])
    return Disc(towards, sun_disc.HALF_ANGLE, sun_disc.radiance(sun.zenith, TURBIDITY, space))


def falling(weights: Array) -> Array:
    """Return the irradiance in lux ``(3,)`` on the ground of a sky's weights ``(3, N*N)``.

    >>> even = np.zeros((3, 4)); even[:, 2] = np.sqrt(3 * np.pi / 4)
    >>> falling(even).round(4).tolist()
    [3.1416, 3.1416, 3.1416]
    """
    return np.asarray(weights[:, 2] * np.sqrt(4.0 * np.pi / 3.0))


def falling_from(disc: Disc) -> Array:
    """Return the same of a sun's disc."""
    return np.asarray(np.pi * np.sin(disc.half_angle) ** 2 * max(disc.direction[2], 0.0) * disc.radiance)


def _turned(weights: Array, azimuth: float) -> Array:
    return np.asarray(sphere.rotate_azimuth(weights, azimuth), dtype=np.float64)


def _radiance(config: Config, values: Array, azimuth: float) -> Callable[[Array], Array]:
    light, names = config.source, [axis.name for axis in config.axes]
    parameters = {name: np.array([value]) for name, value in zip(names, values, strict=True)}
    c, s = np.cos(azimuth), np.sin(azimuth)
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])

    def radiance(along: Array) -> Array:
        found, above = np.zeros(along.shape), along[..., 2] > 0.0
        found[above] = light.radiance(along[above] @ turn, parameters)
        return found

    return radiance
