"""Fit: one fit of the whole grid, and the fits shown beside it."""

from __future__ import annotations

import numpy as np

from skylight_sh.config.schema import Config
from skylight_sh.fit.axis import Axis
from skylight_sh.quadrature import parameter_points
from skylight_sh.run.config_axes import axes_of, fit_nodes, harmonics_of
from skylight_sh.run.executors import Advance
from skylight_sh.run.from_config import parity_of, scale_of, scene_of
from skylight_sh.run.plan import Inputs
from skylight_sh.run.steps import GRID
from skylight_sh.scene.fold import fold
from skylight_sh.store.dataset import Dataset, Variable
from skylight_sh.table import grid_fit, npz, parity
from skylight_sh.table.table import specification, whole


def make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    """Fit the grid, and what is shown beside the fit."""
    grid = inputs[GRID]
    harmonics = harmonics_of(config, grid)
    axes = axes_of(config, inputs)
    nodes = fit_nodes(config, axes)
    sets = parameter_points.grid(nodes).reshape(*grid["weights"].shape[:-2], -1)
    samples = fold(scene_of(config), grid["weights"], grid["degree"], sets)
    degrees = [axis.degrees[1] for axis in config.axes]
    # Of a grid's systems, one a axis is the whole one's solution.
    solver = grid_fit.TENSOR if config.fit.solver == "svd" else config.fit.solver
    scale, peak = scale_of(config, inputs), parity_of(config)
    if peak:
        middle = [0.5 * (axis.low + axis.high) for axis in axes]
        parity.check(config.source, [axis.name for axis in axes], middle, peak, scale)
    made = grid_fit.fit(samples, axes, nodes, degrees, config.fit.basis, solver, scale, peak, harmonics.orders)
    powers = tuple(f"power_{axis.name}" for axis in axes)
    found = {
        "coefficients": Variable(("class", "weight", *powers), made.dense),
        "condition": Variable((), np.array(made.condition)),
    }
    for done, section in enumerate(config.fit.references):
        advance(done, len(config.fit.references))
        kind = "identity" if section.scaled else "raw"
        plain = tuple(Axis(axis.name, axis.low, axis.high, axis.unit, kind) for axis in axes)
        shown = grid_fit.fit(samples, plain, nodes, section.degrees, section.basis, section.solver, None)
        spec = specification(plain, config.source.channels, harmonics.mirrored, section.basis)
        table = whole(spec, shown.dense, config.truth.bands, section.dtype)
        start = f"references/{section.name}"
        found[f"{start}/npz"] = Variable(("byte",), np.frombuffer(npz.write(table), dtype=np.uint8))
        found[f"{start}/condition"] = Variable((), np.array(shown.condition))
    return Dataset(found, {"mirrored": harmonics.mirrored})
