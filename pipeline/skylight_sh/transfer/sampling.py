"""Directions for the hemisphere above a vertex: a cosine-weighted Fibonacci set, spun at random for each vertex."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_GOLDEN = np.pi * (3.0 - np.sqrt(5.0))


def cosine_fibonacci(count: int, start: float = 0.5, spin: float = 0.0) -> Array:
    """Return ``count`` unit vectors ``(count, 3)`` above the plane z = 0, with density cos / pi.

    A sunflower's lattice in the disc, lifted to the sphere (Malley's method); ``start`` from 0 to 1 shifts it along its
    spiral, ``spin`` turns it, in radians.

    >>> float(cosine_fibonacci(1000)[:, 2].mean().round(4))  # of cos, under the density cos / pi: 2/3
    0.6667
    """
    k = np.arange(count) + start
    square = k / count
    radius, angle = np.sqrt(square), _GOLDEN * k + spin
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), np.sqrt(1.0 - square)], axis=-1)


@dataclass(frozen=True)
class Cells:
    """A fine lattice of ``directions`` ``(n, 3)``, grouped into the cells of a coarse one.

    ``middles`` ``(cells, 2)`` are the coarse points in the disc below, ``cell`` ``(n,)`` is each direction's cell, and
    ``first`` ``(cells,)`` one of its directions, drawn at random.
    """

    directions: Array
    middles: Array
    cell: Index
    first: Index


def cells(count: int, each: int, random: np.random.Generator) -> Cells:
    """Return a cosine-weighted lattice of ``count`` cells, ``each`` of so many directions on average.

    Cells are those of the nearest coarse point in the disc below, where the cosine-weighted measure is even. Both lattices
    are shifted and spun at random.
    """
    coarse = cosine_fibonacci(count, random.random(), 2.0 * np.pi * random.random())[:, :2]
    fine = cosine_fibonacci(count * each, random.random(), 2.0 * np.pi * random.random())
    cell = np.asarray(cKDTree(coarse).query(fine[:, :2])[1])
    # A cell that holds no direction, at the rim, takes the nearest one; the others take any of theirs.
    first = np.array(cKDTree(fine[:, :2]).query(coarse)[1])
    order = random.permutation(count * each)
    first[cell[order]] = order
    return Cells(fine, coarse, cell, first)


def nearest(of: Cells, among: Cells, count: int) -> Index:
    """Return for each cell the ``count`` nearest ones of another lattice, ``(cells, count)``."""
    _, found = cKDTree(among.middles).query(of.middles, k=min(count, len(among.middles)))
    return np.asarray(found).reshape(len(of.middles), -1)


def frames(normals: Array, spins: Array) -> Array:
    """Return orthonormal frames ``(n, 3, 3)`` whose third column is the unit normal, turned about it by ``spins`` radians.

    The columns are tangent, bitangent and normal, right-handed. No direction is special but for the sign of z.
    """
    x, y, z = np.moveaxis(normals, -1, 0)
    sign = np.where(z >= 0.0, 1.0, -1.0)
    a = -1.0 / (sign + z)
    b = x * y * a
    one = np.stack([1.0 + sign * x * x * a, sign * b, -sign * x], axis=-1)
    other = np.stack([b, sign + y * y * a, -y], axis=-1)
    cos, sin = np.cos(spins)[:, np.newaxis], np.sin(spins)[:, np.newaxis]
    return np.stack([cos * one + sin * other, cos * other - sin * one, normals], axis=-1)


def chunks(count: int, size: int) -> list[slice]:
    """Return slices that cover ``count`` things, ``size`` at a time: what is random is drawn anew for each of them."""
    return [slice(start, min(start + size, count)) for start in range(0, count, size)]


def generator(seed: int, purpose: int, first: int) -> np.random.Generator:
    """Return the random numbers of the chunk that begins at ``first``: the same, whoever computes it and after whatever."""
    return np.random.default_rng([seed, purpose, first])
