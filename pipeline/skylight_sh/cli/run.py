"""The command ``run``: a config's stages, from sampling to the report."""

from __future__ import annotations

from pathlib import Path

import click

from skylight_sh.cli import options, warn


@click.command()
@click.argument("config")
@click.option("--executor", help="threads, processes, or a Dask scheduler's address; overrides run.executor.")
@click.option("--workers", type=click.IntRange(0), help="Threads or processes, 0 for one a core; overrides run.workers.")
@options.store
@options.reports
def run(config: str, executor: str | None, workers: int | None, store: Path, reports: Path) -> None:
    """Run every stage of CONFIG that is not cached, and publish reports/NAME/.

    CONFIG is the path of a TOML file, or the name of a config that comes with the package (`skylight-sh configs`).

    Stages: truth (sample the light), fit (and sweep the degrees), select (the winners), export (C and NPZ), report.

    Example: skylight-sh run preetham
    """
    from skylight_sh.run.runner import run as run_config
    from skylight_sh.store.store import Store

    loaded = options.load_config(config, {"executor": executor, "workers": workers})
    result = run_config(loaded, Store(store), reports, warn)
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


def _percent(fraction: float) -> str:
    return f"{100 * fraction:>10.4g} %"
