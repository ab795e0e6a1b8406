"""Fast tables as shaders: GLSL, HLSL and WGSL functions for weights, radiance and irradiance, from one generator."""

from __future__ import annotations

import math
import re
import textwrap
from collections.abc import Callable, Sequence
from itertools import product

import numpy as np

from skylight_sh import __version__, sphere
from skylight_sh.export.c_comment import input_lines
from skylight_sh.export.c_header import PREFIX, Facts, template
from skylight_sh.export.shader_dialects import DIALECTS, Dialect, check_prefix, expression, number
from skylight_sh.fit.maps import MAPS
from skylight_sh.light import PREFACTORS
from skylight_sh.table import twilight
from skylight_sh.table.prefactor import ClosedForm, Reciprocal
from skylight_sh.table.rows import Rows
from skylight_sh.table.table import SLACK, Table

_WIDTH = 112
_MOST_CHANNELS = 4
# A quarter turn in two parts, the first of few bits, and how many an angle of 1 has.
_QUARTER = {"high": "1.5703125", "low": number(math.pi / 2 - 1.5703125), "each": number(2 / math.pi)}

# Function k of each basis in the variable u{a} of axis a, by those before it in t{a}; a format over ``prefix``.
_TERMS: dict[str, Callable[[int, int], str]] = {
    # By products of lower ones: few steps wait for each other.
    "chebyshev": lambda a, k: f"u{a}" if k == 1 else f"2.0 * t{a}[{k // 2}] * t{a}[{k - k // 2}] - t{a}[{k % 2}]",
    "legendre": lambda a, k: (
        f"u{a}" if k == 1 else f"{number(2 - 1 / k)} * u{a} * t{a}[{k - 1}] - {number(1 - 1 / k)} * t{a}[{k - 2}]"
    ),
    "monomial": lambda a, k: f"u{a} * t{a}[{k - 1}]",
    "fourier": lambda a, k: f"{{prefix}}_wave({number(math.pi * ((k + 1) // 2))} * u{a}).{'x' if k % 2 else 'y'}",
}


def obstacle(table: Table) -> str | None:
    """Say why ``table`` cannot become a shader, or nothing where it can."""
    if not isinstance(table.body, Rows):
        return f"its layout is {table.body.kind}; shaders evaluate tables of layout rows"
    if table.dtype != np.float32:
        return f"its numbers are {table.dtype}; shaders work in float32"
    if table.quantity != "radiance" or table.azimuth is not None:
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
    why = obstacle(table)
    if why or not isinstance(table.body, Rows):
        raise ValueError(f"This table cannot become a shader: {why}.")
    if not PREFIX.fullmatch(prefix):
        raise ValueError(f"Invalid prefix {prefix!r}. Should be a lower-case C identifier of at most 32 characters.")
    check_prefix(prefix)
    dialect = DIALECTS[language]
    names = [axis.name for axis in table.axes]
    inputs = [names[0], "sun_azimuth", *names[1:]]
    colour = "real" if len(table.channels) == 1 else f"vec{len(table.channels)}"
    fours = table.body.rows.reshape(-1, 4)
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
        bytes=table.bytes,
        provenance=[_comment(line) for line in facts.provenance],
        bands=table.bands,
        colour=colour,
        radiance=_expansion(dialect, colour, "direction", [1.0] * table.bands),
        irradiance=_expansion(dialect, colour, "normal", sphere.clamped_cosine(table.bands).tolist()),
        lengths=[str(n) for n in table.body.lengths.tolist()],
        rows=[dialect.vector([number(v) for v in four]) for four in fours.tolist()],
        width=table.body.rows.shape[1] // 4,
        prefactor=_prefactor(table, dialect),
        parameters=[dialect.parameter("real", name) for name in inputs],
        arguments=", ".join(inputs),
        axes=_axes(table, prefix),
        scale=_scale(table, dialect, prefix),
        rest=_rest(table),
        waves=_waves(table.bands, dialect, prefix),
        quarter=_QUARTER,
        stores=_stores(table, dialect, colour),
    )


