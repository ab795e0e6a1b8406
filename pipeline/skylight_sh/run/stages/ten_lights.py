"""Ten spherical lights in the courtyard by night, diffuse and glossy, in few bands and by integration."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.config.scenes_schema import ScenesSection
from skylight_sh.config.schema import Config
from skylight_sh.mesh.courtyard import ENTRANCE, courtyard
from skylight_sh.reflectance import glossy, lobes
from skylight_sh.reflectance.spheres import Spheres, in_bands, integrated
from skylight_sh.render.surface import Points, Surface
from skylight_sh.render.view import View
from skylight_sh.run.executors import Advance, map_tasks
from skylight_sh.run.plan import Inputs
from skylight_sh.run.scene_pictures import compared_with
from skylight_sh.store.dataset import Dataset, Variable

Array = NDArray[np.float64]

BANDS = (3, 5, 7, 10)
_CHUNK = 1024
# The lobe of the glossy pictures, (n + 1) / (2 pi) cos^n about the mirror direction, and its share of the light.
_EXPONENT, _GLOSS = 16.0, 0.25
# Centre and radius in metres, and colour.
_LIGHTS = (
    ((-4.6, -0.6, 1.3), 0.32, (1.0, 0.30, 0.10)),
    ((-3.0, 1.6, 2.4), 0.28, (0.25, 1.0, 0.35)),
    ((0.4, 0.2, 2.7), 0.25, (1.0, 0.85, 0.55)),
    ((-3.9, 5.6, 2.2), 0.25, (1.0, 0.60, 0.25)),
    ((-0.5, 5.6, 2.2), 0.25, (1.0, 0.60, 0.25)),
    ((2.9, 5.6, 2.2), 0.25, (1.0, 0.60, 0.25)),
    ((1.2, -2.2, 0.45), 0.22, (1.0, 0.15, 0.65)),
    ((-1.9, -4.2, 0.5), 0.24, (0.10, 0.75, 1.0)),
    ((3.2, 1.6, 1.7), 0.26, (0.35, 0.35, 1.0)),
    ((5.4, -3.4, 1.3), 0.24, (0.75, 0.85, 1.0)),
)
_EXPOSURE = 30.0
# Lamps are drawn so much dimmer than they are, or no screen would tell their colours.
_DRAWN = 0.06


def make(config: Config, _: Inputs, advance: Advance) -> Dataset:
    """Light the courtyard by ten lights that nothing hides."""
    asked = config.report.scenes or ScenesSection.model_construct()
    lights = Spheres(*(np.array([light[k] for light in _LIGHTS]) for k in range(3)))
    surface = Surface(courtyard())
    view = View(surface, ENTRANCE.eye, ENTRANCE.target, ENTRANCE.field, width=asked.width, height=asked.width * 9 // 16)
    count = len(view.points.positions)
    parts = [slice(start, start + _CHUNK) for start in range(0, count, _CHUNK)]
    results = map_tasks(
        lambda part: _lit(view.points.some(part), view.along[view.seen][part], lights),
        parts,
        executor="threads",
        workers=config.run.workers,
        advance=advance,
    )
    lit = {name: np.concatenate([one[name] for one in results]) for name in results[0]}
    variables: dict[str, Variable] = {}
    balls, before = seen_lights(view, Spheres(lights.centres, lights.radii, _DRAWN * lights.radiance))
    for name in ("diffuse", "glossy"):
        pictures = {}
        for key in (*map(str, BANDS), "integrated"):
            radiance = lit[f"{name} {key}"]
            pictures[key] = view.picture(
                np.where(before[view.seen, np.newaxis], balls[view.seen], radiance), balls[~view.seen]
            )
        # Where a light itself is seen nothing is lost.
        shown = view.shown & (view.pixels(before[:, np.newaxis].astype(np.float64))[..., 0] == 0.0)
        variables |= compared_with(name, pictures, "integrated", (pictures["integrated"],) * 2, shown, _EXPOSURE)
    return Dataset(variables, {"exponent": _EXPONENT, "gloss": _GLOSS})


def _lit(points: Points, along: Array, lights: Spheres) -> dict[str, Array]:
    """Return radiance ``(n, 3)`` by name, seen along unit vectors ``along`` ``(n, 3)``."""
    mirrored = glossy.reflect(-along, points.normals)
    weights = lights.weights(points.positions, max(BANDS))
    found = {}
    for bands in BANDS:
        diffuse = in_bands(weights, points.normals, sphere.clamped_cosine(bands) / np.pi)
        found[str(bands)] = diffuse, in_bands(weights, mirrored, lobes.cosine_power(_EXPONENT, bands))
    found["integrated"] = (
        integrated(lights, points.positions, points.normals, 1.0),
        integrated(lights, points.positions, mirrored, _EXPONENT),
    )
    lit = {f"diffuse {key}": points.albedo * diffuse for key, (diffuse, _) in found.items()}
    shone = {
        f"glossy {key}": (1.0 - _GLOSS) * points.albedo * diffuse + _GLOSS * lobe for key, (diffuse, lobe) in found.items()
    }
    return lit | shone


def seen_lights(view: View, lights: Spheres) -> tuple[Array, NDArray[np.bool_]]:
    """Return the lights' own radiance ``(samples, 3)``, and where one stands before the mesh ``(samples,)``."""
    out, nearest = np.zeros(view.along.shape), np.where(view.hits.met, view.hits.distance, np.inf)
    before = np.zeros(len(out), dtype=bool)
    for centre, radius, radiance in zip(lights.centres, lights.radii, lights.radiance, strict=True):
        middle = view.along @ (centre - view.eye)
        depth = radius**2 - np.sum(np.square(centre - view.eye)) + middle**2
        distance = middle - np.sqrt(np.maximum(depth, 0.0))
        met = (depth > 0.0) & (distance > 0.0) & (distance < nearest)
        out[met], nearest[met], before[met] = radiance, distance[met], True
    return out, before
