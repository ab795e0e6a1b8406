"""A table as it is asked for."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Request:
    """One table of ``bands`` bands: the fewest bytes under a ``budget``, the least error within a ``size``, or ``degrees``.

    ``budget`` is a largest E_mean, ``size`` a number of bytes, ``degrees`` one an axis, every coefficient kept: one of them
    is given. ``layout`` is ``rows`` (for speed) or ``packed`` (for size), ``dtype`` float32 or float64.
    """

    name: str
    bands: int
    dtype: str = "float32"
    layout: str = "rows"
    budget: float | None = None
    size: int | None = None
    degrees: tuple[int, ...] | None = None
