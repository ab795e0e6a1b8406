"""SH weights of a picture, a block of texels at a time."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.probe.charts import Chart
from skylight_sh.probe.image_layouts.protocol import Patch
from skylight_sh.probe.layouts import most_bands, patches

Array = NDArray[np.float64]

# Floats held at once by the basis of one block of texels (32 MB).
_BLOCK = 4_000_000


def project(image: NDArray[np.floating], layout: str, bands: int, *, signed: bool = False) -> Array:
    """Return the weights ``(channels, N*N)`` of a picture ``(height, width, channels)`` of linear radiance.

    A texel stands for the mean radiance over its solid angle, which is exact (``charts``). Taken as a constant there it
    would blur the picture by one texel; taken at its centre, by half of that. So the basis is weighted with ``4/3
    y(centre) - 1/3 mean of y at the corners``: the operator dual to the mean over the texel, which undoes the blur to
    second order in the texel's size. Smooth light then converges with that size's fourth power (inside a chart); a jump,
    as at a sky's horizon, leaves a second-order error.

    Raises ValueError for a shape that the layout does not have, bands that the texels do not resolve, and a pixel that
    is NaN, infinite, or, unless ``signed``, negative. Pixels that show nothing (a cross's corners, the outside of an angular
    map's disc) are not looked at.
    """
    if image.ndim != 3 or image.shape[-1] < 1:
        raise ValueError(f"Invalid picture of shape {image.shape}. Should be (height, width, channels).")
    found = patches(layout, image.shape[0], image.shape[1])
    most = most_bands(layout, *image.shape[:2])
    if not 1 <= bands <= most:
        raise ValueError(
            f"Invalid number of bands {bands}. Should be from 1 to {most} for a {layout} picture of "
            f"{image.shape[1]}x{image.shape[0]} (width x height): ask for fewer, or take a larger picture."
        )
    weights = np.zeros((image.shape[-1], bands * bands))
    for patch in found:
        u, v = patch.edges()
        for rows in _blocks(patch, bands):
            edges = v[rows.start : rows.stop + 1]
            solid = patch.chart.solid_angles(u, edges)
            first = patch.row + rows.start
            part = image[first : first + edges.size - 1, patch.column : patch.column + patch.columns]
            # Rounding may leave a sliver of the rim below 0.
            seen = solid > 0
            _check(part, seen, (first, patch.column), signed=signed)
            flux = np.where(seen[..., np.newaxis], part, 0.0) * np.maximum(solid, 0.0)[..., np.newaxis]
            centres = (u[1:] + u[:-1]) / 2, (edges[1:] + edges[:-1]) / 2
            weights += (4.0 / 3.0) * _sum(patch.chart, *centres, flux, bands)
            # Corners are shared: each takes a quarter of the flux of its texels.
            shared = np.zeros((edges.size, u.size, image.shape[-1]))
            for down, across in ((0, 0), (0, 1), (1, 0), (1, 1)):
                shared[down : down + flux.shape[0], across : across + flux.shape[1]] += flux / 4.0
            weights -= _sum(patch.chart, u, edges, shared, bands) / 3.0
    return weights


def blur(weights: NDArray[np.floating], sigma: float) -> Array:
    """Convolve weights ``(..., N*N)`` with the sphere's Gaussian of standard deviation ``sigma`` radians.

    The heat kernel, ``exp(-l (l + 1) sigma**2 / 2)``: it keeps the light's total, is never negative, and does on the
    sphere what a Gaussian pre-filter of the picture (Green 2003) means to, alike in every direction. For a small
    ``sigma`` it is the plane's Gaussian. Raises ValueError unless ``sigma`` is finite and not negative.
    """
    if not 0.0 <= sigma < np.inf:
        raise ValueError(f"Invalid blur of {sigma} radians. Should be a finite angle of at least 0.")
    l = np.arange(sphere.bands_of(weights))
    return sphere.scale_degrees(weights, np.exp(-l * (l + 1) * sigma**2 / 2))


def _sum(chart: Chart, u: Array, v: Array, flux: Array, bands: int) -> Array:
    """Sum flux ``(rows, columns, channels)`` times the basis at the points of the grid of u and v, ``(channels, N*N)``."""
    row, column = np.nonzero(flux.any(axis=-1))
    return np.asarray(flux[row, column].T @ sphere.basis(chart.directions(u[column], v[row]), bands))


def _blocks(patch: Patch, bands: int) -> Iterator[slice]:
    """Split a patch's rows so that a block's basis and its temporaries stay within ``_BLOCK`` floats, one row at least."""
    step = max(1, _BLOCK // (patch.columns * (3 * bands * bands + 20)))
    for start in range(0, patch.rows, step):
        yield slice(start, min(start + step, patch.rows))


def _check(part: NDArray[np.floating], seen: NDArray[np.bool_], origin: tuple[int, int], *, signed: bool) -> None:
    """Raise ValueError at the first bad pixel that shows something; ``origin`` is the part's first row and column."""
    bad = ~np.isfinite(part)
    if not signed:
        bad |= part < 0
    bad &= seen[..., np.newaxis]
    if bad.any():
        row, column, channel = np.argwhere(bad)[0].tolist()
        raise ValueError(
            f"Invalid pixel at row {origin[0] + row}, column {origin[1] + column} (from 0, top left), channel {channel}: "
            f"{part[row, column, channel]}. Should be a finite radiance of at least 0. Mend it in an image editor, "
            "for example from its neighbours."
        )
