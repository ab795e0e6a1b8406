"""The command ``configs``: what comes with the package."""

from __future__ import annotations

import click

from skylight_sh import shipped


@click.command()
def configs() -> None:
    """List the configs that come with the package, one line each.

    `skylight-sh run NAME` runs one; `extends = "NAME"` in a config of your own starts from it.
    """
    names = shipped.names()
    width = max(map(len, names))
    for name in names:
        click.echo(f"{name:<{width}}  {shipped.summary(name)}")
