"""A table's formulas as C functions, printed from their programs; the gradient's with exact derivatives, in double."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from skylight_sh.export import c_data
from skylight_sh.export.evaluators import commented
from skylight_sh.formula import printers
from skylight_sh.formula.azimuth import TURN, stretched_waves
from skylight_sh.formula.bases import BASES
from skylight_sh.formula.expression import with_derivatives
from skylight_sh.formula.halves import halves
from skylight_sh.formula.printers import C_DOUBLE, C_SINGLE, Language
from skylight_sh.formula.sine import SHORT_END, SHORT_SINE, SINE
from skylight_sh.formula.window import SINC
from skylight_sh.runtime import Packed, Program, Table
from skylight_sh.table.prefactor import CLOSED_FORM
from skylight_sh.table.short_numbers import short

P, _p = c_data.P, "skylight_sh"


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
    yield from commented(f"The functions of {_axis(table, 0)}; 0 where there is none.")
    yield from _function(f"void {_p}_first(const {real} *x, {real} *out)", _first(table, language))
    others = ", ".join(_axis(table, axis) for axis in range(1, len(x)))
    yield from commented(f"All products of the functions of {others or 'no other axis'}.")
    yield from _function(f"void {_p}_others(const {real} *x, {real} *out)", _others(table, language))
    yield from commented("cos(m azimuth) and sin(m azimuth), m < bands, each times the m-th power of `radius`, by doubling.")
    targets = [f"{name}[{m}]" for name in ("cosines", "sines") for m in range(table.bands)]
    lines = printers.assignments(stretched_waves(table.bands), language, ["azimuth", "radius"], targets)
    lines += ["(void)azimuth;", "(void)radius;"] if table.bands == 1 else []
    yield from _function(f"void {_p}_waves({real} azimuth, {real} radius, {real} *cosines, {real} *sines)", lines)
    if table.spec.parity:
        yield from commented("The sine of the sun's zenith angle, whose powers the sums of order m lack.")
        peak = f"x[{P}_SUN]"
        yield from _function(f"{real} {_p}_sine(const {real} *x)", _returning(_sine(table), language, [peak]))
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


def _factors(table: Table, language: Language, x: Sequence[str]) -> Iterator[str]:
    """Yield the functions of what multiplies sums."""
    real, scale = f"{_p}_real", table.spec.scale
    if scale and c_data.is_mixed(table):
        early, rest = halves(scale.program)
        targets = [f"early[{k}]" for k in range(len(early.outputs))]
        yield f"#define {P}_EARLY {max(len(targets), 1)}"
        yield ""
        lines = [*printers.assignments(early, language, x, targets), "(void)x;", "(void)early;"]
        yield from _function(f"void {_p}_begin_factors(const {real} *x, {real} *early)", lines)
        outputs = [f"out[{k}]" for k in range(len(rest.outputs))]
        lines = [*printers.assignments(rest, language, [*x, *targets], outputs), "(void)x;", "(void)early;"]
        yield from commented("The rest of it.")
        yield from _function(f"void {_p}_end_factors(const {real} *x, const {real} *early, {real} *out)", lines)
    else:
        scaled = _returning(scale.program, language, x) if scale else ["return 1;"]
        lines = scaled if any("x[" in line for line in scaled) else ["(void)x;", *scaled]
        yield from _function(f"{real} {_p}_scale(const {real} *x)", lines)


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
    if table.spec.scale:
        axes = range(len(table.axes))
        program = with_derivatives(table.spec.scale.program, list(axes))
        inputs, targets = [f"x[{axis}]" for axis in axes], [f"out[{k}]" for k in range(len(program.outputs))]
        # A constant factor reads no axis.
        lines = [*printers.assignments(program, C_DOUBLE, inputs, targets), "(void)x;"]
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
    return [*lines, *(f"out[{k}] = 0;" for k in range(size, c_data.room(size - 1))), "(void)x;"]


def _others(table: Table, language: Language) -> list[str]:
    """Return the lines that fill all products of the other axes' functions, the last axis's fastest."""
    names = [axis.name for axis in table.axes[1:]]
    if not names:
        return ["out[0] = 1;", "(void)x;"]
    lines: list[str] = []
    arrays = ["out"] if len(names) == 1 else [f"{name}_terms" for name in names]
    for axis, array in enumerate(arrays, start=1):
        program = c_data.functions_of(table, axis, _basis(table, axis))
        size = len(program.outputs)
        found = printers.assignments(program, language, [f"x[{axis}]"], [f"{array}[{k}]" for k in range(size)])
        if len(names) == 1:
            return [*found, "(void)x;"]
        lines += [f"{_p}_real {array}[{size}];", "{", *(f"    {line}" for line in found), "}"]
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
