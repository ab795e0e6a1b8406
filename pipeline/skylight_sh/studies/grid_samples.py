"""A config's fit grid, sampled afresh in this process: the benchmarks' and stress tests' samples."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh.config.schema import Config
from skylight_sh.fit.axis import Axis, of_table
from skylight_sh.fit.errors import Reference
from skylight_sh.quadrature import parameter_points, sampling
from skylight_sh.quadrature.registry import suited
from skylight_sh.run.config_axes import fit_nodes
from skylight_sh.run.from_config import reference, specification_of
from skylight_sh.run.steps import is_searched
from skylight_sh.runtime import Specification, Table
from skylight_sh.sphere import Harmonics

Array = NDArray[np.float64]

_NODES = 56


@dataclass(frozen=True)
class Samples:
    """Weights on the fit grid, ``(n_1, .., n_D, channels, count)``: all N*N (``full``) and m >= 0 alone (``half``).

    ``spec`` and ``axes`` are the run's own, with its changes of variable and factor.
    """

    config: Config
    spec: Specification
    axes: tuple[Axis, ...]
    nodes: list[Array]
    full: Array
    half: Array
    reference: Reference


def sample(config: Config, bands: int, random: int = 400, like: Table | None = None) -> Samples:
    """Sample the fit grid and ``random`` seeded sets plus the corners, for ``bands`` bands of a mirrored light.

    ``like`` is a table of the run: changes of variable and factor that the run has found in samples are its.
    """
    config = config.model_copy(update={"truth": config.truth.model_copy(update={"bands": bands})})
    ranges = [axis.range for axis in config.axes]
    spec = _specification(config, like)
    axes = tuple(of_table(axis) for axis in spec.axes)
    nodes = fit_nodes(config, axes)
    grid = measured_at(config, parameter_points.grid(nodes)).weights
    half = grid.reshape(*(n.size for n in nodes), *grid.shape[1:])
    corners = parameter_points.grid([np.array(r) for r in ranges])
    sets = np.concatenate([corners, parameter_points.random(ranges, random, 77)])
    full = np.asarray(_harmonics(config).unmirror(half), dtype=np.float64)
    return Samples(config, spec, axes, nodes, full, half, measured_at(config, sets))


def _specification(config: Config, like: Table | None) -> Specification:
    if like is not None and is_searched(config):
        return Specification(like.axes, like.channels, True, like.spec.basis, like.spec.scale)
    return specification_of(config, {}, _harmonics(config))


def measured_at(config: Config, sets: Array) -> Reference:
    """Sample parameter sets ``(n, axes)`` as something to measure errors against."""
    radiance, least = _radiance(config, sets)
    return reference(config, sets, radiance, _harmonics(config).degrees, least)


def light_alone(raw: dict[str, Any]) -> dict[str, Any]:
    """Return a config's data without what stands in the scene beside the light: what it fixes and its channels stay."""
    kept = {key: value for key, value in raw["scene"].items() if key in ("fixed", "channels")}
    return {**raw, "scene": kept}


def _harmonics(config: Config) -> Harmonics:
    return Harmonics.even(config.truth.bands)


def _radiance(config: Config, sets: Array) -> tuple[Array, Array]:
    harmonics, names = _harmonics(config), tuple(axis.name for axis in config.axes)
    weights = np.empty((len(sets), len(config.source.channels), harmonics.count))
    least = np.empty(len(sets))
    for block in parameter_points.chunks(sets, sampling.peak_of(config.source, names), 64):
        rule = suited(config.source, harmonics.bands)
        nodes = max(_NODES, harmonics.bands + 12)
        job = sampling.Job(config.source, names, sets[block], nodes, harmonics, rule, config.truth.stated_tolerance)
        sampled = sampling.sample_block(job)
        weights[block], least[block] = sampled.weights, sampled.least
    return weights, least
