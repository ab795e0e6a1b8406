"""Formulas as programs: traced, differentiated, printed and compiled, checked, carried by files, read back by one module."""

from __future__ import annotations

import hashlib
import io
import json
import math
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Callable
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from conftest import with_spec
from golden.test_generated_code import PEREZ, PREETHAM, perez_factor, preetham_factor
from golden.test_maps_and_bases import CASES, by_ends
from numpy.typing import NDArray
from skylight_sh import runtime
from skylight_sh.fit.axis import Axis
from skylight_sh.formula import elementary
from skylight_sh.formula.bases import BASES
from skylight_sh.formula.elementary import exp, label, log, sqrt
from skylight_sh.formula.expression import derivatives, expressions, trace
from skylight_sh.formula.printers import C_DOUBLE, C_SINGLE, Language, assignments, double, single, statements
from skylight_sh.formula.variables import VARIABLES
from skylight_sh.light.protocol import Prefactor
from skylight_sh.runtime import FUNCTIONS, Program, Specification, Surroundings, Table
from skylight_sh.studies.stability.flavours import flavours
from skylight_sh.table import npz
from skylight_sh.table.prefactor import closed_form
from skylight_sh.table.table import fast, specification
from skylight_sh.table.twilight import TWILIGHT

Array = NDArray[np.float64]
FLAVOURS = flavours()


def test_a_trace_keeps_the_order_of_the_function() -> None:
    """Nothing is rearranged; literal zeros and ones alone are carried out."""
    found = trace(lambda x, y, k: [x * y - k[0] * x, 1.0 * x + 0.0, -(y / 2)], ["x", "y"], [3.0])
    assert found.inputs == ("x", "y")
    assert found.constants == (3.0,)
    assert found.steps == (
        ("input", 0),
        ("input", 1),
        ("*", 0, 1),
        ("constant", 0),
        ("*", 3, 0),
        ("-", 2, 4),
        ("number", 2.0),
        ("/", 1, 6),
        ("negative", 7),
    )
    assert found.outputs == (5, 0, 8)
    assert found.literals == (2.0,)
    assert [float(v) for v in found.run([5.0, 7.0])] == [20.0, 5.0, -3.5]
    # What is used twice is computed once.
    shared = trace(lambda x: [s * s for s in [x + 1]], ["x"])
    assert [step[0] for step in shared.steps] == ["input", "number", "+", "*"]


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_a_program_runs_in_the_type_of_its_inputs(dtype: type[np.floating]) -> None:
    found = trace(lambda x, k: [log(x) * k[0] + 0.1, 2.0], ["x"], [1 / 3])
    x = np.array([0.3, 1.7], dtype=dtype)
    one, two = found.run([x])
    assert one.dtype == two.dtype == dtype
    assert np.array_equal(one, np.log(x.astype(np.float64)).astype(dtype) * dtype(1 / 3) + dtype(0.1))


@pytest.mark.parametrize(
    "formula",
    [
        lambda x: [x**2],
        lambda x: [np.exp(x)],
        lambda x: [math.sin(x)],
        lambda x: [x if x > 0 else -x],
        lambda x: [float(x)],
        lambda x: [x @ x],
    ],
)
def test_what_is_no_formula_of_numbers_is_refused(formula: Callable[[Any], Any]) -> None:
    with pytest.raises(TypeError):
        trace(formula, ["x"])


def test_programs_go_into_one_another() -> None:
    inner = trace(lambda x, k: [x * k[0]], ["x"], [3.0])
    outer = trace(lambda a: [expressions(inner, [a + 1.0])[0] + a], ["a"])
    assert outer.constants == ()
    assert float(outer.run([2.0])[0]) == 11.0


def slopes(program: Program, by: int, *values: float) -> list[float]:
    return [float(v) for v in derivatives(program, by).run([np.float64(v) for v in values])]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_elementary_functions_have_their_slopes(name: str) -> None:
    """Of f(2 x + x^2): the chain rule against mpmath's derivative."""
    program = trace(lambda x: [getattr(elementary, name)(2.0 * x + x * x)], ["x"])
    exact = getattr(mpmath, name)
    for x in (0.125, 0.7, 1.9):
        assert float(program.run([x])[0]) == pytest.approx(float(exact(2 * x + x * x)), rel=1e-14)
        expected = float(mpmath.diff(lambda v: exact(2 * v + v * v), x))
        assert slopes(program, 0, x) == [pytest.approx(expected, rel=1e-12)]


