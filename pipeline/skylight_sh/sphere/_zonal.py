"""Functions symmetric about an axis: the spherical cap, and any zonal weights aimed at a direction."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh.sphere._basis import basis
from skylight_sh.sphere._convolution import convolve
from skylight_sh.sphere._orders import check_bands

Array = NDArray[np.float64]


def cap(half_angle: ArrayLike, bands: int) -> Array:
    """Return the zonal weights of a spherical cap: 1 within ``half_angle`` of +z, 0 beyond.

    ``half_angle`` is in radians, 0 to pi, shape ``(...)``; returns ``(..., N)``, one weight a degree. Raises ValueError
    for an angle outside the range. Everything but the cap is ``-cap``, with ``sqrt(4 pi)`` more at l = 0: a shadow.

    Closed form for any l: ``sqrt(pi / (2l+1)) (P_(l-1) - P_(l+1))`` (Mezieres and Paulin, eq. 12; Green 2003,
    ``synth_light``) is lost for a small cap: its terms are near 1, and it is of the order of the angle squared. By
    Legendre's equation it is ``sqrt((2l+1) / (4 pi)) pi sin(a)**2 r_l`` with ``r_l = P_l'(cos a) / (l (l+1) / 2)``, which
    starts at 1 and leaves it by steps that a recurrence in ``1 - cos a`` gives without cancellation.

    >>> cap(np.pi / 2, 2).round(4).tolist()
    [1.7725, 1.535]
    """
    check_bands(bands)
    angle = np.asarray(half_angle, dtype=np.float64)
    bad = ~((angle >= 0) & (angle <= np.pi))
    if np.any(bad):
        raise ValueError(f"Invalid half-angle {float(angle[bad].flat[0])!r}. Should be in radians, from 0 to pi.")
    # P_l' of a cap wider than a hemisphere is that of its complement, but for the sign at even l.
    wide = angle > np.pi / 2
    near = np.where(wide, np.pi - angle, angle)
    t = 2.0 * np.sin(near / 2.0) ** 2
    out = np.empty((*angle.shape, bands))
    out[..., 0] = 2 * np.sqrt(np.pi) * np.sin(angle / 2.0) ** 2
    ratio, step = np.ones_like(t), np.zeros_like(t)
    area = np.pi * np.sin(near) ** 2
    for l in range(1, bands):
        sign = np.where(wide, -1.0, 1.0) if l % 2 == 0 else 1.0
        out[..., l] = np.sqrt((2 * l + 1) / (4.0 * np.pi)) * area * ratio * sign
        step = ((l - 1) * step - (2 * l + 1) * t * ratio) / (l + 2)
        ratio = ratio + step
    return out


def aim(zonal: ArrayLike, directions: Array) -> Array:
    """Turn a function symmetric about +z to ``directions``: zonal weights ``(..., N)`` -> weights ``(..., N*N)``.

    ``directions`` are unit vectors ``(..., 3)``; leading axes broadcast. ``sqrt(4 pi / (2l+1)) y_lm(direction)`` times the
    weight (Mezieres and Paulin, eq. 13): a rotation without a matrix, the convolution of a Dirac light.

    >>> np.abs(aim(cap(np.pi / 2, 2), np.array([1.0, 0.0, 0.0]))).round(4).tolist()
    [1.7725, 0.0, 0.0, 1.535]
    """
    known = np.asarray(zonal, dtype=np.float64)
    return convolve(basis(directions, known.shape[-1]), known)
