"""Stratified Monte Carlo (Green 2003), what the 2008 paper describes: one random direction in each of n x n equal cells."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh.light.protocol import Light, Parameters
from skylight_sh.quadrature import direction_sums
from skylight_sh.quadrature.rule import Rule, steps
from skylight_sh.quadrature.samples import Samples
from skylight_sh.sphere import Harmonics

Array = NDArray[np.float64]


def directions(n: int, seed: int) -> tuple[Array, Array]:
    """Return unit vectors ``(n n, 3)`` and solid angles ``(n n,)`` in sr of the upper hemisphere.

    One random direction in each of n x n equal-area cells (Green 2003, "Spherical Harmonic Lighting"), seeded.

    >>> where, solid_angles = directions(4, seed=1)
    >>> where.shape, float((solid_angles.sum() / (2 * np.pi)).round(6))
    ((16, 3), 1.0)
    """
    jitter = np.random.default_rng(seed).random((2, n, n))
    cell = np.arange(n)
    z = ((cell[:, np.newaxis] + jitter[0]) / n).ravel()
    phi = ((cell + jitter[1]) * 2 * np.pi / n).ravel()
    return direction_sums.towards(z, phi), np.full(n * n, 2 * np.pi / (n * n))


def project(light: Light, parameters: Parameters, *, nodes: int, harmonics: Harmonics) -> Samples:
    """Integrate by ``directions(nodes, nodes)``: another number of cells draws anew, so that two runs are independent.

    The zonal weights of an overcast sky, (1 + 2 z) / 3:

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> sky, at = CieTraditional(sky="overcast"), {"sun_zenith": np.array([[0.4]])}
    >>> project(sky, at, nodes=64, harmonics=Harmonics.even(2)).weights[0, 0, 0, :2].round(2).tolist()
    [1.18, 1.19]
    """
    return direction_sums.project(light, parameters, directions(nodes, nodes), harmonics)


RULE = Rule("stratified Monte Carlo", project, steps(32, 64, 128, 256, 512, 1024, 2048))