def test_quotients_products_and_signs_have_their_slopes() -> None:
    program = trace(lambda x, y: [x / (y - x), -(x * y) * x, 4.0 - y, 3.0, x / 2.0 + 1.0 / x], ["x", "y"])
    x, y = 0.75, 2.5
    assert slopes(program, 0, x, y) == pytest.approx([y / (y - x) ** 2, -2 * x * y, 0.0, 0.0, 0.5 - 1 / x**2], rel=1e-14)
    assert slopes(program, 1, x, y) == pytest.approx([-x / (y - x) ** 2, -x * x, -1.0, 0.0, 0.0], rel=1e-14)


@pytest.mark.parametrize("case", CASES, ids=lambda c: f"{c[0]}-{c[1]:.2g}-{c[3]:.2g}")
def test_variables_have_their_slopes(case: tuple[Any, ...]) -> None:
    name, low, high, point, make = case
    program = Axis("x", low, high, map=name, point=point).specified.variable
    program.check(name, 1, 1)
    expected = by_ends(make(mpmath.mpf(point)), low, high)
    for share in (0.0, 0.07, 0.5, 0.93):
        value = low + share * (high - low)
        assert float(program.run([value])[0]) == pytest.approx(float(expected(value)), abs=1e-13)
        assert slopes(program, 0, value) == [pytest.approx(float(mpmath.diff(expected, value)), rel=1e-10)]


def test_every_variable_was_looked_at() -> None:
    assert {case[0] for case in CASES} | {"raw"} == set(VARIABLES)
    raw = Axis("x", 2.5, 6.0, map="raw").specified.variable
    assert (raw.steps, raw.outputs) == ((("input", 0),), (0,))
    assert slopes(raw, 0, 3.0) == [1.0]


def slopes_of_basis(name: str, u: float, degree: int) -> list[float]:
    if name == "fourier":
        turns = [k * math.pi for k in range(1, degree)]
        return [0.0, *(v for w in turns for v in (-w * math.sin(w * u), w * math.cos(w * u)))][: degree + 1]
    kind: Any = {
        "chebyshev": np.polynomial.Chebyshev,
        "legendre": np.polynomial.Legendre,
        "monomial": np.polynomial.Polynomial,
    }[name]
    return [float(kind.basis(k).deriv()(u)) for k in range(degree + 1)]


@pytest.mark.parametrize("shallow", [False, True])
@pytest.mark.parametrize("name", BASES)
def test_bases_have_their_slopes(name: str, shallow: bool) -> None:
    """Corners included, where Chebyshev polynomials are steepest: T_k'(1) = k^2."""
    degree = 13
    program = BASES[name].program(degree, shallow=shallow)
    program.check(name, 1, degree + 1)
    for u in (-1.0, -0.63, 0.0, 0.4, 1.0):
        assert slopes(program, 0, u) == pytest.approx(slopes_of_basis(name, u, degree), rel=1e-12, abs=1e-10)
        assert [float(v) for v in program.run([u])] == pytest.approx(BASES[name].vander(np.array(u), degree), abs=1e-12)
    if name == "chebyshev":
        assert slopes(program, 0, 1.0) == [float(k * k) for k in range(degree + 1)]


def test_prefactors_and_twilight_have_their_slopes() -> None:
    """By a complex step of the formulas as the papers have them (Squire and Trapp 1998)."""
    assert PREETHAM is not None
    assert PEREZ is not None
    for hint, second, formula in ((PREETHAM, "turbidity", preetham_factor), (PEREZ, "brightness", perez_factor)):
        axes = (Axis("sun_zenith", 0.0, 1.5).specified, Axis(second, 0.2, 6.0).specified)
        program = closed_form(hint, axes).program
        program.check("it", 2, 1)
        for values in ((0.0, 3.0), (0.6, 0.3), (1.5, 5.0)):
            for by in range(2):
                moved = [complex(v, 1e-30 * (i == by)) for i, v in enumerate(values)]
                assert slopes(program, by, *values) == [pytest.approx(formula(moved).imag / 1e-30, rel=1e-9)]
    for x in (0.0, 0.2, 0.7, 1.0):
        assert slopes(TWILIGHT.program, 0, x) == [pytest.approx(-110 * x * (1 - x) ** 9, rel=1e-12, abs=1e-12)]


