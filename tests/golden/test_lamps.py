"""Spherical, point and spot lights: inverse squares, half-angles and the cubic step between two cones."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh.light import spherical_lights
from skylight_sh.scene import lamps

from golden.oracles import basis, degrees, gauss, lobe, towards


def test_a_sphere_is_seen_as_the_disc_that_its_tangents_cut() -> None:
    """sin of the half-angle is radius over distance (Euclid, Optics 23); 3-4-5 triangles by hand."""
    angle, direction = spherical_lights.half_angles([[0.0, 0.0, 5.0], [6.0, 0.0, 8.0]], [3.0, 5.0])
    assert angle == pytest.approx([math.asin(0.6), math.pi / 6], rel=1e-14)
    assert direction == pytest.approx(np.array([[0, 0, 1], [0.6, 0, 0.8]]), abs=1e-14)
    # Seen from elsewhere.
    moved, _ = spherical_lights.half_angles([0.0, 0.0, 5.0], 3.0, [0.0, 0.0, -5.0])
    assert float(moved) == pytest.approx(math.asin(0.3), rel=1e-14)


def test_a_sphere_of_radiance_one_in_weights() -> None:
    half, axis = math.asin(0.6), towards(0.9, 0.4)
    z, w = gauss(math.cos(half), 1.0, 12)
    phi = np.arange(24) * math.pi / 12
    flat = np.sqrt(1 - z * z)[:, np.newaxis]
    local = np.stack(np.broadcast_arrays(flat * np.cos(phi), flat * np.sin(phi), z[:, np.newaxis]), axis=-1).reshape(-1, 3)
    frame = np.stack([towards(0.9 - math.pi / 2, 0.4), towards(math.pi / 2, 0.4 + math.pi / 2), axis])
    expected = np.repeat(w * math.pi / 12, 24) @ basis(local @ frame, 5)
    assert spherical_lights.spheres(5 * axis, 3.0, 5) == pytest.approx(expected, abs=1e-13)
    assert spherical_lights.discs(half, 7 * axis, 5) == pytest.approx(expected, abs=1e-13)


def test_a_point_falls_with_the_square_of_its_distance() -> None:
    """Lambert 1760: a candela at 2 m gives a quarter of a lux."""
    axis = towards(1.9, -0.7)
    pulse = basis(axis[np.newaxis], 4)[0]
    assert spherical_lights.points(2 * axis, 4) == pytest.approx(pulse / 4, rel=1e-12, abs=1e-15)
    assert spherical_lights.points(2 * axis + 1, 4, [1.0, 1.0, 1.0]) == pytest.approx(pulse / 4, rel=1e-12, abs=1e-15)
    assert spherical_lights.directional(3 * axis, 4) == pytest.approx(pulse, rel=1e-12, abs=1e-15)


@pytest.mark.parametrize("degrees", [0.0, 19.0, 24.0, 31.0, 39.9, 41.0, 120.0])
def test_a_spot_fades_by_smoothstep(degrees: float) -> None:
    """GLSL's smoothstep (specification 4.60, section 8.3), t^2 (3 - 2 t), of the cosine between 20 and 40 degrees."""
    inner, outer = math.radians(20), math.radians(40)
    t = (math.cos(math.radians(degrees)) - math.cos(outer)) / (math.cos(inner) - math.cos(outer))
    t = min(max(t, 0.0), 1.0)
    receiver = 3 * towards(math.radians(180 - degrees), 0.3)
    got = spherical_lights.spots([0.0, 0.0, 0.0], [0.0, 0.0, -2.0], inner, outer, 3, receiver)
    expected = t * t * (3 - 2 * t) / 9 * basis(-receiver[np.newaxis] / 3, 3)[0]
    assert got == pytest.approx(expected, rel=1e-11, abs=1e-15)


def unread(image: str) -> NDArray[np.floating]:
    raise AssertionError(image)


def test_every_kind_of_lamp_is_its_light_in_its_colours() -> None:
    """A candela at 2 m is a quarter of a lux; a disc's weights are its radiance's; a spot's inner cone a point."""
    axis, bands, colour = towards(0.7, 0.3), 4, (4.0, 0.0, 2.5)
    place, pulse = tuple(2 * axis), basis(axis[np.newaxis], bands)[0]
    half = math.asin(0.25)
    z, w = gauss(math.cos(half), 1.0, 12)
    # Integrals of Legendre polynomials over the cap, times the basis in its direction over that of the zenith.
    zonal = np.array([2 * math.pi * (w @ np.polynomial.legendre.Legendre.basis(l)(z)) for l in range(bands)])
    disc = zonal[degrees(bands)] * pulse
    for lamp, shape in (
        (lamps.Sphere(centre=place, radius=0.5, radiance=colour), disc),
        (lamps.Disc(direction=place, half_angle=half, radiance=colour), disc),
        (lamps.Point(centre=place, intensity=colour), pulse / 4),
        (lamps.Spot(centre=place, axis=tuple(-axis), inner=0.1, outer=0.2, intensity=colour), pulse / 4),
        (lamps.Spot(centre=place, axis=tuple(axis), inner=0.1, outer=0.2, intensity=colour), 0 * pulse),
        (lamps.Directional(direction=place, illuminance=colour), pulse),
    ):
        assert lamps.LAMPS[lamp.kind] is type(lamp)
        assert lamp.weights(bands, unread) == pytest.approx(np.outer(colour, shape), abs=1e-12)


def test_lamps_add_up_and_a_grey_picture_lights_all_channels() -> None:
    """An even picture of value 2 at 5 cd/m2: c_00 is 10 sqrt(4 pi), and pi times that in irradiance (Ramamoorthi 2001)."""
    even = lamps.Probe(image="even", layout="equirect", brightness=5.0, blur=0.0)
    sun = lamps.Directional(direction=(0.0, 0.0, 3.0), illuminance=(7.0, 8.0, 9.0))

    def read(image: str) -> NDArray[np.floating]:
        assert image == "even"
        return np.full((128, 256, 1), 2.0)

    got = lamps.total([even, sun], 3, 3, "radiance", read)
    expected = np.outer([7.0, 8.0, 9.0], basis(np.array([[0.0, 0.0, 1.0]]), 3)[0])
    expected[:, 0] += 10 * math.sqrt(4 * math.pi)
    # A texel's basis is that of its middle: an error of its width squared.
    near = (math.pi / 128) ** 2
    assert got == pytest.approx(expected, abs=near)
    diffuse = lamps.total([even, sun], 3, 3, "irradiance", read)
    assert diffuse == pytest.approx(expected * lobe(3)[degrees(3)], abs=near)
    assert lamps.total([], 3, 3, "radiance", read).size == 0
