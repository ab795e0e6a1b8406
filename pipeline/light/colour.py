"""Linear RGB colour spaces: matrices from CIE XYZ."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# XYZ (D65) to linear sRGB. Another rounding moves E_mean by 0.2 %, so these nine numbers are the contract.
_SRGB = (
    (3.2404542, -1.5371385, -0.4985314),
    (-0.9692660, 1.8760108, 0.0415560),
    (0.0556434, -0.2040259, 1.0572252),
)

SPACES = {"srgb": np.array(_SRGB)}


def matrix(space: str) -> Array:
    """Return the 3x3 matrix from XYZ to the linear RGB ``space``. Raises ValueError for an unknown name."""
    try:
        return SPACES[space]
    except KeyError:
        raise ValueError(f"Unknown colour space {space!r}. Should be one of: {', '.join(sorted(SPACES))}.") from None


def luminance_row(space: str) -> Array:
    """Return the factors, shape ``(3,)``, that turn linear RGB of ``space`` into luminance Y."""
    row: Array = np.linalg.inv(matrix(space))[1]
    return row
