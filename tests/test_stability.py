"""The stresses of tables as they are evaluated: each holds, and each notices where the formula that it stresses is wrong."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import mpmath
import numpy as np
import pytest
from conftest import SMALL
from numpy.typing import NDArray
from skylight_sh import runtime
from skylight_sh.config import parse
from skylight_sh.export import c_header
from skylight_sh.formula.sine import SHORT_SINE
from skylight_sh.runtime import ClassRows, Packed, Program, Table, orders_of
from skylight_sh.studies import compiled, single_fit
from skylight_sh.studies.grid_samples import Samples, sample
from skylight_sh.studies.stability import cancellation, decoded, gradients, rounding, turning, wide, zenith
from skylight_sh.studies.stability.flavours import flavours
from skylight_sh.table.table import small

Array = NDArray[np.float64]
FLAVOURS = flavours()
REFERENCE = Path(__file__).parents[1] / "reports" / "reference" / "export"


def inside(table: Table, count: int = 40) -> Array:
    low, high = np.transpose([(axis.low, axis.high) for axis in table.axes])
    sets = np.random.default_rng(3).uniform(low, high, size=(count, low.size))
    sets[0], sets[1] = low, high
    return wide.in_single(table, sets)


def rounded_by(program: Program, values: list[float], roundings: NDArray[np.float64]) -> list[float]:
    """Run a program in Python, each step's result times 1 + its rounding; numbers that single precision holds are exact."""
    done: list[float] = []
    for (operation, *arguments), rounding_ in zip(program.steps, roundings.tolist(), strict=True):
        operands = [done[int(a)] for a in arguments] if operation in {"+", "-", "*", "/", "negative"} else []
        match operation:
            case "input":
                done.append(values[int(arguments[0])])
            case "number":
                number = float(arguments[0])
                done.append(number * (1.0 + rounding_ * (float(np.float32(number)) != number)))
            case "constant":
                number = program.constants[int(arguments[0])]
                done.append(number * (1.0 + rounding_ * (float(np.float32(number)) != number)))
            case "negative":
                done.append(-operands[0])
            case _:
                one, other = operands
                result = {"+": one + other, "-": one - other, "*": one * other}.get(str(operation))
                done.append((one / other if result is None else result) * (1.0 + rounding_))
    return [done[place] for place in program.outputs]


def test_derivatives_after_roundings_are_those_of_differences() -> None:
    """Of the factors of the classes, the longest program there is: each step's rounding by itself."""
    scale = FLAVOURS["classes"].spec.scale
    assert scale is not None
    program, at = scale.program, [0.7, 3.1]
    steps = len(program.steps)
    found = rounding.traced(program, [rounding.exact(np.array([value]), steps) for value in at])
    for place in range(0, steps, 3):
        one = np.zeros(steps)
        one[place] = 1e-6
        up, down = (rounded_by(program, at, sign * one) for sign in (1.0, -1.0))
        for output, number in enumerate(found):
            slope = (up[output] - down[output]) / 2e-6
            assert abs(number.slopes[place, 0] - slope) < 1e-6 * abs(number.value[0]), (place, output)


def test_functions_of_the_library_are_traced() -> None:
    steps: list[tuple[str | int | float, ...]] = [("input", 0)]
    for k, name in enumerate(["log", "exp", "sin", "cos", "sqrt", "cbrt"]):
        steps.append((name, 0) if k == 0 else (name, k))
    program = Program(("x",), (), tuple(steps), (1, 2, 3, 4, 5, 6))
    # log, exp of it, the input again, and so on: the derivative after the first rounding is the chain's.
    found = rounding.traced(program, [rounding.exact(np.array([2.5]), len(steps))])
    with mpmath.workdps(40):

        def chain(rounded: mpmath.mpf, functions: int) -> mpmath.mpf:
            value = mpmath.log(mpmath.mpf("2.5")) * (1 + rounded)
            for function in (mpmath.exp, mpmath.sin, mpmath.cos, mpmath.sqrt, mpmath.cbrt)[:functions]:
                value = function(value)
            return value

        for k, number in enumerate(found):
            expected = mpmath.diff(lambda rounded, k=k: chain(rounded, k), 0)
            assert abs(number.slopes[1, 0] - float(expected)) < 1e-12


