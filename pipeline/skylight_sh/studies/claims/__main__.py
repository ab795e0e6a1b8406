"""``python -m skylight_sh.studies.claims``: measure what the README claims, release a bench's speed, write its blocks."""

from __future__ import annotations

import json
from pathlib import Path

import click

from skylight_sh.store import atomic
from skylight_sh.studies.claims import measured, readme, sources
from skylight_sh.studies.speed.speed import FILE

_ROOT = Path(__file__).resolve().parents[4]
_REFERENCE = click.option(
    "--reference",
    type=click.Path(file_okay=False, path_type=Path),
    default=_ROOT / "reports" / "reference",
    help="Folder of the released run.",
)
_README = click.option(
    "--readme", "page", type=click.Path(dir_okay=False, path_type=Path), default=_ROOT / "README.md", help="The README."
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
    """Write the recommended table as shaders, JavaScript and C# into the folder code."""
    (reference / "code").mkdir(exist_ok=True)
    for name, data in sources.of(reference).items():
        atomic.write(reference / "code" / name, data)


@main.command()
@_REFERENCE
@_README
def write(reference: Path, page: Path) -> None:
    """Rewrite the README's blocks from summary.json, claims.json and speed.json."""
    try:
        text = readme.rewrite(page.read_text(encoding="utf-8"), readme.released(reference))
    except (OSError, ValueError) as error:
        raise click.ClickException(str(error)) from error
    atomic.write(page, text.encode())


if __name__ == "__main__":
    main(prog_name="python -m skylight_sh.studies.claims")
