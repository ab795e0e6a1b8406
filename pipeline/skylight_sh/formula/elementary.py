"""Elementary functions of generic numbers: computed for arrays, traced for expressions."""

from __future__ import annotations

from typing import Any

from skylight_sh.formula.expression import Expression
from skylight_sh.runtime import FUNCTIONS

# What formulas work on: an array, whose number type operators and the functions below keep, or an expression.
Number = Any


def log(x: Number) -> Number:
    """Return the natural logarithm.

    >>> float(log(1.0))
    0.0
    """
    return _apply("log", x)


def exp(x: Number) -> Number:
    """Return e to the power x.

    >>> exp(Expression("input")).operation
    'exp'
    """
    return _apply("exp", x)


def sin(x: Number) -> Number:
    """Return the sine of an angle in radians."""
    return _apply("sin", x)


def cos(x: Number) -> Number:
    """Return the cosine of an angle in radians."""
    return _apply("cos", x)


def sqrt(x: Number) -> Number:
    """Return the square root.

    >>> float(sqrt(9.0))
    3.0
    """
    return _apply("sqrt", x)


def cbrt(x: Number) -> Number:
    """Return the cube root of a number of at least 0.

    >>> float(cbrt(8.0))
    2.0
    """
    return _apply("cbrt", x)


def label(x: Number, name: str) -> Number:
    """Return ``x``, called ``name`` where code is printed.

    >>> label(Expression("input") + 1.0, "next").label, label(2.0, "two")
    ('next', 2.0)
    """
    if isinstance(x, Expression) and x.arguments:
        return Expression(x.operation, x.arguments, x.value, name)
    return x


def _apply(name: str, x: Number) -> Number:
    if isinstance(x, Expression):
        return Expression(name, (x,))
    return FUNCTIONS[name](x)