@pytest.mark.parametrize("name", ["classes", "classes-packed", "parity", "rows", "one-axis", "unmirrored", "irradiance"])
def test_single_precision_keeps_within_what_roundings_can_do(name: str) -> None:
    """And not far within: a bound that nothing comes near says nothing."""
    table = FLAVOURS[name]
    sets = inside(table, 200)
    error = np.abs(table.evaluate(sets) - wide.parts(table, sets).weights)
    bound = rounding.bound(table, sets)
    assert (error <= bound).all()
    assert error.max() > 0.02 * bound.max()


@pytest.mark.parametrize("name", ["classes-float64", "float64"])
def test_parts_are_those_of_the_runtime(name: str) -> None:
    table = FLAVOURS[name]
    sets = inside(table)
    expected = table.evaluate(sets)
    assert np.abs(wide.parts(table, sets).weights - expected).max() < 1e-13 * np.abs(expected).max()


def test_parts_without_their_signs() -> None:
    sums = np.array([[[3.0, 1.0], [5.0, 0.0]]])
    parts = wide.Parts(np.ones((1, 1)), sums, np.array([[[2.0, -1.0]]]), np.array([[1.0, 0.5]]))
    assert parts.weights.tolist() == [[[1.0, 1.0]]]
    assert parts.magnitudes.tolist() == [[[11.0, 1.0]]]
    assert cancellation.amplification(parts) == pytest.approx(np.sqrt((121 + 1) / 2))


def test_single_precision_s_sets_lie_within_the_ranges() -> None:
    """Float32 pi/2 does not."""
    table = FLAVOURS["classes"]
    sets = wide.in_single(table, np.array([[np.pi / 2, 6.0], [0.0, 2.5], [9.0, -9.0]]))
    assert sets[0, 0] < np.pi / 2
    assert sets[1].tolist() == [0.0, 2.5]
    assert sets[2].tolist() == [sets[0, 0], 2.5]


@pytest.fixture(scope="module")
def samples() -> Samples:
    """Of a light of classes, over axes whose functions are those of classes."""
    raw = tomllib.loads(SMALL.read_text(encoding="utf-8"))
    raw["axes"][0] |= {"map": "even", "point": -14.0}
    return sample(parse(raw, "even"), 4, random=60)


def packed_of(samples: Samples, step: float) -> Table:
    made = single_fit.fit(samples, samples.half, [6, 4], "chebyshev", "svd", single_fit.OWN)
    whole = np.rint(made.dense / step).astype(np.int64).swapaxes(0, 1)
    return small(single_fit.table_of(samples, made, "float32").spec, whole.reshape(*whole.shape[:3], -1), step, (6, 4), 4)


def test_what_classes_cost(samples: Samples) -> None:
    made = single_fit.fit(samples, samples.half, [6, 4], "chebyshev", "svd", single_fit.OWN)
    tables = {"fast": single_fit.table_of(samples, made, "float32"), "packed": packed_of(samples, 2.0**-9)}
    one, weights, suns = cancellation.sections(samples, tables["fast"], tables, dict.fromkeys(tables, 0.01))
    assert [row["holds"] for row in one.rows] == ["yes"] * 6
    # Most of what single precision adds is the factors'.
    assert all(0.3 < float(str(row["factors"])) / float(str(row["float32"])) < 1.5 for row in one.rows)
    assert [row["steps"] is None for row in one.rows] == [True] * 3 + [False] * 3
    assert [row["holds"] for row in weights.rows] == ["yes"] * 10
    assert all(float(str(row[c])) >= 1.0 for row in [*weights.rows, *suns.rows] for c in ("red", "green", "blue"))
    assert suns.draw is not None
    assert len(suns.draw(suns.rows).axes[0].lines) == 9


