"""A table's formulas as C functions, printed from their programs; the gradient's with exact derivatives, in double."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from skylight_sh.export import c_data
from skylight_sh.export.evaluators import commented
from skylight_sh.formula import printers
from skylight_sh.formula.azimuth import TURN, waves_of_turn
from skylight_sh.formula.bases import BASES
from skylight_sh.formula.expression import with_derivatives
from skylight_sh.formula.printers import C_DOUBLE, C_FOUR, C_SINGLE, C_SUNS, Language
from skylight_sh.formula.side_by_side import side_by_side
from skylight_sh.formula.sine import QUARTER, SHORT_END, SHORT_SINE, SINE
from skylight_sh.formula.window import SINC
from skylight_sh.runtime import Packed, Program, Table
from skylight_sh.table.prefactor import CLOSED_FORM
from skylight_sh.table.short_numbers import short

P, _p = c_data.P, "skylight_sh"
_FOUR = 4


def functions(table: Table) -> Iterator[str]:
    """Yield the functions that every evaluation calls."""
    language, real = c_data.language(table), f"{_p}_real"
    x = [f"x[{axis}]" for axis in range(len(table.axes))]
    yield from commented(f"What all weights share: {_about(table)}.")
    shorts: list[int] = []
    factors = list(_factors(table, _with_shorts(language, shorts) if _keeps_shorts(table) else language, x))
    if shorts:
        yield f"static const unsigned short {_p}_short[{len(shorts)}] = {{ {', '.join(map(str, shorts))} }};"
        yield ""
    yield from factors
    yield from _of_sums(table, language, real, "")
    if not c_data.is_double(table):
        yield from commented("Cosine and sine of an angle of at most an eighth of a turn.")
        yield from _function(f"void {_p}_quarter({real} angle, {real} *out)", _quarter(language))
    if "HAS_WIDE" in c_data.features(table):
        yield f"#ifdef {P}_LANES"
        yield from commented("The same for suns side by side.")
        yield from _wide_functions(table, x)
        yield f"#endif /* {P}_LANES */"
        yield ""
    if not table.spec.mirrored:
        yield from commented("The weights of orders m and -m turned by the azimuth (Habel et al. 2008, eq. 4).")
        found, results = printers.statements(TURN, language, ["plus", "minus", "cosine", "sine"])
        lines = [*found, *(f"*{o} = (float)({r});" for o, r in zip(("turned", "partner"), results, strict=True))]
        head = f"{real} plus, {real} minus, {real} cosine, {real} sine, float *turned, float *partner"
        yield from _function(f"void {_p}_turn({head})", lines)
    yield from commented("The zonal window's factor for the degree `share` * bands (Habel et al. 2008, eq. 5).")
    yield from _function(f"float {_p}_sinc(float share)", _returning(SINC, C_SINGLE, ["share"]))
    if table.spec.twilight:
        yield from commented("The share of the horizon's light at the sun's depth below it, 0 to 1.")
        lines = _returning(table.spec.twilight.program, language, ["depth"])
        yield from _function(f"{real} {_p}_fade({real} depth)", lines)


def _of_sums(table: Table, language: Language, real: str, suffix: str) -> Iterator[str]:
    """Yield the functions of the axes, the waves of the azimuth and the sine; ``suffix`` tells those of many suns."""
    yield from commented(f"The functions of {_axis(table, 0)}; 0 where there is none.")
    yield from _function(f"void {_p}_first{suffix}(const {real} *x, {real} *out)", _first(table, language))
    others = ", ".join(_axis(table, axis) for axis in range(1, len(table.axes)))
    yield from commented(f"All products of the functions of {others or 'no other axis'}.")
    yield from _function(f"void {_p}_others{suffix}(const {real} *x, {real} *out)", _others(table, language, real))
    yield from commented("cos(m azimuth) and sin(m azimuth), m < bands, each times the m-th power of `radius`, by doubling.")
    targets = [f"{name}[{m}]" for name in ("cosines", "sines") for m in range(table.bands)]
    turn = ["cosine", "sine", "radius"]
    lines = printers.assignments(waves_of_turn(table.bands), language, turn, targets)
    lines += [f"(void){name};" for name in turn] if table.bands == 1 else []
    given = ", ".join(f"{real} {name}" for name in turn)
    yield from _function(f"void {_p}_waves{suffix}({given}, {real} *cosines, {real} *sines)", lines)
    if table.spec.parity:
        yield from commented("The sine of the sun's zenith angle, whose powers the sums of order m lack.")
        peak = f"x[{P}_SUN]"
        yield from _function(f"{real} {_p}_sine{suffix}(const {real} *x)", _returning(_sine(table), language, [peak]))


def _wide_functions(table: Table, x: Sequence[str]) -> Iterator[str]:
    """Yield the same functions of vectors of suns."""
    real = f"{_p}_lanes"
    programs = [*(axis.variable for axis in table.axes), *([table.spec.scale.program] if table.spec.scale else [])]
    called = sorted({str(step[0]) for program in programs for step in program.steps} & set(C_SUNS.functions))
    for name in called:
        yield from _function(
            f"{real} {_p}_{name}_suns({real} v)",
            ["int s;", f"for (s = 0; s < {P}_LANES; ++s) v[s] = {name}f(v[s]);", "return v;"],
        )
    yield from _function(f"void {_p}_factors_suns(const {real} *x, {real} *out)", _factor_lines(table, C_SUNS, x))
    yield from _of_sums(table, C_SUNS, real, "_suns")
    yield from _function(f"void {_p}_quarter_suns({real} angle, {real} *out)", _quarter(C_SUNS))


def _quarter(language: Language) -> list[str]:
    return printers.assignments(QUARTER, language, ["angle"], ["out[0]", "out[1]"])


def _factors(table: Table, language: Language, x: Sequence[str]) -> Iterator[str]:
    """Yield the function of what multiplies sums: where there are classes, with vectors where the compiler has them."""
    head = f"void {_p}_factors(const {_p}_real *x, {_p}_real *out)"
    scale = table.spec.scale
    if scale is None or not c_data.is_mixed(table) or c_data.is_double(table):
        yield from _function(head, _factor_lines(table, language, x))
        return
    places = c_data.factor_places(table)
    channels = len(table.channels)
    fours = [
        [[k + table.spec.classes * channel for channel in range(channels)][i : i + _FOUR] for i in range(0, channels, _FOUR)]
        for k in range(table.spec.classes)
    ]
    groups = [four for of_class in fours for four in of_class]
    targets = [f"out + {places[group[0]]}" for group in groups]
    vectors = replace(language, vectors=C_FOUR.vectors)
    lines = printers.assignments(side_by_side(scale.program, groups), vectors, x, targets)
    yield f"#ifdef {P}_LANES"
    yield from commented("Equal formulas of different numbers side by side.")
    yield from _function(head, [*lines, "(void)x;"])
    yield "#else"
    yield from _function(head, _factor_lines(table, language, x))
    yield f"#endif /* {P}_LANES */"
    yield ""


def _factor_lines(table: Table, language: Language, x: Sequence[str]) -> list[str]:
    """Return the statements that fill ``out``, with 0 where no channel has a place."""
    if not table.spec.scale:
        return [_filled(language, "out[0]", 1), "(void)x;"]
    places = c_data.factor_places(table)
    empty = sorted(set(range(c_data.factors(table))) - set(places))
    lines = printers.assignments(table.spec.scale.program, language, x, [f"out[{place}]" for place in places])
    return [*lines, *(_filled(language, f"out[{place}]", 0) for place in empty), "(void)x;"]


def _filled(language: Language, target: str, value: int) -> str:
    """Return the statement that gives ``target`` a whole number."""
    return f"{target} = {language.vectors.spread.format(x=value) if language.vectors else value};"


def _keeps_shorts(table: Table) -> bool:
    """Say whether a closed form's numbers of few digits stand in two bytes: those of packed tables."""
    scale = table.spec.scale
    return isinstance(table.body, Packed) and scale is not None and scale.kind == CLOSED_FORM


