"""What the C evaluator reads of a table: sizes, numbers, and lists that it expands to unrolled code."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from skylight_sh import __version__
from skylight_sh.export.evaluators import commented, filled
from skylight_sh.formula.expression import composed, with_derivatives
from skylight_sh.formula.harmonics import HORIZONTAL
from skylight_sh.formula.printers import C_DOUBLE, C_SINGLE, Language
from skylight_sh.formula.printers import double as exact
from skylight_sh.formula.printers import single as rounded
from skylight_sh.runtime import Packed, Program, Rows, Table
from skylight_sh.sphere import lower_hemisphere
from skylight_sh.table import twilight
from skylight_sh.table.row_layout import layout
from skylight_sh.table.surroundings import PARTS
from skylight_sh.table.table import float32_limits

P = "SKYLIGHT_SH"
_p = "skylight_sh"
_FOUR = 4
# An even ground's radiance for an albedo of 1 is this times the weight l = 1, m = 0 of the sky.
_REFLECTED = HORIZONTAL / np.pi


def single(value: float) -> str:
    """Return a float of C."""
    return rounded(value) + "f"


def is_double(table: Table) -> bool:
    """Say whether a table's arithmetic is in double precision."""
    return table.dtype == np.float64


def language(table: Table) -> Language:
    """Return how the table's own arithmetic is printed."""
    return C_DOUBLE if is_double(table) else C_SINGLE


