"""A config's axes as the numerics know them, and their nodes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pipeline.config.schema import Config
from pipeline.fit.axes import Axis

Array = NDArray[np.float64]


def axes_of(config: Config) -> tuple[Axis, ...]:
    """Return the config's axes with their units, in its order."""
    return tuple(
        Axis(axis.name, *axis.range, unit=config.source.domains[axis.name].unit, map=axis.map, point=axis.point)
        for axis in config.axes
    )


def fit_nodes(config: Config) -> list[Array]:
    """Return the fit grid's nodes, an axis."""
    return [axis.fit_nodes(s.nodes, s.spacing) for axis, s in zip(axes_of(config), config.axes, strict=True)]


def verification_nodes(config: Config) -> list[Array]:
    """Return the verification grid's nodes, an axis: both ends, and no interior node of the fit grid."""
    return [
        axis.verification_nodes(s.verification, nodes)
        for axis, s, nodes in zip(axes_of(config), config.axes, fit_nodes(config), strict=True)
    ]
