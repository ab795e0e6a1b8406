"""Gauss-Legendre in the zenith's cosine times uniform azimuths: blind to the sun, for lights that neither peak nor jump."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh.light.protocol import Light, Parameters
from skylight_sh.quadrature import direction_sums
from skylight_sh.quadrature.rule import Rule, steps
from skylight_sh.quadrature.samples import Samples

Array = NDArray[np.float64]


def directions(n: int) -> tuple[Array, Array]:
    """Return Gauss-Legendre in the zenith's cosine (n nodes) times 2n uniform azimuths."""
    x, w = np.polynomial.legendre.leggauss(n)
    z = np.repeat((x + 1) / 2, 2 * n)
    phi = np.tile((np.arange(2 * n) + 0.5) * np.pi / n, n)
    return direction_sums.towards(z, phi), np.repeat(w / 2, 2 * n) * np.pi / n


def project(light: Light, parameters: Parameters, *, nodes: int, bands: int, mirrored: bool) -> Samples:
    """Integrate by ``directions(nodes)``; shapes as ``sun_centred.project``."""
    return direction_sums.project(light, parameters, directions(nodes), bands, mirrored=mirrored)


RULE = Rule("Gauss about the zenith", project, steps(16, 32, 64, 128, 256, 512, 1024))
