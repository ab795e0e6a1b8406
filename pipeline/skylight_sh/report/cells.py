"""Cells of a page's tables: how a value is shown, in one style, and by what it is sorted."""

from __future__ import annotations

import math
from dataclasses import dataclass

from skylight_sh.report.amounts import count, percent


@dataclass(frozen=True)
class Cell:
    """What is shown, and the number that it is sorted by; words are sorted as they are, by None."""

    text: str
    key: float | None = None

    @property
    def sort(self) -> str:
        """The number it is sorted by as an attribute has it.

        >>> Cell("1.5 %", 0.015).sort
        '0.015'
        """
        return "" if self.key is None else f"{self.key:.10g}"


def number(value: float) -> Cell:
    """Return a whole number, or one to three digits, with commas for thousands.

    >>> number(7997).text
    '7,997'
    """
    return Cell(count(value), value)


def fraction(value: float) -> Cell:
    """Return a fraction in per cent.

    >>> fraction(0.015)
    Cell(text='1.5 %', key=0.015)
    """
    return Cell(percent(value), value) if math.isfinite(value) else Cell("overflow", value)


def text(words: str) -> Cell:
    """Return words."""
    return Cell(words)
