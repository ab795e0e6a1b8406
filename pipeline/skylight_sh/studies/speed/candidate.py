"""What is timed beside the tables: a header with the tables' API, how many bytes it reads, and how exact it is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from skylight_sh.fit.axis import Axis
from skylight_sh.formula import printers
from skylight_sh.formula.printers import C_SINGLE


@dataclass(frozen=True)
class Candidate:
    """Something with the tables' API: its header, bytes of constants, and the bands it returns.

    ``kind`` is what a page groups it under; ``rival_of`` names the table that it was made to be as exact as, if any.
    """

    header: str
    bytes: int
    bands: int
    kind: str
    rival_of: str | None = None


def parameters(axes: Sequence[Axis]) -> str:
    """Return the inputs in the tables' own order, as C declares them."""
    first, *rest = (axis.name for axis in axes)
    return ", ".join(f"float {name}" for name in (first, "sun_azimuth", *rest))


def variable(axis: Axis) -> dict[str, object]:
    """Return what a template needs of an axis: its ends, and its change of variable over the clamped value ``v``.

    >>> variable(Axis("height", 0.0, 2.0))["variable"]
    '(v - 0.0f) * 1.0f - 1.0f'
    """
    lines, (text,) = printers.statements(axis.specified.variable, C_SINGLE, ["v"])
    ends = {"low": C_SINGLE.number(axis.low), "high": C_SINGLE.number(axis.high)}
    return {"name": axis.name, "lines": lines, "variable": text, **ends}
