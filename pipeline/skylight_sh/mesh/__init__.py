"""Triangle meshes: what a scene is made of, with normals, colours and named parts."""

from skylight_sh.mesh._mesh import Mesh, Part
from skylight_sh.mesh.findings import Finding
from skylight_sh.mesh.reading import files, read

__all__ = ["Finding", "Mesh", "Part", "files", "read"]
