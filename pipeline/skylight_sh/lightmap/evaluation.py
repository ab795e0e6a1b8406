"""Irradiance for a normal, from the few SH weights that a lightmap's texel keeps."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.lightmap.texels import Mask, Texels, world_normals
from skylight_sh.transfer.sampling import frames

Array = NDArray[np.float64]
Form = Literal["linear", "clamped", "nonnegative"]

# Of the mean, below which a negative irradiance is rounding.
_ROUNDING = 1e-12
# Normals that a fit looks at.
_FITTED = 100


@dataclass(frozen=True)
class Lightmap:
    """A baked lightmap: incident radiance ``weights`` ``(rows, columns, channels, M*M)`` in world axes, M >= 2, and frames.

    ``frames`` ``(rows, columns, 3, 3)`` and ``covered`` ``(rows, columns)`` are those of its ``Texels``. Raises ValueError
    where shapes do not fit, or a weight is not finite.
    """

    weights: Array = field(repr=False)
    frames: Array = field(repr=False)
    covered: Mask = field(repr=False)

    def __post_init__(self) -> None:
        shape = self.weights.shape
        if self.weights.ndim != 4 or sphere.bands_of(self.weights) < 2:
            raise ValueError(f"Invalid weights of shape {shape}. Should be (rows, columns, channels, M*M), M at least 2.")
        if self.frames.shape != (*shape[:2], 3, 3) or self.covered.shape != shape[:2]:
            raise ValueError(
                f"Invalid frames or cover of shapes {self.frames.shape}, {self.covered.shape}. Should be "
                f"{(*shape[:2], 3, 3)} and {shape[:2]}, as the weights."
            )
        if not np.all(np.isfinite(self.weights)):
            raise ValueError("Invalid weights: some are not finite. Bake them again.")

    @property
    def packed(self) -> Array:
        """The tutorial's four numbers a channel, ``(rows, columns, channels, 4)``: see ``sphere.packed_irradiance``."""
        return sphere.packed_irradiance(self.weights)


def of(texels: Texels, weights: Array) -> Lightmap:
    """Return a lightmap of texels ``(rows, columns)`` and their baked weights; see ``Lightmap``."""
    return Lightmap(weights, texels.frames, texels.covered)


def evaluate(weights: NDArray[np.floating], normals: Array, form: Form = "linear") -> Array:
    """Return the irradiance ``(..., channels)`` towards ``normals`` ``(..., 3)``, unit vectors, not divided by pi.

    ``weights`` ``(..., channels, M*M)`` are the incident radiance's; leading axes broadcast. ``linear`` is the sum of the
    expansion: with two bands ``packed[0] + y packed[1] + z packed[2] + x packed[3]``. ``clamped`` is that, or 0 where it is
    negative. ``nonnegative`` is not negative by itself: with two bands the curve of ``sphere.nonnegative_irradiance``, which
    keeps the mean and a single light's peak; with more the expansion of ``deringed`` weights. That window costs far more
    than a clamp where a surface's own lower half is dark, as it pays for normals that look into the surface. Raises
    ValueError for another form, and where a channel's mean is negative and no window helps.

    >>> up, down = np.array([0.0, 0.0, 1.0]), np.array([0.0, 0.0, -1.0])
    >>> light = np.array([[1.0, 0.0, 1.1, 0.0]])
    >>> evaluate(light, np.stack([up, down])).round(4)[:, 0].tolist()
    [2.0119, -0.2394]
    >>> evaluate(light, np.stack([up, down]), "nonnegative").round(4)[:, 0].tolist()
    [2.4491, 0.1978]
    """
    if form not in get_args(Form):
        raise ValueError(f"Invalid form {form!r}. Should be one of {', '.join(get_args(Form))}.")
    bands = sphere.bands_of(weights)
    if form != "nonnegative":
        found = _linear(weights, normals)
        return found if form == "linear" else np.maximum(found, 0.0)
    if bands == 2:
        packed = sphere.packed_irradiance(weights)
        return sphere.nonnegative_irradiance(packed, normals[..., np.newaxis, np.newaxis, :])[..., 0]
    return _linear(deringed(weights), normals)


