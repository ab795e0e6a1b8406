"""Formats of meshes by the ending of a file's name, one file each. What a format is, its file's first line says."""

from __future__ import annotations

from typing import TYPE_CHECKING

from skylight_sh.registry import Registry

if TYPE_CHECKING:
    from skylight_sh.mesh.formats.protocol import Format

FORMATS: Registry[Format] = Registry(
    {
        "glb": "skylight_sh.mesh.formats.gltf:FORMAT",
        "gltf": "skylight_sh.mesh.formats.gltf:FORMAT",
        "obj": "skylight_sh.mesh.formats.obj:FORMAT",
        "ply": "skylight_sh.mesh.formats.ply:FORMAT",
    }
)

__all__ = ["FORMATS"]
