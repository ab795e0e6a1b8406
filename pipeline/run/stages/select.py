"""Select: under each error budget the fastest or the smallest table, measured as shipped."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from pipeline import sphere
from pipeline.config.names import Wanted, wanted
from pipeline.config.schema import Config
from pipeline.export import npz
from pipeline.fit.errors import Reference, mean_luminance
from pipeline.fit.fewest import fewest
from pipeline.fit.smallest import smallest
from pipeline.fit.weighted import Sampled, even, metric
from pipeline.run.executors import Advance, map_tasks
from pipeline.run.plan import Inputs, Step
from pipeline.run.stages.axes import fit_nodes, variables
from pipeline.run.stages.fit import reference_of, truth_inputs
from pipeline.run.stages.frame import frame_of, surrounded
from pipeline.run.stages.scene import folded, luminance_scale, window
from pipeline.store.dataset import Dataset, Variable
from pipeline.table import factor as factors
from pipeline.table import packed
from pipeline.table import table as tables
from pipeline.table.measure import headline, least_reconstructed, measure
from pipeline.table.table import Frame, Table
from pipeline.truth import sets as parameter_sets

Array = NDArray[np.float64]
# Bytes and E_mean of a table that was tried.
Point = tuple[float, float]
Result = tuple[Wanted, Table, list[Point]]

_CODE = (
    *("light", "sphere", "fit", "table", "truth/sets.py", "export/npz.py", "config/names.py"),
    *(f"run/stages/{part}.py" for part in ("select", "fit", "axes", "frame", "scene")),
)
# How often a table that float32 carries over its budget is sought again, with a budget how much below proportion.
_RETRIES = 4
_SHRINK = 0.995
# Sets at which the least reconstructed luminance is sought.
_LEAST_SETS = 150
# Budgets tried for a size: the last two differ by a few per cent.
_SIZE_STEPS = 9
# Searches start from degrees whose whole fit errs this much less than the budget.
_HEADROOM = 10.0
# A fast table may err this much more than the packed one of the same budget.
_BESIDE_PACKED = 1.01


class BudgetError(RuntimeError):
    """No table of the config's degrees meets a budget."""


@dataclass(frozen=True)
class _Material:
    """What every search needs: the frame, the fit grid's weights, L_min and nodes, and what errors are measured on."""

    frame: Frame
    sets: Array
    weights: Array
    least: Array
    shape: tuple[int, ...]
    degrees: tuple[int, ...]
    reference: Reference
    swept: NDArray[np.int64]
    swept_error: Array
    window: Callable[[int, NDArray[np.int64], NDArray[np.int64]], Array]

    def windowed(self, bands: int) -> Array:
        """Return what a table of ``bands`` bands multiplies its weights with, ``(count,)``."""
        return self.window(bands, *sphere.degrees_orders(bands, mirrored=self.frame.mirrored))

    def reference_of(self, bands: int) -> Reference:
        """Return what a table of ``bands`` bands is measured against."""
        use = self.reference.first_bands(bands)
        weights = self.reference.weights[..., use] * self.windowed(bands)
        return replace(self.reference, weights=weights, degrees=self.reference.degrees[use])

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
    return [Step("select", "", _CODE, needed, parameters, partial(_make, config))]


