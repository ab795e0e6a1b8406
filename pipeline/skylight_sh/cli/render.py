"""The command ``render``: pictures of a config's mesh under its light."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from skylight_sh.cli import options, warn

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from skylight_sh.config.schema import Config
    from skylight_sh.config.views_schema import ViewSection


@click.command(
    epilog="""\b
Examples:
  skylight-sh render courtyard                              its first view: morning.png
  skylight-sh render courtyard --sun 12,-15 --turbidity 4   another sun, in hazier air
  skylight-sh render courtyard --slices 8 --output day.png  a day in one picture
  skylight-sh render courtyard --brute-force --output truth.exr
  skylight-sh render courtyard --time 2026-06-21T20:30 --place 48.2,16.4 \\
    --timezone Europe/Vienna"""
)
@click.argument("config")
@click.option("--view", "name", help="Name of a [[views]] table of the config; the first one if it is not given.")
@click.option("--output", type=click.Path(dir_okay=False, path_type=Path), help="File to write, .png or .exr; VIEW.png.")
@click.option("--brute-force", is_flag=True, help="By path tracing, without table and transfer.")
@click.option("--paths", type=click.IntRange(1), default=16, show_default=True, help="Paths from each point of a pixel.")
@click.option("--samples", type=click.IntRange(1, 1024), help="Points looked at in each pixel.")
@click.option("--size", metavar="WxH", help="Pixels, like 1200x675.")
@click.option("--sun", metavar="HEIGHT,AZIMUTH", help="Degrees: above the horizon, and from east towards north.")
@click.option("--time", metavar="ISO", help="Instead of --sun a moment, like 2026-06-21T18:30; local without an offset.")
@click.option("--place", metavar="LATITUDE,LONGITUDE", help="Degrees, north and east positive.")
@click.option("--timezone", help="IANA name of the clock's zone, like Europe/Vienna.")
@click.option("--turbidity", type=float, help="Short for --at turbidity=VALUE.")
@click.option("--at", "given", multiple=True, metavar="NAME=VALUE", help="A parameter of the light beside its sun.")
@click.option("--table", help="Name of a table of the config, or path of an exported .npz; else the recommended one.")
@click.option("--bands", type=click.IntRange(1, 20), help="Fewer SH bands of the light than the table has.")
@click.option("--bounces", type=click.IntRange(0, 20), help="How often surfaces send light on; overrides scene.mesh.")
@click.option("--no-sun", is_flag=True, help="Leave the sun's disc out.")
@click.option("--unshadowed", is_flag=True, help="Surfaces see nothing of each other: no shadows, no bounces.")
@click.option("--exposure", type=click.FloatRange(-20.0, 20.0), help="Stops brighter than by the scene's light.")
@click.option("--slices", type=click.IntRange(2, 24), help="One picture of so many strips, from sunrise to sunset.")
@click.option("--frames", type=click.IntRange(1, 10_000), help="So many pictures of the day: OUTPUT-0001.png and on.")
@click.option("--workers", type=click.IntRange(0), default=0, help="Threads, 0 for one a core.")
@options.store
def render(
    config: str,
    name: str | None,
    output: Path | None,
    brute_force: bool,
    paths: int,
    samples: int | None,
    size: str | None,
    sun: str | None,
    time: str | None,
    place: str | None,
    timezone: str | None,
    turbidity: float | None,
    given: tuple[str, ...],
    table: str | None,
    bands: int | None,
    bounces: int | None,
    no_sun: bool,
    unshadowed: bool,
    exposure: float | None,
    slices: int | None,
    frames: int | None,
    workers: int,
    store: Path,
) -> None:
    """Render a view of CONFIG: its mesh, lit by one of its tables through precomputed transfer.

    The sun's disc and lamps shine by shadow rays, and on by as many bounces as the sky's light. What the store lacks is
    computed first: the table (seconds) and the mesh's transfer (about 10 s for 20,000 vertices), once.
    """
    from skylight_sh import UserError
    from skylight_sh.cli.evaluate import assignments
    from skylight_sh.render import files
    from skylight_sh.run.pictures import Asked, frames_of, picture_of, slices_of

    loaded = options.load_config(config, {"workers": workers or None})
    if not loaded.views:
        raise UserError(f"{loaded.name} has no [[views]]. Add one to the config, or render courtyard, which has some.")
    if slices and frames:
        raise UserError("--slices and --frames are two pictures of a day. Give one of them.")
    if brute_force and unshadowed:
        raise UserError("--brute-force has shadows. Give it without --unshadowed.")
    view = _view(loaded, name)
    at = {**view.at, **assignments(given), **({} if turbidity is None else {"turbidity": turbidity})}
    changed = {
        "sun": _sun(view, sun, time, place, timezone),
        "at": at,
        "bands": bands,
        "samples": samples,
        "exposure": exposure,
        "disc": False if no_sun else None,
        **_size(size),
    }
    asked = _with(loaded, view, {key: value for key, value in changed.items() if value is not None})
    target = output or Path(f"{view.name}.png")
    files.check(target)
    if not target.absolute().parent.is_dir():
        raise UserError(f"Invalid --output {target}. Its folder is not there; make it first.")
    how = Asked(
        table=table or view.table or loaded.export.recommended,
        bounces=bounces,
        paths=paths if brute_force else 0,
        unshadowed=unshadowed,
    )
    if slices:
        _written(target, *slices_of(loaded, asked, how, store, slices, warn))
    elif frames:
        for k, made in enumerate(frames_of(loaded, asked, how, store, frames, warn)):
            _written(target.with_stem(f"{target.stem}-{k + 1:04d}"), *made)
    else:
        _written(target, *picture_of(loaded, asked, how, store, warn))


def _written(path: Path, radiance: NDArray[np.floating], srgb: NDArray[np.floating], told: str) -> None:
    from skylight_sh.render import files
    from skylight_sh.store import atomic

    atomic.write(path, files.encoded(path, radiance, srgb))
    click.echo(f"{path}: {srgb.shape[1]}x{srgb.shape[0]}, {told}")


def _view(config: Config, name: str | None) -> ViewSection:
    from skylight_sh import UserError

    found = [view for view in config.views if name in (None, view.name)]
    if not found:
        known = ", ".join(view.name for view in config.views)
        raise UserError(f"{config.name} has no view {name!r}. Give --view with one of: {known}.")
    return found[0]


def _with(config: Config, view: ViewSection, changed: dict[str, Any]) -> ViewSection:
    """Return the view with what the command line changed, checked like the config's own."""
    from pydantic import ValidationError

    from skylight_sh.config import schema_errors, views_validation
    from skylight_sh.config.problem import refusal
    from skylight_sh.config.views_schema import ViewSection

    raw = {**view.model_dump(mode="json"), **changed}
    try:
        asked = ViewSection.model_validate_json(_json(raw))
    except ValidationError as error:
        raise refusal("The view asked for", schema_errors.problems(error, raw)) from error
    found = list(views_validation.find(config.model_copy(update={"views": (asked,)})))
    if found:
        raise refusal("The view asked for", found)
    return asked


