"""Spherical harmonics: basis, indices, rotations, windows, convolutions and products. Pure numerics."""

from pipeline.sphere._axes import change_axes
from pipeline.sphere._basis import basis, evaluate, legendre, spiral
from pipeline.sphere._convolution import (
    clamped_cosine,
    convolve,
    dot,
    irradiance,
    nonnegative_irradiance,
    packed_irradiance,
    scale_degrees,
)
from pipeline.sphere._general import rotate, rotation_blocks
from pipeline.sphere._ground import add_ground, lower_hemisphere, mirror_ground
from pipeline.sphere._indexing import bands_of, check_bands, count, degrees_orders, flat_index, unmirror
from pipeline.sphere._nonnegative import minimum, smallest_window
from pipeline.sphere._occlusion import cover, horizon
from pipeline.sphere._product import Gaunt, gaunt, multiplication, product
from pipeline.sphere._rotation import rotate_azimuth, rotate_y, rotate_zyz, zyz_matrix
from pipeline.sphere._windows import hann_window, lanczos_window, laplacian_window, sinc_window, zonal_sinc
from pipeline.sphere._zonal import aim, cap

__all__ = [
    "Gaunt",
    "add_ground",
    "aim",
    "bands_of",
    "basis",
    "cap",
    "change_axes",
    "check_bands",
    "clamped_cosine",
    "convolve",
    "count",
    "cover",
    "degrees_orders",
    "dot",
    "evaluate",
    "flat_index",
    "gaunt",
    "hann_window",
    "horizon",
    "irradiance",
    "lanczos_window",
    "laplacian_window",
    "legendre",
    "lower_hemisphere",
    "minimum",
    "mirror_ground",
    "multiplication",
    "nonnegative_irradiance",
    "packed_irradiance",
    "product",
    "rotate",
    "rotate_azimuth",
    "rotate_y",
    "rotate_zyz",
    "rotation_blocks",
    "scale_degrees",
    "sinc_window",
    "smallest_window",
    "spiral",
    "unmirror",
    "zonal_sinc",
    "zyz_matrix",
]
