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
from numpy.typing import NDArray

from skylight_sh import __version__
from skylight_sh.export import c_comment
from skylight_sh.export.c_data import functions_of
from skylight_sh.export.c_header import Facts
from skylight_sh.export.evaluators import COLUMNS, filled, part
from skylight_sh.formula import printers
from skylight_sh.formula.azimuth import TURN, stretched_waves, waves_of_angle
from skylight_sh.formula.bases import BASES
from skylight_sh.formula.harmonics import HORIZONTAL
from skylight_sh.formula.printers import JAVASCRIPT, Language
from skylight_sh.formula.window import SINC
from skylight_sh.runtime import ClassRows, Packed, Program, Rows, Table
from skylight_sh.sphere import lower_hemisphere
from skylight_sh.table.rows import by_class
from skylight_sh.table.surroundings import PARTS

# What a caller needs of the parts; the rest is the module's own.
_PUBLIC = "const OK|function (?:applyExposure|applyGround|applyWindow|unpack)"


def write(table: Table, facts: Facts) -> str:
    """Return the text of the module of ``table``."""
    table = by_class(table)
    names = ["inputs", "rows" if isinstance(table.body, ClassRows) else "packed", "evaluate"]
    names += ["ground"] if takes_ground(table) else []
    names += [] if table.spec.windowed else ["window"]
    parts = [re.sub(rf"^export (?!{_PUBLIC})", "", part(f"javascript/{name}.mjs", ()), flags=re.M) for name in names]
    lines = [*_comment(table, facts), *_data(table), "", *_formulas(table), *parts, *_wrappers(table)]
    return re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).rstrip() + "\n"


def takes_ground(table: Table) -> bool:
    """Say whether an even ground can be added to a table's weights."""
    black = table.spec.ground == "black" and not table.surroundings
    return black and not table.spec.windowed and table.spec.quantity == "radiance" and table.bands > 1


def inputs_of(table: Table) -> list[str]:
    """Return the names of the inputs in order: the first axis, the azimuth unless the table fixes it, the other axes."""
    first, *rest = (axis.name for axis in table.axes)
    return [first, *([] if table.spec.azimuth is not None else ["sun_azimuth"]), *rest]


def example(table: Table, twin: Table) -> str:
    """Return ``evaluators/javascript/example.mjs``: what the parts read of ``table``, and of its packed ``twin``."""
    lines = ["// What an export writes of one table, and a packed table's stream, for the parts as they stand."]
    lines += [*_data(table), *_stream(twin.body), "", *_formulas(table)]
    text = "\n".join(lines).rstrip() + "\n"
    return re.sub(r"^(const|function) ", r"export \1 ", text, flags=re.M)


def _comment(table: Table, facts: Facts) -> Iterator[str]:
    _, notes = c_comment.about(table)
    inputs = inputs_of(table)
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
    rest = int(np.prod([degree + 1 for degree in table.degrees[1:]], dtype=int))
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
    yield f"const firstCount = {table.degrees[0] + 1}, otherCount = {rest};"
    mixed = spec.scale is not None and len(spec.scale.program.outputs) > 1
    yield f"const mirrored = {_json(spec.mirrored)}, windowed = {_json(spec.windowed)}, mixed = {_json(mixed)};"
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
    if takes_ground(table):
        yield "// What an even ground reflects of the weight l = 1, m = 0, and its own zonal weights."
        yield f"const reflected = {printers.double(HORIZONTAL / math.pi)};"
        yield from _array("const lowerHalf = ", "Float64Array", lower_hemisphere(table.bands), ");")
    yield from _terms(table)


def _terms(table: Table) -> Iterator[str]:
    body = table.body
    carried = np.unique(np.sqrt(table.places)[_columns(table) >= 0].astype(int))
    yield "// The degrees that carry anything; their sums follow one another."
    yield f"const degrees = {_json(carried.tolist())}, width = {int(_columns(table).max()) + 1};"
    if not isinstance(body, ClassRows):
        yield from _stream(body)
        return
    yield "// Of each class: how many rows each product of the other axes' functions has; a row a term."
    yield from _array("const lengths = ", "Uint8Array", body.lengths.ravel(), ");")
    kind = "Float64Array" if body.dtype == np.float64 else "Float32Array"
    yield from _array("const rows = ", kind, body.rows.ravel(), ");")