def _expansion(dialect: Dialect, colour: str, vector: str, factors: Sequence[float]) -> list[str]:
    """Return lines that set ``value`` to the sum of ``factors[l]`` times weights times real SH in the unit ``vector``.

    ``y_lm`` over sin^m is a polynomial in z by the recurrence of normalised associated Legendre functions; sin^m cos(m phi)
    and sin^m sin(m phi) are the parts of (x + iy)^m. No step divides, so that no direction is special.
    """
    lines = [dialect.fixed("real", axis, f"{vector}.{axis}") for axis in "xyz"]
    last = max((l for l, factor in enumerate(factors) if factor), default=0)
    for m in range(last + 1):
        kept = [l for l in range(m, last + 1) if factors[l]]
        start = _sectoral(m)
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


def _sectoral(m: int) -> float:
    """Return ``y_mm`` over sin^m cos(m phi): a constant."""
    square = math.prod((2 * k + 1) / (2 * k) for k in range(1, m + 1)) / (4 * math.pi)
    return math.sqrt(2 * square if m else square)


def _step(l: int, m: int, start: float) -> str:
    """Return ``y_lm`` over sin^m cos(m phi) by the two degrees below it; ``start`` is that of degree m."""
    gap = l * l - m * m
    ahead = math.sqrt((4 * l * l - 1) / gap)
    if l == m + 1:
        return f"{number(ahead * start)} * z"
    back = math.sqrt((2 * l + 1) * ((l - 1) ** 2 - m * m) / ((2 * l - 3) * gap))
    before = number(back * start) if l == m + 2 else f"{number(back)} * y{l - 2}_{m}"
    return f"{number(ahead)} * z * y{l - 1}_{m} - {before}"


def _axes(table: Table, prefix: str) -> list[dict[str, object]]:
    low = table.factor.coefficients.shape if isinstance(table.factor, Reciprocal) else (1,) * len(table.axes)
    found: list[dict[str, object]] = []
    for a, (axis, degree, least, ends) in enumerate(zip(table.axes, table.degrees, low, table.ranges, strict=True)):
        slack = SLACK * max(ends[1] - ends[0], 1.0)
        # A root's distance to its point may round below 0, where pow knows no number.
        text = MAPS[axis.map].c_expression.replace("CBRT(k[0] - v)", "pow(max(k[0] - v, 0), 0.333333343)")
        terms = [_TERMS[table.basis](a, k).format(prefix=prefix) for k in range(1, max(degree + 1, least))]
        found.append(
            {
                "name": axis.name,
                "map": axis.map,
                "low": number(axis.low),
                "high": number(axis.high),
                "least": number(ends[0] - slack),
                "most": number(ends[1] + slack),
                "expression": expression(re.sub(r"\bv\b", f"x{a}", text.replace("LOG", "log")), axis.constants),
                "terms": terms,
            }
        )
    return found


def _prefactor(table: Table, dialect: Dialect) -> dict[str, object] | None:
    if not isinstance(table.factor, ClosedForm):
        return None
    body = [dialect.fixed("real", name, number(value)) for name, value in table.factor.fixed]
    body += dialect.statements(PREFACTORS[table.factor.name].c_body, table.factor.constants)
    return {
        "name": table.factor.name,
        "parameters": [dialect.parameter("real", axis.name) for axis in table.axes],
        "lines": [line for text in body for line in _wrapped(text)],
    }


