"""One block of parameter sets: its SH weights and least luminance. The unit of parallel work."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from skylight_sh.light.protocol import Light
from skylight_sh.quadrature import least_luminance, validation
from skylight_sh.quadrature.registry import RULES
from skylight_sh.quadrature.samples import Samples
from skylight_sh.sphere import Harmonics

Array = NDArray[np.float64]

_SHARPENED_AT_ONCE = 4096


@dataclass(frozen=True)
class Job:
    """A block ``values`` ``(g, k, axes)`` of parameters called ``names``, equal along k on the peak's axis.

    ``rule`` names the truth rule; ``nodes`` is for one with fixed nodes, ``tolerance`` for an adaptive one.
    """

    light: Light
    names: tuple[str, ...]
    values: Array
    nodes: int
    harmonics: Harmonics
    rule: str = "sun-centred"
    tolerance: float = 1e-10


def peak_of(light: Light, names: Sequence[str]) -> int | None:
    """Return the position among ``names`` of the parameter that turns the light's peak, or None.

    >>> from skylight_sh.light.preetham import Preetham
    >>> peak_of(Preetham(), ("turbidity", "sun_zenith"))
    1
    """
    return list(names).index(light.hints.peak_axis) if light.hints.peak_axis else None


def project_block(job: Job) -> Samples:
    """Integrate a block's SH weights, ``(g, k, channels, count)``.

    Raises NotConvergedError from an adaptive rule, LightError where the light turns out not to be one.

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> job = Job(CieTraditional(sky="overcast"), ("sun_zenith",), np.array([[[0.4]]]), 24, Harmonics.even(2))
    >>> project_block(job).weights[0, 0, 0, :2].round(4).tolist()
    [1.1816, 1.1939]
    """
    peak = peak_of(job.light, job.names)
    parameters = {name: job.values[:, :1, i] if i == peak else job.values[..., i] for i, name in enumerate(job.names)}
    rule = RULES[job.rule]
    setting = {"nodes": job.nodes} if rule.ladder else {"tolerance": job.tolerance}
    samples = rule.project(job.light, parameters, harmonics=job.harmonics, **setting)
    shape = job.values.shape[:2]
    if samples.least.shape != shape:
        # Sets that differ in nothing, since the peak's is the only axis.
        parts = (samples.weights, samples.least, samples.least_direction, samples.estimate)
        samples = Samples(*(np.broadcast_to(part, (*shape, *part.shape[2:])) for part in parts))
    validation.check_samples(job.light, {name: job.values[..., i].ravel() for i, name in enumerate(job.names)}, samples)
    return samples


def sample_block(job: Job) -> Samples:
    """Return a block's samples with each set's least luminance sharpened.

    The least luminance of an overcast sky is a third, on the horizon:

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> job = Job(CieTraditional(sky="overcast"), ("sun_zenith",), np.array([[[0.4]]]), 24, Harmonics.even(2))
    >>> sample_block(job).least.round(4).tolist()
    [[0.3333]]
    """
    return sharpened(job.light, job.names, job.values, project_block(job))


def sharpened(light: Light, names: Sequence[str], sets: Array, samples: Samples) -> Samples:
    """Return ``samples`` ``(...)`` of parameter ``sets`` ``(..., axes)`` with each one's least luminance sharpened.

    Many sets at once take a fifth of the time that blocks of some thirty do.

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> job = Job(CieTraditional(sky="overcast"), ("sun_zenith",), np.array([[[0.4]]]), 24, Harmonics.even(2))
    >>> sharpened(job.light, job.names, job.values, project_block(job)).least.round(4).tolist()
    [[0.3333]]
    """
    shape = samples.least.shape
    flat, starts, least = sets.reshape(-1, len(names)), samples.least_direction.reshape(-1, 3), samples.least.ravel()
    parts = []
    for start in range(0, least.size, _SHARPENED_AT_ONCE):
        part = slice(start, start + _SHARPENED_AT_ONCE)
        named = {name: flat[part, i] for i, name in enumerate(names)}
        parts.append(least_luminance.refine(light, named, starts[part], least[part]))
    return replace(samples, least=np.concatenate(parts).reshape(shape))
