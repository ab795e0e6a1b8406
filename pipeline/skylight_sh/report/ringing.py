"""How much an expansion rings: with each window and each ground, for each number of bands.

Undershoot is measured everywhere here as a share of the brightest value of the same sky itself, not of its expansion.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.fit.axis import Axis
from skylight_sh.formula.harmonics import HORIZONTAL
from skylight_sh.light.protocol import Light
from skylight_sh.report import panorama
from skylight_sh.runtime import Table

Array = NDArray[np.float64]

ALBEDO = 0.25
LEAST = "least non-negative"
# What the least windows keep from being negative.
_KEPT: dict[str, Literal["radiance", "irradiance"]] = {LEAST: "radiance", "least for irradiance": "irradiance"}
_ROUNDS = 6
# Sets in all, about; evenly spaced along each axis, both edges among them.
_SETS = 49
# Columns of a panorama from one that is looked at to the next.
_EACH = 4


@dataclass(frozen=True)
class Ground:
    """What is below the horizon: added to weights ``(sets, N*N)``, and to a sky's values ``(sets, rows, columns)``.

    ``values`` also takes the irradiance on the horizontal, ``(sets,)``.
    """

    weights: Callable[[Array, int], Array]
    values: Callable[[Array, Array], Array]


def _lit(values: Array, irradiance: Array) -> Array:
    out = values.copy()
    out[:, values.shape[1] // 2 :] = (ALBEDO / np.pi * irradiance)[:, np.newaxis, np.newaxis]
    return out


GROUNDS = {
    "black ground": Ground(lambda weights, _: weights, lambda values, _: values),
    f"ground of albedo {ALBEDO:g}": Ground(lambda weights, bands: sphere.add_ground(weights, ALBEDO, bands), _lit),
    "mirrored sky": Ground(sphere.mirror_ground, lambda values, _: values + values[:, ::-1]),
}


@dataclass(frozen=True)
class Ringing:
    """Figures over all sets, ``(grounds, windows, bands)``: fractions of each sky's own brightest value, or of the sphere.

    ``undershoot`` and ``overshoot`` are the largest of all sets: below 0, and above the scene itself; ``area`` is the
    largest part of the sphere that is negative, ``peak`` the brightest value's change, mean over sets, negative where the
    peak is lost. ``worst`` are the sets of the largest undershoots. ``smoothing`` ``(grounds, 2, bands)`` is that of the
    least windows, the last two.
    """

    bands: tuple[int, ...]
    windows: tuple[str, ...]
    undershoot: Array
    overshoot: Array
    area: Array
    peak: Array
    worst: NDArray[np.int64]
    smoothing: Array


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


def study(light: Light, axes: Sequence[Axis], table: Table, most: int, weights_of: Callable[[Array], Array]) -> Study | None:
    """Measure 3 to 10 bands, ``most`` at most, at evenly spaced sets of parameters, edges of the ``axes`` among them.

    ``weights_of`` gives a set's ``(axes,)`` true SH weights, ``(channels, most * most)``. None for fewer bands, and where
    weights are windowed, lit from below, hold a sun or are no radiance.
    """
    spec, bands = table.spec, tuple(range(3, min(most, 10) + 1))
    if spec.windowed or spec.quantity != "radiance" or spec.ground != "black" or spec.sun_disc or not bands:
        return None
    row = light.luminance_row
    each = round(_SETS ** (1 / len(axes)))
    sets = np.array(list(itertools.product(*(np.linspace(axis.low, axis.high, each) for axis in axes))))
    weights = np.stack([row @ weights_of(values) for values in sets])
    names = tuple(axis.name for axis in axes)
    skies = np.stack([panorama.sky(light, values, names) @ row for values in sets])
    return Study(sets, weights, skies.max(axis=(1, 2)), measure(weights, skies, bands))


def csv(study: Study, names: Sequence[str]) -> bytes:
    """Return one row a ground, window and number of bands: fractions, and the worst set on the axes ``names``.

    Undershoot and overshoot are shares of the brightest value of the same set's sky, as the columns' names say.
    """
    # It takes longer to import than a cached run takes.
    import pandas as pd

    found = study.found
    index = pd.MultiIndex.from_product((GROUNDS, found.windows, found.bands), names=("ground", "window", "bands"))
    columns = {
        "undershoot_of_the_skys_brightest": found.undershoot,
        "overshoot_of_the_skys_brightest": found.overshoot,
        "negative_area": found.area,
        "peak_change": found.peak,
        **{f"{name}_at_undershoot": study.sets[found.worst][..., i] for i, name in enumerate(names)},
    }
    frame = pd.DataFrame({name: values.ravel() for name, values in columns.items()}, index=index)
    return frame.to_csv(float_format="%.4g", lineterminator="\n").encode()


def windows(bands: int) -> dict[str, Array]:
    """Return the fixed windows by name, ``(N*N,)`` each."""
    degrees = sphere.Harmonics(bands).degrees
    return {
        "no window": np.ones(bands * bands),
        "zonal sinc (eq. 5)": sphere.zonal_sinc(bands),
        "sinc (Lanczos)": sphere.lanczos_window(bands)[degrees],
        "sinc cubed": sphere.sinc_window(bands, power=3.0)[degrees],
        "Hann": sphere.hann_window(bands)[degrees],
    }


def tried(found: Ringing, ground: int, band: int) -> dict[str, Array]:
    """Return all windows ``(N*N,)`` by name, the least ones of that ground and number of bands (indices) among them."""
    bands = found.bands[band]
    degrees = sphere.Harmonics(bands).degrees
    least = {name: sphere.laplacian_window(bands, found.smoothing[ground, k, band])[degrees] for k, name in enumerate(_KEPT)}
    return windows(bands) | least


def measure(weights: Array, skies: Array, bands: tuple[int, ...]) -> Ringing:
    """Measure ringing of luminance weights ``(sets, N*N)``, black below the horizon, against ``skies`` themselves.

    ``skies`` ``(sets, rows, columns)`` are their values as a panorama; ``bands`` the numbers of bands to cut to, from 2 to
    N.
    """
    view = panorama.directions()[:, ::_EACH]
    rows = sphere.basis(view.reshape(-1, 3), max(bands))
    # Rows of a panorama are bands of equal altitude: their area goes with its cosine.
    areas = np.hypot(view[..., 0], view[..., 1]).ravel()
    areas /= areas.sum()
    names = (*windows(1), *_KEPT)
    shape = (len(GROUNDS), len(names), len(bands))
    undershoot, overshoot, area, peak = (np.empty(shape) for _ in range(4))
    smoothing = np.empty((len(GROUNDS), len(_KEPT), len(bands)))
    found = Ringing(bands, names, undershoot, overshoot, area, peak, np.empty(shape, dtype=np.int64), smoothing)
    brightest = skies.max(axis=(1, 2))
    irradiance = HORIZONTAL * weights[:, 2]
    for g, ground in enumerate(GROUNDS.values()):
        scene = ground.values(skies[:, :, ::_EACH], irradiance).reshape(len(skies), -1)
        for b, count in enumerate(bands):
            lit = ground.weights(weights[:, : count * count], count)
            cut = rows[:, : count * count].T
            smoothing[g, :, b] = [_least(lit, cut, keep) for keep in _KEPT.values()]
            for w, window in enumerate(tried(found, g, b).values()):
                values = (lit * window) @ cut
                low = -values.min(axis=1) / brightest
                found.worst[g, w, b] = low.argmax()
                undershoot[g, w, b] = max(float(low.max()), 0.0)
                overshoot[g, w, b] = max(float(((values - scene).max(axis=1) / brightest).max()), 0.0)
                area[g, w, b] = float(((values < 0) @ areas).max())
                peak[g, w, b] = float((values.max(axis=1) / brightest).mean()) - 1
    return found


def _least(lit: Array, cut: Array, keep: Literal["radiance", "irradiance"]) -> float:
    """Return a smoothing that leaves no set negative: the largest of those that the worst sets need, one after another."""
    bands = sphere.bands_of(lit)
    kept = sphere.scale_degrees(lit, sphere.clamped_cosine(bands)) if keep == "irradiance" else lit
    smoothing = 0.0
    for _ in range(_ROUNDS):
        low = (sphere.scale_degrees(kept, sphere.laplacian_window(bands, smoothing)) @ cut).min(axis=1) / kept[:, 0]
        needed = float(sphere.nonnegative_smoothing(lit[low.argmin()], keep))
        if needed <= smoothing:
            break
        smoothing = needed
    return smoothing
