"""Wavefront OBJ: polygons in named objects and groups, colours of materials from its MTL files."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError
from skylight_sh.mesh import pictures, polygons
from skylight_sh.mesh.findings import Finding, by_part
from skylight_sh.mesh.formats import mtl
from skylight_sh.mesh.formats.protocol import Content, Format, Surface, check_count, check_indices

Array = NDArray[np.float64]
Index = NDArray[np.int64]

# What says nothing of a surface's shape, or draws lines and points.
_IGNORED = {
    *("s", "l", "p", "vp", "mg", "bevel", "c_interp", "d_interp", "lod"),
    *("shadow_obj", "trace_obj", "maplib", "usemap"),
}
_CURVED = {
    *("cstype", "deg", "bmat", "step", "curv", "curv2", "surf"),
    *("parm", "trim", "hole", "scrv", "sp", "end", "con"),
}

# Lines after which their numbers are looked at.
_LOOK = 1 << 18


@dataclass
class _Faces:
    """The polygons of one object, group and material; ``words`` numbers the different corners among them."""

    words: dict[str, int] = field(default_factory=dict)
    corners: list[int] = field(default_factory=list)
    counts: list[int] = field(default_factory=list)


@dataclass
class _Lines:
    """What the lines of a file gather."""

    positions: list[float] = field(default_factory=list)
    colours: dict[int, list[float]] = field(default_factory=dict)
    uv: list[float] = field(default_factory=list)
    normals: list[float] = field(default_factory=list)
    libraries: list[str] = field(default_factory=list)
    faces: dict[tuple[str, str, str], _Faces] = field(default_factory=dict)
    # The object, group and material that the next faces belong to.
    o: str = ""
    g: str = ""
    usemtl: str = ""


def read(path: Path) -> Content:
    """Read an OBJ file: a part for every object (``o``), group (``g``) and material (``usemtl``).

    Colours of materials are linear; those of vertices (``v x y z r g b``) are sRGB, as programs that write them do.
    """
    lines = _Lines()
    with path.open(encoding="utf-8", errors="replace") as file:
        for number, words in _statements(file):
            if number % _LOOK == 0:
                _check_counts(lines)
            try:
                _take(lines, words)
            except (ValueError, IndexError) as error:
                raise UserError(f"line {number} cannot be read: {' '.join(words)[:60]!r}. Export it anew.") from error
            except UserError as error:
                raise UserError(f"line {number}: {error}") from error
    _check_counts(lines)
    materials, findings = mtl.read([path.parent / name for name in lines.libraries])
    names = _names(list(lines.faces), path.stem)
    surfaces, shelf = [], pictures.Shelf()
    for (place, faces), name in zip(lines.faces.items(), names, strict=True):
        material = materials.get(place[2])
        if place[2] and material is None and (materials or not lines.libraries):
            sentence = f"Part {name!r}: its material {place[2]!r} stands in no MTL file that the mesh names. Export it anew."
            findings.append(Finding(name, "no material", 1, False, sentence))
        if material and material.opacity < 1.0:
            sentence = (
                f"Part {name!r}: its material lets {1.0 - material.opacity:.0%} of the light through; taken as opaque."
            )
            findings.append(Finding(name, "transparent", 1, False, sentence))
        surfaces.append(_surface(name, lines, faces, material or mtl.Material(), shelf))
    few = [i for i, faces in enumerate(lines.faces.values()) for count in faces.counts if count < 3]
    findings += by_part(names, few, "few corners", "face/faces of fewer than 3 corners", "left out", healed=True)
    return Content(tuple(surfaces), (*findings, *shelf.findings))


def _check_counts(lines: _Lines) -> None:
    check_count(len(lines.positions) // 3, "vertices")
    check_count(sum(len(faces.corners) - 2 * len(faces.counts) for faces in lines.faces.values()), "triangles")


def _statements(file: Iterable[str]) -> Iterator[tuple[int, list[str]]]:
    """Yield the words of lines that say something, with the line's number; a backslash at its end joins the next to it."""
    held = ""
    number = 0
    for number, line in enumerate(file, 1):
        text = line.partition("#")[0].rstrip()
        if text.endswith("\\"):
            held += text[:-1] + " "
            continue
        words = (held + text).split()
        held = ""
        if words:
            yield number, words
    if held.split():
        yield number, held.split()


