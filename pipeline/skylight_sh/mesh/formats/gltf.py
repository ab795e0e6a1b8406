"""glTF 2.0, as text or GLB: nodes with their meshes, base colours and pictures of materials, instances."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError
from skylight_sh.mesh import pictures
from skylight_sh.mesh.findings import Finding
from skylight_sh.mesh.formats import gltf_material
from skylight_sh.mesh.formats.gltf_file import Document, Json, inner, listed, load, name_of, numbers, objects, whole
from skylight_sh.mesh.formats.protocol import Content, Format, Surface, check_count

Array = NDArray[np.float64]
Index = NDArray[np.int64]

# What may be required of a reader and changes neither shape nor base colour, or is read here.
_KNOWN = {
    *(
        "KHR_mesh_quantization",
        "KHR_texture_transform",
        "EXT_mesh_gpu_instancing",
        "KHR_lights_punctual",
        "EXT_texture_webp",
    ),
    *(
        "KHR_materials_" + name
        for name in ("unlit", "ior", "specular", "clearcoat", "sheen", "emissive_strength", "variants")
    ),
    *("KHR_materials_" + name for name in ("iridescence", "anisotropy", "dispersion", "pbrSpecularGlossiness")),
    *(
        "KHR_materials_transmission",
        "KHR_materials_volume",
        "KHR_node_visibility",
        "KHR_xmp_json_ld",
        "KHR_animation_pointer",
    ),
}
_TRIANGLES, _STRIP, _FAN = 4, 5, 6


@dataclass
class _Scene:
    """A document, what its meshes were read as, and what is told of them."""

    document: Document
    shelf: pictures.Shelf = field(default_factory=pictures.Shelf)
    meshes: dict[int, list[Surface]] = field(default_factory=dict)
    findings: list[Finding] = field(default_factory=list)

    def tell(self, part: str, kind: str, count: int, text: str) -> None:
        """Tell something of a part that is left as it is."""
        self.findings.append(Finding(part, kind, count, False, f"Part {part!r}: {text}"))


def read(path: Path) -> Content:
    """Read a glTF file's scene: a part for every node and primitive, named as node (or mesh) and material.

    Base colours are linear. Skins, morph targets and animations are left as the nodes stand, and told. Raises UserError for
    what it cannot read whole, and, by name, for an extension that a reader must know and this one does not.
    """
    document = load(path)
    for extension in listed(document.root, "extensionsRequired"):
        if extension not in _KNOWN:
            compressed = any(word in str(extension) for word in ("draco", "meshopt", "basisu"))
            remedy = "Export without compression." if compressed else "Export without it."
            raise UserError(f"glTF: requires the extension {str(extension)[:60]}, which is not read. {remedy}")
    scene = _Scene(document)
    surfaces: list[Surface] = []
    total = 0
    for node, world in _nodes(document):
        if "mesh" in node:
            index = whole(node, "mesh")
            shapes = _mesh(scene, index)
            name = name_of(node, name_of(document.one("meshes", index), f"mesh {index}"))
            if "skin" in node:
                scene.tell(name, "skin", 1, "its skin is not applied, it stands in its bind pose. Export it posed.")
            transforms = _instances(document, node, world)
            total += len(transforms) * sum(len(shape.positions) for shape in shapes)
            check_count(total, "vertices")
            surfaces += [replace(_placed(s, one), name=_joined(name, s.name)) for one in transforms for s in shapes]
    return Content(tuple(surfaces), (*scene.findings, *scene.shelf.findings))


def _joined(node: str, primitive: str) -> str:
    return f"{node}/{primitive}" if primitive else node


def _nodes(document: Document) -> Iterator[tuple[Json, Array]]:
    """Yield the nodes of the scene and their transforms to the world ``(4, 4)``."""
    nodes = objects(document.root, "nodes")
    if "scene" in document.root or document.root.get("scenes"):
        roots = listed(document.one("scenes", whole(document.root, "scene", 0)), "nodes")
    else:
        children = {c for node in nodes for c in listed(node, "children") if isinstance(c, int)}
        roots = [i for i in range(len(nodes)) if i not in children]
    seen = set()
    waiting = [(index, np.eye(4)) for index in reversed(roots)]
    while waiting:
        index, above = waiting.pop()
        node = document.one("nodes", whole({"node": index}, "node"))
        if index in seen:
            raise UserError(f"glTF: node {index} stands below more than one other, or below itself. Export it anew.")
        seen.add(index)
        with np.errstate(over="ignore", invalid="ignore"):
            world = above @ _transform(node)
        if not np.isfinite(world).all():
            raise UserError(f"glTF: the transform of node {index} leaves the range of numbers. Export it in another unit.")
        yield node, world
        waiting += [(child, world) for child in reversed(listed(node, "children"))]


def _transform(node: Json) -> Array:
    """Return a node's own transform ``(4, 4)``."""
    if "matrix" in node:
        return np.asarray(numbers(node, "matrix", [0.0] * 16).reshape(4, 4).T)
    translation, scale = numbers(node, "translation", [0.0] * 3), numbers(node, "scale", [1.0] * 3)
    rotation = numbers(node, "rotation", [0.0, 0.0, 0.0, 1.0])
    return np.asarray(_composed(translation[np.newaxis], rotation[np.newaxis], scale[np.newaxis])[0])


