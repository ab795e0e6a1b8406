"""A table's formulas in double precision or with complex numbers, part by part: what rounding is measured against."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh.runtime import Program, Table, orders_of

Array = NDArray[np.float64]
Numbers = NDArray[Any]

_OPERATIONS: Mapping[str, Callable[..., Any]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
    "negative": lambda a: -a,
    "log": np.log,
    "exp": np.exp,
    "sin": np.sin,
    "cos": np.cos,
    "sqrt": np.sqrt,
    "cbrt": lambda a: np.exp(np.log(a) / 3.0),
}


@dataclass(frozen=True)
class Parts:
    """What weights are made of at ``n`` parameter sets, in the number type of these.

    ``terms`` ``(n, products)`` of the axes' functions, the last axis fastest; ``sums`` ``(n, classes, count)``; ``factors``
    ``(n, channels, classes)``; ``powers`` ``(n, count)`` of the peak's sine, ones without parity.
    """

    terms: Numbers
    sums: Numbers
    factors: Numbers
    powers: Numbers

    @property
    def weights(self) -> Numbers:
        """The stored weights, ``(n, channels, count)``."""
        return np.asarray(np.einsum("nck,nkw,nw->ncw", self.factors, self.sums, self.powers))

    @property
    def magnitudes(self) -> Array:
        """The sum of the classes' shares of each weight without their signs, ``(n, channels, count)``."""
        return np.asarray(np.einsum("nck,nkw,nw->ncw", *map(np.abs, (self.factors, self.sums, self.powers))))


def run(program: Program, values: Sequence[Numbers]) -> list[Numbers]:
    """Return a program's outputs at ``values``, one array ``(n,)`` an input, real or complex, each ``(n,)``.

    >>> half = Program(("x",), (), (("input", 0), ("number", 2.0), ("/", 0, 1)), (2,))
    >>> run(half, [np.array([1.0 + 2.0j])])[0].tolist()
    [(0.5+1j)]
    """
    done: list[Any] = []
    for operation, *arguments in program.steps:
        if operation == "number":
            done.append(float(arguments[0]))
        elif operation == "constant":
            done.append(program.constants[int(arguments[0])])
        elif operation == "input":
            done.append(values[int(arguments[0])])
        else:
            done.append(_OPERATIONS[str(operation)](*(done[int(place)] for place in arguments)))
    return [np.broadcast_to(done[place], values[0].shape) for place in program.outputs]


def multiplied(functions: Sequence[Numbers]) -> Numbers:
    """Return all products ``(.., products)`` of the axes' functions, each ``(.., d+1)``, the last axis fastest."""
    found = functions[0]
    for more in functions[1:]:
        product = found[..., :, np.newaxis] * more[..., np.newaxis, :]
        found = product.reshape(*product.shape[:-2], -1)
    return np.asarray(found)


def parts(table: Table, values: Numbers) -> Parts:
    """Return the parts of a table's weights at sets ``(n, axes)`` within its ranges, of which none is rounded to float32."""
    columns = [values[:, axis] for axis in range(len(table.axes))]
    terms = multiplied(
        [
            np.stack(run(program, run(axis.variable, [column])), axis=1)
            for axis, program, column in zip(table.axes, table.terms, columns, strict=True)
        ]
    )
    sums = np.stack([terms[:, places] @ matrix.astype(np.float64) for places, matrix in table.matrices], axis=1)
    return Parts(terms, sums, factors(table, columns), _powers(table, columns))


def factors(table: Table, columns: Sequence[Numbers]) -> Numbers:
    """Return what each channel takes of each class, ``(n, channels, classes)``, at the axes' values, each ``(n,)``."""
    own, channels = table.spec.scale, len(table.channels)
    found = run(own.program, columns) if own else [np.ones_like(columns[0])]
    if len(found) == 1:
        return np.asarray(found[0][:, np.newaxis, np.newaxis] * np.eye(channels))
    return np.stack(found, axis=1).reshape(-1, channels, table.spec.classes)


def _powers(table: Table, columns: Sequence[Numbers]) -> Numbers:
    if not table.spec.parity:
        return np.ones((len(columns[0]), table.places.size))
    names = [axis.name for axis in table.axes]
    sine = np.sin(columns[names.index(str(table.spec.peak_axis))])
    return np.asarray(sine[:, np.newaxis] ** np.abs(orders_of(table.places)))


def in_single(table: Table, values: Array) -> Array:
    """Return sets ``(n, axes)`` moved to the nearest numbers of single precision that lie within the table's ranges."""
    found = values.astype(np.float32)
    for axis, given in enumerate(table.axes):
        low, high = (np.float32(end) for end in (given.low, given.high))
        # As Python's numbers: NumPy would round the ends before it compares.
        low = low if float(low) >= given.low else np.nextafter(low, np.float32(np.inf))
        high = high if float(high) <= given.high else np.nextafter(high, np.float32(-np.inf))
        found[:, axis] = np.clip(found[:, axis], low, high)
    return found.astype(np.float64)
