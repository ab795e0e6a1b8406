"""Which real spherical harmonics are held, and their flat indices: ``l*(l+1)+m``, section "Conventions" of the README."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Index = NDArray[np.int64]


def flat_index(degree: int, order: int) -> int:
    """Return the position ``l*(l+1)+m`` of degree ``l`` and order ``m`` in a vector of SH weights.

    Raises ValueError where ``|order| > degree`` or the degree is negative.

    >>> flat_index(0, 0), flat_index(1, -1), flat_index(2, 0)
    (0, 1, 6)
    """
    if degree < 0 or abs(order) > degree:
        raise ValueError(f"No spherical harmonic has degree {degree} and order {order}: |m| must not exceed l >= 0.")
    return degree * (degree + 1) + order


@dataclass(frozen=True)
class Harmonics:
    """Which real spherical harmonics are held, in flat order: all of the first ``bands`` bands, or those even in y alone.

    A function even in y, which is mirror-symmetric about phi = 0 (``mirrored``), has no other orders than m >= 0. Raises
    ValueError where ``bands`` is no whole number of at least 1.

    >>> Harmonics(3).count, Harmonics.even(3).count
    (9, 6)
    >>> Harmonics(2).orders.tolist(), Harmonics.even(2).orders.tolist()
    ([0, -1, 0, 1], [0, 0, 1])
    """

    bands: int
    mirrored: bool = False

    def __post_init__(self) -> None:
        check_bands(self.bands)

    @classmethod
    def even(cls, bands: int) -> Harmonics:
        """Return those even in y of ``bands`` bands: the orders m >= 0."""
        return cls(bands, mirrored=True)

    @classmethod
    def of_degrees(cls, degrees: Index) -> Harmonics:
        """Return those whose degrees in flat order are ``degrees`` ``(count,)``. Raises ValueError where none are.

        >>> Harmonics.of_degrees(np.array([0, 1, 1]))
        Harmonics(bands=2, mirrored=True)
        """
        bands = int(degrees.max(initial=0)) + 1
        for found in (cls(bands), cls.even(bands)):
            if np.array_equal(found.degrees, degrees):
                return found
        raise ValueError(
            f"{degrees.size} weights of degrees up to {bands - 1} are neither all orders m of these nor all m >= 0."
        )

    @property
    def count(self) -> int:
        """Number of SH weights: N*N, or N(N+1)/2 for m >= 0 alone."""
        return self.bands * (self.bands + 1) // 2 if self.mirrored else self.bands * self.bands

    @property
    def sides(self) -> tuple[float, ...]:
        """Signs of the azimuths at which a function must be known: those above 0 alone where it is even in y, or both."""
        return (1.0,) if self.mirrored else (1.0, -1.0)

    @property
    def degrees(self) -> Index:
        """Degree l of each weight, ``(count,)``, read-only."""
        return _places(self)[0]

    @property
    def orders(self) -> Index:
        """Order m of each weight, ``(count,)``, read-only."""
        return _places(self)[1]

    @property
    def flat(self) -> Index:
        """Place l*(l+1)+m of each weight among all N*N, ``(count,)``, read-only."""
        return _places(self)[2]

    @property
    def triangle(self) -> Index:
        """Row l(l+1)/2 + |m| of each weight's factor in ``legendre``, ``(count,)``, read-only."""
        return _places(self)[3]

    def first(self, bands: int) -> Harmonics:
        """Return those of the first ``bands`` bands, whose weights come first.

        >>> Harmonics.even(7).first(4)
        Harmonics(bands=4, mirrored=True)
        """
        return Harmonics(bands, self.mirrored)

    def unmirror(self, weights: NDArray[np.floating]) -> NDArray[np.floating]:
        """Spread weights ``(..., count)`` over all N*N, with exact zeros at m < 0 where those are not held.

        Raises ValueError where the last axis has another size.

        >>> Harmonics.even(2).unmirror(np.array([1.0, 2.0, 3.0])).tolist()
        [1.0, 0.0, 2.0, 3.0]
        """
        if weights.shape[-1] != self.count:
            held = "of order m >= 0" if self.mirrored else "of all orders"
            raise ValueError(
                f"{self.bands} bands have {self.count} weights {held}, but the last axis holds {weights.shape[-1]}."
            )
        if not self.mirrored:
            return weights
        full = np.zeros((*weights.shape[:-1], self.bands * self.bands), dtype=weights.dtype)
        full[..., self.flat] = weights
        return full


@lru_cache(maxsize=128)
def _places(harmonics: Harmonics) -> tuple[Index, Index, Index, Index]:
    pairs = [(l, m) for l in range(harmonics.bands) for m in range(0 if harmonics.mirrored else -l, l + 1)]
    l, m = np.ascontiguousarray(np.array(pairs, dtype=np.int64).T)
    found = (l, m, l * (l + 1) + m, l * (l + 1) // 2 + np.abs(m))
    for array in found:
        array.flags.writeable = False
    return found


def as_harmonics(harmonics: Harmonics | int) -> Harmonics:
    """Return ``harmonics``; a number of bands stands for all orders of these.

    >>> as_harmonics(4)
    Harmonics(bands=4, mirrored=False)
    """
    return harmonics if isinstance(harmonics, Harmonics) else Harmonics(harmonics)


def check_bands(bands: int) -> None:
    """Raise ValueError unless ``bands`` is a whole number of at least 1.

    >>> check_bands(0)
    Traceback (most recent call last):
        ...
    ValueError: Invalid number of bands 0. Should be an integer of at least 1.
    """
    if isinstance(bands, bool) or not isinstance(bands, int | np.integer) or bands < 1:
        raise ValueError(f"Invalid number of bands {bands!r}. Should be an integer of at least 1.")


def check_finite(what: str, values: NDArray[np.floating]) -> None:
    """Raise ValueError unless all ``values`` are finite."""
    if not np.all(np.isfinite(values)):
        raise ValueError(f"Invalid {what} {float(values[~np.isfinite(values)].flat[0])!r}. Should be finite.")


def bands_of(weights: NDArray[np.floating]) -> int:
    """Return N of weights ``(..., N*N)``. Raises ValueError where the last axis holds no square number.

    >>> bands_of(np.zeros((3, 49)))
    7
    """
    shape = np.shape(weights)
    size = int(shape[-1]) if shape else 0
    bands = math.isqrt(size)
    if bands < 1 or bands * bands != size:
        raise ValueError(f"{size} weights are not a square number N*N of bands. Should be the last axis, 1, 4, 9, ... long.")
    return bands
