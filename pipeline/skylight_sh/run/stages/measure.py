"""Measure: every error that is published, on held-out sets that nothing else reads; a budget that fails there is refused."""

from __future__ import annotations

import io
from dataclasses import replace
from functools import partial

import numpy as np

from skylight_sh.config.schema import Config
from skylight_sh.config.wanted import wanted
from skylight_sh.export import npz
from skylight_sh.fit.errors import Reference
from skylight_sh.run.executors import Advance
from skylight_sh.run.plan import Inputs, Step
from skylight_sh.run.stages.fit import reference_of, swept
from skylight_sh.run.stages.select import BudgetError
from skylight_sh.scene.axes import variables
from skylight_sh.scene.fold import windowed_reference
from skylight_sh.scene.frame import surrounded
from skylight_sh.store.dataset import Dataset, Variable
from skylight_sh.table.errors import least_reconstructed, measure
from skylight_sh.table.table import Table

HELD_OUT = "truth/held-out"
# Sets at which the least reconstructed luminance is sought.
_LEAST_SETS = 150


def steps(config: Config) -> list[Step]:
    """Return the measurement's step."""
    needed = ("fit", "select", HELD_OUT, "truth/verification", *variables(config), *surrounded(config))
    return [Step("measure", "", needed, {}, partial(_make, config))]


def _make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    reference = reference_of(config, inputs, (HELD_OUT,))
    seen = reference_of(config, inputs, ("truth/verification",))
    if "mean" in seen.l_min:
        # The convention is the selection's, as its budgets are.
        reference = replace(reference, least=np.zeros_like(reference.least))
    elif "mean" in reference.l_min:
        raise BudgetError(
            "The least luminance is positive on the sets that selection sees, but not on held-out ones. Narrow the axes' "
            "ranges, or raise `verification`, so that selection sees where it is not."
        )
    asked = wanted(config)
    total = 1 + len(config.fit.references) + len(asked)
    advance(0, total)
    found = _swept(config, inputs, reference)
    sources = [(f"references/{r.name}", "fit") for r in config.fit.references] + [
        (f"tables/{t.name}", "select") for t in asked
    ]
    for done, (name, source) in enumerate(sources, start=1):
        advance(done, total)
        table = read_table(inputs[source], name)
        window = partial(windowed_reference, config, table.bands, table.mirrored) if source == "select" else _as_is
        found |= _measured(name, table, window(reference), window(seen))
        if source == "select":
            some = reference.parameters[:: max(1, len(reference.parameters) // _LEAST_SETS)]
            least = least_reconstructed(table, some, config.source.luminance_row)
            found[f"{name}/least"] = Variable((), np.array(least))
    for table_wanted in asked:
        reached = float(found[f"tables/{table_wanted.name}/e_mean"].data[0, :, -1].max())
        if table_wanted.budget is not None and not reached <= table_wanted.budget:
            raise BudgetError(
                f"{table_wanted.name} meets winners.budgets = {table_wanted.budget:g} on the sets that selection sees, but "
                f"reaches {reached:.4g} on held-out ones. Raise the axes' `verification` or truth.random, so that "
                "selection sees more."
            )
    return Dataset(found, {"conventions": ",".join(reference.l_min), "held_out": len(reference.parameters)})


def read_table(artifact: Dataset, name: str) -> Table:
    """Return a table that ``fit`` or ``select`` made; ``name`` starts with references/ or tables/."""
    return npz.read(io.BytesIO(artifact[f"{name}/npz"].tobytes()))


def _as_is(reference: Reference) -> Reference:
    return reference


def _swept(config: Config, inputs: Inputs, reference: Reference) -> dict[str, Variable]:
    worst = swept(config, inputs, reference, config.truth.bands)
    dims = ("combination", "channel", "bands")
    return {
        "sweep/degrees": Variable(("combination", "axis"), np.array(worst.degrees)),
        "sweep/e_max": Variable(("l_min", *dims), np.stack(list(worst.e_max.values()))),
        "sweep/e_mean": Variable(("l_min", *dims), np.stack(list(worst.e_mean.values()))),
        "sweep/at": Variable(("l_min", *dims, "axis"), reference.parameters[np.stack(list(worst.at.values()))]),
        "sweep/rel_l2": Variable(dims, worst.rel_l2),
    }


def _measured(name: str, table: Table, reference: Reference, seen: Reference) -> dict[str, Variable]:
    measured = measure(table, reference)
    dims = ("l_min", "channel", "bands")
    return {
        f"{name}/e_max": Variable(dims, measured.e_max),
        f"{name}/e_mean": Variable(dims, measured.e_mean),
        f"{name}/at": Variable((*dims, "axis"), reference.parameters[measured.at]),
        f"{name}/rel_l2": Variable(dims[1:], measured.rel_l2),
        # A picture shows these; they lie on a grid.
        f"{name}/per_set": Variable(("set",), measure(table, seen).per_set),
    }
