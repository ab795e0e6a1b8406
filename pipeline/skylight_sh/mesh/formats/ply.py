"""Stanford PLY, as text or binary of either byte order: one surface, perhaps with normals and colours of vertices."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError
from skylight_sh.mesh import pictures, polygons
from skylight_sh.mesh.findings import Finding, by_part
from skylight_sh.mesh.formats.protocol import Content, Format, Surface, check_count, check_indices

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_TYPES = {
    **{"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4", "float": "f4", "double": "f8"},
    **{"int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4"},
    **{"float32": "f4", "float64": "f8"},
}
_ORDERS = {"ascii": "<", "binary_little_endian": "<", "binary_big_endian": ">"}
_UV = (("s", "t"), ("u", "v"), ("texture_u", "texture_v"))
_COLOURS = (("red", "green", "blue"), ("diffuse_red", "diffuse_green", "diffuse_blue"), ("r", "g", "b"))
_HEADER = re.compile(rb"ply\r?\n.*?\nend_header[ \t]*\r?\n", re.DOTALL)


@dataclass(frozen=True)
class _Property:
    """A column of an element: its numbers' ``kind`` in NumPy's letters, and that of a list's length, or empty."""

    name: str
    kind: str
    length: str = ""


@dataclass(frozen=True)
class _Element:
    """A table of a file: ``count`` rows of ``properties``."""

    name: str
    count: int
    properties: tuple[_Property, ...] = ()


@dataclass(frozen=True)
class _Lists:
    """A column of lists: all their ``values`` one after the other, and how many each row has."""

    values: Array
    counts: Index


@dataclass(frozen=True)
class _Header:
    """How numbers are stored, which tables there are, and the picture that a comment names."""

    order: str
    elements: tuple[_Element, ...]
    picture: str


_Columns = dict[str, Array | _Lists]


def read(path: Path) -> Content:
    """Read a PLY file: one part, named as the file.

    Colours of whole numbers are sRGB, those of floats linear; texture coordinates need a comment ``TextureFile``.
    """
    data = path.read_bytes()
    found = _HEADER.match(data)
    if not found:
        raise UserError("The file is no PLY: it has no header from 'ply' to 'end_header'. Export it anew.")
    header = _parsed(found[0].decode("utf-8", errors="replace"))
    data = data[found.end() :]
    if b"format ascii" in found[0]:
        try:
            # As numbers of one kind, text is read as binary is.
            data = np.array(data.split(), dtype="S").astype("<f8").tobytes() if data.split() else b""
        except ValueError as error:
            raise UserError(f"what follows the header is not all numbers ({error}). Export it anew.") from error
        one = [tuple(replace(p, kind="f8", length="f8" if p.length else "") for p in e.properties) for e in header.elements]
        header = replace(header, elements=tuple(replace(e, properties=p) for e, p in zip(header.elements, one, strict=True)))
    tables, at = {}, 0
    for element in header.elements:
        tables[element.name], at = _table(element, data, at, header.order)
    if at < len(data):
        raise UserError(f"more follows than its header counts ({_told(header)}). Mend the header, or export it anew.")
    floats = {p.name for e in _parsed(found[0].decode("utf-8", "replace")).elements for p in e.properties if "f" in p.kind}
    return _content(path, header, tables, floats)


def _parsed(text: str) -> _Header:
    """Parse a header. Raises UserError for a line that is none of a header's."""
    order, picture, elements = "", "", list[_Element]()
    for line in text.splitlines()[1:-1]:
        words = line.split()
        if words[:1] == ["comment"] and words[1:2] == ["TextureFile"]:
            picture = " ".join(words[2:])
        elif words[:1] in ([], ["comment"], ["obj_info"]):
            continue
        elif words[0] == "format" and len(words) == 3 and words[1] in _ORDERS and not order:
            order = _ORDERS[words[1]]
        elif words[0] == "element" and len(words) == 3 and words[2].isdecimal():
            elements.append(_Element(words[1], int(words[2])))
        elif words[0] == "property" and elements and (column := _column(words[1:])):
            elements[-1] = replace(elements[-1], properties=(*elements[-1].properties, column))
        else:
            raise UserError(f"the header's line {line[:60]!r} cannot be read. Export it anew.")
    names = [element.name for element in elements]
    twice = len(set(names)) < len(names) or any(len({p.name for p in e.properties}) < len(e.properties) for e in elements)
    if not order or twice:
        raise UserError(f"the header {'names something twice' if twice else 'has no format'}. Export it anew.")
    return _Header(order, tuple(elements), picture)


def _column(words: list[str]) -> _Property | None:
    if len(words) == 2 and words[0] in _TYPES:
        return _Property(words[1], _TYPES[words[0]])
    if len(words) == 4 and words[0] == "list" and words[1] in _TYPES and words[2] in _TYPES:
        return _Property(words[3], _TYPES[words[2]], _TYPES[words[1]])
    return None