def _composed(translation: Array, rotation: Array, scale: Array) -> Array:
    """Return transforms ``(n, 4, 4)`` of translations, unit quaternions (x, y, z, w) and scales."""
    x, y, z, w = (rotation / np.maximum(np.linalg.norm(rotation, axis=-1, keepdims=True), 1e-30)).T
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    whole_transform = np.tile(np.eye(4), (len(translation), 1, 1))
    whole_transform[:, :3, :3] = np.moveaxis(turn, -1, 0) * scale[:, np.newaxis]
    whole_transform[:, :3, 3] = translation
    return whole_transform


def _instances(document: Document, node: Json, world: Array) -> Array:
    """Return the transforms ``(n, 4, 4)`` at which a node's mesh stands: one, but for EXT_mesh_gpu_instancing."""
    told = inner(node, "extensions")
    if "EXT_mesh_gpu_instancing" not in told:
        return world[np.newaxis]
    attributes = inner(inner(told, "EXT_mesh_gpu_instancing"), "attributes")
    given = {
        key: document.accessor(whole(attributes, key), (width,))
        for key, width in (("TRANSLATION", 3), ("ROTATION", 4), ("SCALE", 3))
        if key in attributes
    }
    counts = {len(values) for values in given.values()}
    if len(counts) != 1 or not all(np.isfinite(values).all() for values in given.values()):
        raise UserError(
            "glTF: EXT_mesh_gpu_instancing should have as many of each attribute, all finite. Export without it."
        )
    count = counts.pop()
    found = _composed(
        given.get("TRANSLATION", np.zeros((count, 3))),
        given.get("ROTATION", np.tile([0.0, 0.0, 0.0, 1.0], (count, 1))),
        given.get("SCALE", np.ones((count, 3))),
    )
    return np.asarray(world @ found)


def _placed(surface: Surface, transform: Array) -> Surface:
    """Move a surface; where its transform mirrors, its triangles are wound the other way, so that outside stays outside."""
    linear = transform[:3, :3]
    mirrored = np.linalg.det(linear / max(float(np.abs(linear).max()), 1e-300)) < 0.0
    normals = surface.normals
    if normals is not None:
        # The cofactors are the inverse transposed but for a factor, and exist for flattened shapes too.
        a, b, c = linear / max(float(np.abs(linear).max()), 1e-300)
        cofactors = np.array([np.cross(b, c), np.cross(c, a), np.cross(a, b)])
        turned = normals @ (-cofactors if mirrored else cofactors).T
        # A wrong length stays to be told.
        length = np.linalg.norm(normals, axis=-1) / np.maximum(np.linalg.norm(turned, axis=-1), 1e-300)
        normals = turned * length[:, np.newaxis]
    return replace(
        surface,
        positions=surface.positions @ linear.T + transform[:3, 3],
        normals=normals,
        triangles=surface.triangles[:, ::-1] if mirrored else surface.triangles,
    )


