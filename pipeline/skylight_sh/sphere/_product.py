"""Products of SH expansions by exact Gaunt coefficients: ``integral of y_i y_j y_k``, sparse and cached."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from skylight_sh.sphere._basis import legendre
from skylight_sh.sphere._gauss import gauss
from skylight_sh.sphere._orders import Harmonics, Index, bands_of, check_bands

Array = NDArray[np.float64]

# Triples integrated at once.
_CHUNK = 1 << 16
# Some triples vanish by no rule of symmetry; they come out below 4e-15, all others above 1e-6 (to 20 bands).
_ZERO = 1e-12


class Gaunt(NamedTuple):
    """The triples that do not vanish, sorted by ``out``, then ``left``, then ``right``; all arrays ``(entries,)``."""

    left: Index
    right: Index
    out: Index
    value: Array


@lru_cache(maxsize=32)
def gaunt(left_bands: int, right_bands: int, out_bands: int) -> Gaunt:
    """Return the integrals of ``y_left y_right y_out`` over the sphere that are not zero.

    Read-only arrays; flat indices ``l*(l+1)+m``. A triple vanishes unless the degrees make a triangle with an even sum,
    ``|m|`` of one is the sum or difference of the others', and an even number of orders is negative. The polar factor is
    integrated by Gauss and Legendre with as many nodes as make it exact, the azimuth in closed form: nothing but rounding
    is left. Seconds and hundreds of MB beyond 20 bands; the result is cached.

    >>> gaunt(1, 1, 1).value.round(4).tolist()
    [0.2821]
    """
    for bands in (left_bands, right_bands, out_bands):
        check_bands(bands)
    left, right, out = _candidates(left_bands, right_bands, out_bands)
    most = max(left_bands, right_bands, out_bands)
    every = Harmonics(most)
    # Degrees up to the sum's: the sines of |m| > 0 come in even powers.
    nodes, areas = gauss((left_bands + right_bands + out_bands - 3) // 2 + 1)
    factors = legendre(nodes, np.sqrt((1 - nodes) * (1 + nodes)), most)
    values = np.empty(left.size)
    for start in range(0, left.size, _CHUNK):
        part = slice(start, start + _CHUNK)
        i, j, k = (factors[every.triangle[index[part]]] for index in (left, right, out))
        values[part] = (i * j * k) @ areas
    values *= _azimuth(every.orders[left], every.orders[right], every.orders[out])
    some = np.abs(values) > _ZERO
    found = Gaunt(left[some], right[some], out[some], values[some])
    for array in found:
        array.flags.writeable = False
    return found


def product(one: NDArray[np.floating], other: NDArray[np.floating], bands: int | None = None) -> Array:
    """Return the weights of the product of two expansions, ``(..., N1*N1)`` and ``(..., N2*N2)`` -> ``(..., N*N)``.

    N is ``bands``; N1 + N2 - 1, the default, holds the product exactly, fewer its projection. Leading axes broadcast.

    >>> two = np.array([2 * np.sqrt(4 * np.pi)])
    >>> product(two, np.array([1.0, 0.0, 3.0, 0.0])).round(6).tolist()
    [2.0, 0.0, 6.0, 0.0]
    """
    first, second = bands_of(one), bands_of(other)
    bands = first + second - 1 if bands is None else bands
    table = gaunt(first, second, bands)
    terms = one[..., table.left] * other[..., table.right] * table.value
    return _gather(terms, table.out, bands * bands)


def multiplication(function: NDArray[np.floating], bands: int, out_bands: int | None = None) -> Array:
    """Return the matrix that multiplies an environment of ``bands`` bands by a function: a mask, a shadow.

    ``function`` has shape ``(..., F*F)``; returns ``(..., M*M, N*N)`` with N = ``bands`` and M = ``out_bands``, N if left
    out, so that ``matrix @ weights`` equals ``product(function, weights, M)``. Green 2003, eq. 8: the transfer matrix of
    triple products; symmetric where M = N. Beyond F + N - 1 out bands its rows are zero.

    >>> multiplication(np.array([2 * np.sqrt(4 * np.pi)]), 2).diagonal().round(6).tolist()
    [2.0, 2.0, 2.0, 2.0]
    """
    out_bands = bands if out_bands is None else out_bands
    table = gaunt(bands_of(function), bands, out_bands)
    place = table.out * bands**2 + table.right
    order = np.argsort(place, kind="stable")
    terms = function[..., table.left[order]] * table.value[order]
    flat = _gather(terms, place[order], (bands * out_bands) ** 2)
    return flat.reshape(*flat.shape[:-1], out_bands**2, bands**2)


def _gather(terms: Array, places: Index, size: int) -> Array:
    """Sum terms ``(..., entries)`` of the same place, which ascend, into ``(..., size)``."""
    out = np.zeros((*terms.shape[:-1], size))
    starts = np.flatnonzero(np.diff(places, prepend=-1))
    out[..., places[starts]] = np.add.reduceat(terms, starts, axis=-1)
    return out


def _candidates(left_bands: int, right_bands: int, out_bands: int) -> tuple[Index, Index, Index]:
    """Return the flat indices of every triple that symmetry allows."""
    lefts, rights, outs = (Harmonics(bands) for bands in (left_bands, right_bands, out_bands))
    left_l, left_m, right_l, right_m = lefts.degrees, lefts.orders, rights.degrees, rights.orders
    pieces = []
    for place, (l, m) in enumerate(zip(outs.degrees, outs.orders, strict=True)):
        degree_sum = left_l[:, np.newaxis] + right_l
        triangle = (np.abs(left_l[:, np.newaxis] - right_l) <= l) & (l <= degree_sum) & ((degree_sum + l) % 2 == 0)
        a, b, c = np.abs(left_m)[:, np.newaxis], np.abs(right_m), abs(m)
        waves = (a + b == c) | (np.abs(a - b) == c)
        sines = ((left_m < 0)[:, np.newaxis] ^ (right_m < 0)) == (m < 0)
        i, j = np.nonzero(triangle & waves & sines)
        pieces.append((i, j, np.full(i.size, place)))
    left, right, out = (np.concatenate(part).astype(np.int64) for part in zip(*pieces, strict=True))
    return left, right, out


def _azimuth(a: Index, b: Index, c: Index) -> Array:
    """Integrate cos or sin of ``|order|`` phi, cos from 0 up, three at a time: multiples of pi / 2, and exactly so."""
    exponents = []
    for order in (a, b, c):
        # exp(i|m|phi) and exp(-i|m|phi): halves for a cosine, -i/2 and i/2 for a sine.
        factor = np.where(order < 0, -0.5j, 0.5 + 0j)
        exponents.append(((np.abs(order), factor), (-np.abs(order), factor.conj())))
    total = np.zeros(a.shape, dtype=np.complex128)
    for first, x in exponents[0]:
        for second, y in exponents[1]:
            for third, z in exponents[2]:
                total += np.where(first + second + third == 0, x * y * z, 0)
    return 2 * np.pi * total.real
