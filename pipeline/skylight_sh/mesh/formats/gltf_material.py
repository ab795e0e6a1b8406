"""Materials of glTF: base colour, its picture and the normal map, and where on a surface these lie."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh import pictures
from skylight_sh.mesh.findings import Finding
from skylight_sh.mesh.formats.gltf_file import Document, Json, inner, number, numbers, whole

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Look:
    """What a material makes of a surface: linear ``colour`` ``(3,)`` or None, pictures, and the texture coordinates' name.

    ``transform`` ``(2, 3)`` is what KHR_texture_transform makes of texture coordinates.
    """

    colour: Array | None = None
    texture: Array | None = None
    relief: Array | None = None
    coordinates: str = "TEXCOORD_0"
    transform: tuple[tuple[float, float, float], ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    findings: tuple[Finding, ...] = ()

    def placed(self, uv: Array) -> Array:
        """Return texture coordinates ``(v, 2)`` with v upwards; glTF's is downwards."""
        moved = uv @ np.array(self.transform)[:, :2].T + np.array(self.transform)[:, 2]
        return np.stack([moved[:, 0], 1.0 - moved[:, 1]], axis=-1)


def look(document: Document, primitive: Json, shelf: pictures.Shelf, part: str) -> Look:
    """Return the look of a primitive. Raises UserError where its material says what glTF does not know."""
    if "material" not in primitive:
        return Look()
    material = document.one("materials", whole(primitive, "material"))
    pbr, findings = inner(material, "pbrMetallicRoughness"), list[Finding]()
    older = inner(inner(material, "extensions"), "KHR_materials_pbrSpecularGlossiness")
    if older and not pbr:
        pbr = {"metallicFactor": 0.0}
        pbr |= {new: older[old] for old, new in _OLDER.items() if old in older}
    if pbr and "metallicRoughnessTexture" not in pbr and (metal := number(pbr, "metallicFactor", 1.0)) > 0.0:
        findings.append(_told(part, "metal", f"its material is metal to {metal:.0%}; taken as diffuse of its base colour."))
    transmits = "KHR_materials_transmission" in inner(material, "extensions")
    if transmits or material.get("alphaMode", "OPAQUE") != "OPAQUE":
        findings.append(_told(part, "transparent", "its material lets light through; taken as opaque."))
    base, bumps = inner(pbr, "baseColorTexture"), inner(material, "normalTexture")
    source = _source(document, base) if base else None
    texture = shelf.colours(part, source) if source is not None else None
    relief_source = _source(document, bumps) if bumps else None
    relief = shelf.relief(part, relief_source, number(bumps, "scale", 1.0)) if relief_source is not None else None
    if (base and source is None) or (bumps and relief_source is None):
        findings.append(
            _told(part, "no picture", "a picture in a form that is not read; it goes without. Export it as PNG.")
        )
    first = base or bumps
    if base and bumps and _lies(base) != _lies(bumps):
        findings.append(_told(part, "relief", "its normal map lies otherwise than its colours, and is left out."))
        relief = None
    coordinates, transform = _lies(first)
    colour = numbers(pbr, "baseColorFactor", [1.0] * 4)[:3]
    return Look(colour, texture, relief, coordinates, transform, tuple(findings))


_OLDER = {"diffuseFactor": "baseColorFactor", "diffuseTexture": "baseColorTexture"}


def _told(part: str, kind: str, text: str) -> Finding:
    return Finding(part, kind, 1, False, f"Part {part!r}: {text}")


def _source(document: Document, use: Json) -> bytes | Path | None:
    """Return the picture that a use of a texture means, None where it has none that can be read."""
    texture = document.one("textures", whole(use, "index"))
    if "source" not in texture:
        texture = inner(inner(texture, "extensions"), "EXT_texture_webp")
    if "source" not in texture:
        return None
    image = document.one("images", whole(texture, "source"))
    return document.view(whole(image, "bufferView"))[0] if "bufferView" in image else document.data(image)


def _lies(use: Json) -> tuple[str, tuple[tuple[float, float, float], ...]]:
    """Return which texture coordinates a use of a texture takes, and how KHR_texture_transform moves them."""
    told = inner(inner(use, "extensions"), "KHR_texture_transform")
    u, v = numbers(told, "offset", [0.0, 0.0])
    a, b = numbers(told, "scale", [1.0, 1.0])
    angle = number(told, "rotation", 0.0)
    c, s = float(np.cos(angle)), float(np.sin(angle))
    coordinates = f"TEXCOORD_{whole(told, 'texCoord', whole(use, 'texCoord', 0))}"
    return coordinates, ((c * float(a), s * float(b), float(u)), (-s * float(a), c * float(b), float(v)))
