"""What a table's error does to the light that falls on surfaces, beside what E_mean and E_max promise of it.

Errors of weights are sums over weights, over the sky's least luminance (Habel et al. 2008, eqs. 2 and 3); the paper calls
them overestimates of what a surface loses, "since a surface point never sees the whole environment". How large an
overestimate follows from the clamped cosine: by Cauchy and Schwarz no irradiance is off by more than the norm of its
weights times E_mean times the least luminance, and no surface that does not face down receives less than pi / 2 times the
least luminance of a sky above black ground.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.fit.errors import Reference, e_means
from skylight_sh.runtime import Table

Array = NDArray[np.float64]

# A wall every so many degrees, beside an even spiral of all normals.
_WALLS, _SPIRAL = 36, 400


@dataclass(frozen=True)
class Lost:
    """Irradiance that an approximation loses: the largest error over all normals, for each of ``n`` sets, ``(n,)``.

    ``of_largest``: over the largest irradiance of the same set; ``of_least``: over the least of the normals that do not face
    down; ``local``: over the irradiance towards the same normal, of those that do not face down.
    """

    of_largest: Array
    of_least: Array
    local: Array


@dataclass(frozen=True)
class Lighting:
    """What a table loses, and what its number of bands does, in luminance; ``channel`` is the table's worst channel's.

    ``bound`` ``(n,)`` is what each set's E_mean allows of ``table.local``: none where its least luminance is not positive.
    """

    table: Lost
    channel: Lost
    bands: Lost
    bound: Array | None


def normals() -> Array:
    """Return unit normals ``(n, 3)`` that are looked at: an even spiral of all, and walls all round.

    >>> normals().shape, int((normals()[:, 2] == 0.0).sum())
    ((436, 3), 36)
    """
    azimuth = 2.0 * np.pi * np.arange(_WALLS) / _WALLS
    walls = np.stack([np.cos(azimuth), np.sin(azimuth), np.zeros(_WALLS)], axis=-1)
    return np.concatenate([sphere.spiral(_SPIRAL), walls])


def irradiance(weights: NDArray[np.floating], towards: Array, quantity: str = "radiance") -> Array:
    """Return the irradiance ``(..., n)`` that surfaces of unit normals ``towards`` ``(n, 3)`` receive, not divided by pi.

    ``weights`` ``(..., N*N)`` are those of radiance, or already of irradiance, as ``quantity`` says.

    >>> sky = np.array([np.sqrt(4.0 * np.pi), 0.0, 0.0, 0.0])
    >>> irradiance(sky, np.array([[0.0, 0.0, 1.0]])).round(6).tolist()
    [3.141593]
    """
    held = sphere.irradiance(weights) if quantity == "radiance" else weights
    values = held.reshape(-1, held.shape[-1]) @ sphere.basis(towards, sphere.bands_of(held)).T
    return np.asarray(values.reshape(*held.shape[:-1], len(towards)))


def lost(off: Array, true: Array, towards: Array) -> Lost:
    """Return what errors ``off`` ``(n, normals)`` are beside the irradiance ``true`` ``(n, normals)``.

    >>> up_down = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
    >>> found = lost(np.array([[0.1, -0.4]]), np.array([[2.0, 1.0]]), up_down)
    >>> found.of_largest.tolist(), found.of_least.tolist(), found.local.tolist()
    ([0.2], [0.2], [0.05])
    """
    size, up = np.abs(off), towards[:, 2] >= 0.0
    most = size.max(axis=-1)
    return Lost(most / true.max(axis=-1), most / true[..., up].min(axis=-1), (size / true)[..., up].max(axis=-1))


@dataclass(frozen=True)
class Surfaces:
    """Surfaces of unit normals ``towards`` ``(normals, 3)`` below a light of many more bands than any irradiance shows.

    ``whole`` ``(n, channels, N*N)`` are the light's weights of all orders, ``true`` ``(n, channels, normals)`` its
    irradiance.
    """

    light: Reference
    luminance_row: Array
    quantity: str
    towards: Array
    whole: Array
    true: Array


def surfaces(light: Reference, luminance_row: Array, quantity: str = "radiance") -> Surfaces:
    """Return surfaces below ``light``, whose weights are of ``quantity``; ``luminance_row`` ``(channels,)``."""
    towards = normals()
    whole = np.asarray(sphere.Harmonics.of_degrees(light.degrees).unmirror(light.weights), dtype=np.float64)
    return Surfaces(light, luminance_row, quantity, towards, whole, irradiance(whole, towards, quantity))


def measure(table: Table, on: Surfaces) -> Lighting:
    """Measure what ``table`` loses on surfaces: as it is, against the light's first bands; these against the whole light.

    Raises ValueError where the light has fewer bands than the table.
    """
    # In double precision from here on: what is looked for lies far above it.
    rebuilt = np.asarray(table.whole(table.evaluate(on.light.parameters)), dtype=np.float64)
    return beside(rebuilt, on, windowed=table.spec.windowed)


def beside(rebuilt: Array, on: Surfaces, *, windowed: bool = False) -> Lighting:
    """Measure what weights ``rebuilt`` ``(n, channels, M*M)`` lose; they have the window of eq. 5 where ``windowed``."""
    bands, most = sphere.bands_of(rebuilt), sphere.bands_of(on.whole)
    if most < bands:
        raise ValueError(f"The light has {most} bands, the table {bands}. Sample more bands of the light.")
    first = on.whole[..., : bands**2]
    if windowed:
        first = first * sphere.zonal_sinc(bands)
    residual = rebuilt - first
    cut, off = (irradiance(part, on.towards, on.quantity) for part in (first, residual))
    true_, cut_, off_ = (np.einsum("ncd,c->nd", part, on.luminance_row) for part in (on.true, cut, off))
    channels = [lost(off[:, c], on.true[:, c], on.towards) for c in range(off.shape[1])]
    return Lighting(
        table=lost(off_, true_, on.towards),
        channel=Lost(*(np.max([getattr(one, key.name) for one in channels], axis=0) for key in fields(Lost))),
        bands=lost(cut_ - true_, true_, on.towards),
        bound=_bound(residual, on),
    )


def promise(bands: int, quantity: str = "radiance") -> float:
    """Return the most that a surface that does not face down can lose of its irradiance, over E_mean.

    Of radiance it is at most 0.9213: the norm of the clamped cosine, the root of 2 pi / 3, over pi / 2.

    >>> [round(promise(bands), 4) for bands in (1, 3, 7)], round(float(np.sqrt(2 * np.pi / 3) / (np.pi / 2)), 4)
    ([0.5642, 0.9177, 0.921], 0.9213)
    """
    factors = sphere.clamped_cosine(bands) if quantity == "radiance" else np.full(bands, np.pi)
    degrees = np.arange(bands)
    norm = np.sqrt(np.sum(factors**2 * (2 * degrees + 1) / (4 * np.pi)))
    return float(norm / (np.pi / 2))


def _bound(residual: Array, on: Surfaces) -> Array | None:
    """Return what each set's own E_mean, of the worst channel, allows of its luminance."""
    if "per-set" not in on.light.l_min:
        return None
    worst = e_means(residual, on.light.headline).max(axis=-1)
    return np.asarray(promise(sphere.bands_of(residual), on.quantity) * worst)
