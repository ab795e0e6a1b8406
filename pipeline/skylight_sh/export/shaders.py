"""Fast tables as shaders: GLSL, HLSL and WGSL functions for weights, radiance and irradiance, from one generator."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from itertools import product
from typing import Any

import numpy as np

from skylight_sh import __version__, sphere
from skylight_sh.export import prefixes
from skylight_sh.export.c_comment import input_lines
from skylight_sh.export.c_data import is_mixed
from skylight_sh.export.c_header import Facts
from skylight_sh.export.shader_dialects import DIALECTS, Dialect, check_prefix
from skylight_sh.export.statements import peak_of
from skylight_sh.export.template import template
from skylight_sh.formula import harmonics, printers
from skylight_sh.formula.azimuth import TURN, waves
from skylight_sh.formula.bases import BASES
from skylight_sh.formula.expression import trace
from skylight_sh.formula.printers import Language
from skylight_sh.formula.printers import single as number
from skylight_sh.runtime import SLACK, ClassRows, Packed, Table
from skylight_sh.table import twilight
from skylight_sh.table.rows import by_class
from skylight_sh.table.size import bytes_of

_WIDTH = 112
_MOST_CHANNELS = 4
# A quarter turn in two parts, the first of few bits, and how many an angle of 1 has.
_QUARTER = {"high": "1.5703125", "low": number(math.pi / 2 - 1.5703125), "each": number(2 / math.pi)}


def obstacle(table: Table) -> str | None:
    """Say why ``table`` cannot become a shader, or nothing where it can."""
    if isinstance(table.body, Packed):
        return f"its layout is {table.body.kind}; shaders evaluate tables of layout rows"
    if table.dtype != np.float32:
        return f"its numbers are {table.dtype}; shaders work in float32"
    if table.spec.quantity != "radiance" or table.spec.azimuth is not None:
        return "a shader takes radiance weights of a sun that turns"
    if table.surroundings:
        return "surroundings are too many constants for a shader; apply them to its weights"
    if len(table.channels) > _MOST_CHANNELS:
        return f"it has {len(table.channels)} channels; a shader's vectors hold {_MOST_CHANNELS}"
    return None


def write(table: Table, facts: Facts, language: str, prefix: str = "skylight_sh") -> str:
    """Return the text of ``table`` in ``language`` (``glsl``, ``hlsl`` or ``wgsl``); every global starts with ``prefix``.

    Weights are scalars for one channel, else vectors of the channels. Raises ValueError for a table with an ``obstacle``,
    a prefix that the languages reserve, or a prefactor whose C is more than arithmetic.
    """
    why, table = obstacle(table), by_class(table)
    if why or not isinstance(table.body, ClassRows):
        raise ValueError(f"This table cannot become a shader: {why}.")
    prefixes.check(prefix)
    check_prefix(prefix)
    dialect = DIALECTS[language]
    names = [axis.name for axis in table.axes]
    inputs = [names[0], "sun_azimuth", *names[1:]]
    colour = "real" if len(table.channels) == 1 else f"vec{len(table.channels)}"
    width = _vectors(table.body)
    fours = np.pad(table.body.rows, ((0, 0), (0, 4 * width - table.body.rows.shape[1]))).reshape(-1, 4)
    return template("skylight_sh.shader.j2").render(
        d=dialect,
        p=prefix,
        P=prefix.upper(),
        version=__version__,
        title=_comment(facts.title),
        inputs=[*input_lines(table), "sun_azimuth: any angle, rad; best within a few thousand turns of 0"],
        layout=_comment(f"{dialect.types[colour]} of the channels {', '.join(table.channels)}"),
        e_mean=facts.e_mean,
        e_max=facts.e_max,
        l_min=_comment(facts.l_min),
        bytes=bytes_of(table) + 4 * fours.size - table.body.rows.nbytes,
        provenance=[_comment(line) for line in facts.provenance],
        bands=table.bands,
        colour=colour,
        radiance=_expansion(dialect, colour, "direction", [1.0] * table.bands),
        irradiance=_expansion(dialect, colour, "normal", sphere.clamped_cosine(table.bands).tolist()),
        lengths=[str(n) for n in table.body.lengths.ravel().tolist()],
        rows=[dialect.vector([number(v) for v in four]) for four in fours.tolist()],
        classes=table.spec.classes,
        width=width,
        prefactor=_prefactor(table, dialect, colour, prefix),
        wave="_wave(" in str((_axes(table, dialect, prefix), _prefactor(table, dialect, colour, prefix))),
        parameters=[dialect.parameter("real", name) for name in inputs],
        arguments=", ".join(inputs),
        axes=_axes(table, dialect, prefix),
        scale=_scale(table, dialect, prefix),
        factors=_factors(table, dialect, colour, prefix),
        rest=_rest(table),
        waves=_waves(table, dialect, prefix),
        quarter=_QUARTER,
        stores=_stores(table, table.body, dialect, colour),
    )


def _vectors(body: ClassRows) -> int:
    """Return how many vectors of four hold a row; the last is filled up."""
    return int(-(-body.rows.shape[1] // 4))


def _expansion(dialect: Dialect, colour: str, vector: str, factors: Sequence[float]) -> list[str]:
    """Return lines that set ``value`` to the sum of ``factors[l]`` times weights times real SH in the unit ``vector``.

    ``y_lm`` over sin^m is a polynomial in z by the recurrence of normalised associated Legendre functions; sin^m cos(m phi)
    and sin^m sin(m phi) are the parts of (x + iy)^m. No step divides, so that no direction is special.
    """
    lines = [dialect.fixed("real", axis, f"{vector}.{axis}") for axis in "xyz"]
    last = max((l for l, factor in enumerate(factors) if factor), default=0)
    for m in range(last + 1):
        kept = [l for l in range(m, last + 1) if factors[l]]
        start = harmonics.sectoral(m)
        lines += [dialect.fixed("real", f"y{l}_{m}", _step(l, m, start)) for l in range(m + 1, kept[-1] + 1)]

        def total(sign: int, m: int = m, kept: Sequence[int] = tuple(kept), start: float = start) -> str:
            terms = []
            for l in kept:
                weight = f"weights[{l * (l + 1) + sign * m}]"
                factor = "" if factors[l] == 1 else f"{number(factors[l])} * "
                terms.append(f"{number(factors[l] * start)} * {weight}" if l == m else f"{factor}y{l}_{m} * {weight}")
            return " + ".join(terms).replace("+ -", "- ")

        if m == 0:
            lines += _wrapped(dialect.variable(colour, "value", total(0)))
            continue
        if m == 1:
            lines += [dialect.fixed("real", "c1", "x"), dialect.fixed("real", "s1", "y")]
        else:
            lines.append(dialect.fixed("real", f"c{m}", f"c{m - 1} * x - s{m - 1} * y"))
            lines.append(dialect.fixed("real", f"s{m}", f"s{m - 1} * x + c{m - 1} * y"))
        lines += _wrapped(f"value += c{m} * ({total(1)}) + s{m} * ({total(-1)});")
    return lines


def _step(l: int, m: int, start: float) -> str:
    """Return ``y_lm`` over sin^m cos(m phi) by the two degrees below it; ``start`` is that of degree m."""
    ahead = float(harmonics.ahead(l, m))
    if l == m + 1:
        return f"{number(ahead * start)} * z"
    back = float(harmonics.behind(l, m))
    before = number(back * start) if l == m + 2 else f"{number(back)} * y{l - 2}_{m}"
    return f"{number(ahead)} * z * y{l - 1}_{m} - {before}"


def _language(dialect: Dialect, prefix: str) -> Language:
    """Return how formulas are printed; cosine and sine are the shader's own, which GPUs cannot spoil."""
    functions = {name: f"{name}({{x}})" for name in ("log", "exp", "sqrt")}
    # A root's distance to its point may round below 0, where pow knows no number.
    functions["cbrt"] = "pow(max({x}, 0.0), 0.333333343)"
    functions |= {"cos": f"{prefix}_wave({{x}}).x", "sin": f"{prefix}_wave({{x}}).y"}
    return Language(number, functions, lambda name, value: dialect.fixed("real", name, value))


