"""Lookup tables as someone competent would make them: in the product's own variables, divided by its factor, as exact.

The paper's "naive tabulation" on raw axes is a straw man: even steps of the axes' own variables and the division need far
fewer points. A table interpolates linearly or by four points an axis (Lagrange's cubic), orders m >= 0 alone, in float32.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from skylight_sh.fit.axis import Axis
from skylight_sh.fit.errors import Reference, e_mean
from skylight_sh.formula import printers
from skylight_sh.formula.printers import C_SINGLE
from skylight_sh.quadrature import parameter_points
from skylight_sh.runtime import Scale
from skylight_sh.studies import compiled
from skylight_sh.studies.grid_samples import Samples, measured_at
from skylight_sh.studies.speed import race
from skylight_sh.studies.speed.candidate import Candidate, parameters, variable
from skylight_sh.table import prefactor

Array = NDArray[np.float64]

POINTS = {"linear": 2, "cubic": 4}
MOST_BYTES = 4_000_000
"""Larger tables are not made: nobody would ship them, and a compiler takes minutes."""
_EVEN = "even"
# Of several places of the pole, in ranges beyond the upper end, the one whose tables of the Preetham sky were smallest.
_AWAY = 2.2


@dataclass(frozen=True)
class Source:
    """What tables are read off: weights over ``scale``, as Chebyshev polynomials of the axes' variables.

    ``coefficients`` ``(channels, count, n_1, .., n_D)``; orders m >= 0 alone.
    """

    axes: tuple[Axis, ...]
    scale: Scale | None
    coefficients: Array

    def first_bands(self, bands: int) -> Source:
        """Return the same for fewer bands."""
        return replace(self, coefficients=self.coefficients[:, : bands * (bands + 1) // 2])

    def factor(self, sets: Array) -> Array:
        """Return what the weights at ``sets`` ``(n, axes)`` are divided by, ``(n,)``."""
        if self.scale is None:
            return np.ones(len(sets))
        return np.broadcast_to(self.scale.program.run(list(np.ascontiguousarray(sets.T)))[0], len(sets))


@dataclass(frozen=True)
class Grid:
    """A lookup table of a ``kind``: ``sizes``, and the ``values`` over the factor ``(n_1, .., n_D, channels, count)``."""

    sizes: tuple[int, ...]
    values: Array
    kind: str


def source(samples: Samples) -> Source:
    """Sample the light afresh for tables to be read off.

    The factor is the product's own where that is one factor of all weights, or else the light's closed form. A variable
    that is even in its parameter is not taken over, for it goes with the division by powers of a sine, which a table has
    not: steps of 1 / (p - v) instead, which are shorter towards the range's upper end.
    """
    config = samples.config
    axes = tuple(_uneven(axis) if axis.map == _EVEN else axis for axis in samples.axes)
    scale, hint = samples.spec.scale, config.source.hints.prefactor
    if scale is not None and len(scale.program.outputs) > 1:
        scale = prefactor.closed_form(hint, [axis.specified for axis in axes], config.scene.fixed) if hint else None
    nodes = [axis.fit_nodes(given.nodes, "chebyshev") for axis, given in zip(axes, config.axes, strict=True)]
    sets = parameter_points.grid(nodes)
    made = Source(axes, scale, np.empty(0))
    values = measured_at(config, sets).weights / made.factor(sets)[:, np.newaxis, np.newaxis]
    coefficients = np.moveaxis(values.reshape(*(n.size for n in nodes), *values.shape[1:]), (-2, -1), (0, 1))
    for axis, places in zip(axes, nodes, strict=True):
        inverse = np.linalg.inv(chebyshev.chebvander(_share(axis, places), places.size - 1))
        # The axes rotate: after as many steps as there are axes each is a polynomial's.
        coefficients = np.tensordot(coefficients, inverse, axes=(2, 1))
    return replace(made, coefficients=coefficients)


def tabulate(made: Source, sizes: Sequence[int], kind: str) -> Grid:
    """Return a table of so many even steps of the axes' variables."""
    values = made.coefficients
    for place, size in enumerate(sizes):
        degree = made.coefficients.shape[2 + place] - 1
        values = np.tensordot(values, chebyshev.chebvander(np.linspace(-1.0, 1.0, size), degree), axes=(2, 1))
    return Grid(tuple(sizes), np.moveaxis(values, (0, 1), (-2, -1)), kind)


