"""Evaluation: every table's header beside the paper-literal scheme and beside lookup tables, warm and with a cold cache."""

from __future__ import annotations

import statistics
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import chain, islice, repeat
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.export import paper_literal
from skylight_sh.fit.errors import e_mean
from skylight_sh.quadrature import parameter_points as parameter_sets
from skylight_sh.runtime import Table
from skylight_sh.studies import compiled, single_fit
from skylight_sh.studies.grid_samples import Samples
from skylight_sh.studies.page import Row, Section
from skylight_sh.studies.speed import lookup
from skylight_sh.table.size import bytes_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

LITERAL = "paper-literal"
TEXT = (
    "One call: inputs to all weights, azimuth rotation included, float inputs, cc -O3 (`native`: and -march=native), "
    "median over rounds that time every program in turn, with the least and the most of the rounds' ratios. `cold` is one "
    "call after 64 MB of other memory was read, since a frame asks once. `paper-literal` is the 2008 scheme: monomials of "
    "degree (13, 7) in double precision, all orders. `lookup` is a table over a regular grid of the axes, interpolated "
    "linearly or cubically: the paper's naive tabulation. E_mean is of what the program returns."
)
_FLAGS = {"portable": ["-O3"], "native": ["-O3", "-march=native"]}
_CALLS = 50_000
_COLD = 60
_PROGRAM = """
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "table.h"
static double now(void)
{{
    struct timespec t;
    timespec_get(&t, TIME_UTC);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}}
static int compare(const void *a, const void *b)
{{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}}
int main(void)
{{
    static float w[BENCH_SH_CHANNELS][BENCH_SH_WEIGHTS];
    static double cold[{cold}];
    const size_t flushed = (size_t)64 << 20;
    unsigned char *other = calloc(flushed, 1);
    float sum = 0.0f;
    double start;
    int run, i;
    size_t j;
    if (!other) return 1;
    for (run = 0; run < 2; ++run) {{
        start = now();
        for (i = 0; i < {calls}; ++i) {{
            const float x = (float)((i * 7919) % {calls}) / {calls}.0f;
            bench_sh_weights({arguments}, w);
            /* Every store counts: without this a compiler drops those that nobody reads. */
            __asm__ volatile("" : : "g"(w) : "memory");
            sum += w[0][1] + w[BENCH_SH_CHANNELS - 1][BENCH_SH_WEIGHTS - 1];
        }}
    }}
    printf("%.9g\\n", (now() - start) / {calls}.0);
    for (i = 0; i < {cold}; ++i) {{
        const float x = (float)i / {cold}.0f;
        for (j = 0; j < flushed; j += 64) other[j] = (unsigned char)(other[j] + 1);
        start = now();
        bench_sh_weights({arguments}, w);
        cold[i] = now() - start;
        sum += w[0][1];
    }}
    qsort(cold, {cold}, sizeof *cold, compare);
    printf("%.9g\\n", cold[{cold} / 2]);
    free(other);
    return sum == 12345.0f;
}}
"""


@dataclass(frozen=True)
class Candidate:
    """Something with the tables' API: its header, bytes of constants, and the bands it returns."""

    header: str
    bytes: int
    bands: int


def section(samples: Samples, tables: Mapping[str, Table], repeats: int) -> Section:
    """Time all candidates in turn and measure what they return."""
    candidates = {LITERAL: literal(samples)}
    candidates |= {
        name: Candidate(compiled.header_of(table), bytes_of(table), table.bands) for name, table in tables.items()
    }
    candidates |= _lookups(samples)
    source = program_of([(a.name, *a.range) for a in samples.config.axes], fixed_azimuth=False)
    warm: dict[tuple[str, str], list[float]] = {}
    cold: dict[str, list[float]] = {name: [] for name in candidates}
    with tempfile.TemporaryDirectory() as folder:
        made = {
            (label, name): compiled.program(candidate.header, source, Path(folder) / f"{i}{label}", flags)
            for label, flags in _FLAGS.items()
            for i, (name, candidate) in enumerate(candidates.items())
        }
        for _ in range(repeats):
            for (label, name), program in made.items():
                out = subprocess.run([str(program)], check=True, capture_output=True, text=True).stdout.split()
                warm.setdefault((label, name), []).append(float(out[0]))
                if label == "portable":
                    cold[name].append(float(out[1]))
        errors = {name: _error(samples, c, Path(folder) / "run") for name, c in candidates.items()}
    rows = [
        {
            "table": name,
            "bytes": candidate.bytes,
            "E_mean": errors[name],
            "ns": 1e9 * statistics.median(warm["portable", name]),
            **_ratios("times faster", warm["portable", LITERAL], warm["portable", name]),
            "native ns": 1e9 * statistics.median(warm["native", name]),
            **_ratios("native times faster", warm["native", LITERAL], warm["native", name]),
            "cold ns": 1e9 * statistics.median(cold[name]),
            **_ratios("cold times faster", cold[LITERAL], cold[name]),
        }
        for name, candidate in candidates.items()
    ]
    return Section("evaluation", "Evaluation: error against time and bytes", TEXT, rows, _draw)


