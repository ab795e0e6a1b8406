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
    samples = project_block(job)
    flat = {name: job.values[..., i].ravel() for i, name in enumerate(job.names)}
    lowest = least_luminance.refine(job.light, flat, samples.least_direction.reshape(-1, 3), samples.least.ravel())
    return replace(samples, least=lowest.reshape(samples.least.shape))
