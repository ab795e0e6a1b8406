"""The command ``transfer``: what the vertices of a mesh make of the light around it."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import click

from skylight_sh.cli import options, warn


@click.command()
@click.argument("mesh")
@click.option("--bands", type=click.IntRange(1, 20), default=5, show_default=True, help="SH bands of the light.")
@click.option("--rays", type=click.IntRange(16, 1_000_000), default=1024, show_default=True, help="Rays a vertex.")
@click.option(
    "--gather-rays",
    type=click.IntRange(16, 100_000),
    default=256,
    show_default=True,
    help="Rays a vertex for light from other surfaces.",
)
@click.option("--bounces", type=click.IntRange(0, 20), default=3, show_default=True, help="0: shadows alone.")
@click.option("--unshadowed", is_flag=True, help="See no mesh, as if each surface stood alone.")
@click.option("--up", type=click.Choice(["y", "z"]), help="The file's upward axis; else y for glTF, z for the others.")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Of the rays' random turns.")
@click.option(
    "--output", type=click.Path(dir_okay=False, path_type=Path), required=True, help="The HDF5 file to write, e.g. scene.h5."
)
@click.option("--executor", default="threads", show_default=True, help="threads, processes, or a Dask scheduler's address.")
@click.option("--workers", type=click.IntRange(0), default=0, help="Threads or processes, 0 for one a core.")
@options.store
def transfer(
    mesh: str,
    bands: int,
    rays: int,
    gather_rays: int,
    bounces: int,
    unshadowed: bool,
    up: Literal["y", "z"] | None,
    seed: int,
    output: Path,
    executor: str,
    workers: int,
    store: Path,
) -> None:
    """Compute the transfer of MESH and write it as HDF5, which xarray opens.

    MESH is an OBJ, PLY or glTF file, or `courtyard`, a scene that is made by code. For each vertex, the dot product of
    its transfer with the SH weights of the light is irradiance / pi, shadows and bounces included, before the vertex's own
    albedo. Finished blocks of vertices are kept in the store: a run that was stopped goes on from them.

    Example: skylight-sh transfer courtyard --bands 5 --output courtyard.h5
    """
    from skylight_sh import UserError
    from skylight_sh.run import progress
    from skylight_sh.run.files import transfer_file
    from skylight_sh.run.mesh_source import MADE, MeshSource
    from skylight_sh.run.plan import execute
    from skylight_sh.run.steps import TRANSFER, transfer_step
    from skylight_sh.store import atomic
    from skylight_sh.store.store import Store
    from skylight_sh.transfer.options import Options

    if mesh not in MADE and not Path(mesh).is_file():
        raise UserError(f"No such mesh: {mesh}. Give the path of an OBJ, PLY or glTF file, or {', '.join(MADE)}.")
    if not output.absolute().parent.is_dir():
        raise UserError(f"Invalid --output {output}. Its folder is not there; make it first.")
    source = MeshSource(Path(mesh), Options(bands, rays, gather_rays, bounces, seed), up, unshadowed)
    plan = [transfer_step(source, executor, workers)]
    _, artifacts = execute(plan, Store(store), dict, progress.bar, warn, wanted=(TRANSFER,))
    found = artifacts[TRANSFER]
    atomic.write(output, transfer_file(found))
    vertices, channels, weights = found["transfer"].shape
    error = float(found.attrs["error"])
    click.echo(f"{output}: {vertices:,} vertices, {channels} channels, {weights} weights; error {100 * error:.2g} %")
