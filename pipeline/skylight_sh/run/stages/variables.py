"""Variables: changes of variable and a prefactor found from samples, where a config asks for them."""

from __future__ import annotations

import json
from dataclasses import asdict

import numpy as np
from numpy.typing import NDArray

from skylight_sh.config.schema import Config
from skylight_sh.fit.errors import mean_luminance
from skylight_sh.fit.variable_search import search
from skylight_sh.run.config_axes import given_axes
from skylight_sh.run.executors import Advance
from skylight_sh.run.plan import Inputs
from skylight_sh.run.steps import PROBE, middle_budget
from skylight_sh.store.dataset import Dataset, Variable

Array = NDArray[np.float64]


def make(config: Config, inputs: Inputs, _: Advance) -> Dataset:
    """Find changes of variable and the prefactor from the probe, a grid in the parameters themselves."""
    probe, axes = inputs[PROBE], given_axes(config)
    free = [axis.map == "auto" for axis in config.axes]
    found = search(
        axes,
        [probe[axis.name] for axis in axes],
        probe["weights"],
        _positive(config, probe),
        middle_budget(config),
        free=free,
        factor=config.fit.prefactor == "auto",
    )
    powers = tuple(f"power_{axis.name}" for axis in axes)
    made = json.dumps([asdict(axis) for axis in found.axes])
    return Dataset({"denominator": Variable(powers, found.denominator)}, {"axes": made})


def _positive(config: Config, probe: Dataset) -> Array:
    """Return what the search divides by: the least luminance, or the mean where the least is not positive."""
    if np.all(probe["least_luminance"] > 0.0):
        return probe["least_luminance"]
    return mean_luminance(probe["weights"][..., 0], config.source.luminance_row)
