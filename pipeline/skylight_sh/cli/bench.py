"""The command ``bench``: error against time."""

from __future__ import annotations

from pathlib import Path

import click

from skylight_sh.cli import options


@click.command()
@click.argument("config", default=options.DEFAULT)
@click.option(
    "--repeats",
    type=click.IntRange(3),
    default=7,
    show_default=True,
    help="Rounds a median is taken of, of fits and rules; eight times as many of calls in C.",
)
@options.reports
def bench(config: str, repeats: int, reports: Path) -> None:
    """Measure error against time for CONFIG, which must have run: its tables against their rivals, batches, rules, fits.

    CONFIG is a path or a shipped config's name, preetham if it is left out.
    """
    from skylight_sh.run import progress
    from skylight_sh.studies.run import run
    from skylight_sh.studies.speed.study import SPEED

    with progress.bar("bench") as advance:
        text = run(SPEED, options.load_config(config, {}), reports, advance, repeats)
    click.echo(text)
