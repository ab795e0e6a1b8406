"""The light itself in any direction: the sky turned to its sun, what hides it, the ground, pictures of all directions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from skylight_sh.light.protocol import Light
from skylight_sh.probe.layouts import patches
from skylight_sh.quadrature import zenith_gauss

Array = NDArray[np.float64]
# The radiance (n, 3) or opacity (n,) of unit vectors (n, 3).
Lookup = Callable[[Array], Array]

_NODES = 96


@dataclass(frozen=True)
class Sky:
    """A light with the values of its ``parameters``, its peak turned to ``azimuth`` radians from +x towards +y.

    ``dim`` multiplies it, as twilight does. ``below`` is the radiance ``(3,)`` below the skyline, or ``mirror``: the sky
    again. ``skyline`` has elevations in radians at even azimuths, ``opacity`` and ``cloud`` ``(3,)`` are those of clouds,
    and ``occluders`` half-angles ``(k,)`` and directions ``(k, 3)`` of black spheres. Lights of one channel are grey.

    >>> from skylight_sh.light.cie_traditional import CieTraditional
    >>> sky = Sky(CieTraditional(sky="overcast"), {"sun_zenith": 0.4})
    >>> sky.radiance(np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])).tolist()
    [[1.0, 1.0, 1.0], [0.0, 0.0, 0.0]]
    """

    light: Light
    parameters: Mapping[str, float]
    azimuth: float = 0.0
    dim: float = 1.0
    below: tuple[float, ...] | str = (0.0, 0.0, 0.0)
    skyline: tuple[float, ...] = ()
    opacity: Lookup | None = None
    cloud: tuple[float, ...] = (0.0, 0.0, 0.0)
    occluders: tuple[Array, Array] | None = None

    def radiance(self, directions: Array) -> Array:
        """Return the radiance ``(n, 3)`` in cd/m2 from unit vectors ``(n, 3)``."""
        mirrored = self.below == "mirror"
        seen = np.concatenate([directions[:, :2], np.abs(directions[:, 2:])], axis=1) if mirrored else directions
        above = self._over(seen)
        found = np.zeros(directions.shape)
        found[above] = self._above(seen[above])
        if not mirrored:
            found[~above] = self.below
        found[self._occluded(directions)] = 0.0
        return found

    def shows(self, directions: Array) -> NDArray[np.bool_]:
        """Say along which unit vectors ``(n, 3)`` the sky shows, whatever clouds are before it."""
        return self._over(directions) & ~self._occluded(directions)

    def falling(self) -> Array:
        """Return the irradiance in lux ``(3,)`` on the horizontal, right to 1e-4 of itself where nothing hides the sky."""
        directions, solid = zenith_gauss.directions(_NODES)
        return np.asarray((directions[:, 2] * solid) @ self.radiance(directions))

    def on_ground(self, albedo: Sequence[float], straight: Array) -> Sky:
        """Return this sky over even ground of ``albedo``, one or three, lit by it and ``straight`` ``(3,)`` lux of a sun."""
        lux = replace(self, below=(0.0, 0.0, 0.0)).falling() + straight
        return replace(self, below=tuple((np.broadcast_to(albedo, (3,)) * lux / np.pi).tolist()))

    def _over(self, directions: Array) -> NDArray[np.bool_]:
        return np.asarray(elevation(directions) > self._horizon(directions))

    def _occluded(self, directions: Array) -> NDArray[np.bool_]:
        if not self.occluders:
            return np.zeros(len(directions), dtype=bool)
        angles, axes = self.occluders
        return np.asarray((directions @ np.transpose(axes) >= np.cos(angles)).any(axis=1))

    def _above(self, directions: Array) -> Array:
        cos, sin = np.cos(self.azimuth), np.sin(self.azimuth)
        x, y, z = directions.T
        # A skyline may lie below the level horizon, the sky does not.
        own = np.stack([cos * x + sin * y, cos * y - sin * x, np.maximum(z, 0.0)], axis=-1)
        values = {name: np.array([value]) for name, value in self.parameters.items()}
        found = np.broadcast_to(self.dim * self.light.radiance(own, values), directions.shape)
        found = np.where(z[:, np.newaxis] > 0.0, found, 0.0)
        if self.opacity is None:
            return found
        hidden = self.opacity(directions)[:, np.newaxis]
        return np.asarray((1.0 - hidden) * found + hidden * np.array(self.cloud))

    def _horizon(self, directions: Array) -> Array | float:
        if not self.skyline:
            return 0.0
        turn = np.arctan2(directions[:, 1], directions[:, 0]) / (2.0 * np.pi) % 1.0
        return np.interp(turn * len(self.skyline), np.arange(len(self.skyline) + 1), [*self.skyline, self.skyline[0]])


def elevation(directions: Array) -> Array:
    """Return the height of unit vectors ``(n, 3)`` above the horizon in radians, ``(n,)``."""
    return np.asarray(np.arctan2(directions[:, 2], np.hypot(directions[:, 0], directions[:, 1])))


def texels(pixels: NDArray[np.floating], layout: str) -> Lookup:
    """Return what a picture of the whole sphere shows along unit vectors: its nearest texel, ``(n, channels)``.

    Raises ValueError for a picture of another layout.
    """
    from scipy.spatial import KDTree

    looks, values = [], []
    for patch in patches(layout, *pixels.shape[:2]):
        u, v = patch.edges()
        across, down = np.meshgrid(0.5 * (u[1:] + u[:-1]), 0.5 * (v[1:] + v[:-1]))
        inside = patch.chart.density(across, down) > 0.0
        looks.append(patch.chart.directions(across, down)[inside])
        part = pixels[patch.row : patch.row + patch.rows, patch.column : patch.column + patch.columns]
        values.append(part[inside])
    tree, every = KDTree(np.concatenate(looks)), np.concatenate(values).astype(np.float64)
    return lambda directions: every[tree.query(directions)[1]]


def together(parts: Sequence[Lookup]) -> Lookup:
    """Return the sum of radiances ``(n, 3)``, or of grey ones ``(n, 1)``, as one."""
    return lambda directions: np.asarray(sum(np.broadcast_to(part(directions), directions.shape) for part in parts))
