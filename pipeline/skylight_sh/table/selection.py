"""Selection: under each error budget the fastest or the smallest table, tried as shipped.

What is decided here hangs on rounded numbers alone, so that every machine selects the same tables: see ``reproducible``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError
from skylight_sh.fit.axis import Axis
from skylight_sh.fit.errors import Reference, l_min
from skylight_sh.fit.minimax import even, metric
from skylight_sh.fit.quantisation import smallest
from skylight_sh.fit.sampled import Sampled
from skylight_sh.fit.sweep import Worst
from skylight_sh.fit.term_selection import Known, fewest
from skylight_sh.reproducible import significant, to_grid
from skylight_sh.runtime import Specification, Surroundings, Table
from skylight_sh.sphere import Harmonics
from skylight_sh.table import packed
from skylight_sh.table import table as tables
from skylight_sh.table.errors import headline
from skylight_sh.table.grid_fit import factor_at, sines_at
from skylight_sh.table.request import Request
from skylight_sh.table.row_layout import stored
from skylight_sh.table.size import bytes_of

Array = NDArray[np.float64]
Index = NDArray[np.int64]
# Bytes and E_mean of a table that was tried.
Point = tuple[float, float]

# How often a table that float32 carries over its budget is sought again, with a budget how much below proportion.
_RETRIES = 4
_SHRINK = 0.995
# Kept in hand of every budget: sets that selection does not see may err this much more than those that it sees.
_IN_HAND = 0.03
# Of the largest coefficient of a table laid out for speed: finer ones would be the last bits of the machine that fitted it.
_GRID_BITS = {"float32": 24, "float64": 32}
# Of L_min where it only weighs the sets of a fit against each other; errors have a finer one.
_WEIGHT_BITS = 6
# Of budgets that a search makes of errors it met.
_BUDGET_BITS = 10
# Budgets tried for a size: the last two differ by a few per cent.
_SIZE_STEPS = 9
# Searches start from degrees whose whole fit errs this much less than the budget.
_HEADROOM = 10.0


class BudgetError(UserError, RuntimeError):
    """No table of the config's degrees meets a budget."""


@dataclass(frozen=True)
class SearchData:
    """What every search needs: specification, the fit grid's sets, weights and L_min, and what errors are checked on.

    ``axes`` are the specification's as the fit has them, ``surroundings`` those of each number of bands; ``shape`` is that
    of the fit grid, ``checked_shape`` that of the grid at the start of ``reference``; ``degrees`` the largest, an axis;
    ``swept`` ``(combinations, axes)`` the degrees of the sweep and ``swept_error`` ``(combinations, channels, bands)`` their
    E_mean. ``window`` is what a table of these harmonics multiplies its weights with, ``(count,)``.
    """

    spec: Specification
    axes: tuple[Axis, ...]
    surroundings: Mapping[int, Surroundings]
    sets: Array
    weights: Array
    least: Array
    shape: tuple[int, ...]
    checked_shape: tuple[int, ...]
    degrees: tuple[int, ...]
    reference: Reference
    swept: Index
    swept_error: Array
    window: Callable[[Harmonics], Array]

    def reference_of(self, bands: int) -> Reference:
        """Return what a table of ``bands`` bands is measured against."""
        return self.reference.windowed(bands, self.window(stored(self.spec, bands)))

    def enough(self, bands: int, budget: float) -> tuple[int, ...]:
        """Return the fewest degrees whose whole fit stays well within ``budget``, by the sweep; all where none does."""
        error = self.swept_error[:, :, bands - 1].max(axis=1)
        found = self.swept[error <= budget / _HEADROOM]
        if not len(found):
            return self.degrees
        return tuple(found[np.prod(found + 1, axis=1).argmin()].tolist())


@dataclass(frozen=True)
class Selected:
    """A table that meets its request, and bytes and E_mean of all that were tried on the way."""

    request: Request
    table: Table
    tried: list[Point]


def search_data(
    spec: Specification,
    axes: tuple[Axis, ...],
    surroundings: Mapping[int, Surroundings],
    grid: Reference,
    shape: tuple[int, ...],
    reference: Reference,
    checked_shape: tuple[int, ...],
    degrees: tuple[int, ...],
    sweep: Worst,
    window: Callable[[Harmonics], Array],
) -> SearchData:
    """Gather what the searches need: the fit ``grid`` and its ``shape``, the rest as ``SearchData`` has it.

    Where any set that is checked has no positive least luminance, the fit's sets are weighed by their mean too.
    """
    least = grid.least * ("mean" not in reference.l_min)
    least = significant(next(iter(l_min(least, grid.mean).values())), _WEIGHT_BITS)
    errors = next(iter(sweep.e_mean.values()))
    return SearchData(
        *(spec, axes, surroundings, grid.parameters, grid.weights, least, shape, checked_shape, degrees, reference),
        *(np.array(sweep.degrees), errors, window),
    )


