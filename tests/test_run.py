"""Runs: what is cached, what is not, and that the bytes never depend on who did the work."""

from __future__ import annotations

import ast
import json
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from conftest import ROOT, SMALL, run_quietly
from skylight_sh.config import Config, load
from skylight_sh.run import code, plan
from skylight_sh.run.executors import map_tasks
from skylight_sh.run.runner import Result, run
from skylight_sh.run.steps import steps
from skylight_sh.store.store import Store
from skylight_sh.table.selection import BudgetError


def published(folder: Path) -> dict[str, bytes]:
    """All files of a report but run.json, which has the times."""
    files = [p for p in folder.rglob("*") if p.is_file() and p.name != "run.json"]
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in files}


def edited(tmp_path: Path, *edits: tuple[str, str]) -> Config:
    text = SMALL.read_text(encoding="utf-8")
    for old, new in edits:
        assert old in text
        text = text.replace(old, new)
    path = tmp_path / "edited.toml"
    path.write_text(text, encoding="utf-8")
    return load(path)


def test_outputs_are_the_contract(small_run: Result) -> None:
    files = published(small_run.folder)
    assert {"index.html", "errors.csv", "summary.json", "figures/bands.png"} <= set(files)
    assert {"export/skylight_sh.h", "export/skylight_sh.npz", "export/4-bands-5pct/skylight_sh.h"} <= set(files)
    summary = json.loads(files["summary.json"])
    assert summary["recommended"] == "4-bands-1pct"
    for row in summary["tables"]:
        assert {"name", "path", "bands", "dtype", "bytes", "coefficients", "e_mean", "e_max", "l_min"} <= set(row)
        assert (small_run.folder / row["path"] / "skylight_sh.h").is_file()
    record = json.loads((small_run.folder / "run.json").read_text(encoding="utf-8"))
    assert list(record["stages"])[:6] == ["truth", "fit", "select", "measure", "export", "report"]
    assert all({"seconds", "cached"} <= set(stage) for stage in record["stages"].values())


def test_a_second_run_makes_nothing_and_changes_no_byte(small_run: Result) -> None:
    before = published(small_run.folder)
    again = run_quietly(load(SMALL), small_run.folder.parents[1])
    assert all(facts["cached"] for name, facts in again.stages.items() if name != "publish")
    assert published(again.folder) == before


def keys_by_stage(config: Config) -> dict[str, set[str]]:
    plan_ = steps(config)
    keys = plan.keys(plan_)
    return {
        stage: {keys[s.name] for s in plan_ if s.stage == stage} for stage in ("truth", "fit", "select", "export", "report")
    }


@pytest.mark.parametrize(
    ("edit", "remade"),
    [
        (("budgets = [0.05, 0.01]", "budgets = [0.06, 0.01]"), {"select", "export", "report"}),
        (('figures = ["bands"]', 'figures = ["maps"]'), {"export", "report"}),
        (("degrees = [3, 9]", "degrees = [3, 8]"), {"fit", "select", "export", "report"}),
        (("tolerance = 1e-8", "tolerance = 1e-7"), {"truth", "fit", "select", "export", "report"}),
        (('model = "preetham"', 'model = "preetham"\nconstants = "smits"'), {"truth", "fit", "select", "export", "report"}),
        (("[report]", '[run]\nexecutor = "processes"\nworkers = 2\n\n[report]'), set()),
    ],
)
def test_a_change_remakes_only_what_depends_on_it(tmp_path: Path, edit: tuple[str, str], remade: set[str]) -> None:
    before, after = keys_by_stage(load(SMALL)), keys_by_stage(edited(tmp_path, edit))
    assert {stage for stage in before if before[stage] != after[stage]} == remade


