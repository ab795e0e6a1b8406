"""Tables as C#: one static class without dependencies, for Unity and .NET, that evaluates and turns by azimuth.

The evaluator stands in ``evaluators/csharp`` and is copied beside the table's data and its formulas, printed from their
programs. Nothing is allocated in a call.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from skylight_sh import __version__
from skylight_sh.export import c_comment, engines, prefixes, statements
from skylight_sh.export.c_data import features, is_double, is_mixed, others
from skylight_sh.export.c_header import Facts
from skylight_sh.export.engine_profiles import PROFILES
from skylight_sh.export.evaluators import PREFIX, filled, part
from skylight_sh.export.javascript import plain
from skylight_sh.formula import printers
from skylight_sh.formula.azimuth import TURN
from skylight_sh.formula.harmonics import HORIZONTAL
from skylight_sh.formula.printers import CSHARP_DOUBLE, CSHARP_SINGLE, Language
from skylight_sh.formula.window import SINC
from skylight_sh.runtime import ClassRows, Packed, Rows, Table
from skylight_sh.sphere import lower_hemisphere
from skylight_sh.table import twilight
from skylight_sh.table.rows import by_class
from skylight_sh.table.surroundings import PARTS
from skylight_sh.table.table import float32_limits

# ECMA-334, 6.4.4: names that parameters have behind an @.
_KEYWORDS = """
abstract as base bool break byte case catch char checked class const continue decimal default delegate do double else enum
event explicit extern false finally fixed float for foreach goto if implicit in int interface internal is lock long namespace
new null object operator out override params private protected public readonly ref return sbyte sealed short sizeof
stackalloc static string struct switch this throw true try typeof uint ulong unchecked unsafe ushort using virtual void
volatile while
"""
_BODY = re.compile(r"^public static partial class SkylightSh\n\{\n(.*)^\}", re.MULTILINE | re.DOTALL)
_COLUMNS = 120
_WEIGHTS = "Span<float> weights"
_UNITY_WEIGHTS = 9


def write(table: Table, facts: Facts, prefix: str = PREFIX) -> str:
    """Return the text of the class of ``table``, named by ``prefix``.

    Raises ValueError for a prefix that is no identifier of lower-case letters, digits and underscores.
    """
    prefixes.check(prefix)
    table = by_class(table)
    names = ["inputs", *([] if isinstance(table.body, ClassRows) else ["packed"]), "evaluate", "extras"]
    blocks = [_data(table), _formulas(table), *(_part(name, table) for name in names), _public(table), _unity(table)]
    inside = "\n\n".join(text for text in ("\n".join(block).strip("\n") for block in blocks) if text)
    name = class_name(prefix)
    lines = [*_comment(table, facts, name), *_usings(table), "", f"public static class {name}", "{", inside, "}"]
    return re.sub(r"\n{3,}", "\n\n", "\n".join(lines)) + "\n"


def example(table: Table, twin: Table) -> str:
    """Return ``evaluators/csharp/example.cs``: what the parts read of ``table``, and of its packed ``twin``."""
    lines = ["// What an export writes of one table, and a packed table's stream, for the parts as they stand."]
    lines += [*_usings(table), "", "public static partial class SkylightSh", "{", *_data(table), *_stream(twin.body), ""]
    text = "\n".join([*lines, "\n".join(_formulas(table)).rstrip(), "}"])
    return re.sub(r"\n{3,}", "\n\n", text) + "\n"


def class_name(prefix: str) -> str:
    """Return the class of a prefix; different ones for different prefixes.

    >>> class_name("skylight_sh"), class_name("sky_4_bands_0_1pct")
    ('SkylightSh', 'Sky_4Bands_0_1pct')
    """
    return parameter(f"_{prefix}")


def parameter(name: str) -> str:
    """Return the name of an input as C# writes parameters.

    >>> parameter("sun_zenith"), parameter("base")
    ('sunZenith', '@base')
    """
    written = re.sub(r"_([a-z])", lambda found: found[1].upper(), name)
    return f"@{written}" if written in _KEYWORDS.split() else written


def _usings(table: Table) -> list[str]:
    return ["using System;", f"using Real = System.{'Double' if is_double(table) else 'Single'};"]


def _part(name: str, table: Table) -> list[str]:
    """Return the lines inside the class of an evaluator's file, as ``table`` needs them."""
    found = _BODY.search(part(f"csharp/{name}.cs", features(table)))
    return found[1].splitlines() if found else []


