"""Changes of variable and bases: closed forms, ends, slopes, and the C text of each against the same formulas."""

from __future__ import annotations

import math
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from scipy import special
from skylight_sh.fit.axis import Axis
from skylight_sh.formula.bases import BASES
from skylight_sh.formula.printers import C_DOUBLE, assignments, statements

Number = mpmath.mpf


def by_ends(f: Callable[[Number], Number], low: float, high: float) -> Callable[[float], Number]:
    """The map that is linear in ``f`` and takes low to -1 and high to 1."""
    return lambda v: 2 * (f(Number(v)) - f(Number(low))) / (f(Number(high)) - f(Number(low))) - 1


def root(x: Number) -> Number:
    return mpmath.cbrt(x) if x >= 0 else -mpmath.cbrt(-x)


# name, low, high, point; the README's definitions: scaled, log of the distance to the point, its reciprocal, its cube root,
# the reciprocal of the square's distance.
CASES = [
    ("identity", 0.0, math.pi / 2, 0.0, lambda _: lambda v: v),
    ("identity", 2.5, 6.0, 0.0, lambda _: lambda v: v),
    ("log", 2.5, 6.0, 0.5, lambda p: lambda v: mpmath.log(v - p)),
    ("log", -1.0, 2.0, -2.5, lambda p: lambda v: mpmath.log(v - p)),
    ("log", 1.0, 2.0, 2.7, lambda p: lambda v: mpmath.log(p - v)),
    ("reciprocal", 0.0, math.pi / 2, 5.0, lambda p: lambda v: 1 / (p - v)),
    ("reciprocal", 2.5, 6.0, -2.0, lambda p: lambda v: 1 / (p - v)),
    ("cbrt", 0.0, math.pi / 2, math.pi / 2, lambda p: lambda v: root(p - v)),
    ("cbrt", 0.2, 1.1, 1.7, lambda p: lambda v: root(p - v)),
    ("even", 0.0, math.pi / 2, -14.0, lambda p: lambda v: 1 / (p - v * v)),
    ("even", 0.3, 1.2, 2.1, lambda p: lambda v: 1 / (p - v * v)),
]
SHARES = (0.0, 0.07, 0.31, 0.5, 0.86, 1.0)


@pytest.mark.parametrize("case", CASES, ids=lambda c: f"{c[0]}-{c[1]:.2g}-{c[3]:.2g}")
def test_maps_are_their_closed_forms(case: tuple[Any, ...]) -> None:
    name, low, high, point, make = case
    axis, expected = Axis("x", low, high, map=name, point=point), by_ends(make(Number(point)), low, high)
    values = [low + s * (high - low) for s in SHARES]
    assert axis.scaled(np.array(values)) == pytest.approx([float(expected(v)) for v in values], abs=1e-13)
    assert float(axis.scaled(np.array([low]))[0]) == pytest.approx(-1.0, abs=1e-14)
    assert float(axis.scaled(np.array([high]))[0]) == pytest.approx(1.0, abs=1e-14)
    u = np.array([-1.0, -0.4, 0.3, 1.0])
    assert [float(expected(v)) for v in axis.unscaled(u)] == pytest.approx(u.tolist(), abs=1e-12)
    # The slope, against mpmath's, by a complex step of the map itself where it takes one.
    middle = low + 0.4 * (high - low)
    slope = float(mpmath.diff(expected, middle))
    step = 1e-6 * (high - low)
    found = float(np.diff(axis.scaled(np.array([middle - step, middle + step])))[0]) / (2 * step)
    assert found == pytest.approx(slope, rel=1e-7)


def test_raw_leaves_a_value_alone() -> None:
    axis = Axis("x", 2.5, 6.0, map="raw")
    assert axis.scaled(np.array([2.5, 4.0])).tolist() == [2.5, 4.0]
    assert axis.constants == ()


def compiled(program: str, place: Path) -> list[float]:
    place.with_suffix(".c").write_text(f"#include <math.h>\n#include <stdio.h>\n{program}", encoding="utf-8")
    subprocess.run(["cc", "-std=c99", "-O1", str(place.with_suffix(".c")), "-o", str(place), "-lm"], check=True)
    return [float(v) for v in subprocess.run([str(place)], capture_output=True, text=True, check=True).stdout.split()]


