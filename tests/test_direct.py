"""The header that sums the sky itself: against the rings rule, the model in Python, libraries, and its twin in double."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tomllib
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from c_programs import FACTS
from conftest import ROOT, SMALL
from numpy.typing import NDArray
from skylight_sh import runtime, sphere
from skylight_sh.config import ConfigError, parse
from skylight_sh.config.schema import SceneSection
from skylight_sh.export import direct, direct_nodes, targets
from skylight_sh.fit.axis import Axis
from skylight_sh.light.preetham import Preetham
from skylight_sh.quadrature import rings, sun_centred
from skylight_sh.run.runner import Result
from skylight_sh.runtime import Table
from skylight_sh.table.table import fast, specification

Array = NDArray[np.float64]

HALF_PI = float(np.pi / 2)
RANGES = {"sun_zenith": (0.0, HALF_PI), "turbidity": (2.5, 6.0)}
STRICT = "-Wall -Wextra -Wconversion -Wshadow -pedantic -Werror"
EVERYTHING = "-Weverything -Werror -Wno-declaration-after-statement -Wno-padded -Wno-unknown-warning-option " + (
    "-Wno-unsafe-buffer-usage -Wno-c++98-compat-pedantic -Wno-old-style-cast -Wno-zero-as-null-pointer-constant"
)
BUILDS = {
    "gcc c99 -O3": f"gcc -std=c99 -O3 {STRICT}",
    "gcc -O3, native, fast-math": "gcc -std=c11 -O3 -march=native -ffast-math",
    "g++ c++11": f"g++ -x c++ -std=c++11 -O2 {STRICT}",
}
MORE_BUILDS = {
    "gcc, sanitizers": "gcc -std=c11 -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all",
    "clang c99 -O3": f"clang -std=c99 -O3 {EVERYTHING}",
    "clang++ c++11, native": f"clang++ -x c++ -std=c++11 -O3 -march=native {EVERYTHING}",
    "clang, memory": "clang -std=c11 -O1 -g -fsanitize=memory -fno-sanitize-recover=all",
}
PROGRAM = """
#include <stdio.h>
#include "skylight_sh_direct.h"
int main(void)
{
    float in[3], w[SKYLIGHT_SH_DIRECT_CHANNELS][SKYLIGHT_SH_DIRECT_WEIGHTS];
    while (fread(in, sizeof in, 1, stdin) == 1) {
        const int status = skylight_sh_direct_weights(in[0], in[1], in[2], w);
        fwrite(&status, sizeof status, 1, stdout);
        fwrite(w, sizeof w, 1, stdout);
    }
    return 0;
}
"""


def table_of(light: Preetham, bands: int, budget: float, **scene: Any) -> Table:
    """A table as a run ships it, but for its coefficients, of which the target reads nothing."""
    axes = tuple(Axis(name, *ends) for name, ends in RANGES.items())
    spec = specification(axes, light.channels, True, "chebyshev", None)
    options = {"model": light.model, "constants": light.constants, "colour_space": light.colour_space}
    config = {"light": options, "scene": SceneSection(**scene).model_dump(mode="json")}
    made = fast(spec, np.zeros((3, bands * (bands + 1) // 2, 1)), np.array(1), bands, "float32")
    return replace(made, provenance={"config": config, "budget": budget, "e_mean": budget})


def output(folder: Path, header: str, source: str, sent: Array, build: str) -> bytes:
    """What a program around the header writes to its output, given float32 numbers."""
    (folder / "skylight_sh_direct.h").write_text(header, encoding="utf-8")
    (folder / "program.c").write_text(source, encoding="utf-8")
    command = [*build.split(), "program.c", "-o", "program", "-lm"]
    made = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
    given = sent.astype(np.float32).tobytes()
    return subprocess.run(["./program"], cwd=folder, input=given, capture_output=True, check=True).stdout


def evaluated(folder: Path, header: str, inputs: Array, build: str = "gcc -O2") -> tuple[NDArray[np.int32], Array]:
    """Statuses and weights ``(n, 3, N*N)`` of inputs ``(n, 3)``."""
    out = output(folder, header, PROGRAM, inputs, build)
    rows = np.frombuffer(out, dtype=np.int32).reshape(len(inputs), -1)
    return rows[:, 0], rows[:, 1:].view(np.float32).reshape(len(inputs), 3, -1).astype(np.float64)


def macro(header: str, name: str) -> float:
    found = re.search(rf"#define SKYLIGHT_SH_DIRECT_{name} (\S+)", header)
    assert found
    return float(found[1].rstrip("f"))


def even(weights: Array) -> Array:
    """The weights of orders m >= 0."""
    return weights[..., sphere.Harmonics(sphere.bands_of(weights)).orders >= 0]


def points(count: int, turbidity: tuple[float, float], seed: int) -> Array:
    """Random suns and those of corners and edges, as float32 has them: ``(n, 2)``, none beyond the horizon."""
    rng = np.random.default_rng(seed)
    drawn = rng.uniform((0.0, turbidity[0]), (HALF_PI, turbidity[1]), (count, 2))
    inner = [v for v in (2.5, 6.0) if turbidity[0] < v < turbidity[1]]
    corners = list(product((0.0, 1e-4, 1.45, 1.55, 1.569, HALF_PI), (*turbidity, *inner)))
    found = np.concatenate([drawn, corners]).astype(np.float32).astype(np.float64)
    return np.stack([np.minimum(found[:, 0], HALF_PI), found[:, 1]], axis=-1)


def truth_of(light: Preetham, sets: Array, bands: int) -> tuple[Array, Array]:
    """Weights ``(n, 3, N(N+1)/2)`` by the rings rule, which shares nothing with this one, and the least luminances."""
    parameters = {"sun_zenith": sets[:, :1], "turbidity": sets[:, 1:]}
    found = rings.project(light, parameters, nodes=72, harmonics=sphere.Harmonics.even(bands))
    z, phi = np.meshgrid(np.linspace(0.0, 1.0, 61), np.linspace(0.0, np.pi, 61))
    flat = np.sqrt(1 - z**2)
    directions = np.stack([flat * np.cos(phi), flat * np.sin(phi), z], axis=-1).reshape(1, -1, 3)
    luminance = light.radiance(directions, parameters) @ light.luminance_row
    return found.weights[:, 0], luminance.min(axis=1)


def errors(found: Array, truth: Array, least: Array) -> Array:
    """E_mean of each set's worst channel, ``(n,)``."""
    return np.asarray(np.sqrt(np.square(even(found) - truth).sum(axis=-1)).max(axis=-1) / least)