def groups(requests: Sequence[Request]) -> list[list[Request]]:
    """Return the requests with a budget or a size by bands, number type and limit: each group is one worker's.

    The hardest come first, so that no worker waits long for the other's last one.

    >>> asked = [Request("loose", 4, budget=0.1), Request("tight", 7, budget=0.01)]
    >>> [[request.name for request in group] for group in groups(asked)]
    [['tight'], ['loose']]
    """
    found: dict[tuple[int, str, float], list[Request]] = {}
    for request in requests:
        if request.degrees is None:
            limit = request.budget or float(request.size or 0)
            found.setdefault((request.bands, request.dtype, limit), []).append(request)
    return [group for _, group in sorted(found.items(), key=lambda g: (-g[0][0], g[0][2]))]


def select(group: Sequence[Request], data: SearchData) -> list[Selected]:
    """Search the tables of one budget or size, each for itself. Raises BudgetError where one cannot be had."""
    return [
        Selected(
            request,
            *(
                _cheapest(request, request.budget or 0.0, data)
                if request.size is None
                else _within(request, request.size, data)
            ),
        )
        for request in group
    ]


def given(request: Request, coefficients: Array, data: SearchData) -> Table:
    """Return the table of the degrees that ``request`` gives, cut out of the fit's ``coefficients``, rounded."""
    degrees = request.degrees or ()
    cut = coefficients[(slice(None), slice(None), *(slice(d + 1) for d in degrees))]
    harmonics = stored(data.spec, request.bands)
    cut = cut[:, : harmonics.count] * data.window(harmonics).reshape(-1, *(1,) * (cut.ndim - 2))
    around = data.surroundings.get(request.bands)
    return tables.whole(data.spec, _gridded(data, cut, request.dtype), request.bands, request.dtype, around)


def pareto_front(points: Sequence[Point]) -> list[Point]:
    """Return the points that no other beats in both bytes and error, by rising bytes.

    >>> pareto_front([(300, 0.1), (100, 0.5), (200, 0.6)])
    [(100, 0.5), (300, 0.1)]
    """
    kept: list[Point] = []
    for size, error in sorted(points):
        if not kept or error < kept[-1][1]:
            kept.append((size, error))
    return kept


def _gridded(data: SearchData, dense: Array, dtype: str) -> Array:
    """Round coefficients; not those of monomials, whose sums cancel: they are their machine's, as the paper's were."""
    return dense if data.spec.basis == "monomial" else to_grid(dense, _GRID_BITS[dtype])


def _cheapest(request: Request, asked: float, data: SearchData) -> tuple[Table, list[Point]]:
    """Search with a budget that shrinks until the table as shipped meets the one asked for; also return all tried."""
    budget = (1.0 - _IN_HAND) * asked
    aim, reached, front, known = budget, np.inf, [], None
    data = replace(data, degrees=data.enough(request.bands, budget))
    for _ in range(_RETRIES):
        if request.layout == "packed":
            table, tried = _packed(request, aim, data)
        else:
            table, tried, known = _fast(request, aim, data, known)
        front += tried
        if table is None:
            reached = _whole_error(request, data)
            break
        reached = headline(table, data.reference_of(request.bands), data.checked_shape)
        if reached <= budget:
            return table, front
        aim = float(significant(aim * _SHRINK * budget / reached, _BUDGET_BITS))
    raise BudgetError(
        f"No table of {request.bands} bands meets winners.budgets = {asked:g}: {request.name} reaches "
        f"{reached:.3g} with all degrees, and {_IN_HAND:.0%} of a budget are kept in hand. Raise the budget, or the "
        "largest degrees of the axes."
    )


def _whole_error(request: Request, data: SearchData) -> float:
    """Return the error of all terms of the largest degrees, in double precision."""
    grid, checked = _both(replace(data, degrees=tuple(data.swept.max(axis=0))), request.bands)
    return checked.largest(metric(grid, even(grid)).best)


