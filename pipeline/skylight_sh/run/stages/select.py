"""Select: under each error budget the fastest or the smallest table, tried as shipped.

What is decided here hangs on rounded numbers alone, so that every machine selects the same tables: see ``reproducible``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError, sphere
from skylight_sh.config.schema import Config
from skylight_sh.config.wanted import Wanted, wanted
from skylight_sh.export import npz
from skylight_sh.fit.errors import Reference, l_min, mean_luminance
from skylight_sh.fit.minimax import Sampled, even, metric
from skylight_sh.fit.quantisation import smallest
from skylight_sh.fit.term_selection import fewest
from skylight_sh.quadrature import parameter_points as parameter_sets
from skylight_sh.reproducible import significant, to_grid
from skylight_sh.run.executors import Advance, map_tasks
from skylight_sh.run.plan import Inputs, Step
from skylight_sh.run.stages.fit import reference_of, swept, truth_inputs
from skylight_sh.scene.axes import fit_nodes, variables
from skylight_sh.scene.fold import folded, luminance_scale, window, windowed_reference
from skylight_sh.scene.frame import frame_of, surrounded
from skylight_sh.store.dataset import Dataset, Variable
from skylight_sh.table import packed
from skylight_sh.table import prefactor as factors
from skylight_sh.table import table as tables
from skylight_sh.table.errors import headline
from skylight_sh.table.table import Frame, Table

Array = NDArray[np.float64]
# Bytes and E_mean of a table that was tried.
Point = tuple[float, float]
Result = tuple[Wanted, Table, list[Point]]

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
# One in so many of the sets that selection sees tells which degrees are enough.
_SWEPT_EACH = 8
# Budgets tried for a size: the last two differ by a few per cent.
_SIZE_STEPS = 9
# Searches start from degrees whose whole fit errs this much less than the budget.
_HEADROOM = 10.0


class BudgetError(UserError, RuntimeError):
    """No table of the config's degrees meets a budget."""


@dataclass(frozen=True)
class _Material:
    """What every search needs: the frame, the fit grid's weights, L_min and nodes, and what errors are checked on.

    ``shape`` is that of the fit grid, ``checked_shape`` that of the grid at the start of ``reference``.
    """

    frame: Frame
    sets: Array
    weights: Array
    least: Array
    shape: tuple[int, ...]
    checked_shape: tuple[int, ...]
    degrees: tuple[int, ...]
    reference: Reference
    swept: NDArray[np.int64]
    swept_error: Array
    window: Callable[[int, NDArray[np.int64], NDArray[np.int64]], Array]
    behind_window: Callable[[int, bool, Reference], Reference]

    def windowed(self, bands: int) -> Array:
        """Return what a table of ``bands`` bands multiplies its weights with, ``(count,)``."""
        return self.window(bands, *sphere.degrees_orders(bands, mirrored=self.frame.mirrored))

    def reference_of(self, bands: int) -> Reference:
        """Return what a table of ``bands`` bands is measured against."""
        return self.behind_window(bands, self.frame.mirrored, self.reference)

    def enough(self, bands: int, budget: float) -> tuple[int, ...]:
        """Return the fewest degrees whose whole fit stays well within ``budget``, by the sweep; all where none does."""
        error = self.swept_error[:, :, bands - 1].max(axis=1)
        found = self.swept[error <= budget / _HEADROOM]
        if not len(found):
            return self.degrees
        return tuple(found[np.prod(found + 1, axis=1).argmin()].tolist())


def steps(config: Config) -> list[Step]:
    """Return the selection's step."""
    parameters = {"winners": [winner.model_dump(mode="json") for winner in config.winners]}
    needed = ("fit", "truth/grid", *variables(config), *surrounded(config), *truth_inputs(config))
    return [Step("select", "", needed, parameters, partial(_make, config))]


