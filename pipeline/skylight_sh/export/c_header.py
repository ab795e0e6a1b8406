"""Tables as C: one header, C99 and C++11, that evaluates, turns by azimuth and windows.

The evaluator stands in ``evaluators/c`` and is copied; what differs between tables is data (``c_data``), formulas printed
from their programs (``c_formulas``), and functions of the inputs' names that call the evaluator with arrays.
"""

from __future__ import annotations

import hashlib
import re
import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from skylight_sh import __version__
from skylight_sh.export import c_comment, c_data, c_formulas, evaluators, prefixes
from skylight_sh.export.evaluators import part, renamed, wrapped
from skylight_sh.runtime import Packed, Table
from skylight_sh.table.powers import in_powers
from skylight_sh.table.rows import by_class
from skylight_sh.table.size import bytes_of

# What errors are fractions of, by the convention's name.
_L_MIN = {"per-set": "least luminance of the same sky", "mean": "mean luminance of the same sky"}
_P, _p = "SKYLIGHT_SH", "skylight_sh"
_WEIGHTS = f"[{_P}_CHANNELS][{_P}_WEIGHTS]"


@dataclass(frozen=True)
class Facts:
    """What the header says about its table beside what the table knows itself.

    ``e_mean``, ``e_max`` as measured (fractions, ``l_min`` names the convention); ``least`` the least reconstructed
    luminance over the largest of its set, if it was measured; ``luminance`` the channels' factors to luminance.
    """

    title: str
    e_mean: float
    e_max: float
    l_min: str
    provenance: Sequence[str]
    least: float | None = None
    luminance: Sequence[float] = ()


def write(table: Table, facts: Facts, prefix: str = evaluators.PREFIX) -> str:
    """Return the text of the header of ``table``; every symbol starts with ``prefix``.

    Raises ValueError for a prefix that is no C identifier of lower-case letters, digits and underscores.
    """
    prefixes.check(prefix)
    table = in_powers(by_class(table))
    unit, _ = c_comment.about(table)
    has = c_data.features(table)
    declared = [*c_data.facts(table, unit, facts.e_mean, facts.e_max), "", *_declarations(table)]
    defined = [
        part("c/vectors.h", has),
        *c_data.data(table, facts.luminance),
        "",
        *c_formulas.functions(table),
        *c_formulas.slopes(table),
    ]
    evaluator = [part(f"c/{name}.h", has) for name in _parts(table)]
    body = [*defined, *evaluator, *_wrappers(table), part("c/extras.h", has)]
    # Tells tables under one prefix apart.
    sign = hashlib.sha256("\n".join([*declared, *body]).encode()).hexdigest()[:8]
    lines = [
        part("c/requirements.h", has),
        f"#ifndef {_P}_H",
        f"#define {_P}_H 0x{sign}",
        "",
        part("c/linkage.h", has),
        *declared,
        "",
        f"#elif {_P}_H != 0x{sign}",
        f'#error "Another table has the prefix {_p}_ already: export one of them under a prefix of its own."',
        f"#endif /* {_P}_H */",
        "",
        f"#if (!defined({_P}_EXTERN) || defined({_P}_IMPLEMENTATION)) && !defined({_P}_DEFINED)",
        f"#define {_P}_DEFINED",
        "",
        *body,
        f"#endif /* {_P}_DEFINED */",
    ]
    text = re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).replace(f"prefix {_p}_ already", f"prefix {prefix} already")
    return wrapped("\n".join(_comment(table, facts, prefix)) + "\n" + renamed(text, prefix))


def example(table: Table, twin: Table) -> str:
    """Return ``evaluators/c/example.h``: what the evaluator's files read of ``table``, and of its packed ``twin``.

    With it they compile as they stand.
    """
    lines = [
        "/* What an export writes of one table, and beside it a packed table's stream: with it these files compile as they",
        "   stand. Written by c_header.example. */",
        "#pragma once",
        '#include "linkage.h"',
        "",
        *(f"#define {_P}_{name} 1" for name in sorted(c_data.features(table))),
        '#include "vectors.h"',
        *c_data.facts(table, "cd/m2", 0.0, 0.0),
        *c_data.data(table, ()),
        c_data.unpacked(twin),
        *c_data.packed(twin),
        "",
        *c_formulas.functions(table),
        *c_formulas.slopes(table),
    ]
    return wrapped("\n".join(lines).rstrip())


def _parts(table: Table) -> list[str]:
    return ["inputs", "circle", "turn", "rows", *(["packed"] if _is_packed(table) else []), "evaluate", "batch", "gradient"]


def _is_packed(table: Table) -> bool:
    return isinstance(table.body, Packed)


