"""``python -m skylight_sh.studies.lightmaps``: what a lightmap of few bands loses against baking each normal.

A street between two facades under the exact Preetham sky at turbidity 3, with three bounces; texels on one facade, each with
normals tilted up to 60 degrees from it. Brute force sends other rays, and expands nothing.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.lightmap import evaluation, incident, texels
from skylight_sh.mesh import Mesh, Part
from skylight_sh.reflectance import glossy, lobes
from skylight_sh.reflectance.brute_force import relative_rms
from skylight_sh.studies.materials import SUNS, environment
from skylight_sh.transfer import Options, Rays, precompute

Array = NDArray[np.float64]

BANDS = (2, 3, 5)
GLOSSY_BANDS = (5, 7, 10)
EXPONENTS = (8, 16, 32)
TILTS = np.radians([0.0, 20.0, 40.0, 60.0])
_AROUND = 6
_TRANSFER = Options(bands=7, rays=256, gather_rays=128, bounces=3)
_ALBEDO = {"facade": (0.6, 0.5, 0.4), "opposite": (0.7, 0.35, 0.25), "ground": (0.25, 0.25, 0.25)}


@dataclass(frozen=True)
class Street:
    """A scene and what lights it: the mesh, its rays, texels, a light from all sides, and what vertices send back."""

    mesh: Mesh
    rays: Rays
    texels: texels.Texels


def street(rows: int = 4, columns: int = 6) -> Street:
    """Return two facades 20 long and 6 high, 5 apart along x, and the ground between, in patches of about 1."""
    sides = {
        # Origin, the side along u and the side along v, so that u x v points into the street.
        "facade": ((0.0, -10.0, 0.0), (0.0, 20.0, 0.0), (0.0, 0.0, 6.0)),
        "opposite": ((5.0, 10.0, 0.0), (0.0, -20.0, 0.0), (0.0, 0.0, 6.0)),
        "ground": ((0.0, -10.0, 0.0), (5.0, 0.0, 0.0), (0.0, 20.0, 0.0)),
    }
    pieces = [_patches(np.array(sides[name]), np.array(albedo)) for name, albedo in _ALBEDO.items()]
    before = np.cumsum([0, *(len(piece.positions) for piece in pieces)])
    mesh = Mesh(
        positions=np.concatenate([piece.positions for piece in pieces]),
        normals=np.concatenate([piece.normals for piece in pieces]),
        albedo=np.concatenate([piece.albedo for piece in pieces]),
        triangles=np.concatenate([piece.triangles + k for piece, k in zip(pieces, before, strict=False)]),
        part=np.repeat(np.arange(3), [len(piece.triangles) for piece in pieces]),
        parts=tuple(Part(name) for name in sides),
        uv=np.concatenate([piece.uv for piece in pieces]),
    )
    return Street(mesh, Rays(mesh), texels.chart(mesh, "facade", rows, columns))


def tilted(frames: Array) -> Array:
    """Return normals ``(..., k, 3)`` tilted from each frame's own by every one of ``TILTS``, all around."""
    turn = 2 * np.pi * np.arange(_AROUND) / _AROUND
    tilt, around = np.meshgrid(TILTS[1:], turn, indexing="ij")
    local = np.stack([np.sin(tilt) * np.cos(around), np.sin(tilt) * np.sin(around), np.cos(tilt)], axis=-1).reshape(-1, 3)
    return texels.world_normals(frames[..., np.newaxis, :, :], np.concatenate([[[0.0, 0.0, 1.0]], local]))


def errors(scene: Street, sun: float, rays: int = 1024) -> dict[str, tuple[float, float]]:
    """Return, by form, the relative RMS over texels, normals and channels, and the worst error over the RMS irradiance."""
    weights, seen = environment(sun)
    made = precompute(scene.mesh, _TRANSFER)
    leaving = scene.mesh.albedo * np.einsum("vcw,cw->vc", made.transfer, weights[:, : _TRANSFER.bands**2])
    many = incident.Sampling(4 * rays, seed=2)
    normals = tilted(scene.texels.frames)
    exact = incident.irradiance(scene.mesh, scene.rays, scene.texels, normals, seen.radiance, leaving, many)
    found = {"normal map ignored": np.broadcast_to(exact[..., :1, :], exact.shape)}
    sampling = incident.Sampling(rays)
    baked = incident.bake(scene.mesh, scene.rays, scene.texels, seen.radiance, leaving, max(BANDS), sampling)
    for bands in BANDS:
        kept = baked[..., np.newaxis, :, : bands**2]
        found[f"{bands} bands"] = evaluation.evaluate(kept, normals)
        if bands == 2:
            found["2 bands, nonnegative"] = evaluation.evaluate(kept, normals, "nonnegative")
        if bands == 3:
            found["3 bands, deringed"] = evaluation.evaluate(evaluation.deringed(kept), normals)
    for bands in (2, 3):
        kept = evaluation.fitted(baked, scene.texels.frames[..., 2, :], bands)
        found[f"{bands} bands, fitted"] = evaluation.evaluate(kept[..., np.newaxis, :, :], normals)
    back = scene.mesh.albedo[:, :, np.newaxis] * made.transfer
    matrices = incident.matrices(scene.mesh, scene.rays, scene.texels, back, 3, sampling)
    for bands in (5, 7):
        lit = incident.apply(matrices[..., : bands**2], weights)
        found[f"3 bands, by matrices of {bands}"] = evaluation.evaluate(lit[..., np.newaxis, :, :], normals)
    size = np.sqrt(np.mean(np.square(exact)))
    return {name: (relative_rms(one, exact), float(np.abs(one - exact).max() / size)) for name, one in found.items()}


