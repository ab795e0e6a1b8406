"""The command line: ``skylight-sh``. Commands, nothing else."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from skylight_sh import __version__
from skylight_sh.cli.project import project
from skylight_sh.cli.tables import BadInputError, evaluate, export
from skylight_sh.cli.verify import verify

if TYPE_CHECKING:
    from skylight_sh.config import Config

_STORE = click.option(
    "--store",
    type=click.Path(file_okay=False, path_type=Path),
    default=Path("artifacts"),
    show_default=True,
    help="Folder of the artifact store.",
)
_REPORTS = click.option(
    "--reports",
    type=click.Path(file_okay=False, path_type=Path),
    default=Path("reports"),
    show_default=True,
    help="Folder that reports are published under.",
)


class _Group(click.Group):
    """Turns bad input into exit code 2 with one message, and known failures into exit code 1 without a traceback."""

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except BrokenPipeError:
            # Whoever read the output has seen enough.
            sys.stdout = None
            ctx.exit(0)
        except (BadInputError, OSError) as error:
            click.echo(f"Error: {error}", err=True)
            ctx.exit(2 if isinstance(error, BadInputError) else 1)
        except (RuntimeError, ValueError) as error:
            from skylight_sh.light import LightError, MissingExtraError
            from skylight_sh.run.executors import WorkerError

            if not isinstance(error, LightError | MissingExtraError | WorkerError):
                raise
            click.echo(f"Error: {error}", err=True)
            ctx.exit(1 if isinstance(error, WorkerError) else 2)


@click.group(cls=_Group)
@click.version_option(__version__, prog_name="skylight-sh")
def main() -> None:
    """Turn a light on the sphere into tiny polynomial tables of its spherical-harmonics weights.

    Start with `skylight-sh run configs/preetham.toml`, then open reports/preetham/index.html.

    Exit codes: 0 success, 2 bad input (the message names the field and the remedy), 1 any other failure.
    """


@main.command()
@click.argument("config", type=click.Path(path_type=Path))
@click.option("--executor", help="threads, processes, or a Dask scheduler's address; overrides run.executor.")
@click.option("--workers", type=click.IntRange(0), help="Threads or processes, 0 for one a core; overrides run.workers.")
@_STORE
@_REPORTS
def run(config: Path, executor: str | None, workers: int | None, store: Path, reports: Path) -> None:
    """Run every stage of CONFIG (a TOML file) that is not cached, and publish reports/NAME/.

    Stages: truth (sample the light), fit (and sweep the degrees), select (the winners), export (C and NPZ), report.
    """
    from skylight_sh.quadrature.samples import NotConvergedError
    from skylight_sh.run.runner import run as run_config
    from skylight_sh.run.stages.select import BudgetError
    from skylight_sh.store.store import Store

    loaded = _load(config, {"executor": executor, "workers": workers})
    try:
        result = run_config(loaded, Store(store), reports, lambda text: click.echo(f"Warning: {text}", err=True))
    except (BudgetError, NotConvergedError) as error:
        raise BadInputError(str(error)) from error
    for stage, facts in result.stages.items():
        click.echo(f"{stage:<8} {facts['seconds']:7.2f} s{'  cached' if facts['cached'] else ''}")
    click.echo()
    click.echo(f"{'table':<24}{'bytes':>8}{'E_mean':>12}{'E_max':>12}")
    for row in result.summary["tables"]:
        mark = "  recommended" if row["name"] == result.summary["recommended"] else ""
        click.echo(f"{row['name']:<24}{row['bytes']:>8}{_percent(row['e_mean'])}{_percent(row['e_max'])}{mark}")
    click.echo()
    click.echo(f"report  {result.folder / 'index.html'}")
    click.echo(f"C       {result.folder / 'export' / 'skylight_sh.h'}")
    click.echo(f"NPZ     {result.folder / 'export' / 'skylight_sh.npz'}")


main.add_command(evaluate)
main.add_command(export)
main.add_command(project)
main.add_command(verify)


@main.group()
def artifacts() -> None:
    """List, show, verify and clean the artifact store."""


@artifacts.command("ls")
@_STORE
def list_artifacts(store: Path) -> None:
    """List every artifact: stage, key, size."""
    from skylight_sh.store.store import Store

    for entry in Store(store).entries():
        click.echo(f"{entry.stage:<8} {entry.key} {entry.size:>10}")


@artifacts.command()
@click.argument("key")
@_STORE
def show(key: str, store: Path) -> None:
    """Show what the artifact holds whose key starts with KEY."""
    from skylight_sh.store.hdf5 import CorruptArtifactError
    from skylight_sh.store.store import Store

    try:
        entry = Store(store).find(key)
    except KeyError as error:
        raise BadInputError(error.args[0]) from error
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
@_STORE
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
@_STORE
def gc(store: Path) -> None:
    """Delete artifacts that no run's last result uses, and temporary files an hour old."""
    from skylight_sh.store.store import Store

    freed = 0
    for entry in Store(store).collect():
        freed += entry.size
        click.echo(f"deleted {entry.stage} {entry.key}")
    click.echo(f"freed {freed} bytes")


@main.group("config")
def config_group() -> None:
    """Describe and check configs."""


@config_group.command()
def schema() -> None:
    """Print the JSON Schema of a config."""
    from skylight_sh.config import Config

    click.echo(json.dumps(Config.model_json_schema(), indent=2))


@config_group.command()
@click.argument("config", type=click.Path(path_type=Path))
def check(config: Path) -> None:
    """Check CONFIG without running anything."""
    click.echo(f"{config} holds: run {_load(config, {}).name!r}.")


@main.command()
@click.argument("config", type=click.Path(path_type=Path), default=Path("configs/preetham.toml"))
@click.option("--repeats", type=click.IntRange(3), default=7, show_default=True, help="Runs a median is taken of.")
@_REPORTS
def bench(config: Path, repeats: int, reports: Path) -> None:
    """Measure error against time for CONFIG, which must have run: truth rules, fits, evaluation, growth of cost."""
    from skylight_sh.run import progress
    from skylight_sh.studies.speed import run as benchmarks

    with progress.bar("bench") as advance:
        text = benchmarks.run(_load(config, {}), reports, repeats, advance)
    click.echo(text)


@main.command()
@click.argument("config", type=click.Path(path_type=Path), default=Path("configs/preetham.toml"))
@_REPORTS
def stability(config: Path, reports: Path) -> None:
    """Stress the numerics of CONFIG, which must have run: bases, solvers, number types, compilers, noise, edges."""
    from skylight_sh.run import progress
    from skylight_sh.studies.stability import run as stresses

    with progress.bar("stability") as advance:
        text = stresses.run(_load(config, {}), reports, advance)
    click.echo(text)


def _load(path: Path, overrides: dict[str, Any]) -> Config:
    from skylight_sh.config import ConfigError, load

    try:
        return load(path, {key: value for key, value in overrides.items() if value is not None})
    except ConfigError as error:
        raise BadInputError(str(error)) from error


def _percent(fraction: float) -> str:
    return f"{100 * fraction:>10.4g} %"
