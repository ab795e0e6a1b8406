"""What rounding to single precision can do to a table's weights: each operation's own rounding, followed to the result.

An operation returns its exact result times 1 + d, |d| <= 2^-24. To first order the result moves by the sum over all d of its
derivative after d, so by no more than the sum of their magnitudes times 2^-24 (Bauer 1974). The derivatives are taken along
with the values, in double precision, from the programs themselves; sums and products of known shape are bounded term by term
(Higham 2002, sections 3.1 and 5.1).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh.formula.sine import QUARTER, SHORT_END, SHORT_SINE
from skylight_sh.runtime import Program, Table, orders_of
from skylight_sh.studies.stability import wide

Array = NDArray[np.float64]

UNIT = 2.0**-24
"""The largest relative error of one rounding to single precision."""
SMALLEST = 2.0**-150
"""The farthest that a number too small for single precision is moved by rounding."""
_SETS_AT_ONCE = 128
_DIGITS = 60
# Of a result: itself, and its derivatives after the operands.
_TWO: Mapping[str, Callable[[Array, Array], tuple[Array, Any, Any]]] = {
    "+": lambda a, b: (a + b, 1.0, 1.0),
    "-": lambda a, b: (a - b, 1.0, -1.0),
    "*": lambda a, b: (a * b, b, a),
    "/": lambda a, b: (a / b, 1.0 / b, -a / (b * b)),
}
_ONE: Mapping[str, Callable[[Array], tuple[Array, Array]]] = {
    "log": lambda a: (np.log(a), 1.0 / a),
    "exp": lambda a: (np.exp(a), np.exp(a)),
    "sin": lambda a: (np.sin(a), np.cos(a)),
    "cos": lambda a: (np.cos(a), -np.sin(a)),
    "sqrt": lambda a: (np.sqrt(a), 0.5 / np.sqrt(a)),
    "cbrt": lambda a: (np.cbrt(a), 1.0 / (3.0 * np.cbrt(a) ** 2)),
}


@dataclass(frozen=True)
class Traced:
    """Values ``(n,)`` of a step, and their derivatives after each relative rounding, ``(roundings, n)``."""

    value: Array
    slopes: Array


def exact(value: Array, roundings: int) -> Traced:
    """Return numbers ``(n,)`` that no rounding has touched, of a computation of so many roundings."""
    return Traced(value, np.zeros((roundings, value.size)))


def traced(program: Program, inputs: Sequence[Traced], first: int = 0) -> list[Traced]:
    """Return a program's outputs; step k's own rounding is number ``first`` + k.

    Numbers that single precision holds exactly, signs and inputs are not rounded; the library's functions are, once, from
    double precision.

    >>> program = Program(("x",), (), (("input", 0), ("*", 0, 0)), (1,))
    >>> traced(program, [exact(np.array([3.0]), 2)])[0].slopes.ravel().tolist()
    [0.0, 9.0]
    """
    done: list[Traced] = []
    for place, (operation, *arguments) in enumerate(program.steps):
        if operation == "input":
            done.append(inputs[int(arguments[0])])
            continue
        if operation in ("number", "constant"):
            number = float(arguments[0]) if operation == "number" else program.constants[int(arguments[0])]
            value, slopes = np.full_like(inputs[0].value, number), np.zeros_like(inputs[0].slopes)
            if float(np.float32(number)) != number:
                slopes[first + place] = value
            done.append(Traced(value, slopes))
            continue
        operands = [done[int(argument)] for argument in arguments]
        if operation == "negative":
            done.append(Traced(-operands[0].value, -operands[0].slopes))
            continue
        if operation in _TWO:
            one, other = operands
            value, of_one, of_other = _TWO[str(operation)](one.value, other.value)
            slopes = of_one * one.slopes + of_other * other.slopes
        else:
            value, of_one = _ONE[str(operation)](operands[0].value)
            slopes = of_one * operands[0].slopes
        slopes[first + place] += value
        done.append(Traced(value, slopes))
    return [done[place] for place in program.outputs]


def largest(numbers: Sequence[Traced]) -> Array:
    """Return how far rounding may move each of so many numbers, ``(numbers, n)``, in units of ``UNIT``."""
    return np.stack([np.abs(number.slopes).sum(axis=0) for number in numbers])


def sine_of_header(table: Table, angles: Array) -> Array:
    """Return how far off the C header's sine of the peak's zenith angles ``(n,)`` may be, relative, in units of ``UNIT``.

    In single precision it is a polynomial: its distance from the sine by mpmath, and its operations' roundings. Where the
    table reaches farther than that goes, it is the library's, within a unit in the last place.
    """
    import mpmath

    peak = next(axis for axis in table.axes if axis.name == table.spec.peak_axis)
    if max(-peak.low, peak.high) > SHORT_END:
        return np.full_like(angles, 2.0)
    rounded = largest(traced(SHORT_SINE, [exact(angles, len(SHORT_SINE.steps))]))[0]
    found = np.ones_like(angles)
    with mpmath.workdps(_DIGITS):
        for i, angle in enumerate(angles.tolist()):
            if angle:
                # Python's numbers become mpmath's, exactly.
                sine = mpmath.sin(mpmath.mpf(angle))
                polynomial = wide.run(SHORT_SINE, [np.array([mpmath.mpf(angle)], dtype=object)])[0][0]
                found[i] = float(abs(polynomial - sine) / sine) / UNIT + rounded[i] / float(sine)
    return found


@cache
def circle_of_header() -> float:
    """Return how far an azimuth's cosine and sine in the header may be off together, in units of ``UNIT``.

    The library's, for large azimuths, are within a unit in the last place each, which is less.
    """
    import mpmath

    # An eighth of a turn, and as much more as the quarter that is nearest in single precision may be off.
    angles = np.linspace(0.0, np.pi / 4 + 1e-6, 401)[1:]
    steps = len(QUARTER.steps)
    # What is left of the azimuth is itself rounded.
    slopes = np.zeros((steps + 1, angles.size))
    slopes[steps] = angles
    rounded = largest(traced(QUARTER, [Traced(angles, slopes)]))
    distance = np.zeros_like(rounded)
    with mpmath.workdps(_DIGITS):
        for i, angle in enumerate(angles.tolist()):
            given = np.array([mpmath.mpf(angle)], dtype=object)
            cosine, sine = (one[0] for one in wide.run(QUARTER, [given]))
            distance[:, i] = float(abs(cosine - mpmath.cos(angle))), float(abs(sine - mpmath.sin(angle)))
    return float(np.linalg.norm(rounded + distance / UNIT, axis=0).max())


def bound(table: Table, values: Array, *, sine: float = 1.0, horner: bool = False) -> Array:
    """Return how far float32 may be off at sets ``(n, axes)`` of single precision and azimuth 0: ``(n, channels, count)``.

    ``sine`` is the relative error of the peak's sine in units of ``UNIT``. Terms are summed one by one in the table's order,
    or, with ``horner``, in any order that takes no more operations than Horner's scheme on the first axis and a multiply-add
    for each product of the others, coefficients of a packed table rounded on the way.
    """
    return np.concatenate(
        [
            _bound(table, values[start : start + _SETS_AT_ONCE], sine, horner)
            for start in range(0, len(values), _SETS_AT_ONCE)
        ]
    )


def _bound(table: Table, values: Array, sine: float, horner: bool) -> Array:
    parts = wide.parts(table, values)
    columns = [np.ascontiguousarray(values[:, axis]) for axis in range(len(table.axes))]
    functions, slopes = zip(*(_functions(table, axis, column) for axis, column in enumerate(columns)), strict=True)
    # What the functions' roundings do, each to all classes at once.
    total = np.zeros(parts.weights.shape)
    for axis, slope in enumerate(slopes):
        moved = wide.multiplied(
            [slope if a == axis else np.broadcast_to(f, (len(slope), *f.shape)) for a, f in enumerate(functions)]
        )
        sums = np.stack([moved[..., places] @ matrix.astype(np.float64) for places, matrix in table.matrices], axis=2)
        total += np.abs(np.einsum("nck,rnkw->rncw", parts.factors, sums)).sum(axis=0)
    total += np.einsum("nck,nkw->ncw", np.abs(parts.factors), _summing(table, parts.terms, horner))
    # Factors, their products with the sums, the sum of these, the sine's powers and the product with them.
    shares = parts.factors[..., np.newaxis] * parts.sums[:, np.newaxis]
    total += _of_factors(table, columns, parts.sums) + np.abs(shares).sum(axis=2)
    total += np.abs(np.cumsum(shares, axis=2)[:, :, 1:]).sum(axis=2)
    orders = np.abs(orders_of(table.places)) if table.spec.parity else np.zeros(table.places.size)
    powers = orders * sine + np.maximum(orders - 1, 0) + 1.0
    return np.asarray(UNIT * (total * np.abs(parts.powers[:, np.newaxis]) + powers * np.abs(parts.weights)))


def _functions(table: Table, axis: int, column: Array) -> tuple[Array, Array]:
    """Return an axis's functions ``(n, d+1)`` and their derivatives after the roundings, ``(roundings, n, d+1)``."""
    variable, program = table.axes[axis].variable, table.terms[axis]
    roundings = len(variable.steps) + len(program.steps)
    found = traced(program, traced(variable, [exact(column, roundings)]), len(variable.steps))
    return np.stack([one.value for one in found], axis=1), np.stack([one.slopes for one in found], axis=2)