def glossy_errors(scene: Street, sun: float, rays: int = 2048) -> dict[tuple[int, int], float]:
    """Return, by exponent and bands, the relative RMS of a cosine's powers reflected by 20 places on the ground.

    Over mirror directions at least 9 degrees above it; what arrives is baked in SH, brute force sums the lobe over rays.
    """
    weights, seen = environment(sun)
    made = precompute(scene.mesh, _TRANSFER)
    leaving = scene.mesh.albedo * np.einsum("vcw,cw->vc", made.transfer, weights[:, : _TRANSFER.bands**2])
    places = np.array([[x, y, 0.0] for x in (0.5, 1.5, 2.5, 3.5, 4.5) for y in (-8.0, -3.0, 2.0, 7.0)])
    ground = texels.of_points(places, np.tile([0.0, 0.0, 1.0], (20, 1)), np.tile([1.0, 0.0, 0.0], (20, 1)))
    sampling, many = incident.Sampling(rays), incident.Sampling(2 * rays, seed=2)
    baked = incident.bake(scene.mesh, scene.rays, ground, seen.radiance, leaving, max(GLOSSY_BANDS), sampling)
    reflected = np.array([r for r in sphere.spiral(60) if r[2] > 0.15])
    exact: dict[int, list[Array]] = {n: [] for n in EXPONENTS}
    for met in incident.meet(scene.mesh, scene.rays, ground, many):
        light = met.solid_angle * incident.arriving(met, seen.radiance, leaving)
        cosine = np.maximum(reflected @ met.directions.swapaxes(1, 2), 0.0)
        for n in EXPONENTS:
            exact[n].append((n + 1) / (2 * np.pi) * (cosine**n @ light))
    found = {}
    for n in EXPONENTS:
        for bands in GLOSSY_BANDS:
            kept = baked[:, np.newaxis, :, : bands**2]
            lit = glossy.radiance(kept, lobes.cosine_power(n, bands), reflected)
            found[n, bands] = relative_rms(lit, np.concatenate(exact[n]))
    return found


def main() -> None:
    """Print the rows."""
    scene = street()
    shiny = [glossy_errors(scene, sun) for sun in SUNS]
    for n, bands in shiny[0]:
        print("|", " | ".join([f"cos^{n}", str(bands), *(f"{100 * column[n, bands]:.2g} %" for column in shiny)]), "|")
    columns = [errors(scene, sun) for sun in SUNS]
    for name in columns[0]:
        cells = [
            f"{100 * rms:.2g} % ({float(f'{100 * worst:.2g}'):g} %)" for rms, worst in (column[name] for column in columns)
        ]
        print("|", " | ".join([name, *cells]), "|")


def _patches(rectangle: Array, albedo: Array) -> Mesh:
    """Return a rectangle ``(3, 3)``, a corner and two sides, in patches about 1 in size; texture coordinates from 0 to 1."""
    origin, along, up = rectangle
    columns, rows = (max(1, round(float(np.linalg.norm(side)))) for side in (along, up))
    u, v = (part.ravel() for part in np.meshgrid(np.arange(columns + 1) / columns, np.arange(rows + 1) / rows))
    normal = np.cross(along, up)
    corner = np.arange((columns + 1) * (rows + 1)).reshape(rows + 1, columns + 1)
    a, b, c, d = (part.ravel() for part in (corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1]))
    triangles = np.concatenate([np.stack([a, b, c], axis=-1), np.stack([a, c, d], axis=-1)])
    return Mesh(
        positions=origin + np.multiply.outer(u, along) + np.multiply.outer(v, up),
        normals=np.broadcast_to(normal / np.linalg.norm(normal), (u.size, 3)).copy(),
        albedo=np.broadcast_to(albedo, (u.size, 3)).copy(),
        triangles=triangles,
        part=np.zeros(len(triangles), dtype=np.int64),
        parts=(Part("patches"),),
        uv=np.stack([u, v], axis=-1),
    )


if __name__ == "__main__":
    main()