def _with_shorts(language: Language, shorts: list[int]) -> Language:
    """Return ``language`` with numbers of few digits read from an array of whole numbers, which ``shorts`` collects."""

    def number(value: float) -> str:
        found = short(value)
        if found is None:
            return language.number(value)
        whole, power = abs(found[0]), found[1]
        if whole not in shorts:
            shorts.append(whole)
        text = f"{_p}_short[{shorts.index(whole)}]"
        text = f"{language.number(10.0**-power)} * {text}" if power else f"({_p}_real){text}"
        return f"({'-' if found[0] < 0 else ''}{text})"

    return replace(language, number=number)


def slopes(table: Table) -> Iterator[str]:
    """Yield what the gradient reads: functions with their slopes."""
    bases = [_basis(table, axis) for axis in range(len(table.axes))]
    yield from c_data.slope_ranges(table, bases)
    yield ""
    yield from commented("The functions of an axis at v, and their slopes.")
    lines = []
    for axis, basis in enumerate(bases):
        program = with_derivatives(c_data.functions_of(table, axis, basis), [0])
        size = len(basis.outputs)
        targets = [f"{name}[{k}]" for name in ("out", "slopes") for k in range(size)]
        lines.append(f"if (axis == {axis}) {{")
        lines += [f"    {line}" for line in printers.assignments(program, C_DOUBLE, ["v"], targets)]
        lines.append("}")
    lines.append("(void)v;")
    yield from _function(f"void {_p}_functions(int axis, double v, double *out, double *slopes)", lines)
    yield from commented("The factors, then their slopes after each axis.")
    count, places = c_data.factors(table), c_data.factor_places(table)
    if table.spec.scale:
        axes = range(len(table.axes))
        program = with_derivatives(table.spec.scale.program, list(axes))
        targets = [f"out[{block * count + place}]" for block in range(1 + len(axes)) for place in places]
        # A constant factor reads no axis.
        lines = [*printers.assignments(program, C_DOUBLE, [f"x[{axis}]" for axis in axes], targets), "(void)x;"]
    else:
        lines = ["(void)x;", *(f"out[{k}] = {float(k == 0)};" for k in range(1 + len(table.axes)))]
    yield from _function(f"void {_p}_factor_slopes(const double *x, double *out)", lines)
    if table.spec.parity:
        yield from commented("The sine of the sun's zenith angle, then its slope.")
        lines = printers.assignments(with_derivatives(SINE, [0]), C_DOUBLE, [f"x[{P}_SUN]"], ["out[0]", "out[1]"])
        yield from _function(f"void {_p}_sine_slope(const double *x, double *out)", lines)
    if table.spec.twilight:
        yield from commented("The fade, then its slope.")
        program = with_derivatives(table.spec.twilight.program, [0])
        lines = printers.assignments(program, C_DOUBLE, ["depth"], ["out[0]", "out[1]"])
        yield from _function(f"void {_p}_fade_slope(double depth, double *out)", lines)


