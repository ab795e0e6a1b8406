"""A table's errors as shipped: its own number type, evaluated in its own arithmetic."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.fit import peaks
from skylight_sh.fit.errors import Reference, by_band, e_means
from skylight_sh.runtime import Table
from skylight_sh.table import validation
from skylight_sh.table.row_layout import stored

Array = NDArray[np.float64]
Floats = NDArray[np.floating]


@dataclass(frozen=True)
class Measured:
    """Largest errors over all sets, ``(conventions, channels, bands)``, and each set's error over all the bands.

    ``at`` is the set where ``e_mean`` is largest; ``rel_l2`` has no convention; ``per_set`` ``(n,)`` is the E_mean of the
    worst channel under the first convention.
    """

    conventions: tuple[str, ...]
    e_max: Array
    e_mean: Array
    at: NDArray[np.int64]
    rel_l2: Array
    per_set: Array


def measure(table: Table, reference: Reference) -> Measured:
    """Measure ``table`` against ``reference`` for its first 1, 2, .. bands.

    Raises LightError where an error would be none: not finite, negative, or relative to no light.
    """
    use = reference.first_bands(table.bands)
    truth = reference.weights[..., use]
    residual = table.evaluate(reference.parameters).astype(np.float64) - truth
    absolute, root = by_band(residual, reference.degrees[use], table.bands)
    norm = by_band(truth, reference.degrees[use], table.bands)[1]
    l_min = reference.l_min
    validation.check_scales(l_min, reference.parameters)
    scales = [values[:, np.newaxis, np.newaxis] for values in l_min.values()]
    means = np.stack([root / scale for scale in scales])
    largest = np.stack([(absolute / scale).max(axis=0) for scale in scales])
    validation.check_errors({"E_max": largest, "E_mean": means})
    return Measured(
        conventions=tuple(l_min),
        e_max=largest,
        e_mean=means.max(axis=1),
        at=means.argmax(axis=1),
        rel_l2=(root / np.maximum(norm, np.finfo(np.float64).tiny)).max(axis=0),
        per_set=means[0, :, :, -1].max(axis=1),
    )


def least_reconstructed(table: Table, parameters: Array, luminance_row: Array) -> float:
    """Return the least luminance the table's expansion takes over its largest of the same set, the least over all sets.

    A fraction, below 0 where the expansion rings; directions are an even spiral of 2,000, sets ``(n, axes)``. Surroundings
    are in it, with the suns of the sets spread over all azimuths.
    """
    weights: Floats = table.evaluate(parameters).astype(np.float64)
    harmonics = stored(table.spec, table.bands)
    if table.surroundings:
        azimuths = (
            np.linspace(0.0, 2.0 * np.pi, len(parameters), endpoint=False)
            if table.spec.azimuth is None
            else table.spec.azimuth
        )
        turned = sphere.rotate_azimuth(table.whole(weights), np.reshape(azimuths, (-1, 1)))
        weights, harmonics = table.surroundings.apply(turned, table.bands), sphere.Harmonics(table.bands)
    basis = sphere.basis(sphere.spiral(2000), harmonics)
    luminance = np.einsum("ncw,c->nw", weights, luminance_row) @ basis.T
    return float((luminance.min(axis=1) / luminance.max(axis=1)).min())


def headline(table: Table, reference: Reference, shape: Sequence[int] = ()) -> float:
    """Return the largest E_mean over all sets and channels under the first convention, over all the table's bands.

    Where the first sets are on a grid of ``shape``, peaks are looked for between its nodes.
    """
    use = reference.first_bands(table.bands)
    residual = table.evaluate(reference.parameters).astype(np.float64) - reference.weights[..., use]
    return peaks.largest(e_means(residual, reference.headline), shape)
