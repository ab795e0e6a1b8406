"""Lights of a table drawn at random: skies of any sun and weather, and the sun's disc that belongs to each."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError
from skylight_sh.light import colour, sun_disc
from skylight_sh.runtime import Runtime

Array = NDArray[np.float64]

CLEAR = 3.0
"""The turbidity of a sun whose table has none."""


def random_suns(
    table: Runtime, bands: int, count: int, seed: int, colour_space: str = "srgb", turbidity: float = CLEAR
) -> tuple[Array, Array]:
    """Return SH weights of ``count`` random skies and of their suns, each ``(count, 3, N*N)`` in cd/m2.

    Every axis of the table is drawn evenly over its range, the sun's azimuth over a turn, by ``seed``. A table of one
    channel lights red, green and blue alike. The sun is the disc of the sky's turbidity (``sun_disc``), or of ``turbidity``
    where the table has none; dark where it is in the table already, where the table has no sun that moves, and below the
    horizon. Raises UserError where the table holds
    irradiance, fewer bands, or other channels than one or three.
    """
    spec = table.table.spec
    if spec.quantity != "radiance":
        raise UserError("Transfer takes a table of radiance, not of irradiance. Give another table.")
    if table.table.bands < bands:
        raise UserError(f"The table has {table.table.bands} bands, the transfer {bands}. Give a table of at least {bands}.")
    if len(spec.channels) not in (1, 3):
        raise UserError(f"The table has {len(spec.channels)} channels. Transfer takes one or three: {spec.channels}.")
    random = np.random.default_rng(seed)
    drawn = {axis.name: random.uniform(axis.low, axis.high, count) for axis in spec.axes}
    azimuth = random.uniform(0.0, 2.0 * np.pi, count)
    given = {**drawn, "sun_azimuth": azimuth}
    sky = np.asarray(table.weights(*(given[name] for name in table.inputs), bands=bands), dtype=np.float64)
    sun = np.zeros((count, 3, bands * bands))
    if spec.peak_axis is not None and not spec.sun_disc:
        zenith = drawn[spec.peak_axis]
        up = zenith <= np.pi / 2
        turned = azimuth if spec.azimuth is None else np.full(count, spec.azimuth)
        haze = np.clip(drawn.get("turbidity", np.full(count, turbidity)), 1.0, 10.0)
        sun[up] = sun_disc.weights(zenith[up], turned[up], haze[up], bands, colour_space)
    if len(spec.channels) == 1:
        grey = colour.luminance_row(colour_space) @ sun
        sky, sun = np.repeat(sky, 3, axis=1), np.repeat(grey[:, np.newaxis], 3, axis=1)
    return sky, sun
