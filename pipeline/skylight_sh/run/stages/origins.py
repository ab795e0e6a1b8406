"""Origins: what the 2008 paper's error may be made of, tested with the paper's own scheme on this run's grid."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from skylight_sh.config.schema import Config
from skylight_sh.fit import least_squares, paper_scheme
from skylight_sh.fit.errors import mean_luminance
from skylight_sh.quadrature import parameter_points
from skylight_sh.run.config_axes import axes_of, fit_nodes, harmonics_of
from skylight_sh.run.executors import Advance, map_tasks
from skylight_sh.run.from_config import reference_of
from skylight_sh.run.plan import Inputs
from skylight_sh.run.steps import GRID, selected_on
from skylight_sh.store.dataset import Dataset, Variable

Array = NDArray[np.float64]

# Side of the grid of cells, one random sample each, that stands for a truth.
_SIDES = (12, 18, 26, 36, 50)


def make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    """Try each of what the paper's error may be made of."""
    scheme = _scheme(config, inputs)
    total = len(_SIDES) + 1
    found = []
    for done, side in enumerate(_SIDES):
        advance(done, total)
        found.append(scheme.undersampling(_samples(config, scheme, side)))
    advance(len(_SIDES), total)
    errors = [scheme.rounding(solver) for solver in least_squares.SOLVERS]
    return Dataset(
        {
            "samples": Variable(("side",), np.array([s * s for s in _SIDES])),
            "solver": Variable(("solver",), np.array(list(least_squares.SOLVERS))),
            "solver_e_mean": Variable(("solver", "dtype"), np.array(errors)),
            **{key: Variable(("side",), np.array([one[key] for one in found])) for key in found[0]},
        },
        {"degrees": " x ".join(map(str, scheme.degrees)), "bands": scheme.bands},
    )


def _scheme(config: Config, inputs: Inputs) -> paper_scheme.Scheme:
    nodes, grid = fit_nodes(config, axes_of(config, inputs)), inputs[GRID]
    bands = min(paper_scheme.BANDS, config.truth.bands)
    weights = grid["weights"].reshape(-1, *grid["weights"].shape[-2:])
    stored = harmonics_of(config, grid).first(bands)
    exact = weights[..., : stored.count]
    reference = reference_of(config, inputs, selected_on(config))
    least = grid["least_luminance"].ravel()
    if "per-set" not in reference.l_min:
        least = mean_luminance(weights[:, :, 0], config.source.luminance_row)
    return paper_scheme.Scheme(
        nodes=nodes,
        degrees=paper_scheme.degrees_within([n.size - 1 for n in nodes]),
        bands=bands,
        exact=np.asarray(stored.unmirror(exact)),
        least=least,
        reference=reference,
    )


def _samples(config: Config, scheme: paper_scheme.Scheme, side: int) -> Array:
    """Return stratified weights on the grid; the sets of every value of the first axis share their directions."""
    sets, run = parameter_points.grid(list(scheme.nodes)), config.run
    names = tuple(axis.name for axis in config.axes)
    jobs = [
        partial(paper_scheme.stratified_weights, config.source, names, rows, side, scheme.bands, seed)
        for seed, rows in enumerate(np.split(sets, len(scheme.nodes[0])))
    ]
    return np.concatenate(map_tasks(_call, jobs, executor=run.executor, workers=run.workers, advance=lambda *_: None))


def _call(job: partial[Array]) -> Array:
    return job()
