"""Glossy lobes symmetric about an axis, as what they leave of each degree of the light.

A lobe is a density on the sphere, its integral 1. Its factor of degree l is the integral of the lobe times the Legendre
polynomial P_l of the cosine to its axis: 1 at l = 0, and near 1 as long as the lobe is narrower than the degree's waves.
``sphere.scale_degrees`` applies factors (Funk and Hecke; Ramamoorthi and Hanrahan 2001, eq. 5); the lobe's own zonal weights
are ``sqrt((2l+1) / (4 pi))`` times them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh.sphere import check_bands

Array = NDArray[np.float64]

# Beyond, the Bessel functions behind it are lost, and the lobe is a mirror's: its half width is below 0.01 degrees.
SHARPEST = 1e8


def cosine_power(exponent: ArrayLike, bands: int) -> Array:
    """Return the factors ``(..., N)`` of the lobe ``(n+1) / (2 pi) max(0, cos)**n``, for real exponents n >= 0, ``(...)``.

    With I_l the integral of x**n P_l(x) over [0, 1], Bonnet's recurrence and Legendre's equation give
    ``I_l = I_(l-2) (n - l + 2) / (n + l + 1)`` from ``I_0 = 1 / (n+1)`` and ``I_1 = 1 / (n+2)``: products alone, so that no
    number of bands and no exponent loses digits. Of the exponent 1 they are ``sphere.clamped_cosine`` over pi. The lobe of
    Phong's highlight about the mirror direction (Ramamoorthi and Hanrahan 2002, Sloan, Kautz and Snyder 2002). Raises
    ValueError for an exponent below 0 or not finite.

    >>> cosine_power(1, 4).round(4).tolist()
    [1.0, 0.6667, 0.25, 0.0]
    >>> cosine_power(8.5, 3).round(4).tolist()
    [1.0, 0.9048, 0.7391]
    """
    check_bands(bands)
    n = _within("exponent", exponent, 0.0, np.inf)
    out = np.ones((*n.shape, bands))
    if bands > 1:
        out[..., 1] = (n + 1) / (n + 2)
    for l in range(2, bands):
        out[..., l] = out[..., l - 2] * (n - (l - 2)) / (n + (l + 1))
    return out


def von_mises_fisher(sharpness: ArrayLike, bands: int) -> Array:
    """Return the factors ``(..., N)`` of the lobe ``exp(k (cos - 1))`` over its integral, for a sharpness k ``(...)``.

    A spherical Gaussian. They are ratios of modified Bessel functions, ``I_(l + 1/2)(k) / I_(1/2)(k)``; that of l = 1 is
    ``coth k - 1/k``. Raises ValueError for a sharpness outside [0, 1e8].

    >>> von_mises_fisher(10.0, 3).round(4).tolist()
    [1.0, 0.9, 0.73]
    """
    # Tables are evaluated with NumPy alone, and so is a lobe that needs no more.
    from scipy.special import ive

    check_bands(bands)
    k = _within("sharpness", sharpness, 0.0, SHARPEST)[..., np.newaxis]
    # A sharpness of 0 is an even lobe: the mean alone.
    kept = np.maximum(k, 1e-30)
    ratio = ive(np.arange(bands) + 0.5, kept) / ive(0.5, kept)
    return np.where(k > 0, ratio, np.arange(bands) == 0)


def henyey_greenstein(asymmetry: ArrayLike, bands: int) -> Array:
    """Return the factors of the lobe ``(1 - g**2) / (4 pi (1 + g**2 - 2 g cos)**1.5)``: ``g**l``, ``(..., N)``.

    The asymmetry g ``(...)``, the mean of the cosine, lies between -1 and 1, both left out (Henyey and Greenstein 1941).
    Raises ValueError otherwise.

    >>> henyey_greenstein(0.5, 4).tolist()
    [1.0, 0.5, 0.25, 0.125]
    """
    check_bands(bands)
    g = np.asarray(asymmetry, dtype=np.float64)
    if not np.all(np.abs(g) < 1):
        raise ValueError(f"Invalid asymmetry {float(g[~(np.abs(g) < 1)].flat[0])!r}. Should be above -1 and below 1.")
    return np.asarray(g[..., np.newaxis] ** np.arange(bands))


def _within(name: str, value: ArrayLike, low: float, high: float) -> Array:
    known = np.asarray(value, dtype=np.float64)
    bad = ~((known >= low) & (known <= high) & np.isfinite(known))
    if np.any(bad):
        wanted = f"from {low:g} to {high:g}" if np.isfinite(high) else f"a finite number of at least {low:g}"
        raise ValueError(f"Invalid {name} {float(known[bad].flat[0])!r}. Should be {wanted}.")
    return known
