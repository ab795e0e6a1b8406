"""A config's axes, nodes and SH weights as the numerics know them: given, or found by the steps before."""

from __future__ import annotations

import json

import numpy as np
from numpy.typing import NDArray

from skylight_sh.config.schema import Config
from skylight_sh.fit.axis import Axis
from skylight_sh.run.plan import Inputs
from skylight_sh.run.steps import VARIABLES
from skylight_sh.sphere import Harmonics
from skylight_sh.store.dataset import Dataset

Array = NDArray[np.float64]


def given_axes(config: Config) -> tuple[Axis, ...]:
    """Return the config's axes with their units; an automatic map stands as ``identity``."""
    return tuple(
        Axis(
            axis.name,
            *axis.range,
            unit=config.source.domains[axis.name].unit,
            map="identity" if axis.map == "auto" else axis.map,
            point=axis.point,
        )
        for axis in config.axes
    )


def axes_of(config: Config, inputs: Inputs) -> tuple[Axis, ...]:
    """Return the axes, with the maps that the search has found where there was one."""
    if VARIABLES not in inputs:
        return given_axes(config)
    return tuple(Axis(**axis) for axis in json.loads(str(inputs[VARIABLES].attrs["axes"])))


def harmonics_of(config: Config, artifact: Dataset) -> Harmonics:
    """Return which SH weights a step of the truth, ``artifact``, has sampled, or its rule asks for."""
    return Harmonics(config.truth.bands, bool(artifact.attrs["mirrored"]))


def fit_nodes(config: Config, axes: tuple[Axis, ...]) -> list[Array]:
    """Return the fit grid's nodes, an axis."""
    return [axis.fit_nodes(s.nodes, s.spacing) for axis, s in zip(axes, config.axes, strict=True)]


def verification_nodes(config: Config, axes: tuple[Axis, ...]) -> list[Array]:
    """Return the verification grid's nodes, an axis: both ends, and no interior node of the fit grid."""
    return [
        axis.verification_nodes(s.verification, nodes)
        for axis, s, nodes in zip(axes, config.axes, fit_nodes(config, axes), strict=True)
    ]
