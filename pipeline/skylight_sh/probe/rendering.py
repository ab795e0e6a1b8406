"""Pictures of a light: what a perfect camera with square texels would store."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.probe.charts import Chart
from skylight_sh.probe.layouts import patches

if TYPE_CHECKING:
    from skylight_sh.light.protocol import Light, Parameters

Array = NDArray[np.float64]

# Directions held at once.
_BLOCK = 64_000


def render(light: Light, parameters: Parameters, layout: str, height: int, width: int, *, nodes: int = 2) -> Array:
    """Return the picture ``(height, width, channels)`` of a light over a black lower hemisphere, in the light's unit.

    Each texel holds the mean radiance over its solid angle: ``nodes`` x ``nodes`` Gauss-Legendre points in the chart's
    plane, weighted with the chart's density. A texel that the horizon crosses is split there exactly, and one
    that an angular map's rim cuts takes the mean of the points inside. ``parameters`` hold one value each, ``(1,)``. What no
    patch covers is 0.
    """

    def radiance(directions: Array) -> Array:
        return np.asarray(light.radiance(directions, parameters))

    out = np.zeros((height, width, len(light.channels)))
    for patch in patches(layout, height, width):
        u, v = patch.edges()
        step = max(1, _BLOCK // (patch.columns * nodes * nodes))
        for start in range(0, patch.rows, step):
            rows = v[start : start + step + 1]
            place = slice(patch.row + start, patch.row + start + rows.size - 1)
            out[place, patch.column : patch.column + patch.columns] = _means(patch.chart, radiance, u, rows, nodes)
    return out


def _means(chart: Chart, radiance: Callable[[Array], Array], u: Array, v: Array, nodes: int) -> Array:
    """Return the means over the cells between u and v, ``(rows, columns, channels)``."""
    x, w = sphere.gauss(nodes)
    across = ((u[1:] + u[:-1])[:, np.newaxis] + np.diff(u)[:, np.newaxis] * x) / 2
    total: Array | float = 0.0
    area: Array | float = 0.0
    # Side faces, angular maps and panoramas have their horizon on the line v = 0; the faces above and below have none
    # and are no worse for the cut.
    middle = np.clip(0.0, v[:-1], v[1:])
    for top, bottom in ((v[:-1], middle), (middle, v[1:])):
        if (bottom == top).all():
            continue
        down = ((bottom + top)[:, np.newaxis] + (bottom - top)[:, np.newaxis] * x) / 2
        points_u, points_v = np.broadcast_arrays(across[np.newaxis, :, np.newaxis], down[:, np.newaxis, :, np.newaxis])
        share = ((bottom - top) / np.diff(v))[:, np.newaxis, np.newaxis, np.newaxis] * np.outer(w, w)
        # The least weight keeps a mean where the rim leaves no point inside.
        share = share * (chart.density(points_u, points_v) + 1e-30)
        looks = chart.directions(points_u, points_v)
        lit = (looks[..., 2] > 0) & (share > 0)
        values = radiance(looks[lit])
        seen = np.zeros((*lit.shape, values.shape[-1]))
        seen[lit] = values
        total = total + np.einsum("rcij,rcijk->rck", share, seen)
        area = area + share.sum(axis=(2, 3))
    return np.asarray(total / np.asarray(area)[..., np.newaxis])
