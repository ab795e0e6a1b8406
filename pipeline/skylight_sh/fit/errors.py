"""The paper's error measures (Habel et al. 2008, eqs. 2 and 3) and the conventions they need."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import SupportsFloat

import numpy as np
from numpy.typing import NDArray

from skylight_sh.reproducible import significant

Array = NDArray[np.float64]


# L_min is recorded to half of 2**-13 of itself: its minimiser's last bits are the processor's.
_L_MIN_BITS = 14


@dataclass(frozen=True)
class Reference:
    """What errors are measured against, for ``n`` parameter sets.

    ``parameters`` ``(n, axes)``; ``weights`` ``(n, channels, count)``; ``degrees`` ``(count,)``, rising;
    ``least`` ``(n,)``, the least luminance of each set's upper hemisphere, and ``mean``, its mean.
    """

    parameters: Array
    weights: Array
    degrees: NDArray[np.int64]
    least: Array
    mean: Array

    @property
    def l_min(self) -> dict[str, Array]:
        """The denominator of E_max and E_mean for each convention's name, shape ``(n,)``.

        A light whose least radiance is not positive has its mean radiance instead, under the name ``mean``.
        """
        return l_min(self.least, self.mean)

    @property
    def headline(self) -> Array:
        """The denominator of the first convention, which headlines use, ``(n,)``."""
        return next(iter(self.l_min.values()))

    def some(self, each: int) -> Reference:
        """Return one in ``each`` of the sets."""
        part = slice(None, None, each)
        return Reference(self.parameters[part], self.weights[part], self.degrees, self.least[part], self.mean[part])

    def first_bands(self, bands: int) -> NDArray[np.int64]:
        """Return the positions of the weights of the first ``bands`` bands."""
        return np.flatnonzero(self.degrees < bands)

    def windowed(self, bands: int, window: Array) -> Reference:
        """Return what a table of ``bands`` bands is measured against: its own weights, times a ``window`` ``(count,)``."""
        use = self.first_bands(bands)
        return replace(self, weights=self.weights[..., use] * window, degrees=self.degrees[use])


def l_min(least: Array, mean: Array) -> dict[str, Array]:
    """Return the denominators of E_max and E_mean, ``(n,)``, by convention: of least and mean luminances ``(n,)``.

    Where a least luminance is not positive, the mean is the only convention. Rounded to 14 bits, 6e-5 of themselves.

    >>> {name: values.tolist() for name, values in l_min(np.array([1.0, 2.0]), np.array([4.0, 8.0])).items()}
    {'per-set': [1.0, 2.0], 'global': [1.0, 1.0]}
    """
    if np.any(least <= 0.0):
        return {"mean": significant(mean, _L_MIN_BITS)}
    rounded = significant(least, _L_MIN_BITS)
    return {"per-set": rounded, "global": np.full(least.shape, rounded.min())}


def published(value: SupportsFloat) -> float:
    """Return a figure as it is published, to four digits: far above what differs from machine to machine.

    >>> published(0.0012345678)
    0.001235
    """
    return float(f"{float(value):.4g}")


def e_mean(residual: Array, l_min: Array) -> float:
    """Return the largest E_mean (eq. 3) of residuals ``(n, channels, count)`` over ``l_min`` ``(n,)``.

    >>> e_mean(np.array([[[3.0, 4.0]]]), np.array([10.0]))
    0.5
    """
    return float(e_means(residual, l_min).max())


def e_means(residual: Array, l_min: Array) -> Array:
    """Return each set's and channel's E_mean (eq. 3), ``(n, channels)``; arguments as ``e_mean``.

    >>> e_means(np.array([[[3.0, 4.0]]]), np.array([10.0])).tolist()
    [[0.5]]
    """
    return np.asarray(norms(residual) / l_min[:, np.newaxis])


def norms(residual: Array) -> Array:
    """Return the root of the sum of squares over the weights ``(..., count)``: E_mean of residuals in units of L_min.

    >>> norms(np.array([[3.0, 4.0]])).tolist()
    [5.0]
    """
    return np.asarray(np.sqrt(np.square(residual).sum(axis=-1)))


def by_band(residual: Array, degrees: NDArray[np.int64], bands: int) -> tuple[Array, Array]:
    """Sum residuals ``(..., count)`` over the first 1, 2, .. ``bands`` bands.

    Returns the sums of magnitudes and the roots of the sums of squares, shape ``(..., bands)``: E_max and E_mean
    before division by L_min.

    >>> magnitudes, roots = by_band(np.array([2.0, -3.0, 6.0]), np.array([0, 1, 1]), 2)
    >>> magnitudes.tolist(), roots.tolist()
    ([2.0, 11.0], [2.0, 7.0])
    """
    starts = np.searchsorted(degrees, np.arange(bands))
    absolute, squares = (np.add.reduceat(x, starts, axis=-1) for x in (np.abs(residual), residual * residual))
    return np.cumsum(absolute, axis=-1), np.sqrt(np.cumsum(squares, axis=-1))


def mean_luminance(first_weights: Array, luminance_row: Array) -> Array:
    """Return the mean luminance over the upper hemisphere, ``(n,)``, from the l = 0 weights ``(n, channels)``.

    >>> float(mean_luminance(np.array([[np.sqrt(np.pi)]]), np.ones(1)).round(12)[0])
    1.0
    """
    return np.asarray(first_weights @ luminance_row * np.sqrt(4 * np.pi) / (2 * np.pi))