def test_an_automatic_truth_hangs_on_budgets_tighter_than_all_loose_ones(tmp_path: Path) -> None:
    def keys_with(budgets: str) -> dict[str, set[str]]:
        text = SMALL.read_text(encoding="utf-8").replace("tolerance = 1e-8", 'tolerance = "auto"')
        (tmp_path / "auto.toml").write_text(text.replace("budgets = [0.05, 0.01]", budgets), encoding="utf-8")
        return keys_by_stage(load(tmp_path / "auto.toml"))

    first, looser, tighter = map(keys_with, ("budgets = [0.05, 0.01]", "budgets = [1, 0.01]", "budgets = [1e-6, 0.01]"))
    assert first["truth"] == looser["truth"]
    assert first["truth"].isdisjoint(tighter["truth"])


def test_the_order_of_the_axes_is_part_of_every_truth_key(tmp_path: Path) -> None:
    text = SMALL.read_text(encoding="utf-8")
    first, second, end = (text.index(mark) for mark in ("[[axes]]", '[[axes]]\nname = "turbidity"', "[truth]"))
    swapped = text[:first] + text[second:end] + text[first:second] + text[end:]
    for old, new in (("degrees = [5, 3]", "degrees = [3, 5]"), ("degrees = [6, 4]", "degrees = [4, 6]")):
        swapped = swapped.replace(old, new)
    (tmp_path / "swapped.toml").write_text(swapped, encoding="utf-8")
    one = run_quietly(load(SMALL), tmp_path)
    before = [row["e_mean"] for row in one.summary["tables"]]
    other = run_quietly(load(tmp_path / "swapped.toml"), tmp_path)
    # The same fit, selected along the other axis first: its whole table errs alike.
    assert other.summary["tables"][-1]["e_mean"] == pytest.approx(before[-1], rel=1e-6)


def test_another_seed_redraws_the_random_sets_alone(tmp_path: Path) -> None:
    before, after = (plan.keys(steps(c)) for c in (load(SMALL), edited(tmp_path, ("random = 40", "random = 40\nseed = 9"))))
    assert {name for name in before if name.startswith("truth") and before[name] != after[name]} == {"truth/random"}


@pytest.mark.parametrize(("executor", "workers"), [("threads", 1), ("threads", 2), ("processes", 1), ("processes", 2)])
def test_bytes_do_not_depend_on_the_executor(small_run: Result, tmp_path: Path, executor: str, workers: int) -> None:
    config = load(SMALL, {"executor": executor, "workers": workers})
    assert published(run_quietly(config, tmp_path).folder) == published(small_run.folder)


def test_bytes_do_not_depend_on_a_cluster(small_run: Result, tmp_path: Path) -> None:
    from distributed import LocalCluster

    with LocalCluster(
        n_workers=1, threads_per_worker=2, protocol="tcp", host="127.0.0.1", dashboard_address=":0"
    ) as cluster:
        config = load(SMALL, {"executor": cluster.scheduler_address})
        assert published(run_quietly(config, tmp_path).folder) == published(small_run.folder)


def test_an_unreachable_cluster_is_an_error_that_says_so() -> None:
    with pytest.raises(OSError, match=r"127\.0\.0\.1:9"):
        map_tasks(abs, [1], executor="tcp://127.0.0.1:9", workers=0, advance=lambda *_: None)


def test_results_come_in_the_order_of_the_items() -> None:
    def late(i: int) -> int:
        time.sleep(0.02 * (5 - i))
        return i

    seen: list[tuple[int, int]] = []
    got = map_tasks(late, range(6), executor="threads", workers=3, advance=lambda *p: seen.append(p))
    assert got == list(range(6))
    assert seen == [(i, 6) for i in range(1, 7)]


