"""GLSL and HLSL without a GPU: a few lines of C++ give them their types, g++ compiles them, and the runtime agrees."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
import shader_tools
from shader_tools import FACTS
from skylight_sh import runtime, sphere
from skylight_sh.export import shaders
from skylight_sh.export.reserved import usable
from skylight_sh.fit.axis import Axis
from skylight_sh.formula.bases import BASES
from skylight_sh.table.table import fast, specification
from test_shaders import MADE, Array, Floats, directions, drawn, lobe, tables

TYPES = """
#include <algorithm>
#include <cmath>
#include <cstdio>
using namespace std;
static float clamp(float v, float low, float high) { return min(max(v, low), high); }
template <int N> struct vec;
template <> struct vec<2> { float x, y; vec() {} vec(float a, float b) : x(a), y(b) {} };
template <> struct vec<3> { float x, y, z; vec() {} vec(float a, float b, float c) : x(a), y(b), z(c) {} };
template <> struct vec<4> {
    float x, y, z, w; vec() {} vec(float a, float b, float c, float d) : x(a), y(b), z(c), w(d) {} };
template <int N> float &part(vec<N> &v, int i) { return (&v.x)[i]; }
template <int N> vec<N> operator*(vec<N> v, float f) { for (int i = 0; i < N; ++i) part(v, i) *= f; return v; }
template <int N> vec<N> operator*(float f, vec<N> v) { return v * f; }
template <int N> vec<N> operator-(vec<N> v) { return v * -1.0f; }
template <int N> vec<N> operator+(vec<N> a, vec<N> b) { for (int i = 0; i < N; ++i) part(a, i) += part(b, i); return a; }
template <int N> vec<N> operator-(vec<N> a, vec<N> b) { return a + -b; }
template <int N> vec<N> &operator+=(vec<N> &a, vec<N> b) { return a = a + b; }
typedef vec<2> vec2; typedef vec<3> vec3; typedef vec<4> vec4;
typedef vec<2> float2; typedef vec<3> float3; typedef vec<4> float4;
#define out
static vec4 result;
static struct { float x, y; } gl_FragCoord;
"""
LOOP = """
int main()
{{
    for (int s = 0; s < {height}; ++s)
        for (int i = 0; i < {width}; ++i) {{
            const vec4 pixel = {pixel};
            fwrite(&pixel, sizeof pixel, 1, stdout);
        }}
}}
"""
HEADS = {
    "glsl": ("void main()", "static vec4 shade()", "(gl_FragCoord.x = (float)i, gl_FragCoord.y = (float)s, shade())"),
    "hlsl": (
        "float4 main(float4 place : SV_Position) : SV_Target",
        "static vec4 shade(vec4 place)",
        "shade(vec4((float)i, (float)s, 0.0f, 0.0f))",
    ),
}


def run(source: str, folder: Path) -> bytes:
    """Compile a C++ program in single precision, and return what it prints."""
    (folder / "shader.cpp").write_text(source, encoding="utf-8")
    command = ["g++", "-std=c++11", "-O1", "-fsingle-precision-constant", "-ffp-contract=off", "-o", str(folder / "shader")]
    done = subprocess.run([*command, str(folder / "shader.cpp")], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return subprocess.run([str(folder / "shader")], capture_output=True, check=True).stdout


def image(made: shader_tools.Program, folder: Path) -> Floats:
    """Compile a program as C++ and run it: ``(height, width, 4)``."""
    head, named, pixel = HEADS[made.language]
    assert head in made.source
    text = (
        made.source.replace("#version 300 es", "").replace("layout(location = 0) out vec4 result;", "").replace(head, named)
    )
    text = re.sub(r"= \w+\[\d+\]\(([^;]*)\);", r"= {\1};", text).replace("result =", "return")
    loop = LOOP.format(height=made.height, width=made.width, pixel=pixel)
    out = run(TYPES + text + loop, folder)
    return np.frombuffer(out, dtype="<f4").reshape(made.height, made.width, 4)


@pytest.mark.parametrize("language", HEADS)
@pytest.mark.parametrize("name", ["preetham", "twilight", *MADE])
def test_shaders_compiled_as_cpp_agree_with_the_runtime(tmp_path: Path, name: str, language: str) -> None:
    table = tables()[name]
    inputs = drawn(table)
    got = image(shader_tools.program(table, language, inputs, directions()), tmp_path).astype(np.float64)
    weights, status = runtime.Runtime(table).weights_and_status(*inputs.T.astype(np.float64))
    assert set(status.tolist()) == {0, 1}
    assert np.array_equal(got[..., 3], np.broadcast_to(status[:, np.newaxis], got.shape[:2]))

    degrees = sphere.Harmonics(table.bands).degrees
    basis: Array = sphere.basis(directions().astype(np.float64), table.bands)
    bent = weights * lobe(table.bands)[degrees]
    expected = np.concatenate([weights, weights @ basis.T, bent @ basis.T], axis=-1)
    values = got[..., : len(table.channels)].swapaxes(1, 2)
    assert values.shape == expected.shape
    assert np.abs(values - expected).max() < 1e-5 * np.abs(weights).max()


@pytest.mark.parametrize("name", BASES)
def test_bases_are_those_of_numpy(tmp_path: Path, name: str) -> None:
    u = np.array([-1.0, -0.75, -0.125, 0.0, 0.3125, 0.875, 1.0])
    waves = [np.ones_like(u)] + [f(k * np.pi * u) for k in range(1, 5) for f in (np.cos, np.sin)]
    expected = {
        "chebyshev": np.polynomial.chebyshev.chebvander(u, 8),
        "legendre": np.polynomial.legendre.legvander(u, 8),
        "monomial": np.vander(u, 9, increasing=True),
        "fourier": np.stack(waves[:9], axis=-1),
    }[name]
    numbers = 1.5 ** -np.arange(9)
    frame = specification((Axis("haze", -1.0, 1.0),), ("one",), True, name, None)
    table = fast(frame, numbers[np.newaxis, np.newaxis], np.array([9]), 1, "float32")
    inputs = np.stack([u, np.zeros_like(u)], axis=-1).astype(np.float32)
    for language in HEADS:
        got = image(shader_tools.program(table, language, inputs, directions()), tmp_path)
        assert got[:, 0, 0] == pytest.approx(expected @ numbers, abs=2e-6)


def test_axes_of_any_usable_name_compile(tmp_path: Path) -> None:
    """Those that occur in a shader among them."""
    hour = Axis("hour", 0.0, 3.0, map="log", point=-0.5)

    def text(name: str, prefix: str = "skylight_sh") -> str:
        spec = specification((hour, Axis(name, 0.5, 1.0, map="cbrt", point=2.0)), ("one",), True, "chebyshev")
        return shaders.write(fast(spec, np.ones((1, 4, 3, 2)), np.array([[3, 2]]), 2, "float32"), FACTS, "glsl", prefix)

    words = sorted(set(re.findall(r"[a-z][a-z0-9_]+", re.sub(r"//[^\n]*|#[^\n]*", "", text("haze")))))
    allowed = [word for word in words if usable(word) and not word.startswith("skylight")]
    assert {"haze", "normal"} <= set(allowed)
    assert {"weights", "row", "status", "clamp", "pow"} <= set(words) - set(allowed)
    made = "\n".join(text(word, f"p{i}") for i, word in enumerate(allowed) if word != "hour")
    run(TYPES + re.sub(r"= \w+\[\d+\]\(([^;]*)\);", r"= {\1};", made) + "\nint main() { return 0; }\n", tmp_path)


def test_waves_are_cosine_and_sine_to_the_last_bits(tmp_path: Path) -> None:
    """In all quadrants and at their edges, where the reduction by quarter turns rounds."""
    edges = np.arange(-40, 41) * np.pi / 8
    angles = np.concatenate([np.linspace(-10.0, 10.0, 4001), edges, np.nextafter(edges, 9.0)]).astype(np.float32)
    text = shaders.write(tables()["preetham"], shader_tools.FACTS, "glsl")
    text = re.sub(r"= \w+\[\d+\]\(([^;]*)\);", r"= {\1};", text)
    values = ", ".join(f"{float(v):.9e}f" for v in angles)
    main = f"""
static const float in[{angles.size}] = {{{values}}};
int main()
{{
    for (float angle : in) {{
        const vec2 wave = skylight_sh_wave(angle);
        fwrite(&wave, sizeof wave, 1, stdout);
    }}
}}
"""
    got = np.frombuffer(run(TYPES + text + main, tmp_path), dtype="<f4").reshape(-1, 2)
    exact = angles.astype(np.float64)
    assert np.abs(got - np.stack([np.cos(exact), np.sin(exact)], axis=-1)).max() < 2e-7