def _columns(table: Table) -> NDArray[np.integer]:
    return table.body.columns if isinstance(table.body, ClassRows) else np.arange(table.places.size)


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
    x = [f"x[{axis}]" for axis in range(len(table.axes))]
    yield "// What all weights share, or what each channel in turn takes of each class."
    yield from _function("factorsOf(x, out)", _factors(table, language, x))
    yield f"// The functions of {table.axes[0].name} (change of variable: {table.axes[0].map})."
    yield from _function("firstFunctions(x, out)", _assigned(table, 0, "out"))
    yield "// All products of the other axes' functions, the last axis's fastest."
    yield from _function("otherFunctions(x, out)", _others(table))
    targets = [f"{name}[{m}]" for name in ("cosines", "sines") for m in range(table.bands)]
    if table.spec.parity:
        yield "// cos(m azimuth) and sin(m azimuth) times sin^m of the peak's zenith angle, by doubling."
        peak = [axis.name for axis in table.axes].index(str(table.spec.peak_axis))
        lines = [f"const sine = Math.sin(x[{peak}]);"]
        lines += printers.assignments(stretched_waves(table.bands), language, ["azimuth", "sine"], targets)
    else:
        yield "// cos(m azimuth) and sin(m azimuth), by doubling."
        lines = printers.assignments(waves_of_angle(table.bands), language, ["azimuth"], targets)
    yield from _function("wavesOf(x, azimuth, cosines, sines)", lines)
    yield "// The weights of orders m and -m turned by the azimuth (Habel et al. 2008, eq. 4)."
    lines, results = printers.statements(TURN, language, ["plus", "minus", "cosine", "sine"])
    yield from _function("turn(plus, minus, cosine, sine)", [*lines, f"return [{', '.join(results)}];"])
    yield "// The zonal window's factor for the degree `share` * bands (Habel et al. 2008, eq. 5)."
    yield from _function("sinc(share)", _returning(SINC, language, ["share"]))
    yield "// The share of the horizon's light at the sun's depth below it, 0 to 1."
    if table.spec.twilight:
        yield from _function("fade(depth)", _returning(table.spec.twilight.program, language, ["depth"]))
    else:
        yield from _function("fade()", ["return 1;"])


def _factors(table: Table, language: Language, x: Sequence[str]) -> list[str]:
    program = table.spec.scale.program if table.spec.scale else None
    targets = [f"out[{k}]" for k in range(len(program.outputs) if program else 1)]
    return printers.assignments(program, language, x, targets) if program else ["out[0] = 1;"]


def _assigned(table: Table, axis: int, array: str) -> list[str]:
    program = functions_of(table, axis, BASES[table.spec.basis].program(table.degrees[axis], shallow=True))
    targets = [f"{array}[{k}]" for k in range(len(program.outputs))]
    return printers.assignments(program, _language(table), [f"x[{axis}]"], targets)


def _others(table: Table) -> list[str]:
    if len(table.axes) == 1:
        return ["out[0] = 1;"]
    lines = ["let count = 1;", "out[0] = 1;"]
    for axis in range(1, len(table.axes)):
        lines += ["{", "  const terms = [];", *(f"  {line}" for line in _assigned(table, axis, "terms"))]
        lines += ["  for (let k = count - 1; k >= 0; --k) {", "    const product = out[k];"]
        lines += ["    terms.forEach((term, i) => { out[k * terms.length + i] = product * term; });", "  }"]
        lines += ["  count *= terms.length;", "}"]
    return lines


def _language(table: Table) -> Language:
    """Return how a table's formulas are printed: its numbers are those of its own arithmetic."""
    exact = replace(JAVASCRIPT, number=lambda value: printers.double(float(np.float32(value))))
    return exact if table.dtype == np.float32 else JAVASCRIPT


def _returning(program: Program, language: Language, inputs: Sequence[str]) -> list[str]:
    lines, results = printers.statements(program, language, inputs)
    return [*lines, f"return {results[0]};"]


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
    names = inputs_of(table)
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