def test_an_interrupted_run_goes_on_where_it_stood(small_run: Result, tmp_path: Path) -> None:
    command = [sys.executable, "-m", "skylight_sh", "run", str(SMALL)]
    options = ["--store", str(tmp_path / "artifacts"), "--reports", str(tmp_path / "reports")]
    process = subprocess.Popen([*command, *options], cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    deadline = time.monotonic() + 60
    while not list(tmp_path.glob("artifacts/truth/*.h5")) and time.monotonic() < deadline:
        time.sleep(0.005)
    process.send_signal(signal.SIGKILL)
    process.wait()
    assert list(tmp_path.glob("artifacts/truth/*.h5"))
    result = run_quietly(load(SMALL), tmp_path)
    assert published(result.folder) == published(small_run.folder)


def test_a_corrupt_artifact_is_made_again_with_a_warning(small_run: Result, tmp_path: Path) -> None:
    config = load(SMALL)
    first = run_quietly(config, tmp_path)
    store = Store(tmp_path / "artifacts")
    name = "select"
    key = plan.keys(steps(config))[name]
    store.path("select", key).write_bytes(b"not HDF5")
    store.path("export", plan.keys(steps(config))["export"]).unlink()
    warnings: list[str] = []
    again = run(config, store, tmp_path / "reports", warnings.append)
    assert len(warnings) == 1
    assert key in warnings[0]
    assert published(again.folder) == published(small_run.folder) == published(first.folder)


def test_a_budget_out_of_reach_is_refused_before_anything_is_published(tmp_path: Path) -> None:
    config = edited(tmp_path, ("budgets = [0.05, 0.01]", "budgets = [0.0000001]"), ("4-bands-1pct", "4-bands-1e-05pct"))
    with pytest.raises(BudgetError, match=r"winners\.budgets = 1e-07.*largest degrees"):
        run_quietly(config, tmp_path)
    assert not (tmp_path / "reports").exists()


def test_a_renamed_winner_leaves_no_stale_files(tmp_path: Path) -> None:
    run_quietly(load(SMALL), tmp_path)
    (tmp_path / "reports" / "small" / "mine.txt").write_text("kept", encoding="utf-8")
    run_quietly(edited(tmp_path, ("budgets = [0.05, 0.01]", "budgets = [0.06, 0.01]")), tmp_path)
    folders = {p.name for p in (tmp_path / "reports" / "small" / "export").iterdir() if p.is_dir()}
    assert folders == {"4-bands-6pct", "4-bands-6pct-packed", "4-bands-1pct-packed", "3-bands-degrees-6-4-float64"}
    assert (tmp_path / "reports" / "small" / "mine.txt").is_file()


def test_processes_are_spawned_not_forked() -> None:
    # HDF5 can hang after a fork with threads.
    from dask.multiprocessing import get_context

    assert get_context().get_start_method() == "spawn"


@pytest.mark.parametrize(
    ("step", "inside", "outside"),
    [
        (
            "truth/grid",
            ("light/preetham.py", "quadrature/sun_centred.py", "sphere/_basis.py"),
            ("report/page.py", "fit/sweep.py"),
        ),
        ("select", ("fit/quantisation.py", "fit/nearest_plane.py", "table/packed.py"), ("report/page.py", "cli/run.py")),
        ("report", ("report/page.py", "report/templates/index.html.j2", "report/figures/maps.py"), ("cli/run.py",)),
    ],
)
def test_a_key_finds_the_code_its_step_runs(step: str, inside: tuple[str, ...], outside: tuple[str, ...]) -> None:
    made = {step.name: step.make for step in steps(load(ROOT / "configs" / "preetham.toml"))}[step]
    found = set(code.closure(sorted(set(code._modules(made)))))
    assert set(inside) <= found
    assert not set(outside) & found


def test_the_import_closure_misses_nothing_that_python_imports() -> None:
    package = ROOT / "pipeline" / "skylight_sh"
    for path in sorted(package.rglob("*.py")):
        expected = set()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            names = []
            if isinstance(node, ast.ImportFrom) and node.module:
                names = [node.module, *(f"{node.module}.{alias.name}" for alias in node.names)]
            elif isinstance(node, ast.Import):
                names = [alias.name for alias in node.names]
            for name in names:
                if name.split(".")[0] == "skylight_sh":
                    place = ROOT / "pipeline" / name.replace(".", "/")
                    expected |= {p for p in (place.with_suffix(".py"), place / "__init__.py") if p.is_file()}
        found = {package / name for name in code.imported(path.relative_to(package).as_posix())}
        assert expected <= found | {package / "__init__.py"}, path
