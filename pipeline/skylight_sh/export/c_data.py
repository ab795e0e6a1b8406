"""What the C evaluator reads of a table: sizes, numbers, and lists that it expands to unrolled code."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import isqrt

import numpy as np
from numpy.typing import NDArray

from skylight_sh import __version__
from skylight_sh.export.evaluators import commented, filled
from skylight_sh.formula.expression import composed, with_derivatives
from skylight_sh.formula.harmonics import HORIZONTAL
from skylight_sh.formula.printers import C_DOUBLE, C_SINGLE, Language
from skylight_sh.formula.printers import double as exact
from skylight_sh.formula.printers import single as rounded
from skylight_sh.runtime import ClassRows, Packed, Program, Table, unpack
from skylight_sh.sphere import lower_hemisphere
from skylight_sh.table import twilight
from skylight_sh.table.packed import lengths_of as lengths_of_runs
from skylight_sh.table.powers import POWERS
from skylight_sh.table.surroundings import PARTS
from skylight_sh.table.table import float32_limits

P = "SKYLIGHT_SH"
_p = "skylight_sh"
_FOUR = 4
# Numbers of the widest vectors that the evaluator reads rows in.
_WIDEST = 16
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


def is_mixed(table: Table) -> bool:
    """Say whether a channel's weights are made of the sums of several classes."""
    return table.spec.scale is not None and len(table.spec.scale.program.outputs) > 1