def test_numbers_are_printed_to_the_bit() -> None:
    for value in (0.1, 1 / 3, 1e-300, -2.5, 3.0, 1e22, 5e-324):
        assert float(double(value)) == value
        assert any(c in double(value) for c in ".e")
    for value in (0.1, 1 / 3, 1e-38, -2.5, 16777216.0):
        assert np.float32(single(value)) == np.float32(value)


def drawn(rng: np.random.Generator) -> Program:
    """A random formula of three inputs, with shared parts, negative literals and constants, and three outputs."""

    def formula(*arguments: Any) -> list[Any]:
        *inputs, constants = arguments
        pool = [*inputs, *constants]
        for _ in range(12):
            a, b = (pool[i] for i in rng.integers(len(pool), size=2))
            value = float(np.round(rng.normal(), 3)) or 1.5
            made = [a + b, a - b, a * b, a - (b - value), value - a, -(a - b), -a * -b, a / (b * b + 2.0)]
            pool.append(made[rng.integers(len(made))])
        return pool[-3:]

    return trace(formula, ["a", "b", "c"], [-1.25, 0.3])


@pytest.mark.parametrize(("language", "real"), [(C_DOUBLE, "double"), (C_SINGLE, "float")], ids=["double", "single"])
def test_printed_c_computes_the_same_bits(tmp_path: Path, language: Language, real: str) -> None:
    """Forty random formulas by both printers: brackets, shared parts and signs are those of the program."""
    rng = np.random.default_rng(2010)
    values = [0.7, -1.3, 2.9]
    functions, calls, expected = [], [], []
    for n in range(40):
        program = drawn(rng)
        lines, results = statements(program, language, ["a", "b", "c"])
        stores = [f"out[{i}] = {result};" for i, result in enumerate(results)]
        filled = assignments(program, language, ["a", "b", "c"], ["out[3]", "out[4]", "out[5]"])
        head = f"static void f{n}{{}}({real} a, {real} b, {real} c, {real} *out) {{{{ {{}} (void)a; (void)b; (void)c; }}}}"
        functions += [head.format("s", "\n".join([*lines, *stores])), head.format("a", "\n".join(filled))]
        calls.append(f"f{n}s(in[0], in[1], in[2], out); f{n}a(in[0], in[1], in[2], out); show(out);")
        found = [float(v) for v in program.run([np.array(v, dtype=real.replace("float", "float32")) for v in values])]
        expected += [*found, *found]
    text = f"""#include <math.h>
#include <stdio.h>
static void show(const {real} *v) {{ int i; for (i = 0; i < 6; ++i) printf("%.17g\\n", (double)v[i]); }}
{chr(10).join(functions)}
int main(void) {{ static const {real} in[3] = {{ {", ".join(map(language.number, values))} }}; {real} out[6];
{chr(10).join(calls)} return 0; }}
"""
    (tmp_path / "f.c").write_text(text, encoding="utf-8")
    flags = ["-std=c99", "-O0", "-ffp-contract=off", "-Wall", "-Wextra", "-Wconversion", "-Werror"]
    subprocess.run(["cc", *flags, str(tmp_path / "f.c"), "-o", str(tmp_path / "f"), "-lm"], check=True)
    out = subprocess.run([str(tmp_path / "f")], capture_output=True, text=True, check=True).stdout
    assert np.array_equal(np.array(out.split(), dtype=float), np.array(expected))


