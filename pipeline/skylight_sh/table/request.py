"""A table as it is asked for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

# How a table's numbers are laid out, and what for.
LAYOUTS: Mapping[str, str] = {
    "rows": "for speed",
    "packed": "whole numbers in the fewest bytes, for budgets or sizes and float32 alone",
}


@dataclass(frozen=True)
class Request:
    """One table of ``bands`` bands: the fewest bytes under a ``budget``, the least error within a ``size``, or ``degrees``.

    ``budget`` is a largest E_mean, ``size`` a number of bytes, ``degrees`` one an axis, every coefficient kept: one of them
    is given. ``layout`` is one of ``LAYOUTS``, ``dtype`` float32 or float64.
    """

    name: str
    bands: int
    dtype: str = "float32"
    layout: str = "rows"
    budget: float | None = None
    size: int | None = None
    degrees: tuple[int, ...] | None = None
