"""Select: the table with the fewest bytes under each error budget, measured as shipped."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from pipeline import sphere
from pipeline.config.names import winner_names
from pipeline.config.schema import Config, WinnerSection
from pipeline.export import npz
from pipeline.fit.errors import Reference
from pipeline.fit.staircase import Lengths, shortest
from pipeline.run.executors import Advance
from pipeline.run.plan import Inputs, Step
from pipeline.run.stages.axes import axes_of
from pipeline.run.stages.fit import prefactor_of, reference_of, truth_inputs, whole_table
from pipeline.store.dataset import Dataset, Variable
from pipeline.table.measure import headline, measure
from pipeline.table.table import Table, pack

Array = NDArray[np.float64]

_CODE = ("light", "sphere", "fit", "table", "export/npz.py", "config/names.py", "run/stages/select.py", "run/stages/fit.py")


class BudgetError(RuntimeError):
    """No table of the config's degrees meets a budget."""


def steps(config: Config) -> list[Step]:
    """Return the selection's step."""
    parameters = {"winners": [winner.model_dump(mode="json") for winner in config.winners]}
    return [Step("select", "", _CODE, ("fit", *truth_inputs(config)), parameters, partial(_make, config))]


def _make(config: Config, inputs: Inputs, advance: Advance) -> Dataset:
    fit = inputs["fit"]
    reference = reference_of(config, inputs)
    wanted = [
        (name, winner, budget)
        for winner in config.winners
        for name, budget in zip(winner_names(winner), winner.budgets or (None,), strict=True)
    ]
    variables: dict[str, Variable] = {"parameters": Variable(("set", "axis"), reference.parameters)}
    for done, (name, winner, budget) in enumerate(wanted):
        advance(done, len(wanted))
        table = _cheapest(config, winner, budget, fit, reference) if budget else _given(config, winner, fit)
        measured = measure(table, reference)
        dims = ("l_min", "channel", "bands")
        variables |= {
            f"tables/{name}/npz": Variable(("byte",), np.frombuffer(npz.write(table), dtype=np.uint8)),
            f"tables/{name}/e_max": Variable(dims, measured.e_max),
            f"tables/{name}/e_mean": Variable(dims, measured.e_mean),
            f"tables/{name}/at": Variable((*dims, "axis"), reference.parameters[measured.at]),
            f"tables/{name}/rel_l2": Variable(dims[1:], measured.rel_l2),
            f"tables/{name}/per_set": Variable(("set",), measured.per_set),
        }
    return Dataset(variables, {"conventions": ",".join(reference.l_min)})


def _given(config: Config, winner: WinnerSection, fit: Dataset) -> Table:
    cut = fit["coefficients"][(slice(None), slice(None), *(slice(d + 1) for d in winner.degrees or ()))]
    mirrored = bool(fit.attrs["mirrored"])
    basis, prefactor = config.fit.basis, prefactor_of(config)
    return whole_table(config, cut, axes_of(config), basis, winner.dtype, prefactor, winner.bands, mirrored)


def _cheapest(config: Config, winner: WinnerSection, budget: float, fit: Dataset, reference: Reference) -> Table:
    mirrored = bool(fit.attrs["mirrored"])
    dense = fit["coefficients"][:, : sphere.count(winner.bands, mirrored=mirrored)]

    def table(lengths: Lengths) -> Table:
        return pack(
            dense,
            lengths,
            axes=axes_of(config),
            channels=config.source.channels,
            bands=winner.bands,
            mirrored=mirrored,
            basis=config.fit.basis,
            dtype=winner.dtype,
            prefactor=prefactor_of(config),
        )

    lengths = shortest(dense, budget, lambda lengths: headline(table(lengths), reference))
    if lengths is None:
        reached = headline(table(np.full((*dense.shape[:2], *dense.shape[3:]), dense.shape[2])), reference)
        raise BudgetError(
            f"No table of {winner.bands} bands meets winners.budgets = {budget:g}: all coefficients reach {reached:.3g}. "
            "Raise the budget, or the largest degrees of the axes."
        )
    return table(lengths)
