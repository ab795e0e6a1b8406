"""What all weights of a table are multiplied with: a light's closed form, or the reciprocal of a polynomial in samples."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh.formula.bases import BASES
from skylight_sh.formula.expression import expression, expressions, trace
from skylight_sh.light.protocol import Prefactor
from skylight_sh.runtime import Axis, Scale
from skylight_sh.table.short_numbers import bytes_of_numbers

Array = NDArray[np.float64]
Floats = NDArray[np.floating]

CLOSED_FORM, RECIPROCAL = "closed form", "reciprocal"


def closed_form(prefactor: Prefactor, axes: Sequence[Axis], fixed: Mapping[str, float] | None = None) -> Scale:
    """Return a light's ``prefactor`` over ``axes``; parameters that are no axes any more are ``fixed``."""
    known = {name: value for name, value in sorted((fixed or {}).items()) if name in prefactor.axes}

    def formula(*arguments: Any) -> list[Any]:
        *values, constants = arguments
        named = dict(zip((axis.name for axis in axes), values, strict=True))
        named |= {name: expression(value) for name, value in known.items()}
        found = prefactor.formula(*(named[name] for name in prefactor.axes), constants)
        return list(found) if isinstance(found, list | tuple) else [found]

    program = trace(formula, [axis.name for axis in axes], prefactor.constants)
    return Scale(CLOSED_FORM, prefactor.name, program, tuple(known.items()))


def reciprocal(coefficients: Floats, axes: Sequence[Axis]) -> Scale:
    """Return 1 over the Chebyshev polynomial of ``coefficients`` ``(d_1+1, .., d_D+1)`` in the axes' own variables.

    >>> from skylight_sh.fit.axis import Axis
    >>> halved = reciprocal(np.array([2.0, 1.0]), [Axis("height", 0.0, 1.0).specified])
    >>> evaluate(halved, np.array([[0.0], [0.5], [1.0]])).ravel().round(4).tolist()
    [1.0, 0.5, 0.3333]
    """
    functions = BASES["chebyshev"]

    def formula(*arguments: Any) -> list[Any]:
        *values, constants = arguments
        sums: dict[tuple[int, ...], Any] = dict(zip(np.ndindex(*coefficients.shape), constants, strict=True))
        for axis, value, size in zip(axes, values, coefficients.shape, strict=True):
            # The first axis left is summed over, again and again, in a fixed order.
            terms = expressions(functions.program(size - 1), expressions(axis.variable, [value]))
            rest = dict.fromkeys(index[1:] for index in sums)
            sums = {index: sum((sums[k, *index] * terms[k] for k in range(size)), start=expression(0.0)) for index in rest}
        return [1 / sums[()]]

    program = trace(formula, [axis.name for axis in axes], coefficients.ravel().tolist())
    return Scale(RECIPROCAL, "polynomial", program)


def evaluate(scale: Scale | None, values: Floats) -> Floats:
    """Return the factors at parameter sets ``(n, axes)``, shape ``(n, outputs)``, in their dtype; ones where there are none.

    >>> evaluate(None, np.zeros((2, 1))).tolist()
    [[1.0], [1.0]]
    """
    if scale is None:
        return np.ones((len(values), 1), dtype=values.dtype)
    found = scale.program.run([np.ascontiguousarray(values[:, i]) for i in range(values.shape[1])])
    return np.stack([np.broadcast_to(one, len(values)) for one in found], axis=1)


def bytes_of_factor(scale: Scale | None, itemsize: int, *, packed: bool) -> int:
    """Return the size of what an evaluation of the factor reads, the numbers that stand in a closed form included.

    Packed tables keep numbers of a closed form that have few digits in two bytes.

    >>> bytes_of_factor(None, 4, packed=False)
    0
    """
    if scale is None:
        return 0
    program = scale.program
    if scale.kind != CLOSED_FORM:
        return itemsize * len(program.constants)
    numbers = [*program.constants, *program.literals]
    return bytes_of_numbers(numbers, itemsize) if packed else itemsize * len(numbers)
