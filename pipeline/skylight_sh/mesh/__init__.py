"""Triangle meshes: what a scene is made of, with normals, colours and named parts."""

from skylight_sh.mesh._mesh import Mesh, Part

__all__ = ["Mesh", "Part"]
