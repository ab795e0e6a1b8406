"""Captured light: the sRGB curve, charts of the sphere, texels' solid angles, and the projection's weights."""

from __future__ import annotations

import math
from typing import Any

import colour as colour_science
import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import integrate
from skylight_sh import probe
from skylight_sh.light.cie_traditional import CieTraditional
from skylight_sh.probe import charts, files, layouts
from skylight_sh.report import panorama

from golden.oracles import basis, degrees, gauss, towards

Array = NDArray[np.float64]


def test_srgb_is_iec_61966_2_1() -> None:
    """The toe below 0.04045 / 0.0031308 and the power above, by colour-science, whose mean level error is 1e-8."""
    encoded = np.concatenate([np.linspace(0, 0.08, 161), np.linspace(0.08, 1.0, 93), [0.04045, 0.0404499, 0.0404501]])
    expected = colour_science.models.eotf_sRGB(encoded)
    assert files.from_srgb(encoded.astype(np.float32)) == pytest.approx(expected, rel=3e-6, abs=1e-9)
    linear = np.concatenate([np.linspace(0, 0.01, 201), np.linspace(0.01, 1.0, 100), [0.0031308]])
    assert files.to_srgb(linear) == pytest.approx(colour_science.models.eotf_inverse_sRGB(linear), rel=1e-9, abs=1e-12)


def test_srgb_by_hand() -> None:
    """IEC 61966-2-1, eqs. 5 and 6: 0.04 lies in the toe, 0.5 on the power."""
    low, half, one = files.from_srgb(np.array([0.04, 0.5, 1.0], dtype=np.float32)).tolist()
    assert low == pytest.approx(0.04 / 12.92, rel=1e-6)
    assert half == pytest.approx(((0.5 + 0.055) / 1.055) ** 2.4, rel=1e-6)
    assert one == pytest.approx(1.0, rel=1e-6)
    assert files.to_srgb(np.array([0.002, 0.18])).tolist() == [
        pytest.approx(12.92 * 0.002, rel=1e-14),
        pytest.approx(1.055 * 0.18 ** (1 / 2.4) - 0.055, rel=1e-14),
    ]


# Where a plane's point looks: longitude and latitude; Debevec 1998's angular map; a gnomonic face.


def test_equirectangular_looks_left_to_the_north() -> None:
    u, v = np.array([0.3, -1.2, 2.9]), np.array([-0.4, 0.9, 0.0])
    expected = [towards(math.pi / 2 + b, -a) for a, b in zip(u, v, strict=True)]
    assert charts.LatLong().directions(u, v) == pytest.approx(np.array(expected), abs=1e-14)
    assert charts.LatLong().bounds == (-math.pi, math.pi, -math.pi / 2, math.pi / 2)


def test_the_angular_maps_radius_is_its_angle() -> None:
    for u, v in ((0.3, -0.5), (-0.7, 0.1), (0.0, 0.9), (1e-9, 0.0)):
        got = charts.Angular().directions(np.array([u]), np.array([v]))[0]
        radius = math.hypot(u, v)
        assert math.acos(max(-1.0, min(1.0, got[0]))) == pytest.approx(math.pi * radius, abs=1e-7)
        assert got[1:] == pytest.approx(-np.array([u, v]) / radius * math.sin(math.pi * radius), abs=1e-14)


def test_solid_angles_are_integrals_of_the_sphere() -> None:
    """Cells between edges against their areas by SciPy's quadrature of the textbooks' densities."""
    u, v = np.array([-0.6, -0.1, 0.35]), np.array([-0.3, 0.2])
    face = charts.Face((1, 0, 0), (0, -1, 0), (0, 0, -1))
    densities: list[tuple[Any, Any]] = [
        (face, lambda b, a: (1 + a * a + b * b) ** -1.5),
        (charts.LatLong(), lambda b, _: math.cos(b)),
        (charts.Angular(), lambda b, a: math.pi * math.sin(math.pi * math.hypot(a, b)) / math.hypot(a, b)),
    ]
    for chart, density in densities:
        found = chart.solid_angles(u, v)[0]
        for i in range(2):
            area = integrate.dblquad(density, u[i], u[i + 1], v[0], v[1], epsabs=1e-10)[0]
            assert found[i] == pytest.approx(area, rel=1e-7)
            middle = np.array([0.5 * (u[i] + u[i + 1])])
            assert float(chart.density(middle, np.array([0.05]))[0]) == pytest.approx(density(0.05, middle[0]), rel=1e-12)


@pytest.mark.parametrize(("layout", "height", "width"), [("angular", 48, 48), ("equirect", 32, 64), ("cube-cross", 36, 48)])
def test_an_even_picture_is_the_mean(layout: Any, height: int, width: int) -> None:
    weights = probe.project(np.full((height, width, 1), 2.5), layout, 4)[0]
    assert weights[0] == pytest.approx(2.5 * math.sqrt(4 * math.pi), rel=1e-3)
    assert np.abs(weights[1:]).max() < 5e-3