def _json(raw: dict[str, Any]) -> str:
    import json

    return json.dumps(raw)


def _sun(
    view: ViewSection, angles: str | None, time: str | None, place: str | None, timezone: str | None
) -> dict[str, Any] | None:
    """Return the sun asked for, or nothing where it is the view's own."""
    from skylight_sh import UserError

    if angles is not None:
        if time or place:
            raise UserError("--sun, and --time with --place, both say where the sun stands. Give one of them.")
        height, azimuth = _pair("--sun", angles, "12,-15")
        return {"height": height, "azimuth": azimuth}
    own = view.sun.model_dump(mode="json", exclude_none=True)
    changed: dict[str, Any] = {}
    if place is not None:
        changed["latitude"], changed["longitude"] = _pair("--place", place, "48.2,16.4")
    if time is not None:
        changed["time"] = time
    if timezone is not None:
        changed["timezone"] = timezone
    if not changed:
        return None
    return {key: value for key, value in {**own, **changed}.items() if key not in ("height", "azimuth")}


def _pair(option: str, text: str, example: str) -> tuple[float, float]:
    from skylight_sh import UserError

    try:
        one, other = (float(part) for part in text.split(","))
    except ValueError as error:
        raise UserError(f"Invalid {option} {text!r}. Should be two numbers, like {example}.") from error
    return one, other


def _size(text: str | None) -> dict[str, int]:
    from skylight_sh import UserError

    if text is None:
        return {}
    try:
        width, height = (int(part) for part in text.lower().split("x"))
    except ValueError as error:
        raise UserError(f"Invalid --size {text!r}. Should be width x height in pixels, like 1200x675.") from error
    return {"width": width, "height": height}