def test_labels_name_what_is_printed() -> None:
    def formula(x: Any) -> list[Any]:
        square = label(x * x, "square")
        other = label(square * 2.0, "square")
        return [square + other, label(x, "plain"), sqrt(other)]

    lines, results = statements(trace(formula, ["x"]), C_DOUBLE, ["v"])
    assert lines == ["const double square = v * v;", "const double square_2 = square * 2.0;"]
    assert results == ["square + square_2", "v", "sqrt(square_2)"]
    powers = trace(lambda x: [1.0, x, x * x, x, x * x * x], ["x"])
    targets = assignments(powers, C_SINGLE, ["u"], [f"t[{i}]" for i in range(5)])
    assert sorted(targets) == [
        "t[0] = 1.0f;",
        "t[1] = u;",
        "t[2] = t[1] * t[1];",
        "t[3] = t[1];",
        "t[4] = t[1] * t[1] * t[1];",
    ]


SOUND = Program(("x",), (2.0,), (("input", 0), ("constant", 0), ("*", 0, 1), ("number", 3), ("log", 2)), (4,), ((2, "a"),))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"steps": (("input", 0), ("tangent", 0))}, r"unknown step \('tangent', 0\): a newer version wrote it"),
        ({"steps": (("input", 0), ("+", 0))}, r"unknown step"),
        ({"steps": (("input", 0), ("log", 0, 0))}, r"unknown step"),
        ({"steps": (("input", 0), ("+", 0, 1))}, r"impossible step \('\+', 0, 1\)"),
        ({"steps": (("+", 1, 1), ("input", 0))}, r"impossible step \('\+', 1, 1\)"),
        ({"steps": (("input", 0), ("negative", -1))}, r"impossible step"),
        ({"steps": (("input", 0), ("negative", 0.0))}, r"impossible step"),
        ({"steps": (("input", 0), ("negative", "0"))}, r"impossible step"),
        ({"steps": (("input", 0), ("negative", False))}, r"impossible step"),
        ({"steps": (("input", 1),)}, r"impossible step \('input', 1\)"),
        ({"steps": (("constant", 1),)}, r"impossible step \('constant', 1\)"),
        ({"steps": (("number", math.nan),)}, r"impossible step \('number', nan\)"),
        ({"steps": (("number", math.inf),)}, r"impossible step"),
        ({"steps": (("number", "3"),)}, r"impossible step"),
        ({"steps": (("input", 0),) * 100_001}, r"has 100001 steps"),
        ({"constants": (math.nan,)}, r"constants that are not finite"),
        ({"constants": (-math.inf,)}, r"constants that are not finite"),
        ({"inputs": ()}, r"the inputs \(\)"),
        ({"inputs": ("x", "y")}, r"the inputs \('x', 'y'\)"),
        ({"outputs": (5,)}, r"impossible outputs \(5,\)"),
        ({"outputs": (-1,)}, r"impossible outputs"),
        ({"outputs": (1.0,)}, r"impossible outputs"),
        ({"outputs": ()}, r"impossible outputs \(\)"),
        ({"outputs": (0, 1)}, r"impossible outputs"),
        ({"labels": ((2, "a; b"),)}, r"impossible labels"),
        ({"labels": ((2, 3),)}, r"impossible labels"),
        ({"labels": ((9, "a"),)}, r"impossible labels"),
    ],
)
def test_a_program_that_is_no_formula_is_refused(change: dict[str, Any], message: str) -> None:
    SOUND.check("it", 1, 1)
    with pytest.raises(ValueError, match=message) as caught:
        replace(SOUND, **{"outputs": (0,), "labels": (), **change}).check("it", 1, 1)
    assert str(caught.value).startswith("it has ")


def damaged(table: Table, change: Callable[[dict[str, Any], dict[str, Any]], None], **arrays: Any) -> io.BytesIO:
    """The file of ``table`` after ``change(header, arrays)``, with other ``arrays``."""
    with np.load(io.BytesIO(npz.write(table)), allow_pickle=False) as archive:
        found = {name: archive[name] for name in archive.files}
    header = json.loads(str(found.pop("header")))
    found |= arrays
    change(header, found)
    out = io.BytesIO()
    np.savez(out, header=np.array(json.dumps(header)), **found)
    return io.BytesIO(out.getvalue())


