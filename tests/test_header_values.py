"""Headers against formulas: every flavour's self-test by one compiler, derivatives, batches, and what a caller adds."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from pipeline import runtime, sphere
from pipeline.export import c_header, paper_literal, vectors
from pipeline.fit.axes import Axis
from pipeline.fit.maps import MAPS
from pipeline.stability.flavours import flavours
from pipeline.table import twilight
from pipeline.table.table import Frame, Table, fast

Array = NDArray[np.float64]
FLAVOURS = flavours()
FACTS = c_header.Facts("values", 0.0, 0.0, "per-set", [], luminance=(0.2, 0.7, 0.1))
GCC = ["gcc", "-std=c99"]
# At -O2 gcc sees what is read or written beyond the ends of arrays.
STRICT = ["-O2", "-Wall", "-Wextra", "-Werror", "-Wno-unused-function"]


def run(
    folder: Path, source: str, *arguments: str, check: bool = True, flags: Sequence[str] = ("-O1",)
) -> subprocess.CompletedProcess[str]:
    """Compile a C program in ``folder`` and run it there."""
    (folder / "program.c").write_text(source, encoding="utf-8")
    made = subprocess.run(
        [*GCC, *flags, "program.c", "-o", "program", "-lm"], cwd=folder, capture_output=True, text=True, check=False
    )
    assert made.returncode == 0, made.stderr
    return subprocess.run(["./program", *arguments], cwd=folder, capture_output=True, text=True, check=check)


def floats(values: NDArray[np.floating]) -> str:
    return ", ".join(f"{float(v):.9e}f" for v in np.asarray(values, dtype=np.float32).ravel())


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

    kept = "    return status;\n}\n\n/* Evaluates all bands. */"
    start = "    int i, status = skylight_sh_inputs("
    assert header.count(kept) == header.count(f", scale;\n{start}") == 1
    # The last weight stays as it was before the call: no number, so that it counts as no deviation.
    unset = header.replace(f", scale;\n{start}", f", scale;\n    const float left = weights[0][24];\n{start}")
    code, passed, failed, deviation = outcome(unset.replace(kept, "    weights[0][24] = left;\n" + kept))
    assert (code, failed) == (1, count - _invalid(table))
    assert deviation < vectors.BOUND
    code, passed, failed, deviation = outcome(header.replace(kept, "    weights[0][24] = 1e6f;\n" + kept))
    assert (code, failed) == (1, count - _invalid(table))
    assert deviation > 1.0
    assert outcome(header.replace("*status |= (v < first) | (v > last);", ""))[:2] == (1, count - _clamped(table))

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


CALLS = """
#include <stdio.h>
#include "skylight_sh.h"
static const float in[{count}] = {{{values}}};
int main(void)
{{
    int s;
    for (s = 0; s < {count}; ++s) {{
        float w[1][1];
        skylight_sh_weights(in[s], 0.0f, w);
        printf("%.9g\\n", (double)w[0][0]);
    }}
    return 0;
}}
"""


def one_weight(table: Table, values: Array, folder: Path) -> Array:
    """The only weight of a table of one axis, by its header."""
    (folder / "skylight_sh.h").write_text(c_header.write(table, FACTS), encoding="utf-8")
    return np.array(run(folder, CALLS.format(count=values.size, values=floats(values))).stdout.split(), dtype=np.float64)


def test_maps_in_c_are_those_of_python(tmp_path: Path) -> None:
    """Each map over a range that does not start at 0, against its formula in double."""
    points = {"identity": 0.0, "log": 0.7, "reciprocal": 5.5, "cbrt": 4.25, "raw": 0.0}
    assert set(points) == set(MAPS)
    for name, point in points.items():
        axis = Axis("haze", 1.25, 4.0, map=name, point=point)
        table = fast(Frame((axis,), ("one",), True, "monomial", None), np.array([[[0.5, 2.0]]]), np.array(2), 1, "float64")
        values = np.array([1.25, 1.5, 2.0, 3.0, 4.0])
        got = one_weight(table, values, tmp_path)
        scaled = {
            "identity": (values - 1.25) / 2.75 * 2 - 1,
            "log": np.log((values - 0.7) / 0.55) / np.log(3.3 / 0.55) * 2 - 1,
            "reciprocal": (1 / (5.5 - values) - 1 / 4.25) / (1 / 1.5 - 1 / 4.25) * 2 - 1,
            "cbrt": (np.cbrt(3.0) - np.cbrt(4.25 - values)) / (np.cbrt(3.0) - np.cbrt(0.25)) * 2 - 1,
            "raw": values,
        }[name]
        assert got == pytest.approx(0.5 + 2.0 * scaled, abs=1e-6), name


def test_bases_in_c_are_those_of_numpy(tmp_path: Path) -> None:
    u = np.array([-1.0, -0.75, -0.125, 0.0, 0.3125, 0.875, 1.0])
    waves = [np.ones_like(u)] + [f(k * np.pi * u) for k in range(1, 5) for f in (np.cos, np.sin)]
    expected = {
        "chebyshev": np.polynomial.chebyshev.chebvander(u, 8),
        "legendre": np.polynomial.legendre.legvander(u, 8),
        "monomial": np.vander(u, 9, increasing=True),
        "fourier": np.stack(waves[:9], axis=-1),
    }
    numbers = 3.0 ** -np.arange(9)
    for name, values in expected.items():
        frame = Frame((Axis("haze", -1.0, 1.0),), ("one",), True, name, None)
        table = fast(frame, numbers[np.newaxis, np.newaxis], np.array(9), 1, "float64")
        got = one_weight(table, u, tmp_path)
        assert got == pytest.approx(values @ numbers, abs=1e-6), name


BATCH = """
#include <stdio.h>
#include "skylight_sh.h"
#define SUNS {suns}
{columns}
static float out[SUNS + 1][SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS], one[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS];
int main(void)
{{
    int s, status, worst = 0, c, i;
    double far = 0, large = 0;
    memset(out, 0x7f, sizeof out);
    status = skylight_sh_weights_batch(SUNS, {names}, out);
    for (s = 0; s < SUNS; ++s) {{
        const int single = skylight_sh_weights({elements}, one);
        worst = single > worst ? single : worst;
        for (c = 0; c < SKYLIGHT_SH_CHANNELS; ++c)
            for (i = 0; i < SKYLIGHT_SH_WEIGHTS; ++i) {{
                const double d = fabs((double)out[s][c][i] - (double)one[c][i]), size = fabs((double)one[c][i]);
                far = d > far ? d : far;
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


@pytest.mark.parametrize("name", FLAVOURS)
@pytest.mark.parametrize("invalid", [False, True], ids=["valid", "with a NaN"])
def test_a_batch_is_its_single_calls(tmp_path: Path, name: str, invalid: bool) -> None:
    """Suns that share the other axes and suns that do not, one of them clamped; nothing behind the last is touched."""
    table = FLAVOURS[name]
    (tmp_path / "skylight_sh.h").write_text(c_header.write(table, with_luminance(table)), encoding="utf-8")
    rows = inside(table, 12)
    rows[2:5, 2:] = rows[2, 2:]
    rows[7, 0] = 50.0
    rows[9, 2:] = rows[8, 2:]
    columns = [f"x{i}" for i in range(rows.shape[1])]
    texts = [f"static const float {c}[SUNS] = {{{floats(rows[:, i])}}};" for i, c in enumerate(columns)]
    if invalid:
        texts[1] = texts[1].replace(floats(rows[4:5, 1]), "NAN", 1)
    source = BATCH.format(
        suns=len(rows), columns="\n".join(texts), names=", ".join(columns), elements=", ".join(f"{c}[s]" for c in columns)
    )
    status, worst, touched, far = run(tmp_path, source, flags=STRICT).stdout.split()
    assert int(status) == int(worst) == (2 if invalid else 1)
    assert touched == "0"
    assert float(far) < 2e-6


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
    dense = rng.normal(size=(2, sphere.count(3, mirrored=True), 6, 4, 4))
    dense *= 2.0 ** -np.sum(np.indices(dense.shape[2:]), axis=0)
    return fast(Frame(axes, ("a", "b"), True, "chebyshev", None), dense, np.full((4, 4), 6), 3, "float64")


@pytest.mark.parametrize("name", ["rows", "packed", "float64", "surrounded", "three axes"])
def test_derivatives_are_those_of_the_runtime(tmp_path: Path, name: str) -> None:
    """Against differences of the runtime's values, in double precision where the table is of that."""
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


ADDED = """
#include <stdio.h>
#include "skylight_sh.h"
static float w[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS] = {{{weights}}};
static void show(void)
{{
    int c, i;
    for (c = 0; c < SKYLIGHT_SH_CHANNELS; ++c)
        for (i = 0; i < SKYLIGHT_SH_WEIGHTS; ++i) printf("%.9g ", (double)w[c][i]);
    printf("\\n");
}}
int main(void)
{{
{body}
    return 0;
}}
"""


def added(folder: Path, weights: NDArray[np.floating], body: str) -> list[Array]:
    source = ADDED.format(weights=floats(weights), body=body)
    return [np.array(line.split(), dtype=np.float64) for line in run(folder, source).stdout.splitlines()]


def header_of_three_bands(folder: Path) -> Table:
    frame = Frame((Axis("sun_zenith", 0.0, 1.0),), ("r", "g", "b"), True, "chebyshev", None)
    table = fast(frame, np.ones((3, 6, 2)), np.array(2), 3, "float32")
    (folder / "skylight_sh.h").write_text(c_header.write(table, FACTS), encoding="utf-8")
    return table


def test_the_dominant_light_points_along_the_linear_part(tmp_path: Path) -> None:
    """Weights of a light from one direction are the basis there: the direction comes back."""
    header_of_three_bands(tmp_path)
    direction = np.array([0.6, -0.48, 0.64])
    basis = sphere.basis(direction[np.newaxis], 3)[0]
    # Channels that disagree: luminance 0.2, 0.7, 0.1 decides.
    colours = np.array([1.0, 2.0, 3.0])
    weights = colours[:, np.newaxis] * basis
    body = "    float d[3]; int s = skylight_sh_dominant(w, d);\n"
    body += '    printf("%d %.9g %.9g %.9g\\n", s, (double)d[0], (double)d[1], (double)d[2]);\n'
    (found,) = added(tmp_path, weights, body)
    assert found == pytest.approx([0.0, *direction], abs=1e-6)
    other = np.stack([basis, sphere.basis(np.array([[0.0, 1.0, 0.0]]), 3)[0], basis])
    pull = 0.3 * direction + 0.7 * np.array([0.0, 1.0, 0.0])
    (found,) = added(tmp_path, other, body)
    assert found[1:] == pytest.approx(pull / np.linalg.norm(pull), abs=1e-6)
    (found,) = added(tmp_path, np.zeros((3, 9)), body)
    assert found.tolist() == [1.0, 0.0, 0.0, 1.0]


def test_a_ground_reflects_what_falls_on_it(tmp_path: Path) -> None:
    """Radiance albedo E / pi below the horizon, E of the sky alone, whose weights are then those of the lower half."""
    header_of_three_bands(tmp_path)
    rng = np.random.default_rng(2)
    weights = rng.normal(size=(3, 9))
    albedo = np.array([0.1, 0.5, 0.9])
    body = f"    static const float albedo[3] = {{{floats(albedo)}}};\n    skylight_sh_ground(albedo, w);\n    show();\n"
    (found,) = added(tmp_path, weights, body)
    x, gauss = np.polynomial.legendre.leggauss(40)
    z = (x - 1) / 2
    legendre = np.stack([np.ones_like(z), z, (3 * z * z - 1) / 2])
    lower = np.sqrt((2 * np.arange(3) + 1) / (4 * np.pi)) * 2 * np.pi * (legendre @ (gauss / 2))
    # E of an upper half sky: only l = 1 looks up, doubled, since the lower half is black.
    radiance = albedo * weights[:, 2] * 2 * np.sqrt(np.pi / 3) / np.pi
    expected = weights.copy()
    expected[:, [0, 2, 6]] += radiance[:, np.newaxis] * lower
    assert found == pytest.approx(expected.ravel(), abs=1e-6)


@pytest.mark.parametrize("bands", [1, 2, 3, 5])
def test_the_zonal_window_is_a_sinc_of_its_bands(tmp_path: Path, bands: int) -> None:
    header_of_three_bands(tmp_path)
    weights = np.random.default_rng(3).normal(size=(3, 9))
    (found,) = added(tmp_path, weights, f"    skylight_sh_window({bands}, w);\n    show();\n")
    l, m = sphere.degrees_orders(3)
    factors = np.where((l < bands) & (m == 0), np.sinc(l / bands), 1.0)
    assert found == pytest.approx((weights * factors).ravel(), abs=1e-6)


@pytest.mark.parametrize("dtype", ["float32", "float64"])
def test_twilight_fades_as_its_formula_says(tmp_path: Path, dtype: str) -> None:
    frame = Frame((Axis("sun_zenith", 0.0, float(np.pi / 2)),), ("one",), True, "chebyshev", None, twilight=True)
    table = fast(frame, np.array([[[3.0]]]), np.array(1), 1, dtype)
    (tmp_path / "skylight_sh.h").write_text(c_header.write(table, FACTS), encoding="utf-8")
    depth = np.array([-1.0, -1e-3, 0.0, 1e-3, 0.03, 0.1, 0.15, 0.2, twilight.DEPTH])
    angles = (np.pi / 2 + depth).astype(np.float32)
    calls = "".join(f"    skylight_sh_weights({float(v):.9e}f, 0.0f, w); show();\n" for v in angles)
    found = np.concatenate(added(tmp_path, np.zeros((1, 1)), calls))
    x = np.clip((angles.astype(np.float64) - np.pi / 2) / np.radians(12.0), 0.0, 1.0)
    assert found == pytest.approx(3.0 * (1 - x) ** 10 * (1 + 10 * x), rel=2e-5, abs=1e-9)
    if dtype == "float64":
        # The depth is the difference of close numbers: double precision keeps its own.
        assert found == pytest.approx(3.0 * (1 - x) ** 10 * (1 + 10 * x), rel=1e-6, abs=1e-9)


def test_the_papers_scheme_is_its_equations(tmp_path: Path) -> None:
    """Monomials times coefficients, then eq. 4: the other axes' powers run fastest."""
    rng = np.random.default_rng(8)
    coefficients = rng.normal(size=(2, 9, 4, 3))
    (tmp_path / "skylight_sh.h").write_text(
        paper_literal.write(coefficients, ["sun_zenith", "turbidity"], ["a", "b"], "skylight_sh"), encoding="utf-8"
    )
    theta, phi, tau = 0.75, -1.25, 2.5
    source = """#include <stdio.h>
#include "skylight_sh.h"
int main(void)
{
    float w[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS];
    int c, i, status = skylight_sh_weights(0.75f, -1.25f, 2.5f, w);
    printf("%d\\n", status);
    for (c = 0; c < 2; ++c)
        for (i = 0; i < 9; ++i) printf("%.9g\\n", (double)w[c][i]);
    return 0;
}
"""
    found = np.array(run(tmp_path, source).stdout.split(), dtype=np.float64)
    made = np.einsum("cwij,i,j->cw", coefficients, theta ** np.arange(4), tau ** np.arange(3))
    expected = made.copy()
    for l in range(3):
        for m in range(1, l + 1):
            plus, minus = l * (l + 1) + m, l * (l + 1) - m
            expected[:, plus] = made[:, plus] * np.cos(m * phi) - made[:, minus] * np.sin(m * phi)
            expected[:, minus] = made[:, minus] * np.cos(m * phi) + made[:, plus] * np.sin(m * phi)
    assert found == pytest.approx([0.0, *expected.ravel()], rel=1e-6)