def _table(element: _Element, data: bytes, at: int, order: str) -> tuple[_Columns, int]:
    """Return an element's columns and where the next one starts. Raises UserError where the file ends before."""
    check_count(element.count, element.name + " rows")
    least = sum(np.dtype(p.length or p.kind).itemsize for p in element.properties)
    if at + least * element.count > len(data):
        raise _short(element)
    if not element.properties or not element.count:
        return {
            p.name: _Lists(np.zeros(0), np.zeros(0, np.int64)) if p.length else np.zeros(0) for p in element.properties
        }, at
    try:
        first, _ = _row(element, data, at, order)
        sizes = [len(values) for values in first]
        dtype = np.dtype(
            [
                (f"{i}{what}", order + kind, shape)
                for i, (p, size) in enumerate(zip(element.properties, sizes, strict=True))
                for what, kind, shape in ([("n", p.length, ()), ("v", p.kind, (size,))] if p.length else [("v", p.kind, ())])
            ]
        )
        end = at + dtype.itemsize * element.count
        if end <= len(data):
            rows = np.frombuffer(data, dtype, element.count, at)
            if all((rows[f"{i}n"] == size).all() for i, size in enumerate(sizes) if element.properties[i].length):
                return {p.name: _whole(p, rows, i, sizes[i]) for i, p in enumerate(element.properties)}, end
        return _one_by_one(element, data, at, order)
    except (ValueError, OverflowError) as error:
        raise _short(element) from error


def _whole(column: _Property, rows: NDArray[np.void], i: int, size: int) -> Array | _Lists:
    values = rows[f"{i}v"].astype(np.float64)
    return _Lists(values.ravel(), np.full(len(rows), size)) if column.length else values


def _one_by_one(element: _Element, data: bytes, at: int, order: str) -> tuple[_Columns, int]:
    """Read rows whose lists differ in length."""
    gathered: list[list[NDArray[np.generic]]] = [[] for _ in element.properties]
    for _ in range(element.count):
        row, at = _row(element, data, at, order)
        for held, values in zip(gathered, row, strict=True):
            held.append(values)
    columns: _Columns = {}
    for p, held in zip(element.properties, gathered, strict=True):
        together = np.concatenate(held).astype(np.float64)
        columns[p.name] = _Lists(together, np.array([len(v) for v in held])) if p.length else together
    return columns, at


def _row(element: _Element, data: bytes, at: int, order: str) -> tuple[list[NDArray[np.generic]], int]:
    """Return one row, each column's values, and where the next one starts. Raises ValueError where the data end."""
    row = []
    for p in element.properties:
        count = 1
        if p.length:
            length = np.frombuffer(data, order + p.length, 1, at)
            count, at = int(length[0]), at + length.itemsize
            if count < 0 or count != length[0]:
                raise ValueError(count)
        # NumPy refuses a count of -1 or more than there are, but takes 0 for nothing only where something is left.
        row.append(np.frombuffer(data, order + p.kind, count, at) if count else np.zeros(0))
        at += row[-1].itemsize * count
    return row, at


def _short(element: _Element) -> UserError:
    return UserError(
        f"the file ends, or has a list of an impossible length, before all {element.count:,} rows of the element "
        f"{element.name!r} that its header counts. Export it anew."
    )


def _told(header: _Header) -> str:
    return ", ".join(f"{element.count:,} {element.name}" for element in header.elements)


def _content(path: Path, header: _Header, tables: dict[str, _Columns], floats: set[str]) -> Content:
    """Make the one surface of a file's tables."""
    vertices, faces, name = tables.get("vertex", {}), tables.get("face", {}), path.stem
    if "tristrips" in tables:
        raise UserError("The file holds triangle strips. Should hold faces. Export it as triangles.")
    place = _together(vertices, ("x", "y", "z"))
    if place is None:
        raise UserError("The file has no positions x, y and z of vertices. Export it anew.")
    lists = faces.get("vertex_indices", faces.get("vertex_index"))
    if not isinstance(lists, _Lists):
        raise UserError("The file has no faces, points alone. Should hold triangles. Make a surface of them first.")
    wrong = ~(np.abs(lists.values) < 2**53)
    corners = np.where(wrong, -1.0, lists.values).astype(np.int64)
    check_indices(name, corners, len(place), "vertices")
    triangles = polygons.triangulate(place, corners, lists.counts)
    few = np.zeros(int((lists.counts < 3).sum()), np.int64)
    findings = [*by_part([name], few, "few corners", "face/faces of fewer than 3 corners", "left out", healed=True)]
    if any(p in faces for p in ("texcoord", "red")):
        sentence = f"Part {name!r}: colours or texture coordinates of its faces are not read. Give them to its vertices."
        findings.append(Finding(name, "face colours", 1, False, sentence))
    uv = next((found for pair in _UV if (found := _together(vertices, pair)) is not None), None)
    albedo = next((found for three in _COLOURS if (found := _together(vertices, three)) is not None), None)
    if albedo is not None and not floats & {"red", "diffuse_red", "r"}:
        most = 65535.0 if (albedo > 255.0).any() else 255.0
        albedo = pictures.decoded(albedo / most)
    shelf = pictures.Shelf()
    texture = shelf.colours(name, path.parent / header.picture) if header.picture and uv is not None else None
    if texture is not None and albedo is None:
        albedo = np.ones_like(place)
    surface = Surface(name, place, triangles, _together(vertices, ("nx", "ny", "nz")), albedo, uv, texture)
    return Content((surface,), (*findings, *shelf.findings))


def _together(columns: _Columns, names: tuple[str, ...]) -> Array | None:
    found = [columns[name] for name in names if name in columns]
    arrays = [column for column in found if not isinstance(column, _Lists)]
    return np.stack(arrays, axis=-1) if len(arrays) == len(names) else None


def beside(path: Path) -> tuple[Path, ...]:
    """Return the picture that a PLY file names, if any."""
    found = _HEADER.match(path.read_bytes())
    picture = _parsed(found[0].decode("utf-8", errors="replace")).picture if found else ""
    return (path.parent / picture,) if picture else ()


FORMAT = Format("Stanford PLY", "z", read, beside)
