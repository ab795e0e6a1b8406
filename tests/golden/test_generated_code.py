"""Generated C, GLSL and HLSL against an evaluation of its own: values, complex-step slopes, ground, window, irradiance."""

from __future__ import annotations

import itertools
import math
import re
import subprocess
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh import runtime
from skylight_sh.export import c_header, paper_literal, shaders
from skylight_sh.export.c_header import Facts
from skylight_sh.fit.axis import Axis
from skylight_sh.formula.elementary import cos, exp
from skylight_sh.light.perez import Perez
from skylight_sh.light.preetham import Preetham
from skylight_sh.light.protocol import Prefactor
from skylight_sh.runtime import Scale, Table
from skylight_sh.table.prefactor import closed_form, reciprocal
from skylight_sh.table.table import fast, specification
from skylight_sh.table.twilight import TWILIGHT

from golden.oracles import basis, degrees, hemisphere, lobe, orders, preetham_shape, sinc, upper

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
FACTS = Facts("a table", 0.001, 0.004, "per-set", [], luminance=(0.3, 0.6, 0.1))


def polynomial(coefficients: Array, u: list[complex], basis_name: str) -> complex:
    """Sum of coefficients over products of Chebyshev (or other) functions, last axis first."""
    sums = {
        "chebyshev": np.polynomial.chebyshev.chebval,
        "legendre": np.polynomial.legendre.legval,
        "monomial": np.polynomial.polynomial.polyval,
    }
    out: Complex = coefficients.astype(complex)
    for x in reversed(u):
        out = np.apply_along_axis(lambda c, x=x: sums[basis_name](x, c), -1, out)
    return complex(out)


def mapped(axis: Axis, v: complex) -> complex:
    """The variable linear in the map's function, -1 and 1 at the ends (README)."""
    functions: dict[str, Callable[[complex], complex]] = {
        "identity": lambda x: x,
        # A ratio of distances, which is positive on either side of the point.
        "log": lambda x: np.log(complex((x - axis.point) / (axis.low - axis.point))),
        "reciprocal": lambda x: 1 / (axis.point - x),
        "cbrt": lambda x: complex(axis.point - x) ** (1 / 3) if x != axis.point else 0j,
    }
    f = functions[axis.map]
    return complex(2 * (f(v) - f(axis.low)) / (f(axis.high) - f(axis.low)) - 1)


def preetham_factor(values: list[complex]) -> complex:
    """The prefactor's series (see test_preetham), for complex numbers too."""
    theta, tau = values
    a, b, c, d, e = (complex(k) for k in preetham_shape("published", "Y", 0.0))
    slopes = [s - o for s, o in zip(preetham_shape("published", "Y", 1.0), (a, b, c, d, e), strict=True)]
    a, b, c, d, e = (o + s * tau for o, s in zip((a, b, c, d, e), slopes, strict=True))
    chi = (4 / 9 - tau / 120) * (math.pi - 2 * theta)
    tangent = chi / (1 - chi**2 / (3 - chi**2 / (5 - chi**2 / 7)))
    up, halo = (1 + b / 4 + (b / 4) ** 2 / 2) ** 4, (1 + d * theta / 8 + (d * theta / 8) ** 2 / 2) ** 8
    cosine = 1 - theta**2 / 2 + theta**4 / 24 - theta**6 / 720
    zenith = 1000 * ((4.0453 * tau - 4.9710) * tangent - 0.2155 * tau + 2.4192)
    return complex(zenith / ((1 + a * up) * (1 + c * halo + e * cosine**2)))


def perez_factor(values: list[complex]) -> complex:
    from perezsky.coefficients import LUMINANCE_1993

    theta, delta = values
    a, b, c, d, e = (r[0] + r[1] * theta + delta * (r[2] + r[3] * theta) for r in LUMINANCE_1993[4])
    return complex(1 / ((1 + a * np.exp(b)) * (1 + c * np.exp(d * theta) + e * np.cos(theta) ** 2)))


