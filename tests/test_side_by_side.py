"""Programs of vectors against the plain programs that they come from."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from skylight_sh.formula import printers
from skylight_sh.formula.azimuth import stretched_waves, waves_of_turn
from skylight_sh.formula.expression import trace
from skylight_sh.formula.printers import C_FOUR, C_SUNS
from skylight_sh.formula.side_by_side import side_by_side
from skylight_sh.formula.sine import QUARTER
from skylight_sh.light.preetham import Preetham
from skylight_sh.runtime import Program

Array = NDArray[np.float64]
PLAIN = {"+": np.add, "-": np.subtract, "*": np.multiply, "/": np.divide, "negative": np.negative}


def run(program: Program, inputs: list[float]) -> list[Array]:
    """Interpret a program whose values may be vectors."""
    values: list[Array] = []
    for operation, *arguments in program.steps:
        if operation == "number":
            value = np.float64(arguments[0])
        elif operation == "constant":
            value = np.float64(program.constants[int(arguments[0])])
        elif operation == "input":
            value = np.float64(inputs[int(arguments[0])])
        else:
            given = [values[int(a)] for a in arguments]
            if operation == "pack":
                assert all(np.ndim(one) == 0 for one in given)
                value = np.array(given)
            elif str(operation).startswith("lane"):
                value = given[0][int(str(operation)[4:])]
            else:
                value = PLAIN[str(operation)](*given)
        values.append(np.asarray(value))
    return [values[place] for place in program.outputs]


def classes() -> Program:
    factors = Preetham().hints.classes
    assert factors is not None
    return trace(factors.formula, factors.axes, factors.constants)


def test_vectors_have_the_plain_program_s_values() -> None:
    """The factors of Preetham's classes: bit by bit, since nothing is rearranged."""
    plain = classes()
    groups = [[k, k + 3, k + 6] for k in range(3)]
    for theta, tau in [(0.0, 2.5), (0.7, 3.1), (1.5, 6.0)]:
        want = np.array(plain.run([theta, tau])).reshape(3, 3)
        assert np.array_equal(np.array(run(side_by_side(plain, groups), [theta, tau])).T, want)
        # Without groups of outputs they stay numbers.
        assert np.array_equal(np.array(run(side_by_side(plain), [theta, tau])).reshape(3, 3), want)


def operations(program: Program) -> int:
    used, todo = set(), list(program.outputs)
    while todo:
        place = todo.pop()
        step = program.steps[place]
        if place not in used and step[0] not in ("number", "constant", "input", "pack"):
            used.add(place)
            todo += [int(a) for a in step[1:]]
    return len(used)


def test_vectors_save_operations() -> None:
    """Three shapes of the sky at once, two chromaticities, three channels: about half of all operations."""
    plain = classes()
    packed = side_by_side(plain, [[k, k + 3, k + 6] for k in range(3)])
    assert operations(packed) < 0.6 * operations(plain)
    sizes = [len(step) - 1 for step in packed.steps if step[0] == "pack"]
    assert set(sizes) == {2, 3}


def test_what_saves_nothing_stays_as_it_is() -> None:
    short = trace(lambda x: [2 * x + 1, 3 * x + 2], ["x"])
    assert side_by_side(short).steps == short.steps
    # A formula of a shared part: the part stays one number.
    shared = trace(lambda x: [(2 * (x * x) + 1) * (x * x) * x * x, (3 * (x * x) + 2) * (x * x) * x * x], ["x"])
    packed = side_by_side(shared, [[0, 1]])
    assert run(packed, [3.0])[0].tolist() == [(2 * 9 + 1) * 81, (3 * 9 + 2) * 81]


def test_vectors_are_printed() -> None:
    pair = trace(lambda x: [(2 * x + 3) * x, (4 * x + 5) * x], ["x"])
    assert printers.assignments(side_by_side(pair, [[0, 1]]), C_FOUR, ["x"], ["out"]) == [
        "const skylight_sh_four part_1 = (skylight_sh_pair(2.0f, 4.0f) * x + skylight_sh_pair(3.0f, 5.0f)) * x;",
        "skylight_sh_keep(out, part_1);",
    ]
    # Of many suns: what hangs on no input is one number.
    assert printers.assignments(trace(lambda x: [1.0, x * x], ["x"]), C_SUNS, ["x"], ["a", "b"]) == [
        "a = skylight_sh_spread(1.0f);",
        "const skylight_sh_lanes part_1 = x * x;",
        "b = part_1;",
    ]


def test_an_eighth_of_a_turn_has_its_cosine_and_sine() -> None:
    angle = np.linspace(-np.pi / 4, np.pi / 4, 2001)
    cosine, sine = QUARTER.run([angle])
    assert np.abs(cosine - np.cos(angle)).max() < 2e-10
    known = angle != 0
    assert np.abs(sine[known] / np.sin(angle[known]) - 1).max() < 5e-9


@pytest.mark.parametrize("bands", [1, 2, 7])
def test_waves_of_a_turn_are_those_of_its_angle(bands: int) -> None:
    angle = np.array([-3.0, 0.2, 9.0])
    for found in (stretched_waves(bands).run([angle, 0.5]), waves_of_turn(bands).run([np.cos(angle), np.sin(angle), 0.5])):
        for m in range(bands):
            assert np.allclose(found[m], 0.5**m * np.cos(m * angle), atol=1e-14)
            assert np.allclose(found[bands + m], 0.5**m * np.sin(m * angle), atol=1e-14)
