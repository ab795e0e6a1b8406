"""One fit of the samples in a basis, by a solver, in plain or the config's own variables: what the stresses vary."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit import paper_scheme
from skylight_sh.fit.axis import Axis
from skylight_sh.runtime import Scale, Table
from skylight_sh.sphere import Harmonics
from skylight_sh.studies.grid_samples import Samples
from skylight_sh.table import grid_fit
from skylight_sh.table.grid_fit import GridFit
from skylight_sh.table.table import specification, whole

Array = NDArray[np.float64]
OWN = "config"
"""Stands for the config's own changes of variable and its prefactor, where else a change of variable is named."""


def paper_degrees(samples: Samples) -> list[int]:
    """Return the paper's degrees (13, 7), or as many as the config sweeps, 3 for further axes."""
    return paper_scheme.degrees_within([axis.degrees[1] for axis in samples.config.axes])


def system(samples: Samples, values: Array, degrees: Sequence[int], basis: str, kind: str) -> tuple[Array, list[Array]]:
    """Return the right side ``(n_1, .., n_D, outputs)`` and the basis at each axis's nodes.

    ``values`` has the shape of ``samples.half``; ``kind`` is a change of variable for every axis, or ``OWN``.
    """
    return grid_fit.system(values, _axes(samples, kind), samples.nodes, degrees, basis, _scale(samples, kind))


def fit(samples: Samples, values: Array, degrees: Sequence[int], basis: str, solver: str, kind: str) -> GridFit:
    """Fit ``values`` as ``system`` sets it up. Raises LinAlgError where the solver gives up."""
    orders = Harmonics.even(samples.config.truth.bands).orders
    variables, scale, peak = _axes(samples, kind), _scale(samples, kind), _parity(samples, kind)
    return grid_fit.fit(values, variables, samples.nodes, degrees, basis, solver, scale, peak, orders)


def table_of(samples: Samples, made: GridFit, dtype: str) -> Table:
    """Return a fit as a table of all its coefficients in ``dtype``."""
    peak = made.parity or None
    channels = samples.spec.channels
    spec = specification(made.axes, channels, True, made.basis, made.scale, peak_axis=peak, parity=bool(peak))
    return whole(spec, made.dense, samples.config.truth.bands, dtype)


def _axes(samples: Samples, kind: str) -> tuple[Axis, ...]:
    return samples.axes if kind == OWN else tuple(Axis(a.name, *a.range, map=kind) for a in samples.config.axes)


def _scale(samples: Samples, kind: str) -> Scale | None:
    return samples.spec.scale if kind == OWN else None


def _parity(samples: Samples, kind: str) -> str:
    return str(samples.spec.peak_axis) if kind == OWN and samples.spec.parity else ""
