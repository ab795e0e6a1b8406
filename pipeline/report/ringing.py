"""How much an expansion rings: with each window and each ground, for each number of bands."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from pipeline import sphere
from pipeline.report import panorama

if TYPE_CHECKING:
    from pipeline.report.material import Material

Array = NDArray[np.float64]

ALBEDO = 0.25
GROUNDS: dict[str, Callable[[Array, int], Array]] = {
    "black ground": lambda weights, _: weights,
    f"ground of albedo {ALBEDO:g}": lambda weights, bands: sphere.add_ground(weights, ALBEDO, bands),
    "mirrored sky": sphere.mirror_ground,
}
LEAST = "least non-negative"
# Sets in all, about; evenly spaced along each axis, both edges among them.
_SETS = 49


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


@dataclass(frozen=True)
class Study:
    """Ringing of a light over its whole domain.

    ``sets`` ``(n, axes)``, their luminance ``weights`` ``(n, N*N)``, the sky's ``brightest`` luminance ``(n,)``, and what
    was ``found``.
    """

    sets: Array
    weights: Array
    brightest: Array
    found: Ringing


def study(material: Material) -> Study | None:
    """Measure 3 to 10 bands at evenly spaced sets of parameters, edges among them.

    None for fewer bands, and where weights are windowed, lit from below, hold a sun or are no radiance.
    """
    table = material.best.table
    bands = tuple(range(3, min(material.bands, 10) + 1))
    if table.windowed or table.quantity != "radiance" or table.ground != "black" or table.sun_disc or not bands:
        return None
    row = material.light.luminance_row
    each = round(_SETS ** (1 / len(material.axes)))
    sets = np.array(list(itertools.product(*(np.linspace(axis.low, axis.high, each) for axis in material.axes))))
    weights = np.stack([_luminance(material, values, row) for values in sets])
    names = tuple(axis.name for axis in material.axes)
    brightest = np.array([(panorama.sky(material.light, values, names) @ row).max() for values in sets])
    return Study(sets, weights, brightest, measure(weights, brightest, bands))


def csv(found: Ringing) -> bytes:
    """Return one row a ground, window and number of bands; fractions, to four significant digits."""
    index = pd.MultiIndex.from_product((GROUNDS, found.windows, found.bands), names=("ground", "window", "bands"))
    columns = {"undershoot": found.undershoot, "negative_area": found.area, "peak_change": found.peak}
    frame = pd.DataFrame({name: values.ravel() for name, values in columns.items()}, index=index)
    return frame.to_csv(float_format="%.4g", lineterminator="\n").encode()


def _luminance(material: Material, values: Array, row: Array) -> Array:
    weights = row @ material.sample(values)
    return np.asarray(sphere.unmirror(weights, material.bands) if material.mirrored else weights, dtype=np.float64)


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