def with_azimuth(sets: Array, azimuth: float = 0.0) -> Array:
    return np.insert(sets, 1, azimuth, axis=1)


@pytest.mark.parametrize(("bands", "budget"), [(7, 0.015), (7, 0.001), (7, 0.00005), (4, 0.001), (10, 0.001), (1, 0.001)])
def test_its_error_stays_within_the_budget(tmp_path: Path, bands: int, budget: float) -> None:
    """Over the table's ranges; anywhere else in the model's domain, near what the header says."""
    light = Preetham()
    header = direct.write(table_of(light, bands, budget))
    near, far = points(60, (2.5, 6.0), 5), points(60, (1.7, 10.0), 6)
    status, found = evaluated(tmp_path, header, with_azimuth(np.concatenate([near, far])))
    assert not status.any()
    within = errors(found[: len(near)], *truth_of(light, near, bands))
    assert within.max() <= budget
    assert within.max() <= 1.1 * macro(header, "E_MEAN") <= 1.1 * budget
    anywhere = errors(found[len(near) :], *truth_of(light, far, bands))
    assert anywhere.max() <= 1.2 * macro(header, "E_MEAN_ANYWHERE")


def test_the_other_constants(tmp_path: Path) -> None:
    light = Preetham(constants="smits")
    header = direct.write(table_of(light, 5, 0.001))
    sets = points(40, (2.5, 6.0), 7)
    _, found = evaluated(tmp_path, header, with_azimuth(sets))
    assert errors(found, *truth_of(light, sets, 5)).max() <= 0.001