def _inputs(table: Table) -> list[str]:
    """Return the names of the inputs in order: the first axis, the azimuth unless the table fixes it, the other axes."""
    names = [axis.name for axis in table.axes]
    return [names[0], *([] if table.spec.azimuth is not None else ["sun_azimuth"]), *names[1:]]


def _signatures(table: Table) -> dict[str, tuple[str, str]]:
    """Return of each public function of the inputs its parameters, and what it returns."""
    inputs, axes = _inputs(table), [axis.name for axis in table.axes]
    fixed = table.spec.azimuth is not None
    numbers = ", ".join(f"float {name}" for name in inputs)
    arrays = ", ".join(f"const float *{name}" for name in inputs)
    azimuth = f"{_P}_AZIMUTH" if fixed else "sun_azimuth"
    one, many = f"{{ {', '.join(axes)} }}", "NULL" if fixed else "sun_azimuth"
    # Of a name that no axis has.
    given = f"{_p}_given"
    single = f"    const float {given}[{_P}_AXES] = {one};\n"
    batch = f"    const float *const {given}[{_P}_AXES] = {one};\n"
    packed = _is_packed(table)
    rows = "NULL" if packed else f"{_p}_rows"
    found = {
        "weights": (
            f"{numbers}, float weights{_WEIGHTS}",
            f"{single}    return {_p}_evaluate({rows}, {given}, {azimuth}, {_P}_BANDS, weights);",
        ),
        "weights_bands": (
            f"{numbers}, int bands, float weights{_WEIGHTS}",
            f"{single}    return {_p}_evaluate({rows}, {given}, {azimuth}, bands, weights);",
        ),
        "weights_batch": (
            f"int count, {arrays}, float (*weights){_WEIGHTS}",
            f"{batch}    return {_p}_evaluate_batch({rows}, count, {given}, {many}, weights);",
        ),
        "weights_columns": (
            f"int count, {arrays}, float *weights",
            f"{batch}    return {_p}_evaluate_columns({rows}, count, {given}, {many}, weights);",
        ),
        "weights_gradient": (
            f"{numbers}, float weights{_WEIGHTS}, float gradient[{_P}_AXES]{_WEIGHTS}",
            f"{single}    return {_p}_evaluate_gradient({rows}, {given}, {azimuth}, weights, gradient);",
        ),
    }
    if not packed:
        return found
    memory = f"float memory[{_P}_UNPACKED]"
    # Decoded once, for all suns.
    for name, called in (("weights_batch", "evaluate_batch"), ("weights_columns", "evaluate_columns")):
        found[name] = (
            found[name][0],
            f"{batch}    float {_p}_memory[{_P}_UNPACKED];\n    if (count > 1) {_p}_unpack_rows({_p}_memory);\n"
            f"    return {_p}_{called}(count > 1 ? {_p}_memory : NULL, count, {given}, {many}, weights);",
        )
    return found | {
        "unpack": (memory, f"    {_p}_unpack_rows(memory);"),
        "unpacked_weights": (
            f"const {memory}, {numbers}, float weights{_WEIGHTS}",
            f"{single}    return {_p}_evaluate(memory, {given}, {azimuth}, {_P}_BANDS, weights);",
        ),
        "unpacked_weights_bands": (
            f"const {memory}, {numbers}, int bands, float weights{_WEIGHTS}",
            f"{single}    return {_p}_evaluate(memory, {given}, {azimuth}, bands, weights);",
        ),
        "unpacked_weights_batch": (
            f"const {memory}, int count, {arrays}, float (*weights){_WEIGHTS}",
            f"{batch}    return {_p}_evaluate_batch(memory, count, {given}, {many}, weights);",
        ),
        "unpacked_weights_columns": (
            f"const {memory}, int count, {arrays}, float *weights",
            f"{batch}    return {_p}_evaluate_columns(memory, count, {given}, {many}, weights);",
        ),
    }


def _result(name: str) -> str:
    """Return the type of what a public function of the inputs returns."""
    return "void" if name == "unpack" else "int"


