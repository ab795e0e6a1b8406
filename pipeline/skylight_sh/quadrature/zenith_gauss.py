"""Gauss-Legendre in the zenith's cosine times uniform azimuths: blind to the sun, for lights that neither peak nor jump."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh.light.protocol import Light, Parameters
from skylight_sh.quadrature import direction_sums
from skylight_sh.quadrature.rule import Rule, steps
from skylight_sh.quadrature.samples import Samples
from skylight_sh.sphere import Harmonics, gauss_unit

Array = NDArray[np.float64]


def directions(n: int) -> tuple[Array, Array]:
    """Return unit vectors ``(2 n n, 3)`` and solid angles ``(2 n n,)`` in sr of the upper hemisphere.

    Gauss-Legendre in the zenith's cosine (n nodes) times 2n uniform azimuths.

    >>> where, solid_angles = directions(4)
    >>> where.shape, float((solid_angles.sum() / (2 * np.pi)).round(6))
    ((32, 3), 1.0)
    """
    height, share = gauss_unit(n)
    z = np.repeat(height, 2 * n)
    phi = np.tile((np.arange(2 * n) + 0.5) * np.pi / n, n)
    return direction_sums.towards(z, phi), np.repeat(share, 2 * n) * np.pi / n


def project(light: Light, parameters: Parameters, *, nodes: int, harmonics: Harmonics) -> Samples:
    """Integrate by ``directions(nodes)``; shapes as ``sun_centred.project``.

    The zonal weights of an overcast sky, (1 + 2 z) / 3:

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> sky, at = CieTraditional(sky="overcast"), {"sun_zenith": np.array([[0.4]])}
    >>> project(sky, at, nodes=8, harmonics=Harmonics.even(2)).weights[0, 0, 0, :2].round(4).tolist()
    [1.1816, 1.1939]
    """
    return direction_sums.project(light, parameters, directions(nodes), harmonics)


RULE = Rule("Gauss about the zenith", project, steps(16, 32, 64, 128, 256, 512, 1024))
