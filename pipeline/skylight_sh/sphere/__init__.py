"""Spherical harmonics: basis, indices, rotations, windows, convolutions and products. Pure numerics.

A name is looked up in the modules below when it is asked for, so that whoever turns a few weights loads little.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from skylight_sh.sphere._basis import basis, evaluate, legendre, spiral
    from skylight_sh.sphere._convolution import (
        clamped_cosine,
        convolve,
        dot,
        irradiance,
        nonnegative_irradiance,
        packed_irradiance,
        scale_degrees,
    )
    from skylight_sh.sphere._gauss import gauss, gauss_unit
    from skylight_sh.sphere._general_rotation import change_axes, rotate, rotation_blocks
    from skylight_sh.sphere._ground import add_ground, lower_hemisphere, mirror_ground
    from skylight_sh.sphere._nonnegative import minimum, nonnegative_smoothing
    from skylight_sh.sphere._orders import Harmonics, bands_of, check_bands, flat_index
    from skylight_sh.sphere._product import Gaunt, gaunt, multiplication, product
    from skylight_sh.sphere._rotation import generator_vectors, rotate_azimuth, rotate_y, rotate_zyz, zyz_matrix
    from skylight_sh.sphere._visibility import cover, horizon
    from skylight_sh.sphere._windows import hann_window, lanczos_window, laplacian_window, sinc_window, zonal_sinc
    from skylight_sh.sphere._zonal import aim, cap

__all__ = [
    "Gaunt",
    "Harmonics",
    "add_ground",
    "aim",
    "bands_of",
    "basis",
    "cap",
    "change_axes",
    "check_bands",
    "clamped_cosine",
    "convolve",
    "cover",
    "dot",
    "evaluate",
    "flat_index",
    "gaunt",
    "gauss",
    "gauss_unit",
    "generator_vectors",
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
    "nonnegative_smoothing",
    "packed_irradiance",
    "product",
    "rotate",
    "rotate_azimuth",
    "rotate_y",
    "rotate_zyz",
    "rotation_blocks",
    "scale_degrees",
    "sinc_window",
    "spiral",
    "zonal_sinc",
    "zyz_matrix",
]

# Those come first that need the least.
_MODULES = (
    "_orders",
    "_general_rotation",
    "_basis",
    "_convolution",
    "_gauss",
    "_ground",
    "_nonnegative",
    "_product",
    "_rotation",
    "_visibility",
    "_windows",
    "_zonal",
)


def __getattr__(name: str) -> object:
    for module in _MODULES if name in __all__ else ():
        home = import_module(f"{__name__}.{module}")
        if hasattr(home, name):
            # For the next time.
            globals()[name] = getattr(home, name)
            return globals()[name]
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
