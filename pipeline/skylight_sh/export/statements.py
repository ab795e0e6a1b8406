"""What JavaScript and C# share of a table: its formulas as statements over arrays, its sizes and names."""

from __future__ import annotations

from collections.abc import Sequence
from math import isqrt

from skylight_sh.export.c_data import columns_of, functions_of
from skylight_sh.formula import printers
from skylight_sh.formula.azimuth import stretched_waves
from skylight_sh.formula.bases import BASES
from skylight_sh.formula.printers import Language
from skylight_sh.runtime import Program, Table


def of_axis(table: Table, axis: int, language: Language, array: str) -> list[str]:
    """Return the statements that fill ``array`` with the functions of an axis at ``x[axis]``."""
    program = functions_of(table, axis, BASES[table.spec.basis].program(table.degrees[axis], shallow=True))
    targets = [f"{array}[{k}]" for k in range(len(program.outputs))]
    return printers.assignments(program, language, [f"x[{axis}]"], targets)


def of_factors(table: Table, language: Language) -> list[str]:
    """Return the statements that fill ``to`` with the factor of all sums, or the matrix of channels and classes."""
    if not table.spec.scale:
        return ["to[0] = 1;"]
    program = table.spec.scale.program
    inputs, targets = (
        [f"{name}[{k}]" for k in range(n)] for name, n in (("x", len(table.axes)), ("to", len(program.outputs)))
    )
    return printers.assignments(program, language, inputs, targets)


def of_waves(bands: int, language: Language) -> list[str]:
    """Return the statements that fill ``cosines`` and ``sines`` of m ``azimuth``, each times ``radius`` to the power m."""
    targets = [f"{name}[{m}]" for name in ("cosines", "sines") for m in range(bands)]
    return printers.assignments(stretched_waves(bands), language, ["azimuth", "radius"], targets)


def returning(program: Program, language: Language, inputs: Sequence[str]) -> list[str]:
    """Return the statements of a function of one result."""
    lines, results = printers.statements(program, language, inputs)
    return [*lines, f"return {results[0]};"]


def carried(table: Table) -> list[int]:
    """Return the degrees that carry anything; their columns follow one another."""
    return sorted({isqrt(place) for place in table.places[columns_of(table) >= 0].tolist()})


def width(table: Table) -> int:
    """Return how many sums a class has."""
    return int(columns_of(table).max()) + 1


def inputs_of(table: Table) -> list[str]:
    """Return the names of the inputs in order: the first axis, the azimuth unless the table fixes it, the other axes."""
    first, *rest = (axis.name for axis in table.axes)
    return [first, *([] if table.spec.azimuth is not None else ["sun_azimuth"]), *rest]


def peak_of(table: Table) -> int:
    """Return the place of the axis whose sine the sums of order m lack m times, or -1."""
    return [axis.name for axis in table.axes].index(str(table.spec.peak_axis)) if table.spec.parity else -1
