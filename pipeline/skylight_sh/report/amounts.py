"""Amounts as people read them: per cent, counts and times, in one style."""

from __future__ import annotations

import numpy as np


def percent(value: float) -> str:
    """Return a fraction as per cent to three digits, never in exponents, with commas for thousands.

    >>> percent(0.000965), percent(12.345)
    ('0.0965 %', '1,230 %')
    """
    return f"{plain(100 * value)} %"


def plain(value: float, digits: int = 3) -> str:
    """Return a number to so many digits, never in exponents, with commas for thousands.

    >>> [plain(v) for v in (-100.0, 0.0, 1e-7, 131712.0)], plain(2.5, 2)
    (['-100', '0', '0.0000001', '132,000'], '2.5')
    """
    rounded = float(f"{value:.{digits}g}")
    if abs(rounded) >= 1000:
        return f"{rounded:,.0f}"
    return str(np.format_float_positional(rounded, trim="-"))


def count(value: float) -> str:
    """Return a count with commas for thousands; what is no whole number to three digits.

    >>> count(131712), count(90.1)
    ('131,712', '90.1')
    """
    return f"{value:,.0f}" if float(value).is_integer() else plain(value)


def nanoseconds(value: float) -> str:
    """Return a time in nanoseconds in the unit that suits it.

    >>> nanoseconds(145.0), nanoseconds(6870.0)
    ('145 ns', '6.87 µs')
    """
    return f"{plain(value)} ns" if value < 1000 else f"{plain(value / 1000)} µs"
