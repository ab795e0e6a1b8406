"""Tables as JavaScript: one ES module without dependencies, for browsers and Node, that evaluates and turns by azimuth.

The evaluator stands in ``evaluators/javascript`` and is copied beside the table's data and its formulas, printed from their
programs. It computes in double precision and stores float32.
"""

from __future__ import annotations

import json
import math
import re
import textwrap
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from skylight_sh import __version__
from skylight_sh.export import c_comment, statements
from skylight_sh.export.c_data import features, is_mixed, others
from skylight_sh.export.c_header import Facts
from skylight_sh.export.evaluators import COLUMNS, filled, part
from skylight_sh.formula import printers
from skylight_sh.formula.azimuth import TURN
from skylight_sh.formula.harmonics import HORIZONTAL
from skylight_sh.formula.printers import JAVASCRIPT, Language
from skylight_sh.formula.window import SINC
from skylight_sh.runtime import ClassRows, Packed, Rows, Table
from skylight_sh.sphere import lower_hemisphere
from skylight_sh.table.rows import by_class
from skylight_sh.table.surroundings import PARTS

# What a caller needs of the parts; the rest is the module's own.
_PUBLIC = "const OK|function (?:applyExposure|applyGround|applyWindow|unpack)"


def write(table: Table, facts: Facts) -> str:
    """Return the text of the module of ``table``."""
    table = by_class(table)
    names = ["inputs", "rows" if isinstance(table.body, ClassRows) else "packed", "evaluate"]
    names += ["ground"] if "TAKES_GROUND" in features(table) else []
    names += [] if table.spec.windowed else ["window"]
    parts = [re.sub(rf"^export (?!{_PUBLIC})", "", part(f"javascript/{name}.mjs", ()), flags=re.M) for name in names]
    lines = [*_comment(table, facts), *_data(table), "", *_formulas(table), *parts, *_wrappers(table)]
    return re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).rstrip() + "\n"


def example(table: Table, twin: Table) -> str:
    """Return ``evaluators/javascript/example.mjs``: what the parts read of ``table``, and of its packed ``twin``."""
    lines = ["// What an export writes of one table, and a packed table's stream, for the parts as they stand."]
    lines += [*_data(table), *_stream(twin.body), "", *_formulas(table)]
    text = "\n".join(lines).rstrip() + "\n"
    return re.sub(r"^(const|function) ", r"export \1 ", text, flags=re.M)


