"""The courtyard under three suns, through transfer and by paths: day, sunset, shadows and bounces, sources of error."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh.config.scenes_schema import ScenesSection
from skylight_sh.config.schema import Config
from skylight_sh.mesh.courtyard import COLOURS, courtyard
from skylight_sh.mesh.courtyard.views import BENCH, ENTRANCE
from skylight_sh.mesh.courtyard.views import View as Place
from skylight_sh.mesh.texels import averaged
from skylight_sh.render import compared, tone
from skylight_sh.render.brute_force import Source
from skylight_sh.render.compared import Scene, Sky
from skylight_sh.render.emitters import Disc
from skylight_sh.render.surface import Points, Surface
from skylight_sh.render.view import View
from skylight_sh.run.executors import Advance, map_tasks
from skylight_sh.run.plan import Inputs
from skylight_sh.run.scene_pictures import compared_with
from skylight_sh.run.scene_suns import SUNS, SUNSET, disc_of, falling, falling_from, sky_of, tables_of
from skylight_sh.store.dataset import Dataset, Variable
from skylight_sh.transfer import Options, precompute

Array = NDArray[np.float64]

BANDS = (3, 5, 7)
# Points of a pixel, either way, and points of a task.
_SIDE, _CHUNK = 2, 256
_NOON, _MORNING = 0, 1


def make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    """Light the courtyard every way."""
    asked = config.report.scenes or ScenesSection.model_construct()
    surface = Surface(courtyard())
    options = Options(max(BANDS), asked.rays, max(8, asked.rays // 4), asked.bounces)

    def mapped(function: Callable[[Any], Any], items: Sequence[Any]) -> list[Any]:
        # Scenes stay in this process: they are large, and rays are the library's own.
        return map_tasks(function, items, executor="threads", workers=config.run.workers, advance=advance)

    found = precompute(surface.mesh, options, mapped)
    scene, tables = compared.scene(surface, found, options), tables_of(config, inputs)
    by_day, at_sunset = (_seen(surface, view, asked) for view in (ENTRANCE, BENCH))
    skies = [sky_of(config, tables, sun, max(BANDS)) for sun in SUNS]
    lit = _light(asked, scene, by_day.view.points, skies, disc_of(config, SUNS[_NOON]), mapped)
    variables = by_day.in_sunlight("day", skies, _NOON, disc_of(config, SUNS[_NOON]), lit)
    variables |= by_day.by_skylight(skies, lit) | by_day.sources(lit, len(skies))
    # What another step's wall receives from the rest of the courtyard.
    leaving = averaged(surface.mesh).albedo * np.einsum("vcw,cw->vc", found.transfer, skies[_MORNING].true)
    variables["leaving"] = Variable(("vertex", "channel"), leaving)
    evening, disc = [sky_of(config, tables, SUNSET, max(BANDS))], disc_of(config, SUNSET)
    lit = _light(asked, scene, at_sunset.view.points, evening, disc, mapped)
    variables |= at_sunset.in_sunlight("sunset", evening, 0, disc, lit)
    return Dataset(variables, {"vertices": len(found.direct), "transfer_error": found.error})


def _seen(surface: Surface, view: Place, asked: ScenesSection) -> _Compared:
    height = asked.width * 9 // 16
    return _Compared(View(surface, view.eye, view.target, view.field, width=asked.width, height=height, side=_SIDE))


def _light(
    asked: ScenesSection,
    scene: Scene,
    points: Points,
    skies: Sequence[Sky],
    disc: Disc,
    mapped: Callable[[Callable[[Any], Any], Sequence[Any]], list[Any]],
) -> dict[str, Array]:
    """Return irradiance / pi ``(lights, points, 3)`` by name, the disc the last of the lights.

    Brute force is there twice, by either half of its paths.
    """
    per_point = Options(
        scene.options.bands,
        max(2, scene.options.rays // _SIDE**2),
        max(2, scene.options.gather_rays // _SIDE**2),
        scene.options.bounces,
        scene.options.seed,
    )
    at_points = Scene(scene.surface, per_point, scene.transfer, scene.sent)
    half = max(1, asked.paths // _SIDE**2 // 2)
    sources = [*(sky.source for sky in skies), Source(np.zeros_like, [disc])]
    count = len(points.positions)

    def task(part: slice) -> dict[str, Array]:
        some = points.some(part)
        done = compared.through_transfer(at_points, some, skies, BANDS, first=part.start)
        for turn in range(2):
            by = compared.by_paths(scene, some, sources, count=half, first=part.start + turn * count)
            done |= {f"paths {turn} {name}": values for name, values in by.items()}
        return done

    parts = [slice(start, min(start + _CHUNK, count)) for start in range(0, count, _CHUNK)]
    results = mapped(task, parts)
    lit = {name: np.concatenate([one[name] for one in results], axis=1) for name in results[0]}
    lit["sent on"] = points.interpolate(compared.sent_on(scene, [disc]))
    return lit


class _Compared:
    """Pictures and errors of what a view shows."""

    def __init__(self, view: View) -> None:
        self.view = view

    def in_sunlight(
        self, name: str, skies: Sequence[Sky], k: int, disc: Disc, lit: Mapping[str, Array]
    ) -> dict[str, Variable]:
        """Return pictures of sky ``k`` and the sun's disc, in sRGB, and their errors."""
        # Straight sunlight is the same in all of them, by shadow rays: no few bands could hold it.
        straight = 0.5 * (lit["paths 0 straight"] + lit["paths 1 straight"])[-1]
        bounced = [lit[f"paths {turn} interreflected"] for turn in range(2)]
        halves = [half[k] + half[-1] + straight for half in bounced]
        through = {f"{n}": lit[f"interreflected {n}"][k] + lit["sent on"] + straight for n in BANDS}
        return self._pictures(name, skies[k], through, halves, falling(skies[k].true) + falling_from(disc))

    def by_skylight(self, skies: Sequence[Sky], lit: Mapping[str, Array]) -> dict[str, Variable]:
        """Return pictures of the morning's sky alone, unshadowed, shadowed and interreflected, and their errors."""
        found: dict[str, Variable] = {}
        for name in ("unshadowed", "shadowed", "interreflected"):
            through = {f"{n}": lit[f"{name} {n}"][_MORNING] for n in BANDS}
            halves = [lit[f"paths {turn} {name}"][_MORNING] for turn in range(2)]
            found |= self._pictures(name, skies[_MORNING], through, halves, falling(skies[_MORNING].true))
        return found

    def sources(self, lit: Mapping[str, Array], count: int) -> dict[str, Variable]:
        """Return the error ``(source, sun)`` of each source by itself, and ``noise``, the reference's own."""
        middle = BANDS[1]
        paths = tuple(lit[f"paths {turn} interreflected"][:count] for turn in range(2))
        own = (lit[f"points {middle}"],) * 2
        nothing = (np.zeros_like(paths[0]),) * 2
        # A picture, and twice what it is held to: two halves of the paths, whose noise is left out so.
        pairs = {
            "table": (lit["table"], nothing),
            "smallest table": (lit["smallest table"], nothing),
            "sampling": (lit["sampling"], nothing),
            "vertices": (lit["true"], own),
            **{f"{n} bands": (lit[f"points {n}"], paths) for n in reversed(BANDS)},
            "all": (lit[f"interreflected {middle}"], paths),
            "no bounces": (lit[f"shadowed {middle}"], paths),
            "no shadows": (lit[f"unshadowed {middle}"], paths),
        }
        whole = [_mean(self._seen(a), self._seen(b)) for a, b in zip(*paths, strict=True)]
        errors = np.zeros((len(pairs), count))
        for row, (picture, held) in enumerate(pairs.values()):
            for k in range(count):
                off = [self._seen(picture[k] - one[k]) for one in held]
                errors[row, k] = np.sqrt(max(_mean(*off), 0.0) / whole[k])
        noise = [
            np.sqrt(_mean(off, off) / w) for off, w in zip(map(self._seen, 0.5 * (paths[0] - paths[1])), whole, strict=True)
        ]
        return {
            "sources/source": Variable(("source",), np.array(list(pairs))),
            "sources/height": Variable(("sun",), np.array([sun.height for sun in SUNS]), {"units": "degrees"}),
            "sources/error": Variable(("source", "sun"), errors),
            "sources/noise": Variable(("sun",), np.array(noise)),
        }

    def _seen(self, lit: Array) -> Array:
        """Return the radiance ``(pixels, 3)`` of irradiance / pi, over the pixels that show the courtyard."""
        return np.asarray(self.view.picture(self.view.points.albedo * lit)[self.view.shown])

    def _pictures(
        self, name: str, sky: Sky, lit: Mapping[str, Array], halves: Sequence[Array], lux: Array
    ) -> dict[str, Variable]:
        """Return pictures of irradiance / pi by name before the sky, beside two halves of ``paths``.

        ``lux`` ``(3,)`` is what falls on the ground, sun and all.
        """
        along = self.view.along[~self.view.seen]
        # Beyond the last of the earth there is more of it.
        behind = np.where(along[:, 2:] > 0.0, sky.source.radiance(along), np.array(COLOURS["EARTH"]) * lux / np.pi)
        radiance = {key: self.view.picture(self.view.points.albedo * values, behind) for key, values in lit.items()}
        one, other = (self.view.picture(self.view.points.albedo * half, behind) for half in halves)
        shown = {**radiance, "paths": 0.5 * (one + other)}
        return compared_with(name, shown, "paths", (one, other), self.view.shown, tone.exposure(float(lux @ tone.LUMINANCE)))


def _mean(one: Array, other: Array) -> float:
    return float(np.mean(one * other))