def fitted(weights: NDArray[np.floating], normals: Array, bands: int, tilt: float = np.pi / 3) -> Array:
    """Return weights ``(..., channels, M*M)`` of ``bands`` bands whose irradiance is nearest for the normals of a relief.

    ``weights`` ``(..., channels, K*K)`` are incident radiance of more bands, ``normals`` ``(..., 3)`` the surface's own.
    Mere truncation is nearest over all normals, half of which look into the surface; this is least squares over those within
    ``tilt`` (radians, below pi/2) of the surface's. Raises ValueError for another tilt, and for more bands than there are.

    Light of three bands about the normal, seen within 60 degrees of it:

    >>> up, edge = np.array([0.0, 0.0, 1.0]), np.array([[0.0, 0.6, 0.8]])
    >>> light = np.array([[1.0, 0.0, 1.2, 0.0, 0.0, 0.0, 0.8, 0.0, 0.0]])
    >>> [evaluate(w, edge).round(3).tolist() for w in (light, light[:, :4], fitted(light, up, 2))]
    [[[2.051]], [[1.869]], [[2.062]]]
    """
    held = sphere.bands_of(weights)
    if not 0 < tilt < np.pi / 2 or not 2 <= bands <= held:
        raise ValueError(
            f"Invalid tilt {tilt!r} or bands {bands}. Should be radians below pi/2, and from 2 to {held} bands."
        )
    # Even over the cap, enough of them for any of so few bands.
    cap = sphere.spiral(round(2 * _FITTED / (1 - np.cos(tilt))))[:_FITTED]
    n = np.asarray(normals, dtype=np.float64)
    around = cap @ frames(n.reshape(-1, 3), np.zeros(n.size // 3)).transpose(0, 2, 1)
    towards = sphere.irradiance(sphere.basis(around / np.linalg.norm(around, axis=-1, keepdims=True), held))
    matrices = np.linalg.pinv(towards[..., : bands * bands]) @ towards
    return np.asarray(weights @ matrices.reshape(*n.shape[:-1], *matrices.shape[1:]).swapaxes(-1, -2))


def deringed(weights: NDArray[np.floating]) -> Array:
    """Return weights ``(..., channels, M*M)`` whose irradiance is nowhere negative: one window for a texel's channels.

    ``sphere.nonnegative_smoothing`` of each channel, and for the texel the largest; where another channel falls below
    0 by that, as it may, twice as much until none does. A tenth of a second a texel.

    >>> light = np.array([[1.0, 0.0, 2.0, 0.0]])
    >>> float(sphere.minimum(sphere.irradiance(deringed(light)))[0][0].round(6)) >= 0.0
    True
    """
    known = np.asarray(weights, dtype=np.float64)
    bands = sphere.bands_of(known)
    smoothing = sphere.nonnegative_smoothing(known, keep="irradiance").max(axis=-1)
    while True:
        found = sphere.scale_degrees(known, sphere.laplacian_window(bands, smoothing)[..., np.newaxis, :])
        least = sphere.minimum(sphere.irradiance(found))[0]
        # Twice often enough is infinite, which leaves the mean, and the mean is not negative.
        low = np.any(least < -_ROUNDING * np.abs(known[..., 0]), axis=-1)
        if not low.any():
            return found
        smoothing = np.where(low, np.maximum(2 * smoothing, 1e-9), smoothing)


def shade(lightmap: Lightmap, relief: Array, form: Form = "linear") -> Array:
    """Return the irradiance ``(i, k, channels)`` at the texels of a normal map ``relief`` ``(i, k, 3)`` over the same chart.

    The relief is given in the tangent frame (x along u, y along v, z outward) and may be finer or coarser than the lightmap,
    whose weights and frames are interpolated bilinearly between the centres of its covered texels. Where none of the four is
    covered the irradiance is 0.
    """
    if form == "nonnegative" and sphere.bands_of(lightmap.weights) > 2:
        # What lies between texels that are nowhere negative is not negative either.
        weights = lightmap.weights.copy()
        weights[lightmap.covered] = deringed(weights[lightmap.covered])
        return shade(replace(lightmap, weights=weights), relief)
    rows, columns = relief.shape[:2]
    high, wide = lightmap.covered.shape
    below, down = _between(rows, high)
    right, across = _between(columns, wide)
    weights = np.zeros((rows, columns, *lightmap.weights.shape[2:]))
    frames, total = np.zeros((rows, columns, 3, 3)), np.zeros((rows, columns))
    for i, row_share in ((below, 1 - down), (np.minimum(below + 1, high - 1), down)):
        for k, column_share in ((right, 1 - across), (np.minimum(right + 1, wide - 1), across)):
            grid = np.ix_(i, k)
            share = np.multiply.outer(row_share, column_share) * lightmap.covered[grid]
            total += share
            weights += share[..., np.newaxis, np.newaxis] * lightmap.weights[grid]
            frames += share[..., np.newaxis, np.newaxis] * lightmap.frames[grid]
    seen = total > 0
    weights[seen] /= total[seen, np.newaxis, np.newaxis]
    normals = world_normals(frames[seen], relief[seen])
    out = np.zeros((rows, columns, weights.shape[2]))
    out[seen] = evaluate(weights[seen], normals / np.linalg.norm(normals, axis=-1, keepdims=True), form)
    return out


def _linear(weights: NDArray[np.floating], normals: Array) -> Array:
    known = sphere.irradiance(weights)
    return np.asarray((known @ sphere.basis(normals, sphere.bands_of(known))[..., np.newaxis])[..., 0])


def _between(fine: int, coarse: int) -> tuple[NDArray[np.int64], Array]:
    """Return, for the centres of ``fine`` texels, the one of ``coarse`` before each and the share of the next."""
    place = np.clip((np.arange(fine) + 0.5) * coarse / fine - 0.5, 0.0, coarse - 1.0)
    low = np.minimum(place.astype(np.int64), max(coarse - 2, 0))
    return low, place - low