def _declarations(table: Table) -> Iterator[str]:
    has = c_data.features(table)
    axes = ", ".join(axis.name for axis in table.axes)
    told = {
        "weights": "Evaluates all bands.",
        "weights_bands": f"Evaluates the first `bands` bands (1 to {_P}_BANDS, clamped likewise) and zeroes the rest.",
        "weights_batch": "Evaluates `count` suns from arrays; returns the largest status."
        + ("" if "HAS_ROWS" in has else f" Unpacks the table once, {_P}_UNPACKED floats on the stack."),
        "weights_columns": f"The same with the suns of each weight side by side: [{_P}_CHANNELS][{_P}_WEIGHTS][count].",
        "weights_gradient": f"Evaluates all bands and their derivatives after each axis ({axes}), per unit of the axis; "
        "beyond a range, those at its edge.",
        "unpack": f"Unpacks the table into memory of the caller's, {_P}_UNPACKED floats, for the calls below.",
        "unpacked_weights": "Evaluates all bands of an unpacked table: far faster than of the packed one.",
        "unpacked_weights_bands": "The same for the first `bands` bands.",
        "unpacked_weights_batch": "The same for `count` suns from arrays; returns the largest status.",
        "unpacked_weights_columns": f"The same as [{_P}_CHANNELS][{_P}_WEIGHTS][count].",
    }
    for name, (parameters, _) in _signatures(table).items():
        yield from evaluators.commented(told[name])
        yield f"{_P}_API {_result(name)} {_p}_{name}({parameters});"
    if "HAS_DIRECTION" in has:
        yield "/* Unit vector of the dominant light. Returns 0, or 1 (and straight up) where there is none. */"
        yield f"#define {_p}_dominant(weights, direction) \\"
        yield f"    {_p}_dominant_of(&(weights)[0][0], direction)"
        yield f"{_P}_API int {_p}_dominant_of(const float *weights, float direction[3]);"
    if "TAKES_GROUND" in has:
        yield "/* Optional: adds an even ground of this albedo below the horizon, lit by the sky (before any window). */"
        yield f"{_P}_API void {_p}_ground(const float albedo[{_P}_CHANNELS], float weights{_WEIGHTS});"
    if "IS_WINDOWED" not in has:
        yield "/* Optional: tames the ringing of the horizon by the zonal window of the first `bands` bands. */"
        yield f"{_P}_API void {_p}_window(int bands, float weights{_WEIGHTS});"


def _wrappers(table: Table) -> Iterator[str]:
    for name, (parameters, body) in _signatures(table).items():
        yield f"{_P}_API {_result(name)} {_p}_{name}({parameters})\n{{\n{body}\n}}\n"


def _comment(table: Table, facts: Facts, prefix: str) -> Iterator[str]:
    p, upper, fast = prefix, prefix.upper(), not _is_packed(table)
    _, notes = c_comment.about(table)
    middle = {axis.name: c_data.single(float(f"{(axis.low + axis.high) / 2:.3g}")) for axis in table.axes}
    example = ", ".join(middle.get(name, "0.0f") for name in _inputs(table))
    yield f"/* {c_comment.safe(facts.title)}: spherical-harmonics weights, evaluated from polynomials."
    told = [
        "",
        f"Written by skylight-sh {__version__}; the table and this code may be used by anyone for anything (CC0-1.0).",
        "C99 and C++11, no allocation, no global written, nothing static but constants: any thread may call it.",
        "",
        "Usage",
        f"  float w[{upper}_CHANNELS][{upper}_WEIGHTS];",
        f"  int status = {p}_weights({example}, w);",
        "Compile with, for instance",
        "  cc -std=c99 -O3 program.c -o program -lm",
        "Included plainly, the file is all there is: its functions are static, and the table stands in every unit that "
        f"includes it. With {upper}_EXTERN defined before it, it declares only; the one unit that also defines "
        f"{upper}_IMPLEMENTATION holds functions and table, for C and C++.",
        "",
        "Inputs",
        *(f"  {line}" for line in c_comment.input_lines(table)),
        *([] if table.spec.azimuth is not None else ["  sun_azimuth: any finite angle, rad"]),
        "Output",
        *(f"  {line}" for line in notes),
        f"  Define {upper}_EXPOSURE before this file (where it holds the table) to multiply all weights (1 by default).",
        "",
        f"Accuracy, as shipped: E_mean {100 * facts.e_mean:.3g} %, E_max {100 * facts.e_max:.3g} % of the "
        f"{_L_MIN.get(facts.l_min, c_comment.safe(facts.l_min))}, at azimuth 0.",
        *_ringing(table, facts),
        f"Memory: {bytes_of(table)} bytes of constants, "
        f"{'laid out for speed' if fast else 'packed into few bytes (a fast table takes more and less time)'}.",
        "",
        "Provenance",
        *(f"  {c_comment.safe(line)}" for line in facts.provenance),
    ]
    for line in told:
        indent = " " * (len(line) - len(line.lstrip()))
        found = textwrap.wrap(line, evaluators.COLUMNS - 3, subsequent_indent=indent, break_on_hyphens=False)
        yield from (f" * {one}" for one in found or [""])
    yield " */"


def _ringing(table: Table, facts: Facts) -> Iterator[str]:
    if facts.least is not None and facts.least < 0:
        tamed = "" if table.spec.windowed else "; the window below tames it"
        told = "The expansion rings: the least value it takes, over all directions and measured sets, is"
        yield f"{told} {100 * facts.least:.3g} % of its largest in the same set{tamed}."
