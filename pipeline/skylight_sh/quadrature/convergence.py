"""How many nodes a rule needs for a stated tolerance, and whether a light is as symmetric as it says."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from skylight_sh.light.protocol import Light
from skylight_sh.quadrature import parameter_points as parameter_sets
from skylight_sh.quadrature.registry import RULES
from skylight_sh.quadrature.samples import NotConvergedError, Samples
from skylight_sh.quadrature.sampling import Job, peak_of, project_block, sample_block
from skylight_sh.reproducible import significant
from skylight_sh.sphere import Harmonics

Array = NDArray[np.float64]

_PROBES_PER_AXIS = 5
# An adaptive rule's tolerance for a first look, and the finest that is asked for by itself.
_ROUGH = 1e-3
_FINEST = 1e-13
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
    until two runs differ by no more than ``tolerance``: in the root of the summed squares of all weights' differences,
    relative to each set's and channel's largest weight. The coarser run's node count is returned: the finer one measures
    its error, which is the estimate. An adaptive rule needs no number, and has its own estimate: the largest over the same
    sets. Raises NotConvergedError with the difference reached.

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> nodes, error = choose_nodes(
    ...     CieTraditional(sky="overcast"), {"sun_zenith": (0.0, 1.5)}, harmonics=Harmonics.even(2), tolerance=1e-6
    ... )
    >>> nodes, error < 1e-6
    (24, True)
    """
    names, blocks = tuple(ranges), _probes(light, ranges)
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
                float(np.max(np.linalg.norm(new - old, axis=-1) / np.maximum(np.abs(new).max(axis=-1), _TINY)))
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


def probe(light: Light, ranges: Mapping[str, tuple[float, float]], *, rule: str, harmonics: Harmonics) -> Samples:
    """Sample roughly, with the fewest nodes of ``rule``, where ``choose_nodes`` does: samples of shape ``(n,)``.

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> sky, held = CieTraditional(sky="overcast"), Harmonics.even(2)
    >>> probe(sky, {"sun_zenith": (0.0, 1.5)}, rule="sun-centred", harmonics=held).least.round(4).tolist()
    [0.3333, 0.3333, 0.3333, 0.3333, 0.3333]
    """
    ladder = RULES[rule].ladder
    nodes = ladder(harmonics.bands)[0] if ladder else 0
    parts = [
        sample_block(Job(light, tuple(ranges), block, nodes, harmonics, rule, _ROUGH)) for block in _probes(light, ranges)
    ]
    joined = (
        np.concatenate([getattr(part, name).reshape(-1, *getattr(part, name).shape[2:]) for part in parts])
        for name in ("weights", "least", "least_direction", "estimate")
    )
    return Samples(*joined)


def tolerance_for(error: float, weights: Array, l_min: Array, *, rule: str) -> float:
    """Return the tolerance of ``rule`` that leaves an E_mean of ``error``, as ``choose_nodes`` and adaptive rules mean it.

    ``weights`` ``(n, channels, count)`` are rough ones over the whole range, ``l_min`` ``(n,)`` what their errors are
    divided by (the paper's eq. 3). Not below 1e-13, where rounding is.

    >>> tolerance_for(2.0**-20, np.array([[[3.0, 4.0]]]), np.array([2.0]), rule="sun-centred") * 2**20
    0.5
    """
    share = float(np.min(l_min / np.abs(weights).max(axis=(1, 2))))
    if RULES[rule].ladder is None:
        # It bounds the error of each weight; all of them may have it.
        share /= np.sqrt(weights.shape[-1])
    # What an adaptive rule decides by must not hang on this machine's last bits.
    return max(float(significant(error * share, 8)), _FINEST)


def _probes(light: Light, ranges: Mapping[str, tuple[float, float]]) -> list[Array]:
    """Return a coarse grid of parameter sets, edges and corners included, in blocks ``(g, k, axes)``."""
    probes = parameter_sets.grid([np.linspace(low, high, _PROBES_PER_AXIS) for low, high in ranges.values()])
    return [probes[block] for block in parameter_sets.chunks(probes, peak_of(light, tuple(ranges)), 64)]


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
