"""Charts of the sphere that images are drawn in: where a point of the plane looks, and the exact solid angle of a cell.

A picture shows the world as seen from inside: its centre looks along +x (azimuth 0), +z is up, and -y is to the right.
Plane coordinates are u to the right and v downwards; every chart puts the horizon, where it has one, on the line v = 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere

Array = NDArray[np.float64]

# Gauss nodes an edge of an angular map's cell: enough for rounding on cells of any size, and on small ones.
_COARSE_NODES, _FINE_NODES, _FINE_EDGE = 24, 4, 1 / 32


class Chart(Protocol):
    """A smooth map of a rectangle of the plane to the sphere."""

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Least and largest u, least and largest v."""

    def directions(self, u: Array, v: Array) -> Array:
        """Return unit vectors ``(..., 3)`` for plane coordinates that broadcast to ``(...)``."""

    def density(self, u: Array, v: Array) -> Array:
        """Return the solid angle in sr for each unit of the plane's area, ``(...)``; 0 where the chart shows nothing."""

    def solid_angles(self, u: Array, v: Array) -> Array:
        """Return the solid angles in sr, ``(rows, columns)``, of the cells between edges u ``(columns + 1,)`` and v."""


@dataclass(frozen=True)
class LatLong:
    """Equirectangular: u is minus the azimuth, v minus the altitude, both in radians."""

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """A full turn across, the zenith at the top."""
        return (-np.pi, np.pi, -np.pi / 2, np.pi / 2)

    def directions(self, u: Array, v: Array) -> Array:
        """See ``Chart``."""
        flat = np.cos(v)
        return np.stack(np.broadcast_arrays(flat * np.cos(u), -flat * np.sin(u), -np.sin(v)), axis=-1)

    def density(self, u: Array, v: Array) -> Array:
        """See ``Chart``."""
        return np.broadcast_to(np.cos(v), np.broadcast_shapes(u.shape, v.shape))

    def solid_angles(self, u: Array, v: Array) -> Array:
        """See ``Chart``; sin b - sin a as a product, which does not cancel in thin rows."""
        rows = 2.0 * np.cos((v[1:] + v[:-1]) / 2) * np.sin(np.diff(v) / 2)
        return np.asarray(np.outer(rows, np.diff(u)))


@dataclass(frozen=True)
class Face:
    """One face of a cube of half edge 1: its centre, and the directions of u and v, all of them unit axes."""

    centre: tuple[float, float, float]
    right: tuple[float, float, float]
    down: tuple[float, float, float]

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """The square from -1 to 1."""
        return (-1.0, 1.0, -1.0, 1.0)

    def directions(self, u: Array, v: Array) -> Array:
        """See ``Chart``."""
        across, down = u[..., np.newaxis] * np.array(self.right), v[..., np.newaxis] * np.array(self.down)
        return np.asarray((np.array(self.centre) + across + down) / np.sqrt(1.0 + u * u + v * v)[..., np.newaxis])

    def density(self, u: Array, v: Array) -> Array:
        """See ``Chart``."""
        return np.asarray((1.0 + u * u + v * v) ** -1.5)

    def solid_angles(self, u: Array, v: Array) -> Array:
        """See ``Chart``; differences of the solid angle of the rectangle from the face's centre to a corner."""
        x, y = u[np.newaxis, :], v[:, np.newaxis]
        corner = np.arctan2(x * y, np.sqrt(1.0 + x * x + y * y))
        return np.asarray(np.diff(np.diff(corner, axis=0), axis=1))


@dataclass(frozen=True)
class Angular:
    """Angular map, a light probe (Debevec 1998): the distance from the centre is the angle from +x, 1 for -x."""

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """The square about the unit disc."""
        return (-1.0, 1.0, -1.0, 1.0)

    def directions(self, u: Array, v: Array) -> Array:
        """See ``Chart``; a point outside the disc counts as the nearest on its rim."""
        radius = np.hypot(u, v)
        angle = np.pi * np.minimum(radius, 1.0)
        # sin(angle) / radius, by NumPy's sinc at the centre.
        side = np.where(radius < 1.0, np.pi * np.sinc(radius), np.sin(angle) / np.maximum(radius, 1.0))
        return np.stack([np.cos(angle), -side * u, -side * v], axis=-1)

    def density(self, u: Array, v: Array) -> Array:
        """See ``Chart``."""
        radius = np.hypot(u, v)
        return np.where(radius < 1.0, np.pi**2 * np.sinc(radius), 0.0)

    def solid_angles(self, u: Array, v: Array) -> Array:
        """See ``Chart``; of a cell that the rim cuts, the part inside, 0 for one outside.

        By Stokes a cell's solid angle is the integral of ``1 - cos theta`` over the polar angle along its outline:
        Gauss-Legendre along straight edges, where the integrand is entire, and 2 an angle along the rim. Edges are
        shared, so that the sum over a whole map is 4 pi whatever the quadrature does.
        """
        upright = _edges(u, v)
        level = _edges(v, u)
        return np.diff(upright, axis=0).T + np.diff(level, axis=0) + 2.0 * _rim(u, v)


def _edges(lines: Array, ends: Array) -> Array:
    """Integrate ``1 - cos theta`` over the polar angle along the parts inside the disc of lines at one coordinate.

    ``lines`` ``(n,)`` holds that coordinate, ``ends`` ``(k + 1,)`` the other one's edges. Returns ``(n, k)``.
    """
    nodes, weights = sphere.gauss(_FINE_NODES if np.diff(ends).max() <= _FINE_EDGE else _COARSE_NODES)
    chord = np.sqrt(np.maximum((1.0 - lines) * (1.0 + lines), 0.0))[:, np.newaxis]
    cut = np.clip(ends, -chord, chord)
    half, middle = np.diff(cut, axis=1) / 2, (cut[:, 1:] + cut[:, :-1]) / 2
    out = np.zeros_like(half)
    for node, weight in zip(nodes.tolist(), weights.tolist(), strict=True):
        # (1 - cos(pi r)) / r**2 without loss at r = 0.
        radius = np.hypot(lines[:, np.newaxis], middle + half * node)
        out += weight * 0.5 * (np.pi * np.sinc(radius / 2)) ** 2
    return out * half * lines[:, np.newaxis]


def _rim(u: Array, v: Array) -> Array:
    """Return the angle in radians that the unit circle spends in each cell between edges u and v, ``(rows, columns)``."""
    across, along = np.arccos(u[np.abs(u) <= 1.0]), np.arcsin(v[np.abs(v) <= 1.0])
    crossings = np.sort(np.concatenate([across, -across, along, np.pi - along]) % (2 * np.pi))
    arcs = np.diff(crossings, append=crossings[0] + 2 * np.pi)
    middle = crossings + arcs / 2
    column = np.searchsorted(u, np.cos(middle), side="right") - 1
    row = np.searchsorted(v, np.sin(middle), side="right") - 1
    out = np.zeros((v.size - 1, u.size - 1))
    inside = (column >= 0) & (column < u.size - 1) & (row >= 0) & (row < v.size - 1)
    np.add.at(out, (row[inside], column[inside]), arcs[inside])
    return out
