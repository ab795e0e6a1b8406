"""A run as a list of steps, each cached under a key of its own inputs only."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from skylight_sh.run.blas import one_thread
from skylight_sh.run.code import version_of
from skylight_sh.run.provenance import libraries
from skylight_sh.store import hdf5
from skylight_sh.store.dataset import Dataset
from skylight_sh.store.hdf5 import SCHEMA_VERSION
from skylight_sh.store.keys import digest
from skylight_sh.store.store import Store

Inputs = Mapping[str, Dataset]


@dataclass(frozen=True)
class Step:
    """One artifact to make.

    ``stage`` is what it belongs to, ``part`` tells several of a stage apart; ``inputs`` are the steps it reads,
    ``parameters`` (JSON-like) all else than its code that decides its result. A step ``in_blocks`` is also given the
    ``Blocks`` that an earlier run of it has finished, and keeps its own there.
    """

    stage: str
    part: str
    inputs: tuple[str, ...]
    parameters: Any
    make: Callable[..., Dataset]
    in_blocks: bool = False

    @property
    def name(self) -> str:
        """Name within the plan, e.g. ``truth/grid``."""
        return f"{self.stage}/{self.part}" if self.part else self.stage


@dataclass(frozen=True)
class Outcome:
    """What became of a step; ``provenance`` is that of whoever made it, perhaps another machine, long ago."""

    step: Step
    key: str
    seconds: float
    cached: bool
    provenance: Mapping[str, Any]


def keys(plan: Sequence[Step]) -> dict[str, str]:
    """Return each step's key by name: its stage, code, libraries, parameters and its inputs' keys, nothing else."""
    steps = {step.name: step for step in plan}
    known: dict[str, str] = {}

    def add(step: Step) -> None:
        for name in step.inputs:
            if name not in known:
                add(steps[name])
        known[step.name] = digest(
            {
                "stage": step.name,
                "schema": SCHEMA_VERSION,
                "code": version_of(step.make),
                "libraries": libraries(),
                "parameters": step.parameters,
                "inputs": {name: known[name] for name in step.inputs},
            }
        )

    for step in plan:
        if step.name not in known:
            add(step)
    return known


def execute(
    plan: Sequence[Step],
    store: Store,
    provenance: Callable[[], Mapping[str, Any]],
    bar: Callable[[str], Any],
    warn: Callable[[str], None],
    wanted: Sequence[str],
) -> tuple[dict[str, Outcome], dict[str, Dataset]]:
    """Make what the store lacks, in the plan's order; return every step's outcome and the artifacts ``wanted`` by name.

    ``provenance`` gives what an artifact that is made now tells of its maker. Artifacts are read only where a step needs
    them. One that is corrupt, or another than it should be, is made again, with a warning.
    """
    names = keys(plan)
    steps = {step.name: step for step in plan}
    loaded: dict[str, Dataset] = {}
    outcomes: dict[str, Outcome] = {}

    def obtain(name: str) -> Dataset:
        if name in loaded:
            return loaded[name]
        step, key = steps[name], names[name]
        start = time.perf_counter()
        if store.has(step.stage, key):
            try:
                loaded[name] = store.get(step.stage, key, step.name)
            except hdf5.CorruptArtifactError as error:
                warn(str(error))
            else:
                taken = time.perf_counter() - start
                outcomes.setdefault(name, Outcome(step, key, taken, True, _provenance(loaded[name].attrs)))
                return loaded[name]
        inputs = {needed: obtain(needed) for needed in step.inputs}
        start = time.perf_counter()
        with bar(step.name) as advance, one_thread():
            blocks = store.blocks(step.stage, key, warn)
            made = step.make(inputs, advance, blocks) if step.in_blocks else step.make(inputs, advance)
        stamped = Dataset(made.variables, {**made.attrs, "step": name, "key": key, **provenance()})
        store.put(step.stage, key, stamped)
        if step.in_blocks:
            blocks.clear()
        loaded[name] = stamped
        outcomes[name] = Outcome(step, key, time.perf_counter() - start, False, _provenance(stamped.attrs))
        return stamped

    for step in plan:
        if store.has(step.stage, names[step.name]) and step.name not in wanted:
            key = names[step.name]
            found = _provenance(store.attributes(step.stage, key))
            outcomes.setdefault(step.name, Outcome(step, key, 0.0, True, found))
        else:
            obtain(step.name)
    return outcomes, {name: loaded[name] for name in wanted}


def _provenance(attrs: Mapping[str, Any]) -> dict[str, Any]:
    """Return what an artifact tells of who made it; nothing where it tells nothing."""
    found: dict[str, Any] = json.loads(str(attrs.get("provenance", "{}")))
    return found