@dataclass(frozen=True)
class Made:
    """A table and what its evaluation must give: ``factor`` is a number, or a matrix of channels and classes."""

    table: Table
    dense: Array
    factor: Callable[[list[complex]], complex | Complex]

    def stored(self, values: list[complex]) -> Complex:
        """The weights at azimuth 0, ``(channels, stored)``."""
        u = [mapped(axis, v) for axis, v in zip(self.table.axes, values, strict=True)]
        rows = [polynomial(c, u, self.table.spec.basis) for c in self.dense.reshape(-1, *self.dense.shape[2:])]
        sums, factor = np.reshape(rows, self.dense.shape[:2]), np.asarray(self.factor(values))
        found = factor @ sums if factor.ndim else factor * sums
        if self.table.spec.parity:
            m = orders(self.table.bands)
            found = found * np.sin(values[0]) ** np.abs(m[m >= 0] if self.table.spec.mirrored else m)
        return np.asarray(found)

    def turned(self, stored: Array, azimuth: float) -> Array:
        """Eq. 4: all weights, ``(channels, N*N)``."""
        bands = self.table.bands
        l, m = degrees(bands), orders(bands)
        full = np.zeros((len(stored), bands**2))
        full[:, m >= 0 if self.table.spec.mirrored else slice(None)] = stored
        partner = full[:, l * (l + 1) - m]
        return np.where(
            m >= 0,
            full * np.cos(m * azimuth) - partner * np.sin(m * azimuth),
            full * np.cos(m * azimuth) - partner * np.sin(m * azimuth),
        )

    def weights(self, values: list[float], azimuth: float) -> Array:
        return self.turned(self.stored([complex(v) for v in values]).real, azimuth)

    def gradient(self, values: list[float], azimuth: float) -> Array:
        """By a complex step (Squire and Trapp 1998), ``(axes, channels, N*N)``."""
        out = []
        for i in range(len(values)):
            moved = [complex(v, 1e-30 if i == k else 0.0) for k, v in enumerate(values)]
            out.append(self.turned(self.stored(moved).imag / 1e-30, azimuth))
        return np.array(out)


def make(
    axes: tuple[Axis, ...],
    top: tuple[int, ...],
    bands: int,
    scale: Scale | None,
    formula: Callable[[list[complex]], complex | Complex] | None = None,
    *,
    mirrored: bool = True,
    parity: bool = False,
    dtype: str = "float64",
    basis_name: str = "chebyshev",
    channels: int = 3,
) -> Made:
    rng = np.random.default_rng(sum(top) + bands)
    names = ("red", "green", "blue")[:channels]
    spec = specification(axes, names, mirrored, basis_name, scale, peak_axis=axes[0].name, parity=parity)
    count = bands * (bands + 1) // 2 if mirrored else bands**2
    dense = rng.normal(size=(spec.classes, count, *(d + 1 for d in top)))
    lengths = np.full([spec.classes, *(d + 1 for d in top[1:])], top[0] + 1)
    table = fast(spec, dense, lengths, bands, dtype)
    return Made(table, dense, formula or (lambda _: 1.0 + 0j))


def specified(axes: tuple[Axis, ...]) -> list[runtime.Axis]:
    return [axis.specified for axis in axes]


def over_polynomial(axes: tuple[Axis, ...], numbers: Array) -> Callable[[list[complex]], complex]:
    return lambda values: 1 / polynomial(numbers, [mapped(a, v) for a, v in zip(axes, values, strict=True)], "chebyshev")


