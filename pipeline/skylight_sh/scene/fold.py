"""What a scene wants of the weights, folded in before the fit: sun, ground, irradiance, and the window."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.config.schema import Config
from skylight_sh.fit.errors import Reference
from skylight_sh.light import sun_disc
from skylight_sh.light.preetham import Preetham

Array = NDArray[np.float64]
Index = NDArray[np.int64]


def folded(config: Config, weights: Array, degrees: Index, sets: Array) -> Array:
    """Return weights ``(..., channels, count)`` of the light at ``sets`` ``(..., axes)`` as what the scene asks for."""
    scene, bands = config.scene, int(degrees.max()) + 1
    mirrored = degrees.size != bands * bands
    from_below: Array | float = 0.0
    if isinstance(config.light, Preetham) and scene.sun_disc:
        theta, tau = (_parameter(config, sets, name) for name in ("sun_zenith", "turbidity"))
        colour = sun_disc.radiance(theta, tau, config.light.colour_space)
        if scene.channels == "luminance":
            colour = (colour @ config.light.luminance_row)[..., np.newaxis]
        orders = sphere.degrees_orders(bands, mirrored=mirrored)[1]
        disc = sun_disc.disc(theta, 0.0, bands)[..., np.newaxis, degrees * (degrees + 1) + orders]
        weights, from_below = weights + colour[..., np.newaxis] * disc, colour * sun_disc.from_below(theta)[..., np.newaxis]
    if scene.ground == "mirror":
        weights = sphere.mirror_ground(weights, bands, mirrored=mirrored)
    elif scene.ground != "black" and not scene.masked:
        weights = sphere.add_ground(weights, scene.ground, bands, mirrored=mirrored, from_below=from_below)
    return weights if scene.quantity == "radiance" else weights * sphere.clamped_cosine(bands)[degrees]


def _parameter(config: Config, sets: Array, name: str) -> Array:
    """Return a parameter of the light at ``sets`` ``(..., axes)``: an axis, or fixed."""
    for i, axis in enumerate(config.axes):
        if axis.name == name:
            return np.asarray(sets[..., i])
    return np.full(sets.shape[:-1], config.scene.fixed[name])


def luminance_scale(config: Config) -> float:
    """Return what a radiance that errors are divided by is multiplied with: an even sky's irradiance is pi times it."""
    return float(np.pi) if config.scene.quantity == "irradiance" else 1.0


def window(config: Config, bands: int, degrees: Index, orders: Index) -> Array:
    """Return the factors ``(count,)`` of a table of ``bands`` bands: the zonal window, or ones."""
    if not config.scene.window:
        return np.ones(degrees.size)
    return np.asarray(sphere.zonal_sinc(bands)[degrees * (degrees + 1) + orders])


def windowed_reference(config: Config, bands: int, mirrored: bool, reference: Reference) -> Reference:
    """Return what a table of ``bands`` bands is measured against: its own weights, behind the window if there is one."""
    use = reference.first_bands(bands)
    factors = window(config, bands, *sphere.degrees_orders(bands, mirrored=mirrored))
    return replace(reference, weights=reference.weights[..., use] * factors, degrees=reference.degrees[use])