def _make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    material = _gather(config, inputs)
    asked = wanted(config)
    made = {table.name: _given(table, material, inputs["fit"]) for table in asked if table.winner.degrees is not None}
    groups: dict[tuple[int, str, float], list[Wanted]] = {}
    for table in asked:
        if table.winner.degrees is None:
            limit = table.budget or float(table.size or 0)
            groups.setdefault((table.winner.bands, table.winner.dtype, limit), []).append(table)
    run = config.run
    # The hardest first, so that no worker waits long for the other's last one.
    jobs = [partial(_searched, group, material) for _, group in sorted(groups.items(), key=lambda g: (-g[0][0], g[0][2]))]
    results = map_tasks(_call, jobs, executor=run.executor, workers=run.workers, advance=advance)
    fronts: dict[tuple[int, str], list[Point]] = {}
    for table, best, tried in (result for group in results for result in group):
        made[table.name] = best
        fronts.setdefault((table.winner.bands, table.layout), []).extend(tried)
    found: dict[str, Variable] = {}
    for table in asked:
        found[f"tables/{table.name}/npz"] = Variable(("byte",), np.frombuffer(npz.write(made[table.name]), dtype=np.uint8))
    for (bands, layout), points in sorted(fronts.items()):
        found[f"fronts/{bands}-{layout}"] = Variable(("point", "bytes_error"), np.array(_front(points)))
    return Dataset(found, {})


def _call(job: Callable[[], list[Result]]) -> list[Result]:
    return job()


def _searched(group: Sequence[Wanted], material: _Material) -> list[Result]:
    """Search the tables of one budget or size, each for itself."""
    return [
        (
            table,
            *(
                _cheapest(table, table.budget or 0.0, material)
                if table.size is None
                else _within(table, table.size, material)
            ),
        )
        for table in group
    ]


def _gather(config: Config, inputs: Inputs) -> _Material:
    grid = inputs["truth/grid"]
    frame = frame_of(config, inputs, mirrored=bool(grid.attrs["mirrored"]))
    nodes = fit_nodes(config, frame.axes)
    shape = tuple(n.size for n in nodes)
    reference = reference_of(config, inputs, truth_inputs(config))
    radiance = grid["weights"].reshape(-1, *grid["weights"].shape[-2:])
    sets = parameter_sets.grid(nodes)
    weights, scale = folded(config, radiance, grid["degree"], sets), luminance_scale(config)
    mean = mean_luminance(radiance[:, :, 0], config.source.luminance_row)
    # Where any set that is checked has no positive least luminance, all have their mean.
    least = scale * grid["least_luminance"].ravel() * ("mean" not in reference.l_min)
    least = significant(next(iter(l_min(least, scale * mean).values())), _WEIGHT_BITS)
    checked_shape = inputs["truth/verification"]["least_luminance"].shape
    degrees = tuple(axis.degrees[1] for axis in config.axes)
    worst = swept(config, inputs, reference.some(_SWEPT_EACH), max(winner.bands for winner in config.winners))
    errors = next(iter(worst.e_mean.values()))
    return _Material(
        *(frame, sets, weights, least, shape, checked_shape, degrees, reference, np.array(worst.degrees), errors),
        *(partial(window, config), partial(windowed_reference, config)),
    )


def _given(table: Wanted, material: _Material, fit: Dataset) -> Table:
    degrees = table.winner.degrees or ()
    cut = fit["coefficients"][(slice(None), slice(None), *(slice(d + 1) for d in degrees))]
    bands = table.winner.bands
    count = sphere.count(bands, mirrored=material.frame.mirrored)
    cut = cut[:, :count] * material.windowed(bands).reshape(-1, *(1,) * (cut.ndim - 2))
    return tables.whole(material.frame, _gridded(material, cut, table.winner.dtype), bands, table.winner.dtype)


def _gridded(material: _Material, dense: Array, dtype: str) -> Array:
    """Round coefficients; not those of monomials, whose sums cancel: they are their machine's, as the paper's were."""
    return dense if material.frame.basis == "monomial" else to_grid(dense, _GRID_BITS[dtype])


def _cheapest(wanted_: Wanted, asked: float, material: _Material) -> tuple[Table, list[Point]]:
    """Search with a budget that shrinks until the table as shipped meets the one asked for; also return all tried."""
    budget = (1.0 - _IN_HAND) * asked
    aim, reached, front, known = budget, np.inf, [], None
    material = replace(material, degrees=material.enough(wanted_.winner.bands, budget))
    for _ in range(_RETRIES):
        if wanted_.layout == "packed":
            table, tried = _packed(wanted_, aim, material)
        else:
            table, tried, known = _fast(wanted_, aim, material, known)
        front += tried
        if table is None:
            reached = _whole_error(wanted_, material)
            break
        reached = headline(table, material.reference_of(wanted_.winner.bands), material.checked_shape)
        if reached <= budget:
            return table, front
        aim = float(significant(aim * _SHRINK * budget / reached, _BUDGET_BITS))
    raise BudgetError(
        f"No table of {wanted_.winner.bands} bands meets winners.budgets = {asked:g}: {wanted_.name} reaches "
        f"{reached:.3g} with all degrees, and {_IN_HAND:.0%} of a budget are kept in hand. Raise the budget, or the "
        "largest degrees of the axes."
    )


