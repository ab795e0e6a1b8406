"""Windows against ringing, as factors of a degree, and the paper's zonal one."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh import runtime
from skylight_sh.sphere._orders import check_bands

Array = NDArray[np.float64]


def zonal_sinc(bands: int) -> Array:
    """Return the factors of the zonal window ``sinc(pi l / N)``, m = 0 alone (Habel et al. 2008, eq. 5).

    Shape ``(N*N,)`` in flat order; every order m != 0 keeps its weight. The paper's sinc is
    ``sin(x)/x``: a box filter in the zenith angle, which is where the sky jumps.

    >>> zonal_sinc(2).round(4).tolist()
    [1.0, 1.0, 0.6366, 1.0]
    """
    check_bands(bands)
    return runtime.zonal_sinc(bands)


def sinc_window(bands: int, *, cutoff: float | None = None, power: float = 1.0) -> Array:
    """Return ``sinc(pi l / cutoff)**power`` for every degree, ``(N,)``; see ``scale_degrees``.

    ``cutoff`` is the degree where it falls to 0, N if left out, and everything from there on stays 0; ``power``, at least
    0, is how many times it blurs (Sloan 2008, "Stupid Spherical Harmonics Tricks", windowing). Raises ValueError for a
    cutoff or power out of range.

    >>> sinc_window(3).round(4).tolist()
    [1.0, 0.827, 0.4135]
    """
    if not 0 <= power < np.inf:
        raise ValueError(f"Invalid power {power!r}. Should be a finite number of at least 0.")
    place = _places(bands, cutoff)
    factors = np.clip(np.sinc(place), 0.0, 1.0) ** power
    return np.where(place < 1, factors, 0.0)


def lanczos_window(bands: int, *, cutoff: float | None = None) -> Array:
    """Return Lanczos' sigma factors ``sin(x) / x``, x = pi l / cutoff, ``(N,)``: ``sinc_window`` of power 1.

    As Sloan 2008 has it under this name.

    >>> lanczos_window(2).round(4).tolist()
    [1.0, 0.6366]
    """
    return sinc_window(bands, cutoff=cutoff)


def hann_window(bands: int, *, cutoff: float | None = None) -> Array:
    """Return the Hann window ``(1 + cos(pi l / cutoff)) / 2``, 0 from the cutoff on, ``(N,)`` (Sloan 2008).

    Raises ValueError for a cutoff out of range; it is N if left out.

    >>> hann_window(3).round(4).tolist()
    [1.0, 0.75, 0.25]
    """
    place = _places(bands, cutoff)
    return np.where(place < 1, np.cos(0.5 * np.pi * np.minimum(place, 1.0)) ** 2, 0.0)


def laplacian_window(bands: int, smoothing: ArrayLike) -> Array:
    """Return ``1 / (1 + smoothing * l**2 (l+1)**2)`` for every degree: ``smoothing (...)`` -> ``(..., N)``.

    The minimiser of the squared error plus ``smoothing`` times the squared Laplacian (Sloan 2008, windowing): 0 keeps
    everything, infinity the mean alone. Raises ValueError where the smoothing is negative or NaN.

    >>> laplacian_window(3, 0.1).round(4).tolist()
    [1.0, 0.7143, 0.2174]
    """
    check_bands(bands)
    known = np.asarray(smoothing, dtype=np.float64)
    if not np.all(known >= 0):
        raise ValueError(f"Invalid smoothing {float(known[~(known >= 0)].flat[0])!r}. Should be a number of at least 0.")
    l = np.arange(bands)
    with np.errstate(invalid="ignore"):
        rough = known[..., np.newaxis] * np.square(l * (l + 1.0))
    # Infinity times the mean's roughness of 0.
    return 1 / (1 + np.where(l == 0, 0.0, rough))


def _places(bands: int, cutoff: float | None) -> Array:
    check_bands(bands)
    end = float(bands if cutoff is None else cutoff)
    if not 0 < end < np.inf:
        raise ValueError(f"Invalid cutoff {cutoff!r}. Should be a finite degree above 0, such as the number of bands.")
    return np.arange(bands) / end
