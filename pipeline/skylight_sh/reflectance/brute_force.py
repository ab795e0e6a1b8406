"""What a surface reflects, integrated over directions without any expansion: the truth that lobes and tables are held to."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.light.protocol import Light
from skylight_sh.quadrature import sun_centred, zenith_gauss
from skylight_sh.reflectance.models.protocol import Model
from skylight_sh.reflectance.tabulated import view_frames

Array = NDArray[np.float64]
Radiance = Callable[[Array], Array]

_DOWN = np.array([1.0, 1.0, -1.0])
# Products of a block of points and nodes held at once.
_BLOCK = 4_000_000


@dataclass(frozen=True)
class Environment:
    """A light above the horizon and an even ground below it, direction by direction.

    ``directions`` ``(n, 3)`` and ``powers`` ``(n, channels)``, radiance times solid angle, are nodes over the whole sphere
    that follow the light's peak and its jump on the horizon.
    """

    light: Light
    parameters: Mapping[str, float]
    ground: Array
    directions: Array
    powers: Array

    def radiance(self, directions: Array) -> Array:
        """Return what is seen in ``directions`` ``(..., 3)``: ``(..., channels)``."""
        above = directions[..., 2] > 0.0
        named = {name: np.array(value) for name, value in self.parameters.items()}
        found = np.empty((*above.shape, len(self.ground)))
        found[above] = self.light.radiance(directions[above], named)
        found[~above] = self.ground
        return found


def environment(light: Light, parameters: Mapping[str, float], albedo: float = 0.0, nodes: int = 128) -> Environment:
    """Return a light with its parameters, and a ground of ``albedo`` lit by it: radiance albedo E / pi.

    Above a white ground an even sky is the same everywhere:

    >>> from skylight_sh.light.cie_general import CieGeneral
    >>> seen = environment(CieGeneral(sky=5), {"sun_zenith": 0.5}, albedo=1.0, nodes=32)
    >>> up, down = seen.radiance(np.array([[0.0, 0.0, 1.0], [0.6, 0.0, -0.8]]))[:, 0]
    >>> float((down / up).round(6)), float((seen.powers.sum() / (4 * np.pi * up)).round(6))
    (1.0, 1.0)
    """
    axis = light.hints.peak_axis
    half, areas = sun_centred.half_sky(parameters[axis] if axis else light.hints.peak_zenith or 0.0, nodes)
    up = np.concatenate([half, half * np.array([1.0, -1.0, 1.0])])
    named = {name: np.array(value) for name, value in parameters.items()}
    sky = light.radiance(up, named) * np.tile(0.5 * areas, 2)[:, np.newaxis]
    ground = albedo / np.pi * (up[:, 2] @ sky)
    down, solid_angles = zenith_gauss.directions(nodes // 2)
    powers = np.concatenate([sky, np.multiply.outer(solid_angles, ground)])
    return Environment(light, parameters, ground, np.concatenate([up, down * _DOWN]), powers)


def cosine_lobe(seen: Environment, exponent: float, reflected: Array) -> Array:
    """Return what the lobe ``(n+1) / (2 pi) max(0, cos)**n`` reflects, ``(p, channels)``.

    ``reflected`` are mirror directions ``(p, 3)``.
    """
    out = np.empty((len(reflected), seen.powers.shape[1]))
    step = max(1, _BLOCK // len(seen.directions))
    for start in range(0, len(reflected), step):
        cosine = np.maximum(reflected[start : start + step] @ seen.directions.T, 0.0)
        out[start : start + step] = cosine**exponent @ seen.powers
    return np.asarray((exponent + 1) / (2 * np.pi) * out)


def reflected(
    model: Model, radiance: Radiance, normals: Array, views: Array, tangents: Array | None = None, nodes: int = 96
) -> Array:
    """Return what surfaces reflect towards the eye, ``(p, channels)``, under a ``radiance`` of directions in the world.

    Channels are those of the radiance, or the model's where one of them has a single one.
    ``normals``, ``views`` and ``tangents`` are unit vectors ``(p, 3)``. Each is a Gauss rule over the directions above the
    surface, polar about the mirror direction; a jump of the light costs accuracy of the order of a node's share.
    """
    frames, height = view_frames(normals, views)
    found = []
    for k, (frame, up) in enumerate(zip(frames, height.tolist(), strict=True)):
        half, areas = sun_centred.half_sky(float(np.arccos(np.clip(up, 0.0, 1.0))), nodes)
        world = np.concatenate([half, half * np.array([1.0, -1.0, 1.0])]) @ frame
        axes = frame if tangents is None else np.stack([tangents[k], np.cross(normals[k], tangents[k]), normals[k]])
        values = model.values(world @ axes.T, views[k] @ axes.T)
        lit = radiance(world) * (world @ normals[k] * np.tile(0.5 * areas, 2))[:, np.newaxis]
        found.append(np.sum(values * lit, axis=0))
    return np.stack(found)


def relative_rms(found: Array, exact: Array) -> float:
    """Return the root of the mean squared error over that of the mean square, all points and channels together.

    >>> round(relative_rms(np.array([1.0, 2.0]), np.array([1.0, 1.0])), 4)
    0.7071
    """
    return float(np.sqrt(np.mean(np.square(found - exact)) / np.mean(np.square(exact))))
