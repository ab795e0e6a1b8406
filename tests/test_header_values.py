"""Headers against formulas: every flavour's self-test by one compiler, derivatives, batches, and what a caller adds."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from c_programs import FACTS, STRICT, floats, run
from numpy.typing import NDArray
from skylight_sh import runtime, sphere
from skylight_sh.export import c_data, c_header, vectors
from skylight_sh.fit.axis import Axis
from skylight_sh.runtime import Table
from skylight_sh.studies.claims import gradient as claims_gradient
from skylight_sh.studies.compiled import builds
from skylight_sh.studies.stability.flavours import flavours
from skylight_sh.table.powers import in_powers
from skylight_sh.table.rows import by_class
from skylight_sh.table.table import fast, specification

Array = NDArray[np.float64]
FLAVOURS = flavours()


def with_luminance(table: Table) -> c_header.Facts:
    return replace(FACTS, luminance=FACTS.luminance[: len(table.channels)])


def inside(table: Table, count: int) -> NDArray[np.float32]:
    """Random inputs within the ranges' inner nine tenths, in the runtime's order."""
    rng = np.random.default_rng(6)
    ends = [(low + 0.05 * (high - low), high - 0.05 * (high - low)) for low, high in table.ranges]
    columns = [rng.uniform(low, high, count) for low, high in ends]
    columns.insert(1, rng.uniform(-4, 4, count))
    return np.stack(columns, axis=-1).astype(np.float32)


@pytest.mark.parametrize("name", FLAVOURS)
def test_every_flavour_passes_its_self_test(tmp_path: Path, name: str) -> None:
    table = FLAVOURS[name]
    (tmp_path / "skylight_sh.h").write_text(c_header.write(table, with_luminance(table)), encoding="utf-8")
    (tmp_path / "vectors.txt").write_text(vectors.write(table), encoding="utf-8")
    done = run(tmp_path, vectors.self_test(table), "vectors.txt", check=False)
    assert (done.returncode, " 0 failed" in done.stdout) == (0, True), done.stdout + done.stderr


def test_a_self_test_names_what_fails(tmp_path: Path) -> None:
    """Another prefix, a weight never stored, a status, a number too few, a bound of the caller's: each has its outcome."""
    table = FLAVOURS["one-axis"]
    header = c_header.write(table, with_luminance(table))
    (tmp_path / "vectors.txt").write_text(vectors.write(table), encoding="utf-8")
    count = int(re.findall(r"^vectors (\d+)$", vectors.write(table), re.MULTILINE)[0])
    program = vectors.self_test(table)

    def outcome(header: str, *arguments: str) -> tuple[int, int, int, float]:
        (tmp_path / "skylight_sh.h").write_text(header, encoding="utf-8")
        done = run(tmp_path, program, "vectors.txt", *arguments, check=False)
        passed, failed = map(int, re.findall(r"(\d+) passed, (\d+) failed", done.stdout)[0])
        assert len(re.findall(r"^vector \d+ failed$", done.stdout, re.MULTILINE)) == failed
        return done.returncode, passed, failed, float(re.findall(r"deviation (\S+) of", done.stdout)[0])

    code, passed, failed, deviation = outcome(header)
    assert (code, passed, failed) == (0, count, 0)
    assert 0.0 < deviation < vectors.BOUND
    code, passed, failed, _ = outcome(header, f"{0.5 * deviation:.3g}")
    assert code == 1
    assert 0 < failed < count
    assert outcome(header, f"{1.1 * deviation:.3g}")[0] == 0

    kept = "    return status;\n}\n\n/* One of many suns"
    start = "    int i, all, status = skylight_sh_inputs("
    assert header.count(kept) == header.count(start) == 1
    # The last weight stays as it was before the call: no number, so that it counts as no deviation.
    unset = header.replace(start, f"    const float left = weights[0][24];\n{start}")
    code, passed, failed, deviation = outcome(unset.replace(kept, "    weights[0][24] = left;\n" + kept))
    assert (code, failed) == (1, count - _invalid(table))
    assert deviation < vectors.BOUND
    code, passed, failed, deviation = outcome(header.replace(kept, "    weights[0][24] = 1e6f;\n" + kept))
    assert (code, failed) == (1, count - _invalid(table))
    assert deviation > 1.0
    assert outcome(re.sub(r"status \|= \(v < [^;]*;", "", header))[:2] == (1, count - _clamped(table))

    (tmp_path / "skylight_sh.h").write_text(header, encoding="utf-8")
    text = vectors.write(table)
    for damaged in (
        "",
        text[: len(text) // 2],
        text.replace("channels 1", "channels 2"),
        text.replace("vectors 1", "vectors 2", 1),
    ):
        (tmp_path / "vectors.txt").write_text(damaged, encoding="utf-8")
        assert run(tmp_path, program, "vectors.txt", check=False).returncode == 2
    assert run(tmp_path, program, check=False).returncode == 2
    assert "no file given" in run(tmp_path, program, check=False).stderr
    assert "absent.txt" in run(tmp_path, program, "absent.txt", check=False).stderr


def _status(table: Table) -> list[int]:
    words = vectors.write(table).split()
    inputs, channels, weights = (int(words[i]) for i in (3, 5, 7))
    rows = np.array(words[14:], dtype=np.float64).reshape(-1, inputs + 1 + channels * weights)
    return [int(v) for v in rows[:, inputs]]


def _invalid(table: Table) -> int:
    return _status(table).count(2)


def _clamped(table: Table) -> int:
    return _status(table).count(1)


BATCH = """
#include <stdio.h>
#include "skylight_sh.h"
#define SUNS {suns}
{columns}
static float out[SUNS + 1][SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS], one[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS];
static float columns[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS][SUNS];
int main(void)
{{
    int s, status, worst = 0, c, i;
    double far = 0, large = 0;
    memset(out, 0x7f, sizeof out);
    status = skylight_sh_weights_batch(SUNS, {names}, out);
    if (skylight_sh_weights_columns(SUNS, {names}, &columns[0][0][0]) != status) status = -1;
    for (s = 0; s < SUNS; ++s) {{
        const int single = skylight_sh_weights({elements}, one);
        worst = single > worst ? single : worst;
        for (c = 0; c < SKYLIGHT_SH_CHANNELS; ++c)
            for (i = 0; i < SKYLIGHT_SH_WEIGHTS; ++i) {{
                const double d = fabs((double)out[s][c][i] - (double)one[c][i]), size = fabs((double)one[c][i]);
                const double e = fabs((double)columns[c][i][s] - (double)one[c][i]);
                far = d > far ? d : far;
                far = e > far ? e : far;
                large = size > large ? size : large;
            }}
    }}
    {{
        uint32_t bits, touched = 0;
        for (c = 0; c < SKYLIGHT_SH_CHANNELS; ++c)
            for (i = 0; i < SKYLIGHT_SH_WEIGHTS; ++i) {{
                memcpy(&bits, &out[SUNS][c][i], sizeof bits);
                touched += bits != 0x7f7f7f7fu;
            }}
        printf("%d %d %d %.3g\\n", status, worst, (int)touched, far / large);
    }}
    return 0;
}}
"""


# Those whose batches evaluate suns side by side.
WIDE = [name for name, table in FLAVOURS.items() if "HAS_WIDE" in c_data.features(in_powers(by_class(table)))]


@pytest.mark.parametrize(
    ("name", "suns"),
    [*((name, "many weathers") for name in FLAVOURS), *product(WIDE, ["with a NaN", "one weather"])],
)
def test_a_batch_is_its_single_calls(tmp_path: Path, name: str, suns: str) -> None:
    """Suns that share the other axes and suns that do not, one of them clamped; nothing behind the last is touched.

    As many as are evaluated side by side in any build, and some more; azimuths of many turns among them.
    """
    table = FLAVOURS[name]
    header = c_header.write(table, with_luminance(table))
    (tmp_path / "skylight_sh.h").write_text(header, encoding="utf-8")
    rows = inside(table, 64 + 16 + 5)
    rows[: None if suns == "one weather" else 5, 2:] = rows[2, 2:]
    rows[7, 0] = 50.0
    rows[68, 1] = 3e6
    rows[70:74, 1] = [np.pi, -0.0, 99999.0, -1000.0]
    columns = [f"x{i}" for i in range(rows.shape[1])]
    texts = [f"static const float {c}[SUNS] = {{{floats(rows[:, i])}}};" for i, c in enumerate(columns)]
    invalid = suns == "with a NaN"
    if invalid:
        texts[1] = texts[1].replace(floats(rows[4:5, 1]), "NAN", 1)
    source = BATCH.format(
        suns=len(rows), columns="\n".join(texts), names=", ".join(columns), elements=", ".join(f"{c}[s]" for c in columns)
    )
    # In vectors of four, and wider.
    wider = list(builds(tmp_path / "probe").values())[1:] if name in WIDE else []
    for flags in ([], *(wider if suns == "many weathers" else wider[:1])):
        status, worst, touched, far = run(tmp_path, source, flags=[*STRICT, *flags]).stdout.split()
        assert int(status) == int(worst) == (2 if invalid else 1)
        assert touched == "0"
        assert float(far) < 2e-6


UNPACKED = """
#include <stdio.h>
#include "skylight_sh.h"
#define SUNS {suns}
{columns}
static float memory[SKYLIGHT_SH_UNPACKED + 1], one[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS];
static float out[SUNS][SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS], two[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS];
static float side[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS][SUNS];
static double far(const float *a, const float *b, int step)
{{
    double most = 0;
    int i;
    for (i = 0; i < SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS; ++i) {{
        const double d = fabs((double)a[i * step] - (double)b[i]);
        most = d > most ? d : most;
    }}
    return most;
}}
int main(void)
{{
    int s, i, differ = 0;
    double most = 0, large = 0;
    memory[SKYLIGHT_SH_UNPACKED] = 7.0f;
    skylight_sh_unpack(memory);
    differ += skylight_sh_unpacked_weights_batch(memory, SUNS, {names}, out) != 0;
    differ += skylight_sh_unpacked_weights_columns(memory, SUNS, {names}, &side[0][0][0]) != 0;
    for (s = 0; s < SUNS; ++s) {{
        const int status = skylight_sh_weights({elements}, one);
        double d;
        differ += skylight_sh_unpacked_weights(memory, {elements}, two) != status;
        d = far(&two[0][0], &one[0][0], 1);
        most = d > most ? d : most;
        d = far(&out[s][0][0], &one[0][0], 1);
        most = d > most ? d : most;
        d = far(&side[0][0][s], &one[0][0], SUNS);
        most = d > most ? d : most;
        for (i = 0; i < SKYLIGHT_SH_WEIGHTS; ++i) large = fabs((double)one[0][i]) > large ? fabs((double)one[0][i]) : large;
        skylight_sh_weights_bands({elements}, 2, one);
        skylight_sh_unpacked_weights_bands(memory, {elements}, 2, two);
        d = far(&two[0][0], &one[0][0], 1);
        most = d > most ? d : most;
    }}
    printf("%d %g %.3g\\n", differ, (double)memory[SKYLIGHT_SH_UNPACKED], most / large);
    return 0;
}}
"""


@pytest.mark.parametrize("name", [name for name in FLAVOURS if name.endswith("packed")])
def test_an_unpacked_table_gives_what_the_packed_one_does(tmp_path: Path, name: str) -> None:
    """One by one, as a batch and by column; nothing behind the memory is touched."""
    table = FLAVOURS[name]
    (tmp_path / "skylight_sh.h").write_text(c_header.write(table, with_luminance(table)), encoding="utf-8")
    rows = inside(table, 19)
    columns = [f"x{i}" for i in range(rows.shape[1])]
    texts = [f"static const float {c}[SUNS] = {{{floats(rows[:, i])}}};" for i, c in enumerate(columns)]
    source = UNPACKED.format(
        suns=len(rows),
        columns="\n".join(texts),
        names=", ".join(columns),
        elements=", ".join(f"{c}[s]" for c in columns),
    )
    for flags in (STRICT, [*STRICT, "-O3", "-march=native"]):
        differ, behind, most = run(tmp_path, source, flags=flags).stdout.split()
        assert (differ, behind) == ("0", "7")
        assert float(most) < 2e-6


GRADIENT = """
#include <stdio.h>
#include "skylight_sh.h"
static const float in[{rows}][{inputs}] = {{{{{values}}}}};
int main(void)
{{
    int s, a, c, i;
    for (s = 0; s < {rows}; ++s) {{
        static float w[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS];
        static float g[SKYLIGHT_SH_AXES][SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS];
        memset(w, 0xff, sizeof w);
        memset(g, 0xff, sizeof g);
        printf("%d\\n", skylight_sh_weights_gradient({arguments}, w, g));
        for (c = 0; c < SKYLIGHT_SH_CHANNELS; ++c)
            for (i = 0; i < SKYLIGHT_SH_WEIGHTS; ++i) printf("%.9g\\n", (double)w[c][i]);
        for (a = 0; a < SKYLIGHT_SH_AXES; ++a)
            for (c = 0; c < SKYLIGHT_SH_CHANNELS; ++c)
                for (i = 0; i < SKYLIGHT_SH_WEIGHTS; ++i) printf("%.9g\\n", (double)g[a][c][i]);
    }}
    return 0;
}}
"""


def gradient(table: Table, rows: NDArray[np.float32], folder: Path) -> tuple[list[int], Array, Array]:
    """Status, weights ``(n, channels, N*N)`` and derivatives ``(n, axes, channels, N*N)`` by the header."""
    (folder / "skylight_sh.h").write_text(c_header.write(table, with_luminance(table)), encoding="utf-8")
    arguments = ", ".join(f"in[s][{i}]" for i in range(rows.shape[1]))
    values = "}, {".join(map(floats, rows)).replace("nanf", "NAN").replace("inff", "INFINITY")
    source = GRADIENT.format(rows=len(rows), inputs=rows.shape[1], values=values, arguments=arguments)
    found = np.array(run(folder, source, flags=STRICT).stdout.split(), dtype=np.float64).reshape(len(rows), -1)
    shape = (len(rows), 1 + len(table.axes), len(table.channels), table.bands**2)
    made = found[:, 1:].reshape(shape)
    return [int(s) for s in found[:, 0]], made[:, 0], made[:, 1:]


def three_axes() -> Table:
    rng = np.random.default_rng(5)
    axes = (Axis("sun_zenith", 0.25, 1.5), Axis("haze", 1.0, 3.0, map="log", point=0.5), Axis("albedo", -1.0, 1.0))
    dense = rng.normal(size=(2, sphere.Harmonics.even(3).count, 6, 4, 4))
    dense *= 2.0 ** -np.sum(np.indices(dense.shape[2:]), axis=0)
    return fast(specification(axes, ("a", "b"), True, "chebyshev", None), dense, np.full((2, 4, 4), 6), 3, "float64")


@pytest.mark.parametrize("name", [*FLAVOURS, "three axes"])
def test_derivatives_are_exact_everywhere(name: str) -> None:
    """Inside, on edges and in corners, against differences of the same polynomials in double precision."""
    found = claims_gradient.measure(three_axes() if name == "three axes" else FLAVOURS[name])
    assert set(found) == {"inside", "edges", "corners"}
    assert max(found.values()) < 1e-6, found


@pytest.mark.parametrize("name", ["rows", "packed", "float64", "surrounded", "three axes", "unmirrored"])
def test_derivatives_are_those_of_the_runtime(tmp_path: Path, name: str) -> None:
    """Weights too, and turned by the azimuth: against differences of the runtime's values."""
    table = three_axes() if name == "three axes" else FLAVOURS[name]
    rows = inside(table, 6)
    status, weights, slopes = gradient(table, rows, tmp_path)
    loaded = runtime.Runtime(table)
    inputs = rows.astype(np.float64)
    expected = loaded.weights(*inputs.T).astype(np.float64)
    assert status == [0] * len(rows)
    assert np.abs(weights - expected).max() < 2e-6 * np.abs(expected).max()
    for axis, (low, high) in enumerate(table.ranges):
        column = axis + (axis > 0)
        # Single precision allows no smaller step: its error is that of the third derivative.
        step = (1e-5 if table.dtype == np.float64 else 4e-3) * (high - low)
        ends = []
        for sign in (1, -1):
            moved = inputs.copy()
            moved[:, column] += sign * step
            ends.append(loaded.weights(*moved.T).astype(np.float64))
        found = (ends[0] - ends[1]) / (2 * step)
        bound = 2e-6 if table.dtype == np.float64 else 2e-3
        assert np.abs(slopes[:, axis] - found).max() < bound * np.abs(found).max(), axis


def test_derivatives_at_and_beyond_the_edges(tmp_path: Path) -> None:
    table = three_axes()
    rows = np.array(
        [[0.25, 0.4, 1.0, -1.0], [1.5, 0.4, 3.0, 1.0], [9.0, 0.4, 9.0, 9.0], [np.nan, 0.4, 2.0, 0.0]], np.float32
    )
    status, weights, slopes = gradient(table, rows, tmp_path)
    assert status == [0, 0, 1, 2]
    assert np.array_equal(slopes[1], slopes[2])
    assert not weights[3].any()
    assert not slopes[3].any()
    loaded = runtime.Runtime(table)
    for row, sign in ((0, 1.0), (1, -1.0)):
        for axis, (low, high) in enumerate(table.ranges):
            step = 1e-4 * (high - low) * sign
            moved = np.repeat(rows[row : row + 1].astype(np.float64), 3, axis=0)
            moved[1:, axis + (axis > 0)] += [step, 2 * step]
            at = loaded.weights(*moved.T).astype(np.float64)
            one_sided = (-3 * at[0] + 4 * at[1] - at[2]) / (2 * step)
            assert np.abs(slopes[row, axis] - one_sided).max() < 1e-4 * np.abs(one_sided).max()
