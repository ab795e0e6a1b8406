"""How far the weights of two tables lie apart over the ranges that both have."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from skylight_sh.runtime import Floats, Runtime, Table

# Places along an axis, and at most in the whole grid.
_MOST, _SETS = 33, 20_000
_AZIMUTHS = np.arange(4) * (np.pi / 4)


@dataclass(frozen=True)
class Difference:
    """The ``greatest`` difference of two tables' weights over their first ``bands``, in the weights' unit.

    ``relative`` divides it by the largest weight of the two; ``at`` names where it is, angles in radians, ``channel``,
    degree ``l`` and order ``m`` in which weight. ``sets`` counts the places of the grid.
    """

    greatest: float
    relative: float
    bands: int
    sets: int
    at: dict[str, float]
    channel: str
    l: int
    m: int


def incomparable(first: Table, second: Table) -> str:
    """Return why the weights of two tables cannot be compared one by one; empty where they can."""
    axes = [[(axis.name, axis.unit) for axis in table.axes] for table in (first, second)]
    if axes[0] != axes[1]:
        told = (", ".join(name for name, _ in each) for each in axes)
        return f"their axes differ, {' against '.join(told)}"
    if first.channels != second.channels:
        return f"their channels differ, {', '.join(first.channels)} against {', '.join(second.channels)}"
    if first.spec.quantity != second.spec.quantity:
        return f"their quantities differ, {first.spec.quantity} against {second.spec.quantity}"
    if first.spec.azimuth != second.spec.azimuth:
        return "one takes the sun's azimuth that the other does not"
    for axis, low, high in _common(first, second):
        if low > high:
            return f"their ranges of {axis} do not meet"
    return ""


def greatest(first: Table, second: Table) -> Difference:
    """Return the greatest difference of two tables' weights on a grid over the ranges that both have, ends included.

    Its places are denser towards the ends of an axis, as Chebyshev's extrema are, where polynomials differ most.
    Raises ValueError where the weights cannot be compared, see ``incomparable``.
    """
    why = incomparable(first, second)
    if why:
        raise ValueError(f"The weights of the two tables cannot be compared: {why}.")
    turned = first.spec.azimuth is None
    count = max(3, min(_MOST, int((_SETS / (len(_AZIMUTHS) if turned else 1)) ** (1 / len(first.axes)))))
    values = {
        axis: _extrema(low, high, count) if high > low else np.array([low]) for axis, low, high in _common(first, second)
    }
    if turned:
        values["sun_azimuth"] = _AZIMUTHS
    grid = dict(zip(values, (each.ravel() for each in np.meshgrid(*values.values(), indexing="ij")), strict=True))
    bands = min(first.bands, second.bands)
    one, other = (_weights(table, grid, bands) for table in (first, second))
    apart = np.abs(one - other)
    at, channel, place = np.unravel_index(int(apart.argmax()), apart.shape)
    largest = float(max(np.abs(one).max(), np.abs(other).max()))
    widest = float(apart.max())
    degree = int(np.sqrt(place))
    return Difference(
        greatest=widest,
        relative=widest / largest if largest else 0.0,
        bands=bands,
        sets=len(apart),
        at={name: float(each[at]) for name, each in grid.items()},
        channel=first.channels[channel],
        l=degree,
        m=int(place) - degree * (degree + 1),
    )


def _weights(table: Table, grid: dict[str, Floats], bands: int) -> Floats:
    runtime = Runtime(table)
    return runtime.weights(*(grid[name] for name in runtime.inputs), bands=bands).astype(np.float64)


def _common(first: Table, second: Table) -> Sequence[tuple[str, float, float]]:
    """Return each axis' name and the range that both tables have of it."""
    pairs = zip(first.axes, first.ranges, second.ranges, strict=True)
    return [(axis.name, max(one[0], other[0]), min(one[1], other[1])) for axis, one, other in pairs]


def _extrema(low: float, high: float, count: int) -> Floats:
    """Return ``count`` places in ``[low, high]``, which are Chebyshev's extrema."""
    inner = (low + high) / 2 - (high - low) / 2 * np.cos(np.linspace(0.0, np.pi, count))
    return np.clip(inner, low, high)