def _make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    material = _gather(config, inputs)
    reference = material.reference
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
    found: dict[str, Variable] = {"parameters": Variable(("set", "axis"), reference.parameters)}
    for table in asked:
        found |= _measured(table.name, made[table.name], material.reference_of(table.winner.bands))
        some = reference.parameters[:: max(1, len(reference.parameters) // _LEAST_SETS)]
        least = least_reconstructed(made[table.name], some, config.source.luminance_row)
        found[f"tables/{table.name}/least"] = Variable((), np.array(least))
    for (bands, layout), points in sorted(fronts.items()):
        found[f"fronts/{bands}-{layout}"] = Variable(("point", "bytes_error"), np.array(_front(points)))
    return Dataset(found, {"conventions": ",".join(reference.l_min)})


def _call(job: Callable[[], list[Result]]) -> list[Result]:
    return job()


def _searched(group: Sequence[Wanted], material: _Material) -> list[Result]:
    """Search the tables of one budget: the packed one first, whose error then bounds the fast one's."""
    found: list[Result] = []
    for table in sorted(group, key=lambda w: w.layout != "packed"):
        if table.size is not None:
            found.append((table, *_within(table, table.size, material)))
            continue
        budget = table.budget or 0.0
        if found:
            budget = min(budget, _BESIDE_PACKED * headline(found[0][1], material.reference_of(table.winner.bands)))
        found.append((table, *_cheapest(table, budget, material)))
    return found


def _measured(name: str, table: Table, reference: Reference) -> dict[str, Variable]:
    measured = measure(table, reference)
    dims = ("l_min", "channel", "bands")
    return {
        f"tables/{name}/npz": Variable(("byte",), np.frombuffer(npz.write(table), dtype=np.uint8)),
        f"tables/{name}/e_max": Variable(dims, measured.e_max),
        f"tables/{name}/e_mean": Variable(dims, measured.e_mean),
        f"tables/{name}/at": Variable((*dims, "axis"), reference.parameters[measured.at]),
        f"tables/{name}/rel_l2": Variable(dims[1:], measured.rel_l2),
        f"tables/{name}/per_set": Variable(("set",), measured.per_set),
    }


def _gather(config: Config, inputs: Inputs) -> _Material:
    grid = inputs["truth/grid"]
    frame = frame_of(config, inputs, mirrored=bool(grid.attrs["mirrored"]))
    nodes = fit_nodes(config, frame.axes)
    shape = tuple(n.size for n in nodes)
    reference = reference_of(config, inputs)
    convention = next(iter(reference.l_min))
    radiance = grid["weights"].reshape(-1, *grid["weights"].shape[-2:])
    sets = parameter_sets.grid(nodes)
    weights, scale = folded(config, radiance, grid["degree"], sets), luminance_scale(config)
    least = grid["least_luminance"].ravel()
    if convention != "per-set":
        least = mean_luminance(radiance[:, :, 0], config.source.luminance_row)
    degrees = tuple(axis.degrees[1] for axis in config.axes)
    swept, errors = inputs["fit"]["sweep/degrees"], inputs["fit"]["sweep/e_mean"][0]
    return _Material(frame, sets, weights, scale * least, shape, degrees, reference, swept, errors, partial(window, config))


def _given(table: Wanted, material: _Material, fit: Dataset) -> Table:
    degrees = table.winner.degrees or ()
    cut = fit["coefficients"][(slice(None), slice(None), *(slice(d + 1) for d in degrees))]
    bands = table.winner.bands
    count = sphere.count(bands, mirrored=material.frame.mirrored)
    cut = cut[:, :count] * material.windowed(bands).reshape(-1, *(1,) * (cut.ndim - 2))
    return tables.whole(material.frame, cut, bands, table.winner.dtype)


def _cheapest(wanted_: Wanted, budget: float, material: _Material) -> tuple[Table, list[Point]]:
    """Search with a budget that shrinks until the table as shipped meets the one asked for; also return all tried."""
    aim, reached, front = budget, np.inf, []
    material = replace(material, degrees=material.enough(wanted_.winner.bands, budget))
    for _ in range(_RETRIES):
        search = _packed if wanted_.layout == "packed" else _fast
        table, tried = search(wanted_, aim, material)
        front += tried
        if table is None:
            reached = _whole_error(wanted_, material)
            break
        reached = headline(table, material.reference_of(wanted_.winner.bands))
        if reached <= budget:
            return table, front
        aim *= _SHRINK * budget / reached
    raise BudgetError(
        f"No table of {wanted_.winner.bands} bands meets winners.budgets = {budget:g}: {wanted_.name} reaches "
        f"{reached:.3g} with all degrees. Raise the budget, or the largest degrees of the axes."
    )


def _whole_error(wanted_: Wanted, material: _Material) -> float:
    """Return the error of all terms of the largest degrees, in double precision."""
    grid, checked = _both(replace(material, degrees=tuple(material.swept.max(axis=0))), wanted_.winner.bands)
    return float(checked.errors(metric(grid, even(grid)).best).max())


def _within(wanted_: Wanted, size: int, material: _Material) -> tuple[Table, list[Point]]:
    """Search the least error that ``size`` bytes allow, by bisecting the budget."""
    low, high = float(np.log(1e-7)), float(np.log(0.5))
    front: list[Point] = []
    best: Table | None = None
    for _ in range(_SIZE_STEPS):
        middle = (low + high) / 2
        try:
            table, tried = _cheapest(wanted_, float(np.exp(middle)), material)
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


def _sampled(material: _Material, sets: Array, weights: Array, least: Array, bands: int) -> Sampled:
    frame = material.frame
    count = sphere.count(bands, mirrored=frame.mirrored)
    scale = np.asarray(factors.evaluate(frame.factor, frame.axes, sets), dtype=np.float64) / least
    basis = np.asarray(tables.products(frame.basis, frame.axes, sets, material.degrees), dtype=np.float64)
    truth = weights[..., :count] * material.windowed(bands)
    return Sampled(basis * scale[:, np.newaxis], truth / least[:, np.newaxis, np.newaxis])


def _both(material: _Material, bands: int) -> tuple[Sampled, Sampled]:
    """Return the fit grid and the verification sets in units of L_min."""
    reference = material.reference
    l_min = reference.headline
    grid = _sampled(material, material.sets, material.weights, material.least, bands)
    return grid, _sampled(material, reference.parameters, reference.weights, l_min, bands)


def _fast(wanted_: Wanted, aim: float, material: _Material) -> tuple[Table | None, list[Point]]:
    bands, dtype, first = wanted_.winner.bands, wanted_.winner.dtype, material.degrees[0] + 1
    best, tried = fewest(*_both(material, bands), material.shape, first, aim)
    rest = tuple(d + 1 for d in material.degrees[1:])
    empty = np.zeros((len(material.frame.channels), sphere.count(bands, mirrored=material.frame.mirrored), first, *rest))

    def table(lengths: NDArray[np.int64], dense: Array) -> Table:
        shaped = dense.reshape(empty.shape)
        return tables.fast(material.frame, shaped, lengths.reshape(rest), bands, dtype)

    points = [(float(table(k.lengths, empty).bytes), k.error) for k in tried]
    return (table(best.lengths, best.dense) if best else None), points


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
