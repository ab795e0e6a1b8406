"""The command ``export``: a day of skies at a place on Earth, in an engine's form."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path
from typing import Literal

import click

from skylight_sh import UserError
from skylight_sh.cli import evaluate as asked
from skylight_sh.cli import warn


@click.command()
@click.argument("table", type=click.Path(path_type=Path))
@click.option("--format", "form", type=asked.FORMATS, required=True, help="The engine that reads the day.")
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
@asked.AT
@asked.TURBIDITY
@asked.BANDS
@asked.WINDOW
@asked.AXES
@asked.EXPOSURE
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

    Example: skylight-sh export reports/preetham/export/skylight_sh.npz --format unity --latitude 48.2
    --longitude 16.4 --timezone Europe/Vienna --date 2024-06-21 --turbidity 3 --output day.json
    """
    from skylight_sh.export import day as days
    from skylight_sh.scene.solar import Place

    loaded = asked.read_table(table, form)
    if loaded.table.spec.peak_axis is None:
        raise UserError(f"{table} has no sun that moves: its inputs are {', '.join(loaded.inputs)}. Use `evaluate`.")
    sun = (loaded.table.spec.peak_axis, "sun_azimuth")
    if set(sun) & set(asked.assignments(given)):
        raise UserError(f"The date and the place give the sun's position. Leave --at {sun[0]} and sun_azimuth out.")
    values = asked.inputs_of(loaded, given, {**dict.fromkeys(sun, 0.0), "turbidity": turbidity})
    others = {name: value for name, value in values.items() if name not in sun}
    factor = 1.0 if exposure is None else exposure
    try:
        place = Place(latitude, longitude)
        request = days.Request(
            form, place, day.date(), others, timezone, step, bands, window, axes, exposure=factor, night=night
        )
        made = days.tabulate(loaded, request)
        if made.clamped:
            warn(f"{made.clamped} skies lie outside the table and were clamped: {asked.ranges(loaded)}.")
        asked.warn_of_halves(float(abs(made.numbers).max(initial=0.0)))
        days.write(made, output)
    except ValueError as error:
        raise UserError(str(error)) from error
    if made.nights:
        fate = "left out" if night == "skip" else "written without a sky"
        depth = "12 degrees below" if loaded.table.spec.twilight else "below"
        click.echo(f"{made.nights} times with the sun {depth} the horizon are {fate}.")
    click.echo(f"{len(made.times)} skies  {output}")