def test_rounding_to_steps_is_off_as_independent_roundings_are(samples: Samples) -> None:
    """On average over steps, and never by more than half a step each."""
    sets, shares = samples.reference.parameters, []
    for step in 2.0 ** np.linspace(-11.0, -8.0, 24):
        found = cancellation.rounded_to_steps(samples, packed_of(samples, float(step)), sets)
        assert (found[""] <= found[" bound"]).all()
        shares.append(np.square(found[""]).mean() / np.square(found[" expected"]).mean())
    assert 0.8 < np.mean(shares) < 1.25


def test_what_is_said_of_the_default_table_s_classes() -> None:
    """In the docs: parts are at most 1.8 times their sum, most in red with the sun at the zenith; as X, Y and S 9 times."""
    table = runtime.read(REFERENCE / "skylight_sh.npz")
    parts = wide.parts(table, inside(table, 500))
    larger = cancellation.amplification(parts)
    assert 1.6 < larger[:, 0].max() < 1.8
    assert larger[:, 1].max() < 1.05
    assert larger[:, 2].max() < 1.2
    (luminance, x, s), factors = np.moveaxis(parts.sums, 1, 0), parts.factors
    of_luminance = factors[..., 0] - factors[..., 1] - factors[..., 2]
    plain = replace(
        parts,
        sums=np.stack([luminance, luminance + x, luminance + s], axis=1),
        factors=np.stack([of_luminance, factors[..., 1], factors[..., 2]], axis=2),
    )
    assert np.allclose(plain.weights, parts.weights, rtol=1e-12, atol=1e-9)
    assert cancellation.amplification(plain).max(axis=0) == pytest.approx([9.4, 3.0, 7.4], rel=0.03)
    overhead = cancellation.amplification(wide.parts(table, np.array([[0.0, 2.5], [1.5, 2.5]])))
    assert overhead[0, 0] > overhead[1, 0]
    sets = inside(table, 500)
    error = np.abs(table.evaluate(sets) - parts.weights)
    assert error.max() < 2e-6 * np.abs(table.evaluate(sets)).max()


def off(table: Table) -> Table:
    """Return a table whose first coefficient, of its first class and weight, is off by 1e-4 of the largest."""
    body = table.body
    assert isinstance(body, ClassRows)
    rows = body.rows.copy()
    rows[0, 0] += 1e-4 * np.abs(rows).max()
    return replace(table, body=replace(body, rows=rows))


def changed(monkeypatch: pytest.MonkeyPatch, change: Callable[[Table], Table]) -> None:
    """Make headers those of changed tables."""

    def header_of(table: Table) -> str:
        return c_header.write(change(table), compiled.FACTS, compiled.PREFIX)

    monkeypatch.setattr(compiled, "header_of", header_of)


def test_powers_of_the_sine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    rows = zenith.powers(7, tmp_path)
    assert {row["in"] for row in rows} == {"C", "Python"}
    assert [row["holds"] for row in rows] == ["yes"] * len(rows)
    # At 1e-7 the sixth power is below single precision's full range, and yet no 0.
    smallest = [row for row in rows if row["zenith angle"] == 1e-7]
    assert all(0.0 < float(str(row["relative error"])) < 1e-2 for row in smallest)

    def powers(base: NDArray[np.floating], count: int) -> NDArray[np.floating]:
        found = np.ones((len(base), count), dtype=base.dtype)
        found[:, 1:] = (base * base.dtype.type(1.0 + 2.0**-20))[:, np.newaxis] ** np.arange(1, count)
        return found

    monkeypatch.setattr(runtime, "powers", powers)
    changed(monkeypatch, off)
    wrong = zenith.powers(7, tmp_path)
    assert all(row["holds"] == "no" for row in wrong if row["in"] == "Python" and row["zenith angle"] != 0.0)
    # The changed weight is that of order 0, which stands at the zenith too.
    assert all(row["holds"] == "no" for row in wrong if row["in"] == "C")