def same(one: Any, other: Any) -> bool:
    """Whether two tables agree in every field, arrays by bits; whole numbers may come back in fewer bytes."""
    if isinstance(one, np.ndarray):
        alike = one.dtype == other.dtype or one.dtype.kind == other.dtype.kind == "i"
        return alike and np.array_equal(one, other)
    if hasattr(one, "__dataclass_fields__"):
        return type(one) is type(other) and all(same(getattr(one, f.name), getattr(other, f.name)) for f in fields(one))
    if isinstance(one, tuple):
        return isinstance(other, tuple) and len(one) == len(other) and all(map(same, one, other))
    return bool(one == other)


@pytest.mark.parametrize("name", FLAVOURS)
def test_every_field_comes_back(name: str) -> None:
    table = replace(FLAVOURS[name], provenance={"config": {"a": [1, 2.5, None]}})
    assert same(runtime.read(io.BytesIO(npz.write(table))), table)
    assert npz.write(runtime.read(io.BytesIO(npz.write(table)))) == npz.write(table)


def test_what_a_file_lacks_has_its_default() -> None:
    optional = ("scale", "quantity", "windowed", "azimuth", "ground", "sun_disc", "peak_axis", "twilight", "parity")

    def without(header: dict[str, Any], _: dict[str, Any]) -> None:
        for name in optional:
            del header["table"]["spec"][name]
        del header["table"]["provenance"]
        del header["table"]["surroundings"]["own"]
        for axis in header["table"]["spec"]["axes"]:
            del axis["variable"]["labels"]

    odd = with_spec(FLAVOURS["surrounded"], windowed=True, sun_disc=True, ground=(0.1, 0.2, 0.3), azimuth=0.5)
    found = runtime.read(damaged(odd, without))
    plain = {f.name: f.default for f in fields(Specification) if f.name in optional}
    assert found.spec == replace(odd.spec, **plain)
    assert found.provenance == {}
    assert found.surroundings is not None
    assert odd.surroundings is not None
    assert same(found.surroundings, Surroundings(odd.surroundings.transfer, below=odd.surroundings.below))


def put(*path: str | int, to: Any) -> Callable[[dict[str, Any], dict[str, Any]], None]:
    """A change of one place in a header."""

    def change(header: dict[str, Any], _: dict[str, Any]) -> None:
        at: Any = header
        for name in path[:-1]:
            at = at[name]
        at[path[-1]] = to

    return change


def drop(name: str) -> Callable[[dict[str, Any], dict[str, Any]], None]:
    return lambda _, arrays: arrays.pop(name)


def reshaped(name: str, change: Callable[[Any], Any]) -> Callable[[dict[str, Any], dict[str, Any]], None]:
    return lambda _, arrays: arrays.update({name: change(arrays[name])})


def marred(value: float) -> Callable[[Any], Any]:
    def change(array: Any) -> Any:
        array = array.copy()
        array.flat[1] = value
        return array

    return change


SPEC = ("table", "spec")
VARIABLE = (*SPEC, "axes", 0, "variable")


