"""Where the sun stands, by the Astronomical Almanac's short series (Michalsky 1988) and Saemundsson's refraction."""

from __future__ import annotations

import itertools
import math
from datetime import UTC, datetime, timedelta

import pytest
from skylight_sh.scene import solar
from skylight_sh.scene.solar import zenith_range


def almanac(latitude: float, longitude: float, moment: datetime) -> tuple[float, float]:
    """Zenith angle without refraction and azimuth from north by east, degrees; within 0.01 degrees from 1950 to 2050."""
    n = (moment - datetime(2000, 1, 1, 12, tzinfo=UTC)) / timedelta(days=1)
    mean, anomaly = math.radians(280.460 + 0.9856474 * n), math.radians(357.528 + 0.9856003 * n)
    ecliptic = mean + math.radians(1.915 * math.sin(anomaly) + 0.020 * math.sin(2 * anomaly))
    tilt = math.radians(23.439 - 4e-7 * n)
    ascension = math.atan2(math.cos(tilt) * math.sin(ecliptic), math.cos(ecliptic))
    declination = math.asin(math.sin(tilt) * math.sin(ecliptic))
    sidereal = math.radians(15 * (6.697375 + 0.0657098242 * n + moment.hour + moment.minute / 60 + moment.second / 3600))
    hour, phi = sidereal + math.radians(longitude) - ascension, math.radians(latitude)
    up = math.sin(declination) * math.sin(phi) + math.cos(declination) * math.cos(phi) * math.cos(hour)
    east = -math.cos(declination) * math.sin(hour)
    north = math.sin(declination) * math.cos(phi) - math.cos(declination) * math.sin(phi) * math.cos(hour)
    return math.degrees(math.acos(up)), math.degrees(math.atan2(east, north)) % 360


def refraction(altitude: float) -> float:
    """Degrees, from the true altitude (Saemundsson 1986; Meeus 1998, eq. 16.4)."""
    return 1.02 / math.tan(math.radians(altitude + 10.3 / (altitude + 5.11))) / 60


MOMENTS = [datetime(2026, month, 11, hour, 17, tzinfo=UTC) for month in (1, 4, 6, 9, 12) for hour in (8, 11, 15)]


@pytest.mark.parametrize(("latitude", "longitude"), [(48.2, 16.4), (-33.9, 18.4), (0.0, 0.0), (64.1, -21.9)])
def test_the_sun_of_a_year(latitude: float, longitude: float) -> None:
    seen = 0
    for moment in MOMENTS:
        zenith, azimuth = almanac(latitude, longitude, moment)
        if zenith > 85:
            continue
        seen += 1
        got, turned = (math.degrees(v) for v in solar.position(solar.Place(latitude, longitude), moment))
        assert got == pytest.approx(zenith - refraction(90 - zenith), abs=0.03)
        # Ours runs from east to north.
        off = (turned - (90 - azimuth) + 180) % 360 - 180
        assert abs(off) * math.sin(math.radians(zenith)) < 0.03
    assert seen > 5


def test_the_turn_of_the_year() -> None:
    """The tilt of the ecliptic, 23.44 degrees, at the solstices; refraction left out, a margin of 0.6 degrees on."""
    low, high = (math.degrees(v) for v in zenith_range(30.0, "2026-06-21", "2026-06-21"))
    assert low == pytest.approx(30.0 - 23.44 - 0.6, abs=0.03)
    assert high == pytest.approx(90.0, rel=1e-14)
    # Midnight sun at 80 degrees: 180 - 80 - 23.44 at the lowest.
    low, high = (math.degrees(v) for v in zenith_range(80.0, "2026-06-21", "2026-06-21"))
    assert low == pytest.approx(80.0 - 23.44 - 0.6, abs=0.03)
    assert high == pytest.approx(180.0 - 80.0 - 23.44 + 0.6, abs=0.03)


def test_moments_are_even_in_real_time() -> None:
    """Vienna's clocks went back on 2026-10-25: 25 hours, an hour apart."""
    times = list(solar.moments(datetime(2026, 10, 25, tzinfo=UTC).date(), "Europe/Vienna", 60))
    assert len(times) == 25
    utc = [t.astimezone(UTC) for t in times]
    assert {b - a for a, b in itertools.pairwise(utc)} == {timedelta(hours=1)}
