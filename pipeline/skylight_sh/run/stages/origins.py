"""Origins: what the 2008 paper's error may be made of, tested with the paper's own scheme on this run's grid."""

from __future__ import annotations

from dataclasses import asdict
from functools import partial
from itertools import chain, repeat

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.config.schema import Config
from skylight_sh.fit import least_squares
from skylight_sh.fit.bases import BASES
from skylight_sh.fit.errors import Reference, e_mean, mean_luminance
from skylight_sh.quadrature import direction_sums, monte_carlo
from skylight_sh.quadrature import parameter_points as parameter_sets
from skylight_sh.run.executors import Advance, map_tasks
from skylight_sh.run.plan import Inputs, Step
from skylight_sh.run.stages.fit import reference_of, truth_inputs
from skylight_sh.scene.axes import axes_of, fit_nodes, variables
from skylight_sh.store.dataset import Dataset, Variable

Array = NDArray[np.float64]

NAME = "origins"
STEP = "fit/origins"
# The paper's bands and degrees; side of the grid of cells, one random sample each, that stands for a truth.
_BANDS = 7
_DEGREES = (13, 7)
_FURTHER = 3
_SIDES = (12, 18, 26, 36, 50)


def is_wanted(config: Config) -> bool:
    """Say whether the report shows the origins, which are those of radiance above a black ground, as in the paper."""
    scene = config.scene
    return NAME in config.report.figures and scene.quantity == "radiance" and scene.ground == "black" and not scene.sun_disc


def steps(config: Config) -> list[Step]:
    """Return the step, if the report shows its picture."""
    if not is_wanted(config):
        return []
    parameters = {
        "light": {**asdict(config.light), "version": config.light.version},
        "axes": [axis.model_dump(mode="json") for axis in config.axes],
        "scene": config.scene.model_dump(mode="json"),
    }
    needed = ("truth/grid", *variables(config), *truth_inputs(config))
    return [Step("fit", NAME, needed, parameters, partial(_make, config))]


def _make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    axes = axes_of(config, inputs)
    nodes = fit_nodes(config, axes)
    bands = min(_BANDS, config.truth.bands)
    reference = reference_of(config, inputs, truth_inputs(config))
    grid = inputs["truth/grid"]
    count = sphere.count(bands, mirrored=bool(grid.attrs["mirrored"]))
    exact = grid["weights"][..., :count].reshape(-1, len(config.source.channels), count)
    exact = np.asarray(sphere.unmirror(exact, bands)) if grid.attrs["mirrored"] else exact
    degrees = [min(d, n.size - 1) for d, n in zip(chain(_DEGREES, repeat(_FURTHER)), nodes, strict=False)]
    matrices = [np.asarray(BASES["monomial"].vander(n, d), dtype=np.float64) for n, d in zip(nodes, degrees, strict=True)]
    sets = parameter_sets.grid(nodes)
    least = grid["least_luminance"].ravel()
    if "per-set" not in reference.l_min:
        least = mean_luminance(
            grid["weights"].reshape(-1, *grid["weights"].shape[-2:])[:, :, 0], config.source.luminance_row
        )

    done, total = 0, len(_SIDES) + 1
    found: dict[str, list[float]] = {key: [] for key in ("m_below_0", "rel_l2", "own", "truth")}
    for side in _SIDES:
        advance(done, total)
        done += 1
        jobs = [partial(_row, config, sets[rows], side, bands, i) for i, rows in enumerate(_rows(sets, len(nodes[0])))]
        run = config.run
        parts = map_tasks(_call, jobs, executor=run.executor, workers=run.workers, advance=lambda *_: None)
        sampled = np.concatenate(parts)
        made = _monomials(sampled, matrices, "svd")
        # What its authors could see: the distance from their own samples. And what they could not: that from the truth.
        fitted = _evaluate(made, sets, degrees)
        found["own"].append(e_mean(fitted - sampled, least))
        found["truth"].append(_from_truth(made, reference, degrees, bands))
        _, orders = sphere.degrees_orders(bands)
        norms = np.sqrt((sampled**2).sum(axis=(1, 2)))
        below = np.sqrt((sampled[..., orders < 0] ** 2).sum(axis=(1, 2)))
        found["m_below_0"].append(float(np.median(below / norms)))
        found["rel_l2"].append(float(np.median(np.sqrt(((sampled - exact) ** 2).sum(axis=(1, 2))) / norms)))
    advance(done, total)
    solvers = {s: _monomials(exact, matrices, s) for s in least_squares.SOLVERS}
    errors = [
        [
            _from_truth(made.astype(dtype), reference, degrees, bands)
            for dtype in (np.dtype(np.float64), np.dtype(np.float32))
        ]
        for made in solvers.values()
    ]
    return Dataset(
        {
            "samples": Variable(("side",), np.array([s * s for s in _SIDES])),
            "solver": Variable(("solver",), np.array(list(solvers))),
            "solver_e_mean": Variable(("solver", "dtype"), np.array(errors)),
            **{key: Variable(("side",), np.array(values)) for key, values in found.items()},
        },
        {"degrees": " x ".join(map(str, degrees)), "bands": bands},
    )


def _rows(sets: Array, first: int) -> list[NDArray[np.int64]]:
    """Return the sets of every value of the first axis: they share their directions."""
    return list(np.arange(len(sets)).reshape(first, -1))


def _call(job: partial[Array]) -> Array:
    return job()


def _row(config: Config, sets: Array, side: int, bands: int, seed: int) -> Array:
    """Return the stratified Monte Carlo weights of ``sets``, ``(sets, channels, N*N)``."""
    directions, solid = monte_carlo.directions(side, 7919 * side + seed)
    table = direction_sums.tabulate(directions, solid, bands)
    named = {axis.name: sets[:, i, np.newaxis] for i, axis in enumerate(config.axes)}
    return np.asarray(config.source.radiance(directions, named).swapaxes(1, 2) @ table)


def _monomials(values: Array, matrices: list[Array], solver: str) -> Array:
    """Fit ``values`` ``(sets, channels, N*N)``: coefficients ``(channels, N*N, terms)``."""
    shape = tuple(len(m) for m in matrices)
    solution = least_squares.fit_full(values.reshape(*shape, -1), matrices, solver)
    return solution.reshape(*values.shape[1:], -1)


def _evaluate(made: NDArray[np.floating], sets: Array, degrees: list[int]) -> Array:
    """Evaluate monomials at ``sets`` in the coefficients' own number type: ``(sets, channels, N*N)``."""
    values = sets.astype(made.dtype)
    product = np.ones((len(sets), 1), dtype=made.dtype)
    for i, degree in enumerate(degrees):
        vander = BASES["monomial"].vander(values[:, i], degree)
        product = (product[:, :, np.newaxis] * vander[:, np.newaxis]).reshape(len(sets), -1)
    out = product @ made.reshape(-1, made.shape[-1]).T
    return np.asarray(out.reshape(len(sets), *made.shape[:2]), dtype=np.float64)


def _from_truth(made: NDArray[np.floating], reference: Reference, degrees: list[int], bands: int) -> float:
    truth = reference.weights[..., reference.first_bands(bands)]
    if truth.shape[-1] != bands * bands:
        truth = np.asarray(sphere.unmirror(truth, bands))
    return e_mean(_evaluate(made, reference.parameters, degrees) - truth, reference.headline)
