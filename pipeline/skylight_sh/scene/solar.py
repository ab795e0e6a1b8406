"""Where the sun stands at a place on Earth, and how high it can stand there, by the NOAA formulas of the library Astral."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, date, datetime, time, timedelta
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from skylight_sh import MissingExtraError

# Refraction is left out, and longitude and year move the sun a little: a margin keeps the range from being too narrow.
_MARGIN = math.radians(0.6)
_LONGEST = 366


@dataclass(frozen=True)
class Place:
    """A place on Earth, in degrees: ``latitude`` north of the equator, ``longitude`` east of Greenwich.

    Raises ValueError for values that no place has.
    """

    latitude: float
    longitude: float

    def __post_init__(self) -> None:
        for name, value, limit in (("latitude", self.latitude, 90), ("longitude", self.longitude, 180)):
            if not abs(value) <= limit:  # a NaN is refused as well
                raise ValueError(f"Invalid {name} {value}. Should be degrees from -{limit} to {limit}.")


def position(place: Place, moment: datetime) -> tuple[float, float]:
    """Return the sun's zenith angle and azimuth, radians, in our convention, at an aware ``moment``.

    The zenith angle is that of the sun's centre as seen, with refraction by a standard atmosphere. The azimuth runs
    from +x, east, towards +y, north, 0 to 2 pi; maps count theirs from north towards east, so it is pi/2 minus the
    map's. Within 0.01 degrees of NREL's algorithm at most hours. Raises MissingExtraError without Astral, ValueError
    for a moment without a time zone.
    """
    try:
        from astral import Observer, sun
    except ImportError as error:
        raise MissingExtraError("The sun's position needs Astral: pip install 'skylight-sh[solar]'.") from error
    if moment.tzinfo is None:
        raise ValueError(f"Invalid moment {moment.isoformat()}. Should have a time zone.")
    zenith, bearing = sun.zenith_and_azimuth(Observer(place.latitude, place.longitude), moment.astimezone(UTC))
    return math.radians(zenith), math.radians(90.0 - bearing) % (2 * math.pi)


def zenith_range(latitude: float, first: str, last: str) -> tuple[float, float]:
    """Return the least and largest zenith angle of the sun's centre in radians, the horizon at most.

    ``latitude`` is in degrees north; ``first`` and ``last`` are ISO dates, at most a year apart. Raises ValueError for dates
    that are none or in the wrong order, and where the sun never rises; MissingExtraError without Astral.

    >>> least, most = zenith_range(48.2, "2024-06-21", "2024-06-21")
    >>> round(math.degrees(least)), round(math.degrees(most))
    (24, 90)
    """
    try:
        from astral import Observer, sun
    except ImportError as error:
        raise MissingExtraError("It needs astral. Install the extra: pip install 'skylight-sh[solar]'.") from error
    start, end = date.fromisoformat(first), date.fromisoformat(last)
    days = (end - start).days
    if not 0 <= days <= _LONGEST:
        raise ValueError(f"{first} to {last} is no span of 0 to {_LONGEST} days")
    observer = Observer(latitude, 0.0)
    zeniths = []
    for day in (start + timedelta(days=n) for n in range(days + 1)):
        for when in (sun.noon(observer, day), sun.midnight(observer, day)):
            zeniths.append(math.radians(sun.zenith(observer, when, with_refraction=False)))
    low, high = min(zeniths) - _MARGIN, max(zeniths) + _MARGIN
    if low >= math.pi / 2:
        raise ValueError(f"the sun does not rise at latitude {latitude:g} from {first} to {last}")
    return max(0.0, low), min(math.pi / 2, high)


def moments(day: date, zone: str, step: int) -> Iterator[datetime]:
    """Yield the moments of ``day`` in time zone ``zone``, every ``step`` minutes from its midnight to before the next.

    The steps are even in real time: a day on which clocks change has 23 or 25 hours. Raises ValueError for an unknown
    zone or a step below one minute.

    >>> [moment.isoformat() for moment in moments(date(2024, 6, 21), "Europe/Vienna", 720)]
    ['2024-06-21T00:00:00+02:00', '2024-06-21T12:00:00+02:00']
    """
    try:
        local = ZoneInfo(zone)
    except (ZoneInfoNotFoundError, ValueError, OSError) as error:
        raise ValueError(f"Invalid timezone {zone!r}. Should be an IANA name, like UTC or Europe/Vienna.") from error
    if step < 1:
        raise ValueError(f"Invalid step {step}. Should be at least 1 minute.")
    try:
        now, end = (datetime.combine(d, time(), local).astimezone(UTC) for d in (day, day + timedelta(days=1)))
    except OverflowError as error:
        raise ValueError(f"Invalid date {day}. Should be a day of years 2 to 9998.") from error
    while now < end:
        yield now.astimezone(local)
        now += timedelta(minutes=step)
