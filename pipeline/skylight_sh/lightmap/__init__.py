"""Baked irradiance: SH of the light that falls on the texels of a lightmap, evaluated with a normal map."""

from skylight_sh.lightmap.evaluation import Lightmap, deringed, evaluate, fitted, of, shade
from skylight_sh.lightmap.files import read, write
from skylight_sh.lightmap.incident import Sampling, apply, bake, irradiance, matrices
from skylight_sh.lightmap.texels import Texels, chart, of_points, world_normals

__all__ = [
    "Lightmap",
    "Sampling",
    "Texels",
    "apply",
    "bake",
    "chart",
    "deringed",
    "evaluate",
    "fitted",
    "irradiance",
    "matrices",
    "of",
    "of_points",
    "read",
    "shade",
    "world_normals",
    "write",
]
