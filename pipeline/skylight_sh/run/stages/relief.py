"""A brick wall with a normal map, from a lightmap of few bands and by the light on every normal (the tutorial's picture)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh.config.scenes_schema import ScenesSection
from skylight_sh.config.schema import Config
from skylight_sh.lightmap import evaluation, incident, texels
from skylight_sh.mesh.courtyard import courtyard
from skylight_sh.render import tone
from skylight_sh.run.executors import Advance, map_tasks
from skylight_sh.run.plan import Inputs
from skylight_sh.run.scene_pictures import compared_with
from skylight_sh.run.scene_suns import SUNS, falling, sky_of
from skylight_sh.store.dataset import Dataset
from skylight_sh.transfer import Rays

Array = NDArray[np.float64]

BANDS = (2, 3, 5, 7)
_MORNING = SUNS[1]
# The piece of the courtyard's western wall that is shown: its face, from south to north, and its height, in metres.
_FACE, _SOUTH, _LONG, _HIGH = -6.0, -3.2, 3.84, 2.16
# Metres of a brick and of the joint about it.
_BRICK, _COURSE, _JOINT = 0.32, 0.12, 0.018
# Fine texels along one of the lightmap.
_COARSE = 8
# Texels either way that share their rays where every normal is lit.
_SHARED = 2
_SEED = 11


def make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    """Bake the wall, and light every normal of it."""
    asked = config.report.scenes or ScenesSection.model_construct()
    rows, columns = asked.width * 9 // 16 // _SHARED, asked.width // _SHARED
    width, height = _SHARED * columns, _SHARED * rows
    mesh = courtyard()
    rays, leaving = Rays(mesh), inputs["pictures/courtyard"]["leaving"]
    sky = sky_of(config, {}, _MORNING, 2)
    relief, albedo = bricks(width, height)

    coarse = wall(max(2, width // _COARSE), max(2, height // _COARSE))
    sampling = incident.Sampling(asked.rays, seed=_SEED)
    baked = incident.bake(mesh, rays, coarse, sky.source.radiance, leaving, max(BANDS), sampling)
    lit = {}
    for bands in BANDS:
        lit[str(bands)] = evaluation.shade(evaluation.of(coarse, baked[..., : bands**2]), relief, "clamped")

    def exactly(row: int) -> Array:
        # Neighbours share their rays: a place sees the same from so near, whatever its normal.
        places = wall(columns, rows, row)
        turned = texels.world_normals(places.frames[..., np.newaxis, :, :], _grouped(relief, row))
        many = incident.Sampling(2 * asked.rays, seed=_SEED + 1 + row)
        found = incident.irradiance(mesh, rays, places, turned, sky.source.radiance, leaving, many)
        return found.reshape(1, columns, _SHARED, _SHARED, 3).swapaxes(1, 2).reshape(_SHARED, _SHARED * columns, 3)

    found = map_tasks(exactly, range(rows), executor="threads", workers=config.run.workers, advance=advance)
    lit["each normal"] = np.concatenate(found)
    pictures = {key: albedo * values / np.pi for key, values in lit.items()}
    everywhere = np.ones((height, width), dtype=bool)
    return Dataset(
        compared_with(
            "wall",
            pictures,
            "each normal",
            (pictures["each normal"],) * 2,
            everywhere,
            2.0 * tone.exposure(float(falling(sky.true) @ tone.LUMINANCE)),
        ),
        {},
    )


def wall(columns: int, rows: int, row: int | None = None) -> texels.Texels:
    """Return texels of the wall as one sees it from the court, or one ``row`` of them: the first at the top, north right."""
    y = _SOUTH + (np.arange(columns) + 0.5) * _LONG / columns
    z = _HIGH * (1.0 - (np.arange(rows) + 0.5) / rows)
    z = z if row is None else z[row : row + 1]
    points = np.stack(np.broadcast_arrays(np.float64(_FACE), y, z[:, np.newaxis]), axis=-1)
    return texels.of_points(
        points, np.broadcast_to([1.0, 0.0, 0.0], points.shape), np.broadcast_to([0.0, 1.0, 0.0], points.shape)
    )


def _grouped(relief: Array, row: int) -> Array:
    """Return a row of places' normals ``(1, columns, k, 3)``: those of the texels that share its rays."""
    strip = relief[_SHARED * row : _SHARED * (row + 1)]
    return strip.reshape(_SHARED, -1, _SHARED, 3).swapaxes(0, 1).reshape(1, -1, _SHARED * _SHARED, 3)


def bricks(columns: int, rows: int) -> tuple[Array, Array]:
    """Return a normal map ``(rows, columns, 3)`` of bricks in courses, and their albedo ``(rows, columns, 3)``."""
    x = (np.arange(columns) + 0.5) * _LONG / columns
    y = ((rows - np.arange(rows)) - 0.5)[:, np.newaxis] * _HIGH / rows
    course = np.floor(y / _COURSE)
    along = x + 0.5 * _BRICK * (course % 2.0)
    brick = np.floor(along / _BRICK)
    u, v = along / _BRICK - brick, y / _COURSE - course
    # The distance to the nearest joint, and how a brick's edge is rounded there.
    across = np.minimum(np.minimum(u, 1.0 - u) * _BRICK, np.minimum(v, 1.0 - v) * _COURSE)
    edge = np.clip(across / _JOINT - 0.5, 0.0, 1.0)
    edge = edge * edge * (3.0 - 2.0 * edge)
    draw = np.random.default_rng(_SEED)
    tint, tilt = draw.uniform(0.75, 1.15, (64, 64)), draw.uniform(-0.12, 0.12, (2, 64, 64))
    place = tuple(np.broadcast_arrays(course.astype(np.int64) % 64, brick.astype(np.int64) % 64))
    lumps = 0.0016 * np.sin(61.0 * along + 3.0 * np.sin(47.0 * y)) * np.sin(83.0 * y + 2.0 * np.sin(53.0 * along))
    depth = 0.012 * edge + edge * lumps
    slope_y, slope_x = np.gradient(depth, _HIGH / rows, _LONG / columns)
    normals = np.stack([edge * tilt[0][place] - slope_x, edge * tilt[1][place] + slope_y, np.ones_like(depth)], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    clay, mortar = np.array([0.52, 0.19, 0.11]), np.array([0.45, 0.42, 0.37])
    share = edge[..., np.newaxis]
    return normals, share * clay * tint[place][..., np.newaxis] + (1.0 - share) * mortar
