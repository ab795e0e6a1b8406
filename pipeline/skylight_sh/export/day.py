"""A tabulated day: a table's skies at a place, from midnight to midnight, in an engine's form, as JSON or CSV."""

from __future__ import annotations

import csv
import io
import json
import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from datetime import date
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.export import engines
from skylight_sh.runtime import CLAMPED, INVALID, Runtime, Table
from skylight_sh.scene import solar
from skylight_sh.store import atomic

Array = NDArray[np.float64]
Night = Literal["skip", "zero"]


@dataclass(frozen=True)
class Request:
    """What to tabulate: when, where, the table's inputs beside the sun, and the engine's form.

    ``step`` is minutes. ``night`` says what becomes of moments whose sun stands below the horizon, or 12 degrees below it
    for a table with twilight: left out, or zero but for what shines of itself in the table's surroundings.
    """

    format: str
    place: solar.Place
    date: date
    others: Mapping[str, float]
    timezone: str = "UTC"
    step: int = 60
    bands: int | None = None
    window: bool = False
    axes: str | None = None
    exposure: float = 1.0
    night: Night = "skip"


@dataclass(frozen=True)
class Day:
    """A day's skies: local times, the sun's zenith angles and azimuths ``(n,)``, and numbers ``(n, 3, N*N)``.

    ``nights`` counts the moments of ``night``, ``clamped`` those outside the table's ranges.
    """

    request: Request
    times: list[str]
    zeniths: list[float]
    azimuths: list[float]
    numbers: Array
    nights: int
    clamped: int


def tabulate(table: Runtime, request: Request) -> Day:
    """Evaluate ``table`` at every moment of the day that the sun is up, or at all of them.

    Raises ValueError for anything in the request that table, engine or sun do not take.
    """
    profile = engines.PROFILES[request.format]
    bands = engines.bands_for(profile, table.table.bands, request.bands)
    places = [
        (moment.isoformat(), *solar.position(request.place, moment))
        for moment in solar.moments(request.date, request.timezone, request.step)
    ]
    fading, peak = table.table.spec.twilight, table.table.spec.peak_axis
    if peak is None:
        raise ValueError(f"This table has no sun that moves. Its inputs are {', '.join(table.inputs)}.")
    night = math.pi / 2 + (fading.depth if fading else 0.0)
    up = [zenith <= night for _, zenith, _ in places]
    kept = [place for place, shines in zip(places, up, strict=True) if shines or request.night == "zero"]
    zeniths, azimuths = [zenith for _, zenith, _ in kept], [azimuth for _, _, azimuth in kept]
    # A night's sun is clamped, and its light then dropped.
    inputs = {peak: np.minimum(zeniths, night), "sun_azimuth": np.array(azimuths), **request.others}
    weights, status = table.weights_and_status(bands=bands, window=request.window, **inputs)
    if np.any(status == INVALID):
        raise ValueError(f"Invalid inputs {dict(request.others)}. Should be finite numbers.")
    shines = np.array(zeniths) <= night
    weights = np.where(shines[:, np.newaxis, np.newaxis], weights, _at_night(table.table, bands))
    numbers = engines.convert(weights, profile, axes=request.axes, exposure=request.exposure)
    return Day(
        request,
        [time for time, _, _ in kept],
        zeniths,
        azimuths,
        numbers,
        nights=len(up) - sum(up),
        clamped=int(np.count_nonzero((status == CLAMPED) & shines)),
    )


def _at_night(table: Table, bands: int) -> Array:
    """Return the weights ``(channels, N*N)`` of what shines without the sky: the surroundings' lamps and clouds."""
    dark = np.zeros((len(table.channels), table.bands**2))
    return np.asarray(table.surroundings.apply(dark, bands) if table.surroundings else dark[:, : bands * bands])


def to_json(day: Day) -> str:
    """Return the day as JSON: what it is, then ``skies``, each with its time, the sun's place in radians, and the form."""
    request, profile = day.request, engines.PROFILES[day.request.format]
    axes = request.axes or profile.axes
    about = {
        **{key: value for key, value in asdict(request).items() if value is not None},
        "date": request.date.isoformat(),
        "others": dict(request.others),
        "title": profile.title,
        "read_with": profile.reader,
        "quantity": profile.quantity,
        "condon_shortley": profile.condon_shortley,
        "axes": axes,
        "axes_in_words": engines.describe(axes),
        "bands": sphere.bands_of(day.numbers),
        "sun": "zenith angle from up and azimuth from east (+x) towards north (+y), radians",
    }
    rows = zip(day.times, day.zeniths, day.azimuths, day.numbers, strict=True)
    skies = [
        json.dumps({"time": time, "sun_zenith": z, "sun_azimuth": a, "sky": engines.structure(numbers, profile)})
        for time, z, a, numbers in rows
    ]
    head = json.dumps(about, indent=1, sort_keys=True).removesuffix("\n}")
    lines = ",\n".join(skies)  # a line a sky
    return f'{head},\n "skies": [\n{lines}\n ]\n}}\n'


def to_csv(day: Day) -> str:
    """Return the day as CSV: time, the sun's place in radians, then the engine's numbers in its order."""
    profile = engines.PROFILES[day.request.format]
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    bands = sphere.bands_of(day.numbers)
    writer.writerow(["time", "sun_zenith", "sun_azimuth", *engines.columns(profile, bands)])
    for time, z, a, numbers in zip(day.times, day.zeniths, day.azimuths, day.numbers, strict=True):
        writer.writerow([time, z, a, *engines.flatten(numbers, profile)])
    return out.getvalue()


WRITERS = {".json": to_json, ".csv": to_csv}


def write(day: Day, path: Path) -> None:
    """Write the day to ``path``, whole or not at all; its suffix, .json or .csv, decides the form. ValueError for others."""
    if path.suffix not in WRITERS:
        raise ValueError(f"Invalid output {str(path)!r}. Should end in {' or '.join(WRITERS)}.")
    atomic.write(path, WRITERS[path.suffix](day).encode())
