"""How much an expansion rings: with each window and each ground, for each number of bands."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pipeline import sphere
from pipeline.report import panorama

Array = NDArray[np.float64]

ALBEDO = 0.25
GROUNDS: dict[str, Callable[[Array, int], Array]] = {
    "black ground": lambda weights, _: weights,
    f"ground of albedo {ALBEDO:g}": lambda weights, bands: sphere.add_ground(weights, ALBEDO, bands),
    "mirrored sky": sphere.mirror_ground,
}
LEAST = "least non-negative"


@dataclass(frozen=True)
class Ringing:
    """Figures over all sets, each ``(grounds, windows, bands)``: fractions of each set's brightest sky, or of the sphere.

    ``undershoot`` is the largest of all sets, ``area`` the largest part of the sphere that is negative, ``peak`` the
    brightest value's change, mean over sets, negative where the peak is lost. ``worst`` ``(grounds, bands)`` is the set of
    the largest undershoot without a window. The window ``LEAST``, last, is that of each ground's worst set, at that set.
    """

    bands: tuple[int, ...]
    windows: tuple[str, ...]
    undershoot: Array
    area: Array
    peak: Array
    worst: NDArray[np.int64]


def windows(bands: int) -> dict[str, Array]:
    """Return the fixed windows by name, ``(N*N,)`` each."""
    degrees, _ = sphere.degrees_orders(bands)
    return {
        "no window": np.ones(bands * bands),
        "zonal sinc (eq. 5)": sphere.zonal_sinc(bands),
        "sinc (Lanczos)": sphere.lanczos_window(bands)[degrees],
        "Hann": sphere.hann_window(bands)[degrees],
    }


def least_window(weights: Array, bands: int) -> Array:
    """Return the least window ``(N*N,)`` that leaves one expansion nowhere negative."""
    degrees, _ = sphere.degrees_orders(bands)
    return sphere.laplacian_window(bands, float(sphere.smallest_window(weights)))[degrees]


def measure(weights: Array, brightest: Array, bands: tuple[int, ...]) -> Ringing:
    """Measure ringing of luminance weights ``(sets, N*N)``, black below the horizon, against ``brightest`` ``(sets,)``.

    ``bands`` are the numbers of bands to cut to, from 2 to N.
    """
    view = panorama.directions()[:, ::4].reshape(-1, 3)
    rows = sphere.basis(view, max(bands))
    # Rows of a panorama are bands of equal altitude: their area goes with its cosine.
    areas = np.hypot(view[:, 0], view[:, 1])
    areas /= areas.sum()
    names = (*windows(1), LEAST)
    shape = (len(GROUNDS), len(names), len(bands))
    undershoot, area, peak = np.empty(shape), np.empty(shape), np.empty(shape)
    worst = np.empty((len(GROUNDS), len(bands)), dtype=np.int64)
    for b, count in enumerate(bands):
        for g, ground in enumerate(GROUNDS.values()):
            lit = ground(weights[:, : count * count], count)
            for w, window in enumerate((*windows(count).values(), None)):
                at = np.arange(len(lit)) if window is not None else worst[g, b : b + 1]
                factors = least_window(lit[at[0]], count) if window is None else window
                values = (lit[at] * factors) @ rows[:, : count * count].T
                low = -values.min(axis=1) / brightest[at]
                if w == 0:
                    worst[g, b] = low.argmax()
                undershoot[g, w, b] = max(float(low.max()), 0.0)
                area[g, w, b] = float(((values < 0) @ areas).max())
                peak[g, w, b] = float((values.max(axis=1) / brightest[at]).mean()) - 1
    return Ringing(bands, names, undershoot, area, peak, worst)