def rendered(weights: Array, height: int) -> Array:
    """An equirectangular picture of an expansion: means over solid angles, by Gauss and Legendre in sine of altitude."""
    out = np.zeros((height, 2 * height))
    edges = np.linspace(math.pi / 2, -math.pi / 2, height + 1)
    for row in range(height):
        z, share = gauss(math.sin(edges[row + 1]), math.sin(edges[row]), 5)
        for column in range(2 * height):
            phi, turn = gauss(math.pi - math.pi * (column + 1) / height, math.pi - math.pi * column / height, 5)
            flat = np.sqrt(1 - z * z)[:, np.newaxis]
            where = np.stack(np.broadcast_arrays(flat * np.cos(phi), flat * np.sin(phi), z[:, np.newaxis]), axis=-1)
            area = np.outer(share, turn)
            bands = math.isqrt(weights.size)
            out[row, column] = (basis(where.reshape(-1, 3), bands) @ weights) @ area.ravel() / area.sum()
    return out


def test_projection_undoes_its_texels_blur_to_fourth_order() -> None:
    """4/3 of the centre less 1/3 of the corners: halving the texels divides the error by 16; either alone, by 4."""
    weights = np.random.default_rng(31).normal(size=9)
    errors = []
    for height in (8, 16):
        got = probe.project(rendered(weights, height)[..., np.newaxis], "equirect", 3, signed=True)[0]
        errors.append(float(np.abs(got - weights).max()))
    assert errors[0] < 0.02 * np.abs(weights).max()
    assert 11 < errors[0] / errors[1] < 22


def test_blur_is_the_heat_kernel() -> None:
    """exp(-l (l + 1) t), t = sigma^2 / 2: heat on the sphere; its variance is that of 2 - 2 cos in the plane's limit."""
    weights, sigma = np.random.default_rng(32).normal(size=36), 0.23
    got = probe.blur(weights, sigma)
    l = degrees(6)
    assert got == pytest.approx(weights * np.exp(-(l**2 + l) * sigma**2 / 2), rel=1e-13)
    # The mean cosine of the kernel is that of a Gaussian of the plane for a small sigma: 1 - sigma^2.
    assert probe.blur(np.eye(4)[2], 1e-3)[2] == pytest.approx(1 - 1e-6, rel=1e-11)


def test_faces_are_those_of_a_box() -> None:
    """Looking along +x with +z up, north (+y) is to the left; edges of neighbouring faces meet."""
    named = dict(zip(("right", "left", "up", "down", "front", "back"), layouts.patches("cube-strip", 8, 48), strict=True))
    middle, end = np.array([0.0]), np.array([1.0])
    centres = {
        "right": (0, -1, 0),
        "left": (0, 1, 0),
        "up": (0, 0, 1),
        "down": (0, 0, -1),
        "front": (1, 0, 0),
        "back": (-1, 0, 0),
    }
    for name, patch in named.items():
        assert patch.chart.directions(middle, middle)[0].tolist() == list(centres[name])
    rims = {
        ("front", "right"): (end, middle, -end, middle),
        ("left", "front"): (end, middle, -end, middle),
        ("right", "back"): (end, middle, -end, middle),
        ("up", "front"): (middle, end, middle, -end),
        ("front", "down"): (middle, end, middle, -end),
    }
    for (one, other), (u, v, s, t) in rims.items():
        assert named[one].chart.directions(u, v) == pytest.approx(named[other].chart.directions(s, t), abs=1e-15)


def test_a_texel_resolves_one_band_over_half_a_turn() -> None:
    """Nyquist: N bands have N - 1 waves around, so that as many texels as bands over half a turn are two a wave."""
    for layout, height, width, most in (("equirect", 20, 40, 20), ("angular", 20, 20, 10), ("cube-strip", 9, 54, 18)):
        assert layouts.most_bands(layout, height, width) == most
    assert layouts.most_bands("equirect", 512, 1024) == 100


def test_panoramas_are_tone_mapped_as_stated() -> None:
    """Reinhard 2002, eq. 3, so that `level` is the top: 2 x / (1 + x); then sRGB."""
    x = np.array([0.0, 0.25, 1.0, 4.0])
    shown = panorama.display(7.0 * x[:, np.newaxis, np.newaxis] * np.ones(3), 7.0)
    expected = colour_science.models.eotf_inverse_sRGB(np.minimum(2 * x / (1 + x), 1.0))
    assert shown[:, 0, 0] == pytest.approx(expected, rel=1e-9)
    assert panorama.white(np.arange(101.0)) == pytest.approx(98.0)
    view = panorama.directions()
    assert view.shape == (90, 180, 3)
    assert view[10, 45] == pytest.approx(towards(math.radians(21.0), math.radians(-89.0)), abs=1e-14)


def test_a_rendered_texel_is_a_mean_over_its_solid_angle() -> None:
    """Moon and Spencer's sky, (1 + 2 z) / 3: the mean of z over a belt is the mean of its edges' sines (Archimedes)."""
    at = {"sun_zenith": np.array([0.3])}
    image = probe.render(CieTraditional(sky="overcast"), at, "equirect", 15, 30)[..., 0]
    sines = np.sin(np.linspace(math.pi / 2, -math.pi / 2, 16))
    # The horizon runs through the eighth row, whose lower half is black.
    top, bottom = np.maximum(sines[:-1], 0), np.maximum(sines[1:], 0)
    means = np.where(top > bottom, (1 + top + bottom) / 3 * (top - bottom), 0.0) / (sines[:-1] - sines[1:])
    assert image == pytest.approx(np.broadcast_to(means[:, np.newaxis], image.shape), abs=2e-5)
