"""Turning weights about the zenith: eq. 4 of Habel, Mustata and Wimmer (2008), for generic numbers."""

from __future__ import annotations

from typing import Any

from skylight_sh.formula.elementary import cos, sin
from skylight_sh.formula.expression import expressions, program, trace
from skylight_sh.runtime import Program, turned


def waves(cosine: Any, sine: Any, bands: int) -> tuple[list[Any], list[Any]]:
    """Return cos(m phi) and sin(m phi), m = 0 .. bands - 1, by those of phi: doubling, m = h + k.

    >>> waves(0.6, 0.8, 3)
    ([1.0, 0.6, -0.28000000000000014], [0.0, 0.8, 0.96])
    """
    cosines, sines = [1.0, cosine][:bands], [0.0, sine][:bands]
    for m in range(2, bands):
        h, k = m // 2, m - m // 2
        cosines.append(cosines[h] * cosines[k] - sines[h] * sines[k])
        sines.append(sines[h] * cosines[k] + cosines[h] * sines[k])
    return cosines, sines


def waves_of_angle(bands: int) -> Program:
    """Return the program of an azimuth: all cosines, then all sines.

    >>> [round(float(wave), 4) for wave in waves_of_angle(2).run([1.0])]
    [1.0, 0.5403, 0.0, 0.8415]
    """
    return trace(lambda azimuth: [wave for part in waves(cos(azimuth), sin(azimuth), bands) for wave in part], ["azimuth"])


def stretched_waves(bands: int) -> Program:
    """Return the program of an azimuth and a radius: all cosines, then all sines, each times the m-th power of the radius.

    >>> [round(float(wave), 4) for wave in stretched_waves(2).run([1.0, 0.5])]
    [1.0, 0.2702, 0.0, 0.4207]
    """
    turned_to = trace(lambda azimuth, radius: [cos(azimuth), sin(azimuth), radius], ["azimuth", "radius"])
    return program(expressions(waves_of_turn(bands), expressions(turned_to)), ["azimuth", "radius"])


def waves_of_turn(bands: int) -> Program:
    """Return the same program of an azimuth's cosine and sine and of the radius.

    >>> [round(float(wave), 4) for wave in waves_of_turn(3).run([0.6, 0.8, 1.0])]
    [1.0, 0.6, -0.28, 0.0, 0.8, 0.96]
    """
    return trace(
        lambda cosine, sine, radius: [wave for part in waves(radius * cosine, radius * sine, bands) for wave in part],
        ["cosine", "sine", "radius"],
    )


# Of the weights of orders m and -m, m > 0, by the cosine and sine of m times the azimuth.
TURN = trace(
    lambda plus, minus, cosine, sine: [turned(plus, minus, cosine, sine), turned(minus, plus, cosine, -sine)],
    ["plus", "minus", "cosine", "sine"],
)
