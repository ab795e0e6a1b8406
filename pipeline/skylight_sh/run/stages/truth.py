"""Truth: SH weights and least luminance on the fit grid, the sets that selection sees, and those that only errors do."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from skylight_sh.config.schema import Config
from skylight_sh.fit.axis import Axis
from skylight_sh.fit.errors import l_min, mean_luminance
from skylight_sh.quadrature import convergence, parameter_points, sampling, validation
from skylight_sh.quadrature.registry import suited
from skylight_sh.quadrature.samples import Samples
from skylight_sh.run.config_axes import axes_of, fit_nodes, given_axes, harmonics_of, verification_nodes
from skylight_sh.run.executors import Advance, map_tasks
from skylight_sh.run.plan import Inputs
from skylight_sh.run.steps import RULE, allowed_error
from skylight_sh.sphere import Harmonics
from skylight_sh.store.dataset import Dataset, Variable

Array = NDArray[np.float64]
NodesOf = Callable[[Config, tuple[Axis, ...]], list[Array]]

_SETS_PER_TASK = 64
_SETS_A_PEAK = 10


def make_rule(config: Config, _: Inputs, __: Advance) -> Dataset:
    """Look at the light, and choose the truth rule and its number of nodes."""
    light, truth = config.source, config.truth
    ranges = {axis.name: axis.range for axis in config.axes}
    validation.vet(light, ranges)
    # A claim is spot-checked; a light that claims nothing is looked at closely.
    symmetric = convergence.is_mirrored(light, ranges, samples=512 if light.hints.mirrored else 20_000)
    harmonics = Harmonics(truth.bands, symmetric and truth.orders == "auto")
    rule = suited(light, truth.bands) if truth.rule == "auto" else truth.rule
    tolerance = truth.stated_tolerance
    error = allowed_error(config) if truth.tolerance == "auto" else None
    if error is not None:
        probes = convergence.probe(light, ranges, rule=rule, harmonics=harmonics)
        mean = mean_luminance(probes.weights[:, :, 0], light.luminance_row)
        denominator = next(iter(l_min(probes.least, mean).values()))
        tolerance = convergence.tolerance_for(error, probes.weights, denominator, rule=rule)
    nodes, estimate = convergence.choose_nodes(light, ranges, rule=rule, harmonics=harmonics, tolerance=tolerance)
    found = {"rule": rule, "nodes": nodes, "estimate": estimate, "tolerance": tolerance, "mirrored": harmonics.mirrored}
    return Dataset({}, found)


def make_grid(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    """Sample the fit's grid."""
    return _make_grid(config, fit_nodes, "grid", inputs, advance)