def held_to_its_twin(folder: Path, build: str) -> None:
    """float32 adds less to the same sum in double than the choice of nodes allows for, whatever the compiler."""
    # Sanitizers take long to compile unrolled orders.
    light, bands, budget = Preetham(), 3 if "sanitize" in build else 7, 0.00005
    header = direct.write(table_of(light, bands, budget))
    nodes, _ = direct_nodes.choose(light, tuple(RANGES.values()), bands, budget)
    sets = points(60, (1.7, 10.0), 8)
    _, found = evaluated(folder, header, with_azimuth(sets), build)
    parameters = {"sun_zenith": sets[:, :1], "turbidity": sets[:, 1:]}
    twin = sun_centred.project(light, parameters, nodes=nodes, harmonics=sphere.Harmonics.even(bands)).weights[:, 0]
    added = np.linalg.norm(even(found) - twin, axis=-1) / np.linalg.norm(twin, axis=-1)
    assert added.max() <= direct_nodes.ROUNDING


@pytest.mark.parametrize("build", BUILDS)
def test_float32_adds_little(tmp_path: Path, build: str) -> None:
    held_to_its_twin(tmp_path, BUILDS[build])


@pytest.mark.tools
@pytest.mark.parametrize("build", MORE_BUILDS)
def test_float32_adds_little_in_clang_and_sanitized(tmp_path: Path, build: str) -> None:
    held_to_its_twin(tmp_path, MORE_BUILDS[build])


MODEL = """
#include <stdio.h>
#include "skylight_sh_direct.h"
int main(void)
{
    /* Zenith angle of the sun, turbidity; the direction's height and angle to the sun. */
    float in[4];
    int c, k;
    while (fread(in, sizeof in, 1, stdin) == 1) {
        const skylight_sh_direct_sky sky = skylight_sh_direct_model((double)in[0], (double)in[1]);
        const double cosine = cos((double)in[3]);
        double f[3], sums[3];
        for (k = 0; k < 3; ++k)
            f[k] = (1.0 + sky.a[k] * exp(sky.b[k] / (double)in[2])) *
                   (1.0 + sky.c[k] * exp(sky.d[k] * (double)in[3]) + sky.e[k] * cosine * cosine);
        sums[0] = f[1] * f[0] / f[2];
        sums[1] = f[0];
        sums[2] = f[0] / f[2];
        for (c = 0; c < 3; ++c) {
            const double radiance = sky.mix[c][0] * sums[0] + sky.mix[c][1] * sums[1] + sky.mix[c][2] * sums[2];
            fwrite(&radiance, sizeof radiance, 1, stdout);
        }
    }
    return 0;
}
"""


@pytest.mark.parametrize("constants", ["published", "smits"])
def test_its_model_is_the_one_in_python(tmp_path: Path, constants: Any) -> None:
    """Radiance at random points and corners, by the C function's numbers put into the paper's equations."""
    light = Preetham(constants=constants)
    sets = points(300, (1.7, 10.0), 9)
    rng = np.random.default_rng(10)
    z, phi = (rng.uniform(low, high, len(sets)).astype(np.float32).astype(np.float64) for low, high in ((0.01, 1), (-3, 3)))
    flat = np.sqrt(1 - z**2)
    directions = np.stack([flat * np.cos(phi), flat * np.sin(phi), z], axis=-1)
    parameters = {"sun_zenith": sets[:, 0], "turbidity": sets[:, 1]}
    expected = light.radiance(directions, parameters)
    towards = np.stack([np.sin(sets[:, 0]), 0 * z, np.cos(sets[:, 0])], axis=-1)
    gamma = np.arccos(np.clip(np.sum(directions * towards, axis=-1), -1, 1))
    header = direct.write(table_of(light, 3, 0.01))
    out = output(tmp_path, header, MODEL, np.column_stack([sets, z, gamma]), "gcc -O2")
    found = np.frombuffer(out).reshape(-1, 3)
    assert len(found) == len(sets)
    # float32 has the angle to the sun and A..E, which low turbidities subtract.
    assert np.abs(found - expected).max() / np.abs(expected).max() < 1e-6
    assert (np.abs(found - expected) / np.abs(expected).max(axis=1, keepdims=True)).max() < 3e-5


