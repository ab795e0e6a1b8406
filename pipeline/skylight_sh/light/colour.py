"""Linear RGB colour spaces: matrices from CIE XYZ."""

from __future__ import annotations

import difflib
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from skylight_sh import MissingExtraError

Array = NDArray[np.float64]

# XYZ (D65) to linear sRGB. Another rounding moves E_mean by 0.2 %, so these nine numbers are the contract.
_SRGB = (
    (3.2404542, -1.5371385, -0.4985314),
    (-0.9692660, 1.8760108, 0.0415560),
    (0.0556434, -0.2040259, 1.0572252),
)
_ADAPTATION = "Bradford"


@lru_cache(maxsize=16)
def matrix(space: str) -> Array:
    """Return the 3x3 matrix from XYZ (D65) to the linear RGB ``space``: srgb, or any name that colour-science knows.

    Another space's own white stands for D65 (chromatic adaptation by Bradford's transform). Raises ValueError for an unknown
    name, MissingExtraError where the library is needed and not installed.
    """
    srgb = np.array(_SRGB)
    if space == "srgb":
        return srgb
    try:
        import colour
    except ImportError as error:
        raise MissingExtraError(
            f"The colour space {space!r} needs colour-science. Install the extra: pip install 'skylight-sh[colour]'."
        ) from error
    spaces = colour.RGB_COLOURSPACES
    if space not in spaces:
        close = difflib.get_close_matches(space, [*spaces, "srgb"], n=3, cutoff=0.3)
        raise ValueError(f"Unknown colour space {space!r}. Did you mean one of: {', '.join(close) or 'srgb'}?")
    between = colour.matrix_RGB_to_RGB(spaces["sRGB"], spaces[space], _ADAPTATION)
    return np.asarray(between @ srgb, dtype=np.float64)


def luminance_row(space: str) -> Array:
    """Return the factors, shape ``(3,)``, that turn linear RGB of ``space`` into luminance Y.

    >>> luminance_row("srgb").round(4).tolist()
    [0.2127, 0.7152, 0.0722]
    """
    row: Array = np.linalg.inv(matrix(space))[1]
    return row
