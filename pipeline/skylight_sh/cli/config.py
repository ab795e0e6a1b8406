"""The commands ``config schema | check``."""

from __future__ import annotations

import json

import click

from skylight_sh.cli import options


@click.group()
def config() -> None:
    """Describe and check configs."""


@config.command()
def schema() -> None:
    """Print the JSON Schema of a config."""
    from skylight_sh.config import Config

    click.echo(json.dumps(Config.model_json_schema(), indent=2))


@config.command()
@click.argument("config")
def check(config: str) -> None:
    """Check CONFIG, a path or a shipped config's name, without running anything."""
    from skylight_sh.run import scene_problems

    loaded = options.load_config(config, {})
    scene_problems.check(loaded)
    click.echo(f"{config} holds: run {loaded.name!r}.")
