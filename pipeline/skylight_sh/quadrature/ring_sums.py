"""Sums of SH weights over nodes in polar coordinates, where the basis separates into Legendre factors and waves.

A ring is a circle about the pole; ``rings`` stand in groups, and ``rows`` are a group's parameter sets times channels.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from skylight_sh.sphere import Harmonics

Array = NDArray[np.float64]

# Up to so many bands the quick recurrence loses no more than the sums do.
_FEW_BANDS = 16


def accumulate(total: Array, sides: Sequence[Array], azimuth: Array, factors: Array, harmonics: Harmonics) -> None:
    """Add weighted radiances to the SH weights ``total`` ``(groups, rows, count)`` in place.

    ``sides`` are the radiances ``(groups, rings, rows, azimuths)`` at ``azimuth`` ``(groups, rings, azimuths)`` >= 0 and,
    unless the ``harmonics`` are those even in y alone, at its negative; ``factors`` ``(N(N+1)/2, groups, rings)`` come from
    ``sphere.legendre``.
    """
    bands = harmonics.bands
    if len(harmonics.sides) == 1:
        even = cosines(azimuth, bands) if bands <= _FEW_BANDS else waves(azimuth, bands).real
        _add_orders(total, 2.0 * (sides[0] @ even), factors, bands, sign=0)
    else:
        turns = waves(azimuth, bands)
        _add_orders(total, (sides[0] + sides[1]) @ turns.real, factors, bands, sign=1)
        _add_orders(total, (sides[0] - sides[1]) @ turns.imag, factors, bands, sign=-1)


def cosines(azimuth: Array, bands: int) -> Array:
    """cos(m phi) for m < bands, ``(..., azimuths, bands)``, by Chebyshev's recurrence: rounding grows with m squared.

    >>> cosines(np.array([np.pi]), 4).tolist()
    [[1.0, -1.0, 1.0, -1.0]]
    """
    out = np.empty((bands, *azimuth.shape))
    out[0] = 1.0
    if bands > 1:
        np.cos(azimuth, out=out[1])
    twice = 2.0 * out[1:2]
    for m in range(2, bands):
        np.multiply(twice[0], out[m - 1], out=out[m])
        out[m] -= out[m - 2]
    return np.moveaxis(out, 0, -1)


def waves(azimuth: Array, bands: int) -> NDArray[np.complex128]:
    """exp(i m phi) for m < bands, ``(..., azimuths, bands)``, by doubling: rounding grows with log m.

    >>> waves(np.array([np.pi]), 4).real.tolist()
    [[1.0, -1.0, 1.0, -1.0]]
    """
    out = np.ones((*azimuth.shape[:-1], bands, azimuth.shape[-1]), dtype=np.complex128)
    if bands > 1:
        out[..., 1, :].real = np.cos(azimuth)
        out[..., 1, :].imag = np.sin(azimuth)
    known = 2
    while known < bands:
        more = min(known - 1, bands - known)
        np.multiply(out[..., 1 : 1 + more, :], out[..., known - 1 : known, :], out=out[..., known : known + more, :])
        known += more
    return out.swapaxes(-1, -2)


def _add_orders(total: Array, sums: Array, factors: Array, bands: int, *, sign: int) -> None:
    """Add ``sums`` ``(groups, rings, rows, orders)`` times ``factors`` to the columns of ``total``, order by order.

    ``sign`` is that of the orders, or 0 where m >= 0 are the only ones kept.
    """
    for m in range(1 if sign < 0 else 0, bands):
        l = np.arange(m, bands)
        triangle = l * (l + 1) // 2 + m
        columns = l * (l + 1) + sign * m if sign else triangle
        total[:, :, columns] += sums[..., m].swapaxes(1, 2) @ factors[triangle].transpose(1, 2, 0)
