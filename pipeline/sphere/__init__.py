"""Spherical harmonics: basis, indices, rotations and windows. Pure numerics."""

from pipeline.sphere._axes import change_axes
from pipeline.sphere._basis import basis, evaluate, legendre
from pipeline.sphere._convolution import clamped_cosine
from pipeline.sphere._ground import add_ground, lower_hemisphere, mirror_ground
from pipeline.sphere._indexing import check_bands, count, degrees_orders, flat_index, unmirror
from pipeline.sphere._rotation import rotate_azimuth, rotate_y
from pipeline.sphere._windows import zonal_sinc

__all__ = [
    "add_ground",
    "basis",
    "change_axes",
    "check_bands",
    "clamped_cosine",
    "count",
    "degrees_orders",
    "evaluate",
    "flat_index",
    "legendre",
    "lower_hemisphere",
    "mirror_ground",
    "rotate_azimuth",
    "rotate_y",
    "unmirror",
    "zonal_sinc",
]
