"""Measured reflectance: isotropic samples on a grid of angles, interpolated linearly, and what is to be said about them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from skylight_sh.reflectance.models.protocol import Model

Array = NDArray[np.float64]


def half_and_difference(incident: Array, views: Array) -> Array:
    """Return Rusinkiewicz' angles ``(..., 3)``: the half vector's zenith angle, the difference's, the difference's azimuth.

    Rusinkiewicz 1998: the incident direction in a frame whose z is the half vector; the azimuth is in [0, pi), since
    exchanging incident and view direction adds pi. Unit vectors ``(..., 3)`` broadcast.

    >>> half_and_difference(np.array([0.6, 0.0, 0.8]), np.array([-0.6, 0.0, 0.8])).round(4).tolist()
    [0.0, 0.6435, 0.0]
    """
    half = incident + views
    half = half / np.maximum(np.linalg.norm(half, axis=-1, keepdims=True), 1e-300)
    flat = np.hypot(half[..., 0], half[..., 1])
    # A half vector along the normal has no azimuth: 0 will do.
    safe = np.maximum(flat, 1e-300)
    c, s = np.where(flat > 0, half[..., 0] / safe, 1.0), half[..., 1] / safe
    x = half[..., 2] * (incident[..., 0] * c + incident[..., 1] * s) - incident[..., 2] * flat
    y = incident[..., 1] * c - incident[..., 0] * s
    z = np.sum(incident * half, axis=-1)
    azimuth = np.mod(np.arctan2(y, x), np.pi)
    return np.stack(np.broadcast_arrays(np.arctan2(flat, half[..., 2]), np.arctan2(np.hypot(x, y), z), azimuth), axis=-1)


def zeniths_and_azimuth(incident: Array, views: Array) -> Array:
    """Return the two zenith angles and the azimuth between the directions in [0, 2 pi), ``(..., 3)``.

    >>> zeniths_and_azimuth(np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.6, 0.8])).round(4).tolist()
    [1.5708, 0.6435, 1.5708]
    """
    one, other = (np.arctan2(np.hypot(d[..., 0], d[..., 1]), d[..., 2]) for d in (incident, views))
    cross = incident[..., 0] * views[..., 1] - incident[..., 1] * views[..., 0]
    along = incident[..., 0] * views[..., 0] + incident[..., 1] * views[..., 1]
    azimuth = np.mod(np.arctan2(cross, along), 2 * np.pi)
    return np.stack(np.broadcast_arrays(one, other, azimuth), axis=-1)


@dataclass(frozen=True)
class Measured:
    """An isotropic surface by samples of f in 1/sr: ``samples`` ``(a, b, c, channels)`` at ``nodes`` of three angles.

    ``angles`` makes the angles of two directions; the last one is an azimuth, of which the samples cover one ``period``
    (then they are joined over its ends), or with a period of 0 those up to pi, mirrored. Angles beyond the nodes are taken
    as the last of them.
    """

    title: str
    nodes: tuple[Array, Array, Array] = field(repr=False)
    samples: Array = field(repr=False)
    angles: Callable[[Array, Array], Array] = field(repr=False)
    period: float

    @property
    def channels(self) -> int:
        """Those of the samples."""
        return int(self.samples.shape[-1])

    @property
    def isotropic(self) -> bool:
        """It is."""
        return True

    @property
    def mirrored(self) -> bool:
        """Only where the samples say so."""
        return self.period == 0.0

    def values(self, incident: Array, views: Array) -> Array:
        """Return ``(..., channels)`` in 1/sr, interpolated linearly; see ``Model.values``."""
        from scipy.interpolate import interpn

        nodes, samples = self.nodes, self.samples
        found = self.angles(incident, views)
        if self.period:
            last = nodes[2]
            nodes = (nodes[0], nodes[1], np.concatenate([last[-1:] - self.period, last, last[:1] + self.period]))
            samples = np.concatenate([samples[:, :, -1:], samples, samples[:, :, :1]], axis=2)
        else:
            found[..., 2] = np.minimum(found[..., 2], 2 * np.pi - found[..., 2])
        for k, at in enumerate(nodes):
            found[..., k] = np.clip(found[..., k], at[0], at[-1])
        return np.asarray(interpn(nodes, samples, found), dtype=np.float64)


def reciprocity(model: Model, samples: int = 4096, seed: int = 1) -> float:
    """Return how much f changes where incident and view direction change places: RMS of the difference over that of f.

    At random pairs of directions within 80 degrees of the normal; 0 for a surface that obeys Helmholtz.

    >>> from skylight_sh.reflectance.models.lambert import Lambert
    >>> reciprocity(Lambert())
    0.0
    """
    rng = np.random.default_rng(seed)
    z, phi = rng.uniform(np.cos(np.radians(80)), 1.0, (2, samples)), rng.uniform(0.0, 2 * np.pi, (2, samples))
    flat = np.sqrt((1 - z) * (1 + z))
    one, other = np.stack([flat * np.cos(phi), flat * np.sin(phi), z], axis=-1)
    there, back = model.values(one, other), model.values(other, one)
    size = float(np.sqrt(np.mean(np.square(there))))
    return float(np.sqrt(np.mean(np.square(there - back)))) / size if size else 0.0