PREETHAM = Preetham().hints.prefactor
PEREZ = Perez(category=5).hints.prefactor
assert PREETHAM is not None
assert PEREZ is not None
SUN, WEATHER = (
    Axis("sun_zenith", 0.0, 1.5, "rad", "reciprocal", 5.0),
    Axis("turbidity", 2.5, 6.0, map="reciprocal", point=-2.0),
)
TWO = (Axis("sun_zenith", 0.0, 1.5, map="cbrt", point=1.5), Axis("turbidity", 2.5, 6.0, map="log", point=0.5))
THREE = (
    Axis("sun_zenith", 0.0, 1.5),
    Axis("albedo", 0.0, 1.0, map="cbrt", point=1.3),
    Axis("haze", 1.0, 3.0, map="log", point=4.0),
)
BRIGHT = (replace(SUN, map="identity"), Axis("brightness", 0.2, 0.5))
# What three channels take of two classes.
MATRIX = Prefactor(
    "matrix",
    ("sun_zenith", "turbidity"),
    (0.5, -2.0),
    lambda v, w, k: [k[0] * w, exp(-v), 1 / (v + w), -1.0, v * w + k[1], cos(v) * w],
)


def matrix(values: list[complex]) -> Complex:
    v, w = values
    return np.array([[0.5 * w, np.exp(-v)], [1 / (v + w), -1.0], [v * w - 2.0, np.cos(v) * w]])


DENOMINATOR = np.array([[2.0, 0.3], [-0.1, 0.2], [0.05, 0.0]])
MADE = {
    "preetham": make((SUN, WEATHER), (5, 3), 4, closed_form(PREETHAM, specified((SUN, WEATHER))), preetham_factor),
    "perez": make(
        BRIGHT,
        (3, 2),
        2,
        closed_form(PEREZ, specified(BRIGHT)),
        perez_factor,
        mirrored=False,
    ),
    "pole": make(TWO, (4, 3), 3, reciprocal(DENOMINATOR, specified(TWO)), over_polynomial(TWO, DENOMINATOR)),
    "three": make(THREE, (3, 2, 4), 2, None, channels=1),
    "one": make((replace(SUN, map="log", point=-0.3),), (6,), 3, None, channels=1, mirrored=False),
    "single": make(
        (SUN, WEATHER), (5, 3), 4, closed_form(PREETHAM, specified((SUN, WEATHER))), preetham_factor, dtype="float32"
    ),
    "legendre": make((SUN, WEATHER), (4, 3), 2, None, basis_name="legendre", mirrored=False),
    "classes": make((SUN, WEATHER), (5, 3), 4, closed_form(MATRIX, specified((SUN, WEATHER))), matrix, parity=True),
    "asymmetric": make(TWO, (4, 2), 3, closed_form(MATRIX, specified(TWO)), matrix, parity=True, mirrored=False),
    "monomial": make((replace(SUN, map="identity"),), (7,), 2, None, basis_name="monomial"),
}
SHARES = (0.13, 0.5, 0.91)
AZIMUTHS = (0.4, -2.0, 3.0)


def inputs(made: Made) -> list[tuple[list[float], float]]:
    out = []
    for share, azimuth in zip(SHARES, AZIMUTHS, strict=True):
        turns = [(share + 0.31 * i) % 1.0 for i in range(len(made.table.axes))]
        values = [float(np.float32(a.low + t * (a.high - a.low))) for a, t in zip(made.table.axes, turns, strict=True)]
        out.append((values, float(np.float32(azimuth))))
    return out


