"""The command ``init``: a first config of one's own."""

from __future__ import annotations

import re
from pathlib import Path

import click

from skylight_sh import UserError

_STARTER = """\
# {name}: what a run of mine makes. Run it with: skylight-sh run {path}
# It starts from the shipped config "preetham" and says only what differs; `skylight-sh configs` lists others to start
# from, and `skylight-sh config schema` describes every key. Results go to reports/{name}/.
extends = "preetham"
name = "{name}"

# Other ranges, more or less accurate fits: an axis keeps what it does not name here.
# [[axes]]
# name = "turbidity"
# range = [2.0, 8.0]

# What the scene needs, folded into the weights: diffuse irradiance instead of radiance, a ground lit by the sky, twilight.
# [scene]
# quantity = "irradiance"
# ground = [0.2, 0.2, 0.2]
# twilight = true

# The tables to make: the fewest bytes within each largest error (a fraction), laid out for speed or packed.
[[winners]]
bands = 4
budgets = [0.01]
layouts = ["rows", "packed"]

[export]
recommended = "4-bands-1pct"
targets = ["c", "npz"] # also: glsl, hlsl, wgsl, javascript, csharp, vectors
"""


@click.command()
@click.argument("path", type=click.Path(path_type=Path))
def init(path: Path) -> None:
    """Write a commented config to start from at PATH, a .toml file that does not exist yet.

    Example: skylight-sh init my.toml
    """
    name = re.sub(r"[^a-z0-9_-]+", "-", path.stem.lower()).strip("-_")[:40]
    if path.suffix != ".toml" or not name:
        raise UserError(f"{str(path)!r} is no name of a config. Give one that ends in .toml, such as my.toml.")
    try:
        with path.open("x", encoding="utf-8") as file:
            file.write(_STARTER.format(name=name, path=path))
    except FileExistsError as error:
        raise UserError(f"{path} exists and is left as it is. Give another name.") from error
    except OSError as error:
        raise UserError(f"{path} cannot be written ({error.strerror}). Give a path in a folder that is there.") from error
    click.echo(f"{path}  next: skylight-sh run {path}")