def test_the_c_text_of_every_map(tmp_path: Path) -> None:
    functions, calls, expected = [], [], []
    for n, (name, low, high, point, make) in enumerate(CASES):
        axis, exact = Axis("x", low, high, map=name, point=point), by_ends(make(Number(point)), low, high)
        lines, results = statements(axis.specified.variable, C_DOUBLE, ["v"])
        functions.append(f"static double map{n}(double v) {{ {' '.join(lines)} return {results[0]}; }}")
        for share in SHARES:
            value = low + share * (high - low)
            calls.append(f'printf("%.17g\\n", map{n}({value!r}));')
            expected.append(float(exact(value)))
    found = compiled("\n".join([*functions, "int main(void) {", *calls, "return 0; }"]), tmp_path / "maps")
    assert found == pytest.approx(expected, abs=1e-12)


def exact_basis(name: str, u: float, degree: int) -> list[float]:
    if name == "chebyshev":
        return [math.cos(k * math.acos(u)) for k in range(degree + 1)]
    if name == "legendre":
        return [float(special.eval_legendre(k, u)) for k in range(degree + 1)]
    if name == "monomial":
        return [u**k for k in range(degree + 1)]
    # What the paper tried first: 1, cos pi u, sin pi u, cos 2 pi u ..
    return [
        1.0,
        *(f((k + 1) // 2 * math.pi * u) for k, f in zip(range(1, degree + 1), [math.cos, math.sin] * 9, strict=False)),
    ]


@pytest.mark.parametrize("name", ["chebyshev", "legendre", "monomial", "fourier"])
def test_bases_and_their_c_text(name: str, tmp_path: Path) -> None:
    degree, calls, expected = 11, [], []
    for u in (-1.0, -0.63, 0.0, 0.4, 1.0):
        exact = exact_basis(name, u, degree)
        assert BASES[name].vander(np.array([u]), degree)[0] == pytest.approx(exact, abs=1e-12)
        calls.append(f'fill({u!r}, t); for (k = 0; k <= {degree}; ++k) printf("%.17g\\n", t[k]);')
        expected += exact
    for shallow in (False, True):
        program = BASES[name].program(degree, shallow=shallow)
        fill = "\n".join(assignments(program, C_DOUBLE, ["u"], [f"t[{k}]" for k in range(degree + 1)]))
        found = compiled(
            f"static void fill(double u, double *t) {{\n{fill}\n}}\n"
            f"int main(void) {{ double t[{degree + 1}]; int k; {' '.join(calls)} return 0; }}",
            tmp_path / f"{name}{shallow:d}",
        )
        assert found == pytest.approx(expected, abs=1e-12)
    assert BASES[name].nested == (name == "chebyshev")


def test_nodes_are_chebyshevs() -> None:
    """Roots of T_n in the map's own variable (Trefethen 2013, ch. 2); verification nodes are its extremes."""
    for name, low, high, point in (("identity", 1.0, 4.0, 0.0), ("log", 2.5, 6.0, 0.5)):
        axis = Axis("x", low, high, map=name, point=point)
        u = axis.scaled(axis.fit_nodes(9, "chebyshev"))
        assert u == pytest.approx(np.polynomial.chebyshev.chebroots([0] * 9 + [1]), abs=1e-12)
    raw = Axis("x", 1.0, 4.0, map="raw").fit_nodes(5, "chebyshev")
    assert raw == pytest.approx(2.5 + 1.5 * np.polynomial.chebyshev.chebroots([0] * 5 + [1]), abs=1e-12)
    assert Axis("x", 1.0, 4.0).fit_nodes(4, "uniform").tolist() == [1.0, 2.0, 3.0, 4.0]
    points = Axis("x", 1.0, 4.0).verification_nodes(7, np.array([0.0]))
    assert points == pytest.approx(2.5 + 1.5 * np.polynomial.chebyshev.chebpts2(7), abs=1e-12)
