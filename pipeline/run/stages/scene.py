"""What a scene wants of the weights, folded in before the fit: ground, irradiance, and the window."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pipeline import sphere
from pipeline.config.schema import Config

Array = NDArray[np.float64]
Index = NDArray[np.int64]


def folded(config: Config, weights: Array, degrees: Index) -> Array:
    """Return radiance weights ``(..., channels, count)`` of ``degrees`` as what the scene asks for, ground included."""
    scene, bands = config.scene, int(degrees.max()) + 1
    mirrored = degrees.size != bands * bands
    if scene.ground == "mirror":
        weights = sphere.mirror_ground(weights, bands, mirrored=mirrored)
    elif scene.ground != "black":
        weights = sphere.add_ground(weights, scene.ground, bands, mirrored=mirrored)
    return weights if scene.quantity == "radiance" else weights * sphere.clamped_cosine(bands)[degrees]


def luminance_scale(config: Config) -> float:
    """Return what a radiance that errors are divided by is multiplied with: an even sky's irradiance is pi times it."""
    return float(np.pi) if config.scene.quantity == "irradiance" else 1.0


def window(config: Config, bands: int, degrees: Index, orders: Index) -> Array:
    """Return the factors ``(count,)`` of a table of ``bands`` bands: the zonal window, or ones."""
    if not config.scene.window:
        return np.ones(degrees.size)
    return np.asarray(sphere.zonal_sinc(bands)[degrees * (degrees + 1) + orders])
