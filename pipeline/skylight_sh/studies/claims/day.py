"""The README's first picture, a courtyard's day in slices: what lit it, and what share of its error is the table's."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.config.schema import Config
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import sampling
from skylight_sh.render import metrics
from skylight_sh.render.brute_force import Paths
from skylight_sh.render.picture import Sampling
from skylight_sh.render.scene import by_paths, through_transfer
from skylight_sh.run import from_views, pictures
from skylight_sh.runtime import rotate_azimuth
from skylight_sh.store.store import Store
from skylight_sh.table.size import bytes_of

Array = NDArray[np.float64]

SLICES, TURBIDITY = 8, 2.5
"""As `make reference` asks for the picture."""

_PROPORTIONS = 16 / 9
_NODES = 96
_POINTS = 4


def measure(config: Config, store: Path, rows: int, paths: int) -> dict[str, Any]:
    """Return what lit the slices of the day of a config's first view, and how far they are from brute force.

    ``table`` and ``bytes`` tell of the config's recommended table, under a mirrored Preetham sky. ``error`` is the relative
    RMSE over all pixels that show surfaces alone, sun and bounces included, against ``paths`` from each point, their noise
    left out; ``from_table`` that of the light by the table against the light by true weights of as many bands, over the same
    pixels' RMS. The picture has so many ``rows``. What the store lacks is computed first, about ten seconds. Raises
    UserError without the extras transfer and solar.
    """
    small = {"width": round(rows * _PROPORTIONS), "height": rows, "samples": _POINTS, "at": {"turbidity": TURBIDITY}}
    view = config.views[0].model_copy(update=small)
    studio = pictures.Studio(config, view, pictures.Asked(config.export.recommended), Store(store), lambda _: None)
    table, scene = studio.table, studio.scene
    if table is None or scene is None:
        raise ValueError(f"{config.name} has no transfer. Give a config with a mesh.")
    bounces, shown = studio.source.options.bounces, Sampling(_POINTS)
    slices: dict[str, list[Array]] = {name: [] for name in ("through", "one", "other", "off")}
    suns = from_views.day_of(view.sun, SLICES)
    for sun, columns in zip(suns, from_views.edges(view.width, SLICES), strict=True):
        light, camera = from_views.light_of(config, table, view, sun).light, from_views.camera_of(view, columns)
        by_table = replace(light, emitters=())
        by_truth = replace(by_table, weights=_true_weights(sun, table.table.bands))
        without_sun = [through_transfer(scene, one, camera, shown).radiance for one in (by_table, by_truth)]
        found = [by_paths(scene.surface, light, camera, shown, Paths(paths, bounces, seed)) for seed in (1, 2)]
        seen = found[0].share == 1.0
        made = through_transfer(scene, light, camera, shown).radiance
        parts = (made, found[0].radiance, found[1].radiance, without_sun[0] - without_sun[1])
        for name, part in zip(slices, parts, strict=True):
            slices[name].append(part[seen])
    through, one, other, off = (np.concatenate(parts) for parts in slices.values())
    return {
        "table": config.export.recommended,
        "bytes": bytes_of(table.table),
        "bands": table.table.bands,
        "slices": SLICES,
        "error": metrics.relative_rmse_of_halves(through, one, other),
        "from_table": float(np.sqrt(np.mean(np.square(off)) / np.mean(one * other))),
    }


def _true_weights(sun: from_views.Sun, bands: int) -> Array:
    """Return the weights ``(3, N*N)`` of a Preetham sky over its mirror image, straight from its quadrature."""
    light, held = Preetham(), sphere.Harmonics(bands)
    sets = np.array([[[sun.zenith, TURBIDITY]]])
    job = sampling.Job(light, ("sun_zenith", "turbidity"), sets, _NODES, held, "sun-centred")
    weights = sphere.mirror_ground(sampling.project_block(job).weights[0, 0], held)
    return np.asarray(rotate_azimuth(weights, np.array(sun.azimuth)), dtype=np.float64)