FUNCTION = """
#include <stdio.h>
#include "skylight_sh_direct.h"
int main(void)
{{
    float x;
    while (fread(&x, sizeof x, 1, stdin) == 1) {{
        const float y = skylight_sh_direct_{name}(x);
        fwrite(&y, sizeof y, 1, stdout);
    }}
    return 0;
}}
"""


def test_its_functions_are_those_of_the_library(tmp_path: Path) -> None:
    """To 2e-7: of 1, or of acos(1 - part) over the root."""
    header = direct.write(table_of(Preetham(), 3, 0.01))
    for name, low, high in (("exp", -87.0, 0.0), ("sin", -HALF_PI, HALF_PI), ("arc", 0.0, 1.0)):
        x = np.linspace(low, high, 20_001).astype(np.float32)
        out = output(tmp_path, header, FUNCTION.format(name=name), x, "gcc -O2")
        found, at = np.frombuffer(out, dtype=np.float32).astype(np.float64), x.astype(np.float64)
        if name == "arc":
            part = np.maximum(at, 1e-12)
            assert found == pytest.approx(2 * np.arcsin(np.sqrt(part / 2)) / np.sqrt(part), rel=2e-7)
        else:
            assert found == pytest.approx(np.exp(at) if name == "exp" else np.sin(at), abs=2e-7), name


def test_the_azimuth_turns_and_mirrors(tmp_path: Path) -> None:
    header = direct.write(table_of(Preetham(), 7, 0.001))
    sets = points(20, (2.5, 6.0), 11)
    azimuths = np.random.default_rng(12).uniform(-7, 7, len(sets)).astype(np.float32).astype(np.float64)
    turned = np.column_stack([sets[:, 0], azimuths, sets[:, 1]])
    _, found = evaluated(tmp_path, header, np.concatenate([with_azimuth(sets), turned, turned * [1.0, -1.0, 1.0]]))
    plain, ahead, behind = np.split(found, 3)
    expected = sphere.rotate_azimuth(plain, azimuths[:, np.newaxis])
    assert np.abs(ahead - expected).max() < 1e-6 * np.abs(plain).max()
    odd = sphere.Harmonics(7).orders < 0
    assert np.array_equal(np.where(odd, -ahead, ahead), behind)
    assert not np.abs(plain[..., odd]).any()


def test_returns_what_a_tables_header_does(tmp_path: Path) -> None:
    header = direct.write(table_of(Preetham(), 4, 0.01))
    nan, inf, huge = np.nan, np.inf, 3e38
    high = float(np.float32(HALF_PI))
    cases = [
        ((0.8, 0.3, 3.0), 0, None),
        # A millionth of the range counts as inside.
        ((high, 0.3, 3.0), 0, None),
        ((high + 1e-6, 0.3, 3.0), 0, (high, 0.3, 3.0)),
        ((-1e-6, 0.3, 10.000004), 0, (0.0, 0.3, 10.0)),
        ((high + 1e-5, 0.3, 3.0), 1, (high, 0.3, 3.0)),
        ((-0.1, 0.3, 3.0), 1, (0.0, 0.3, 3.0)),
        ((0.8, 0.3, 1.6), 1, (0.8, 0.3, 1.7)),
        ((0.8, 0.3, 11.0), 1, (0.8, 0.3, 10.0)),
        ((inf, 0.3, -inf), 1, (high, 0.3, 1.7)),
        ((-huge, 0.3, huge), 1, (0.0, 0.3, 10.0)),
        ((nan, 0.3, 3.0), 2, None),
        ((0.8, nan, 3.0), 2, None),
        ((0.8, inf, 3.0), 2, None),
        ((0.8, 0.3, nan), 2, None),
    ]
    inputs = np.array([case[0] for case in cases] + [case[2] or case[0] for case in cases])
    for build in ("gcc -O2", "gcc -O3 -ffast-math"):
        status, found = evaluated(tmp_path, header, inputs, build)
        given, clamped = np.split(found, 2)
        assert status[: len(cases)].tolist() == [case[1] for case in cases], build
        assert np.array_equal(given, clamped), build
        assert np.array_equal(np.abs(given).max(axis=(1, 2)) > 0, [case[1] < 2 for case in cases]), build