def _scale(table: Table, dialect: Dialect, prefix: str) -> list[str]:
    """Return the lines that declare ``scale``, what all weights are multiplied with, where there is such."""
    lines, factors = [], []
    if table.twilight:
        depth = f"((sun_zenith - {number(twilight.BEGIN)}) - {number(twilight.REST)}) * {number(1.0 / twilight.DEPTH)}"
        lines += [
            "// Twilight: the share of the horizon's light that a sun below it leaves.",
            dialect.fixed("real", "depth", f"clamp({depth}, 0.0, 1.0)"),
            dialect.fixed("real", "fade2", "(1.0 - depth) * (1.0 - depth)"),
            dialect.fixed("real", "fade4", "fade2 * fade2"),
        ]
        factors.append(f"fade4 * fade4 * fade2 * (1.0 + {number(twilight.POWER)} * depth)")
    if isinstance(table.factor, Reciprocal):
        numbers = table.factor.coefficients
        terms = [_times(number(float(numbers[at])), at) for at in product(*(range(size) for size in numbers.shape))]
        factors.append(f"1.0 / ({' + '.join(terms).replace('+ -', '- ')})")
    elif table.factor:
        factors.append(f"{prefix}_prefactor({', '.join(f'x{a}' for a in range(len(table.axes)))})")
    return lines + (_wrapped(dialect.fixed("real", "scale", " * ".join(factors))) if factors else [])


def _rest(table: Table) -> list[str]:
    """Return the products of the other axes' powers, times the scale, in the order of ``Rows``."""
    scale = "scale" if table.factor or table.twilight else "1.0"
    return [_times(scale, (0, *at)) for at in product(*(range(degree + 1) for degree in table.degrees[1:]))]


def _times(first: str, powers: Sequence[int]) -> str:
    return " * ".join([first, *(f"t{a}[{power}]" for a, power in enumerate(powers) if power)])


def _waves(bands: int, dialect: Dialect, prefix: str) -> list[str]:
    """Return the lines that declare cos and sin of m times the azimuth as ``c1``, ``s1``, .. by doubling: m = h + k."""
    if bands == 1:
        return []
    lines = [
        dialect.fixed("vec2", "wave", f"{prefix}_wave(sun_azimuth)"),
        dialect.fixed("real", "c1", "wave.x"),
        dialect.fixed("real", "s1", "wave.y"),
    ]
    for m in range(2, bands):
        h, k = m // 2, m - m // 2
        lines.append(dialect.fixed("real", f"c{m}", f"c{h} * c{k} - s{h} * s{k}"))
        lines.append(dialect.fixed("real", f"s{m}", f"s{h} * c{k} + c{h} * s{k}"))
    return lines


def _stores(table: Table, dialect: Dialect, colour: str) -> list[str]:
    """Return the lines that store all weights, turned by the azimuth (Habel et al. 2008, eq. 4)."""
    column = {place: k for k, place in enumerate(table.layout.places) if place}

    def output(l: int, m: int) -> str:
        places = [column[l, c, m] for c in range(len(table.channels))]
        return dialect.vector([f"acc[{k // 4}].{'xyzw'[k % 4]}" for k in places])

    lines = []
    for l in range(table.bands):
        middle = l * (l + 1)
        lines.append(f"{dialect.element('weights', middle)} = {output(l, 0)};")
        for m in range(1, l + 1):
            plus, minus = dialect.element("weights", middle + m), dialect.element("weights", middle - m)
            lines.append(dialect.fixed(colour, f"a{l}_{m}", output(l, m)))
            if table.mirrored:
                lines += [f"{plus} = a{l}_{m} * c{m};", f"{minus} = a{l}_{m} * s{m};"]
                continue
            lines.append(dialect.fixed(colour, f"b{l}_{m}", output(l, -m)))
            lines.append(f"{plus} = a{l}_{m} * c{m} - b{l}_{m} * s{m};")
            lines.append(f"{minus} = b{l}_{m} * c{m} + a{l}_{m} * s{m};")
    return lines


def _wrapped(text: str) -> list[str]:
    return textwrap.wrap(text, _WIDTH, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)


def _comment(text: str) -> str:
    """Keep text inside its line: no break of any language, no backslash that joins it to the next, nothing but ASCII."""
    return " ".join(text.split()).encode("ascii", "replace").decode().replace("\\", "/")