def _summing(table: Table, terms: Array, horner: bool) -> Array:
    """Return what products and sums of the terms are off, ``(n, classes, count)``, in units of ``UNIT``."""
    found = []
    for places, matrix in table.matrices:
        each = terms[:, places, np.newaxis] * matrix.astype(np.float64)
        if horner:
            rest = [degree + 1 for degree in table.degrees[1:]]
            # Two operations a step of the first axis, two a product of the others, the step of a packed table twice.
            count = 2 * table.degrees[0] + 2 * int(np.prod(rest, dtype=int)) + len(rest) + 2
            found.append(count * np.abs(each).sum(axis=1))
        else:
            found.append(len(table.axes) * np.abs(each).sum(axis=1) + np.abs(np.cumsum(each, axis=1)[:, 1:]).sum(axis=1))
    return np.stack(found, axis=1)


def _of_factors(table: Table, columns: Sequence[Array], sums: Array) -> Array:
    own = table.spec.scale
    if own is None:
        return np.zeros((len(sums), len(table.channels), sums.shape[2]))
    found = traced(own.program, [exact(column, len(own.program.steps)) for column in columns])
    slopes = np.stack([one.slopes for one in found], axis=2)
    if len(found) == 1:
        return np.asarray(np.abs(slopes).sum(axis=0)[..., np.newaxis] * np.abs(sums))
    slopes = slopes.reshape(*slopes.shape[:2], len(table.channels), -1)
    return np.asarray(np.abs(np.einsum("rnck,nkw->rncw", slopes, sums)).sum(axis=0))