def test_it_stands_beside_a_tables_header_and_holds_its_function_once(tmp_path: Path, small_run: Result) -> None:
    table = runtime.read(small_run.folder / "export" / "skylight_sh.npz")
    facts = replace(FACTS, provenance=["made by a test */ and said so"])
    written = targets.write(("c", "direct"), table, facts, "day_sh")
    assert sorted(written) == ["skylight_sh.h", "skylight_sh_direct.h"]
    for name, data in written.items():
        (tmp_path / name).write_bytes(data)
    assert b"made by a test * / and said so" in written["skylight_sh_direct.h"]
    names = set(re.findall(r"\b(?:static inline|extern) \w+ (\w+)\(", written["skylight_sh_direct.h"].decode()))
    assert names
    assert all(name.startswith("day_sh_direct_") for name in names)
    unit = """{defines}
#include "skylight_sh.h"
#include "skylight_sh_direct.h"
#include <stdio.h>
#ifdef __cplusplus
extern "C"
#endif
void {name}(void);
void {name}(void)
{{
    float table[DAY_SH_CHANNELS][DAY_SH_WEIGHTS], sum[DAY_SH_DIRECT_CHANNELS][DAY_SH_DIRECT_WEIGHTS];
    printf("%d ", day_sh_weights(0.8f, 0.3f, 3.0f, table) + day_sh_direct_weights(0.8f, 0.3f, 3.0f, sum));
    printf("%.9g %.9g\\n", (double)table[1][2], (double)sum[1][2]);
}}
"""
    declaring = "#define DAY_SH_EXTERN\n#define DAY_SH_DIRECT_EXTERN"
    holding = f"{declaring}\n#define DAY_SH_IMPLEMENTATION\n#define DAY_SH_DIRECT_IMPLEMENTATION\n"
    # The function that holds the sums multiplies them.
    holding += "#define DAY_SH_DIRECT_EXPOSURE 0.5f"
    for name, defines in {"calling": declaring, "holding": holding, "plain": ""}.items():
        (tmp_path / f"{name}.c").write_text(unit.format(defines=defines, name=name), encoding="utf-8")
    main = "void calling(void);\nvoid plain(void);\nint main(void) { calling(); plain(); return 0; }\n"
    (tmp_path / "main.c").write_text(main, encoding="utf-8")
    subprocess.run(["g++", "-x", "c++", "-std=c++11", "-c", "holding.c", "-o", "holding.o"], cwd=tmp_path, check=True)
    subprocess.run(["gcc", "-std=c99", "-c", "calling.c", "main.c", "plain.c"], cwd=tmp_path, check=True)
    objects = [f"{name}.o" for name in ("holding", "calling", "main", "plain")]
    subprocess.run(["g++", *objects, "-o", "both", "-lm"], cwd=tmp_path, check=True)
    shown = subprocess.run(["./both"], cwd=tmp_path, capture_output=True, text=True, check=True).stdout
    (zero, table_called, halved), (_, table_plain, plain) = (map(float, line.split()) for line in shown.splitlines())
    assert zero == 0
    assert table_called == table_plain == pytest.approx(plain, rel=0.02)
    assert halved == pytest.approx(plain / 2, rel=1e-6)


