"""What several commands take: the config, the store and the folder of reports."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from skylight_sh.config import Config

DEFAULT = "preetham"

store = click.option(
    "--store",
    type=click.Path(file_okay=False, path_type=Path),
    default=Path("artifacts"),
    show_default=True,
    help="Folder of the artifact store.",
)
reports = click.option(
    "--reports",
    type=click.Path(file_okay=False, path_type=Path),
    default=Path("reports"),
    show_default=True,
    help="Folder that reports are published under.",
)


def load_config(name: str, overrides: dict[str, Any]) -> Config:
    """Load the config at the path ``name``, or the shipped one of that name; ``overrides`` are keys of [run], or None.

    Raises ConfigError where it cannot be run.
    """
    from skylight_sh import shipped
    from skylight_sh.config import load

    return load(shipped.find(name), {key: value for key, value in overrides.items() if value is not None})
