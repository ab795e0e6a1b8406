"""Truth: SH weights and least luminance on the fit grid, the verification grid and random sets."""

from __future__ import annotations

from dataclasses import asdict
from functools import partial

import numpy as np
from numpy.typing import NDArray

from pipeline import sphere
from pipeline.config.schema import Config
from pipeline.run.executors import Advance, map_tasks
from pipeline.run.plan import Inputs, Step
from pipeline.run.stages.axes import axes_of, fit_nodes, verification_nodes
from pipeline.store.dataset import Dataset, Variable
from pipeline.truth import converge, sampling
from pipeline.truth import sets as parameter_sets

Array = NDArray[np.float64]

_CODE = ("light", "sphere", "truth", "fit/axes.py", "fit/maps.py", "run/stages/truth.py", "run/stages/axes.py")
_SETS_PER_TASK = 64


def steps(config: Config) -> list[Step]:
    """Return the rule's step and one for each collection of parameter sets that the config asks for."""
    common = {
        "light": {**asdict(config.light), "version": config.light.version},
        "ranges": {axis.name: axis.range for axis in config.axes},
        "bands": config.truth.bands,
        "tolerance": config.truth.tolerance,
        "orders": config.truth.orders,
    }
    spacing = {axis.name: (axis.nodes, axis.spacing, axis.map, axis.point) for axis in config.axes}
    rule = Step("truth", "rule", _CODE, (), common, partial(_make_rule, config))
    found = [
        rule,
        Step("truth", "grid", _CODE, (rule.name,), spacing, partial(_make_grid, config, fit_nodes(config), "grid")),
        Step(
            "truth",
            "verification",
            _CODE,
            (rule.name,),
            {"fit": spacing, "count": {axis.name: axis.verification for axis in config.axes}},
            partial(_make_grid, config, verification_nodes(config), "verification"),
        ),
    ]
    if config.truth.random:
        drawn = {"count": config.truth.random, "seed": config.truth.seed}
        found.append(Step("truth", "random", _CODE, (rule.name,), drawn, partial(_make_random, config)))
    return found


def _make_rule(config: Config, _: Inputs, __: Advance) -> Dataset:
    ranges = {axis.name: axis.range for axis in config.axes}
    symmetric = config.light.hints.mirrored and converge.is_mirrored(config.light, ranges)
    mirrored = symmetric and config.truth.orders == "auto"
    nodes, estimate = converge.choose_nodes(
        config.light, ranges, bands=config.truth.bands, mirrored=mirrored, tolerance=config.truth.tolerance
    )
    return Dataset({}, {"rule": "sun-centred", "nodes": nodes, "estimate": estimate, "mirrored": mirrored})


def _make_grid(config: Config, nodes: list[Array], name: str, inputs: Inputs, advance: Advance) -> Dataset:
    shape = tuple(n.size for n in nodes)
    weights, lowest, rule = _sample(config, parameter_sets.grid(nodes), inputs, advance)
    dims = tuple(axis.name for axis in config.axes)
    coordinates = {
        axis.name: Variable((axis.name,), values, {"units": axis.unit, "long_name": axis.name.replace("_", " ")})
        for axis, values in zip(axes_of(config), nodes, strict=True)
    }
    return _dataset(
        config, coordinates, dims, weights.reshape(*shape, *weights.shape[1:]), lowest.reshape(shape), rule, name
    )


def _make_random(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    sets = parameter_sets.random([axis.range for axis in config.axes], config.truth.random, config.truth.seed)
    weights, lowest, rule = _sample(config, sets, inputs, advance)
    coordinates = {"set": Variable(("set",), np.arange(len(sets)))} | {
        axis.name: Variable(("set",), sets[:, i], {"units": axis.unit}) for i, axis in enumerate(axes_of(config))
    }
    return _dataset(config, coordinates, ("set",), weights, lowest, rule, "random")


def _sample(config: Config, sets: Array, inputs: Inputs, advance: Advance) -> tuple[Array, Array, Dataset]:
    rule = inputs["truth/rule"]
    nodes, mirrored = int(rule.attrs["nodes"]), bool(rule.attrs["mirrored"])
    names = tuple(axis.name for axis in config.axes)
    blocks = parameter_sets.chunks(sets, sampling.peak_of(config.light, names), _SETS_PER_TASK)
    jobs = [sampling.Job(config.light, names, sets[block], nodes, config.truth.bands, mirrored) for block in blocks]
    results = map_tasks(
        sampling.sample_block, jobs, executor=config.run.executor, workers=config.run.workers, advance=advance
    )
    count = sphere.count(config.truth.bands, mirrored=mirrored)
    weights = np.empty((len(sets), len(config.light.channels), count))
    lowest = np.empty(len(sets))
    for block, (block_weights, block_lowest) in zip(blocks, results, strict=True):
        weights[block], lowest[block] = block_weights, block_lowest
    return weights, lowest, rule


def _dataset(
    config: Config,
    coordinates: dict[str, Variable],
    dims: tuple[str, ...],
    weights: Array,
    lowest: Array,
    rule: Dataset,
    name: str,
) -> Dataset:
    degrees, orders = sphere.degrees_orders(config.truth.bands, mirrored=bool(rule.attrs["mirrored"]))
    variables = coordinates | {
        "channel": Variable(("channel",), np.array(config.light.channels)),
        "weight": Variable(("weight",), degrees * (degrees + 1) + orders, {"long_name": "flat index l*(l+1)+m"}),
        "degree": Variable(("weight",), degrees, {"long_name": "degree l"}),
        "order": Variable(("weight",), orders, {"long_name": "order m"}),
        "weights": Variable(
            (*dims, "channel", "weight"),
            weights,
            {"units": "cd m-2 sr0.5", "long_name": "SH weights", "coordinates": "degree order"},
        ),
        "least_luminance": Variable(
            dims, lowest, {"units": "cd m-2", "long_name": "least luminance of the upper hemisphere"}
        ),
    }
    attrs = {"sets": name, "light": config.light.title, **rule.attrs}
    return Dataset(variables, {key: value for key, value in attrs.items() if key not in ("step", "key")})
