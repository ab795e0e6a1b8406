"""Parts of headers against formulas: maps, bases, dominant light, ground, window, twilight, and the paper's scheme."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from c_programs import FACTS, floats, run
from numpy.typing import NDArray
from skylight_sh import sphere
from skylight_sh.export import c_header, paper_literal
from skylight_sh.fit.axis import Axis
from skylight_sh.formula.variables import VARIABLES
from skylight_sh.runtime import Table
from skylight_sh.table import twilight
from skylight_sh.table.table import fast, specification

Array = NDArray[np.float64]

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
    points = {"identity": 0.0, "log": 0.7, "even": 20.25, "reciprocal": 5.5, "cbrt": 4.25, "raw": 0.0}
    assert set(points) == set(VARIABLES)
    for name, point in points.items():
        axis = Axis("haze", 1.25, 4.0, map=name, point=point)
        table = fast(
            specification((axis,), ("one",), True, "monomial", None), np.array([[[0.5, 2.0]]]), np.array([2]), 1, "float64"
        )
        values = np.array([1.25, 1.5, 2.0, 3.0, 4.0])
        got = one_weight(table, values, tmp_path)
        scaled = {
            "identity": (values - 1.25) / 2.75 * 2 - 1,
            "log": np.log((values - 0.7) / 0.55) / np.log(3.3 / 0.55) * 2 - 1,
            "reciprocal": (1 / (5.5 - values) - 1 / 4.25) / (1 / 1.5 - 1 / 4.25) * 2 - 1,
            "cbrt": (np.cbrt(3.0) - np.cbrt(4.25 - values)) / (np.cbrt(3.0) - np.cbrt(0.25)) * 2 - 1,
            "even": (1 / (20.25 - values**2) - 1 / 18.6875) / (1 / 4.25 - 1 / 18.6875) * 2 - 1,
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
        frame = specification((Axis("haze", -1.0, 1.0),), ("one",), True, name, None)
        table = fast(frame, numbers[np.newaxis, np.newaxis], np.array([9]), 1, "float64")
        got = one_weight(table, u, tmp_path)
        assert got == pytest.approx(values @ numbers, abs=1e-6), name


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
    frame = specification((Axis("sun_zenith", 0.0, 1.0),), ("r", "g", "b"), True, "chebyshev", None)
    table = fast(frame, np.ones((3, 6, 2)), np.full(3, 2), 3, "float32")
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
    l, m = sphere.Harmonics(3).degrees, sphere.Harmonics(3).orders
    factors = np.where((l < bands) & (m == 0), np.sinc(l / bands), 1.0)
    assert found == pytest.approx((weights * factors).ravel(), abs=1e-6)


@pytest.mark.parametrize("dtype", ["float32", "float64"])
def test_twilight_fades_as_its_formula_says(tmp_path: Path, dtype: str) -> None:
    sinking = {"peak_axis": "sun_zenith", "twilight": twilight.TWILIGHT}
    axes = (Axis("sun_zenith", 0.0, float(np.pi / 2)),)
    table = fast(specification(axes, ("one",), True, "chebyshev", **sinking), np.array([[[3.0]]]), np.array([1]), 1, dtype)
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


ANGLES = """
#include <stdio.h>
#include "skylight_sh.h"
static const float in[{count}] = {{{values}}};
int main(void)
{{
    int s;
    for (s = 0; s < {count}; ++s) {{
        float w[1][4];
        skylight_sh_weights(1.0f, in[s], w);
        printf("%.9g %.9g\\n", (double)w[0][3], (double)w[0][1]);
    }}
    return 0;
}}
"""


def test_azimuths_of_any_size_have_their_cosine_and_sine(tmp_path: Path) -> None:
    """At all quarters and between, a float before and after each, of one turn and of thousands, beyond 1e5 the library's."""
    quarters = np.arange(-40, 41) * (np.pi / 8)
    near = np.concatenate([np.nextafter(quarters.astype(np.float32), np.float32(end)) for end in (-9e9, 9e9)])
    far = np.array([0.0, -0.0, 1e-30, 99999.0, 1e5, -123456.0, 3e7, 54321.0, -2e4])
    values = np.concatenate([quarters, near, far, np.linspace(-1e4, 1e4, 999)]).astype(np.float32)
    spec = specification((Axis("sun_zenith", 0.0, 1.5),), ("one",), True, "monomial", None)
    # The weight l = 1, m = 1 alone, and it is 1.
    dense = np.array([0.0, 0.0, 1.0]).reshape(1, 3, 1)
    table = fast(spec, dense, np.array([1]), 2, "float32")
    (tmp_path / "skylight_sh.h").write_text(c_header.write(table, FACTS), encoding="utf-8")
    text = run(tmp_path, ANGLES.format(count=values.size, values=floats(values))).stdout
    got = np.array(text.split(), dtype=np.float64).reshape(-1, 2)
    angle = values.astype(np.float64)
    assert np.abs(got[:, 0] - np.cos(angle)).max() < 1.5e-7
    assert np.abs(got[:, 1] - np.sin(angle)).max() < 1.5e-7
