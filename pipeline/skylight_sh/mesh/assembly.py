"""Surfaces of a file put together as one mesh, refused where they cannot be."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import count

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError
from skylight_sh.mesh._mesh import Mesh, Part
from skylight_sh.mesh.findings import Finding, by_part
from skylight_sh.mesh.formats.protocol import Surface, Up, check_count, check_indices

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

GREY = 0.5
BRIGHT = 0.95
# Beyond these, products of lengths leave the range of numbers.
_SMALLEST, _LARGEST = 1e-60, 1e60


def assemble(surfaces: Sequence[Surface], up: Up) -> tuple[Mesh, tuple[Finding, ...]]:
    """Return surfaces as one mesh with z up, vertices that no triangle uses left out, and what was made up.

    Normals are NaN where a surface has none, to be healed later. Albedo is 0.5 where a surface has none, 0 or 1 where it is
    outside. Raises UserError for no triangle at all, more than ``MOST_VERTICES``, indices out of range, positions that
    are no numbers, and sizes that leave the range of numbers.
    """
    surfaces = [surface for surface in surfaces if len(surface.triangles)]
    if not surfaces:
        raise UserError("The file has no triangles. Should have at least one. Export the mesh with its faces.")
    check_count(sum(len(surface.positions) for surface in surfaces), "vertices")
    check_count(sum(len(surface.triangles) for surface in surfaces), "triangles")
    names, findings, kept = _unique([surface.name for surface in surfaces]), list[Finding](), []
    for name, surface in zip(names, surfaces, strict=True):
        check_indices(name, surface.triangles, len(surface.positions), "vertices")
        used, told = _used(name, surface)
        _check_numbers(name, used)
        kept.append(used)
        findings += told
    starts = np.cumsum([0, *(len(surface.positions) for surface in kept)])
    part = np.repeat(np.arange(len(kept)), [len(surface.triangles) for surface in kept])
    mesh = Mesh(
        positions=_turned(np.concatenate([s.positions for s in kept]), up),
        normals=_turned(np.concatenate([_or(s.normals, s, np.nan) for s in kept]), up),
        albedo=np.concatenate([_or(s.albedo, s, GREY) for s in kept]),
        triangles=np.concatenate([s.triangles + start for s, start in zip(kept, starts[:-1], strict=True)]),
        part=part,
        parts=tuple(Part(name, s.texture, s.relief) for name, s in zip(names, kept, strict=True)),
        uv=np.concatenate([np.zeros((len(s.positions), 2)) if s.uv is None else s.uv for s in kept]),
    )
    _check_size(mesh)
    return mesh, tuple(findings)


def _check_size(mesh: Mesh) -> None:
    far = float(np.abs(mesh.positions).max())
    # Halves, for the difference of two large numbers may be none.
    size = 2.0 * float((0.5 * mesh.positions.max(axis=0) - 0.5 * mesh.positions.min(axis=0)).max())
    if size < _SMALLEST or far > _LARGEST:
        raise UserError(
            f"The mesh is {size:.3g} long and reaches {far:.3g} from the origin. Should be at least {_SMALLEST:g} and at "
            f"most {_LARGEST:g}. Export it in another unit."
        )


def _unique(names: Sequence[str]) -> list[str]:
    """Return names with a number after those that were there before."""
    taken, result = set[str](), list[str]()
    for name in names:
        tried = (name if n == 1 else f"{name} {n}" for n in count(1))
        result.append(next(new for new in tried if new not in taken))
        taken.add(result[-1])
    return result


def _used(name: str, surface: Surface) -> tuple[Surface, list[Finding]]:
    """Leave out what no triangle uses; a colour or texture coordinate that is missing or outside its range is told."""
    used, triangles = np.unique(surface.triangles, return_inverse=True)
    albedo, uv, normals = (None if a is None else a[used] for a in (surface.albedo, surface.uv, surface.normals))
    found: list[tuple[int, str, str, str, bool]] = []
    lost = len(surface.positions) - len(used)
    found.append((lost, "unused", "vertex/vertices that no triangle uses", "left out", True))
    if albedo is None:
        found.append((len(used), "no albedo", "vertex/vertices without a colour", f"taken as grey of albedo {GREY:g}", True))
    else:
        finite: Mask = np.asarray(np.isfinite(albedo).all(axis=-1))
        outside = finite & ((albedo < 0.0) | (albedo > 1.0)).any(axis=-1)
        found += [
            (
                int((~finite).sum()),
                "no albedo",
                "vertex/vertices without a colour",
                f"taken as grey of albedo {GREY:g}",
                True,
            ),
            (int(outside.sum()), "albedo", "vertex/vertices of albedo outside 0 to 1", "clamped", True),
        ]
        bright = finite & ~outside & (albedo > BRIGHT).any(axis=-1) & (surface.texture is None)
        noun = f"vertex/vertices of albedo above {BRIGHT:g}"
        found.append((int(bright.sum()), "bright albedo", noun, "more than fresh snow has, left so", False))
        albedo = np.where(finite[:, np.newaxis], np.clip(albedo, 0.0, 1.0), GREY)
    if uv is not None:
        wrong: Mask = np.asarray(~np.isfinite(uv).all(axis=-1))
        found.append((int(wrong.sum()), "uv", "vertex/vertices without texture coordinates", "taken as 0, 0", True))
        uv = np.where(wrong[:, np.newaxis], 0.0, uv)
    findings = [
        told
        for number, kind, noun, done, healed in found
        for told in by_part([name], np.zeros(number, np.int64), kind, noun, done, healed=healed)
    ]
    kept = Surface(
        name, surface.positions[used], triangles.reshape(-1, 3), normals, albedo, uv, surface.texture, surface.relief
    )
    return kept, findings


def _check_numbers(name: str, surface: Surface) -> None:
    wrong = np.flatnonzero(~np.isfinite(surface.positions).all(axis=-1))
    if len(wrong):
        raise UserError(
            f"part {name!r}: {len(wrong):,} vertices have a position that is no number, such as "
            f"{surface.positions[wrong[0]].tolist()}. Should be finite. Mend the mesh where it was made, and export it anew."
        )


def _or(values: Array | None, surface: Surface, missing: float) -> Array:
    return np.full_like(surface.positions, missing) if values is None else values


def _turned(vectors: Array, up: Up) -> Array:
    """Turn ``(v, 3)`` so that the axis ``up`` is z."""
    return vectors if up == "z" else np.stack([vectors[:, 0], 0.0 - vectors[:, 2], vectors[:, 1]], axis=-1)
