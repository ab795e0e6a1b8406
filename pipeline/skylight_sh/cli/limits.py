"""Limits on a command line: sizes, times and errors as people write them, with their units."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import TypeVar

import click

Amount = TypeVar("Amount")

_NUMBER = re.compile(r"\s*(\d+(?:,\d{3})*(?:\.\d*)?|\.\d+)(e[+-]?\d+)?\s*([^\d\s]*)\s*", re.IGNORECASE)
_BYTES = {"": 1, "b": 1, "bytes": 1, "kb": 1e3, "mb": 1e6}
_NANOSECONDS = {"": 1, "ns": 1, "us": 1e3, "µs": 1e3, "μs": 1e3, "ms": 1e6}
_FRACTIONS = {"": 1, "%": 0.01}


def _amount(text: str, units: Mapping[str, float]) -> float | None:
    """Return the number that a text says, in the unit of 1; None where it says none."""
    found = _NUMBER.fullmatch(text)
    unit = found[3].lower() if found else ""
    if not found or unit not in units:
        return None
    # Units are powers of ten: told to 12 digits, 0.1 % is 0.001.
    return float(f"{float(found[1].replace(',', '') + (found[2] or '')) * units[unit]:.12g}")


def size(text: str) -> int | None:
    """Return a size in bytes; None unless it is a whole number of bytes from 1 to a billion. KB are 1,000 bytes.

    >>> size("2000"), size("2KB"), size("1.5 kB"), size("2KiB")
    (2000, 2000, 1500, None)
    """
    found = _amount(text, _BYTES)
    return int(found) if found is not None and found.is_integer() and 1 <= found <= 1e9 else None


def time(text: str) -> float | None:
    """Return a time in nanoseconds; None unless it is from 1 ns to a second.

    >>> time("200"), time("0.2us"), time("0")
    (200.0, 200.0, None)
    """
    found = _amount(text, _NANOSECONDS)
    return found if found is not None and 1 <= found <= 1e9 else None


def error(text: str) -> float | None:
    """Return an error as a fraction; None unless it is above 0 and at most 1.

    >>> error("0.1%"), error("0.001"), error("5")
    (0.001, 0.001, None)
    """
    found = _amount(text, _FRACTIONS)
    return found if found is not None and 0 < found <= 1 else None


def callback(
    read: Callable[[str], Amount | None], allowed: str
) -> Callable[[click.Context, click.Parameter, str | None], Amount | None]:
    """Return what reads an option's text with ``read``, and tells what is ``allowed`` where that gives None."""

    def called(context: click.Context, parameter: click.Parameter, text: str | None) -> Amount | None:
        found = None if text is None else read(text)
        if text is not None and found is None:
            raise click.BadParameter(f"{text!r} is not {allowed}.", context, parameter)
        return found

    return called