def _axes(table: Table, dialect: Dialect, prefix: str) -> list[dict[str, object]]:
    language = _language(dialect, prefix)
    found: list[dict[str, object]] = []
    for a, (axis, degree, ends) in enumerate(zip(table.axes, table.degrees, table.ranges, strict=True)):
        slack = SLACK * max(ends[1] - ends[0], 1.0)
        program = BASES[table.spec.basis].program(degree, shallow=True)
        targets = [f"t{a}[{k}]" for k in range(degree + 1)]
        found.append(
            {
                "name": axis.name,
                "map": axis.map,
                "low": number(axis.low),
                "high": number(axis.high),
                "least": number(ends[0] - slack),
                "most": number(ends[1] + slack),
                "expression": printers.statements(axis.variable, language, [f"x{a}"])[1][0],
                "size": degree + 1,
                "terms": printers.assignments(program, language, [f"u{a}"], targets),
            }
        )
    return found


def _prefactor(table: Table, dialect: Dialect, colour: str, prefix: str) -> dict[str, object] | None:
    """Return the function of what all weights share: one number, or of each class what the channels take of it."""
    scale = table.spec.scale
    if not scale:
        return None
    inputs = [f"x{a}" for a in range(len(table.axes))]
    lines, results = printers.statements(scale.program, _language(dialect, prefix), inputs)
    parameters = [dialect.parameter("real", name) for name in inputs]
    head = dialect.function("real", f"{prefix}_prefactor", parameters)
    if is_mixed(table):
        classes = table.spec.classes
        head = dialect.procedure(f"{prefix}_factors", [*parameters, dialect.result_parameter(colour, "factors", classes)])
        lines += [f"{dialect.element('factors', k)} = {dialect.vector(results[k::classes])};" for k in range(classes)]
    else:
        lines.append(f"return {results[0]};")
    return {"name": scale.name, "head": head, "lines": [line for text in lines for line in _wrapped(text)]}


