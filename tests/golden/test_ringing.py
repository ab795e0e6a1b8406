"""The study of ringing by brute force: its figures over directions, a basis and windows that owe it nothing."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh.report import panorama
from skylight_sh.report.ringing import ALBEDO, GROUNDS, measure

from golden.oracles import basis, degrees, hemisphere, lobe, orders, preetham_xyz, sinc

Array = NDArray[np.float64]
BANDS = (3, 5)
SETS = [(0.4, 3.0), (1.2, 2.6), (1.5, 5.5)]


def grid(step: float) -> tuple[Array, Array]:
    """Directions of all texels of a panorama of ``step`` degrees, ``(rows * columns, 3)``, and their exact shares."""
    edges = np.radians(np.arange(90.0, -90.0 - step / 2, -step))
    altitude = (edges[1:] + edges[:-1]) / 2
    azimuth = np.radians(np.arange(-180.0, 180.0, step) + step / 2)
    a, b = np.meshgrid(altitude, azimuth, indexing="ij")
    where = np.stack([np.cos(a) * np.cos(b), np.cos(a) * np.sin(b), np.sin(a)], axis=-1).reshape(-1, 3)
    shares = np.repeat((np.sin(edges[:-1]) - np.sin(edges[1:])) / 2, azimuth.size) / azimuth.size
    return where, shares


@pytest.fixture(scope="module")
def scenes() -> tuple[Array, Array]:
    """Luminance weights of three skies, ``(3, 25)``, and their panoramas as the study takes them."""
    above, solid = hemisphere(48)
    weights = [(preetham_xyz("published", above, *s)[:, 1] * solid) @ basis(above, max(BANDS)) for s in SETS]
    view = panorama.directions()
    upper = view[..., 2] > 0
    skies = np.zeros((len(SETS), *upper.shape))
    for sky, values in zip(skies, SETS, strict=True):
        sky[upper] = preetham_xyz("published", view[upper], *values)[:, 1]
    return np.array(weights), skies


def windows(bands: int) -> dict[str, Array]:
    """Factors ``(N*N,)``: Habel 2008, eq. 5, and Sloan 2008."""
    l, x = degrees(bands), np.pi * degrees(bands) / bands
    return {
        "no window": np.ones(l.size),
        "zonal sinc (eq. 5)": np.where(orders(bands) == 0, sinc(x), 1.0),
        "sinc (Lanczos)": sinc(x),
        "sinc cubed": sinc(x) ** 3,
        "Hann": (1 + np.cos(x)) / 2,
    }


def on_the_ground(name: str, weights: Array, sky: Array, bands: int) -> tuple[Array, Array]:
    """Weights of the scene cut to ``bands``, and its panorama ``(rows, columns)``, given the sky's."""
    cut = weights[: bands**2]
    if name == "black ground":
        return cut, sky
    if name == "mirrored sky":
        return cut * (1 + (-1.0) ** (degrees(bands) + orders(bands))), sky + sky[::-1]
    below, solid = hemisphere(30, lower=True)
    radiance = 0.25 * math.sqrt(4 * math.pi / 3) * weights[2] / math.pi
    lit = sky.copy()
    lit[len(sky) // 2 :] = radiance
    return cut + radiance * (solid @ basis(below, bands)), lit


def test_every_figure(scenes: tuple[Array, Array]) -> None:
    weights, skies = scenes
    found = measure(weights, skies, BANDS)
    assert ALBEDO == 0.25
    assert list(GROUNDS) == ["black ground", "ground of albedo 0.25", "mirrored sky"]
    # The study looks at every fourth column of two-degree rows; areas are exact ones of a grid twice as fine.
    assert skies.shape[1:] == (90, 180)
    looked = skies[:, :, ::4]
    fine, shares = grid(1.0)
    coarse = {bands: basis(panorama.directions()[:, ::4].reshape(-1, 3), bands) for bands in BANDS}
    whole = {bands: basis(fine, bands) for bands in BANDS}
    brightest = skies.max(axis=(1, 2))
    for (g, name), (b, bands) in itertools.product(enumerate(GROUNDS), enumerate(BANDS)):
        parts = [on_the_ground(name, weights[i], looked[i], bands) for i in range(len(SETS))]
        cuts, scenery = np.array([cut for cut, _ in parts]), np.array([scene.ravel() for _, scene in parts])
        for w, (title, factors) in enumerate(windows(bands).items()):
            assert found.windows[w] == title
            values = (cuts * factors) @ coarse[bands].T
            low = -values.min(axis=1) / brightest
            assert found.undershoot[g, w, b] == pytest.approx(max(low.max(), 0.0), abs=1e-8)
            assert found.worst[g, w, b] == low.argmax()
            over = ((values - scenery).max(axis=1) / brightest).max()
            assert found.overshoot[g, w, b] == pytest.approx(max(over, 0.0), abs=1e-8)
            negative = ((cuts * factors) @ whole[bands].T < 0) @ shares
            assert found.area[g, w, b] == pytest.approx(negative.max(), abs=0.012)
            assert found.peak[g, w, b] == pytest.approx((values.max(axis=1) / brightest).mean() - 1, abs=1e-8)


def test_a_belt_about_the_equator_has_its_own_area() -> None:
    """y_20 is negative where 3 z^2 < 1: 1 / sqrt 3 = 57.7 % of the sphere, though only 39.2 % of the altitudes."""
    weights = np.zeros((1, 9))
    weights[0, [0, 6]] = 1e-9, 1.0
    view = panorama.directions()
    found = measure(weights, np.broadcast_to((view[..., 2] > 0).astype(float), (1, *view.shape[:2])), (3,))
    assert found.area[0, 0, 0] == pytest.approx(1 / math.sqrt(3), abs=0.012)
    # And of y_20 the least value is -sqrt(5 / (16 pi)), here over a brightest sky of 1.
    assert found.undershoot[0, 0, 0] == pytest.approx(math.sqrt(5 / (16 * math.pi)), rel=2e-3)
    assert found.peak[0, 0, 0] == pytest.approx(math.sqrt(5 / (4 * math.pi)) - 1, rel=5e-3)


def test_the_least_windows_are_just_enough(scenes: tuple[Array, Array]) -> None:
    weights, skies = scenes
    found = measure(weights, skies, BANDS)
    assert found.windows[-2:] == ("least non-negative", "least for irradiance")
    where, _ = grid(1.0)
    for b, bands in enumerate(BANDS):
        l, rows = degrees(bands), basis(where, bands)
        for k, kernel in enumerate((np.ones(bands), lobe(bands))):
            smoothing = float(found.smoothing[0, k, b])
            kept = weights[:, : bands**2] * kernel[l]
            least = [
                ((kept / (1 + s * (l * (l + 1.0)) ** 2)) @ rows.T).min(axis=1) / kept[:, 0]
                for s in (smoothing, 0.97 * smoothing)
            ]
            assert least[0].min() > -1e-4
            assert smoothing == 0.0 or least[1].min() < 0
