"""Environments as pictures: the whole sphere unrolled, azimuth across, altitude up."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.light.protocol import Light
from skylight_sh.probe.files import to_srgb

Array = NDArray[np.float64]
EXTENT = (-180.0, 180.0, -90.0, 90.0)
_ROWS, _COLUMNS = 90, 180


def directions() -> Array:
    """Return unit vectors ``(rows, columns, 3)``: the zenith at the top, azimuth -180 to 180 degrees across."""
    altitude = np.radians(90.0 - (np.arange(_ROWS) + 0.5) * 180.0 / _ROWS)[:, np.newaxis]
    azimuth = np.radians(-180.0 + (np.arange(_COLUMNS) + 0.5) * 360.0 / _COLUMNS)
    flat = np.cos(altitude)
    return np.stack([flat * np.cos(azimuth), flat * np.sin(azimuth), np.sin(altitude) + 0.0 * azimuth], axis=-1)


def sky(light: Light, values: Array, names: tuple[str, ...]) -> Array:
    """Return the light itself, ``(rows, columns, channels)``, black below the horizon."""
    view = directions()
    upper = view[..., 2] > 0
    out = np.zeros((*upper.shape, len(light.channels)))
    parameters = {name: np.array([value]) for name, value in zip(names, values, strict=True)}
    out[upper] = light.radiance(view[upper], parameters)
    return out


def expansion(full: NDArray[np.floating]) -> Array:
    """Return SH weights ``(channels, N*N)`` as a picture ``(rows, columns, channels)``."""
    view = directions()
    values = sphere.evaluate(np.asarray(full, dtype=np.float64), view.reshape(-1, 3))
    return np.moveaxis(values.reshape(-1, *view.shape[:2]), 0, -1)


def white(luminance: Array) -> float:
    """Return what shows as white: the luminance that a fiftieth of a picture exceeds."""
    return float(np.quantile(luminance, 0.98))


def display(radiance: Array, level: float) -> Array:
    """Tone-map linear radiance so that ``level`` is the top (Reinhard 2002), and encode it as sRGB in [0, 1]."""
    scaled = np.maximum(radiance, 0.0) / level
    mapped = np.clip(scaled / (1.0 + scaled) * 2.0, 0.0, 1.0)
    encoded = to_srgb(mapped)
    return encoded if encoded.shape[-1] == 3 else np.repeat(encoded.mean(axis=-1, keepdims=True), 3, axis=-1)
