"""Error against time, in one run: truth rules, and the exported C against the paper's table written out literally."""

from __future__ import annotations

import shutil
import statistics
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from pipeline import sphere
from pipeline.bench import tabular
from pipeline.bench.samples import Samples, sample
from pipeline.config.schema import Config, ReferenceSection
from pipeline.export import c_header, npz
from pipeline.fit.axes import Axis
from pipeline.run.stages.fit import fit_reference
from pipeline.table.table import Table
from pipeline.truth import plain, sun_centred

Array = NDArray[np.float64]
Rows = list[dict[str, object]]

_CALLS = 200_000


def run(config: Config, reports: Path, repeats: int) -> str:
    """Measure, write ``truth-rules.csv`` and ``evaluation.csv`` under the run's bench folder, and return both as text.

    Times are medians over ``repeats`` after a warm-up; ratios compare within this run. The exported tables must exist.
    """
    folder = reports / config.name
    tables = sorted(folder.glob("export/**/skylight_sh.npz"))
    if not tables:
        raise OSError(f"{folder}/export holds no tables. Run `make fit` with the same config first.")
    with threadpool_limits(1):
        truth = truth_rules(config, repeats)
        evaluation = evaluations(config, [(path.parent.name, npz.read(path)) for path in tables], repeats)
    tabular.save(folder / "bench" / "truth-rules.csv", truth)
    tabular.save(folder / "bench" / "evaluation.csv", evaluation)
    return "\n".join(
        [
            "Truth: one parameter set, 7 bands; a plain rule's basis is tabulated beforehand and not timed.",
            tabular.text(truth),
            "",
            "Evaluation: one sun, azimuth rotation included, float inputs, cc -O3.",
            tabular.text(evaluation),
            "",
            f"Rows: {folder / 'bench'}",
        ]
    )


def truth_rules(config: Config, repeats: int) -> Rows:
    """Time each rule at growing cost in the middle of the ranges; errors are against the finest sun-centred run."""
    light, bands = config.light, min(7, config.truth.bands)
    middle = {axis.name: (axis.range[0] + axis.range[1]) / 2 for axis in config.axes}
    parameters = {name: np.full((1, 1), value) for name, value in middle.items()}

    def centred(nodes: int) -> Array:
        mirrored = light.hints.mirrored
        out = sun_centred.project(light, parameters, nodes=nodes, bands=bands, mirrored=mirrored).weights[0, 0]
        return np.asarray(sphere.unmirror(out, bands) if mirrored else out, dtype=np.float64)

    exact = centred(160)
    rows: Rows = []

    def add(rule: str, samples: int, call: Callable[[], Array]) -> None:
        error = float(np.abs(call() - exact).max() / np.abs(exact).max())
        rows.append({"rule": rule, "samples": samples, "error": error, "ms": 1e3 * _median(call, repeats)})

    for n in (300, 1000):
        _plain(add, f"stratified Monte Carlo, {n} x {n}", plain.stratified(n, 1), config, middle, bands)
    for n in (32, 128, 362):
        _plain(add, f"zenith Gauss, {n} x {2 * n}", plain.zenith_gauss(n), config, middle, bands)
    for n in (16, 24, 32, 48, 64, 88):
        pieces = n * round(0.8 * n) + round(0.75 * n) * round(0.8 * n)
        add(f"sun-centred Gauss, {n} nodes", pieces, lambda n=n: centred(n))  # type: ignore[misc]
    return rows


def _plain(
    add: Callable[[str, int, Callable[[], Array]], None],
    rule: str,
    nodes: tuple[Array, Array],
    config: Config,
    middle: dict[str, float],
    bands: int,
) -> None:
    directions, solid_angles = nodes
    basis = plain.tabulate(directions, solid_angles, bands)
    add(rule, len(directions), lambda: plain.project(config.light, middle, directions, basis))


def evaluations(config: Config, tables: list[tuple[str, Table]], repeats: int) -> Rows:
    """Compile each table's header with the C compiler and time it beside the paper-literal table."""
    samples: Samples = sample(config, bands=7)
    # The paper has two parameters; further axes keep the config's largest degree.
    wanted = (13, 7, *(axis.degrees[1] for axis in config.axes[2:]))
    degrees = tuple(min(d, axis.degrees[1]) for d, axis in zip(wanted, config.axes, strict=False))
    section = ReferenceSection(name="paper-literal", degrees=degrees, solver="svd")
    axes = tuple(Axis(axis.name, *axis.range) for axis in config.axes)
    literal, _ = fit_reference(samples.config, section, samples.full, axes, samples.nodes, mirrored=False)
    timed = {"paper-literal": _time_header(literal, repeats)}
    bytes_of = {"paper-literal": literal.bytes}
    for name, table in tables:
        label = "recommended" if name == "export" else name
        timed[label], bytes_of[label] = _time_header(table, repeats), table.bytes
    base = timed["paper-literal"]
    return [
        {"table": name, "bytes": bytes_of[name], "ns a call": 1e9 * seconds, "times faster": base / seconds}
        for name, seconds in timed.items()
    ]


def _time_header(table: Table, repeats: int) -> float:
    """Return the median seconds of one call, over a sweep of suns that no compiler can hoist."""
    names = [axis.name for axis in table.axes]
    inputs = {axis.name: f"{axis.low:.9e}f + {axis.high - axis.low:.9e}f * x" for axis in table.axes}
    arguments = ", ".join([inputs[names[0]], "6.0f * x", *(inputs[name] for name in names[1:])])
    source = f"""
#include <stdio.h>
#include <time.h>
#include "table.h"
int main(void) {{
    static float w[BENCH_SH_CHANNELS][BENCH_SH_WEIGHTS];
    float sum = 0.0f; int run, i; struct timespec a, b;
    for (run = 0; run <= {repeats}; ++run) {{
        timespec_get(&a, TIME_UTC);
        for (i = 0; i < {_CALLS}; ++i) {{
            const float x = (float)((i * 7919) % {_CALLS}) / {_CALLS}.0f;
            bench_sh_weights({arguments}, w);
            sum += w[0][1] + w[BENCH_SH_CHANNELS - 1][BENCH_SH_WEIGHTS - 1];
        }}
        timespec_get(&b, TIME_UTC);
        if (run) printf("%.9g\\n", ((double)(b.tv_sec - a.tv_sec) + 1e-9 * (double)(b.tv_nsec - a.tv_nsec)) / {_CALLS}.0);
    }}
    return sum == 12345.0f;
}}
"""
    facts = c_header.Facts("benchmark", 0.0, 0.0, "per-set", [])
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        (place / "table.h").write_text(c_header.write(table, facts, "bench_sh"), encoding="utf-8")
        (place / "bench.c").write_text(source, encoding="utf-8")
        if shutil.which("cc") is None:
            raise OSError("No C compiler `cc` was found. Install one, such as gcc or clang.")
        subprocess.run(["cc", "-std=c11", "-O3", "bench.c", "-o", "bench", "-lm"], cwd=place, check=True)
        out = subprocess.run([str(place / "bench")], check=True, capture_output=True, text=True).stdout
    return statistics.median(float(line) for line in out.split())


def _median(call: Callable[[], object], repeats: int) -> float:
    call()
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return statistics.median(times)