def test_waves_of_the_azimuth(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    rows = turning.waves(7, tmp_path)
    assert [row["holds"] for row in rows] == ["yes"] * len(rows)
    # In C no bound is so wide that errors are nowhere near.
    assert (
        max(float(str(row["error of m = 1"])) / float(str(row["bound of m = 1"])) for row in rows if row["in"] == "C") > 0.3
    )

    def turned(weights: NDArray[np.floating], azimuth: NDArray[np.floating]) -> NDArray[np.floating]:
        return rotate(weights, azimuth * (1.0 + 2.0**-20))

    rotate = runtime.rotate_azimuth
    monkeypatch.setattr(runtime, "rotate_azimuth", turned)
    changed(monkeypatch, off)
    wrong = turning.waves(7, tmp_path)
    assert all(row["holds"] == "no" for row in wrong if row["in"] == "C")
    assert sum(row["holds"] == "no" for row in wrong if row["in"] == "Python") >= len(wrong) // 2 - 2


def test_the_header_s_sine_is_bounded_by_its_operations() -> None:
    angles = np.float32([1e-7, 0.1, 1.0, 1.5]).astype(np.float64)
    bound = rounding.sine_of_header(zenith.pure(3), angles)
    single = SHORT_SINE.run([angles.astype(np.float32)])[0].astype(np.float64)
    error = np.abs(single / np.sin(angles) - 1.0) / rounding.UNIT
    assert (error <= bound).all()
    assert bound[0] < 1.01
    assert (bound < 5.0).all()


def test_no_weight_jumps_at_the_zenith(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    table = FLAVOURS["classes"]
    assert [row["holds"] for row in zenith.crossing("classes", table, tmp_path)] == ["yes", "yes"]

    def off_zenith(base: NDArray[np.floating], count: int) -> NDArray[np.floating]:
        return np.asarray(np.maximum(base, base.dtype.type(1e-4))[:, np.newaxis] ** np.arange(count), dtype=base.dtype)

    # A sine that does not vanish.
    monkeypatch.setattr(runtime, "powers", off_zenith)
    rows = {row["in"]: row for row in zenith.crossing("parity", FLAVOURS["parity"], tmp_path)}
    assert rows["C"]["holds"] == "yes"
    assert rows["Python"]["holds"] == "no"
    assert float(str(rows["Python"]["at 0"])) > 0.0


def test_slopes_at_the_zenith_are_of_order_one() -> None:
    """sin^m has a slope at 0 for m = 1 alone."""
    table = zenith.pure(4)
    slope = gradients.slopes(table, np.zeros((1, 1)), 0)[0, 0]
    assert np.allclose(slope, np.where(orders_of(table.places) == 1, 1.0, 0.0), atol=1e-25)


def test_decoded_tables_are_the_same_or_within_roundings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    table = FLAVOURS["classes-packed"]
    found = list(decoded.compared(table, tmp_path))
    assert all(one.holds for one in found), [one for one in found if not one.holds]
    same = {(one.built, one.what) for one in found if one.bound == 0.0}
    assert {("Python", "one by one"), ("-O2, no contraction", "unpacked batch"), ("-O2, no contraction", "batch")} <= same

    def one_step_off(packed: Packed, places: NDArray[np.int64]) -> NDArray[np.int64]:
        numbers = runtime.unpack(packed, places).copy()
        numbers[0, 0, 0, 0] += 1
        return numbers

    # What Python has decoded wrongly, no C agrees with, and what has double precision.
    monkeypatch.setattr(decoded, "unpack", one_step_off)
    wrong = {(one.built, one.what, one.against) for one in decoded.compared(table, tmp_path) if not one.holds}
    assert {("Python", "fast table", "call"), ("-O2, no contraction", "fast table", "unpacked")} <= wrong
    assert ("-O2, no contraction", "call", "Python") not in wrong


@pytest.mark.parametrize("name", ["classes", "classes-packed", "parity"])
def test_derivatives_are_within_a_rounding_of_complex_steps(tmp_path: Path, name: str) -> None:
    found = list(gradients.compared(FLAVOURS[name], tmp_path))
    assert all(one.holds for one in found), [one for one in found if not one.holds]
    assert {"inside", "edges", "corners", "zenith", "near the zenith", "beyond the ends"} == {one.where for one in found}
    assert all(one.bound < 2.0**-23 for one in found)


def test_a_wrong_derivative_is_noticed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    changed(monkeypatch, off)
    found = [one for one in gradients.compared(FLAVOURS["classes"], tmp_path) if one.where != "beyond the ends"]
    assert not any(one.holds for one in found)
