"""Select: under each error budget the fastest or the smallest table, each budget a task of its own."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from skylight_sh.config.schema import Config
from skylight_sh.config.wanted import wanted
from skylight_sh.quadrature import parameter_points
from skylight_sh.run.config_axes import axes_of, fit_nodes, harmonics_of
from skylight_sh.run.executors import Advance, map_tasks
from skylight_sh.run.from_config import (
    degree_ranges,
    fit_of,
    reference,
    reference_of,
    scene_of,
    specification_of,
    surroundings_of,
)
from skylight_sh.run.plan import Inputs
from skylight_sh.run.steps import GRID, VERIFICATION, selected_on
from skylight_sh.scene.fold import window
from skylight_sh.store.dataset import Dataset, Variable
from skylight_sh.table import npz, selection
from skylight_sh.table.grid_fit import swept
from skylight_sh.table.selection import Point, SearchData, Selected

# One in so many of the sets that selection sees tells which degrees are enough.
_SWEPT_EACH = 8
# Products of basis functions up to which a search is short calls, half of them Python's own.
_FEW_TERMS = 256


def make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    """Select a table for every request."""
    data, asked = _gather(config, inputs), wanted(config)
    dense = inputs["fit"]["coefficients"]
    made = {request.name: selection.given(request, dense, data) for request in asked if request.degrees is not None}
    jobs = [partial(selection.select, group, data) for group in selection.groups(asked)]
    run = config.run
    # Threads that each do little at once wait for each other, and cost more than they save.
    alone = run.executor == "threads" and np.prod(np.add(data.degrees, 1)) <= _FEW_TERMS
    results = map_tasks(_call, jobs, executor=run.executor, workers=1 if alone else run.workers, advance=advance)
    fronts: dict[tuple[int, str], list[Point]] = {}
    for found in (one for group in results for one in group):
        made[found.request.name] = found.table
        fronts.setdefault((found.request.bands, found.request.layout), []).extend(found.tried)
    variables: dict[str, Variable] = {}
    for request in asked:
        data_ = np.frombuffer(npz.write(made[request.name]), dtype=np.uint8)
        variables[f"tables/{request.name}/npz"] = Variable(("byte",), data_)
    for (bands, layout), points in sorted(fronts.items()):
        front = np.array(selection.pareto_front(points))
        variables[f"fronts/{bands}-{layout}"] = Variable(("point", "bytes_error"), front)
    return Dataset(variables, {})


def _call(job: Callable[[], list[Selected]]) -> list[Selected]:
    return job()


def _gather(config: Config, inputs: Inputs) -> SearchData:
    grid = inputs[GRID]
    spec, axes = specification_of(config, inputs, harmonics_of(config, grid)), axes_of(config, inputs)
    nodes = fit_nodes(config, axes)
    checked = reference_of(config, inputs, selected_on(config))
    radiance = grid["weights"].reshape(-1, *grid["weights"].shape[-2:])
    bands = max(winner.bands for winner in config.winners)
    return selection.search_data(
        spec=spec,
        axes=axes,
        surroundings=surroundings_of(inputs),
        grid=reference(config, parameter_points.grid(nodes), radiance, grid["degree"], grid["least_luminance"].ravel()),
        shape=tuple(n.size for n in nodes),
        reference=checked,
        checked_shape=inputs[VERIFICATION]["least_luminance"].shape,
        degrees=tuple(axis.degrees[1] for axis in config.axes),
        sweep=swept(fit_of(config, inputs), checked.some(_SWEPT_EACH), degree_ranges(config), bands),
        window=partial(window, scene_of(config)),
    )
