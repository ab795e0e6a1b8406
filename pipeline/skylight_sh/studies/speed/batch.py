"""Batches of suns beside single calls, and beside what the machine's multiply-adds allow."""

from __future__ import annotations

import statistics
import subprocess
import tempfile
from collections.abc import Mapping
from pathlib import Path

from skylight_sh.runtime import Rows, Table
from skylight_sh.studies import compiled
from skylight_sh.studies.page import Row, Section
from skylight_sh.table.row_layout import widths

_SUNS = 4096
_FLAGS = {"-O3": ["-O3"], "-O3 native": ["-O3", "-march=native"]}
TEXT = (
    "4,096 suns, nanoseconds a sun: single calls in a loop; one batch of suns that differ in the first axis and "
    "azimuth alone, such as a day of one weather, whose rows are summed over the other axes once; and one batch whose "
    "every sun has other weather. `limit` is the time of the day's multiply-adds (terms of the first axis times "
    "columns) at the rate of a plain acc += p * row loop over cached arrays, measured in the same run. Medians over "
    "rounds that take turns."
)
_PROGRAM = """
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "table.h"
#define SUNS {suns}
static double now(void)
{{
    struct timespec t;
    timespec_get(&t, TIME_UTC);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}}
static float w[SUNS][BENCH_SH_CHANNELS][BENCH_SH_WEIGHTS];
{arrays}
static bench_sh_real row[1024], acc[1024];
int main(void)
{{
    int i, k, run;
    double start;
    for (i = 0; i < SUNS; ++i) {{
        const float x = (float)((i * 7919) % SUNS) / (float)SUNS;
        {fill}
    }}
    for (i = 0; i < 1024; ++i) row[i] = (bench_sh_real)i;
    for (run = 0; run < 2; ++run) {{
        start = now();
        for (i = 0; i < SUNS; ++i) bench_sh_weights({single}, w[i]);
        __asm__ volatile("" : : "g"(w) : "memory");
    }}
    printf("%.9g\\n", (now() - start) / SUNS);
    for (run = 0; run < 2; ++run) {{
        start = now();
        bench_sh_weights_batch(SUNS, {day}, w);
        __asm__ volatile("" : : "g"(w) : "memory");
    }}
    printf("%.9g\\n", (now() - start) / SUNS);
    for (run = 0; run < 2; ++run) {{
        start = now();
        bench_sh_weights_batch(SUNS, {mixed}, w);
        __asm__ volatile("" : : "g"(w) : "memory");
    }}
    printf("%.9g\\n", (now() - start) / SUNS);
    for (run = 0; run < 2; ++run) {{
        start = now();
        for (i = 0; i < 4096; ++i) {{
            const bench_sh_real p = (bench_sh_real)i;
            for (k = 0; k < 1024; ++k) acc[k] += p * row[k];
            __asm__ volatile("" : : "g"(acc) : "memory");
        }}
    }}
    printf("%.9g\\n", (now() - start) / (4096.0 * 1024.0));
    return 0;
}}
"""


def section(tables: Mapping[str, Table], repeats: int) -> Section:
    """Time every table laid out for speed, portable and native."""
    fast = {name: table for name, table in tables.items() if isinstance(table.body, Rows)}
    rows: list[Row] = []
    with tempfile.TemporaryDirectory() as folder:
        for label, flags in _FLAGS.items():
            made = {
                name: compiled.program(compiled.header_of(table), _source(table), Path(folder) / f"{i}{label}", flags)
                for i, (name, table) in enumerate(fast.items())
            }
            found: dict[str, list[list[float]]] = {name: [] for name in made}
            for _ in range(repeats):
                for name, program in made.items():
                    out = subprocess.run([str(program)], check=True, capture_output=True, text=True).stdout
                    found[name].append([1e9 * float(v) for v in out.split()])
            for name, table in fast.items():
                single, day, mixed, _ = (statistics.median(column) for column in zip(*found[name], strict=True))
                work = (table.degrees[0] + 1) * table.spec.classes * widths(table.spec, table.bands)[-1]
                rows.append(
                    {
                        "table": name,
                        "flags": label,
                        "single ns": single,
                        "day ns": day,
                        "day times faster": statistics.median(r[0] / r[1] for r in found[name]),
                        "mixed ns": mixed,
                        "limit ns": work * statistics.median(r[3] for r in found[name]),
                        "day over limit": statistics.median(r[1] / (work * r[3]) for r in found[name]),
                    }
                )
    return Section("batch", "Batches of 4,096 suns", TEXT, rows)


def _source(table: Table) -> str:
    names = [axis.name for axis in table.axes]
    inputs = [names[0], *([] if table.spec.azimuth is not None else ["sun_azimuth"]), *names[1:]]
    spans = {a.name: f"{a.low:.9e}f + {a.high - a.low:.9e}f" for a in table.axes} | {"sun_azimuth": "6.0f"}
    arrays = "".join(f"static float {name}_mixed[SUNS], {name}_day[SUNS];\n" for name in inputs)
    fill = ""
    for name in inputs:
        fill += f"{name}_mixed[i] = {spans[name]} * x;\n        "
        fill += f"{name}_day[i] = {spans[name]} * {'0.3f' if name in names[1:] else 'x'};\n        "
    return _PROGRAM.format(
        suns=_SUNS,
        arrays=arrays,
        fill=fill,
        single=", ".join(f"{name}_day[i]" for name in inputs),
        day=", ".join(f"{name}_day" for name in inputs),
        mixed=", ".join(f"{name}_mixed" for name in inputs),
    )
