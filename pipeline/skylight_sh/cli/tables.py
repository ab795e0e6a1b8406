"""The commands that read an exported table: ``evaluate`` prints one sky, ``export`` writes a day of them."""

from __future__ import annotations

import json
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import click

from skylight_sh.export.engines.profiles import PROFILES

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from skylight_sh.runtime import Runtime

_AT = click.option(
    "--at", "given", multiple=True, metavar="NAME=VALUE", help="Value of one axis; angles in radians. Repeat for each axis."
)
_TURBIDITY = click.option("--turbidity", type=float, help="Short for --at turbidity=VALUE.")
_BANDS = click.option("--bands", type=click.IntRange(1), help="Fewer bands than the table has.")
_WINDOW = click.option("--window", is_flag=True, help="Apply the zonal window of the paper's eq. 5.")
_FORMATS = click.Choice(list(PROFILES))
_AXES = click.option(
    "--axes", help="Where our +x (east), +y (north), +z (up) go, instead of the format's: for example x=+x,y=-z,z=+y."
)
_EXPOSURE = click.option(
    "--exposure", type=float, help="Factor on the light, so on every number of the format alike; half floats end at 65504."
)


class BadInputError(Exception):
    """Input that the user can mend; its text says how."""


@click.command()
@click.argument("table", type=click.Path(path_type=Path))
@_AT
@click.option("--sun-zenith", type=float, help="Short for --at sun_zenith=VALUE.")
@_TURBIDITY
@click.option("--sun-azimuth", type=float, help="Radians from +x, east, towards +y, north; 0 if it is not given.")
@_BANDS
@_WINDOW
@click.option("--json", "as_json", is_flag=True, help="Print JSON instead of a table.")
@click.option("--format", "form", type=_FORMATS, help="Print what this engine reads.")
@_AXES
@_EXPOSURE
def evaluate(
    table: Path,
    given: tuple[str, ...],
    sun_zenith: float | None,
    turbidity: float | None,
    sun_azimuth: float | None,
    bands: int | None,
    window: bool,
    as_json: bool,
    form: str | None,
    axes: str | None,
    exposure: float | None,
) -> None:
    """Print the SH weights of one sun from TABLE, an exported .npz, as they are or in an engine's form.

    Example: skylight-sh evaluate reports/reference/export/skylight_sh.npz --sun-zenith 0.8 --turbidity 3
    """
    from skylight_sh import runtime
    from skylight_sh.export import engines

    if form is None and (axes is not None or exposure is not None):
        raise BadInputError("--axes and --exposure change an engine's form. Add --format NAME, or leave them out.")
    loaded = _table(table, form)
    values = _inputs(loaded, given, {"sun_zenith": sun_zenith, "turbidity": turbidity, "sun_azimuth": sun_azimuth})
    try:
        if form:
            bands = engines.bands_for(PROFILES[form], loaded.table.bands, bands)
        weights, status = loaded.weights_and_status(bands=bands, window=window, **values)
        if status == runtime.INVALID:
            raise BadInputError("An input is not a finite number. Give finite values.")
        if status == runtime.CLAMPED:
            _warn(f"an input lies outside the table and was clamped: {_ranges(loaded)}.")
        if form:
            numbers = engines.convert(weights, PROFILES[form], axes=axes, exposure=1.0 if exposure is None else exposure)
            _warn_of_halves(float(abs(numbers).max()))
            made = engines.structure(numbers, PROFILES[form])
            click.echo(json.dumps(made) if as_json else engines.text(numbers, PROFILES[form]))
            return
    except ValueError as error:
        raise BadInputError(str(error)) from error
    show_weights(weights, loaded.table.channels, as_json=as_json)


