"""What a header says about its table in words: inputs, weights, what is folded in."""

from __future__ import annotations

import textwrap

import numpy as np

from skylight_sh.light import sun_disc
from skylight_sh.runtime import Table
from skylight_sh.sphere import clamped_cosine
from skylight_sh.table import twilight
from skylight_sh.table.surroundings import gain

_WIDTH = 95


def about(table: Table) -> tuple[str, list[str]]:
    """Return the weights' unit, and what a reader must know of them, a line each."""
    if table.spec.quantity == "irradiance":
        quantity, unit = "diffuse irradiance E(n) = sum of w * y(n), luminance-scaled lux", "lx"
    else:
        quantity, unit = "linear radiance, luminance-scaled cd/m2", "cd/m2"
    told = [
        f"w[channel][l*(l+1)+m], channels {', '.join(table.channels)}: {quantity}. Real orthonormal spherical harmonics "
        "without the Condon-Shortley sign, z up, m > 0 cosine, m < 0 sine; the azimuth turns from +x towards +y. Below the "
        f"horizon: {_below(table)}. Returns 0; 1 where an input lay outside its range and was clamped; 2 (weights zeroed) "
        f"where one was NaN{'' if table.spec.azimuth is not None else ' or the azimuth infinite'}."
    ]
    if table.spec.quantity == "irradiance":
        told.append("E is not divided by pi: a white diffuse surface reflects E / pi. Bands l = 3, 5, .. carry none of it.")
    if table.spec.windowed:
        told.append("The zonal window sinc(pi l / bands) (Habel et al. 2008, eq. 5) is in the weights.")
    if table.spec.sun_disc:
        radius = f"{np.degrees(sun_disc.HALF_ANGLE):.4g} degrees in radius"
        told.append(f"The sun's disc, {radius} and dimmed by the air, is in the weights.")
        if table.spec.quantity == "irradiance":
            lost = f"{100 * _lobe_error(table.bands):.2g} %"
            told.append(f"{table.bands} bands hold its light on a surface to {lost} of that on one that faces it.")
    elif table.spec.peak_axis:
        told.append("The glow about the sun is in the weights, its disc is not: with a disc of your own, add no halo.")
    if table.surroundings:
        told.append(
            "The scene's surroundings are in the weights: what hides part of the sky, and what shines beside it. The "
            f"accuracy below is that of the sky alone; they multiply its E_mean by at most {gain(table.surroundings):.3g}."
        )
    if table.spec.twilight:
        told.append(f"Below the horizon the light of a sun on it fades: {twilight.FORMULA}.")
    if table.spec.azimuth is not None:
        told.append(f"The sun's azimuth is {table.spec.azimuth:.9g} rad for good.")
    if table.spec.scale:
        told += [f"{name} is {value:.9g} for good." for name, value in table.spec.scale.fixed]
    return unit, [line for text in told for line in textwrap.wrap(safe(text), _WIDTH, break_on_hyphens=False)]


def input_lines(table: Table) -> list[str]:
    """Return the axes with their ranges and units, a line each."""
    units = ["" if axis.unit == "1" else axis.unit for axis in table.axes]
    return [
        f"{axis.name}: [{low:.9g}, {high:.9g}] {unit}".rstrip()
        for axis, (low, high), unit in zip(table.axes, table.ranges, units, strict=True)
    ]


def _lobe_error(bands: int) -> float:
    """Return how far a clamped cosine of so many bands is from its own, at most, as a share of 1."""
    cosine = np.linspace(-1.0, 1.0, 401)
    degrees = np.arange(bands)
    factors = clamped_cosine(bands) * (2 * degrees + 1) / (4 * np.pi)
    cut = np.polynomial.legendre.legval(cosine, factors)
    return float(np.abs(cut - np.maximum(cosine, 0.0)).max())


def _below(table: Table) -> str:
    """Return in words what is below the horizon."""
    ground = table.spec.ground
    if isinstance(ground, str):
        return {"black": "black", "mirror": "the sky's mirror image"}[ground]
    seen = "what of the sky is seen" if table.surroundings and table.surroundings.below.size else "the sky"
    albedo = ", ".join(f"{a:g}" for a in ground)
    return f"an even ground of albedo {albedo}, lit by {seen}{' and the sun' if table.spec.sun_disc else ''}"


def safe(text: str) -> str:
    """Keep text from ending the comment that holds it."""
    return text.replace("*/", "* /").replace("\n", " ")