def room(degree: int) -> int:
    """Return how many functions of the first axis have a place: loops over them run in fours."""
    return -(-(degree + 1) // _FOUR) * _FOUR


def features(table: Table) -> set[str]:
    """Return what this table needs of the evaluator."""
    spec, around = table.spec, table.surroundings
    lit = around is not None
    grounded = spec.ground == "black" and not spec.windowed and spec.quantity == "radiance" and not lit and table.bands > 1
    found = {
        "HAS_ROWS": isinstance(table.body, Rows),
        "IS_MIRRORED": spec.mirrored,
        "IS_WINDOWED": spec.windowed,
        "HAS_TWILIGHT": spec.twilight is not None,
        "HAS_SURROUNDINGS": lit,
        "HAS_TRANSFER": around is not None and around.transfer.size > 0,
        "HAS_LIGHTS": around is not None and around.own.size > 0,
        "HAS_GROUND": around is not None and around.below.size > 0,
        "HAS_DIRECTION": table.bands > 1,
        "TAKES_GROUND": grounded,
    }
    return {name for name, has in found.items() if has}


def facts(table: Table, unit: str, e_mean: float, e_max: float) -> Iterator[str]:
    """Yield the macros that a program may read."""
    number = language(table).number
    yield f'#define {P}_VERSION "{__version__}"'
    yield f"#define {P}_BANDS {table.bands}"
    yield f"#define {P}_WEIGHTS {table.bands**2}"
    yield f"#define {P}_CHANNELS {len(table.channels)}"
    yield f"#define {P}_AXES {len(table.axes)}"
    yield f'#define {P}_UNIT "{unit}"'
    yield f"#define {P}_E_MEAN {e_mean:.6e}"
    yield f"#define {P}_E_MAX {e_max:.6e}"
    for axis, (low, high) in zip(table.axes, table.ranges, strict=True):
        yield f"#define {P}_{axis.name.upper()}_MIN {number(low)}"
        yield f"#define {P}_{axis.name.upper()}_MAX {number(high)}"


def data(table: Table, luminance: Sequence[float]) -> Iterator[str]:
    """Yield the lines of macros and constants that the evaluator's parts read."""
    spec, number = table.spec, language(table).number
    sizes = [degree + 1 for degree in table.degrees]
    yield f"typedef {'double' if is_double(table) else 'float'} {_p}_real;"
    yield ""
    yield from commented("Functions of the first axis, in fours; products of the other axes' functions.")
    yield f"#define {P}_FIRST {room(table.degrees[0])}"
    yield f"#define {P}_OTHERS {int(np.prod(sizes[1:], dtype=int))}"
    yield f"#define {P}_SIZES {_braced(sizes)}"
    yield f"#define {P}_MOST {max(*sizes, room(table.degrees[0]))}"
    yield f"#define {P}_AZIMUTH {single(spec.azimuth or 0.0)}"
    if spec.twilight:
        yield from commented("The sun's axis, the horizon in two parts, how far below it the light has faded.")
        yield f"#define {P}_SUN {[axis.name for axis in table.axes].index(str(spec.peak_axis))}"
        yield f"#define {P}_HORIZON {number(twilight.BEGIN)}"
        yield f"#define {P}_HORIZON_REST {number(0.0 if is_double(table) else twilight.REST)}"
        yield f"#define {P}_DEPTH {exact(spec.twilight.depth)}"
    if table.bands > 1:
        yield from commented("The channels' luminance.")
        yield f"#define {P}_LUMINANCE {_braced(map(single, luminance or [1.0] * len(table.channels)))}"
    if "TAKES_GROUND" in features(table):
        yield from commented("What an even ground reflects of the weight l = 1, m = 0, and its own zonal weights.")
        yield f"#define {P}_REFLECTED {single(_REFLECTED)}"
        yield f"#define {P}_LOWER {_braced(map(single, lower_hemisphere(table.bands).tolist()))}"
    yield from _ranges(table)
    yield from _rows(table, table.body) if isinstance(table.body, Rows) else packed(table)
    for name in PARTS if table.surroundings else ():
        values = getattr(table.surroundings, name).ravel().tolist()
        if values:
            yield from _array(f"static const {_p}_real {_p}_{name}", map(number, values), len(values))


def functions_of(table: Table, axis: int, basis: Program) -> Program:
    """Return the program of an axis's value: its change of variable put into its ``basis``."""
    return composed(basis, [table.axes[axis].variable])


def slope_range(table: Table, axis: int, basis: Program) -> tuple[float, float]:
    """Return where the slopes of an axis's functions are finite: its range, or up to the last float32 inside."""
    program = with_derivatives(functions_of(table, axis, basis), [0])
    ends = (table.axes[axis].low, table.axes[axis].high)
    found = []
    for end, other in (ends, ends[::-1]):
        with np.errstate(all="ignore"):
            finite = all(np.isfinite(value).all() for value in program.run([np.array([end])]))
        inside = np.float32(end)
        while not finite and other != end and (inside - end) * (other - end) <= 0:
            inside = np.nextafter(inside, np.float32(other))
        found.append(end if finite else float(inside))
    return found[0], found[1]


def _ranges(table: Table) -> Iterator[str]:
    number = language(table).number
    inside, ends = float32_limits(table), [(axis.low, axis.high) for axis in table.axes]
    yield ""
    yield from commented("Of each axis: the first and last float that counts as inside, and its range.")
    yield f"static const float {_p}_inside[{P}_AXES][2] = {_braced(_braced(map(single, pair)) for pair in inside)};"
    yield f"static const {_p}_real {_p}_range[{P}_AXES][2] = {_braced(_braced(map(number, pair)) for pair in ends)};"


def _rows(table: Table, body: Rows) -> Iterator[str]:
    terms, width = body.rows.shape
    groups = -(-terms // _FOUR)
    starts = np.concatenate([[0], np.cumsum(body.lengths, dtype=int)])
    number = language(table).number
    yield ""
    yield from commented("Rows, in groups of four; a row's outputs, and those that the first 1, 2, .. bands take.")
    yield f"#define {P}_TERMS {terms}"
    yield f"#define {P}_GROUPS {groups}"
    yield f"#define {P}_WIDTH {width}"
    yield f"#define {P}_WIDTHS {_braced(layout(table.spec, table.bands).widths)}"
    yield from commented("Of each product of the other axes' functions: how many functions of the first axis it has.")
    yield f"#define {P}_LENGTHS {_braced(body.lengths.tolist())}"
    yield from commented("The same: the first product's rows; of each other that has any, first row, rows, place.")
    yield f"#define {P}_LEADING {int(body.lengths[0])}"
    kept = [(int(start), int(n), r) for r, (start, n) in enumerate(zip(starts, body.lengths, strict=False)) if n and r]
    yield from _list(f"#define {P}_PRODUCTS(PRODUCT)", [f"PRODUCT({start}, {n}, {r})" for start, n, r in kept])
    yield from commented("Where a row's outputs go: for each band, by channel, degree, order and column.")
    kinds = "ZONAL, ONE, FOUR" if table.spec.mirrored else "DEGREE"
    yield from _list(f"#define {P}_STORES(BAND, NOTHING, {kinds})", _stores(table))
    yield ""
    yield from commented("A row a term (functions of the other axes, then of the first): its coefficient for every output.")
    numbers = [number(c) for c in body.rows.ravel().tolist()] + [number(0.0)] * ((_FOUR * groups - terms) * width)
    yield from _array(f"static const {_p}_real {_p}_rows", numbers, len(numbers))


def _stores(table: Table) -> Iterator[str]:
    """Yield what is stored of each band: turned by the azimuth where m < 0 is not stored."""
    column = {place: k for k, place in enumerate(layout(table.spec, table.bands).places) if place}
    for l in range(table.bands):
        found = []
        for c in range(len(table.channels)):
            if (l, c, 0) not in column:
                found.append(f"NOTHING({c}, {l})")
            elif not table.spec.mirrored:
                found.append(f"DEGREE({c}, {l}, {column[l, c, -l]})")
            else:
                alone = (l + 1) % _FOUR
                found += [f"ZONAL({c}, {l}, {column[l, c, 0]})"] if alone else []
                found += [f"ONE({c}, {l}, {m}, {column[l, c, m]})" for m in range(1, alone)]
                found += [f"FOUR({c}, {l}, {m}, {column[l, c, m]})" for m in range(alone, l + 1, _FOUR)]
        yield f"BAND({l}, {' '.join(found)})"


def packed(table: Table) -> Iterator[str]:
    """Yield what is read of a packed table's body."""
    body = table.body
    if not isinstance(body, Packed):
        raise TypeError(f"A table of layout {body.kind!r} has no stream.")
    yield ""
    yield from commented(
        "Runs of numbers, one a product of the other axes' functions, and their profiles; what one step is worth."
    )
    yield f"#define {P}_RUNS {body.rest_profile.size}"
    yield f"#define {P}_RUN_PROFILE {_braced(body.rest_profile.tolist())}"
    yield f"#define {P}_CHANNEL_PROFILE {_braced(body.channel_profile.tolist())}"
    yield f"#define {P}_STEP {language(table).number(body.step)}"
    yield ""
    yield from commented("Whole numbers as Rice codes.")
    yield from _array(f"static const unsigned char {_p}_stream", map(str, body.stream), len(body.stream))


def _braced(items: Iterable[object]) -> str:
    return f"{{ {', '.join(map(str, items))} }}"


def _array(head: str, items: Iterable[str], count: int) -> Iterator[str]:
    yield f"{head}[{count}] = {{"
    yield from filled(items)
    yield "};"


def _list(head: str, items: Iterable[str]) -> Iterator[str]:
    """Yield a macro that lists something, an item a line."""
    lines = [head, *(f"    {item}" for item in items)]
    yield from (f"{line} \\" for line in lines[:-1])
    yield lines[-1]


def slope_ranges(table: Table, bases: Sequence[Program]) -> Iterator[str]:
    """Yield where slopes are taken: the ranges, in double."""
    ends = [slope_range(table, axis, basis) for axis, basis in enumerate(bases)]
    yield from commented("Of each axis: where its functions have slopes.")
    pairs = _braced(_braced(map(exact, pair)) for pair in ends)
    yield f"static const double {_p}_slope_range[{P}_AXES][2] = {pairs};"
