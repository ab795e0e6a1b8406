"""Numbers of few decimal digits as whole numbers of two bytes: how packed tables keep the published constants of a model."""

from __future__ import annotations

from collections.abc import Sequence

_LARGEST, _POWERS = 2**16 - 1, range(7)


def short(value: float) -> tuple[int, int] | None:
    """Return n and p of ``value`` = n / 10^p with the size of n in two bytes, or nothing.

    >>> short(-1.463), short(0.26688), short(3.7389856)
    ((-1463, 3), (26688, 5), None)
    """
    for power in _POWERS:
        whole = round(value * 10**power)
        if abs(whole) <= _LARGEST and whole / 10**power == value:
            return whole, power
    return None


def bytes_of_numbers(values: Sequence[float], itemsize: int = 4) -> int:
    """Return how many bytes numbers take: two for each other n, and a number for each power of ten but 1 and for the rest.

    >>> bytes_of_numbers([0.1, 0.2, -0.1, 3.7389856])
    12
    """
    found = [short(value) for value in values]
    whole, powers = {abs(one[0]) for one in found if one}, {one[1] for one in found if one and one[1]}
    return 2 * len(whole) + itemsize * (len(powers) + found.count(None))
