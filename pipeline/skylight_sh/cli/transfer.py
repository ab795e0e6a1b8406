"""The command ``transfer``: what the vertices of a mesh make of the light around it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Literal

import click

from skylight_sh.cli import options, warn

if TYPE_CHECKING:
    from skylight_sh.mesh import Mesh
    from skylight_sh.runtime import Runtime
    from skylight_sh.store.dataset import Dataset


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
@click.option(
    "--gltf",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Also write the mesh with its transfer compressed, e.g. scene.glb, and beside it the shader and its uniforms.",
)
@click.option("--table", type=click.Path(path_type=Path), help="The exported .npz whose skies --gltf is compressed for.")
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
    gltf: Path | None,
    table: Path | None,
    executor: str,
    workers: int,
    store: Path,
) -> None:
    """Compute the transfer of MESH and write it as HDF5, which xarray opens.

    MESH is an OBJ, PLY or glTF file, or `courtyard`, a scene that is made by code. For each vertex, the dot product of
    its transfer with the SH weights of the light is irradiance / pi, shadows and bounces included, before the vertex's own
    albedo. Finished blocks of vertices are kept in the store: a run that was stopped goes on from them.

    Example: skylight-sh transfer courtyard --bands 5 --output courtyard.h5

    With --gltf and --table, twenty bytes a vertex hold it for engines, and what that loses of the table's light is told.
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
    for name, path in (("--output", output), ("--gltf", gltf)):
        if path is not None and not path.absolute().parent.is_dir():
            raise UserError(f"Invalid {name} {path}. Its folder is not there; make it first.")
    if (gltf is None) != (table is None):
        raise UserError("--gltf and --table belong together: transfer is compressed for a table's skies. Give both.")
    lit_by = None if table is None else _lights(table, bands)
    source = MeshSource(Path(mesh), Options(bands, rays, gather_rays, bounces, seed), up, unshadowed)
    plan = [transfer_step(source, executor, workers)]
    _, artifacts = execute(plan, Store(store), dict, progress.bar, warn, wanted=(TRANSFER,))
    found = artifacts[TRANSFER]
    atomic.write(output, transfer_file(found))
    vertices, channels, weights = found["transfer"].shape
    error = float(found.attrs["error"])
    click.echo(f"{output}: {vertices:,} vertices, {channels} channels, {weights} weights; error {100 * error:.2g} %")
    if gltf is not None and lit_by is not None:
        _write_gltf(gltf, source.mesh(), found, lit_by)


def _lights(path: Path, bands: int) -> Runtime:
    """Return the table at ``path``; UserError where it cannot light transfer of so many bands."""
    from skylight_sh.cli.evaluate import read_table
    from skylight_sh.transfer.random_suns import random_suns

    loaded = read_table(path, None)
    random_suns(loaded, bands, 1, 0)
    return loaded


def _write_gltf(place: Path, mesh: Mesh, found: Dataset, table: Runtime) -> None:
    """Write compressed transfer at ``place`` and beside it, and tell what is lost."""
    from skylight_sh.export import transfer_files
    from skylight_sh.store import atomic

    direct, whole = (found[name].astype("float64") for name in ("direct", "transfer"))
    written = transfer_files.write(mesh, direct, whole, table, stem=place.stem)
    for name, data in written.files.items():
        atomic.write(place if name == f"{place.stem}.glb" else place.parent / name, data)
    click.echo(f"{place}: {transfer_files.told(written.lost)}")
