"""The Preetham sky of both constant sets, against the 1999 paper's formulas and tables written out anew."""

from __future__ import annotations

import math
import re
import subprocess
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from skylight_sh.fit.axis import Axis
from skylight_sh.formula.printers import C_DOUBLE, statements
from skylight_sh.light.preetham import Preetham, zenith_factor, zenith_luminance
from skylight_sh.table.prefactor import closed_form

from golden.oracles import (
    PREETHAM,
    REC709,
    WHITE,
    perez_function,
    preetham_shape,
    preetham_xyz,
    preetham_zenith,
    upper,
    xyz_to_rgb,
)

SETS = [(0.0, 2.5), (0.35, 3.1), (0.9, 5.2), (1.31, 2.0), (1.57, 9.5)]


@pytest.mark.parametrize("constants", ["published", "smits"])
@pytest.mark.parametrize(("theta", "tau"), SETS)
def test_every_constant_of_the_sky(constants: Any, theta: float, tau: float) -> None:
    where = upper(60)
    expected = preetham_xyz(constants, where, theta, tau) @ np.round(xyz_to_rgb(REC709, WHITE), 7).T
    light = Preetham(constants=constants)
    got = light.radiance(where, {"sun_zenith": np.array(theta), "turbidity": np.array(tau)})
    assert np.abs(got - expected).max() < 1e-10 * np.abs(expected).max()


@pytest.mark.parametrize(("theta", "tau"), SETS)
def test_zenith_luminance(theta: float, tau: float) -> None:
    got = float(zenith_luminance(np.array(theta), np.array(tau)))
    assert got == pytest.approx(preetham_zenith("published", "Y", theta, tau), rel=1e-13)


def test_published_figures_of_the_paper() -> None:
    """Sun at the zenith: chi = 8 pi / 9 of a quarter turn .. by hand, tau = 2: 3.1196 tan(77 degrees) + 1.9882 kcd/m2."""
    by_hand = 3.1196 * math.tan((4 / 9 - 2 / 120) * math.pi) + 1.9882
    assert float(zenith_luminance(np.array(0.0), np.array(2.0))) == pytest.approx(1000 * by_hand, rel=1e-12)
    # The pole named in the design: 1 + A exp B passes 0 at a turbidity of 1.643.
    rows = [np.array(row.split()[1:], dtype=float) for row in PREETHAM["published"]["Y"]]
    (a1, a0), (b1, b0) = rows[:2]
    pole = mpmath.findroot(lambda t: 1 + (a1 * t + a0) * mpmath.exp(b1 * t + b0), 1.6)
    assert float(pole) == pytest.approx(1.643, abs=5e-4)
    low, high = (getattr(Preetham().domains["turbidity"], end) for end in ("low", "high"))
    assert (low, high) == (1.7, 10.0)
    assert low > float(pole)
    assert (Preetham().domains["sun_zenith"].low, Preetham().domains["sun_zenith"].high) == (0.0, math.pi / 2)


def rational_factor(constants: str, theta: float, tau: float) -> float:
    """The prefactor's definition: tan by its continued fraction to four terms, exp and cos by Taylor's polynomials."""
    a, b, c, d, e = preetham_shape(constants, "Y", tau)
    with mpmath.workdps(30):
        chi = (mpmath.mpf(4) / 9 - mpmath.mpf(tau) / 120) * (mpmath.pi - 2 * mpmath.mpf(theta))
        tangent = chi / (1 - chi**2 / (3 - chi**2 / (5 - chi**2 / 7)))  # Lambert
        exp = mpmath.taylor(mpmath.exp, 0, 2)
        cosine = mpmath.polyval(mpmath.taylor(mpmath.cos, 0, 6), theta, asc=True)
        up = mpmath.polyval(exp, b / mpmath.mpf(4), asc=True) ** 4
        halo = mpmath.polyval(exp, d * theta / mpmath.mpf(8), asc=True) ** 8
        zenith = (4.0453 * tau - 4.9710) * tangent - 0.2155 * tau + 2.4192
        return float(1000 * zenith / ((1 + a * up) * (1 + c * halo + e * cosine**2)))


@pytest.mark.parametrize("constants", ["published", "smits"])
def test_the_prefactor_is_its_series(constants: Any, tmp_path: Path) -> None:
    prefactor = Preetham(constants=constants).hints.prefactor
    assert prefactor is not None
    sets = [(theta, tau) for theta in (0.0, 0.4, 1.1, math.pi / 2) for tau in (2.5, 3.3, 6.0)]
    expected = [rational_factor(constants, *values) for values in sets]
    theta, tau = np.array(sets).T
    assert prefactor.axes == ("sun_zenith", "turbidity")
    assert zenith_factor(theta, tau, prefactor.constants) == pytest.approx(expected, rel=1e-12)
    exact = [
        preetham_zenith(constants, "Y", *values)
        / float(perez_function(preetham_shape(constants, "Y", values[1]), 0.0, values[0]))
        for values in sets
    ]
    # "But for a few per cent": its purpose, not its definition.
    assert expected == pytest.approx(exact, rel=0.08)
    # The same in C, in double so that a wrong digit shows.
    numbers = [float(v) for row in PREETHAM[constants]["Y"] for v in row.split()[1:]]
    assert list(prefactor.constants) == numbers
    program = closed_form(prefactor, [Axis(name, 0.0, 9.0).specified for name in prefactor.axes]).program
    lines, results = statements(program, C_DOUBLE, prefactor.axes)
    body = "\n".join([*lines, f"return {results[0]};"])
    calls = "".join(f'printf("%.17g\\n", factor({t!r}, {u!r}));' for t, u in sets)
    (tmp_path / "f.c").write_text(
        f"#include <math.h>\n#include <stdio.h>\n"
        f"static double factor(double sun_zenith, double turbidity) {{ {body} }}\nint main(void) {{ {calls} return 0; }}\n",
        encoding="utf-8",
    )
    subprocess.run(["cc", str(tmp_path / "f.c"), "-o", str(tmp_path / "f"), "-lm"], check=True)
    out = subprocess.run([str(tmp_path / "f")], capture_output=True, text=True, check=True).stdout
    assert [float(line) for line in out.split()] == pytest.approx(expected, rel=1e-12)
    # Numbers written into the formula, which a table's bytes count: 4/9, 1/120, pi, 105, ...
    written = re.findall(r"(?<![\w.\[])\d+\.\d+(?:e-?\d+)?", body)
    assert {float(number) for number in written} == {*program.literals, *map(abs, numbers)}