@pytest.fixture(scope="module")
def printed(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Array]:
    """What one program of all headers prints: for each input the weights, the gradient, then ground and window."""
    folder = tmp_path_factory.mktemp("c")
    body, sizes = [], {}
    for name, made in MADE.items():
        prefix, table = f"{name}_sh", made.table
        (folder / f"{name}.h").write_text(c_header.write(table, FACTS, prefix), encoding="utf-8")
        axes, channels, count = len(table.axes), len(table.channels), table.bands**2
        slopes = table.spec.basis == "chebyshev"
        body.append(f"static float {name}_w[{channels}][{count}], {name}_g[{axes}][{channels}][{count}], {name}_d[3];")
        body.append(f"static const float {name}_a[3] = {{ 0.1f, 0.5f, 0.9f }};\nstatic void {name}_run(void) {{")
        for values, azimuth in inputs(made):
            first, *rest = (f"{v!r}f" for v in values)
            given = ", ".join([first, f"{azimuth!r}f", *rest])
            tail = f", {name}_g" if slopes else ""
            body.append(f"{prefix}_weights{'_gradient' if slopes else ''}({given}, {name}_w{tail});")
            body += [f"show(&{name}_w[0][0], {channels * count});", f"show(&{name}_g[0][0][0], {axes * channels * count});"]
        body += [
            f"{prefix}_dominant({name}_w, {name}_d); show({name}_d, 3);",
            f"{prefix}_ground({name}_a, {name}_w); show(&{name}_w[0][0], {channels * count});",
            f"{prefix}_window({prefix.upper()}_BANDS, {name}_w); show(&{name}_w[0][0], {channels * count});\n}}",
        ]
        sizes[name] = len(SHARES) * channels * count * (1 + axes) + 3 + 2 * channels * count
    includes = "\n".join(f'#include "{name}.h"' for name in MADE)
    show = 'static void show(const float *v, int n) { int i; for (i = 0; i < n; ++i) printf("%.9g\\n", (double)v[i]); }'
    calls = " ".join(f"{name}_run();" for name in MADE)
    text = f"#include <stdio.h>\n{includes}\n{show}\n" + "\n".join(body) + f"\nint main(void) {{ {calls} return 0; }}\n"
    (folder / "all.c").write_text(text, encoding="utf-8")
    subprocess.run(
        ["cc", "-std=c99", "-O1", "-ffp-contract=off", str(folder / "all.c"), "-o", str(folder / "all"), "-lm"], check=True
    )
    out = subprocess.run([str(folder / "all")], capture_output=True, text=True, check=True).stdout
    found, numbers = {}, np.array(out.split(), dtype=float)
    for name, size in sizes.items():
        found[name], numbers = numbers[:size], numbers[size:]
    return found


@pytest.mark.parametrize("name", MADE)
def test_c_values_gradient_ground_and_window(printed: dict[str, Array], name: str) -> None:
    made, numbers = MADE[name], printed[name]
    table = made.table
    axes, channels, bands = len(table.axes), len(table.channels), table.bands
    shape = (channels, bands**2)
    tolerance = 2e-5 if table.dtype == np.float32 else 1e-6
    for values, azimuth in inputs(made):
        got, numbers = numbers[: math.prod(shape)].reshape(shape), numbers[math.prod(shape) :]
        expected = made.weights(values, azimuth)
        assert np.abs(got - expected).max() < tolerance * np.abs(expected).max()
        slopes, numbers = numbers[: axes * math.prod(shape)].reshape(axes, *shape), numbers[axes * math.prod(shape) :]
        if table.spec.basis == "chebyshev":
            exact = made.gradient(values, azimuth)
            for one, other in zip(slopes, exact, strict=True):
                assert np.abs(one - other).max() < 10 * tolerance * np.abs(other).max()
        first, *rest = values
        told = runtime.Runtime(table).weights(first, azimuth, *rest)
        assert np.abs(told - expected).max() < tolerance * np.abs(expected).max()
    # The dominant direction of the last weights: x, y, z of the linear part by luminance.
    share = np.array(FACTS.luminance)[:channels]
    linear = share @ got[:, [3, 1, 2]]
    assert numbers[:3] == pytest.approx(linear / np.linalg.norm(linear), abs=1e-6)
    ground, window = numbers[3:].reshape(2, *shape)
    below, solid = hemisphere(30, lower=True)
    albedo = np.array([0.1, 0.5, 0.9])[:channels]
    fallen = math.sqrt(4 * math.pi / 3) * got[:, 2]
    lit = got + np.multiply.outer(albedo * fallen / math.pi, solid @ basis(below, bands))
    assert np.abs(ground - lit).max() < 1e-6 * np.abs(lit).max()
    eq5 = np.where(orders(bands) == 0, sinc(math.pi * degrees(bands) / bands), 1.0)
    assert np.abs(window - ground * eq5).max() < 1e-6 * np.abs(lit).max()


