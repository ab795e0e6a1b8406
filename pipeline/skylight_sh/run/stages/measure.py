"""Measure: every error that is published, on held-out sets that nothing else reads; a budget that fails there is refused."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from skylight_sh.config.schema import Config
from skylight_sh.config.wanted import wanted
from skylight_sh.fit.errors import Reference
from skylight_sh.run.executors import Advance
from skylight_sh.run.from_config import degree_ranges, fit_of, read_table, reference_of, scene_of
from skylight_sh.run.plan import Inputs
from skylight_sh.run.steps import HELD_OUT, VERIFICATION
from skylight_sh.runtime import Table
from skylight_sh.scene.fold import window
from skylight_sh.store.dataset import Dataset, Variable
from skylight_sh.table.errors import least_reconstructed, measure
from skylight_sh.table.grid_fit import swept
from skylight_sh.table.row_layout import stored
from skylight_sh.table.selection import BudgetError

# Sets at which the least reconstructed luminance is sought.
_LEAST_SETS = 150


def make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    """Measure every table, fit and combination of degrees."""
    reference = reference_of(config, inputs, (HELD_OUT,))
    seen = reference_of(config, inputs, (VERIFICATION,))
    if "mean" in seen.l_min:
        # The convention is the selection's, as its budgets are.
        reference = replace(reference, least=np.zeros_like(reference.least))
    elif "mean" in reference.l_min:
        raise BudgetError(
            "The least luminance is positive on the sets that selection sees, but not on held-out ones. Narrow the axes' "
            "ranges, or raise `verification`, so that selection sees where it is not."
        )
    asked, scene = wanted(config), scene_of(config)
    total = 1 + len(config.fit.references) + len(asked)
    advance(0, total)
    found = _swept(config, inputs, reference)
    # A picture shows the errors of these on the grid: of fast tables, or of all where there is none.
    mapped = {f"tables/{t.name}" for t in [t for t in asked if t.layout == "rows"] or asked}
    sources = [(f"references/{r.name}", "fit") for r in config.fit.references] + [
        (f"tables/{t.name}", "select") for t in asked
    ]
    for done, (name, source) in enumerate(sources, start=1):
        advance(done, total)
        table = read_table(inputs[source], name)
        if source == "fit":
            found |= _measured(name, table, reference)
        else:
            factors = window(scene, stored(table.spec, table.bands))
            found |= _measured(name, table, reference.windowed(table.bands, factors))
            if name in mapped:
                per_set = measure(table, seen.windowed(table.bands, factors)).per_set
                found[f"{name}/per_set"] = Variable(("set",), per_set)
            some = reference.parameters[:: max(1, len(reference.parameters) // _LEAST_SETS)]
            least = least_reconstructed(table, some, config.source.luminance_row)
            found[f"{name}/least"] = Variable((), np.array(least))
    for request in asked:
        reached = float(found[f"tables/{request.name}/e_mean"].data[0, :, -1].max())
        if request.budget is not None and not reached <= request.budget:
            raise BudgetError(
                f"{request.name} meets winners.budgets = {request.budget:g} on the sets that selection sees, but "
                f"reaches {reached:.4g} on held-out ones. Raise the axes' `verification` or truth.random, so that "
                "selection sees more."
            )
    return Dataset(found, {"conventions": ",".join(reference.l_min), "held_out": len(reference.parameters)})


def _swept(config: Config, inputs: Inputs, reference: Reference) -> dict[str, Variable]:
    worst = swept(fit_of(config, inputs), reference, degree_ranges(config), config.truth.bands)
    dims = ("combination", "channel", "bands")
    return {
        "sweep/degrees": Variable(("combination", "axis"), np.array(worst.degrees)),
        "sweep/e_max": Variable(("l_min", *dims), np.stack(list(worst.e_max.values()))),
        "sweep/e_mean": Variable(("l_min", *dims), np.stack(list(worst.e_mean.values()))),
        "sweep/at": Variable(("l_min", *dims, "axis"), reference.parameters[np.stack(list(worst.at.values()))]),
        "sweep/rel_l2": Variable(dims, worst.rel_l2),
    }


def _measured(name: str, table: Table, reference: Reference) -> dict[str, Variable]:
    measured = measure(table, reference)
    dims = ("l_min", "channel", "bands")
    return {
        f"{name}/e_max": Variable(dims, measured.e_max),
        f"{name}/e_mean": Variable(dims, measured.e_mean),
        f"{name}/at": Variable((*dims, "axis"), reference.parameters[measured.at]),
        f"{name}/rel_l2": Variable(dims[1:], measured.rel_l2),
    }