def _within(request: Request, size: int, data: SearchData) -> tuple[Table, list[Point]]:
    """Search the least error that ``size`` bytes allow, by bisecting the budget."""
    low, high = float(np.log(1e-7)), float(np.log(0.5))
    front: list[Point] = []
    best: Table | None = None
    for _ in range(_SIZE_STEPS):
        middle = (low + high) / 2
        try:
            table, tried = _cheapest(request, float(significant(np.exp(middle), _BUDGET_BITS)), data)
        except BudgetError:
            low = middle
            continue
        front += tried
        if bytes_of(table) <= size:
            best, high = table, middle
        else:
            low = middle
    if best is None:
        raise BudgetError(
            f"No table of {request.bands} bands fits winners.sizes = {size} bytes with an E_mean below 50 %. "
            "Raise the size, or lower the bands."
        )
    return best, front


def _sampled(data: SearchData, sets: Array, weights: Array, least: Array, shape: tuple[int, ...], bands: int) -> Sampled:
    spec = data.spec
    harmonics = stored(spec, bands)
    scaled = least[:, np.newaxis, np.newaxis]
    parity = str(spec.peak_axis) if spec.parity else ""
    return Sampled(
        np.asarray(tables.products(spec.basis, data.axes, sets, data.degrees), dtype=np.float64),
        factor_at(spec.scale, sets, len(spec.channels)) / scaled,
        weights[..., : harmonics.count] * data.window(harmonics) / scaled,
        sines_at(data.axes, parity, sets),
        np.abs(harmonics.orders) * spec.parity,
        shape,
        _along(data, sets, shape),
    )


def _along(data: SearchData, sets: Array, shape: tuple[int, ...]) -> tuple[Array, ...]:
    """Return the basis at the nodes of each axis of the grid of ``shape`` that the first of ``sets`` are on."""
    grid = sets[: np.prod(shape, dtype=int)].reshape(*shape, -1)
    found = []
    for i, (axis, degree) in enumerate(zip(data.axes[: len(shape)], data.degrees, strict=False)):
        nodes = np.moveaxis(grid[..., i], i, 0).reshape(shape[i], -1)[:, :1]
        found.append(np.asarray(tables.products(data.spec.basis, [axis], nodes, [degree]), dtype=np.float64))
    return tuple(found)


def _both(data: SearchData, bands: int) -> tuple[Sampled, Sampled]:
    """Return the fit grid and the verification sets in units of L_min."""
    reference = data.reference
    grid = _sampled(data, data.sets, data.weights, data.least, data.shape, bands)
    shape = data.checked_shape
    return grid, _sampled(data, reference.parameters, reference.weights, reference.headline, shape, bands)


def _fast(
    request: Request, aim: float, data: SearchData, known: Known | None
) -> tuple[Table | None, list[Point], Known | None]:
    """Return the table, all tried, and its terms; ``known`` are those of a try that float32 carried over its budget."""
    bands, dtype, first = request.bands, request.dtype, data.degrees[0] + 1
    best, tried = fewest(*_both(data, bands), data.shape, first, aim, known)
    rest = tuple(d + 1 for d in data.degrees[1:])
    empty = np.zeros((data.spec.classes, stored(data.spec, bands).count, first, *rest))

    def table(lengths: Index, dense: Array) -> Table:
        shaped = _gridded(data, dense.reshape(empty.shape), dtype)
        return tables.fast(data.spec, shaped, lengths.reshape(-1, *rest), bands, dtype, data.surroundings.get(bands))

    points = [(float(bytes_of(table(k.lengths, empty))), k.error) for k in tried]
    return (table(best.lengths, best.dense), points, (best, tried)) if best else (None, points, None)


def _packed(request: Request, aim: float, data: SearchData) -> tuple[Table | None, list[Point]]:
    bands, first = request.bands, data.degrees[0] + 1
    degrees = stored(data.spec, bands).degrees

    def cost(numbers: Index) -> int:
        return packed.cost(numbers.swapaxes(0, 1), degrees)

    best, tried = smallest(*_both(data, bands), data.shape, first, aim, cost)
    if best is None:
        return None, [(float(r.cost), r.error) for r in tried]
    numbers, around = best.numbers.swapaxes(0, 1), data.surroundings.get(bands)
    table = tables.small(data.spec, numbers, best.step, data.degrees, bands, around)
    fixed = bytes_of(table) - best.cost
    return table, [(float(r.cost + fixed), r.error) for r in tried]
