"""An engine's numbers written down: as the text or JSON that the engine reads, and as columns of a table."""

from __future__ import annotations

import json
from copy import deepcopy
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.export.engines.profiles import Profile

Array = NDArray[np.float64]

CHANNELS = ("red", "green", "blue")


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
    """Return the names of ``flatten``'s numbers, channel and flat index, in the engine's order."""
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
