"""The sun's disc: Preetham, Shirley and Smits 1999, appendix A.1, over Iqbal's tables from other programs' copies."""

from __future__ import annotations

import math

import colour as colour_science
import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import integrate
from skylight_sh.light import sun_disc

from golden.oracles import REC709, WHITE, basis, gauss, towards, xyz_to_rgb

Array = NDArray[np.float64]
MATRIX = np.round(xyz_to_rgb(REC709, WHITE), 7)

# Iqbal 1983, pages 127 and 130, and the sun's radiance above the air in 100 W / (m2 nm sr), from 380 nm in steps of 10:
# the same numbers in LuxRays (sunspect data) and in Mitsuba (sunmodel.h), typed here wavelength by wavelength.
OZONE = {
    300: "10 4.8 2.7 1.35 0.8 0.38 0.16 0.075 0.04 0.019 0.007 0",
    445: "0.003 0.003 0.004 0.006 0.008 0.009 0.012 0.014 0.017 0.021 0.025",
    500: "0.03 0.035 0.04 0.045 0.048 0.057 0.063 0.07 0.075 0.08 0.085 0.095 0.103 0.110 0.12 0.122 0.12 0.118 0.115 0.12",
    600: "0.125 0.130",
}
OZONE_TENS = {
    610: "0.12 0.105 0.09 0.079 0.067 0.057 0.048 0.036 0.028",
    700: "0.023 0.018 0.014 0.011 0.010 0.009 0.007 0.004 0 0",
}
GASES = {759: 0.0, 760: 3.0, 770: 0.21, 771: 0.0}
VAPOUR = {689: 0.0, 690: 0.016, 700: 0.024, 710: 0.0125, 720: 1.0, 730: 0.87, 740: 0.061}
VAPOUR |= {750: 0.001, 760: 1e-5, 770: 1e-5, 780: 6e-4, 790: 0.0175, 800: 0.036}
SOLAR = """
165.590 162.337 211.275 258.882 258.291 242.323 267.605 296.583 305.454 300.575 306.637 288.304 287.121
278.250 271.006 272.336 263.613 255.038 250.602 253.116 253.559 251.342 246.315 241.732 236.853 232.121
228.277 223.398 219.702 215.267 210.979 207.283 202.404 198.708 194.272 190.724 186.289 182.592
"""


def ozone() -> tuple[list[float], list[float]]:
    points = {start + 5.0 * i: float(v) for start, text in OZONE.items() for i, v in enumerate(text.split())}
    points |= {start + 10.0 * i: float(v) for start, text in OZONE_TENS.items() for i, v in enumerate(text.split())}
    return sorted(points), [points[k] for k in sorted(points)]


def transmittance(theta: float, tau: float, nanometres: float) -> float:
    """Appendix A.1, one wavelength at a time; the exponent of Rayleigh's term multiplies the mass (Iqbal's tau_r)."""
    micro, degrees = nanometres / 1000, math.degrees(theta)
    mass = 1 / (math.cos(theta) + 0.15 * (93.885 - degrees) ** -1.253)  # Kasten 1965
    # The authors' code has 14 digits of the paper's 0.04608 and 0.04586.
    beta = max(0.04608 * tau - 0.04586, 0.0)
    rayleigh = math.exp(-0.008735 * micro**-4.08 * mass)
    aerosol = math.exp(-beta * micro**-1.3 * mass)
    wavelengths, sizes = ozone()
    absorbed = math.exp(-float(np.interp(nanometres, wavelengths, sizes, 0, 0)) * 0.35 * mass)
    gas = float(np.interp(nanometres, list(GASES), list(GASES.values()), 0, 0))
    mixed = math.exp(-1.41 * gas * mass / (1 + 118.93 * gas * mass) ** 0.45)
    vapour = float(np.interp(nanometres, list(VAPOUR), list(VAPOUR.values()), 0, 0))
    wet = math.exp(-0.2385 * vapour * 2.0 * mass / (1 + 20.07 * vapour * 2.0 * mass) ** 0.45)
    return rayleigh * aerosol * absorbed * mixed * wet


WAVELENGTHS = [*range(300, 800, 5), 759, 760, 765, 770, 771, 689, 695]


@pytest.mark.parametrize(("theta", "tau"), [(0.0, 1.0), (0.4, 2.2), (1.1, 4.0), (1.45, 9.5), (math.pi / 2, 3.0)])
def test_spectral_transmittance(theta: float, tau: float) -> None:
    got = sun_disc.spectral_transmittance(theta, tau, np.array(WAVELENGTHS, dtype=float))
    assert got == pytest.approx([transmittance(theta, tau, nm) for nm in WAVELENGTHS], rel=1e-11, abs=1e-300)


def test_clear_air_without_aerosol_stays_clear() -> None:
    """Turbidity 1 is air without aerosol; at 550 nm Rayleigh's scattering and ozone leave 0.90 x 0.97 at the zenith."""
    assert float(sun_disc.spectral_transmittance(0.0, 1.0, np.array([550.0]))[0]) == pytest.approx(0.905 * 0.97, rel=0.01)