def _whole_error(wanted_: Wanted, material: _Material) -> float:
    """Return the error of all terms of the largest degrees, in double precision."""
    grid, checked = _both(replace(material, degrees=tuple(material.swept.max(axis=0))), wanted_.winner.bands)
    return checked.largest(metric(grid, even(grid)).best)


def _within(wanted_: Wanted, size: int, material: _Material) -> tuple[Table, list[Point]]:
    """Search the least error that ``size`` bytes allow, by bisecting the budget."""
    low, high = float(np.log(1e-7)), float(np.log(0.5))
    front: list[Point] = []
    best: Table | None = None
    for _ in range(_SIZE_STEPS):
        middle = (low + high) / 2
        try:
            table, tried = _cheapest(wanted_, float(significant(np.exp(middle), _BUDGET_BITS)), material)
        except BudgetError:
            low = middle
            continue
        front += tried
        if table.bytes <= size:
            best, high = table, middle
        else:
            low = middle
    if best is None:
        raise BudgetError(
            f"No table of {wanted_.winner.bands} bands fits winners.sizes = {size} bytes with an E_mean below 50 %. "
            "Raise the size, or lower the bands."
        )
    return best, front


def _sampled(material: _Material, sets: Array, weights: Array, least: Array, shape: tuple[int, ...], bands: int) -> Sampled:
    frame = material.frame
    count = sphere.count(bands, mirrored=frame.mirrored)
    scale = np.asarray(factors.evaluate(frame.factor, frame.axes, sets), dtype=np.float64) / least
    basis = np.asarray(tables.products(frame.basis, frame.axes, sets, material.degrees), dtype=np.float64)
    truth = weights[..., :count] * material.windowed(bands)
    return Sampled(basis * scale[:, np.newaxis], truth / least[:, np.newaxis, np.newaxis], shape)


def _both(material: _Material, bands: int) -> tuple[Sampled, Sampled]:
    """Return the fit grid and the verification sets in units of L_min."""
    reference = material.reference
    l_min = reference.headline
    grid = _sampled(material, material.sets, material.weights, material.least, material.shape, bands)
    shape = material.checked_shape
    return grid, _sampled(material, reference.parameters, reference.weights, l_min, shape, bands)


def _fast(
    wanted_: Wanted, aim: float, material: _Material, known: NDArray[np.int64] | None
) -> tuple[Table | None, list[Point], NDArray[np.int64] | None]:
    """Return the table, all tried, and its lengths; ``known`` are those of a try that float32 carried over its budget."""
    bands, dtype, first = wanted_.winner.bands, wanted_.winner.dtype, material.degrees[0] + 1
    best, tried = fewest(*_both(material, bands), material.shape, first, aim, known)
    rest = tuple(d + 1 for d in material.degrees[1:])
    empty = np.zeros((len(material.frame.channels), sphere.count(bands, mirrored=material.frame.mirrored), first, *rest))

    def table(lengths: NDArray[np.int64], dense: Array) -> Table:
        shaped = _gridded(material, dense.reshape(empty.shape), dtype)
        return tables.fast(material.frame, shaped, lengths.reshape(rest), bands, dtype)

    points = [(float(table(k.lengths, empty).bytes), k.error) for k in tried]
    return (table(best.lengths, best.dense), points, best.lengths) if best else (None, points, None)


def _packed(wanted_: Wanted, aim: float, material: _Material) -> tuple[Table | None, list[Point]]:
    bands, first = wanted_.winner.bands, material.degrees[0] + 1
    degrees = sphere.degrees_orders(bands, mirrored=material.frame.mirrored)[0]

    def cost(numbers: NDArray[np.int64]) -> int:
        return packed.cost(numbers.swapaxes(0, 1), degrees)

    best, tried = smallest(*_both(material, bands), material.shape, first, aim, cost)
    if best is None:
        return None, [(float(r.cost), r.error) for r in tried]
    table = tables.small(material.frame, best.numbers.swapaxes(0, 1), best.step, material.degrees, bands)
    fixed = table.bytes - best.cost
    return table, [(float(r.cost + fixed), r.error) for r in tried]


def _front(points: Sequence[Point]) -> list[Point]:
    """Return the points that no other beats in both bytes and error, by rising bytes."""
    kept: list[Point] = []
    for size, error in sorted(points):
        if not kept or error < kept[-1][1]:
            kept.append((size, error))
    return kept