@click.command()
@click.argument("table", type=click.Path(path_type=Path))
@click.option("--format", "form", type=_FORMATS, required=True, help="The engine that reads the day.")
@click.option("--latitude", type=float, required=True, help="Degrees, north is positive.")
@click.option("--longitude", type=float, required=True, help="Degrees, east is positive.")
@click.option("--date", "day", type=click.DateTime(["%Y-%m-%d"]), required=True, help="The day, in the time zone.")
@click.option("--timezone", default="UTC", show_default=True, help="IANA name, like Europe/Vienna.")
@click.option("--step", type=click.IntRange(1), default=60, show_default=True, help="Minutes between skies.")
@click.option(
    "--night",
    type=click.Choice(["skip", "zero"]),
    default="skip",
    show_default=True,
    help="Leave out the times with the sun below the horizon (with twilight: 12 degrees below it), or write zeros and what "
    "lamps of the scene give.",
)
@_AT
@_TURBIDITY
@_BANDS
@_WINDOW
@_AXES
@_EXPOSURE
@click.option("--output", type=click.Path(path_type=Path), required=True, help="The file to write, .json or .csv.")
def export(
    table: Path,
    form: str,
    latitude: float,
    longitude: float,
    day: datetime,
    timezone: str,
    step: int,
    night: Literal["skip", "zero"],
    given: tuple[str, ...],
    turbidity: float | None,
    bands: int | None,
    window: bool,
    axes: str | None,
    exposure: float | None,
    output: Path,
) -> None:
    """Write a day's skies at a place on Earth from TABLE, an exported .npz, in an engine's form.

    Example: skylight-sh export reports/reference/export/skylight_sh.npz --format unity --latitude 48.2
    --longitude 16.4 --timezone Europe/Vienna --date 2024-06-21 --turbidity 3 --output day.json
    """
    from skylight_sh.export import day as days
    from skylight_sh.export.solar import Place

    if {"sun_zenith", "sun_azimuth"} & set(_assignments(given)):
        raise BadInputError("The date and the place give the sun's position. Leave --at sun_zenith and sun_azimuth out.")
    loaded = _table(table, form)
    here = {"sun_zenith": 0.0, "sun_azimuth": 0.0, "turbidity": turbidity}
    values = _inputs(loaded, given, here)
    others = {name: value for name, value in values.items() if name not in ("sun_zenith", "sun_azimuth")}
    factor = 1.0 if exposure is None else exposure
    try:
        place = Place(latitude, longitude)
        request = days.Request(
            form, place, day.date(), others, timezone, step, bands, window, axes, exposure=factor, night=night
        )
        made = days.tabulate(loaded, request)
        if made.clamped:
            _warn(f"{made.clamped} skies lie outside the table and were clamped: {_ranges(loaded)}.")
        _warn_of_halves(float(abs(made.numbers).max(initial=0.0)))
        days.write(made, output)
    except ValueError as error:
        raise BadInputError(str(error)) from error
    if made.nights:
        fate = "left out" if night == "skip" else "written without a sky"
        depth = "12 degrees below" if loaded.table.twilight else "below"
        click.echo(f"{made.nights} times with the sun {depth} the horizon are {fate}.")
    click.echo(f"{len(made.times)} skies  {output}")


def show_weights(weights: NDArray[np.floating], channels: tuple[str, ...], *, as_json: bool) -> None:
    """Print SH weights ``(channels, N*N)``, a line each, or as JSON with a list a channel."""
    from skylight_sh import sphere

    if as_json:
        click.echo(json.dumps({channel: weights[i].tolist() for i, channel in enumerate(channels)}))
        return
    click.echo(f"{'l':>3}{'m':>4}" + "".join(f"{channel:>16}" for channel in channels))
    degrees, orders = sphere.degrees_orders(sphere.bands_of(weights))
    for k, (l, m) in enumerate(zip(degrees.tolist(), orders.tolist(), strict=True)):
        click.echo(f"{l:>3}{m:>4}" + "".join(f"{weights[i, k]:>16.8g}" for i in range(len(channels))))


def _table(path: Path, form: str | None) -> Runtime:
    """Load a table; what an engine reads is made of radiance weights of a sun that turns."""
    from skylight_sh import runtime

    try:
        loaded = runtime.load(path)
    except ValueError as error:
        raise BadInputError(str(error)) from error
    table = loaded.table
    if form and (table.quantity != "radiance" or table.azimuth is not None):
        about = "irradiance" if table.quantity != "radiance" else "one azimuth of the sun"
        raise BadInputError(f"{path} holds {about} alone, but --format needs radiance for any azimuth. Give such a table.")
    return loaded


def _inputs(loaded: Runtime, given: tuple[str, ...], short: dict[str, float | None]) -> dict[str, float]:
    """Return a value for every input of a table, from ``--at`` and its short forms."""
    values = _assignments(given)
    for name, value in short.items():
        if value is not None and name in values:
            raise BadInputError(f"{name} is given twice. Leave one of --at {name} and --{name.replace('_', '-')}.")
        if value is not None:
            values[name] = value
    if "sun_azimuth" in loaded.inputs:
        values.setdefault("sun_azimuth", 0.0)
    needed = set(loaded.inputs)
    if set(values) != needed:
        missing, unknown = sorted(needed - set(values)), sorted(set(values) - needed)
        told = [f"--at {name}=VALUE is missing" for name in missing] + [
            f"{name} is no axis of this table" for name in unknown
        ]
        raise BadInputError(f"{'; '.join(told)}. The table's inputs are {', '.join(loaded.inputs)}.")
    return values


def _ranges(loaded: Runtime) -> str:
    table = loaded.table
    return ", ".join(f"{a.name} [{low:.6g}, {high:.6g}]" for a, (low, high) in zip(table.axes, table.ranges, strict=True))


def _warn(text: str) -> None:
    click.echo(f"Warning: {text}", err=True)


def _warn_of_halves(largest: float) -> None:
    from skylight_sh.export.engines import HALF_MAX

    if largest > HALF_MAX:
        _warn(
            f"the largest number, {largest:.6g}, is beyond half floats. If yours are halves, multiply --exposure by "
            f"{HALF_MAX / largest:.2g} or less."
        )


def _assignments(given: tuple[str, ...]) -> dict[str, float]:
    values = {}
    for text in given:
        name, separator, value = text.partition("=")
        try:
            values[name] = float(value)
        except ValueError:
            separator = ""
        if sum(other.partition("=")[0] == name for other in given) > 1:
            raise BadInputError(f"--at {name} is given twice. Leave one of them.")
        if not separator:
            raise BadInputError(f"--at {text!r} is no NAME=VALUE with a number. Write for example --at turbidity=3.")
    return values