def test_what_it_cannot_do_is_told_with_its_remedy() -> None:
    raw = tomllib.loads(SMALL.read_text(encoding="utf-8"))
    raw["export"] |= {"targets": ["c", "npz", "direct"]}
    parse(raw, "small", Path())
    scenes: list[tuple[str, Any]] = [
        ("sun_disc", True),
        ("quantity", "irradiance"),
        ("ground", [0.1, 0.2, 0.3]),
        ("twilight", True),
        ("azimuth", 0.5),
        ("channels", "luminance"),
        ("horizon", [0.1, 0.2, 0.3]),
    ]
    for key, value in scenes:
        with pytest.raises(ConfigError, match=rf'(?s)export\.targets.*"direct".*Leave scene\.{key} out, or "direct" out'):
            parse({**raw, "scene": {key: value}}, "small", Path())
    cie = {**raw, "light": {"model": "cie_general", "sky": 12}, "axes": raw["axes"][:1]}
    with pytest.raises(ConfigError, match=r'(?s)export\.targets.*"direct".*Use model = "preetham", or "direct" out'):
        parse(cie, "small", Path())


def test_tables_it_cannot_stand_beside_say_why() -> None:
    plain = table_of(Preetham(), 4, 0.01)
    assert direct.obstacle(plain) is None
    assert "does not say its light" in str(direct.obstacle(replace(plain, provenance={})))
    assert "scene.twilight" in str(direct.obstacle(table_of(Preetham(), 4, 0.01, twilight=True)))
    assert "17 bands" in str(direct.obstacle(table_of(Preetham(), 17, 0.01)))
    fine = table_of(Preetham(), 4, 1e-7)
    assert re.search(r"1e-07 in float32", str(direct.obstacle(fine)))
    with pytest.raises(ValueError, match="no sum of its sky beside it"):
        direct.write(fine)
    assert targets.write(("direct",), fine, FACTS, "sky_sh") == {}


def test_nodes_grow_with_the_budget_and_no_fewer_do() -> None:
    light, ranges = Preetham(), tuple(RANGES.values())
    sizes = []
    for budget in (0.015, 0.001, 0.00005):
        nodes, e_mean = direct_nodes.choose(light, ranges, 7, budget)
        assert (nodes.circles + nodes.arcs) % direct_nodes.SIDE == 0
        assert e_mean <= budget
        fewer = replace(nodes, waves=nodes.waves - 1)
        assert direct_nodes.e_mean(light, ranges, 7, fewer) > e_mean
        sizes.append((nodes.circles + nodes.arcs) * nodes.waves)
    assert sizes == sorted(sizes)
    assert sizes[0] < sizes[-1]


def test_the_parts_example_is_what_an_export_writes() -> None:
    folder = ROOT / "pipeline" / "skylight_sh" / "export" / "evaluators" / "c"
    assert (folder / "direct_example.h").read_text(encoding="utf-8") == direct.example()
    assert all(len(line) <= 100 for line in (folder / "direct.h").read_text(encoding="utf-8").splitlines())


def test_another_processors_header_is_the_same() -> None:
    """By kernels of another processor, which decide the last bits of sums and exponentials."""
    code = (
        "from test_direct import Preetham, direct, table_of\nprint(direct.write(table_of(Preetham(), 7, 0.00005)), end='')"
    )
    kernels = {"OPENBLAS_CORETYPE": "Nehalem", "NPY_DISABLE_CPU_FEATURES": "X86_V3 X86_V4 AVX512_ICL"}
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT / "tests"), *sys.path]), **kernels}
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
    assert done.stdout == direct.write(table_of(Preetham(), 7, 0.00005))


def test_a_prefix_too_long_is_shortened() -> None:
    table = table_of(Preetham(), 2, 0.01)
    text = direct.write(table, prefix="a" * 60)
    found = re.search(r"int\s+(\w+)_weights\(", text)
    assert found
    assert len(found[1]) <= 63
    assert found[1] != "a" * 60
    with pytest.raises(ValueError, match="Invalid prefix"):
        direct.write(table, prefix="A")