def _scale(table: Table, dialect: Dialect, prefix: str) -> list[str]:
    """Return the lines that declare ``scale``, what all sums are multiplied with, where there is such."""
    lines, factors = [], []
    if table.spec.twilight:
        begin, rest, each = (number(value) for value in (twilight.BEGIN, twilight.REST, 1.0 / twilight.DEPTH))
        depth = f"(({table.spec.peak_axis} - {begin}) - {rest}) * {each}"
        printed, results = printers.statements(table.spec.twilight.program, _language(dialect, prefix), ["depth"])
        lines += [
            "// Twilight: the share of the horizon's light that a sun below it leaves.",
            dialect.fixed("real", "depth", f"clamp({depth}, 0.0, 1.0)"),
            *printed,
        ]
        factors.append(results[0])
    if table.spec.scale and not is_mixed(table):
        factors.append(f"{prefix}_prefactor({', '.join(f'x{a}' for a in range(len(table.axes)))})")
    return lines + (_wrapped(dialect.fixed("real", "scale", " * ".join(factors))) if factors else [])


def _factors(table: Table, dialect: Dialect, colour: str, prefix: str) -> list[str]:
    """Return the lines that declare ``factors``, what the channels take of each class, where there are such."""
    if not is_mixed(table):
        return []
    inputs = [f"x{a}" for a in range(len(table.axes))]
    call = f"{prefix}_factors({', '.join([*inputs, dialect.passed('factors')])});"
    return [dialect.array(colour, "factors", table.spec.classes), call]


def _rest(table: Table) -> list[str]:
    """Return the products of the other axes' functions, times the scale, the last axis fastest."""
    scaled = table.spec.twilight or (table.spec.scale and not is_mixed(table))
    first = ["scale"] if scaled else []
    found = []
    for at in product(*(range(degree + 1) for degree in table.degrees[1:])):
        factors = first + [f"t{a}[{power}]" for a, power in enumerate(at, start=1) if power]
        found.append(" * ".join(factors) or "1.0")
    return found


def _waves(table: Table, dialect: Dialect, prefix: str) -> list[str]:
    """Return the lines that declare cos and sin of m times the azimuth as ``c1``, ``s1``, .. by doubling: m = h + k.

    With parity those of order m are multiplied by sin^m of the peak's zenith angle.
    """
    if table.bands == 1:
        return []
    first = f"{prefix}_wave(sun_azimuth)"
    if table.spec.parity:
        first = f"{first} * {prefix}_wave(x{peak_of(table)}).y"
    lines = [
        dialect.fixed("vec2", "wave", first),
        dialect.fixed("real", "c1", "wave.x"),
        dialect.fixed("real", "s1", "wave.y"),
    ]
    program = trace(lambda cosine, sine: _doubled(cosine, sine, table.bands), ["cosine", "sine"])
    names = [f"{wave}{m}" for m in range(2, table.bands) for wave in "cs"]
    return lines + printers.declarations(program, _language(dialect, prefix), ["c1", "s1"], names)


def _doubled(cosine: Any, sine: Any, bands: int) -> list[Any]:
    """Return cos and sin of twice the azimuth, of three times, .."""
    return [wave for pair in list(zip(*waves(cosine, sine, bands), strict=True))[2:] for wave in pair]


def _stores(table: Table, body: ClassRows, dialect: Dialect, colour: str) -> list[str]:
    """Return the lines that store all weights, turned by the azimuth (Habel et al. 2008, eq. 4)."""
    columns = dict(zip(table.places.tolist(), body.columns.tolist(), strict=True))
    classes, width, mixed = range(table.spec.classes), _vectors(body), is_mixed(table)

    def output(place: int) -> str:
        column = columns[place]
        sums = [f"acc[{k * width + column // 4}].{'xyzw'[column % 4]}" for k in classes]
        if mixed:
            return " + ".join(f"factors[{k}] * {one}" for k, one in enumerate(sums))
        return dialect.vector(sums)

    lines = []
    for l in range(table.bands):
        middle = l * (l + 1)
        lines.append(f"{dialect.element('weights', middle)} = {output(middle)};")
        for m in range(1, l + 1):
            plus, minus = dialect.element("weights", middle + m), dialect.element("weights", middle - m)
            lines.append(dialect.fixed(colour, f"a{l}_{m}", output(middle + m)))
            if table.spec.mirrored:
                lines += [f"{plus} = a{l}_{m} * c{m};", f"{minus} = a{l}_{m} * s{m};"]
                continue
            lines.append(dialect.fixed(colour, f"b{l}_{m}", output(middle - m)))
            inputs = [f"a{l}_{m}", f"b{l}_{m}", f"c{m}", f"s{m}"]
            lines += printers.assignments(TURN, _language(dialect, ""), inputs, [plus, minus])
    return [line for text in lines for line in _wrapped(text)]


def _wrapped(text: str) -> list[str]:
    return textwrap.wrap(text, _WIDTH, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)


def _comment(text: str) -> str:
    """Keep text inside its line: no break of any language, no backslash that joins it to the next, nothing but ASCII."""
    return " ".join(text.split()).encode("ascii", "replace").decode().replace("\\", "/")