def program_of(axes: Sequence[tuple[str, float, float]], fixed_azimuth: bool) -> str:
    """Return a program that times a header over ``axes`` (name, low, high) and prints seconds a call, warm and cold."""
    inputs = [f"{low:.9e}f + {high - low:.9e}f * x" for _, low, high in axes]
    arguments = ", ".join([inputs[0], *([] if fixed_azimuth else ["6.0f * x"]), *inputs[1:]])
    return _PROGRAM.format(calls=_CALLS, cold=_COLD, arguments=arguments)


def _ratios(name: str, base: Sequence[float], other: Sequence[float]) -> dict[str, float]:
    """Median, least and most of the ratios round by round: a machine that slows down slows both."""
    found = [b / o for b, o in zip(base, other, strict=True)]
    return {name: statistics.median(found), f"{name}, least": min(found), f"{name}, most": max(found)}


def literal(samples: Samples) -> Candidate:
    """Return the paper's scheme on these samples: monomials in double precision, every order kept."""
    made = single_fit.fit(samples, samples.full, single_fit.paper_degrees(samples), "monomial", "svd", "raw")
    names = [axis.name for axis in samples.config.axes]
    text = paper_literal.write(made.dense, names, samples.spec.channels, compiled.PREFIX)
    return Candidate(text, made.dense.nbytes, samples.config.truth.bands)


def _lookups(samples: Samples) -> dict[str, Candidate]:
    config, bands = samples.config, samples.config.truth.bands
    degrees = [min(a.degrees[1], n.size - 1) for a, n in zip(config.axes, samples.nodes, strict=True)]
    whole = single_fit.fit(samples, samples.half, degrees, "chebyshev", "svd", single_fit.OWN)
    found = {}
    for fineness in (1, 2, 4):
        sizes = [max(4, fineness * n) for n in list(islice(chain((16, 6), repeat(3)), len(config.axes)))]
        nodes = [np.linspace(*axis.range, n) for axis, n in zip(config.axes, sizes, strict=True)]
        sets = parameter_sets.grid(nodes)
        values = np.asarray(single_fit.table_of(samples, whole, "float64").evaluate(sets), dtype=np.float64)
        for kind in lookup.POINTS:
            text = lookup.header(whole.axes, sizes, values.reshape(*sizes, *values.shape[1:]), bands, kind)
            found[f"lookup {' x '.join(map(str, sizes))}, {kind}"] = Candidate(text, 4 * values.size, bands)
    return found


def _error(samples: Samples, candidate: Candidate, place: Path) -> float:
    inputs = np.insert(samples.reference.parameters, 1, 0.0, axis=1).astype(np.float32)
    got = compiled.weights(candidate.header, inputs, place, ["-O2"])
    held = sphere.Harmonics.even(candidate.bands)
    truth = held.unmirror(samples.reference.weights[..., : held.count])
    return e_mean(got - truth, samples.reference.headline)


def _draw(rows: Sequence[Row]) -> Figure:
    from skylight_sh.report import style

    figure = style.figure(12, 5.2)
    left, right = figure.subplots(1, 2, sharey=True)
    for row in rows:
        name = str(row["table"])
        group = 0 if name == LITERAL else 1 if name.startswith("lookup") else 2
        label = (LITERAL, "lookup tables", "this pipeline")[group]
        for panel, key in ((left, "ns"), (right, "bytes")):
            panel.loglog(row[key], row["E_mean"], style.MARKERS[group], color=style.SERIES[group], markersize=8, label=label)
            if group != 1:
                panel.annotate(name, (row[key], row["E_mean"]), fontsize=7, xytext=(5, 4), textcoords="offset points")
    left.set_xlabel("nanoseconds a call, warm")
    right.set_xlabel("bytes of constants")
    left.set_ylabel("largest E_mean of what is returned")
    left.yaxis.set_major_formatter(style.percent_ticks())
    for panel in (left, right):
        panel.grid(True, alpha=0.3)
    handles = dict(zip(*reversed(left.get_legend_handles_labels()), strict=True))
    left.legend(handles.values(), handles.keys(), fontsize=8)
    return figure
