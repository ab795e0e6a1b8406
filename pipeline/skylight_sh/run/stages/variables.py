"""Variables: changes of variable and a prefactor found from samples, where a config asks for them."""

from __future__ import annotations

import json
from dataclasses import asdict
from functools import partial

import numpy as np
from numpy.typing import NDArray

from skylight_sh.config.schema import Config
from skylight_sh.fit.errors import mean_luminance
from skylight_sh.fit.variable_search import search
from skylight_sh.run.config_axes import fit_nodes, given_axes, is_searched
from skylight_sh.run.executors import Advance
from skylight_sh.run.plan import Inputs, Step
from skylight_sh.run.stages import truth
from skylight_sh.store.dataset import Dataset, Variable

Array = NDArray[np.float64]


def steps(config: Config) -> list[Step]:
    """Return the probe, a grid in the parameters themselves, and the search; nothing where nothing is searched."""
    if not is_searched(config):
        return []
    spacing = truth.spacing_of(config)
    searched = {"nodes": spacing, "prefactor": config.fit.prefactor, "budget": _middle_budget(config)}
    return [
        Step("truth", "probe", ("truth/rule",), spacing, partial(truth.make_grid, config, fit_nodes, "probe")),
        Step("truth", "variables", ("truth/probe",), searched, partial(_make, config)),
    ]


def _middle_budget(config: Config) -> float:
    """Return the error that the search for variables aims at: the middle one of all budgets asked for."""
    budgets = sorted(budget for winner in config.winners for budget in winner.budgets)
    return budgets[len(budgets) // 2] if budgets else 1e-3


def _make(config: Config, inputs: Inputs, _: Advance) -> Dataset:
    """Find changes of variable and the prefactor from the probe, a grid in the parameters themselves."""
    probe, axes = inputs["truth/probe"], given_axes(config)
    free = [axis.map == "auto" for axis in config.axes]
    found = search(
        axes,
        [probe[axis.name] for axis in axes],
        probe["weights"],
        _positive(config, probe),
        _middle_budget(config),
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
