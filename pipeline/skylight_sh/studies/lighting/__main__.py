"""``python -m skylight_sh.studies.lighting``: what the tables of configs really lose of the light on surfaces."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import click

from skylight_sh import shipped
from skylight_sh.config import Config, load
from skylight_sh.run import progress
from skylight_sh.run.runner import run
from skylight_sh.store.store import Store
from skylight_sh.studies import page
from skylight_sh.studies.lighting import study

Run = tuple[Config, Path]
_EVERY, _DEFAULT = "lighting", "preetham"
_LEAD = (
    "E_mean and E_max bound what any surface can lose by a table's error. Here is what surfaces do lose, on parameter sets "
    "that neither fit nor selection saw, and beside it what the number of bands alone loses. Fractions, not per cent."
)


@click.command()
@click.argument("configs", nargs=-1)
@click.option("--all", "every", is_flag=True, help="All shipped configs, on one page under reports/lighting/.")
@click.option("--store", type=click.Path(file_okay=False, path_type=Path), default=Path("artifacts"), show_default=True)
@click.option("--reports", type=click.Path(file_okay=False, path_type=Path), default=Path("reports"), show_default=True)
def main(configs: tuple[str, ...], every: bool, store: Path, reports: Path) -> None:
    """Measure CONFIGS, paths or shipped names, preetham if left out; each runs first where it has not.

    Without --all every config gets a page of its own under reports/NAME/lighting/.
    """
    names = shipped.names() if every else list(configs) or [_DEFAULT]
    runs = [_run(name, store, reports) for name in names]
    pages = [(reports / _EVERY, "The true lighting error", runs)] if every else [_page(one) for one in runs]
    for folder, title, shown in pages:
        with progress.bar("lighting") as advance:
            click.echo(page.publish(folder, title, _LEAD, [partial(study.section, shown, advance)], _quiet))


def _run(name: str, store: Path, reports: Path) -> Run:
    config = load(shipped.find(name))
    return config, run(config, Store(store), reports, lambda text: click.echo(f"Warning: {text}", err=True)).folder


def _page(one: Run) -> tuple[Path, str, list[Run]]:
    config, folder = one
    return folder / "lighting", f"The true lighting error of {config.name}", [one]


def _quiet(_: int, __: int) -> None:
    """Tell nobody: the section tells of progress itself."""


if __name__ == "__main__":
    main(prog_name="python -m skylight_sh.studies.lighting")
