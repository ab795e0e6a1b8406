"""The commands ``artifacts ls | show | verify | gc``, which look after the store."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from skylight_sh import UserError
from skylight_sh.cli import options


@click.group()
def artifacts() -> None:
    """List, show, verify and clean the artifact store."""


@artifacts.command("ls")
@options.store
def list_artifacts(store: Path) -> None:
    """List every artifact: stage, key, size; and those that a stopped run left unfinished."""
    from skylight_sh.store.store import Store

    for entry in Store(store).entries():
        click.echo(f"{entry.stage:<8} {entry.key} {entry.size:>10}")
    for entry, count in Store(store).unfinished():
        click.echo(f"{entry.stage:<8} {entry.key} {entry.size:>10} unfinished, {count} blocks")


@artifacts.command()
@click.argument("key")
@options.store
def show(key: str, store: Path) -> None:
    """Show what the artifact holds whose key starts with KEY.

    Example: skylight-sh artifacts show 3f2a
    """
    from skylight_sh.store.hdf5 import CorruptArtifactError
    from skylight_sh.store.store import Store

    try:
        entry = Store(store).find(key)
    except KeyError as error:
        raise UserError(error.args[0]) from error
    try:
        dataset = Store(store).get(entry.stage, entry.key)
    except CorruptArtifactError as error:
        raise OSError(str(error)) from error
    click.echo(f"{entry.path} ({entry.size} bytes)")
    for name in sorted(dataset.variables):
        variable = dataset.variables[name]
        shape = ", ".join(f"{d}: {n}" for d, n in zip(variable.dims, variable.data.shape, strict=False))
        click.echo(f"  {name} ({shape}) {variable.data.dtype} {variable.attrs.get('units', '')}".rstrip())
    for name in sorted(dataset.attrs):
        click.echo(f"  @{name} = {dataset.attrs[name]}")


@artifacts.command("verify")
@options.store
def verify_artifacts(store: Path) -> None:
    """Check every artifact's checksum, and that it is what its name says; exit 1 where one fails."""
    from skylight_sh.store.hdf5 import CorruptArtifactError
    from skylight_sh.store.store import Store

    failures = 0
    entries = Store(store).entries()
    for entry in entries:
        try:
            Store(store).get(entry.stage, entry.key)
        except CorruptArtifactError as error:
            failures += 1
            click.echo(str(error), err=True)
    click.echo(f"{len(entries) - failures} of {len(entries)} artifacts hold.")
    if failures:
        sys.exit(1)


@artifacts.command()
@options.store
def gc(store: Path) -> None:
    """Delete artifacts that no run's last result uses, and blocks and temporary files an hour old."""
    from skylight_sh.store.store import Store

    freed = 0
    for entry in Store(store).collect():
        freed += entry.size
        click.echo(f"deleted {entry.stage} {entry.key}")
    click.echo(f"freed {freed} bytes")