def _take(lines: _Lines, words: list[str]) -> None:
    """Take one statement. Raises ValueError or IndexError where it is none."""
    what = words[0]
    if what == "v":
        lines.positions += _numbers(words, 3)
        if len(words) >= 7:
            lines.colours[len(lines.positions) // 3 - 1] = [float(word) for word in words[-3:]]
    elif what == "vt":
        lines.uv += _numbers([*words, "0"], 2)
    elif what == "vn":
        lines.normals += _numbers(words, 3)
    elif what in ("f", "fo"):
        _take_face(lines, words[1:])
    elif what in ("o", "g", "usemtl"):
        setattr(lines, what, " ".join(words[1:]))
        # An object begins without a group.
        lines.g = "" if what == "o" else lines.g
    elif what == "mtllib":
        lines.libraries.append(" ".join(words[1:]))
    elif what in _CURVED:
        raise UserError(f"{what!r} belongs to a curved surface. Should be polygons. Export it as polygons.")
    elif what not in _IGNORED:
        raise ValueError(what)


def _numbers(words: list[str], count: int) -> list[float]:
    if len(words) <= count:
        raise ValueError(words[0])
    return [float(word) for word in words[1 : count + 1]]


def _take_face(lines: _Lines, corners: list[str]) -> None:
    faces = lines.faces.setdefault((lines.o, lines.g, lines.usemtl), _Faces())
    known = faces.words
    for corner in corners:
        word = _counted_from_start(lines, corner) if "-" in corner else corner
        faces.corners.append(known.setdefault(word, len(known)))
    faces.counts.append(len(corners))


def _counted_from_start(lines: _Lines, corner: str) -> str:
    """Turn a corner's negative numbers, which count back from the last line, into those from the first."""
    have = (len(lines.positions) // 3, len(lines.uv) // 2, len(lines.normals) // 3)
    numbers = [int(part) if part else None for part in corner.split("/")]
    return "/".join("" if n is None else str(count + 1 + n if n < 0 else n) for n, count in zip(numbers, have, strict=False))


def _names(places: Sequence[tuple[str, str, str]], stem: str) -> list[str]:
    """Name parts by object and group, and by material as well where these do not tell them apart."""
    shapes = ["/".join(dict.fromkeys(filter(None, (o, g)))) or stem for o, g, _ in places]
    return [
        f"{shape}/{material}" if material and shapes.count(shape) > 1 else shape
        for shape, (_, _, material) in zip(shapes, places, strict=True)
    ]


def _surface(name: str, lines: _Lines, faces: _Faces, material: mtl.Material, shelf: pictures.Shelf) -> Surface:
    """Gather what one part's corners name."""
    try:
        parsed = [[int(number) if number else 0 for number in word.split("/")] + [0, 0] for word in faces.words]
        chosen = np.array([numbers[:3] for numbers in parsed], np.int64).reshape(-1, 3) - 1
    except (ValueError, OverflowError) as error:
        raise UserError(f"part {name!r}: a face has a corner that is no index ({error}). Export it anew.") from error
    place, uv, normal = (
        _listed(name, numbers, width, index, noun)
        for numbers, width, index, noun in (
            (lines.positions, 3, chosen[:, 0], "positions"),
            (lines.uv, 2, chosen[:, 1], "texture coordinates"),
            (lines.normals, 3, chosen[:, 2], "normals"),
        )
    )
    if place is None:
        raise UserError(f"part {name!r}: its faces name no position. Export it anew.")
    triangles = polygons.triangulate(place, np.array(faces.corners, np.int64), np.array(faces.counts, np.int64))
    albedo = np.broadcast_to(material.albedo, place.shape) if material.albedo else None
    if lines.colours and material.albedo is None:
        albedo = _vertex_colours(lines, chosen[:, 0])
    texture = relief = None
    if uv is not None:
        texture = shelf.colours(name, material.texture.path) if material.texture else None
        relief = shelf.relief(name, material.relief.path) if material.relief else None
        first = material.texture or material.relief
        uv = uv * first.scale + first.offset if first else uv
    if texture is not None and albedo is None:
        albedo = np.ones_like(place)
    return Surface(name, place, triangles, normal, albedo, uv, texture, relief)


def _listed(name: str, numbers: list[float], width: int, index: Index, noun: str) -> Array | None:
    """Return the lists' rows that corners name ``(v, width)``; NaN where a corner names none, None where no corner does."""
    if (index == -1).all() and noun != "positions":
        return None
    rows = np.array(numbers, np.float64).reshape(-1, width)
    check_indices(name, index if noun == "positions" else index[index != -1], len(rows), noun)
    found = np.full((len(index), width), np.nan)
    found[index != -1] = rows[index[index != -1]]
    return found


def _vertex_colours(lines: _Lines, index: Index) -> Array | None:
    """Return linear RGB ``(v, 3)`` of vertices that have a colour, NaN for others, None where no one has."""
    found = np.array([lines.colours.get(i, [np.nan] * 3) for i in index.tolist()])
    return None if np.isnan(found).all() else pictures.decoded(found)


def beside(path: Path) -> tuple[Path, ...]:
    """Return the MTL files that an OBJ file names, and their pictures."""
    with path.open(encoding="utf-8", errors="replace") as file:
        named = [" ".join(words[1:]) for _, words in _statements(file) if words[0] == "mtllib"]
    libraries = [path.parent / name for name in named]
    used = [picture.path for m in mtl.read(libraries)[0].values() for picture in (m.texture, m.relief) if picture]
    return (*libraries, *used)


FORMAT = Format("Wavefront OBJ", "z", read, beside)
