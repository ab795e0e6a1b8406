"""Rules that know nothing of the sun: one set of nodes for every light (Gauss about the zenith, stratified Monte Carlo).

Here for comparison, and for lights that neither peak nor jump. Each list of nodes is directions ``(n, 3)`` of the upper
hemisphere and their solid angles ``(n,)``.
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


def zenith_gauss(n: int) -> tuple[Array, Array]:
    """Return Gauss-Legendre in the zenith's cosine (n nodes) times 2n uniform azimuths."""
    x, w = np.polynomial.legendre.leggauss(n)
    z = np.repeat((x + 1) / 2, 2 * n)
    phi = np.tile((np.arange(2 * n) + 0.5) * np.pi / n, n)
    return _directions(z, phi), np.repeat(w / 2, 2 * n) * np.pi / n


def stratified(n: int, seed: int) -> tuple[Array, Array]:
    """Return one random direction in each of n x n equal-area cells (Green 2003), seeded."""
    jitter = np.random.default_rng(seed).random((2, n, n))
    cell = np.arange(n)
    z = ((cell[:, np.newaxis] + jitter[0]) / n).ravel()
    phi = ((cell + jitter[1]) * 2 * np.pi / n).ravel()
    return _directions(z, phi), np.full(n * n, 2 * np.pi / (n * n))


def project_zenith(light: Light, parameters: Parameters, *, nodes: int, bands: int, mirrored: bool) -> Samples:
    """Integrate by ``zenith_gauss(nodes)``; shapes as ``sun_centred.project``."""
    return _project(light, parameters, zenith_gauss(nodes), bands, mirrored=mirrored)


def project_stratified(light: Light, parameters: Parameters, *, nodes: int, bands: int, mirrored: bool) -> Samples:
    """Integrate by ``stratified(nodes, nodes)``: another number of cells draws anew, so that two runs are independent."""
    return _project(light, parameters, stratified(nodes, nodes), bands, mirrored=mirrored)


def _project(light: Light, parameters: Parameters, nodes: tuple[Array, Array], bands: int, *, mirrored: bool) -> Samples:
    sets = np.broadcast_shapes(*(values.shape for values in parameters.values()))
    count = sphere.count(bands, mirrored=mirrored)
    named = {name: np.broadcast_to(values, sets).reshape(-1, 1) for name, values in parameters.items()}
    channels = len(light.channels)
    weights, least, where = (
        np.zeros((np.prod(sets, dtype=int), channels, count)),
        np.full(sets, np.inf),
        np.zeros((*sets, 3)),
    )
    directions, solid_angles = nodes
    step = max(1, _BLOCK // (count + 8 * len(weights) * channels))
    for start in range(0, len(directions), step):
        block = slice(start, start + step)
        table = tabulate(directions[block], solid_angles[block], bands, mirrored=mirrored)
        radiance = np.broadcast_to(light.radiance(directions[block], named), (len(weights), len(table), channels))
        keep_least((radiance @ light.luminance_row).reshape(*sets, -1), directions[block], least, where)
        weights += radiance.swapaxes(1, 2) @ table
    return Samples(weights.reshape(*sets, channels, count), least, where, np.full(sets, np.nan))


def project_one(light: Light, parameters: Mapping[str, float], directions: Array, weighted_basis: Array) -> Array:
    """Sum one parameter set's SH weights, ``(channels, count)``, with a basis tabulated once by ``tabulate``."""
    named = {name: np.array([value]) for name, value in parameters.items()}
    return np.asarray(light.radiance(directions, named).T @ weighted_basis)


def tabulate(directions: Array, solid_angles: Array, bands: int, *, mirrored: bool = False) -> Array:
    """Return the SH basis at ``directions`` times their solid angles, ``(n, count)``; ``mirrored`` keeps m >= 0."""
    return sphere.basis(directions, bands, mirrored=mirrored) * solid_angles[:, np.newaxis]


def _directions(z: Array, phi: Array) -> Array:
    flat = np.sqrt((1 - z) * (1 + z))
    return np.stack([flat * np.cos(phi), flat * np.sin(phi), z], axis=-1)