def _comment(table: Table, facts: Facts, name: str) -> Iterator[str]:
    _, notes = c_comment.about(table)
    middle = {axis.name: f"{float(f'{(axis.low + axis.high) / 2:.3g}')}f" for axis in table.axes}
    told = [
        f"{facts.title}: spherical-harmonics weights, evaluated from polynomials.",
        "",
        f"Written by skylight-sh {__version__}; the table and this code may be used by anyone for anything (CC0-1.0).",
        "C# 7.2 for .NET Standard 2.1 (Unity from 2021.2 on), without dependencies. No call allocates anything"
        + (" but the first, which unpacks the table." if isinstance(table.body, Packed) else "."),
        "",
        "Usage",
        f"  var w = new float[{name}.ChannelCount * {name}.WeightCount]; // once",
        f"  int status = {name}.Weights({', '.join(middle.get(axis, '0f') for axis in statements.inputs_of(table))}, w);",
        "w is filled channel by channel: index channel * WeightCount + l * (l + 1) + m.",
        *(_about_unity(name) if _takes_unity(table) else ()),
        "",
        "Inputs",
        *(f"  {line}" for line in c_comment.input_lines(table)),
        *([] if table.spec.azimuth is not None else ["  sun_azimuth: any finite angle, rad"]),
        "Output",
        *(f"  {line}" for line in notes),
        "",
        f"Accuracy: E_mean {100 * facts.e_mean:.3g} %, E_max {100 * facts.e_max:.3g} % at azimuth 0.",
        "",
        "Provenance",
        *(f"  {line}" for line in facts.provenance),
    ]
    for line in told:
        indent = " " * (len(line) - len(line.lstrip()))
        for one in textwrap.wrap(plain(line), _COLUMNS - 3, subsequent_indent=indent, break_on_hyphens=False) or [""]:
            yield f"// {one}".rstrip()


def _about_unity(name: str) -> list[str]:
    nine = _UNITY_WEIGHTS
    return [
        "",
        "Unity's ambient probe, or a light probe",
        f"  var coefficients = new float[{3 * nine}]; // once",
        f"  {name}.Unity(w, coefficients);",
        "  var probe = new SphericalHarmonicsL2();",
        f"  for (int k = 0; k < coefficients.Length; ++k) probe[k / {nine}, k % {nine}] = coefficients[k];",
        "  RenderSettings.ambientProbe = probe;",
        f"{engines.describe(PROFILES['unity'].axes)}. The weights are in cd/m2: expose them before.",
    ]


def _constants(kind: str, values: Iterable[tuple[str, object]]) -> str:
    return f"    public const {kind} {', '.join(f'{name} = {value}' for name, value in values)};"


def _data(table: Table) -> Iterator[str]:
    spec, number = table.spec, _language(table).number
    unit, _ = c_comment.about(table)
    yield "    /// <summary>SH bands, weights a channel, channels.</summary>"
    sizes = {"Bands": table.bands, "WeightCount": table.bands**2, "ChannelCount": len(table.channels)}
    yield _constants("int", sizes.items())
    yield "    /// <summary>What evaluations return.</summary>"
    yield _constants("int", [("Ok", 0), ("Clamped", 1), ("Invalid", 2)])
    yield "    /// <summary>Of what the weights expand.</summary>"
    yield _constants("string", [("Unit", f'"{unit}"')])
    yield "    /// <summary>Of each axis: the least and the largest input.</summary>"
    for axis, (low, high) in zip(table.axes, table.ranges, strict=True):
        name = class_name(axis.name)
        yield _constants("Real", [(f"{name}Min", number(low)), (f"{name}Max", number(high))])
    yield ""
    own = {
        "AxisCount": len(table.axes),
        "ClassCount": spec.classes,
        "FirstCount": table.degrees[0] + 1,
        "OtherCount": others(table),
    }
    own |= {"FactorCount": len(table.channels) * spec.classes if is_mixed(table) else 1, "Width": statements.width(table)}
    yield f"    const int {', '.join(f'{name} = {value}' for name, value in own.items())};"
    yield "    // The axis whose sine the sums of order m lack m times, or -1."
    yield f"    static readonly int Peak = {statements.peak_of(table)};"
    yield f"    static readonly bool Mirrored = {'true' if spec.mirrored else 'false'};"
    if spec.twilight:
        yield "    // The axis of the sun's zenith angle, the horizon in two parts, how far below it the light has faded."
        yield f"    const int Sun = {[axis.name for axis in table.axes].index(str(spec.peak_axis))};"
        depths = {"Horizon": twilight.BEGIN, "HorizonRest": 0.0 if is_double(table) else twilight.REST}
        depths |= {"Depth": spec.twilight.depth}
        yield f"    const Real {', '.join(f'{name} = {number(value)}' for name, value in depths.items())};"
    yield "    // Of each axis: the first and last float that counts as inside, and its range."
    inside = [value for pair in float32_limits(table) for value in pair]
    yield from _array("static readonly float[] Inside", (printers.single(value) + "f" for value in inside))
    yield from _array("static readonly Real[] Range", (number(v) for axis in table.axes for v in (axis.low, axis.high)))
    if "TAKES_GROUND" in features(table):
        yield "    // What an even ground reflects of the weight l = 1, m = 0, and its own zonal weights."
        yield f"    const float Reflected = {printers.single(HORIZONTAL / np.pi)}f;"
        lower = lower_hemisphere(table.bands).tolist()
        yield from _array("static readonly float[] LowerHalf", (printers.single(value) + "f" for value in lower))
    for name in PARTS if table.surroundings else ():
        values = getattr(table.surroundings, name).ravel().tolist()
        if values:
            yield from _array(f"static readonly Real[] {name.capitalize()}", map(number, values))
    yield from _terms(table)


