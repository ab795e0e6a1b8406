"""The command ``stability``: the numerics under stress."""

from __future__ import annotations

from pathlib import Path

import click

from skylight_sh.cli import options


@click.command()
@click.argument("config", default=options.DEFAULT)
@options.reports
def stability(config: str, reports: Path) -> None:
    """Stress the numerics of CONFIG, which must have run: bases, solvers, number types, compilers, noise, edges, rounding.

    CONFIG is a path or a shipped config's name, preetham if it is left out.
    """
    from skylight_sh.run import progress
    from skylight_sh.studies.run import run
    from skylight_sh.studies.stability.study import STABILITY

    with progress.bar("stability") as advance:
        text = run(STABILITY, options.load_config(config, {}), reports, advance)
    click.echo(text)