def _sine(table: Table) -> Program:
    """Return the sine of the peak's zenith angle as a table's own arithmetic takes it."""
    peak = next(axis for axis in table.axes if axis.name == table.spec.peak_axis)
    short = not c_data.is_double(table) and peak.low >= -SHORT_END and peak.high <= SHORT_END
    return SHORT_SINE if short else SINE


def _about(table: Table) -> str:
    scale = table.spec.scale
    if not scale:
        return "nothing"
    return f"the closed form {scale.name}" if scale.kind == CLOSED_FORM else "1 over a polynomial in the same variables"


def _axis(table: Table, axis: int) -> str:
    return f"{table.axes[axis].name} (change of variable: {table.axes[axis].map})"


def _basis(table: Table, axis: int) -> Program:
    return BASES[table.spec.basis].program(table.degrees[axis], shallow=True)


def _first(table: Table, language: Language) -> list[str]:
    program = c_data.functions_of(table, 0, _basis(table, 0))
    size = len(program.outputs)
    lines = printers.assignments(program, language, ["x[0]"], [f"out[{k}]" for k in range(size)])
    empty = range(size, c_data.room(size - 1))
    return [*lines, *(_filled(language, f"out[{k}]", 0) for k in empty), "(void)x;"]


def _others(table: Table, language: Language, real: str) -> list[str]:
    """Return the lines that fill all products of the other axes' functions, the last axis's fastest."""
    names = [axis.name for axis in table.axes[1:]]
    if not names:
        return [_filled(language, "out[0]", 1), "(void)x;"]
    lines: list[str] = []
    arrays = ["out"] if len(names) == 1 else [f"{name}_terms" for name in names]
    for axis, array in enumerate(arrays, start=1):
        program = c_data.functions_of(table, axis, _basis(table, axis))
        size = len(program.outputs)
        found = printers.assignments(program, language, [f"x[{axis}]"], [f"{array}[{k}]" for k in range(size)])
        if len(names) == 1:
            return [*found, "(void)x;"]
        lines += [f"{real} {array}[{size}];", "{", *(f"    {line}" for line in found), "}"]
    places = [f"of_{name}" for name in names]
    lines += [f"int {', '.join(places)};"]
    for place, degree in zip(places, table.degrees[1:], strict=True):
        lines.append(f"for ({place} = 0; {place} < {degree + 1}; ++{place})")
    product = " * ".join(f"{array}[{place}]" for array, place in zip(arrays, places, strict=True))
    return [*lines, f"    *out++ = {product};", "(void)x;"]


def _returning(program: Program, language: Language, inputs: Sequence[str]) -> list[str]:
    """Return the statements of a function of one result."""
    lines, results = printers.statements(program, language, inputs)
    return [*lines, f"return {results[0]};"]


def _function(head: str, lines: Sequence[str]) -> Iterator[str]:
    yield f"static inline {head}"
    yield "{"
    yield from (f"    {line}" for line in lines)
    yield "}"
    yield ""