def make_probe(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    """Sample a grid as the fit's, in the parameters themselves: no change of variable is known yet."""
    return _make_grid(config, fit_nodes, "probe", inputs, advance)


def make_verification(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    """Sample the grid that selection sees."""
    return _make_grid(config, verification_nodes, "verification", inputs, advance)


def _make_grid(config: Config, nodes_of: NodesOf, name: str, inputs: Inputs, advance: Advance) -> Dataset:
    """Sample the grid of ``nodes_of`` the axes; ``name`` says what it is for."""
    axes = axes_of(config, inputs)
    nodes = nodes_of(config, axes)
    shape = tuple(n.size for n in nodes)
    samples, rule = _sample(config, parameter_points.grid(nodes), inputs, advance)
    dims = tuple(axis.name for axis in config.axes)
    coordinates = {
        axis.name: Variable((axis.name,), values, {"units": axis.unit, "long_name": axis.name.replace("_", " ")})
        for axis, values in zip(axes, nodes, strict=True)
    }
    return _dataset(config, coordinates, dims, shape, samples, rule, name)


def make_random(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    """Sample the random sets that selection sees; ten of them share the peak's place, and so the rule's nodes."""
    ranges, names = [axis.range for axis in config.axes], [axis.name for axis in config.axes]
    shared = sampling.peak_of(config.source, names)
    sets = parameter_points.random(ranges, config.truth.random, config.truth.seed, shared=shared, each=_SETS_A_PEAK)
    return _make_list(config, sets, "random", inputs, advance)


def make_held_out(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    """Sample the sets that only errors are measured on."""
    truth = config.truth
    # The sets do not hang on the order in which a config names its axes.
    order = np.argsort([axis.name for axis in config.axes])
    ranges = [config.axes[i].range for i in order]
    sets = parameter_points.held_out(ranges, truth.held_out, truth.held_out_edge, truth.held_out_seed)[:, np.argsort(order)]
    return _make_list(config, sets, "held-out", inputs, advance)


def _make_list(config: Config, sets: Array, name: str, inputs: Inputs, advance: Advance) -> Dataset:
    samples, rule = _sample(config, sets, inputs, advance)
    coordinates = {"set": Variable(("set",), np.arange(len(sets)))} | {
        axis.name: Variable(("set",), sets[:, i], {"units": axis.unit}) for i, axis in enumerate(given_axes(config))
    }
    return _dataset(config, coordinates, ("set",), (len(sets),), samples, rule, name)


def _sample(config: Config, sets: Array, inputs: Inputs, advance: Advance) -> tuple[Samples, Dataset]:
    """Sample parameter sets ``(n, axes)``, in tasks; the samples' shapes start with ``(n,)``."""
    rule, light = inputs[RULE], config.source
    nodes, name, harmonics = int(rule.attrs["nodes"]), str(rule.attrs["rule"]), harmonics_of(config, rule)
    names = tuple(axis.name for axis in config.axes)
    blocks = parameter_points.chunks(sets, sampling.peak_of(light, names), _SETS_PER_TASK)
    tolerance = float(rule.attrs["tolerance"])
    jobs = [sampling.Job(light, names, sets[block], nodes, harmonics, name, tolerance) for block in blocks]
    results = map_tasks(
        sampling.project_block, jobs, executor=config.run.executor, workers=config.run.workers, advance=advance
    )
    shape = (len(sets), len(light.channels), harmonics.count)
    whole = Samples(np.empty(shape), np.empty(len(sets)), np.empty((len(sets), 3)), np.empty(len(sets)))
    for block, part in zip(blocks, results, strict=True):
        whole.weights[block], whole.least[block], whole.estimate[block] = part.weights, part.least, part.estimate
        whole.least_direction[block] = part.least_direction
    return sampling.sharpened(light, names, sets, whole), rule


def _dataset(
    config: Config,
    coordinates: dict[str, Variable],
    dims: tuple[str, ...],
    shape: tuple[int, ...],
    samples: Samples,
    rule: Dataset,
    name: str,
) -> Dataset:
    harmonics = harmonics_of(config, rule)
    variables = coordinates | {
        "channel": Variable(("channel",), np.array(config.source.channels)),
        "weight": Variable(("weight",), harmonics.flat, {"long_name": "flat index l*(l+1)+m"}),
        "degree": Variable(("weight",), harmonics.degrees, {"long_name": "degree l"}),
        "order": Variable(("weight",), harmonics.orders, {"long_name": "order m"}),
        "weights": Variable(
            (*dims, "channel", "weight"),
            samples.weights.reshape(*shape, *samples.weights.shape[1:]),
            {"units": "cd m-2 sr0.5", "long_name": "SH weights", "coordinates": "degree order"},
        ),
        "least_luminance": Variable(
            dims, samples.least.reshape(shape), {"units": "cd m-2", "long_name": "least luminance of the upper hemisphere"}
        ),
    }
    if np.all(np.isfinite(samples.estimate)):
        told = {"long_name": "error measured, relative to the set's largest weight"}
        variables["estimate"] = Variable(dims, samples.estimate.reshape(shape), told)
    attrs = {"sets": name, "light": config.source.title, **rule.attrs}
    return Dataset(variables, {key: value for key, value in attrs.items() if key not in ("step", "key")})
