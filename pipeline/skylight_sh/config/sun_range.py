"""What the sun's zenith angle can be at a latitude, from one day to another."""

from __future__ import annotations

import math
from datetime import date, timedelta
from typing import Any

# Refraction is left out, and longitude and year move the sun a little: a margin keeps the range from being too narrow.
_MARGIN = math.radians(0.6)
_LONGEST = 366


def zenith_range(latitude: float, first: str, last: str) -> tuple[float, float]:
    """Return the least and largest zenith angle of the sun's centre in radians, the horizon at most.

    ``first`` and ``last`` are ISO dates, at most a year apart. Raises ValueError for dates that are none or in the wrong
    order, and where the sun never rises; ImportError where astral is not installed.
    """
    from astral import Observer, sun

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


def narrow(raw: dict[str, Any]) -> str | None:
    """Narrow the sun_zenith axis of a parsed config to its scene's sun, in place; return what is wrong, or None.

    Whatever does not have the expected shape is left to the schema.
    """
    scene = raw.get("scene")
    asked = scene.get("sun") if isinstance(scene, dict) else None
    axes = raw.get("axes")
    if not isinstance(asked, dict) or not isinstance(axes, list):
        return None
    axis = next((a for a in axes if isinstance(a, dict) and a.get("name") == "sun_zenith"), None)
    match asked, axis:
        case {"latitude": int() | float() as latitude, "dates": [str() as first, str() as last]}, {"range": [low, high]}:
            pass
        case _:
            return None
    if not all(isinstance(value, int | float) for value in (low, high)) or axis is None or abs(latitude) > 90:
        return None
    try:
        least, largest = zenith_range(float(latitude), first, last)
    except ImportError:
        return "It needs astral. Install the extra: pip install 'skylight-sh[solar]'."
    except ValueError as error:
        return f"{error}. Give two ISO dates, the first not after the second, on which the sun rises."
    axis["range"] = [max(least, low), min(largest, high)]
    return None
