"""Functions symmetric about an axis: the spherical cap, and any zonal weights aimed at a direction."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pipeline.sphere._basis import basis, legendre
from pipeline.sphere._convolution import scale_degrees
from pipeline.sphere._indexing import check_bands

Array = NDArray[np.float64]


def cap(half_angle: ArrayLike, bands: int) -> Array:
    """Return the zonal weights of a spherical cap: 1 within ``half_angle`` of +z, 0 beyond.

    ``half_angle`` is in radians, 0 to pi, shape ``(...)``; returns ``(..., N)``, one weight a degree. Raises ValueError
    for an angle outside the range. Everything but the cap is ``-cap``, with ``sqrt(4 pi)`` more at l = 0: a shadow.

    Closed form for any l: ``sqrt(pi / (2l+1)) (P_(l-1) - P_(l+1))`` (Mezieres and Paulin, eq. 12; Green 2003,
    ``synth_light``) loses all digits of a small cap. The difference is ``(2l+1) / (l(l+1)) sin(a) P_l^1``, a single term of
    the basis' own recurrence, of which no digit cancels.
    """
    check_bands(bands)
    angle = np.asarray(half_angle, dtype=np.float64)
    bad = ~((angle >= 0) & (angle <= np.pi))
    if np.any(bad):
        raise ValueError(f"Invalid half-angle {float(angle[bad].flat[0])!r}. Should be in radians, from 0 to pi.")
    sine = np.sin(angle)
    out = np.empty((*angle.shape, bands))
    out[..., 0] = 2 * np.sqrt(np.pi) * np.sin(0.5 * angle) ** 2
    if bands > 1:
        l = np.arange(1, bands)
        # Row l(l+1)/2 + 1 is order 1.
        first = np.moveaxis(legendre(np.cos(angle), sine, bands)[l * (l + 1) // 2 + 1], 0, -1)
        out[..., 1:] = np.sqrt(2) * np.pi * sine[..., np.newaxis] * first / np.sqrt(l * (l + 1.0))
    return out


def aim(zonal: ArrayLike, directions: Array) -> Array:
    """Turn a function symmetric about +z to ``directions``: zonal weights ``(..., N)`` -> weights ``(..., N*N)``.

    ``directions`` are unit vectors ``(..., 3)``; leading axes broadcast. ``sqrt(4 pi / (2l+1)) y_lm(direction)`` times the
    weight (Mezieres and Paulin, eq. 13): a rotation without a matrix.
    """
    known = np.asarray(zonal, dtype=np.float64)
    bands = known.shape[-1]
    l = np.arange(bands)
    return scale_degrees(basis(directions, bands), known * np.sqrt(4 * np.pi / (2 * l + 1)))
