"""The command ``lightmap``: the light of a table, baked at the texels of a part of a mesh."""

from __future__ import annotations

from pathlib import Path

import click

from skylight_sh import UserError
from skylight_sh.cli import warn
from skylight_sh.cli.evaluate import AT, TURBIDITY, inputs_of, read_table


@click.command()
@click.argument("mesh", type=click.Path(path_type=Path))
@click.argument("table", type=click.Path(path_type=Path))
@click.option("--part", required=True, help="Part of the mesh whose chart (texture coordinates in [0, 1]) is baked.")
@click.option("--rows", type=click.IntRange(1), default=64, show_default=True, help="Texels from v = 1 down to v = 0.")
@click.option("--columns", type=click.IntRange(1), default=64, show_default=True, help="Texels from u = 0 to u = 1.")
@AT
@click.option("--sun-zenith", type=float, help="Short for --at sun_zenith=VALUE.")
@TURBIDITY
@click.option("--sun-azimuth", type=float, help="Radians from +x, east, towards +y, north; 0 if it is not given.")
@click.option("--bands", type=click.IntRange(2, 5), default=3, show_default=True, help="SH bands that a texel keeps.")
@click.option(
    "--fit", type=float, metavar="DEGREES", help="Fit them to normals so far from the surface's own, below 90, instead."
)
@click.option("--rays", type=click.IntRange(1), default=1024, show_default=True, help="Rays of a texel and of a vertex.")
@click.option("--bounces", type=click.IntRange(0), default=3, show_default=True, help="How often surfaces send light on.")
@click.option("--up", type=click.Choice(["y", "z"]), help="The mesh file's axis that points up, if not its format's.")
@click.option("--output", type=click.Path(path_type=Path), required=True, help="The NPZ to write.")
def lightmap(
    mesh: Path,
    table: Path,
    part: str,
    rows: int,
    columns: int,
    given: tuple[str, ...],
    sun_zenith: float | None,
    turbidity: float | None,
    sun_azimuth: float | None,
    bands: int,
    fit: float | None,
    rays: int,
    bounces: int,
    up: str | None,
    output: Path,
) -> None:
    """Bake the light of one sun from TABLE, an exported .npz, at the texels of a part of MESH.

    The NPZ holds the SH weights of the light that arrives at each texel, and the packed form of two bands, for an irradiance
    by a normal map: docs/formats.md lists its arrays. The light is the table's own, without the sun's disc.

    Example: skylight-sh lightmap yard.obj sky.npz --part wall --sun-zenith 0.8 --turbidity 3 --output wall.npz
    """
    import numpy as np

    from skylight_sh import lightmap as maps
    from skylight_sh import mesh as meshes
    from skylight_sh import runtime, sphere
    from skylight_sh.mesh.texels import averaged
    from skylight_sh.store import atomic
    from skylight_sh.transfer import Options, Rays, precompute

    if fit is not None and not 0.0 < fit < 90.0:
        raise UserError(f"Invalid --fit {fit}. Should be degrees above 0 and below 90.")
    loaded = read_table(table, None)
    if loaded.table.spec.quantity != "radiance":
        raise UserError(f"{table} holds {loaded.table.spec.quantity}, but texels keep radiance. Give a table of radiance.")
    values = inputs_of(loaded, given, {"sun_zenith": sun_zenith, "turbidity": turbidity, "sun_azimuth": sun_azimuth})
    weights, status = loaded.weights_and_status(bands=None, window=False, **values)
    if status == runtime.INVALID:
        raise UserError("An input is not a finite number. Give finite values.")
    if status == runtime.CLAMPED:
        warn("an input lies outside the table and was clamped.")
    light = np.asarray(weights, dtype=np.float64)
    scene, findings = meshes.read(mesh, up)
    for finding in findings:
        warn(finding.sentence)
    if len(light) not in (1, 3):
        raise UserError(f"{table} has {len(light)} channels, but surfaces have one colour or three. Give such a table.")
    texels = maps.chart(scene, part, rows, columns)
    made = precompute(scene, Options(bands=loaded.table.bands, rays=rays, bounces=bounces))
    leaving = averaged(scene).albedo * np.sum(made.transfer * light, axis=-1)
    arriving = maps.bake(
        scene,
        Rays(scene),
        texels,
        lambda directions: np.broadcast_to(sphere.evaluate(light, directions).T, (len(directions), 3)),
        leaving,
        bands if fit is None else max(bands, loaded.table.bands),
        maps.Sampling(rays),
    )
    if fit is not None:
        arriving = maps.fitted(arriving, texels.frames[..., 2, :], bands, float(np.radians(fit)))
    atomic.write(output, maps.write(maps.of(texels, arriving)))
    click.echo(f"{output}: {rows} x {columns} texels, {int(texels.covered.sum())} covered, {bands} bands")