def _terms(table: Table) -> Iterator[str]:
    body = table.body
    yield "    // The degrees that carry anything; their sums follow one another."
    yield from _array("static readonly int[] Degrees", map(str, statements.carried(table)))
    yield "    // Of each class: how many rows each product of the other axes' functions has; a row a term."
    yield "    static class Terms"
    yield "    {"
    if isinstance(body, ClassRows):
        lengths, rows = map(str, body.lengths.ravel().tolist()), map(_language(table).number, body.rows.ravel().tolist())
        yield from (f"    {line}" for line in _array("internal static readonly byte[] Lengths", lengths))
        yield from (f"    {line}" for line in _array("internal static readonly Real[] Rows", rows))
    else:
        yield "        internal static byte[] Lengths => Unpacked.Lengths;"
        yield "        internal static Real[] Rows => Unpacked.Rows;"
    yield "    }"
    if not isinstance(body, ClassRows):
        yield from _stream(body)


def _stream(body: ClassRows | Packed | Rows) -> Iterator[str]:
    if not isinstance(body, Packed):
        raise TypeError(f"A table of layout {body.kind!r} has no stream.")
    yield "    // Runs, one a product of the other axes' functions; profiles; what one step is worth; Rice codes."
    yield from _array("static readonly int[] RunProfile", map(str, body.rest_profile.tolist()))
    yield from _array("static readonly int[] ClassProfile", map(str, body.channel_profile.tolist()))
    yield f"    const Real Step = {printers.single(body.step)}f;"
    yield from _array("static readonly byte[] Stream", map(str, body.stream))


def _array(head: str, items: Iterable[str]) -> Iterator[str]:
    yield f"    {head} = {{"
    yield from (f"    {line}" for line in filled(items, 92))
    yield "    };"


def _language(table: Table) -> Language:
    return CSHARP_DOUBLE if is_double(table) else CSHARP_SINGLE


def _formulas(table: Table) -> Iterator[str]:
    language = _language(table)
    head = "(ReadOnlySpan<Real> x, Span<Real> to)"
    yield "    // What all weights share, or what each channel in turn takes of each class."
    yield from _function(f"static void Factors{head}", statements.of_factors(table, language))
    yield f"    // The functions of {table.axes[0].name} (change of variable: {table.axes[0].map})."
    yield from _function(f"static void FirstFunctions{head}", statements.of_axis(table, 0, language, "to"))
    yield "    // All products of the other axes' functions, the last axis's fastest."
    yield from _function(f"static void OtherFunctions{head}", _others(table))
    yield "    // cos(m azimuth) and sin(m azimuth), each times the m-th power of the radius, by doubling."
    # An azimuth is a float; the Math of Mono and .NET Framework gives angles beyond 2^63 back as they are.
    waves = statements.of_waves(table.bands, replace(language, functions=CSHARP_SINGLE.functions))
    yield from _function("static void Waves(float azimuth, Real radius, Span<Real> cosines, Span<Real> sines)", waves)
    yield "    // The weights of orders m and -m turned by the azimuth (Habel et al. 2008, eq. 4)."
    turned = printers.assignments(TURN, language, ["plus", "minus", "cosine", "sine"], ["turned", "partner"])
    head = "static void Turn(Real plus, Real minus, Real cosine, Real sine, out Real turned, out Real partner)"
    yield from _function(head, turned)
    yield "    // The zonal window's factor for the degree `share` * bands (Habel et al. 2008, eq. 5)."
    yield from _function("static float Sinc(float share)", statements.returning(SINC, CSHARP_SINGLE, ["share"]))
    if table.spec.twilight:
        yield "    // The share of the horizon's light at the sun's depth below it, 0 to 1."
        yield from _function(
            "static Real Fade(Real depth)", statements.returning(table.spec.twilight.program, language, ["depth"])
        )