def _comment(table: Table, facts: Facts) -> Iterator[str]:
    _, notes = c_comment.about(table)
    inputs = statements.inputs_of(table)
    middle = {axis.name: f"{(axis.low + axis.high) / 2:.3g}" for axis in table.axes}
    told = [
        f"{facts.title}: spherical-harmonics weights, evaluated from polynomials.",
        "",
        f"Written by skylight-sh {__version__}; the table and this code may be used by anyone for anything (CC0-1.0).",
        "An ES module for browsers and Node, without dependencies.",
        "",
        "Usage",
        '  import { weights, status } from "./skylight_sh.mjs";',
        f"  const w = weights({', '.join(middle.get(name, '0') for name in inputs)});",
        "w is a Float32Array of CHANNELS.length * WEIGHTS numbers, channel by channel; the last argument, if given, is "
        "filled instead of a new one. weightsBands takes the number of bands before it, weightsBatch an array an input; "
        "status returns OK, CLAMPED or INVALID for inputs. Types stand in skylight_sh.d.mts.",
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
        for one in textwrap.wrap(plain(line), COLUMNS - 3, subsequent_indent=indent, break_on_hyphens=False) or [""]:
            yield f"// {one}".rstrip()


def plain(line: str) -> str:
    """Keep text inside its line: no break that the language knows."""
    return re.sub(r"[\r\n\u2028\u2029]", " ", line)


def _data(table: Table) -> Iterator[str]:
    spec = table.spec
    unit, _ = c_comment.about(table)
    first, last = table.limits
    yield f"export const BANDS = {table.bands}, WEIGHTS = {table.bands**2};"
    yield f"export const CHANNELS = {json.dumps(list(table.channels))};"
    yield f"export const UNIT = {json.dumps(unit)};"
    yield "// Of each axis: the least and the largest input."
    ranges = [
        {"name": axis.name, "unit": axis.unit, "min": low, "max": high}
        for axis, (low, high) in zip(table.axes, table.ranges, strict=True)
    ]
    yield from _objects("export const AXES = ", ranges)
    yield f"const real = {'Math.fround' if table.dtype == np.float32 else '(value) => value'};"
    yield f"const channelCount = {len(table.channels)}, classCount = {spec.classes};"
    yield f"const firstCount = {table.degrees[0] + 1}, otherCount = {others(table)};"
    flags = {"mirrored": spec.mirrored, "windowed": spec.windowed, "mixed": is_mixed(table)}
    yield f"const {', '.join(f'{name} = {_json(value)}' for name, value in flags.items())};"
    yield "// The axis whose sine the sums of order m lack m times, or -1."
    yield f"const peak = {statements.peak_of(table)};"
    yield "// Of each axis: the first and last number that counts as inside, and the table's range."
    axes = [
        {"first": float(a), "last": float(b), "low": axis.low, "high": axis.high}
        for axis, a, b in zip(table.axes, first, last, strict=True)
    ]
    yield from _objects("const axes = ", axes)
    sinking = [axis.name for axis in table.axes].index(str(spec.peak_axis)) if spec.twilight else 0
    yield f"const twilight = {_json({'axis': sinking, 'depth': spec.twilight.depth} if spec.twilight else None)};"
    if table.surroundings:
        yield "const surroundings = {"
        for name in PARTS:
            yield from _array(f"{name}: ", "Float64Array", getattr(table.surroundings, name).ravel(), "),")
        yield "};"
    else:
        yield "const surroundings = null;"
    if "TAKES_GROUND" in features(table):
        yield "// What an even ground reflects of the weight l = 1, m = 0, and its own zonal weights."
        yield f"const reflected = {printers.double(HORIZONTAL / math.pi)};"
        yield from _array("const lowerHalf = ", "Float64Array", lower_hemisphere(table.bands), ");")
    yield from _terms(table)


def _terms(table: Table) -> Iterator[str]:
    body = table.body
    yield "// The degrees that carry anything; their sums follow one another."
    yield f"const degrees = {_json(statements.carried(table))}, width = {statements.width(table)};"
    if not isinstance(body, ClassRows):
        yield from _stream(body)
        return
    yield "// Of each class: how many rows each product of the other axes' functions has; a row a term."
    yield from _array("const lengths = ", "Uint8Array", body.lengths.ravel(), ");")
    kind = "Float64Array" if body.dtype == np.float64 else "Float32Array"
    yield from _array("const rows = ", kind, body.rows.ravel(), ");")


def _stream(body: ClassRows | Packed | Rows) -> Iterator[str]:
    if not isinstance(body, Packed):
        raise TypeError(f"A table of layout {body.kind!r} has no stream.")
    yield "// Runs, one a product of the other axes' functions; profiles; what one step is worth; Rice codes."
    yield "const runProfile = ["
    yield from (line[2:] for line in filled(map(str, body.rest_profile.tolist())))
    yield "];"
    yield f"const channelProfile = {_json(body.channel_profile.tolist())};"
    yield f"const step = {printers.double(float(np.float32(body.step)))};"
    yield from _array("const stream = ", "Uint8Array", np.frombuffer(body.stream, dtype=np.uint8), ");")


def _array(head: str, kind: str, values: np.ndarray, end: str) -> Iterator[str]:
    texts = [str(v) for v in values.tolist()] if values.dtype.kind in "iu" else [_number(v) for v in values]
    yield f"{head}new {kind}(["
    yield from (line[2:] for line in filled(texts))
    yield f"]{end}"


def _objects(head: str, values: Sequence[object]) -> Iterator[str]:
    """Yield a list of objects, one a line."""
    yield f"{head}["
    yield from (f"  {_json(value)}," for value in values)
    yield "];"


def _number(value: np.floating) -> str:
    return printers.single(float(value)) if value.dtype == np.float32 else printers.double(float(value))


def _json(value: object) -> str:
    return json.dumps(value)


def _formulas(table: Table) -> Iterator[str]:
    language = _language(table)
    yield "// What all weights share, or what each channel in turn takes of each class."
    yield from _function("factorsOf(x, to)", statements.of_factors(table, language))
    yield f"// The functions of {table.axes[0].name} (change of variable: {table.axes[0].map})."
    yield from _function("firstFunctions(x, to)", statements.of_axis(table, 0, language, "to"))
    yield "// All products of the other axes' functions, the last axis's fastest."
    yield from _function("otherFunctions(x, to)", _others(table))
    yield "// cos(m azimuth) and sin(m azimuth), each times the m-th power of the radius, by doubling."
    yield from _function("wavesOf(azimuth, radius, cosines, sines)", statements.of_waves(table.bands, language))
    yield "// The weights of orders m and -m turned by the azimuth (Habel et al. 2008, eq. 4)."
    lines, results = printers.statements(TURN, language, ["plus", "minus", "cosine", "sine"])
    yield from _function("turn(plus, minus, cosine, sine)", [*lines, f"return [{', '.join(results)}];"])
    yield "// The zonal window's factor for the degree `share` * bands (Habel et al. 2008, eq. 5)."
    yield from _function("sinc(share)", statements.returning(SINC, language, ["share"]))
    yield "// The share of the horizon's light at the sun's depth below it, 0 to 1."
    if table.spec.twilight:
        yield from _function("fade(depth)", statements.returning(table.spec.twilight.program, language, ["depth"]))
    else:
        yield from _function("fade()", ["return 1;"])


def _others(table: Table) -> list[str]:
    if len(table.axes) == 1:
        return ["to[0] = 1;"]
    lines = ["let count = 1;", "to[0] = 1;"]
    for axis in range(1, len(table.axes)):
        lines += [
            "{",
            "  const terms = [];",
            *(f"  {line}" for line in statements.of_axis(table, axis, _language(table), "terms")),
        ]
        lines += ["  for (let k = count - 1; k >= 0; --k) {", "    const product = to[k];"]
        lines += ["    terms.forEach((term, i) => { to[k * terms.length + i] = product * term; });", "  }"]
        lines += ["  count *= terms.length;", "}"]
    return lines


def _language(table: Table) -> Language:
    """Return how a table's formulas are printed: its numbers are those of its own arithmetic."""
    exact = replace(JAVASCRIPT, number=lambda value: printers.double(float(np.float32(value))))
    return exact if table.dtype == np.float32 else JAVASCRIPT


def _function(head: str, lines: Iterable[str]) -> Iterator[str]:
    yield f"function {head} {{"
    for line in lines:
        indent = " " * (len(line) - len(line.lstrip()) + 4)
        yield from textwrap.wrap(
            f"  {line}", COLUMNS, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False
        )
    yield "}"
    yield ""


def _wrappers(table: Table) -> Iterator[str]:
    names = statements.inputs_of(table)
    inputs, axes = ", ".join(names), ", ".join(axis.name for axis in table.axes)
    azimuth = printers.double(table.spec.azimuth) if table.spec.azimuth is not None else "sun_azimuth"
    out = "\n  weightsOut = new Float32Array(channelCount * WEIGHTS),\n"
    yield "// All bands."
    yield f"export function weights(\n  {inputs},{out}) {{"
    yield f"  evaluateTable([{axes}], {azimuth}, BANDS, weightsOut);"
    yield "  return weightsOut;\n}\n"
    yield "// The first bands, 1 to BANDS; the others are 0."
    yield f"export function weightsBands(\n  {inputs}, bandCount,{out}) {{"
    yield f"  evaluateTable([{axes}], {azimuth}, bandCount, weightsOut);"
    yield "  return weightsOut;\n}\n"
    one = ", ".join(f"{name}[k]" for name in (axis.name for axis in table.axes))
    count = f"{names[0]}.length"
    yield "// All bands of many suns, an array an input: one sun's weights after another."
    yield f"export function weightsBatch(\n  {inputs},"
    yield f"  weightsOut = new Float32Array({count} * channelCount * WEIGHTS),\n) {{"
    yield f"  for (let k = 0; k < {count}; ++k) {{"
    many = "sun_azimuth[k]" if table.spec.azimuth is None else azimuth
    yield "    const at = k * channelCount * WEIGHTS;"
    yield f"    evaluateTable([{one}], {many}, BANDS, weightsOut, at);"
    yield "  }\n  return weightsOut;\n}\n"
    yield "// OK, CLAMPED where an input lies outside its range, INVALID where one is no number or the azimuth not finite."
    yield f"export function status({inputs}) {{"
    yield f"  return clampInputs([{axes}], {azimuth}, []);"
    yield "}"
