"""Spherical lights: what their zonal weights cost by closed forms and by recurrences, counted and timed."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.light import spherical_lights
from skylight_sh.studies import outcomes
from skylight_sh.studies.page import Row, Section
from skylight_sh.studies.timing import medians

TEXT = (
    "Zonal weights of a disc (Mezieres and Paulin). Additions and multiplications are counted by running each scheme on "
    "numbers that count, constants folded and powers of sine and cosine given, as the paper counts them: closed forms "
    "(Sloan 2008) cost what it says, 3/5 for 3 bands and 13/19 for 6. It says 3/6 and 6/18 for its recurrence without "
    "writing out its simplification; `recurrence` is on the weights themselves, `stable` is ours, which keeps its digits at "
    "every radius. Microseconds are for 10 bands: zonal weights from the formula or from a table of 1,024 "
    "angles, interpolated, whose `error` is the largest of any light, over sqrt((2l+1) / 4 pi) times its solid angle; "
    "and all SH weights of so many lights, which also turns them: at one receiver, which is a frame of lights far away, "
    "and at a thousand, as a scene with its lights nearby needs them, each frame anew (the paper's figure 1: ten lights on "
    "10 bands)."
)
Array = NDArray[np.float64]

_BANDS = 10
_TABLE = 1024
_LIGHTS, _RECEIVERS = 10, 1_000


@dataclass
class Tally:
    """How many operations were counted."""

    additions: int = 0
    multiplications: int = 0


class Counted:
    """A number that counts the additions and multiplications it takes part in; those among constants are free."""

    def __init__(self, value: float, tally: Tally) -> None:
        self.value, self._tally = value, tally

    def _other(self, other: Counted | float) -> float:
        return other.value if isinstance(other, Counted) else other

    def __add__(self, other: Counted | float) -> Counted:
        self._tally.additions += 1
        return Counted(self.value + self._other(other), self._tally)

    def __sub__(self, other: Counted | float) -> Counted:
        return self + -self._other(other)

    def __rsub__(self, other: float) -> Counted:
        self._tally.additions += 1
        return Counted(other - self.value, self._tally)

    def __mul__(self, other: Counted | float) -> Counted:
        self._tally.multiplications += 1
        return Counted(self.value * self._other(other), self._tally)

    __rmul__ = __mul__


Scheme = Callable[[Callable[[float], Counted], float, int], list[Counted]]


def closed_forms(given: Callable[[float], Counted], angle: float, bands: int) -> list[Counted]:
    """Return the first 1 to 6 weights by Sloan's forms, factored in cos a - 1 and cos a + 1."""
    c = given(math.cos(angle))
    c2, c4, s2 = (given(v) for v in (math.cos(angle) ** 2, math.cos(angle) ** 4, math.sin(angle) ** 2))
    pi = math.sqrt(math.pi)
    forms: list[Callable[[], Counted]] = [
        lambda: pi * (1.0 - c),
        lambda: pi * math.sqrt(3) / 2 * s2,
        lambda: -pi * math.sqrt(5) / 2 * c * (c - 1.0) * (c + 1.0),
        lambda: -pi * math.sqrt(7) / 8 * (c - 1.0) * (c + 1.0) * (5.0 * c2 - 1.0),
        lambda: -pi * 3 / 8 * c * (c - 1.0) * (c + 1.0) * (7.0 * c2 - 3.0),
        lambda: -pi * math.sqrt(11) / 16 * (c - 1.0) * (c + 1.0) * (21.0 * c4 - 14.0 * c2 + 1.0),
    ]
    return [form() for form in forms[:bands]]


def recurrence(given: Callable[[float], Counted], angle: float, bands: int) -> list[Counted]:
    """Return the weights by the three-term recurrence that eq. 12 becomes when written for the weights themselves."""
    c = given(math.cos(angle))
    out = [math.sqrt(math.pi) * (1.0 - c), math.sqrt(3 * math.pi) / 2 * (1.0 - c * c)]
    out.append(math.sqrt(5 / 3) * c * out[1])
    for l in range(2, bands - 1):
        up = math.sqrt((2 * l + 1) * (2 * l + 3)) / (l + 2)
        back = (l - 1) / (l + 2) * math.sqrt((2 * l + 3) / (2 * l - 1))
        out.append(up * c * out[l] - back * out[l - 1])
    return out[:bands]


