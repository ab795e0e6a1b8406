"""Engines: our SH weights as the numbers that a named engine holds, in its axes, and written down as it reads them.

``PROFILES`` says what each engine expects. One sky takes ``convert``, then ``structure`` (JSON) or ``text``; rows of a table
take ``columns`` and ``flatten``. Where our +x (east), +y (north) and +z (up) go is text, which ``parse_axes`` reads.
"""

from __future__ import annotations

import json
import math
import re
from copy import deepcopy
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.export.engine_profiles import PROFILES, Profile, Quantity

__all__ = [
    "CHANNELS",
    "HALF_MAX",
    "PROFILES",
    "Profile",
    "bands_for",
    "columns",
    "convert",
    "describe",
    "flatten",
    "parse_axes",
    "structure",
    "text",
]

Array = NDArray[np.float64]

CHANNELS = ("red", "green", "blue")
# The largest finite half float; shaders and textures of several engines hold the weights as halves.
HALF_MAX = 65504.0

# A_l of max(0, cos), and the constants that turn 1, y, z, x, xy, yz, 3zz - 1, xz, xx - yy into our basis.
_LOBE = np.array([math.pi, 2 * math.pi / 3, math.pi / 4])
_BASIS = np.sqrt(np.array([1, 3, 3, 3, 15, 15, 1.25, 15, 3.75]) / (4 * math.pi))

# Weights below this part of a sky's largest are rounding of the turn: a mirror-symmetric sky keeps its zeros.
_ROUNDING = 1e-13
_PART = re.compile(r"\s*([xyz])\s*=\s*([+-]?)([xyz])\s*")


def bands_for(profile: Profile, available: int, wanted: int | None = None) -> int:
    """Return how many bands to evaluate: ``wanted``, or as many as both the engine takes and the table has.

    Raises ValueError where there is no such number.

    >>> from skylight_sh.export.engine_profiles import PROFILES
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

    >>> from skylight_sh.export.engine_profiles import PROFILES
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


def parse_axes(text: str) -> Array:
    """Return the matrix ``(3, 3)`` that takes our directions to the engine's.

    ``text`` names, for each of our axes, the engine's axis that it goes to: ``"x=+x,y=-z,z=+y"`` sends our +y to the
    engine's -z. Raises ValueError where an axis is missing, named twice, or the target of two.

    >>> parse_axes("x=+x,y=-z,z=+y").tolist()
    [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]
    """
    parts = [_PART.fullmatch(part) for part in text.split(",")]
    found = [part.groups() for part in parts if part]
    ours, theirs = {part[0] for part in found}, {part[2] for part in found}
    if len(found) != 3 or len(parts) != 3 or len(ours) != 3 or len(theirs) != 3:
        raise ValueError(
            f"Invalid axes {text!r}. Should send each of our +x (east), +y (north), +z (up) to an axis of its own, "
            'like "x=+x,y=-z,z=+y".'
        )
    matrix = np.zeros((3, 3))
    for axis, sign, target in found:
        matrix["xyz".index(target), "xyz".index(axis)] = -1.0 if sign == "-" else 1.0
    return matrix


def describe(text: str) -> str:
    """Say in words what ``parse_axes`` reads: where east, north and up go, and which hand the engine's axes have.

    >>> describe("x=+x,y=-z,z=+y")
    'east is +x, north is -z, up is +y; right-handed'
    """
    matrix = parse_axes(text)
    places = []
    for i, name in enumerate(("east", "north", "up")):
        target = int(np.abs(matrix[:, i]).argmax())
        places.append(f"{name} is {'+' if matrix[target, i] > 0 else '-'}{'xyz'[target]}")
    hand = "right" if np.linalg.det(matrix) > 0 else "left"
    return f"{', '.join(places)}; {hand}-handed"


def text(numbers: Array, profile: Profile) -> str:
    """Return one sky, ``(3, N*N)``, as the engine's text: JSON, or for lines the text of Filament's cmgen."""
    if profile.layout != "lines":
        return json.dumps(structure(numbers, profile))
    every = sphere.Harmonics(sphere.bands_of(numbers))
    return "\n".join(
        f"({', '.join(f'{value:18.9g}' for value in triple)}); // L{l}{m}, irradiance, pre-scaled base"
        for triple, l, m in zip(numbers.T, every.degrees.tolist(), every.orders.tolist(), strict=True)
    )


def structure(numbers: Array, profile: Profile) -> Any:
    """Return one sky, ``(3, N*N)``, as what JSON of that engine holds."""
    values: Any = flatten(numbers, profile)
    if profile.layout != "flat":
        step = numbers.shape[-1] if profile.layout == "planar" else len(CHANNELS)
        values = [values[i : i + step] for i in range(0, len(values), step)]
    if not profile.keys:
        return values
    whole: dict[str, Any] = deepcopy(profile.around)
    place = whole[profile.inside] if profile.inside else whole
    place.update(zip(profile.keys, values if len(profile.keys) > 1 else [values], strict=True))
    return whole


def columns(profile: Profile, bands: int) -> list[str]:
    """Return the names of ``flatten``'s numbers, channel and flat index, in the engine's order.

    >>> columns(PROFILES["unreal"], 1)
    ['red_0', 'green_0', 'blue_0']
    """
    places = range(bands * bands)
    if profile.layout == "planar":
        return [f"{channel}_{i}" for channel in CHANNELS for i in places]
    return [f"{channel}_{i}" for i in places for channel in CHANNELS]


def flatten(numbers: Array, profile: Profile) -> list[float]:
    """Return one sky, ``(3, N*N)``, as a row of numbers in the engine's order."""
    return [_single(value) for value in (numbers if profile.layout == "planar" else numbers.T).ravel().tolist()]


def _single(value: float) -> float:
    """Keep the nine digits that a float of 32 bits needs, and no more."""
    return float(f"{value:.9g}")