def test_twilight_and_the_folded_window_in_c(tmp_path: Path) -> None:
    """A sun 0 to 12 degrees below the horizon, and fewer bands of a table with eq. 5's window in its weights."""
    axis = Axis("sun_zenith", 0.0, math.pi / 2, "rad")
    dense = np.random.default_rng(71).normal(size=(1, 10, 4))
    spec = specification((axis,), ("luminance",), True, "chebyshev", None)
    lengths, dark = np.full(len(dense), 4), math.pi / 2
    sunk = fast(replace(spec, peak_axis="sun_zenith", twilight=TWILIGHT), dense, lengths, 4, "float64")
    folded = fast(replace(spec, windowed=True), dense, lengths, 4, "float64")
    (tmp_path / "sunk.h").write_text(c_header.write(sunk, FACTS, "sunk"), encoding="utf-8")
    (tmp_path / "folded.h").write_text(c_header.write(folded, FACTS, "folded"), encoding="utf-8")
    shares = [0.0, 0.2, 0.6, 1.0]
    calls = [f"sunk_weights({dark + x * math.radians(12):.9g}f, 0.0f, w); show();" for x in shares]
    calls.append("folded_weights_bands(0.5f, 0.0f, 3, w); show();")
    text = f"""#include <stdio.h>\n#include "sunk.h"\n#include "folded.h"\nstatic float w[1][16];
        static void show(void) {{ int i; for (i = 0; i < 16; ++i) printf("%.9g\\n", (double)w[0][i]); }}
        int main(void) {{ {" ".join(calls)} return 0; }}"""
    (tmp_path / "t.c").write_text(text, encoding="utf-8")
    subprocess.run(["cc", "-std=c99", str(tmp_path / "t.c"), "-o", str(tmp_path / "t"), "-lm"], check=True)
    out = subprocess.run([str(tmp_path / "t")], capture_output=True, text=True, check=True).stdout
    *night, cut = np.array(out.split(), dtype=float).reshape(-1, 16)
    made = Made(sunk, dense, lambda _: 1.0 + 0j)
    at_sunset = made.weights([dark], 0.0)[0]
    for x, got in zip(shares, night, strict=True):
        assert got == pytest.approx(at_sunset * (1 - x) ** 10 * (1 + 10 * x), abs=2e-6 * np.abs(at_sunset).max())
        told = runtime.Runtime(sunk).weights(dark + x * math.radians(12), 0.0)[0]
        assert told == pytest.approx(at_sunset * (1 - x) ** 10 * (1 + 10 * x), abs=1e-12 * np.abs(at_sunset).max())
    l, m = degrees(4), orders(4)
    # The weights hold sinc(pi l / 4); those of three bands shall hold sinc(pi l / 3).
    changed = np.where(m == 0, sinc(math.pi * l / 3) / sinc(math.pi * l / 4), 1.0)
    expected = np.where(l < 3, made.weights([0.5], 0.0)[0] * changed, 0.0)
    assert cut == pytest.approx(expected, abs=1e-6 * np.abs(expected).max())
    told = runtime.Runtime(folded).weights(0.5, 0.0, bands=3)[0]
    assert told == pytest.approx(expected[:9], abs=1e-12 * np.abs(expected).max())