@pytest.mark.parametrize(("degrees", "printed"), [(0, 1.0), (60, 1.995), (80, 5.60), (85, 10.39), (90, 36.5)])
def test_optical_mass_is_kastens(degrees: float, printed: float) -> None:
    """Kasten 1965, printed with the formula: 36.3 on the horizon, 10.4 at 85 degrees."""
    assert float(sun_disc.optical_mass(math.radians(degrees))) == pytest.approx(printed, rel=0.01)


def matching() -> Array:
    """The CIE 1931 2 degree observer of colour-science, every ten nanometres, ``(38, 3)``."""
    curves = colour_science.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"]
    return np.array([curves[float(nm)] for nm in range(380, 751, 10)])


@pytest.mark.parametrize(("theta", "tau"), [(0.0, 2.0), (0.9, 3.5), (1.5, 6.0)])
def test_radiance_and_illuminance(theta: float, tau: float) -> None:
    spectrum = [100 * float(s) * transmittance(theta, tau, 380 + 10 * i) for i, s in enumerate(SOLAR.split())]
    xyz = 683 * 10 * np.array(spectrum) @ matching()
    assert sun_disc.radiance(theta, tau) == pytest.approx(MATRIX @ xyz, rel=1e-5, abs=1e-5 * xyz[1])
    # To rounding with the package's own rounding of the observer, whose digits test_the_observer holds.
    exact = 683 * 10 * np.array(spectrum) @ sun_disc.OBSERVER.T
    assert sun_disc.radiance(theta, tau) == pytest.approx(MATRIX @ exact, rel=1e-11)
    solid, _ = integrate.quad(lambda g: 2 * math.pi * math.sin(g) * math.cos(g), 0, math.radians(0.2665))
    assert float(sun_disc.normal_illuminance(theta, tau)) == pytest.approx(exact[1] * solid, rel=1e-9)


def test_the_observer() -> None:
    assert list(sun_disc.WAVELENGTHS) == list(range(380, 751, 10))
    # colour-science has the CIE's table with two more digits in places.
    assert np.abs(sun_disc.OBSERVER.T - matching()).max() < 1.1e-7
    assert pytest.approx(matching(), rel=5e-6, abs=1e-8) == sun_disc.OBSERVER.T


def test_the_discs_size_is_the_suns() -> None:
    """IAU 2015 B3's nominal radius over the astronomical unit of IAU 2012 B2; an old 959.63 seconds of arc agree."""
    angle = math.asin(6.957e8 / 1.495978707e11)
    assert angle == pytest.approx(sun_disc.HALF_ANGLE, rel=3e-4)
    assert math.radians(959.63 / 3600) == pytest.approx(sun_disc.HALF_ANGLE, rel=3e-4)
    assert math.radians(0.2665) == sun_disc.HALF_ANGLE


def test_solar_illuminance_above_the_air() -> None:
    """IES RP-21 (1984) has 127.5 klx, ASTM E490 integrates to 133; the table stands between, with 683 lm/W."""
    above = 683 * 10 * float(sum(100 * float(s) * y for s, y in zip(SOLAR.split(), matching()[:, 1], strict=True)))
    assert 126_000 < above * math.pi * math.sin(sun_disc.HALF_ANGLE) ** 2 < 133_500


def test_the_disc_is_integrated() -> None:
    cosine, areas = gauss(math.cos(sun_disc.HALF_ANGLE), 1.0, 8)
    phi = (np.arange(24) + 0.5) * math.pi / 12
    flat = np.sqrt(1 - cosine**2)[:, np.newaxis]
    local = np.stack(np.broadcast_arrays(flat * np.cos(phi), flat * np.sin(phi), cosine[:, np.newaxis]), axis=-1)
    theta, azimuth = 0.8, 2.1
    up, side = towards(theta - math.pi / 2, azimuth), towards(math.pi / 2, azimuth + math.pi / 2)
    where = local.reshape(-1, 3) @ np.stack([up, side, towards(theta, azimuth)])
    expected = np.repeat(areas * math.pi / 12, 24) @ basis(where, 6)
    assert sun_disc.disc(theta, azimuth, 6) == pytest.approx(expected, rel=1e-9, abs=1e-13)
    lit = sun_disc.weights(theta, azimuth, 3.0, 6)
    assert lit == pytest.approx(np.multiply.outer(sun_disc.radiance(theta, 3.0), expected), rel=1e-9, abs=1e-3)


@pytest.mark.parametrize("part", [0.0, 0.2, 0.55, 0.9, 1.0, 1.5])
def test_what_shines_from_below_the_horizon(part: float) -> None:
    """The integral of -z over the part of a flat disc below a line, by strips."""
    radius = math.radians(0.2665)
    height = part * radius

    def strip(y: float) -> float:
        return 2 * math.sqrt(max(radius**2 - y * y, 0.0)) * (y - height)

    expected = integrate.quad(strip, height, radius, epsabs=0, epsrel=1e-12)[0] if part < 1 else 0.0
    assert float(sun_disc.from_below(math.pi / 2 - height)) == pytest.approx(expected, rel=1e-8, abs=1e-22)
