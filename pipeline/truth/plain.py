"""Rules that know nothing of the sun: nodes for comparison with the sun-centred rule.

Each returns directions ``(n, 3)`` of the upper hemisphere and their solid angles ``(n,)``; ``project`` sums any of them.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from pipeline import sphere
from pipeline.light.protocol import Light

Array = NDArray[np.float64]


def zenith_gauss(n: int) -> tuple[Array, Array]:
    """Gauss-Legendre in the zenith's cosine (n nodes) times 2n uniform azimuths."""
    x, w = np.polynomial.legendre.leggauss(n)
    z = np.repeat((x + 1) / 2, 2 * n)
    phi = np.tile((np.arange(2 * n) + 0.5) * np.pi / n, n)
    return _directions(z, phi), np.repeat(w / 2, 2 * n) * np.pi / n


def stratified(n: int, seed: int) -> tuple[Array, Array]:
    """One random direction in each of n x n equal-area cells (Green 2003), seeded."""
    jitter = np.random.default_rng(seed).random((2, n, n))
    cell = np.arange(n)
    z = ((cell[:, np.newaxis] + jitter[0]) / n).ravel()
    phi = ((cell + jitter[1]) * 2 * np.pi / n).ravel()
    return _directions(z, phi), np.full(n * n, 2 * np.pi / (n * n))


def project(light: Light, parameters: Mapping[str, float], directions: Array, weighted_basis: Array) -> Array:
    """Sum one parameter set's SH weights, ``(channels, count)``, with a basis tabulated once by ``tabulate``."""
    named = {name: np.array([value]) for name, value in parameters.items()}
    return np.asarray(light.radiance(directions, named).T @ weighted_basis)


def tabulate(directions: Array, solid_angles: Array, bands: int, *, mirrored: bool = False) -> Array:
    """Return the SH basis at ``directions`` times their solid angles, ``(n, count)``; ``mirrored`` keeps m >= 0."""
    return sphere.basis(directions, bands, mirrored=mirrored) * solid_angles[:, np.newaxis]


def _directions(z: Array, phi: Array) -> Array:
    flat = np.sqrt((1 - z) * (1 + z))
    return np.stack([flat * np.cos(phi), flat * np.sin(phi), z], axis=-1)