def test_the_paper_written_out_is_the_paper(tmp_path: Path) -> None:
    """Eqs. 1 and 4 in double precision: sums of theta^i tau^j, and orders m and -m turned into each other."""
    rng = np.random.default_rng(72)
    numbers = rng.normal(size=(3, 9, 4, 3))
    (tmp_path / "p.h").write_text(paper_literal.write(numbers, ("theta", "tau"), ("r", "g", "b"), "p"), encoding="utf-8")
    text = """#include <stdio.h>\n#include "p.h"
        int main(void) { static float w[3][9]; int i; p_weights(0.75f, 1.25f, 2.5f, w);
        for (i = 0; i < 27; ++i) printf("%.9g\\n", (double)w[i / 9][i % 9]); return 0; }"""
    (tmp_path / "p.c").write_text(text, encoding="utf-8")
    subprocess.run(["cc", "-std=c99", str(tmp_path / "p.c"), "-o", str(tmp_path / "p"), "-lm"], check=True)
    out = subprocess.run([str(tmp_path / "p")], capture_output=True, text=True, check=True).stdout
    flat = np.einsum("cwij,i,j->cw", numbers, 0.75 ** np.arange(4), 2.5 ** np.arange(3))
    l, m = degrees(3), orders(3)
    expected = flat * np.cos(m * 1.25) - flat[:, l * (l + 1) - m] * np.sin(m * 1.25)
    assert np.array(out.split(), dtype=float).reshape(3, 9) == pytest.approx(expected, rel=1e-6, abs=1e-6)


# GLSL and HLSL, whose few types a page of C++ has: what runs on a GPU, run on a CPU.
PRELUDE = """
#include <cmath>
#include <cstdio>
#define out
struct vec2 { float x, y; vec2() : x(0), y(0) {} vec2(float a, float b) : x(a), y(b) {} };
struct vec3 { float x, y, z; vec3() : x(0), y(0), z(0) {} vec3(float a, float b, float c) : x(a), y(b), z(c) {} };
struct vec4 { float x, y, z, w; vec4() : x(0), y(0), z(0), w(0) {}
  vec4(float a, float b, float c, float d) : x(a), y(b), z(c), w(d) {} };
static inline vec2 operator-(vec2 a) { return vec2(-a.x, -a.y); }
static inline vec2 operator*(vec2 a, float s) { return vec2(a.x * s, a.y * s); }
static inline vec3 operator+(vec3 a, vec3 b) { return vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
static inline vec3 operator-(vec3 a, vec3 b) { return vec3(a.x - b.x, a.y - b.y, a.z - b.z); }
static inline vec3 operator*(float s, vec3 a) { return vec3(s * a.x, s * a.y, s * a.z); }
static inline vec3 operator*(vec3 a, float s) { return s * a; }
static inline vec3 &operator+=(vec3 &a, vec3 b) { a = a + b; return a; }
static inline vec4 operator*(float s, vec4 a) { return vec4(s * a.x, s * a.y, s * a.z, s * a.w); }
static inline vec4 &operator+=(vec4 &a, vec4 b) { a = vec4(a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w); return a; }
static inline float clamp(float v, float low, float high) { return v < low ? low : v > high ? high : v; }
static inline float max(float a, float b) { return a > b ? a : b; }
static inline float min(float a, float b) { return a < b ? a : b; }
typedef vec2 float2; typedef vec3 float3; typedef vec4 float4;
using std::abs; using std::exp; using std::floor; using std::log; using std::pow; using std::sin; using std::cos;
"""
SHADED = {
    "preetham": replace(MADE["preetham"], table=MADE["single"].table),
    "pole": make(
        TWO,
        (4, 3),
        5,
        reciprocal(DENOMINATOR.astype(np.float32), specified(TWO)),
        over_polynomial(TWO, DENOMINATOR),
        dtype="float32",
    ),
    "many": make((SUN, replace(WEATHER, map="identity")), (3, 2), 9, None, dtype="float32", mirrored=False),
    "legendre": make((SUN, WEATHER), (4, 3), 3, None, dtype="float32", basis_name="legendre", mirrored=False),
    "classes": make(
        (SUN, WEATHER), (5, 3), 5, closed_form(MATRIX, specified((SUN, WEATHER))), matrix, dtype="float32", parity=True
    ),
}
LOOKS = upper(8, seed=51) * [1, 1, -1] ** np.arange(8)[:, np.newaxis]


WAVES = np.linspace(-20.0, 20.0, 161)


