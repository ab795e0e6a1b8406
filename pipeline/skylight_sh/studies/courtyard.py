"""Makes the courtyard that the report's page draws: ``python -m skylight_sh.studies.courtyard TABLE.npz`` writes it.

The mesh is that of ``configs/courtyard.toml``. Its transfer has seven bands, so that the page can show one to seven, for
skies of a table over a black ground and mirrored at the horizon. Needs the extra ``transfer``; takes a minute.
"""

from __future__ import annotations

import io
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import click
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from skylight_sh import runtime, shipped, sphere
from skylight_sh.config import load
from skylight_sh.export.transfer_files import losses, told
from skylight_sh.light import sun_disc
from skylight_sh.light.preetham import Preetham
from skylight_sh.mesh import Mesh
from skylight_sh.mesh.courtyard import MORNING, Hour
from skylight_sh.probe.files import to_srgb
from skylight_sh.render import picture, sunlight, tone
from skylight_sh.render.camera import Camera
from skylight_sh.render.emitters import Disc
from skylight_sh.render.sky import Sky
from skylight_sh.render.surface import Points, Surface
from skylight_sh.report import courtyard as shipped_file
from skylight_sh.report.courtyard import BANDS, Packed
from skylight_sh.run import plan, progress
from skylight_sh.run.steps import mesh_source, steps
from skylight_sh.runtime import Runtime
from skylight_sh.store import atomic
from skylight_sh.store.store import Store
from skylight_sh.transfer import compression
from skylight_sh.transfer.compression import STEPS, Compressed
from skylight_sh.transfer.random_suns import random_suns
from skylight_sh.transfer.whole import precompute

Array = NDArray[np.float64]
Ints = NDArray[np.int64]

COMPONENTS = 16
# A length's unit is two millimetres, a normal's 1/200, a texture coordinate's 1/4096 of the texture. What nobody sees and
# only casts shadows may be coarser by a factor.
UNITS = {"position": 2e-3, "normal": 5e-3, "uv": 2.0**-12}
_HIDDEN = 3
# So many first and last components keep all their steps, the others one in so many.
_FINE, _COARSE = 4, 4
_MOST = STEPS - STEPS % _COARSE
# Whole numbers that a row of the matrix has either way.
_MATRIX = 2**15 - 1
# Parts whose textures are kept as pictures, and the one whose is kept as rings.
MATERIALS, RINGS = ("paving", "wall", "arcade", "cypress 1", "door"), "blue jar"
# Triangles are looked for in so many rows of the picture, and skies drawn.
_ROWS, _SUNS, _UNSEEN = 1350, 1500, 60
_POSTER = (800, 450)
_PICTURES = "pictures/courtyard"
# How well pictures are kept, 0 to 100.
_QUALITY = {"poster": 74, "paving": 72, "wall": 80, "arcade": 80, "cypress 1": 70, "door": 70}


@click.command()
@click.argument("table", type=click.Path(exists=True, dir_okay=False, path_type=Path))
@click.option(
    "--store", type=click.Path(file_okay=False, path_type=Path), default="artifacts", help="Where artifacts are kept."
)
def main(table: Path, store: Path) -> None:
    """Write the courtyard, for skies of TABLE, and its poster beside the report's modules."""
    root = Path(shipped_file.__file__).parent
    packed, poster = make(runtime.load(table))
    packed = replace(packed, facts={**packed.facts, "sources": sources(Store(store))})
    atomic.write(root / shipped_file.FILE, shipped_file.pack(packed))
    atomic.write(root / shipped_file.POSTER, poster)
    click.echo(f"{shipped_file.FILE}: {told(packed.facts['lost'])}")


def make(table: Runtime) -> tuple[Packed, bytes]:
    """Return the courtyard for skies of ``table``, seven bands over a black ground, and its poster."""
    source = mesh_source(load(shipped.folder() / "courtyard.toml"))
    if source is None:
        raise ValueError("configs/courtyard.toml has no mesh.")
    mesh = source.mesh()
    made = precompute(mesh, replace(source.options, bands=BANDS))
    seen, hidden = split(mesh, MORNING)
    vertices = np.unique(mesh.triangles[seen])
    direct, transfer = made.direct[vertices], made.transfer[vertices]
    skies = partial(_skies, table)
    compressed = coarser(compression.compress(direct, transfer, *skies(_SUNS, 0), COMPONENTS))
    lost = losses(compression.errors(compressed, direct, transfer, *skies(_UNSEEN, 1)))
    packed = _packed(mesh, seen, hidden, compressed, lost)
    return packed, _webp(poster(mesh, vertices, compressed, table, MORNING), _QUALITY["poster"])


