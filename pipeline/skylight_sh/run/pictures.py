"""Pictures that a command asks for: what they need is taken from the store, or computed and kept there."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError, runtime
from skylight_sh.config.schema import Config
from skylight_sh.config.views_schema import ViewSection
from skylight_sh.config.wanted import table_names
from skylight_sh.render import lettering, tone
from skylight_sh.render.brute_force import Paths
from skylight_sh.render.picture import Picture, Sampling
from skylight_sh.render.scene import Scene, by_paths, through_transfer, without_shadows
from skylight_sh.render.surface import Surface
from skylight_sh.run import from_views, plan, progress
from skylight_sh.run.executors import map_tasks
from skylight_sh.run.from_config import read_table
from skylight_sh.run.mesh_source import MeshSource
from skylight_sh.run.steps import gather_step, mesh_source, steps, transfer_step
from skylight_sh.runtime import Runtime
from skylight_sh.store.store import Store

Array = NDArray[np.float64]
Warn = Callable[[str], None]
# Linear radiance, sRGB, and what there is to tell.
Made = tuple[Array, Array, str]

# Rows of a picture a dot of its letters is high.
_ROWS_A_DOT = 200
# The luminance of a picture's mean that shows as middle grey, where no sky or sun tells how much light there is.
_MIDDLE = 0.18


@dataclass(frozen=True)
class Asked:
    """How a view is rendered: by which ``table``, with how many ``bounces`` (None: the mesh's own), ``paths`` or transfer.

    With ``paths`` from each point it is brute force; ``unshadowed`` surfaces see nothing of each other.
    """

    table: str
    bounces: int | None = None
    paths: int = 0
    unshadowed: bool = False


def picture_of(config: Config, view: ViewSection, asked: Asked, store: Path, warn: Warn) -> Made:
    """Return the picture of a view."""
    return Studio(config, view, asked, Store(store), warn).take(from_views.sun_of(view.sun))


def frames_of(config: Config, view: ViewSection, asked: Asked, store: Path, count: int, warn: Warn) -> Iterator[Made]:
    """Yield ``count`` pictures of the view's day, from sunrise to sunset."""
    suns = from_views.day_of(view.sun, count)
    studio = Studio(config, view, asked, Store(store), warn)
    for sun in suns:
        yield studio.take(sun)


def slices_of(config: Config, view: ViewSection, asked: Asked, store: Path, count: int, warn: Warn) -> Made:
    """Return one picture in strips, each at another time of the view's day, with thin rules between and hours upon them."""
    suns = from_views.day_of(view.sun, count)
    studio = Studio(config, view, asked, Store(store), warn)
    strips = [studio.take(sun, columns) for sun, columns in zip(suns, from_views.edges(view.width, count), strict=True)]
    radiance, srgb = (np.concatenate([strip[k] for strip in strips], axis=1) for k in (0, 1))
    size = max(1, view.height // _ROWS_A_DOT)
    edges = list(from_views.edges(view.width, count))
    for sun, (first, last) in zip(suns, edges, strict=True):
        wide = lettering.dots(sun.clock).shape[1] * size
        # Where a strip is too narrow for its hour, it has none.
        if wide + 4 * size < last - first:
            srgb = lettering.written(srgb, sun.clock, view.height - 11 * size, (first + last - wide) // 2, size)
    srgb = lettering.ruled(srgb, np.array([first for first, _ in edges[1:]]), size)
    return radiance, srgb, f"{count} times from {suns[0].clock} to {suns[-1].clock}"


class Studio:
    """A view made ready: its table, surfaces and transfer, for as many suns as are asked for."""

    def __init__(self, config: Config, view: ViewSection, asked: Asked, store: Store, warn: Warn) -> None:
        source = mesh_source(config)
        if source is None:
            raise UserError('Pictures need surfaces. Add [scene.mesh] with file = "courtyard" to the config.')
        self.config, self.view, self.asked = config, view, asked
        bounces = source.options.bounces if asked.bounces is None else asked.bounces
        self.source = replace(source, unshadowed=False, options=replace(source.options, bounces=bounces))
        self.table = None if asked.paths else _table(config, asked.table, store, warn)
        self.scene = None if asked.paths or asked.unshadowed else _scene(config, self.source, store, warn)
        self.surface = self.scene.surface if self.scene else Surface(source.mesh(warn))

    def take(self, sun: from_views.Sun, columns: tuple[int, int] | None = None) -> Made:
        """Return the picture, or some columns of it, under one sun."""
        lit = from_views.light_of(self.config, self.table, self.view, sun)
        camera = from_views.camera_of(self.view, columns)
        sampling = Sampling(self.view.samples, seed=self.source.options.seed)
        with progress.bar("picture") as advance:
            mapper = partial(map_tasks, executor="threads", workers=self.config.run.workers, advance=advance)
            picture = self._picture(lit.light, camera, sampling, mapper)
        exposed = _exposure(lit.lux, picture.radiance) * 2.0**self.view.exposure
        return picture.radiance, tone.display(picture.radiance, exposed), self._told(sun, lit.lux)

    def _picture(self, light: Any, camera: Any, sampling: Sampling, mapper: Any) -> Picture:
        if self.asked.paths:
            paths = Paths(self.asked.paths, self.source.options.bounces, self.source.options.seed)
            return by_paths(self.surface, light, camera, sampling, paths, mapper)
        if self.scene is None:
            return without_shadows(self.surface, light, camera, sampling, mapper)
        return through_transfer(self.scene, light, camera, sampling, mapper)

    def _told(self, sun: from_views.Sun, lux: float) -> str:
        clock = f"{sun.clock}, " if sun.clock else ""
        by = f"by {self.asked.paths} paths a point" if self.table is None else f"by {self.asked.table}"
        return f"{clock}sun {90.0 - math.degrees(sun.zenith):.1f} degrees high, {lux / 1000.0:.3g} klx, {by}"


def _exposure(lux: float, radiance: Array) -> float:
    if lux > 0.0:
        return tone.exposure(lux)
    mean = float((radiance @ tone.LUMINANCE).mean())
    return _MIDDLE / mean if mean > 0.0 else 1.0


def _table(config: Config, name: str, store: Store, warn: Warn) -> Runtime:
    """Return a table of the config, or of an exported file."""
    if name.endswith(".npz"):
        try:
            return runtime.load(name)
        except (ValueError, OSError) as error:
            raise UserError(str(error)) from error
    if name not in table_names(config):
        raise UserError(f"{config.name} has no table {name!r}. Use one of: {', '.join(table_names(config))}; or an .npz.")
    return Runtime(read_table(_obtained(steps(config), "select", store, warn), f"tables/{name}"))


def _scene(config: Config, source: MeshSource, store: Store, warn: Warn) -> Scene:
    run = (config.run.executor, config.run.workers)
    found = [_obtained([step], step.name, store, warn) for step in (transfer_step(source, *run), gather_step(source, *run))]
    return from_views.scene_of(source, *found)


def _obtained(planned: list[plan.Step], name: str, store: Store, warn: Warn) -> Any:
    """Return the artifact of a step, made if the store lacks it, and nothing that it does not need."""
    known = {step.name: step for step in planned}
    needed: set[str] = set()
    waiting = [name]
    while waiting:
        one = waiting.pop()
        needed.add(one)
        waiting += [other for other in known[one].inputs if other not in needed]
    some = [step for step in planned if step.name in needed]
    return plan.execute(some, store, dict, progress.bar, warn, wanted=(name,))[1][name]
