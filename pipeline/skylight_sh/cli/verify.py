"""The command ``verify``, which tells whether this machine computes the same bytes as a release."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from skylight_sh import UserError
from skylight_sh.cli import options, warn


@click.command()
@click.argument("result", type=click.Path(file_okay=False, path_type=Path), default=Path("reports/reference"))
@click.option(
    "--config",
    help="Run this config, a path or a shipped one's name, instead of the one that the result's summary.json tells.",
)
@click.option(
    "--store",
    type=click.Path(file_okay=False, path_type=Path),
    help="Use artifacts that this store holds; without it, all is computed anew and thrown away.",
)
def verify(result: Path, config: str | None, store: Path | None) -> None:
    """Run the config of RESULT again and compare every file of its SHA256SUMS with what came out.

    RESULT is a folder with SHA256SUMS and summary.json, reports/reference by default. A line a file: same, or how much
    differs in what. Exit code 0 where all are the same, 1 where any differs.
    """
    from skylight_sh.run import verify as verification
    from skylight_sh.store.store import Store

    try:
        given = options.load_config(config, {}) if config else None
        chosen = Store(store) if store else None
        found = list(verification.verify(result, given, chosen, warn))
    except ValueError as error:
        raise UserError(str(error)) from error
    for verdict in found:
        told = f": {verdict.difference}" if verdict.difference else ""
        click.echo(f"{'same' if verdict.same else 'DIFFERS':<8} {verdict.path}{told}")
    wrong = sum(not verdict.same for verdict in found)
    click.echo(f"{len(found) - wrong} of {len(found)} files are the same bytes.")
    if wrong:
        sys.exit(1)
