"""Stratified Monte Carlo (Green 2003), what the 2008 paper describes: one random direction in each of n x n equal cells."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh.light.protocol import Light, Parameters
from skylight_sh.quadrature import direction_sums
from skylight_sh.quadrature.rule import Rule, steps
from skylight_sh.quadrature.samples import Samples

Array = NDArray[np.float64]


def directions(n: int, seed: int) -> tuple[Array, Array]:
    """Return one random direction in each of n x n equal-area cells (Green 2003), seeded."""
    jitter = np.random.default_rng(seed).random((2, n, n))
    cell = np.arange(n)
    z = ((cell[:, np.newaxis] + jitter[0]) / n).ravel()
    phi = ((cell + jitter[1]) * 2 * np.pi / n).ravel()
    return direction_sums.towards(z, phi), np.full(n * n, 2 * np.pi / (n * n))


def project(light: Light, parameters: Parameters, *, nodes: int, bands: int, mirrored: bool) -> Samples:
    """Integrate by ``directions(nodes, nodes)``: another number of cells draws anew, so that two runs are independent."""
    return direction_sums.project(light, parameters, directions(nodes, nodes), bands, mirrored=mirrored)


RULE = Rule("stratified Monte Carlo", project, steps(32, 64, 128, 256, 512, 1024, 2048))
