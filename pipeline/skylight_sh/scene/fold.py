"""What a scene wants of the weights, folded in before the fit: sun, ground, irradiance, and the window."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.light import sun_disc

Array = NDArray[np.float64]
Index = NDArray[np.int64]

Quantity = Literal["radiance", "irradiance"]
Ground = Literal["black", "mirror"] | tuple[float, ...]


@dataclass(frozen=True)
class Sun:
    """The disc that shines beside a Preetham sky, dimmed by the air of the same turbidity (``light.sun_disc``).

    ``zenith`` and ``turbidity`` name the sky's parameters, ``colour_space`` is the sky's; ``luminance_row`` ``(3,)`` reduces
    the colour to one channel, where the sky is reduced to its luminance.
    """

    zenith: str
    turbidity: str
    colour_space: str = "srgb"
    luminance_row: Array | None = None

    def radiance(self, theta: Array, tau: Array) -> Array:
        """Return the disc's radiance in cd/m2, ``(..., channels)``, for sun zenith angles (radians) and turbidities."""
        colour = sun_disc.radiance(theta, tau, self.colour_space)
        return colour if self.luminance_row is None else np.asarray(colour @ self.luminance_row)[..., np.newaxis]


@dataclass(frozen=True)
class Scene:
    """What of a scene is folded into the weights of its light, before the fit.

    ``axes`` names the parameters that vary, in their order, ``fixed`` holds the others. ``ground`` is what is below the
    horizon: ``black``, the ``mirror`` image of the sky, or an albedo of 0 to 1 for each channel of an even ground that sky
    and sun light. ``windowed`` says whether tables hold the zonal window of Habel et al. 2008, eq. 5.
    """

    axes: tuple[str, ...]
    fixed: Mapping[str, float] = field(default_factory=dict)
    quantity: Quantity = "radiance"
    ground: Ground = "black"
    sun: Sun | None = None
    windowed: bool = False

    def parameter(self, name: str, sets: Array) -> Array:
        """Return the values ``(...)`` of a parameter, varying or fixed, at ``sets`` ``(..., axes)``. Raises KeyError."""
        if name in self.axes:
            return np.asarray(sets[..., self.axes.index(name)])
        return np.full(sets.shape[:-1], self.fixed[name])


def fold(scene: Scene, weights: Array, degrees: Index, sets: Array) -> Array:
    """Return weights ``(..., channels, count)`` of a light at ``sets`` ``(..., axes)`` as what the scene asks for.

    ``degrees`` ``(count,)`` are the weights' l: of all N*N, or of m >= 0 alone. Radiance in cd/m2 stays radiance, or becomes
    irradiance in lux (its degrees times those of the clamped cosine: Ramamoorthi and Hanrahan 2001, eq. 8).

    >>> irradiance = Scene(axes=("turbidity",), quantity="irradiance")
    >>> fold(irradiance, np.ones((1, 3)), np.array([0, 1, 1]), np.array([2.5])).round(4).tolist()
    [[3.1416, 2.0944, 2.0944]]
    """
    held = sphere.Harmonics.of_degrees(degrees)
    from_below: Array | float = 0.0
    if scene.sun:
        theta, tau = (scene.parameter(name, sets) for name in (scene.sun.zenith, scene.sun.turbidity))
        colour = scene.sun.radiance(theta, tau)
        disc = sun_disc.disc(theta, 0.0, held.bands)[..., np.newaxis, held.flat]
        weights, from_below = weights + colour[..., np.newaxis] * disc, colour * sun_disc.from_below(theta)[..., np.newaxis]
    if scene.ground == "mirror":
        weights = sphere.mirror_ground(weights, held)
    elif scene.ground != "black":
        weights = sphere.add_ground(weights, scene.ground, held, from_below=from_below)
    return weights if scene.quantity == "radiance" else weights * sphere.clamped_cosine(held.bands)[degrees]


def luminance_scale(quantity: Quantity) -> float:
    """Return what a radiance that errors are divided by is multiplied with: an even sky's irradiance is pi times it.

    >>> luminance_scale("radiance"), round(luminance_scale("irradiance"), 4)
    (1.0, 3.1416)
    """
    return float(np.pi) if quantity == "irradiance" else 1.0


def window(scene: Scene, harmonics: sphere.Harmonics) -> Array:
    """Return what a table of ``harmonics`` holds its weights multiplied with, ``(count,)``: the zonal window, or ones.

    >>> window(Scene(axes=("turbidity",), windowed=True), sphere.Harmonics.even(2)).round(4).tolist()
    [1.0, 0.6366, 1.0]
    """
    return sphere.zonal_sinc(harmonics.bands)[harmonics.flat] if scene.windowed else np.ones(harmonics.count)