def room(degree: int) -> int:
    """Return how many functions of the first axis have a place: loops over them run in fours."""
    return -(-(degree + 1) // _FOUR) * _FOUR


def features(table: Table) -> set[str]:
    """Return what this table needs of the evaluator."""
    spec, around = table.spec, table.surroundings
    lit = around is not None
    powers = isinstance(table.body, ClassRows) and spec.basis == POWERS
    grounded = spec.ground == "black" and not spec.windowed and spec.quantity == "radiance" and not lit and table.bands > 1
    found = {
        "HAS_ROWS": isinstance(table.body, ClassRows),
        "HAS_WIDE": spec.mirrored and powers and not is_double(table) and not lit and table.bands > 1,
        "HAS_PARITY": spec.parity,
        "HAS_POWERS": powers,
        "IS_MIRRORED": spec.mirrored,
        "IS_MIXED": is_mixed(table),
        "IS_SINGLE": not is_double(table),
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
    if isinstance(table.body, Packed):
        yield unpacked(table)
    for axis, (low, high) in zip(table.axes, table.ranges, strict=True):
        yield f"#define {P}_{axis.name.upper()}_MIN {number(low)}"
        yield f"#define {P}_{axis.name.upper()}_MAX {number(high)}"


def unpacked(table: Table) -> str:
    """Return the macro of how many numbers a packed table has once it is unpacked."""
    width = int(columns_of(table).max()) + 1
    return f"#define {P}_UNPACKED {int(lengths_of(table).sum()) * width + -width % _WIDEST}"


def data(table: Table, luminance: Sequence[float]) -> Iterator[str]:
    """Yield the lines of macros and constants that the evaluator's parts read."""
    spec, number = table.spec, language(table).number
    sizes = [degree + 1 for degree in table.degrees]
    yield f"typedef {'double' if is_double(table) else 'float'} {_p}_real;"
    yield ""
    yield from commented("Functions of the first axis, in fours; products of the other axes' functions.")
    yield f"#define {P}_FIRST {room(table.degrees[0])}"
    yield f"#define {P}_OTHERS {others(table)}"
    yield f"#define {P}_SIZES {_braced(sizes)}"
    yield f"#define {P}_MOST {max(*sizes, room(table.degrees[0]))}"
    yield f"#define {P}_AZIMUTH {single(spec.azimuth or 0.0)}"
    if spec.twilight or spec.parity:
        yield from commented("The axis of the sun's zenith angle.")
        yield f"#define {P}_SUN {[axis.name for axis in table.axes].index(str(spec.peak_axis))}"
    if spec.twilight:
        yield from commented("The horizon in two parts, and how far below it the light has faded.")
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
    yield from _sums(table)
    yield from _rows(table.body) if isinstance(table.body, ClassRows) else packed(table)
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


def lengths_of(table: Table) -> NDArray[np.int64]:
    """Return how many functions of the first axis each class has for each product of the others', ``(classes, others)``.

    Of a packed table, whose weights each have their own, the longest: those of its rows once it is unpacked.
    """
    body = table.body
    if not isinstance(body, Packed):
        return np.asarray(body.lengths, dtype=np.int64)
    found = lengths_of_runs(unpack(body, table.places)).max(axis=0)
    return np.pad(found, ((0, 0), (0, others(table) - found.shape[1])))


def columns_of(table: Table) -> NDArray[np.int64]:
    """Return the column of each stored weight among a class's sums, or -1: a packed table has one for each."""
    if isinstance(table.body, Packed):
        return np.arange(table.places.size)
    return np.asarray(table.body.columns, dtype=np.int64)


def others(table: Table) -> int:
    """Return how many products the other axes' functions have."""
    return int(np.prod([degree + 1 for degree in table.degrees[1:]], dtype=int))


def factors(table: Table) -> int:
    """Return how many factors sums have: one, or a class's of each channel, in fours."""
    return table.spec.classes * _channels(table) if is_mixed(table) else 1


def factor_places(table: Table) -> list[int]:
    """Return where the outputs of the factors' program stand: class by class, the channels side by side."""
    if not is_mixed(table):
        return [0]
    return [k * _channels(table) + channel for channel in range(len(table.channels)) for k in range(table.spec.classes)]


def _channels(table: Table) -> int:
    return -(-len(table.channels) // _FOUR) * _FOUR


def _sums(table: Table) -> Iterator[str]:
    """Yield the sizes of sums and rows, and where a class's sums go."""
    lengths, column = lengths_of(table), columns_of(table)
    degrees = np.sqrt(table.places).astype(int)
    width = int(column.max()) + 1
    terms = lengths.sum(axis=1)
    # Of each class the first product is aligned: the last store of the class before may run over its end.
    rooms = -(-terms // _FOUR) * _FOUR
    places = np.cumsum(rooms) - rooms
    yield ""
    yield from commented(
        "Classes; a row's numbers, one a sum, and those of the first 1, 2, .. bands; room for a class's sums."
    )
    yield f"#define {P}_CLASSES {table.spec.classes}"
    every = " ".join(f"CLASS({k})" for k in range(table.spec.classes))
    yield f"#define {P}_ALL_CLASSES(CLASS) {every}"
    yield from commented("What multiplies the sum of a class for a channel; the channels side by side, in fours.")
    yield f"#define {P}_FACTORS {factors(table)}"
    yield f"#define {P}_FACTOR(channel, class_) ({'(class_) * ' + str(_channels(table)) + ' + (channel)'})"
    yield f"#define {P}_WIDTH {width}"
    yield f"#define {P}_WIDTHS {_braced(int(np.sum((column >= 0) & (degrees < n))) for n in range(1, table.bands + 1))}"
    yield f"#define {P}_ROOM {-(-width // _WIDEST) * _WIDEST}"
    yield from commented("All rows; of each class the first row, how many, and the place of its first product.")
    yield f"#define {P}_TERMS {int(terms.sum())}"
    yield f"#define {P}_STARTS {_braced((np.cumsum(terms) - terms).tolist())}"
    yield f"#define {P}_COUNTS {_braced(terms.tolist())}"
    yield f"#define {P}_PLACES {_braced(places.tolist())}"
    yield f"#define {P}_PRODUCTS_ROOM {int(rooms.sum()) + _FOUR}"
    yield from commented(
        "Of each class and product of the other axes' functions: how many functions of the first axis it has."
    )
    yield f"#define {P}_LENGTHS {_braced(map(_braced, lengths.tolist()))}"
    yield from commented(
        "The same: of each that has any, class, place of the first product, how many, the other axes' product."
    )
    starts = places[:, np.newaxis] + np.cumsum(lengths, axis=1) - lengths
    kept = [(k, int(starts[k, r]), int(lengths[k, r]), r) for k, r in np.ndindex(*lengths.shape) if lengths[k, r]]
    yield from _list(f"#define {P}_PRODUCTS(PRODUCT)", [f"PRODUCT({k}, {start}, {n}, {r})" for k, start, n, r in kept])
    if "HAS_POWERS" in features(table):
        yield from commented("The same: of each class the first row of each polynomial, its rows, the other axes' product.")
        first = np.concatenate([[0], np.cumsum(lengths)[:-1]]).reshape(lengths.shape)
        classes = [
            [f"POLYNOMIAL({first[k, r]}, {lengths[k, r]}, {r})" for r in range(lengths.shape[1]) if lengths[k, r]]
            for k in range(len(lengths))
        ]
        found = [f"CLASS({k}, NOTHING {' '.join(one)})" for k, one in enumerate(classes)]
        yield from _list(f"#define {P}_POLYNOMIALS(CLASS, NOTHING, POLYNOMIAL)", found)
        yield from commented("Of each class the longest polynomial's rows, and how many those of the classes before have.")
        longest = lengths.max(axis=1)
        yield f"#define {P}_LONGEST {_braced(longest.tolist())}"
        yield f"#define {P}_BEFORE {_braced((np.cumsum(longest) - longest).tolist())}"
        yield f"#define {P}_SHARED {int(longest.sum())}"
    yield from _places(table, column)


def _places(table: Table, column: NDArray[np.int64]) -> Iterator[str]:
    """Yield where a class's sums go."""
    first = {isqrt(place): int(k) for place, k in reversed(list(zip(table.places.tolist(), column.tolist(), strict=True)))}
    yield from commented("Where sums go: of each degree, the first column, or -1 where it carries nothing.")
    yield f"#define {P}_COLUMNS {_braced(first[l] for l in range(table.bands))}"
    if table.spec.mirrored and table.bands >= _FOUR:
        yield from commented("The same for vectors of four: places, two vectors of sums and the numbers of both, order.")
        yield f"#define {P}_FOURS {-(-int(column.max() + 1) // _FOUR)}"
        yield from _list(
            f"#define {P}_STORES(BAND, NOTHING, MINUS, PLUS)",
            [_band(l, first[l], int(column.max())) for l in range(table.bands)],
        )


def _band(l: int, column: int, last: int) -> str:
    """Return what is stored of degree ``l``, whose order 0 has ``column``; ``last`` is the last column."""
    if column < 0:
        return f"BAND({l}, NOTHING({l * l}, {2 * l + 1}))"

    def four(kind: str, place: int, start: int, step: int) -> str:
        # What has no column, or not this degree's, is overwritten.
        found = [min(max(column + start + step * k, 0), last) for k in range(_FOUR)]
        q = min(found) // _FOUR
        r = max(found) // _FOUR
        picked = ", ".join(str(c % _FOUR + (_FOUR if c // _FOUR > q else 0)) for c in found)
        return f"{kind}({place}, {q}, {r}, {picked}, {start})"

    def starts(count: int) -> list[int]:
        # The last four of many may overlap those before.
        return sorted({*range(0, max(count - _FOUR, 0), _FOUR), max(count - _FOUR, 0)}) if count else []

    minus = [four("MINUS", l * l + k, l - k, -1) for k in starts(l)]
    plus = [four("PLUS", l * (l + 1) + k, k, 1) for k in starts(l + 1)]
    return f"BAND({l}, {' '.join(minus + plus)})"


def _rows(body: ClassRows) -> Iterator[str]:
    width = body.rows.shape[1]
    number = exact if body.rows.dtype == np.float64 else single
    yield ""
    yield from commented(
        "Of each class, a row a term (functions of the other axes, then of the first): its number for every sum."
    )
    numbers = [number(c) for c in body.rows.ravel().tolist()]
    # The last row is read in vectors of as many numbers as a compiler has.
    numbers += [number(0.0)] * (-width % _WIDEST)
    yield f"{P}_ALIGNED"
    yield from _array(f"static const {_p}_real {_p}_rows", numbers, len(numbers))


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
    yield f"#define {P}_CLASS_PROFILE {_braced(body.channel_profile.tolist())}"
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
