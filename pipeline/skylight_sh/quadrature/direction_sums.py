"""Sums over one list of directions that serves every parameter set, whatever the light: the basis is tabulated once.

Each list is directions ``(n, 3)`` of the upper hemisphere, unit vectors, and their solid angles ``(n,)`` in sr.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.light.protocol import Light, Parameters
from skylight_sh.quadrature.samples import Samples, keep_least

Array = NDArray[np.float64]

# Floats of the basis and of the radiance of one block of nodes (64 MB); what a light holds on its way comes on top.
_BLOCK = 8_000_000


def project(light: Light, parameters: Parameters, nodes: tuple[Array, Array], harmonics: sphere.Harmonics) -> Samples:
    """Integrate radiance times ``y_lm`` for ``parameters`` of any one shape ``(...)``: weights ``(..., channels, count)``.

    ``nodes`` are directions ``(n, 3)`` and their solid angles ``(n,)`` in sr. At most 64 MB of them are held at once.

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> from skylight_sh.quadrature import zenith_gauss
    >>> sky, at = CieTraditional(sky="overcast"), {"sun_zenith": np.array([0.4])}
    >>> project(sky, at, zenith_gauss.directions(8), sphere.Harmonics.even(2)).weights[0, 0, :2].round(4).tolist()
    [1.1816, 1.1939]
    """
    sets = np.broadcast_shapes(*(values.shape for values in parameters.values()))
    named = {name: np.broadcast_to(values, sets).reshape(-1, 1) for name, values in parameters.items()}
    channels = len(light.channels)
    weights, least, where = (
        np.zeros((np.prod(sets, dtype=int), channels, harmonics.count)),
        np.full(sets, np.inf),
        np.zeros((*sets, 3)),
    )
    directions, solid_angles = nodes
    step = max(1, _BLOCK // (harmonics.count + 8 * len(weights) * channels))
    for start in range(0, len(directions), step):
        block = slice(start, start + step)
        table = tabulate(directions[block], solid_angles[block], harmonics)
        radiance = np.broadcast_to(light.radiance(directions[block], named), (len(weights), len(table), channels))
        keep_least((radiance @ light.luminance_row).reshape(*sets, -1), directions[block], least, where)
        weights += radiance.swapaxes(1, 2) @ table
    return Samples(weights.reshape(*sets, channels, -1), least, where, np.full(sets, np.nan))


def project_one(light: Light, parameters: Mapping[str, float], directions: Array, weighted_basis: Array) -> Array:
    """Sum one parameter set's SH weights, ``(channels, count)``, with a basis tabulated once by ``tabulate``.

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> from skylight_sh.quadrature import zenith_gauss
    >>> directions, solid_angles = zenith_gauss.directions(8)
    >>> table = tabulate(directions, solid_angles, 1)
    >>> project_one(CieTraditional(sky="overcast"), {"sun_zenith": 0.4}, directions, table).round(4).tolist()
    [[1.1816]]
    """
    named = {name: np.array([value]) for name, value in parameters.items()}
    return np.asarray(light.radiance(directions, named).T @ weighted_basis)


def tabulate(directions: Array, solid_angles: Array, harmonics: sphere.Harmonics | int) -> Array:
    """Return the SH basis at ``directions`` times their solid angles, ``(n, count)``; see ``sphere.basis``.

    >>> tabulate(np.array([[0.0, 0.0, 1.0]]), np.array([2.0]), 1).round(4).tolist()
    [[0.5642]]
    """
    return sphere.basis(directions, harmonics) * solid_angles[:, np.newaxis]


def towards(z: Array, phi: Array) -> Array:
    """Return unit vectors ``(n, 3)`` of height ``z`` and azimuth ``phi`` in radians, both ``(n,)``.

    >>> towards(np.array([1.0, 0.0]), np.array([0.0, np.pi / 2])).round(6).tolist()
    [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]]
    """
    flat = np.sqrt((1 - z) * (1 + z))
    return np.stack([flat * np.cos(phi), flat * np.sin(phi), z], axis=-1)