@pytest.fixture(scope="module")
def shaded(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Array]:
    """What the shaders' functions return, by table and language; ``wave`` the cosines and sines that they turn by."""
    folder, parts, body, sizes = tmp_path_factory.mktemp("shaders"), [], [], {}
    for (name, made), language in itertools.product(SHADED.items(), ("glsl", "hlsl")):
        prefix, kept = f"{name}{language}", f"{name}_{language}_w"
        text = shaders.write(made.table, FACTS, language, prefix)
        # GLSL builds arrays by their type's name, C++ and HLSL by braces.
        parts.append(re.sub(r"= \w+\[\d+\]\((.*?)\n\);", r"= {\1\n};", text, flags=re.DOTALL))
        count = made.table.bands**2
        body.append(f"static vec3 {kept}[{count}];")
        for values, azimuth in inputs(made):
            first, *rest = (f"{v!r}f" for v in values)
            given = ", ".join([first, f"{azimuth!r}f", *rest])
            body += [f"{prefix}_weights({given}, {kept});", f"for (int i = 0; i < {count}; ++i) show({kept}[i]);"]
        for look, call in itertools.product(LOOKS.tolist(), ("radiance", "irradiance")):
            place = ", ".join(f"{v!r}f" for v in look)
            body.append(f"show({prefix}_{call}({kept}, vec3({place})));")
        sizes[f"{name}.{language}"] = 3 * (len(SHARES) * count + 2 * len(LOOKS))
    waves = "{ vec2 v = preethamglsl_wave(a), w = preethamhlsl_wave(a); show(vec3(v.x, v.y, 0)); show(vec3(w.x, w.y, 0)); }"
    body.append(f"for (int i = 0; i < {WAVES.size}; ++i) {{ float a = -20.0f + 0.25f * (float)i; {waves} }}")
    show = 'static void show(vec3 v) { std::printf("%.9g %.9g %.9g\\n", v.x, v.y, v.z); }'
    text = "\n".join([PRELUDE, *parts, show, "int main() {", *body, "return 0; }"])
    (folder / "all.cc").write_text(text, encoding="utf-8")
    command = ["g++", "-std=c++11", "-O0", "-ffp-contract=off", str(folder / "all.cc"), "-o", str(folder / "all")]
    subprocess.run(command, check=True)
    done = subprocess.run([str(folder / "all")], capture_output=True, text=True, check=True).stdout
    found, numbers = {}, np.array(done.split(), dtype=float)
    for name, size in sizes.items():
        found[name], numbers = numbers[:size].reshape(-1, 3), numbers[size:]
    found["wave"] = numbers.reshape(WAVES.size, 2, 3)
    return found


@pytest.mark.parametrize("language", ["glsl", "hlsl"])
@pytest.mark.parametrize("name", SHADED)
def test_shaders_weights_radiance_and_irradiance(shaded: dict[str, Array], name: str, language: str) -> None:
    made, rows = SHADED[name], shaded[f"{name}.{language}"]
    bands = made.table.bands
    for values, azimuth in inputs(made):
        got, rows = rows[: bands**2].T, rows[bands**2 :]
        expected = made.weights(values, azimuth)
        assert np.abs(got - expected).max() < 3e-5 * np.abs(expected).max()
    seen = rows.reshape(len(LOOKS), 2, 3)
    table = basis(LOOKS, bands)
    scale = np.abs(got).sum(axis=1).max()
    assert np.abs(seen[:, 0] - table @ got.T).max() < 2e-6 * scale
    assert np.abs(seen[:, 1] - (table * lobe(bands)[degrees(bands)]) @ got.T).max() < 4e-6 * scale


def test_shaders_turn_by_cosine_and_sine(shaded: dict[str, Array]) -> None:
    exact = np.stack([np.cos(WAVES), np.sin(WAVES)], axis=-1)
    for language in range(2):
        assert np.abs(shaded["wave"][:, language, :2] - exact).max() < 4e-7