def _mesh(scene: _Scene, index: int) -> list[Surface]:
    """Return a mesh's primitives, read once."""
    if index not in scene.meshes:
        values = scene.document.one("meshes", index)
        primitives = objects(values, "primitives")
        label = name_of(values, f"mesh {index}")
        if any(weight != 0 for weight in listed(values, "weights")):
            scene.tell(label, "morph targets", 1, "its morph targets are not applied. Export the shape that is meant.")
        found = []
        for i, primitive in enumerate(primitives):
            name = _primitive_name(scene.document, primitive, i) if len(primitives) > 1 else ""
            surface = _primitive(scene, primitive, name, _joined(label, name))
            if surface is not None:
                found.append(surface)
        scene.meshes[index] = found
    return scene.meshes[index]


def _primitive_name(document: Document, primitive: Json, index: int) -> str:
    default = f"primitive {index}"
    return name_of(document.one("materials", whole(primitive, "material")), default) if "material" in primitive else default


def _primitive(scene: _Scene, primitive: Json, name: str, label: str) -> Surface | None:
    """Return a primitive as a surface, None where it is no triangles."""
    document, attributes = scene.document, inner(primitive, "attributes")
    mode = whole(primitive, "mode", _TRIANGLES)
    if mode < _TRIANGLES or "POSITION" not in attributes:
        scene.tell(label, "no triangles", 1, "a primitive of points, lines or nothing, left out.")
        return None
    place = whole(attributes, "POSITION")
    compressed = [e for e in inner(primitive, "extensions") if "draco" in e]
    if compressed and "bufferView" not in document.one("accessors", place):
        raise UserError(f"glTF: its data are compressed by {compressed[0]}. Export without compression.")
    positions = document.accessor(place, (3,))
    triangles = _triangles(document, primitive, mode, len(positions))
    read_of = {key: widths for key, widths in (("NORMAL", (3,)), ("COLOR_0", (3, 4))) if key in attributes}
    given = {key: document.accessor(whole(attributes, key), widths) for key, widths in read_of.items()}
    colour = given.get("COLOR_0")
    look = gltf_material.look(document, primitive, scene.shelf, label)
    scene.findings += look.findings
    uv = document.accessor(whole(attributes, look.coordinates), (2,)) if look.coordinates in attributes else None
    for key, values in (*given.items(), (look.coordinates, uv)):
        if values is not None and len(values) != len(positions):
            raise UserError(f"glTF: {label!r} has {len(values)} of {key}. Should have {len(positions)}. Export it anew.")
    albedo = None if look.colour is None else np.tile(look.colour, (len(positions), 1))
    if colour is not None:
        albedo = colour[:, :3] * (1.0 if albedo is None else albedo)
    return Surface(
        name,
        positions,
        triangles,
        given.get("NORMAL"),
        albedo,
        None if uv is None else look.placed(uv),
        None if uv is None else look.texture,
        None if uv is None else look.relief,
    )


def _triangles(document: Document, primitive: Json, mode: int, count: int) -> Index:
    """Return a primitive's triangles ``(t, 3)``, whatever way it lists them."""
    if "indices" in primitive:
        given = document.accessor(whole(primitive, "indices"), (1,))[:, 0]
        listing: Index = np.where((given == np.floor(given)) & (np.abs(given) < 2**53), given, -1.0).astype(np.int64)
    else:
        listing = np.arange(count)
    if mode == _TRIANGLES:
        if len(listing) % 3:
            raise UserError(f"glTF: {len(listing)} indices of triangles. Should be a multiple of 3. Export it anew.")
        return np.asarray(listing.reshape(-1, 3))
    i = np.arange(max(len(listing) - 2, 0))
    if mode == _STRIP:
        return np.asarray(listing[np.stack([i, i + 1 + i % 2, i + 2 - i % 2], axis=-1)])
    if mode == _FAN:
        return np.asarray(listing[np.stack([i + 1, i + 2, 0 * i], axis=-1)])
    raise UserError(f"glTF: a primitive of mode {mode}. Should be 4, 5 or 6. Export it as triangles.")


def beside(path: Path) -> tuple[Path, ...]:
    """Return the files of buffers and images that a glTF file names."""
    document = load(path)
    named = [values for kind in ("buffers", "images") for values in objects(document.root, kind) if "uri" in values]
    return tuple(found for found in map(document.data, named) if isinstance(found, Path))


FORMAT = Format("glTF 2.0", "y", read, beside)
