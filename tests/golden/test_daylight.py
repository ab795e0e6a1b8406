"""A clear day in lux, twilight and their published figures."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy import integrate
from skylight_sh.light import sun_disc
from skylight_sh.scene import clear_day
from skylight_sh.table import twilight

from golden.oracles import hemisphere, preetham_xyz

# Explanatory Supplement (Seidelmann 1992), section 9.3, eq. 9.35 and its table: log10 of lux over x = altitude / 90 degrees.
# Vallado 2022, table 5-1, prints the same numbers.
EARLY = (2.88, 21.81, -258.11, -858.36)  # -0.8 to -5 degrees
LATE = (2.70, 12.17, -431.69, -1899.83)  # -5 to -12 degrees
RISING = (2.88, 22.26, -207.64, 1034.30)  # 5 to -0.8 degrees


def lux(k: tuple[float, ...], altitude: float) -> float:
    return 10.0 ** sum(c * (altitude / 90.0) ** i for i, c in enumerate(k))


@pytest.mark.parametrize("degrees", [0.9, 2.0, 3.3, 4.9])
def test_civil_twilight(degrees: float) -> None:
    assert float(clear_day.twilight(math.radians(degrees))) == pytest.approx(lux(EARLY, -degrees), rel=1e-11)


@pytest.mark.parametrize("degrees", [5.1, 6.0, 9.0, 12.0])
def test_nautical_twilight(degrees: float) -> None:
    assert float(clear_day.twilight(math.radians(degrees))) == pytest.approx(lux(LATE, -degrees), rel=1e-11)


@pytest.mark.parametrize("degrees", [0.0, 0.4, 0.8])
def test_the_first_minutes_of_dusk_are_continued(degrees: float) -> None:
    """Down to 0.8 degrees the source has a polynomial of its own, which the one used here meets to 1 %."""
    assert float(clear_day.twilight(math.radians(degrees))) == pytest.approx(lux(RISING, -degrees), rel=0.01)


def test_published_illuminance() -> None:
    """IES RP-21 (1984), clear sky: E_sky = 0.8 + 15.5 sqrt(sin h) klx; 127.5 klx and an extinction of 0.21 an air mass."""
    for degrees in (5.0, 30.0, 75.0):
        theta = math.radians(degrees)
        sky, disc = clear_day.published(theta)
        assert float(sky) == pytest.approx(1000 * (0.8 + 15.5 * math.sqrt(math.sin(math.radians(90 - degrees)))), rel=1e-13)
        mass = 1 / (math.cos(theta) + 0.15 * (93.885 - degrees) ** -1.253)  # Kasten 1965, as RP-21 itself has it
        assert float(disc) == pytest.approx(127_500 * math.exp(-0.21 * mass) * math.cos(theta), rel=1e-12)
    assert clear_day.SOLAR == 127_500


def test_clear_day_is_the_sky_and_the_suns_cosine() -> None:
    zeniths, tau = np.radians([10.0, 55.0, 80.0]), 3.0
    sky, disc = clear_day.clear_day(zeniths, tau)
    where, solid = hemisphere(64)
    for i, theta in enumerate(zeniths.tolist()):
        expected = (preetham_xyz("published", where, theta, tau)[:, 1] * where[:, 2]) @ solid
        assert sky[i] == pytest.approx(expected, rel=2e-4)
        # XYZ of the disc: the first Y of colour's luminance row is inside normal_illuminance, which test_sun holds.
        assert disc[i] == pytest.approx(float(sun_disc.normal_illuminance(theta, tau)) * math.cos(theta), rel=1e-12)


def test_the_fade_is_its_formula() -> None:
    """1 - the incomplete beta function of (2, 10): degree 11, slope 0 at 0 and a tenfold root at 1."""
    assert math.degrees(twilight.DEPTH) == pytest.approx(12.0, rel=1e-14)  # the end of nautical twilight
    assert math.radians(90) == twilight.BEGIN
    assert pytest.approx(math.radians(102), rel=1e-15) == twilight.END
    for x in (0.0, 0.1, 0.5, 0.93, 1.0):
        area = integrate.quad(lambda t: 110 * t * (1 - t) ** 9, x, 1.0, epsabs=1e-15)[0]
        assert float(twilight.fade(x)) == pytest.approx(area, rel=1e-9, abs=1e-13)
    assert float(twilight.fade(0.0)) == 1.0
    assert float(np.float32(twilight.BEGIN)) + twilight.REST == pytest.approx(math.pi / 2, abs=1e-16)
    # 0.6 % at the end of civil twilight, as the module says: (1 / 2)^10 * 6.
    assert float(twilight.fade(0.5)) == pytest.approx(6 / 1024, rel=1e-12)
