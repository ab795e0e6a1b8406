"""Cost as work grows: parameter sets, bands and workers, each with its fitted power and peak memory."""

from __future__ import annotations

import multiprocessing
import resource
import statistics
import sys
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from skylight_sh.config.schema import Config
from skylight_sh.quadrature import convergence, sampling
from skylight_sh.quadrature import parameter_points as parameter_sets
from skylight_sh.quadrature.registry import suited
from skylight_sh.run.executors import map_tasks
from skylight_sh.sphere import Harmonics
from skylight_sh.studies import outcomes
from skylight_sh.studies.page import Row, Section
from skylight_sh.studies.timing import exponent

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TEXT = (
    "The truth stage's work, each line in a fresh process: sampling so many sets of a grid (4 bands), one block of 16 sets "
    "at so many bands to a verified 1e-9, and 2,000 sets with 1 and 2 workers: CPU seconds of all threads, and `wall` "
    "ones, which other work on the machine lengthens. `power` is p in CPU time ~ size^p, fitted over the group. `peak MB` "
    "is the process's largest memory; `growth MB` what it grew by while it worked: a block of sets, and the weights."
)
_SETS = (100, 1_000, 10_000, 100_000)
_BANDS = (3, 7, 16, 32, 64)
_WORKERS = (1, 2)
_TOLERANCE = 1e-9


def section(config: Config) -> Section:
    """Measure every size in a process of its own."""
    light = config.source
    ranges = {axis.name: axis.range for axis in config.axes}
    rows: list[Row] = []
    for label, sizes, task in (
        ("parameter sets", _SETS, _sample_sets),
        ("bands", _BANDS, _sample_bands),
        ("workers", _WORKERS, _sample_workers),
    ):
        found = [_alone(task, light, ranges, size) for size in sizes]
        power = exponent(sizes, [f["seconds"] for f in found]) if label != "workers" else None
        rows += [
            {
                "grows": label,
                "size": size,
                "CPU seconds": f["seconds"],
                "wall seconds": f["wall"],
                "verified error": f.get("error"),
                "power": power,
                "peak MB": f["peak"],
                "growth MB": f["growth"],
            }
            for size, f in zip(sizes, found, strict=True)
        ]
    return Section("growth", "Cost as work grows", TEXT, rows, _draw, outcomes.growth(rows))


def _alone(task: Any, *arguments: Any) -> dict[str, float]:
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        return dict(pool.submit(task, *arguments).result())


def _peak() -> float:
    """Largest resident memory of this process so far, in MB."""
    status = Path("/proc/self/status")
    if status.is_file():
        # What getrusage tells of a process counts its parent's memory before it started a program of its own.
        line = next(line for line in status.read_text(encoding="ascii").splitlines() if line.startswith("VmHWM"))
        return int(line.split()[1]) / 1e3
    scale = 1e6 if sys.platform == "darwin" else 1e3
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / scale


def _jobs(light: Any, ranges: dict[str, tuple[float, float]], sets: int, bands: int, nodes: int) -> list[sampling.Job]:
    # A grid: a hundred values of the first axis at most, so that sets share nodes as the stage's do.
    first = sets if len(ranges) == 1 else min(100, max(1, round(sets**0.5)))
    others = len(ranges) - 1
    each = round((sets / first) ** (1 / others)) + 1 if others else 1
    counts = [first, *[each] * others]
    drawn = parameter_sets.grid([np.linspace(*r, n) for r, n in zip(ranges.values(), counts, strict=True)])[:sets]
    names, rule = tuple(ranges), suited(light, bands)
    blocks = parameter_sets.chunks(drawn, sampling.peak_of(light, names), 64)
    return [sampling.Job(light, names, drawn[block], nodes, Harmonics.even(bands), rule, _TOLERANCE) for block in blocks]


def _run(jobs: Sequence[sampling.Job], workers: int) -> tuple[float, float]:
    """Return the CPU and wall seconds of the work."""
    wall, start = time.perf_counter(), time.process_time()
    map_tasks(sampling.sample_block, jobs, executor="threads", workers=workers, advance=lambda *_: None)
    return time.process_time() - start, time.perf_counter() - wall


def _sample_sets(light: Any, ranges: dict[str, tuple[float, float]], sets: int) -> dict[str, float]:
    jobs = _jobs(light, ranges, sets, 4, 48)
    _run(jobs[:1], 1)
    before = _peak()
    seconds, wall = _run(jobs, 1)
    return {"seconds": seconds, "wall": wall, "peak": _peak(), "growth": _peak() - before}


def _sample_bands(light: Any, ranges: dict[str, tuple[float, float]], bands: int) -> dict[str, float]:
    rule = suited(light, bands)
    middle = {name: (r[0] + 0.01 * (r[1] - r[0]), r[0] + 0.99 * (r[1] - r[0])) for name, r in ranges.items()}
    held = Harmonics.even(bands)
    nodes, estimate = convergence.choose_nodes(light, middle, rule=rule, harmonics=held, tolerance=_TOLERANCE)
    names = tuple(ranges)
    rest = [np.linspace(*r, 16) for r in list(ranges.values())[1:]]
    first = [0.76 * ranges[names[0]][1]]
    values = np.stack([np.full(16, first[0]), *rest], axis=-1)[np.newaxis]
    job = sampling.Job(light, names, values, nodes, held, rule, _TOLERANCE)
    sampling.project_block(job)
    before = _peak()
    times = []
    for _ in range(7):
        wall, start = time.perf_counter(), time.process_time()
        sampling.project_block(job)
        times.append((time.process_time() - start, time.perf_counter() - wall))
    seconds, wall = (statistics.median(column) for column in zip(*times, strict=True))
    return {"seconds": seconds, "wall": wall, "error": estimate, "peak": _peak(), "growth": _peak() - before}


def _sample_workers(light: Any, ranges: dict[str, tuple[float, float]], workers: int) -> dict[str, float]:
    jobs = _jobs(light, ranges, 2_000, 7, 48)
    _run(jobs[:2], workers)
    before = _peak()
    seconds, wall = _run(jobs, workers)
    return {"seconds": seconds, "wall": wall, "peak": _peak(), "growth": _peak() - before}


def _draw(rows: Sequence[Row]) -> Figure:
    from skylight_sh.report import style

    figure = style.figure(style.WIDTH, 8.4)
    panels = figure.subplots(3, 1)
    for i, (panel, label) in enumerate(zip(panels, ("parameter sets", "bands", "workers"), strict=True)):
        mine = [row for row in rows if row["grows"] == label]
        key = "wall seconds" if label == "workers" else "CPU seconds"
        sizes = [int(str(r["size"])) for r in mine]
        panel.loglog(sizes, [r[key] for r in mine], **style.look(i))
        power = mine[0]["power"]
        title = key if power is None else f"{key}, as {label}^{float(str(power)):.2f}"
        panel.set_title(title, fontsize=11)
        panel.set_xlabel(label)
        panel.set_xticks(sizes, [f"{size:,}" for size in sizes])
        panel.set_xticks([], minor=True)
        panel.yaxis.set_major_formatter(style.plain_ticks())
        style.steps(panel.yaxis)
        panel.grid(True, which="major", alpha=0.3)
    return figure
