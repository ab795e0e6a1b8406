"""Reflectance tabulated in SH: for each view, the weights of ``f cos_i``, whose dot product with the light's is radiance.

Kautz, Sloan and Snyder 2002. A view's weights stand in a frame of its own: z is the surface's normal, and x points where
the mirror direction leans, so that the view stands at azimuth pi and the lobe always at azimuth 0. The light is turned into
that frame. Between views weights are interpolated linearly.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from skylight_sh.quadrature import sun_centred
from skylight_sh.quadrature.samples import NotConvergedError
from skylight_sh.reflectance._as_light import VIEW, Reflection
from skylight_sh.reflectance.models.protocol import Model
from skylight_sh.sphere import Harmonics, bands_of, rotate

Array = NDArray[np.float64]

_LADDER = (48, 72, 108, 160, 240, 360)
# Directions of a block of views held at once, for their nodes' number squared: 100 MB or so.
_SAMPLES = 400_000
# Points whose frames are turned at once: as many matrices as the caches hold.
_BLOCK = 1024


@dataclass(frozen=True)
class Table:
    """A surface's SH weights by view.

    ``weights`` ``(zeniths, azimuths, channels, N*N)`` are those of ``f cos_i`` in 1/sr for view zenith angles from 0 to pi/2
    and azimuths of the mirror direction from the surface's tangent, 2 pi k / azimuths; one azimuth stands for all.
    ``estimate`` is the integrals' error, relative to the largest weight.
    """

    title: str
    weights: Array = field(repr=False)
    estimate: float

    def __post_init__(self) -> None:
        bands_of(self.weights)
        if self.weights.ndim != 4 or len(self.weights) < 2:
            raise ValueError(
                f"Invalid weights of shape {self.weights.shape}. Should be (zeniths, azimuths, channels, N*N), two zeniths "
                "or more."
            )
        if not np.all(np.isfinite(self.weights)):
            raise ValueError("Invalid weights: some are not finite. Tabulate it again.")

    @property
    def bands(self) -> int:
        """How many."""
        return bands_of(self.weights)

    @property
    def albedo(self) -> Array:
        """What share of an even light from above comes back towards each view, ``(zeniths, azimuths, channels)``.

        By reciprocity also the share of the light from there that is reflected at all: more than 1 makes energy.
        """
        return np.asarray(np.sqrt(4 * np.pi) * self.weights[..., 0])

    def at(self, zenith: Array, azimuth: Array) -> Array:
        """Return the weights ``(..., channels, N*N)`` for views at ``zenith`` and mirror directions at ``azimuth``.

        Both are ``(...)``, in radians; a zenith angle beyond the range is taken as its end.
        """
        last, turns = len(self.weights) - 1, self.weights.shape[1]
        low, share = _between(np.clip(zenith / (np.pi / 2), 0.0, 1.0) * last, last - 1)
        if turns == 1:
            rows = self.weights[:, 0]
            return np.asarray((1 - share) * rows[low] + share * rows[low + 1])
        left, across = _between(np.mod(azimuth / (2 * np.pi), 1.0) * turns, turns - 1)
        right = (left + 1) % turns
        near, far = ((1 - across) * self.weights[row, left] + across * self.weights[row, right] for row in (low, low + 1))
        return np.asarray((1 - share) * near + share * far)


def tabulate(model: Model, bands: int, *, zeniths: int = 91, azimuths: int = 36, tolerance: float = 1e-4) -> Table:
    """Return a model's ``Table`` of ``bands`` bands and ``zeniths`` views, ``azimuths`` of each where it is not isotropic.

    Each view's weights are integrated by the sun-centred rule about the mirror direction, with more and more nodes until
    two runs agree within ``tolerance`` of the largest weight. Raises NotConvergedError where none do, as with a measured
    table's steps: give a larger tolerance.

    >>> from skylight_sh.reflectance.models.lambert import Lambert
    >>> found = tabulate(Lambert((0.5,)), 2, zeniths=2)  # albedo / pi times a clamped cosine
    >>> found.weights[0, 0, 0, [0, 2]].round(4).tolist(), found.albedo[0, 0].round(4).tolist()
    ([0.141, 0.1629], [0.5])
    """
    if zeniths < 2 or azimuths < 1:
        raise ValueError(f"Invalid views: {zeniths} zeniths, {azimuths} azimuths. Should be at least 2 and 1.")
    turns = 1 if model.isotropic else azimuths
    found = np.empty((zeniths, turns, model.channels, bands * bands))
    estimate = 0.0
    # Of a mirrored surface, turns by the other half circle are mirror images: y turns its sign, and orders below 0 theirs.
    mirrored = np.where(Harmonics(bands).orders < 0, -1.0, 1.0)
    for k in range(turns):
        if model.mirrored and 2 * k > turns:
            found[:, k] = found[:, turns - k] * mirrored
            continue
        found[:, k], off = _integrate(Reflection(model, 2 * np.pi * k / turns), bands, zeniths, tolerance)
        estimate = max(estimate, off)
    return Table(model.title, found, estimate)


def shade(table: Table, weights: NDArray[np.floating], normals: Array, views: Array, tangents: Array | None = None) -> Array:
    """Return the radiance ``(..., channels)`` that surfaces reflect towards the eye, in the light's unit.

    ``weights`` ``(..., channels, M*M)`` are the light's in world axes, at each point or one for all, ``normals`` and
    ``views`` unit vectors ``(..., 3)`` that point away from the surface; ``tangents`` ``(..., 3)`` are asked for where the
    table is of a surface that is not isotropic. Bands beyond those of the table or the light are left out. A view from below
    the surface is taken as one along it. Raises ValueError where tangents are missing.
    """
    if tangents is None and table.weights.shape[1] > 1:
        raise ValueError(f"{table.title}: not isotropic. Give tangents, unit vectors of the normals' shape.")
    size = min(table.bands, bands_of(weights)) ** 2
    sides = [np.asarray(side, dtype=np.float64) for side in (normals, views, normals if tangents is None else tangents)]
    lead = np.broadcast_shapes(*(side.shape[:-1] for side in sides), weights.shape[:-2])
    n, v, t = (np.broadcast_to(side, (*lead, 3)).reshape(-1, 3) for side in sides)
    channels = np.broadcast_shapes(weights.shape[-2:-1], table.weights.shape[2:3])
    # One light for all stays one.
    own = weights.ndim > 2
    light = weights[..., :size]
    lit = np.broadcast_to(light, (*lead, *light.shape[-2:])).reshape(-1, *light.shape[-2:]) if own else light
    out = np.empty((len(n), *channels))
    for start in range(0, len(n), _BLOCK):
        some = slice(start, start + _BLOCK)
        frames, height = view_frames(n[some], v[some])
        azimuth = np.zeros_like(height) if tangents is None else _azimuth(frames, t[some])
        known = table.at(np.arccos(np.clip(height, 0.0, 1.0)), azimuth)
        local = rotate(lit[some] if own else lit, frames[:, np.newaxis])
        out[some] = np.einsum("...i,...i->...", local, known[..., :size])
    return out.reshape(*lead, *channels)


def view_frames(normals: Array, views: Array) -> tuple[Array, Array]:
    """Return the frames of views and the cosines of their zenith angles: ``(..., 3, 3)`` and ``(...)``.

    ``normals`` and ``views`` are unit vectors ``(..., 3)``. A frame's rows are its axes: it takes a direction in the world
    to the same one as the table has it. Of a view along the normal any frame is right; one is chosen.

    >>> frames, height = view_frames(np.array([0.0, 0.0, 1.0]), np.array([0.6, 0.0, 0.8]))
    >>> frames[0].tolist(), float(height)
    ([-1.0, 0.0, 0.0], 0.8)
    """
    n, v = np.broadcast_arrays(np.asarray(normals, dtype=np.float64), np.asarray(views, dtype=np.float64))
    height = np.sum(n * v, axis=-1)
    across = height[..., np.newaxis] * n - v
    length = np.linalg.norm(across, axis=-1, keepdims=True)
    # Far from the normal, whichever axis of the world that is.
    other = np.where(np.abs(n[..., 2:]) < 0.9, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0])
    other = other - np.sum(other * n, axis=-1, keepdims=True) * n
    across = np.where(length > _ALONG, across, other)
    x = across / np.linalg.norm(across, axis=-1, keepdims=True)
    # What rounding left of the normal in a short difference.
    x = x - np.sum(x * n, axis=-1, keepdims=True) * n
    x = x / np.linalg.norm(x, axis=-1, keepdims=True)
    return np.stack([x, np.cross(n, x), n], axis=-2), height


# Nearer to the normal than this a view's azimuth is rounding.
_ALONG = 1e-9


def _azimuth(frames: Array, tangents: Array) -> Array:
    """Return the mirror directions' azimuth from the tangents, ``(...)``."""
    along = (frames @ np.asarray(tangents, dtype=np.float64)[..., np.newaxis])[..., 0]
    return np.asarray(-np.arctan2(along[..., 1], along[..., 0]))