def coarser(compressed: Compressed) -> Compressed:
    """Return components whose middle ones have fewer steps: the first are worth each, the last ones lend them theirs."""
    components = compressed.components.astype(np.int64)
    middle = components[:, _FINE:-_FINE]
    components[:, _FINE:-_FINE] = _COARSE * np.rint(np.clip(middle, -_MOST, _MOST) / _COARSE).astype(np.int64)
    return replace(compressed, components=components.astype(np.int8))


def sources(store: Store) -> dict[str, Any]:
    """Return where the error of pictures of the courtyard comes from, as `configs/papers-scenes.toml` measures it.

    Shares of the light, to two digits, by what loses them and by the sun's height in degrees.
    """
    planned = steps(load(shipped.folder() / "papers-scenes.toml"))
    found = plan.execute(planned, store, dict, progress.bar, click.echo, wanted=(_PICTURES,))[1][_PICTURES]
    errors = np.asarray(found["sources/error"], dtype=np.float64)
    return {
        "names": [str(name) for name in found["sources/source"]],
        "heights": [float(height) for height in found["sources/height"]],
        "errors": [[float(f"{value:.2g}") for value in row] for row in errors.tolist()],
    }


def split(mesh: Mesh, hour: Hour) -> tuple[Ints, Ints]:
    """Return which triangles the camera sees, with their neighbours that face it, and all others."""
    surface, view = Surface(mesh), hour.view
    along = Camera(view.eye, view.target, view.field, _ROWS * 16 // 9, _ROWS).directions().reshape(-1, 3)
    hits = surface.rays.nearest(np.broadcast_to(np.array(view.eye), along.shape), along)
    met = np.zeros(len(mesh.triangles), dtype=bool)
    met[hits.triangle[hits.met]] = True
    touching = np.isin(mesh.triangles, mesh.triangles[met]).any(axis=1)
    facing = np.einsum("tk,tk->t", mesh.corners[:, 0] - np.array(view.eye), mesh.facing) < 0.0
    shown = met | (touching & facing)
    return np.flatnonzero(shown), np.flatnonzero(~shown)


def poster(mesh: Mesh, vertices: Ints, compressed: Compressed, table: Runtime, hour: Hour) -> Array:
    """Return the picture of an hour, sRGB ``(rows, columns, 3)``, by five bands of the compressed transfer and the sun."""
    zenith, azimuth = np.radians(90.0 - hour.height), np.radians(hour.azimuth)
    sky = np.asarray(table.weights(zenith, azimuth, hour.turbidity), dtype=np.float64)
    sun = sun_disc.weights(zenith, azimuth, hour.turbidity, BANDS)
    lux = np.sqrt(4.0 * np.pi / 3.0) * (sky[:, 2] + sun[:, 2])
    used = np.arange(BANDS**2) < 25
    values = np.zeros((len(mesh.positions), 3))
    values[vertices] = compression.lit(compressed, sphere.mirror_ground(sky, BANDS) * used, sun * used)
    surface, view = Surface(mesh), hour.view
    axis = np.array([np.sin(zenith) * np.cos(azimuth), np.sin(zenith) * np.sin(azimuth), np.cos(zenith)])
    disc = Disc(axis, sun_disc.HALF_ANGLE, sun_disc.radiance(zenith, hour.turbidity))
    behind = Sky(Preetham(), {"sun_zenith": float(zenith), "turbidity": hour.turbidity}, float(azimuth))

    def lighting(points: Points, _: int) -> Array:
        return points.interpolate(values)

    camera = Camera(view.eye, view.target, view.field, *_POSTER)
    sampling = picture.Sampling(pixel=8)
    found = picture.take(camera, surface, lighting, behind.radiance, [disc], sampling, sunlight.straight)
    return tone.display(found.radiance, tone.exposure(float(lux @ tone.LUMINANCE)))


def _skies(table: Runtime, count: int, seed: int) -> tuple[Array, Array]:
    """Return ``count`` skies over black ground and as many mirrored ones, and their suns, ``(2 count, 3, N*N)``."""
    sky, sun = random_suns(table, BANDS, count, seed)
    return np.concatenate([sky, sphere.mirror_ground(sky, BANDS)]), np.concatenate([sun, sun])


def _packed(mesh: Mesh, seen: Ints, hidden: Ints, compressed: Compressed, lost: Mapping[str, float]) -> Packed:
    """Return the seen vertices with all they have, then those of other triangles with their positions alone."""
    first, others = np.unique(mesh.triangles[seen]), np.unique(mesh.triangles[hidden])
    # What a hidden triangle shares with a seen one it finds there.
    later = np.setdiff1d(others, first)
    order = np.concatenate([first, later])
    place = np.empty(len(mesh.positions), dtype=np.int64)
    place[order] = np.arange(len(order))
    columns: dict[str, Ints] = {}
    for axis, name in enumerate("xyz"):
        place_of = mesh.positions[order, axis]
        coarse = _HIDDEN * _steps(place_of, _HIDDEN * UNITS["position"])
        columns[name] = np.where(np.arange(len(order)) < len(first), _steps(place_of, UNITS["position"]), coarse)
    for axis, name in enumerate(("normal_x", "normal_y", "normal_z")):
        columns[name] = _steps(mesh.normals[first, axis], UNITS["normal"])
    palette, colour = np.unique(mesh.albedo[first], axis=0, return_inverse=True)
    material = _materials(mesh)[first]
    columns["colour"], columns["material"] = colour.ravel().astype(np.int64), material
    for axis, name in enumerate("uv"):
        columns[name] = np.where(material > 0, _steps(mesh.uv[first, axis], UNITS["uv"]), 0)
    for k in range(compressed.components.shape[1]):
        columns[f"component_{k}"] = compressed.components[:, k].astype(np.int64)
    columns["seen"] = place[mesh.triangles[seen]].ravel()
    columns["hidden"] = place[mesh.triangles[hidden]].ravel()
    largest = np.abs(compressed.matrix).max(axis=1)
    whole = compressed.matrix / np.where(largest > 0.0, largest, 1.0)[:, np.newaxis] * _MATRIX
    columns["matrix"] = np.rint(whole).astype(np.int64).ravel()
    view = MORNING.view
    facts: dict[str, Any] = {
        "bands": BANDS,
        "components": compressed.components.shape[1],
        "units": UNITS,
        "scales": [float(f"{value / _MATRIX:.9g}") for value in largest],
        "palette": palette.round(6).tolist(),
        "rings": _rings(mesh),
        "camera": {"eye": view.eye, "target": view.target, "field": view.field},
        "lost": dict(lost),
    }
    textures = {name: _texture(mesh, name) for name in MATERIALS}
    blobs = {name: _webp(to_srgb(np.clip(one, 0.0, 1.0)), _QUALITY[name]) for name, one in textures.items()}
    return Packed(columns, blobs, facts)


def _steps(values: Array, unit: float) -> Ints:
    return np.rint(values / unit).astype(np.int64)


def _texture(mesh: Mesh, name: str) -> Array:
    texture = next(part.texture for part in mesh.parts if part.name == name)
    if texture is None:
        raise ValueError(f"The part {name} has no texture.")
    return texture


def _materials(mesh: Mesh) -> Ints:
    """Return what texture each vertex ``(v,)`` has: 0 for none, else one more than its place in MATERIALS; rings last."""
    names = (*MATERIALS, RINGS)
    found = np.zeros(len(mesh.positions), dtype=np.int64)
    for k, part in enumerate(mesh.parts):
        if part.texture is not None:
            own = mesh.triangles[mesh.part == k]
            found[own] = 1 + next(i for i, name in enumerate(names) if np.array_equal(_texture(mesh, name), part.texture))
    return found


def _rings(mesh: Mesh) -> dict[str, Any]:
    """Return the heights, from and to, at which the jar's texture is not white, and its colour there."""
    texture = _texture(mesh, RINGS)[::-1, 0]
    painted = (texture != 1.0).any(axis=-1).astype(int)
    edges = np.flatnonzero(np.diff(painted, prepend=0, append=0)) / len(texture)
    return {"edges": edges.round(5).tolist(), "colour": texture[painted > 0][0].tolist()}


def _webp(srgb: Array, quality: int) -> bytes:
    out = io.BytesIO()
    Image.fromarray(np.rint(255.0 * srgb).astype(np.uint8)).save(out, "WEBP", quality=quality, method=6)
    return out.getvalue()


if __name__ == "__main__":
    main()