def _others(table: Table) -> list[str]:
    if len(table.axes) == 1:
        return ["to[0] = 1;"]
    if len(table.axes) == 2:
        return statements.of_axis(table, 1, _language(table), "to")
    lines = ["int count = 1;", "to[0] = 1;"]
    for axis in range(1, len(table.axes)):
        lines += ["{", f"    Span<Real> terms = stackalloc Real[{table.degrees[axis] + 1}];"]
        lines += [f"    {line}" for line in statements.of_axis(table, axis, _language(table), "terms")]
        lines += ["    for (int k = count - 1; k >= 0; --k)", "    {", "        Real product = to[k];"]
        lines += ["        for (int i = 0; i < terms.Length; ++i) to[k * terms.Length + i] = product * terms[i];", "    }"]
        lines += ["    count *= terms.Length;", "}"]
    return lines


def _function(head: str, lines: Iterable[str]) -> Iterator[str]:
    # A parameter stays in one line.
    head = re.sub(r"(?<!,) ", "\u00a0", head)
    for line in (head, "{", *(f"    {line}" for line in lines), "}"):
        indent = " " * (len(line) - len(line.lstrip()) + 8)
        wrapped = textwrap.wrap(
            f"    {line}", _COLUMNS, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False
        )
        yield from (one.replace("\u00a0", " ") for one in wrapped)
    yield ""


def _public(table: Table) -> Iterator[str]:
    names = statements.inputs_of(table)
    axes = [axis.name for axis in table.axes]
    one = ", ".join(f"float {parameter(name)}" for name in names)
    many = ", ".join(f"ReadOnlySpan<float> {parameter(name)}" for name in names)
    fixed = table.spec.azimuth is not None
    azimuth = f"{printers.single(table.spec.azimuth or 0.0)}f" if fixed else parameter("sun_azimuth")
    given = ["Span<float> given = stackalloc float[AxisCount];"]
    given += [f"given[{k}] = {parameter(name)};" for k, name in enumerate(axes)]
    yield "    /// <summary>Evaluates all bands: fills the weights, channel by channel, and returns the status.</summary>"
    yield from _function(
        f"public static int Weights({one}, {_WEIGHTS})", [*given, f"return Evaluate(given, {azimuth}, Bands, weights);"]
    )
    yield "    /// <summary>Evaluates the first bands, 1 to Bands, clamped likewise; the others are 0.</summary>"
    yield from _function(
        f"public static int WeightsBands({one}, int bands, {_WEIGHTS})",
        [*given, f"return Evaluate(given, {azimuth}, bands, weights);"],
    )
    yield "    /// <summary>Evaluates many suns, an array an input, one after another; returns the largest status.</summary>"
    each = ["Span<float> given = stackalloc float[AxisCount];", "int worst = Ok, size = ChannelCount * WeightCount;"]
    each += [f"for (int k = 0; k < {parameter(names[0])}.Length; ++k)", "{"]
    each += [f"    given[{i}] = {parameter(name)}[k];" for i, name in enumerate(axes)]
    turned = azimuth if fixed else f"{azimuth}[k]"
    each += [f"    worst = Math.Max(worst, Evaluate(given, {turned}, Bands, weights.Slice(k * size, size)));", "}"]
    yield from _function(f"public static int WeightsBatch({many}, {_WEIGHTS})", [*each, "return worst;"])


def _takes_unity(table: Table) -> bool:
    radiance = table.spec.quantity == "radiance" and len(table.channels) in (1, len(engines.CHANNELS))
    return radiance and table.bands**2 >= _UNITY_WEIGHTS


def _unity(table: Table) -> Iterator[str]:
    """Yield the method that fills Unity's numbers, as ``engines.convert`` makes them."""
    if not _takes_unity(table):
        return
    # What each of our weights becomes, (9, 9).
    matrix = engines.convert(np.eye(_UNITY_WEIGHTS)[:, np.newaxis], PROFILES["unity"])[:, 0]
    yield "    /// <summary>"
    yield "    /// Fills the numbers of Unity's SphericalHarmonicsL2 with the first three bands' irradiance over pi, y up:"
    yield f"    /// [channel, i] is number {_UNITY_WEIGHTS} * channel + i, of red, green and blue."
    yield "    /// </summary>"
    lines = [f"for (int channel = 0; channel < {len(engines.CHANNELS)}; ++channel)", "{"]
    lines += ["    ReadOnlySpan<float> w = weights.Slice(channel % ChannelCount * WeightCount, WeightCount);"]
    lines += [f"    Span<float> to = coefficients.Slice({_UNITY_WEIGHTS} * channel, {_UNITY_WEIGHTS});"]
    for i, column in enumerate(matrix.T.tolist()):
        terms = " + ".join(f"{printers.single(value)}f * w[{j}]" for j, value in enumerate(column) if value)
        lines.append(f"    to[{i}] = {terms};".replace("+ -", "- "))
    yield from _function("public static void Unity(ReadOnlySpan<float> weights, Span<float> coefficients)", [*lines, "}"])