@pytest.mark.parametrize(
    ("name", "change", "message"),
    [
        ("rows", put("format", to=3), "its format is 3, this version reads 4: run the fit again"),
        ("rows", put("format", to=5), "its format is 5, this version reads 4: a newer version wrote it"),
        ("rows", put("format", to=None), "its format is None, this version reads 4"),
        ("rows", put("table", "knots", to=[]), "its Table has knots: a newer version wrote it"),
        ("rows", put(*SPEC, "colours", to=1), "its Specification has colours: a newer version wrote it"),
        ("rows", put("table", "body", "is", to="Wavelets"), "it holds a Wavelets: a newer version wrote it"),
        ("rows", put("table", to={"is": "Surroundings"}), "it holds a Surroundings"),
        ("rows", put("table", to=[]), "it holds a tuple"),
        ("rows", put("table", "bands", to=0), "it has 0 bands, 2 axes and 3 channels"),
        ("rows", put("table", "bands", to=65), "it has 65 bands"),
        ("rows", put("table", "bands", to=2.0), r"it has 2\.0 bands"),
        ("rows", put("table", "bands", to=6), r"its columns have the shape \(28,\)"),
        ("rows", put(*SPEC, "channels", to=[]), "2 axes and 0 channels"),
        ("rows", put(*SPEC, "axes", to=[]), "0 axes"),
        ("rows", put(*SPEC, "axes", 1, "name", to="sun_zenith"), "its axes are sun_zenith, sun_zenith"),
        ("rows", put(*SPEC, "mirrored", to=False), r"its columns have the shape \(28,\)"),
        ("rows", put(*SPEC, "axes", 0, "low", to=2.0), r"its axis sun_zenith has the range \[2\.0, "),
        ("rows", put(*SPEC, "axes", 0, "high", to=math.nan), r"its axis sun_zenith has the range \[0\.0, nan\]"),
        ("rows", put(*SPEC, "azimuth", to=math.inf), "its azimuth is inf"),
        ("twilight", put(*SPEC, "twilight", "depth", to=0.0), r"its twilight is 0\.0 deep"),
        ("rows", put(*VARIABLE, "steps", 0, to=["tangent", 0]), "its axis sun_zenith has the unknown step .* newer"),
        ("rows", put(*VARIABLE, "steps", 0, to=["log", 1]), "its axis sun_zenith has the impossible step"),
        ("rows", put(*VARIABLE, "constants", to=[math.nan, 1.0, 1.0]), "its axis sun_zenith has .* not finite"),
        ("rows", put(*SPEC, "scale", "program", "outputs", to=[0, 1]), "its prefactor has 2 outputs for 3 channels"),
        ("rows", put(*SPEC, "scale", "program", "outputs", to=[0, 999]), "its prefactor has the impossible outputs"),
        (
            "rows",
            lambda h, _: h["table"]["spec"].update(parity=True, peak_axis="elevation"),
            "it has parity about 'elevation', which is none of its axes sun_zenith, turbidity",
        ),
        ("rows", put("table", "terms", 1, "outputs", to=[999]), "its axis turbidity has the impossible outputs"),
        ("rows", lambda h, _: h["table"]["terms"].pop(), "it has 1 lists of functions for 2 axes"),
        ("rows", lambda h, _: h["table"]["terms"][0]["outputs"].pop(), r"its lengths are .* for 9 functions"),
        ("rows", lambda h, _: h["table"]["terms"][1]["outputs"].pop(), "its rows have the shape"),
        ("rows", drop("rows"), "rows is not a file in the archive"),
        ("rows", reshaped("rows", lambda a: a[:-1]), r"its rows have the shape \(116, 28\)"),
        ("rows", reshaped("rows", lambda a: a.ravel()), r"its rows have the shape"),
        ("rows", reshaped("rows", marred(math.nan)), "its rows are float32, or not finite"),
        ("rows", reshaped("rows", marred(math.inf)), "its rows are float32, or not finite"),
        ("rows", reshaped("rows", lambda a: a.astype(np.int64)), "its rows are int64"),
        ("rows", reshaped("lengths", lambda a: a[:-1]), "its rows have the shape .* its lengths"),
        (
            "rows",
            reshaped("lengths", lambda a: np.array([[40, 1, 1, 1, 1, 1], *a[1:]], a.dtype)),
            "its lengths are .* for 10 functions",
        ),
        ("rows", reshaped("columns", lambda a: a[:-1]), r"its columns have the shape \(27,\)"),
        ("rows", reshaped("columns", marred(5000)), "its columns .* lead beyond"),
        ("rows", reshaped("columns", marred(-2)), "its columns .* lead beyond"),
        ("packed", reshaped("stream", lambda a: a[: a.size // 2]), "its stream ends early"),
        ("packed", reshaped("stream", lambda a: a[:0]), "its stream ends early"),
        ("packed", reshaped("channel_profile", lambda a: a[:2]), "its profiles have 2 classes"),
        ("packed", reshaped("rest_profile", lambda a: np.resize(a, 7)), "its profiles have 3 classes and 7 products"),
        ("packed", put("table", "body", "first", to=11), "its runs have 11 terms of 10"),
        ("packed", put("table", "body", "step", to=math.nan), "its step is nan"),
        ("surrounded", reshaped("transfer", lambda a: a[:4, :4]), r"transfer has the shape \(4, 4\), not \(9, 9\)"),
        ("surrounded", reshaped("own", marred(math.nan)), "its surroundings' own is not finite"),
    ],
)
def test_damaged_and_foreign_files_are_refused(name: str, change: Any, message: str) -> None:
    file = damaged(FLAVOURS[name], change)
    with pytest.raises(ValueError, match=message) as caught:
        runtime.read(file)
    assert "is no table of this pipeline (" in str(caught.value)
    assert str(caught.value).endswith("). Give the .npz that a run exported.")


def test_other_archives_are_refused(tmp_path: Path) -> None:
    np.savez(tmp_path / "other.npz", weights=np.zeros(3))
    np.savez(tmp_path / "text.npz", header=np.array("no JSON"))
    np.savez(tmp_path / "list.npz", header=np.array("[4]"))
    with zipfile.ZipFile(tmp_path / "zip.npz", "w") as archive:
        archive.writestr("header.npy", b"none")
    data = npz.write(FLAVOURS["rows"])
    (tmp_path / "flipped.npz").write_bytes(data[:400] + bytes([data[400] ^ 1]) + data[401:])
    with pytest.raises(ValueError, match=r"absent\.npz is no table"):
        runtime.load(tmp_path / "absent.npz")
    for path in tmp_path.glob("*.npz"):
        with pytest.raises(ValueError, match=r"is no table of this pipeline \(.+\)\. Give the \.npz"):
            runtime.load(path)


ALONE = """
import hashlib, importlib.abc, json, sys

class Forbidden(importlib.abc.MetaPathFinder):
    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] not in ("numpy", "sky", "secrets") and name.split(".")[0] not in sys.stdlib_module_names:
            raise ImportError(f"{name} was asked for")

sys.meta_path.insert(0, Forbidden())
import numpy as np
import sky
found = {}
for name in json.loads(sys.argv[1]):
    loaded = sky.load(f"{name}.npz")
    ranges = loaded.table.ranges
    columns = [np.linspace(low - 0.1, high + 0.1, 9) for low, high in ranges]
    columns.insert(1, np.linspace(-3.0, 7.0, 9))
    weights, status = loaded.weights_and_status(*columns)
    found[name] = [hashlib.sha256(weights.tobytes()).hexdigest(), status.tolist()]
print(json.dumps(found))
"""


def of_tomorrow() -> Table:
    """A table with a change of variable, functions and a prefactor that no registry knows."""
    axis = Axis("sun_zenith", 0.0, 1.5).specified
    strange = replace(axis, map="tomorrow", variable=trace(lambda v: [exp(-v) * 2.0 - 1.0], ["v"]))

    def formula(theta: Any, k: Any) -> Any:
        return k[0] + exp(-k[1] * theta) / sqrt(1.0 + theta)

    scale = closed_form(Prefactor("of_a_plugin", ("sun_zenith",), (1.5, 0.3), formula), (strange,))
    spec = specification((Axis("sun_zenith", 0.0, 1.5),), ("one",), True, "chebyshev", scale)
    table = fast(spec, np.random.default_rng(9).normal(size=(1, 6, 4)), np.array([4]), 3, "float32")
    terms = trace(lambda u: [1.0, u, elementary.sin(u), u * u], ["u"])
    return replace(table, spec=replace(spec, axes=(strange,), basis="tomorrow's"), terms=(terms,))


def test_the_one_file_alone_reads_tables_of_today_and_tomorrow(tmp_path: Path) -> None:
    tables = {**FLAVOURS, "tomorrow": of_tomorrow()}
    shutil.copy(runtime.__file__, tmp_path / "sky.py")
    expected = {}
    for name, table in tables.items():
        (tmp_path / f"{name}.npz").write_bytes(npz.write(table))
        columns = [np.linspace(low - 0.1, high + 0.1, 9) for low, high in table.ranges]
        columns.insert(1, np.linspace(-3.0, 7.0, 9))
        weights, status = runtime.Runtime(table).weights_and_status(*columns)
        assert set(status.tolist()) == {0, 1}
        expected[name] = [weights, status]
    command = [sys.executable, "-c", ALONE, json.dumps(list(tables))]
    done = subprocess.run(command, cwd=tmp_path, env={}, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    for name, (weights, status) in expected.items():
        assert found[name] == [hashlib.sha256(weights.tobytes()).hexdigest(), status.tolist()], name
