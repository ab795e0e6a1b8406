"""``python -m skylight_sh.studies.claims``: measure what the README claims, release a bench's speed, write its blocks."""

from __future__ import annotations

import json
from pathlib import Path

import click

from skylight_sh import shipped
from skylight_sh.store import atomic
from skylight_sh.studies.claims import measured, readme, sources, times
from skylight_sh.studies.speed.speed import FILE

_ROOT = Path(__file__).resolve().parents[4]
_REFERENCE = click.option(
    "--reference",
    type=click.Path(file_okay=False, path_type=Path),
    default=_ROOT / "reports" / "reference",
    help="Folder of the released run.",
)
_PAGES = click.option(
    "--pages", type=click.Path(file_okay=False, path_type=Path), default=_ROOT, help="Folder of the README and of docs/."
)


@click.group()
def main() -> None:
    """Write the README's figures from released files."""


@main.command()
@_REFERENCE
def measure(reference: Path) -> None:
    """Measure gradient, pictures, ringing, valley and daylight into claims.json: a few minutes."""
    found = measured.all_claims(_ROOT, reference)
    atomic.write(reference / "claims.json", (json.dumps(found, indent=2) + "\n").encode())


@main.command()
@click.argument("bench", type=click.Path(file_okay=False, path_type=Path))
@_REFERENCE
def speed(bench: Path, reference: Path) -> None:
    """Release the speed that `make bench` has written into BENCH."""
    try:
        data = (bench / FILE).read_bytes()
    except OSError as error:
        raise click.ClickException(f"{bench / FILE} cannot be read. Run `make bench` first.") from error
    atomic.write(reference / FILE, data)


@main.command()
@_REFERENCE
def code(reference: Path) -> None:
    """Write the recommended table as shaders, JavaScript and C# into the folder code, and a panorama, sky.exr."""
    (reference / "code").mkdir(exist_ok=True)
    for name, data in sources.of(reference).items():
        atomic.write(reference / "code" / name, data)
    atomic.write(reference / "sky.exr", sources.panorama())


@main.command()
@click.argument("names", nargs=-1)
@_REFERENCE
def time(names: tuple[str, ...], reference: Path) -> None:
    """Run NAMES, or all configs that ship, from nothing, and write how long each took: ten minutes."""
    found = times.measure(names or shipped.names())
    atomic.write(reference / times.FILE, (json.dumps(found, indent=2) + "\n").encode())


@main.command()
@_REFERENCE
@_PAGES
def write(reference: Path, pages: Path) -> None:
    """Rewrite the blocks of README.md, docs/guide.md and docs/results.md from summary, claims, speed and times."""
    try:
        found = readme.released(reference)
        for name in readme.PAGES:
            page = pages / name
            atomic.write(page, readme.rewrite(name, page.read_text(encoding="utf-8"), found).encode())
    except (OSError, ValueError) as error:
        raise click.ClickException(str(error)) from error


if __name__ == "__main__":
    main(prog_name="python -m skylight_sh.studies.claims")
