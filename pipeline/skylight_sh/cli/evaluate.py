"""The command ``evaluate``: one sky of an exported table; and what ``export``, a day of them, asks in the same way."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING

import click

from skylight_sh import UserError
from skylight_sh.cli import warn
from skylight_sh.export.engine_profiles import PROFILES

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from skylight_sh.runtime import Runtime

AT = click.option(
    "--at", "given", multiple=True, metavar="NAME=VALUE", help="Value of one axis; angles in radians. Repeat for each axis."
)
TURBIDITY = click.option("--turbidity", type=float, help="Short for --at turbidity=VALUE.")
BANDS = click.option("--bands", type=click.IntRange(1), help="Fewer bands than the table has.")
WINDOW = click.option("--window", is_flag=True, help="Apply the zonal window of the paper's eq. 5.")
FORMATS = click.Choice(list(PROFILES))
AXES = click.option(
    "--axes", help="Where our +x (east), +y (north), +z (up) go, instead of the format's: for example x=+x,y=-z,z=+y."
)
EXPOSURE = click.option(
    "--exposure", type=float, help="Factor on the light, so on every number of the format alike; half floats end at 65504."
)


@click.command()
@click.argument("table", type=click.Path(path_type=Path))
@AT
@click.option("--sun-zenith", type=float, help="Short for --at sun_zenith=VALUE.")
@TURBIDITY
@click.option("--sun-azimuth", type=float, help="Radians from +x, east, towards +y, north; 0 if it is not given.")
@BANDS
@WINDOW
@click.option("--json", "as_json", is_flag=True, help="Print JSON instead of a table.")
@click.option("--format", "form", type=FORMATS, help="Print what this engine reads.")
@AXES
@EXPOSURE
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

    Example: skylight-sh evaluate reports/preetham/export/skylight_sh.npz --sun-zenith 0.8 --turbidity 3
    """
    from skylight_sh import runtime
    from skylight_sh.export import engines

    if form is None and (axes is not None or exposure is not None):
        raise UserError("--axes and --exposure change an engine's form. Add --format NAME, or leave them out.")
    loaded = read_table(table, form)
    values = inputs_of(loaded, given, {"sun_zenith": sun_zenith, "turbidity": turbidity, "sun_azimuth": sun_azimuth})
    try:
        if form:
            bands = engines.bands_for(PROFILES[form], loaded.table.bands, bands)
        weights, status = loaded.weights_and_status(bands=bands, window=window, **values)
        if status == runtime.INVALID:
            wrong = ", ".join(f"{name} = {value}" for name, value in values.items() if not math.isfinite(value))
            raise UserError(f"An input is not a finite number: {wrong}. Give finite values.")
        if status == runtime.CLAMPED:
            limits = dict(zip((a.name for a in loaded.table.axes), loaded.table.ranges, strict=True))
            outside = [f"{n} = {values[n]:g}" for n, (low, high) in limits.items() if not low <= values[n] <= high]
            warn(f"{', '.join(outside)} lies outside the table, {ranges(loaded)}, and was clamped.")
        if form:
            numbers = engines.convert(weights, PROFILES[form], axes=axes, exposure=1.0 if exposure is None else exposure)
            warn_of_halves(float(abs(numbers).max()))
            made = engines.structure(numbers, PROFILES[form])
            click.echo(json.dumps(made) if as_json else engines.text(numbers, PROFILES[form]))
            return
    except ValueError as error:
        raise UserError(str(error)) from error
    show_weights(weights, loaded.table.channels, as_json=as_json)


def show_weights(weights: NDArray[np.floating], channels: tuple[str, ...], *, as_json: bool) -> None:
    """Print SH weights ``(channels, N*N)``, a line each, or as JSON with a list a channel."""
    from skylight_sh import sphere

    if as_json:
        click.echo(json.dumps({channel: weights[i].tolist() for i, channel in enumerate(channels)}))
        return
    click.echo(f"{'l':>3}{'m':>4}" + "".join(f"{channel:>16}" for channel in channels))
    every = sphere.Harmonics(sphere.bands_of(weights))
    for k, (l, m) in enumerate(zip(every.degrees.tolist(), every.orders.tolist(), strict=True)):
        click.echo(f"{l:>3}{m:>4}" + "".join(f"{weights[i, k]:>16.8g}" for i in range(len(channels))))


def read_table(path: Path, form: str | None) -> Runtime:
    """Load a table; what an engine reads is made of radiance weights of a sun that turns."""
    from skylight_sh import runtime

    try:
        loaded = runtime.load(path)
    except ValueError as error:
        raise UserError(str(error)) from error
    table = loaded.table
    if form and (table.spec.quantity != "radiance" or table.spec.azimuth is not None):
        about = "irradiance" if table.spec.quantity != "radiance" else "one azimuth of the sun"
        raise UserError(f"{path} holds {about} alone, but --format needs radiance for any azimuth. Give such a table.")
    return loaded


def inputs_of(loaded: Runtime, given: tuple[str, ...], short: dict[str, float | None]) -> dict[str, float]:
    """Return a value for every input of a table, from ``--at`` and its short forms."""
    values = assignments(given)
    for name, value in short.items():
        if value is not None and name in values:
            raise UserError(f"{name} is given twice. Leave one of --at {name} and --{name.replace('_', '-')}.")
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
        raise UserError(f"{'; '.join(told)}. The table's inputs are {', '.join(loaded.inputs)}.")
    return values


def ranges(loaded: Runtime) -> str:
    """Say what each axis of a table ranges over."""
    table = loaded.table
    return ", ".join(f"{a.name} [{low:.6g}, {high:.6g}]" for a, (low, high) in zip(table.axes, table.ranges, strict=True))


def warn_of_halves(largest: float) -> None:
    """Warn where the largest number of an engine's form does not fit half floats."""
    from skylight_sh.export.engines import HALF_MAX

    if largest > HALF_MAX:
        warn(
            f"the largest number, {largest:.6g}, is beyond half floats. If yours are halves, multiply --exposure by "
            f"{HALF_MAX / largest:.2g} or less."
        )


def assignments(given: tuple[str, ...]) -> dict[str, float]:
    """Read the values of ``--at NAME=VALUE``. Raises UserError where one is none, or is given twice."""
    values = {}
    for text in given:
        name, separator, value = text.partition("=")
        try:
            values[name] = float(value)
        except ValueError:
            separator = ""
        if sum(other.partition("=")[0] == name for other in given) > 1:
            raise UserError(f"--at {name} is given twice. Leave one of them.")
        if not separator:
            raise UserError(f"--at {text!r} is no NAME=VALUE with a number. Write for example --at turbidity=3.")
    return values
