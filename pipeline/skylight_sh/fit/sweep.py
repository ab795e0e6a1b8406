"""Errors of every combination of degrees and bands, from one nested fit."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.errors import Reference, by_band
from skylight_sh.fit.tensor_product import products

Array = NDArray[np.float64]
Floats = NDArray[np.floating]
_POINTS_AT_ONCE = 256


@dataclass(frozen=True)
class Worst:
    """The largest errors over all sets, for each combination of degrees, band count and channel.

    ``e_max`` and ``e_mean``: one array ``(combinations, channels, bands)`` for each L_min convention; ``at`` the index of
    the set where ``e_mean`` is largest; ``rel_l2`` likewise without a convention.
    """

    degrees: list[tuple[int, ...]]
    e_max: dict[str, Array]
    e_mean: dict[str, Array]
    at: dict[str, NDArray[np.int64]]
    rel_l2: Array


def sweep(
    coefficients: Array,
    vanders: Sequence[Floats],
    factor: Array,
    waves: Array,
    reference: Reference,
    degrees: Sequence[Sequence[int]],
    bands: int,
) -> Worst:
    """Measure every combination of ``degrees`` (a list an axis) for the first 1..``bands`` bands.

    ``coefficients`` ``(classes, count, d_1+1, .., d_D+1)`` belong to a nested basis; ``vanders[a]`` ``(n, d_a+1)`` is the
    basis at each set's value; ``factor`` ``(n, channels, classes)`` is what each channel takes of each class's polynomial,
    ``waves`` ``(n, count)`` what each weight is multiplied with. The degree of the first axis grows fastest and only its
    newest terms are evaluated, so the sweep costs little more than its largest fit.
    """
    use = reference.first_bands(bands)
    truth = reference.weights[..., use]
    coefficients, waves = coefficients[:, use], waves[:, use]
    outer = list(itertools.product(*degrees[1:]))
    combinations = [(first, *rest) for rest in outer for first in degrees[0]]
    channels = truth.shape[1]
    shape = (len(combinations), channels, bands)
    l_min = reference.l_min
    result = Worst(
        combinations,
        {name: np.zeros(shape) for name in l_min},
        {name: np.full(shape, -1.0) for name in l_min},
        {name: np.zeros(shape, dtype=np.int64) for name in l_min},
        np.zeros(shape),
    )
    norms = by_band(truth, reference.degrees[use], bands)[1]
    for start in range(0, len(truth), _POINTS_AT_ONCE):
        part = slice(start, start + _POINTS_AT_ONCE)
        sliced = [v[part] for v in vanders]
        for o, rest in enumerate(outer):
            lines = np.einsum("nck,nkwi->ncwi", factor[part], _contract(coefficients, sliced[1:], rest))
            lines *= waves[part, np.newaxis, :, np.newaxis]
            residual = -truth[part]
            done = 0
            for f, first in enumerate(degrees[0]):
                new = slice(done, first + 1)
                residual = residual + np.einsum("ni,ncwi->ncw", sliced[0][:, new], lines[..., new])
                done = first + 1
                absolute, root = by_band(residual, reference.degrees[use], bands)
                _record(result, o * len(degrees[0]) + f, absolute, root, norms[part], l_min, part)
    return result


def _contract(coefficients: Array, vanders: Sequence[Floats], degrees: Sequence[int]) -> Array:
    """Sum over all axes but the first, truncated at ``degrees``: ``(n, classes, count, d_1+1)``."""
    if not vanders:
        return coefficients[np.newaxis]
    channels, count, first = coefficients.shape[:3]
    cut = coefficients[(slice(None),) * 3 + tuple(slice(d + 1) for d in degrees)]
    product = products([vander[:, : d + 1] for vander, d in zip(vanders, degrees, strict=True)])
    return (product @ cut.reshape(-1, product.shape[1]).T).reshape(-1, channels, count, first)


def _record(
    result: Worst, row: int, absolute: Array, root: Array, norms: Array, l_min: dict[str, Array], part: slice
) -> None:
    np.maximum(result.rel_l2[row], (root / np.maximum(norms, np.finfo(np.float64).tiny)).max(axis=0), out=result.rel_l2[row])
    for name, values in l_min.items():
        scale = values[part, np.newaxis, np.newaxis]
        np.maximum(result.e_max[name][row], (absolute / scale).max(axis=0), out=result.e_max[name][row])
        mean = root / scale
        place = mean.argmax(axis=0)
        largest = np.take_along_axis(mean, place[np.newaxis], axis=0)[0]
        better = largest > result.e_mean[name][row]
        result.e_mean[name][row][better] = largest[better]
        result.at[name][row][better] = (place + part.start)[better]
