"""Lighting: what every table loses of the light on surfaces, on sets of its own that neither fit nor selection saw."""

from __future__ import annotations

import dataclasses

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.config.schema import Config
from skylight_sh.config.wanted import table_names
from skylight_sh.fit.errors import Reference
from skylight_sh.light import Fixed, Light, Luminance
from skylight_sh.mesh.courtyard import ENTRANCE, courtyard
from skylight_sh.quadrature import parameter_points, sampling
from skylight_sh.quadrature.registry import suited
from skylight_sh.render import sensitivity
from skylight_sh.render.surface import Surface
from skylight_sh.render.view import View
from skylight_sh.run.executors import Advance, map_tasks
from skylight_sh.run.from_config import read_table, reference
from skylight_sh.run.plan import Inputs
from skylight_sh.runtime import Table
from skylight_sh.sphere import Harmonics
from skylight_sh.store.dataset import Dataset, Variable
from skylight_sh.table import lighting
from skylight_sh.table.lighting import Lighting, Surfaces
from skylight_sh.transfer import Options, precompute

Array = NDArray[np.float64]

# Irradiance of a sky of so many bands is within 1e-4 of the sky's own.
_BANDS, _NODES = 32, 64
_SETS, _EDGE, _SEED = 512, 32, 4_711
_SETS_PER_TASK = 64
# Of the picture: how fine the courtyard is, its rays, gather rays and bounces, pixels across, and suns in degrees.
_DETAIL, _RAYS, _WIDTH = 0.25, (64, 16, 2), 96
_AZIMUTHS = (20.0, 110.0, 200.0, 290.0)


def make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    """Measure every table."""
    on = surfaces_of(config, advance)
    found: dict[str, Variable] = {"sets": Variable(("set", "axis"), on.light.parameters)}
    tables = {name: read_table(inputs["select"], f"tables/{name}") for name in table_names(config)}
    form = picture_form(max(table.bands for table in tables.values()))
    for name, table in tables.items():
        measured = arrays(lighting.measure(table, on)) | {"picture": of_picture(form, table, on)}
        found |= {f"tables/{name}/{key}": Variable(("set",), values) for key, values in measured.items()}
    return Dataset(found, {"bands": _BANDS, "seed": _SEED})


def arrays(measured: Lighting) -> dict[str, Array]:
    """Return what was measured as arrays ``(sets,)`` by name: ``table/local``, ``bands/of_least``, ``bound`` and so on."""
    found = {
        f"{what}/{key}": values
        for what in ("table", "channel", "bands")
        for key, values in dataclasses.asdict(getattr(measured, what)).items()
    }
    return found if measured.bound is None else {**found, "bound": measured.bound}


def picture_form(bands: int) -> Array:
    """Return the form ``(3, N*N, N*N)`` of a picture of the courtyard through transfer (``render.sensitivity``).

    Few vertices and rays do: what weights are off by is weighed alike, and no picture is looked at. Raises UserError without
    the extra ``transfer``.
    """
    surface = Surface(courtyard(_DETAIL))
    found = precompute(surface.mesh, Options(bands, *_RAYS))
    view = View(surface, ENTRANCE.eye, ENTRANCE.target, ENTRANCE.field, width=_WIDTH, height=_WIDTH * 9 // 16, side=1)
    return sensitivity.gram(view.points.interpolate(found.transfer), view.points.albedo)


def of_picture(form: Array, table: Table, on: Surfaces) -> Array:
    """Return the relative RMSE ``(sets,)`` of a picture by the table's weights against true ones of as many bands.

    A table of irradiance, which transfer is not for, counts as the radiance that it comes from: its odd degrees beyond the
    first are lost.
    """
    rebuilt = np.asarray(table.whole(table.evaluate(on.light.parameters)), dtype=np.float64)
    true = on.whole[..., : table.bands**2]
    if table.spec.windowed:
        true = true * sphere.zonal_sinc(table.bands)
    if table.spec.quantity == "irradiance":
        factors = sphere.clamped_cosine(table.bands)
        kept = np.divide(1.0, factors, out=np.zeros_like(factors), where=factors != 0.0)
        rebuilt, true = sphere.scale_degrees(rebuilt, kept), sphere.scale_degrees(true, kept)
    return in_picture(form, rebuilt - true, true)


def in_picture(form: Array, off: Array, true: Array) -> Array:
    """Return the relative RMSE ``(sets,)`` of a picture whose light is ``off`` from ``true``, ``(sets, channels, N*N)``.

    The sun stands in the worst of four azimuths. A light of one channel lights what is green.
    """
    seen = form if true.shape[1] == len(form) else form[1:2]
    errors = [
        sensitivity.relative_rmse(seen, *(sphere.rotate_azimuth(part, np.radians(turn)) for part in (off, true)))
        for turn in _AZIMUTHS
    ]
    return np.asarray(np.max(errors, axis=0))


def surfaces_of(config: Config, advance: Advance) -> Surfaces:
    """Return surfaces below the config's light, sampled as ``sample`` does."""
    return lighting.surfaces(sample(config, advance), config.source.luminance_row, config.scene.quantity)


def sample(config: Config, advance: Advance) -> Reference:
    """Sample the config's light for 32 bands: 512 scrambled Sobol sets, 32 on each edge of the ranges, and the corners."""
    light, names = _light(config), tuple(axis.name for axis in config.axes)
    sets = sets_of(config)
    harmonics = Harmonics(_BANDS, light.hints.mirrored)
    blocks = parameter_points.chunks(sets, sampling.peak_of(light, names), _SETS_PER_TASK)
    rule = suited(light, _BANDS)
    jobs = [
        sampling.Job(light, names, sets[block], _NODES, harmonics, rule, config.truth.stated_tolerance) for block in blocks
    ]
    results = map_tasks(
        sampling.sample_block, jobs, executor=config.run.executor, workers=config.run.workers, advance=advance
    )
    weights, least = np.empty((len(sets), len(light.channels), harmonics.count)), np.empty(len(sets))
    for block, part in zip(blocks, results, strict=True):
        weights[block], least[block] = part.weights, part.least
    return reference(config, sets, weights, harmonics.degrees, least)


def sets_of(config: Config) -> Array:
    """Return the parameter sets ``(n, axes)`` that surfaces are looked at on."""
    return parameter_points.held_out([axis.range for axis in config.axes], _SETS, _EDGE, _SEED)


def _light(config: Config) -> Light:
    """Return the config's light with its hints, also where the fit is to know nothing of it: they spare time alone."""
    light: Light = config.light
    if config.scene.fixed:
        light = Fixed(light, tuple(sorted(config.scene.fixed.items())))
    return Luminance(light) if config.scene.channels == "luminance" and len(light.channels) > 1 else light
