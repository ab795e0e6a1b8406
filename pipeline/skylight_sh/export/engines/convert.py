"""From our SH weights to an engine's numbers: one function, which every profile goes through."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.export.engines.orientation import parse_axes
from skylight_sh.export.engines.profiles import Profile, Quantity

Array = NDArray[np.float64]

# The largest finite half float; shaders and textures of several engines hold the weights as halves.
HALF_MAX = 65504.0

# A_l of max(0, cos), and the constants that turn 1, y, z, x, xy, yz, 3zz - 1, xz, xx - yy into our basis.
_LOBE = np.array([math.pi, 2 * math.pi / 3, math.pi / 4])
_BASIS = np.sqrt(np.array([1, 3, 3, 3, 15, 15, 1.25, 15, 3.75]) / (4 * math.pi))

# Weights below this part of a sky's largest are rounding of the turn: a mirror-symmetric sky keeps its zeros.
_ROUNDING = 1e-13


def bands_for(profile: Profile, available: int, wanted: int | None = None) -> int:
    """Return how many bands to evaluate: ``wanted``, or as many as both the engine takes and the table has.

    Raises ValueError where there is no such number.

    >>> from skylight_sh.export.engines.profiles import PROFILES
    >>> bands_for(PROFILES["directxmath"], available=7)
    6
    """
    least, most = profile.bands
    if wanted is not None and not least <= wanted <= min(most, available):
        takes = f"{least}" if least == most else f"{least} to {most}"
        raise ValueError(f"Invalid bands {wanted}. {profile.title} takes {takes}, and the table has {available}.")
    if available < least:
        raise ValueError(f"{profile.title} needs {least} bands, but the table has {available}. Give another table.")
    return min(most, available) if wanted is None else wanted


def convert(weights: NDArray[np.floating], profile: Profile, *, axes: str | None = None, exposure: float = 1.0) -> Array:
    """Return an engine's numbers ``(..., 3, N*N)`` from our weights ``(..., channels, N*N)`` of a radiance.

    ``axes`` replaces the profile's, see ``parse_axes``. ``exposure`` multiplies the light, so every number alike. One
    channel is given to red, green and blue. Apply a window before: it is zonal about our zenith. Raises ValueError
    for a number of bands or channels that the engine does not take, for bad axes, and for an exposure that is not a
    positive number.

    >>> from skylight_sh.export.engines.profiles import PROFILES
    >>> white = np.zeros((3, 9))
    >>> white[:, 0] = np.sqrt(4 * np.pi)
    >>> convert(white, PROFILES["unity"])[0].round(6).tolist()
    [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    """
    bands = sphere.bands_of(weights)
    bands_for(profile, bands, bands)
    if not (math.isfinite(exposure) and exposure > 0):
        raise ValueError(f"Invalid exposure {exposure}. Should be a finite number above 0; 1 leaves the light alone.")
    if weights.shape[-2] not in (1, 3):
        raise ValueError(f"{profile.title} takes red, green and blue, but the table has {weights.shape[-2]} channels.")
    out = sphere.change_axes(weights, parse_axes(profile.axes if axes is None else axes))
    out = np.where(np.abs(out) < _ROUNDING * np.abs(out).max(axis=(-2, -1), keepdims=True), 0.0, out)
    every = sphere.Harmonics(bands)
    if profile.condon_shortley:
        out = np.where((every.orders % 2 == 1) & (out != 0.0), -out, out)
    out = exposure * _factor(profile.quantity, every.degrees) * out
    return np.repeat(out, 3, axis=-2) if out.shape[-2] == 1 else out


def _factor(quantity: Quantity, degrees: NDArray[np.int64]) -> Array:
    """Return what to multiply each weight of a radiance by, ``(N*N,)``."""
    if quantity.startswith("radiance"):
        return np.full(degrees.shape, 1 / math.pi if quantity == "radiance/pi" else 1.0)
    lobe = _LOBE[degrees]
    if quantity == "irradiance":
        return lobe
    return lobe / math.pi * (_BASIS[: degrees.size] if quantity.endswith("scaled") else 1.0)