def _integrate(light: Reflection, bands: int, zeniths: int, tolerance: float) -> tuple[Array, float]:
    """Return weights ``(zeniths, channels, N*N)`` and their error, relative to the largest."""
    harmonics = Harmonics.even(bands) if light.hints.mirrored else Harmonics(bands)
    views = np.linspace(0.0, np.pi / 2, zeniths)[:, np.newaxis]
    last: Array | None = None
    off = np.inf
    for nodes in _LADDER:
        step = max(1, _SAMPLES // (nodes * nodes))
        blocks = [{VIEW: views[start : start + step]} for start in range(0, zeniths, step)]
        parts = [sun_centred.project(light, block, nodes=nodes, harmonics=harmonics).weights[:, 0] for block in blocks]
        found = np.concatenate(parts)
        if not np.all(np.isfinite(found)):
            raise ValueError(f"{light.title}: its values are not finite. Look at what it returns near the surface's edge.")
        if last is not None:
            off = float(np.abs(found - last).max() / max(float(np.abs(found).max()), np.finfo(np.float64).tiny))
            if off <= tolerance:
                return np.asarray(harmonics.unmirror(found), dtype=np.float64), off
        last = found
    raise NotConvergedError(
        f"{light.title}: {_LADDER[-1]} nodes reach {off:.2g} of the largest weight, but the tolerance is {tolerance:.2g}. "
        "Raise the tolerance, or take a rougher surface."
    )


def _between(place: Array, last: int) -> tuple[NDArray[np.int64], Array]:
    """Return the entry below a place, no later than ``last``, and the share of the next one, ``(..., 1, 1)``."""
    low = np.minimum(place.astype(np.int64), last)
    return low, np.asarray((place - low)[..., np.newaxis, np.newaxis])
