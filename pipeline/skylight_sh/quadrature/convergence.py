"""How many nodes a rule needs for a stated tolerance, and whether a light is as symmetric as it says."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from skylight_sh.light.protocol import Light
from skylight_sh.quadrature import parameter_points as parameter_sets
from skylight_sh.quadrature.registry import RULES
from skylight_sh.quadrature.samples import NotConvergedError
from skylight_sh.quadrature.sampling import Job, peak_of, project_block
from skylight_sh.sphere import Harmonics

Array = NDArray[np.float64]

_PROBES_PER_AXIS = 5
# A channel that is black has weights of 0.
_TINY = np.finfo(np.float64).tiny


def choose_nodes(
    light: Light,
    ranges: Mapping[str, tuple[float, float]],
    *,
    rule: str = "sun-centred",
    harmonics: Harmonics,
    tolerance: float,
) -> tuple[int, float]:
    """Return the number of nodes that meets ``tolerance`` over the whole range, and the error estimate.

    The weights of a coarse grid of parameter sets, edges and corners included, are computed with more and more nodes
    until two runs differ by no more than ``tolerance``, relative to each set's and channel's largest weight. The coarser
    run's node count is returned: the finer one measures its error, which is the estimate. An adaptive rule needs no
    number, and has its own estimate: the largest over the same sets. Raises NotConvergedError with the difference
    reached.

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> nodes, error = choose_nodes(
    ...     CieTraditional(sky="overcast"), {"sun_zenith": (0.0, 1.5)}, harmonics=Harmonics.even(2), tolerance=1e-6
    ... )
    >>> nodes, error < 1e-6
    (24, True)
    """
    names = tuple(ranges)
    probes = parameter_sets.grid([np.linspace(low, high, _PROBES_PER_AXIS) for low, high in ranges.values()])
    blocks = [probes[block] for block in parameter_sets.chunks(probes, peak_of(light, names), 64)]
    steps = RULES[rule].ladder
    if steps is None:
        jobs = [Job(light, names, block, 0, harmonics, rule, tolerance) for block in blocks]
        return 0, max(float(project_block(job).estimate.max()) for job in jobs)
    estimate = np.inf
    previous: list[Array] = []
    coarser = 0
    ladder = steps(harmonics.bands)
    for nodes in ladder:
        current = [project_block(Job(light, names, block, nodes, harmonics, rule)).weights for block in blocks]
        if previous:
            estimate = max(
                float(np.max(np.abs(new - old).max(axis=-1) / np.maximum(np.abs(new).max(axis=-1), _TINY)))
                for new, old in zip(current, previous, strict=True)
            )
            if estimate <= tolerance:
                return coarser, estimate
        previous, coarser = current, nodes
    raise NotConvergedError(
        f"The truth did not converge: {ladder[-1]} nodes of the rule {rule!r} reach {estimate:.2g} relative, but "
        f"truth.tolerance is {tolerance:.2g}. Raise truth.tolerance, lower truth.bands, narrow the axes' ranges or choose "
        "another truth.rule."
    )


def is_mirrored(light: Light, ranges: Mapping[str, tuple[float, float]], *, samples: int = 512, seed: int = 1) -> bool:
    """Check by sampling that radiance is even in y, to 1e-12 of itself; a light's own hint is only a claim.

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> is_mirrored(CieTraditional(sky="overcast"), {"sun_zenith": (0.0, 1.5)})
    True
    """
    rng = np.random.default_rng(seed)
    directions = rng.normal(size=(samples, 3))
    directions[:, 2] = np.abs(directions[:, 2])
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    values = parameter_sets.random(list(ranges.values()), samples, seed)
    parameters = {name: values[:, i] for i, name in enumerate(ranges)}
    one = light.radiance(directions, parameters)
    other = light.radiance(directions * np.array([1.0, -1.0, 1.0]), parameters)
    return bool(np.all(np.abs(one - other) <= 1e-12 * np.abs(one).max(axis=1, keepdims=True)))
