"""Linear radiance as a picture for screens: exposure, tone mapping, sRGB."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh.light import colour
from skylight_sh.probe.files import to_srgb

Array = NDArray[np.float64]

LUMINANCE = colour.luminance_row("srgb")
"""Factors ``(3,)`` that turn linear sRGB into luminance."""

_KEY, _OUTDOORS, _ADAPTED = 4.9, 50_000.0, 0.16
# Of the way from grey to the brightest that a screen shows of a hue.
_KNEE = 0.6


def exposure(lux: float) -> float:
    """Return the factor on radiance in cd/m2 under so much light; it follows it by 84 %: mornings stay darker.

    ``lux`` is the illuminance of the horizontal, by sky and sun. Raises ValueError where it is not positive.

    >>> round(exposure(50_000.0), 6)
    9.8e-05
    """
    if not (lux > 0.0 and np.isfinite(lux)):
        raise ValueError(f"Invalid illuminance {lux!r} lx. Should be above 0.")
    return float(_KEY / lux * (lux / _OUTDOORS) ** _ADAPTED)


def display(radiance: NDArray[np.floating], exposed: float, white: float = 5.0) -> Array:
    """Return radiance ``(..., 3)`` as sRGB in [0, 1].

    Its luminance goes through Reinhard et al. 2002, eq. 4, with ``white`` the least that shows as white. A colour too bright
    for the screen is made darker and paler, half and half, instead of being cut off, which would change its hue; that begins
    gently before the end, so that no edge shows where.

    >>> display(np.array([[5.0, 5.0, 5.0], [0.0, 0.0, 0.0]]), 1.0).round(6).tolist()
    [[1.0, 1.0, 1.0], [0.0, 0.0, 0.0]]
    """
    scaled = np.maximum(np.asarray(radiance, dtype=np.float64), 0.0) * exposed
    luminance = scaled @ LUMINANCE
    mapped = luminance * (1.0 + luminance / white**2) / (1.0 + luminance)
    colours = scaled * np.divide(mapped, luminance, out=np.zeros_like(mapped), where=luminance > 0.0)[..., np.newaxis]
    grey = np.minimum(mapped, 1.0)[..., np.newaxis]
    most = colours.max(axis=-1, keepdims=True)
    room = 1.0 - grey
    beyond = _bent(np.divide(most - grey, room, out=np.zeros_like(most), where=room > 0.0)) * room
    paler = grey + (colours - grey) * np.divide(beyond, most - grey, out=np.ones_like(most), where=most - grey > 1e-12)
    darker = colours * np.divide(grey + beyond, most, out=np.ones_like(most), where=most > 0.0)
    return np.asarray(to_srgb(np.clip(0.5 * (paler + darker), 0.0, 1.0)))


def _bent(share: Array) -> Array:
    """Return ``share`` as it is up to a knee, and below 1 beyond it, without a kink."""
    over = np.maximum(share - _KNEE, 0.0)
    return np.asarray(np.minimum(share, _KNEE) - (1.0 - _KNEE) * np.expm1(-over / (1.0 - _KNEE)))
