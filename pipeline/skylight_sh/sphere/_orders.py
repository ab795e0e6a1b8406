"""Flat indices of real spherical harmonics: ``l*(l+1)+m``, section "Conventions" of the README."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Index = NDArray[np.int64]


def flat_index(degree: int, order: int) -> int:
    """Return the position ``l*(l+1)+m`` of degree ``l`` and order ``m`` in a vector of SH weights.

    Raises ValueError where ``|order| > degree`` or the degree is negative.
    """
    if degree < 0 or abs(order) > degree:
        raise ValueError(f"No spherical harmonic has degree {degree} and order {order}: |m| must not exceed l >= 0.")
    return degree * (degree + 1) + order


def degrees_orders(bands: int, *, mirrored: bool = False) -> tuple[Index, Index]:
    """Return the degrees and orders of the first ``bands`` bands in flat order.

    Shapes are ``(bands**2,)`` each, or ``(bands*(bands+1)/2,)`` where ``mirrored`` keeps the
    orders m >= 0 alone: all that a function even in y (mirror-symmetric about phi = 0) has.
    """
    check_bands(bands)
    pairs = [(l, m) for l in range(bands) for m in range(0 if mirrored else -l, l + 1)]
    table = np.array(pairs, dtype=np.int64)
    return table[:, 0], table[:, 1]


def count(bands: int, *, mirrored: bool = False) -> int:
    """Return the number of SH weights of ``bands`` bands: N*N, or N(N+1)/2 for m >= 0 alone."""
    return bands * (bands + 1) // 2 if mirrored else bands * bands


def unmirror(weights: NDArray[np.floating], bands: int) -> NDArray[np.floating]:
    """Spread m >= 0 weights of shape ``(..., N(N+1)/2)`` over all N*N, with exact zeros at m < 0."""
    l, m = degrees_orders(bands, mirrored=True)
    if weights.shape[-1] != l.size:
        raise ValueError(
            f"{bands} bands have {l.size} weights of order m >= 0, but the last axis holds {weights.shape[-1]}."
        )
    full = np.zeros((*weights.shape[:-1], bands * bands), dtype=weights.dtype)
    full[..., l * (l + 1) + m] = weights
    return full


def check_bands(bands: int) -> None:
    """Raise ValueError unless ``bands`` is a whole number of at least 1."""
    if isinstance(bands, bool) or not isinstance(bands, int | np.integer) or bands < 1:
        raise ValueError(f"Invalid number of bands {bands!r}. Should be an integer of at least 1.")


def check_finite(what: str, values: NDArray[np.floating]) -> None:
    """Raise ValueError unless all ``values`` are finite."""
    if not np.all(np.isfinite(values)):
        raise ValueError(f"Invalid {what} {float(values[~np.isfinite(values)].flat[0])!r}. Should be finite.")


def bands_of(weights: NDArray[np.floating]) -> int:
    """Return N of weights ``(..., N*N)``. Raises ValueError where the last axis holds no square number."""
    shape = np.shape(weights)
    size = int(shape[-1]) if shape else 0
    bands = math.isqrt(size)
    if bands < 1 or bands * bands != size:
        raise ValueError(f"{size} weights are not a square number N*N of bands. Should be the last axis, 1, 4, 9, ... long.")
    return bands