def stable(given: Callable[[float], Counted], angle: float, bands: int) -> list[Counted]:
    """Return the weights as ``sphere.cap`` computes them, in steps of ``1 - cos a``."""
    t, area = given(1.0 - math.cos(angle)), given(math.pi * math.sin(angle) ** 2)
    out, step, ratio = [math.sqrt(math.pi) * t, math.sqrt(3 / (4 * math.pi)) * area], -1.0 * t, 1.0 - t
    for l in range(2, bands):
        if l > 2:
            step = (l - 2) / (l + 1) * step - (2 * l - 1) / (l + 1) * t * ratio
            ratio = ratio + step
        out.append(math.sqrt((2 * l + 1) / (4 * math.pi)) * area * ratio)
    return out[:bands]


def operations(scheme: Scheme, bands: int) -> tuple[int, int]:
    """Return how many additions and multiplications a scheme needs for so many bands."""
    tally = Tally()
    scheme(lambda value: Counted(value, tally), 0.3, bands)
    return tally.additions, tally.multiplications


def section(repeats: int) -> Section:
    """Count operations for 3 and 6 bands; time 10 and 1,000 lights on 10."""
    rows: list[Row] = [
        _row(f"{title}, {bands} bands", operations(scheme, bands))
        for bands in (3, 6)
        for title, scheme in (("closed forms", closed_forms), ("recurrence", recurrence), ("recurrence, stable", stable))
    ]
    rows += [_row(f"recurrence, as the paper counts, {n} bands", counted) for n, counted in ((3, (3, 6)), (6, (6, 18)))]
    table = sphere.cap(np.linspace(0.0, np.pi, _TABLE), _BANDS)
    for lights in (10, 1_000):
        draw = np.random.default_rng(3)
        centres, radii = draw.normal(size=(lights, 3)) + np.array([0.0, 0.0, 8.0]), draw.random(lights)
        angles, _ = spherical_lights.half_angles(centres, radii)
        calls: dict[str, Callable[[], object]] = {
            "zonal, formula": partial(sphere.cap, angles, _BANDS),
            "zonal, table": partial(_look_up, table, angles),
            "all weights": partial(spherical_lights.spheres, centres, radii, _BANDS),
        }
        size = np.sqrt((2 * np.arange(_BANDS) + 1) / (4 * np.pi)) * 4 * np.pi * np.sin(angles / 2)[:, np.newaxis] ** 2
        lost = float((np.abs(_look_up(table, angles) - sphere.cap(angles, _BANDS)) / size).max())
        for title, seconds in medians(calls, repeats, at_least=1e-3).items():
            error = lost if title == "zonal, table" else None
            rows.append(_row(f"{title}, {lights} lights", microseconds=1e6 * seconds, error=error))
    rows.append(_nearby(repeats))
    return Section("discs", "Spherical lights", TEXT, rows, told=outcomes.discs(rows))


def _nearby(repeats: int) -> Row:
    """Time the weights of ten lights at each of a thousand receivers."""
    draw = np.random.default_rng(4)
    centres, radii = draw.normal(size=(_LIGHTS, 3)) + np.array([0.0, 0.0, 8.0]), draw.random(_LIGHTS)
    receivers = draw.normal(size=(_RECEIVERS, 1, 3))
    call = partial(spherical_lights.spheres, centres, radii, _BANDS, receivers)
    seconds = medians({"nearby": call}, repeats)["nearby"]
    return _row(f"all weights, {_LIGHTS} lights at {_RECEIVERS:,} receivers", microseconds=1e6 * seconds)


def _row(
    what: str, counted: tuple[int, int] | None = None, microseconds: float | None = None, error: float | None = None
) -> Row:
    additions, multiplications = counted or (None, None)
    return {
        "what": what,
        "additions": additions,
        "multiplications": multiplications,
        "microseconds": microseconds,
        "error": error,
    }


def _look_up(table: Array, angles: Array) -> Array:
    at = angles * ((_TABLE - 1) / np.pi)
    low = np.minimum(at.astype(np.int64), _TABLE - 2)
    share = (at - low)[..., np.newaxis]
    return np.asarray(table[low] * (1.0 - share) + table[low + 1] * share)
