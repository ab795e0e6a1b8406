"""What errors of a light's SH weights do to a picture, without rendering it again.

A picture through transfer is linear in the light's weights: pixel = albedo * (transfer . weights). The sum of its squares
is hence a quadratic form of the weights, a matrix for each channel, and a picture of many thousand pixels tells the error of
any light's weights by one product.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# Pixels summed at once, in their order, so that the sum hangs on the picture alone.
_BLOCK = 4096


def gram(transfer: NDArray[np.floating], albedo: NDArray[np.floating]) -> Array:
    """Return the form ``(channels, N*N, N*N)`` of a picture: mean squares over its pixels are ``w @ form @ w``.

    ``transfer`` ``(pixels, channels, N*N)`` or, of no colour, ``(pixels, 1, N*N)``; ``albedo`` ``(pixels, channels)``.

    >>> one = gram(np.array([[[2.0, 0.0, 1.0, 0.0]]]), np.array([[0.5]]))
    >>> weights = np.array([1.0, 9.0, 4.0, 9.0])
    >>> float(weights @ one[0] @ weights)  # half of 2 + 4, squared
    9.0
    """
    channels, count = albedo.shape[1], transfer.shape[-1]
    total = np.zeros((channels, count, count))
    for start in range(0, len(albedo), _BLOCK):
        rows = slice(start, start + _BLOCK)
        for channel in range(channels):
            of = transfer[rows, min(channel, transfer.shape[1] - 1)] * albedo[rows, channel, np.newaxis]
            total[channel] += of.T @ of
    return total / len(albedo)


def relative_rmse(form: Array, off: NDArray[np.floating], true: NDArray[np.floating]) -> Array:
    """Return the relative RMSE ``(...)`` of a picture whose light's weights are ``off`` by so much from ``true``.

    Both are ``(..., channels, M*M)`` with M no more than the form's bands; all channels count alike.
    """
    return np.sqrt(_mean_square(form, off) / _mean_square(form, true))


def difference(form: Array, off: NDArray[np.floating], true: NDArray[np.floating]) -> Array:
    """Return the relative RMSE ``(...)`` where ``off`` and ``true`` may have other numbers of bands."""
    return relative_rmse(form, _padded(off, form.shape[-1]), _padded(true, form.shape[-1]))


def _mean_square(form: Array, weights: NDArray[np.floating]) -> Array:
    count = weights.shape[-1]
    return np.asarray(np.einsum("...cw,cwv,...cv->...", weights, form[:, :count, :count], weights, optimize=True))


def _padded(weights: NDArray[np.floating], count: int) -> Array:
    wide = np.zeros((*weights.shape[:-1], count))
    wide[..., : weights.shape[-1]] = weights
    return wide