def interpolate(grid: Grid, axes: Sequence[Axis], sets: Array) -> Array:
    """Return what a table gives over the factor at parameter sets ``(n, axes)``: ``(n, channels, count)``."""
    points = POINTS[grid.kind]
    starts, parts = [], []
    for place, (axis, size) in enumerate(zip(axes, grid.sizes, strict=True)):
        x = (_share(axis, sets[:, place]) + 1) / 2 * (size - 1)
        first = np.clip(np.floor(x).astype(np.int64) - (points // 2 - 1), 0, size - points)
        starts.append(first)
        parts.append(_lagrange(x - first, points))
    out = np.zeros((len(sets), *grid.values.shape[-2:]))
    for corner in itertools.product(range(points), repeat=len(axes)):
        share = np.prod([part[:, k] for part, k in zip(parts, corner, strict=True)], axis=0)
        out += share[:, np.newaxis, np.newaxis] * grid.values[tuple(s + k for s, k in zip(starts, corner, strict=True))]
    return out


def as_exact_as(made: Source, reference: Reference, error: float, kind: str) -> Grid | None:
    """Return the smallest table found whose largest E_mean over the sets of ``reference`` does not exceed ``error``.

    All axes are refined together until it does not, then that axis is coarsened whose coarsening leaves the smallest error,
    for as long as that does not exceed it. Returns None where ``MOST_BYTES`` do not suffice. ``reference`` has orders m >= 0
    alone, of as many bands as ``made`` or more.
    """
    channels, count = made.coefficients.shape[:2]
    factor = made.factor(reference.parameters)
    truth = reference.weights[..., :count] / factor[:, np.newaxis, np.newaxis]
    # Orders m < 0 are 0 at azimuth 0, where E_mean is measured.
    least = reference.headline / factor

    def off(sizes: Sequence[int]) -> float:
        return e_mean(interpolate(tabulate(made, sizes, kind), made.axes, reference.parameters) - truth, least)

    def size_of(sizes: Sequence[int]) -> int:
        return int(4 * channels * count * math.prod(sizes))

    sizes = [POINTS[kind]] * len(made.axes)
    while off(sizes) > error:
        sizes = [math.ceil(1.25 * size) + 1 for size in sizes]
        if size_of(sizes) > 8 * MOST_BYTES:
            return None
    for share in (0.2, 0.1, 0.05, 0.02, 0.0):
        while True:
            trials = []
            for axis, size in enumerate(sizes):
                smaller = min(size - 1, round((1 - share) * size))
                if smaller >= POINTS[kind]:
                    trial = [*sizes[:axis], smaller, *sizes[axis + 1 :]]
                    trials.append((off(trial), trial))
            found, trial = min(trials, default=(math.inf, sizes))
            if found > error:
                break
            sizes = trial
    return tabulate(made, sizes, kind) if size_of(sizes) <= MOST_BYTES else None


def candidate(grid: Grid, made: Source, rival_of: str) -> Candidate:
    """Return a table as a rival of the one it is as exact as."""
    steps = made.scale.program.steps if made.scale else ()
    numbers = sum(step[0] in ("number", "constant") for step in steps) + sum(4 + len(axis.constants) for axis in made.axes)
    bands = _bands(grid)
    return Candidate(header(grid, made), 4 * (int(grid.values.size) + numbers), bands, f"lookup, {grid.kind}", rival_of)


def header(grid: Grid, made: Source) -> str:
    """Return C with the tables' API, changes of variable and factor being those of ``made``."""
    channels, count = grid.values.shape[-2:]
    outputs, points = channels * count, POINTS[grid.kind]
    strides = [outputs * math.prod(grid.sizes[place + 1 :]) for place in range(len(grid.sizes))]
    axes = []
    for axis, size, stride in zip(made.axes, grid.sizes, strides, strict=True):
        low, high = _ends(axis)
        step = C_SINGLE.number((size - 1) / (high - low))
        axes.append(variable(axis) | {"size": size, "stride": stride, "first": C_SINGLE.number(low), "step": step})
    corners = [
        {"number": number, "places": places, "offset": sum(k * stride for k, stride in zip(places, strides, strict=True))}
        for number, places in enumerate(itertools.product(range(points), repeat=len(axes)))
    ]
    lines: list[str] = []
    text = C_SINGLE.number(1.0)
    if made.scale:
        lines, (text,) = printers.statements(made.scale.program, C_SINGLE, [f"x[{i}]" for i in range(len(axes))])
    return race.template(
        "lookup.h.j2",
        p=compiled.PREFIX,
        P=compiled.PREFIX.upper(),
        bands=_bands(grid),
        channels=channels,
        outputs=outputs,
        numbers=[C_SINGLE.number(value) for value in grid.values.ravel().tolist()],
        parameters=parameters(made.axes),
        axes=axes,
        points=points,
        before=points // 2 - 1,
        corners=corners,
        scale_lines=lines,
        scale=text,
    )


def _uneven(axis: Axis) -> Axis:
    return replace(axis, map="reciprocal", point=axis.high + _AWAY * (axis.high - axis.low))


def _bands(grid: Grid) -> int:
    return math.isqrt(2 * grid.values.shape[-1])


def _lagrange(t: Array, points: int) -> Array:
    """Return the weights ``(n, points)`` of points 0, 1, .. at ``t``."""
    places = range(points)
    factors = [[(t - j) / (k - j) for j in places if j != k] for k in places]
    return np.stack([np.prod(row, axis=0) for row in factors], axis=-1)


def _ends(axis: Axis) -> tuple[float, float]:
    """Return the least and the largest value of an axis's variable."""
    low, high = sorted(axis.scaled(np.array([axis.low, axis.high])).tolist())
    return low, high


def _share(axis: Axis, values: Array) -> Array:
    """Return an axis's variable on [-1, 1], whatever its scale."""
    low, high = _ends(axis)
    return np.asarray((2 * axis.scaled(values) - low - high) / (high - low), dtype=np.float64)
