"""One run: config to published report."""

from __future__ import annotations

import hashlib
import json
import os
import platform
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from skylight_sh.config.schema import Config
from skylight_sh.report import overview
from skylight_sh.run import plan, progress
from skylight_sh.run.files import TRANSFER_FILE, from_dataset, transfer_file
from skylight_sh.run.provenance import environment, settings, versions
from skylight_sh.run.steps import ENGINES, TRANSFER, steps
from skylight_sh.store import atomic
from skylight_sh.store.store import Store

SUMS = "SHA256SUMS"


@dataclass(frozen=True)
class Result:
    """Where a run's report lies, and for each stage its seconds and whether all of it was cached."""

    folder: Path
    stages: Mapping[str, Mapping[str, Any]]
    summary: Mapping[str, Any]


def run(config: Config, store: Store, reports: Path, warn: Callable[[str], None]) -> Result:
    """Run every stage that the store does not hold, publish the files under ``reports/<name>/``, record the run and list it.

    Raises what a stage raises (NotConvergedError, BudgetError) before anything is published.
    """
    planned = steps(config)
    published = [step.name for step in planned if step.name in (TRANSFER, ENGINES, "export", "report")]
    outcomes, artifacts = plan.execute(planned, store, partial(_provenance, config), progress.bar, warn, wanted=published)
    start = time.perf_counter()
    folder = reports / config.name
    files = {path: data for artifact in artifacts.values() for path, data in from_dataset(artifact).items()}
    if TRANSFER in artifacts:
        files[TRANSFER_FILE] = transfer_file(artifacts[TRANSFER])
    files[SUMS] = sums(files).encode()
    _publish(folder, files)
    store.keep(config.name, [outcome.key for outcome in outcomes.values()])
    stages = _by_stage(outcomes)
    stages["publish"] = {"seconds": round(time.perf_counter() - start, 3), "cached": False}
    record = {
        "stages": stages,
        "versions": versions(),
        "machine": {"cores": os.cpu_count(), "system": platform.system(), "processor": platform.machine()},
        "run": config.run.model_dump(mode="json"),
        "files": sorted(files),
        **_computed(outcomes),
    }
    _write(folder / "run.json", (json.dumps(record, indent=2) + "\n").encode())
    _list(reports)
    return Result(folder, stages, json.loads(files["summary.json"]))


def sums(files: Mapping[str, bytes]) -> str:
    """Return the lines of SHA256SUMS, as ``sha256sum --check`` reads them: of what is the same on every machine."""
    same = sorted(path for path in files if path.startswith("export/") or path in ("errors.csv", "summary.json"))
    return "".join(f"{hashlib.sha256(files[path]).hexdigest()}  {path}\n" for path in same)


def _provenance(config: Config) -> dict[str, str]:
    """Return what an artifact that is made now tells of who made it."""
    return {"provenance": json.dumps({"config": settings(config), "environment": environment()}, sort_keys=True)}


def _computed(outcomes: Mapping[str, plan.Outcome]) -> dict[str, Any]:
    """Return who computed what: every environment once, and each artifact's place among them."""
    texts = {
        name: json.dumps(outcome.provenance.get("environment", {}), sort_keys=True) for name, outcome in outcomes.items()
    }
    known = sorted(set(texts.values()))
    return {
        "environments": [json.loads(text) for text in known],
        "computed_in": {name: known.index(text) for name, text in texts.items()},
    }


def _by_stage(outcomes: Mapping[str, plan.Outcome]) -> dict[str, dict[str, Any]]:
    stages: dict[str, dict[str, Any]] = {}
    for outcome in outcomes.values():
        stage = stages.setdefault(outcome.step.stage, {"seconds": 0.0, "cached": True, "artifacts": {}})
        stage["seconds"] = round(stage["seconds"] + outcome.seconds, 3)
        stage["cached"] = stage["cached"] and outcome.cached
        stage["artifacts"][outcome.step.name] = outcome.key
    return stages


def _publish(folder: Path, files: Mapping[str, bytes]) -> None:
    """Write what differs, each file whole, and remove what the last run published and this one does not."""
    record = folder / "run.json"
    try:
        before = json.loads(record.read_text(encoding="utf-8"))["files"] if record.is_file() else []
    except (ValueError, KeyError, TypeError):
        # A damaged record: nothing is known to be stale.
        before = []
    for path, data in files.items():
        target = folder / path
        if not target.is_file() or target.read_bytes() != data:
            _write(target, data)
    for path in set(before) - set(files):
        stale = folder / path
        if stale.resolve().is_relative_to(folder.resolve()) and stale.is_file():
            stale.unlink()
            if not any(stale.parent.iterdir()):
                stale.parent.rmdir()


def _list(reports: Path) -> None:
    """Write the page over all runs; again where another run was published meanwhile."""
    written: list[overview.Run] | None = None
    while written != (found := overview.runs(reports)):
        atomic.write(reports / "index.html", overview.page(found))
        written = found


def _write(path: Path, data: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    atomic.write(path, data)
