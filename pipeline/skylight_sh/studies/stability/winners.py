"""The published tables on sets nobody used before, and along a sun's path in steps of 0.01 degrees."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.errors import Reference, e_mean
from skylight_sh.runtime import Table
from skylight_sh.studies import outcomes, single_fit
from skylight_sh.studies.grid_samples import Samples, measured_at
from skylight_sh.studies.page import Row, Section
from skylight_sh.table.errors import measure

Array = NDArray[np.float64]

_SEED, _SETS = 90_210, 2_000
_STEP = np.radians(0.01)
SECOND = (
    "2,000 random parameter sets, by a seed that is used nowhere else, sampled anew: the largest per-set E_mean of each "
    "exported table beside the one it was published with. It holds where the ratio is 1 or below."
)
SMOOTH = (
    "The first axis moves in steps of 0.01 degrees (or of 1/9000 of its range) through its whole range and a hundred "
    "steps beyond each end, where tables clamp, at five values of the others. `error step`: the largest change of a "
    "table's error (against the whole fit in double precision, itself clamped) from one step to the next, as a share "
    "of L_min; it must stay below the table's own E_mean. `value step` and `slope step`: the largest change of the "
    "weights, and of their slope per degree, from one step to the next, likewise; the slope has its one jump where "
    "the clamp begins."
)


def second_verification(samples: Samples, tables: Mapping[str, Table], published: Mapping[str, float]) -> Section:
    """Measure every table on the new sets."""
    ranges = np.array([axis.range for axis in samples.config.axes])
    drawn = np.random.default_rng(_SEED).random((_SETS, len(ranges)))
    fresh = measured_at(samples.config, ranges[:, 0] + (ranges[:, 1] - ranges[:, 0]) * drawn)
    rows: list[Row] = []
    for name, table in tables.items():
        found = measure(table, fresh)
        error = float(found.e_mean[0, :, -1].max())
        rows.append({"table": name, "published E_mean": published[name], "E_mean": error, "ratio": error / published[name]})
    return Section("second-verification", "Published errors on 2,000 new sets", SECOND, rows, told=outcomes.again(rows))


def smoothness(samples: Samples, tables: Mapping[str, Table]) -> Section:
    """Step every table along the first axis."""
    config = samples.config
    first, *rest = config.axes
    low, high = first.range
    step = _STEP if config.source.domains[first.name].unit == "rad" else (high - low) / 9000
    path = np.arange(low - 100 * step, high + 100 * step, step)
    others = np.array([[a.range[0] + share * (a.range[1] - a.range[0]) for a in rest] for share in (0, 0.25, 0.5, 0.75, 1)])
    degrees = [min(axis.degrees[1], nodes.size - 1) for axis, nodes in zip(config.axes, samples.nodes, strict=True)]
    whole = single_fit.fit(samples, samples.half, degrees, "chebyshev", "svd", single_fit.OWN)
    rows: list[Row] = []
    for name, table in tables.items():
        error_step = value_step = slope_step = 0.0
        for other in others[: 1 if not rest else 5]:
            values = np.concatenate([path[:, np.newaxis], np.tile(other, (path.size, 1))], axis=1)
            clamped, _ = table.clamp(values)
            got = table.evaluate(clamped).astype(np.float64)
            count = got.shape[-1]
            dense = whole.dense[:, :count]
            sums = (whole.products(clamped) @ dense.reshape(dense.shape[0] * count, -1).T).reshape(len(got), -1, count)
            exact = whole.weights(clamped, sums, got.shape[1])
            l_min = _least(samples.reference, clamped)
            error_step = max(error_step, e_mean(np.diff(got - exact, axis=0), l_min[1:]))
            value_step = max(value_step, e_mean(np.diff(got, axis=0), l_min[1:]))
            slopes = np.diff(got, axis=0) / np.degrees(step)
            slope_step = max(slope_step, e_mean(np.diff(slopes, axis=0), l_min[1:-1]))
        rows.append({"table": name, "error step": error_step, "value step": value_step, "slope step": slope_step})
    return Section("smoothness", "Smoothness along the sun's path", SMOOTH, rows, told=outcomes.smoothness(rows))


def _least(reference: Reference, values: Array) -> Array:
    """Return L_min at the nearest measured set: a scale, right to a few per cent."""
    from scipy.spatial import cKDTree

    spread = np.ptp(reference.parameters, axis=0)
    nearest = cKDTree(reference.parameters / spread).query(values / spread)[1]
    return np.asarray(reference.headline[nearest])
