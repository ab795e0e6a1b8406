"""Tables as C: one header, C99 and C++11, that evaluates, turns by azimuth and windows."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined, Template, select_autoescape

from skylight_sh import __version__
from skylight_sh.export import c_comment, c_rows
from skylight_sh.export.c_rows import Number
from skylight_sh.formula import printers
from skylight_sh.formula.bases import BASES
from skylight_sh.formula.printers import C_DOUBLE, C_SINGLE, Language
from skylight_sh.runtime import Packed, Program, Rows, Table
from skylight_sh.sphere import lower_hemisphere
from skylight_sh.table import twilight
from skylight_sh.table.prefactor import CLOSED_FORM
from skylight_sh.table.size import bytes_of
from skylight_sh.table.surroundings import PARTS
from skylight_sh.table.table import float32_limits

PREFIX = re.compile(r"[a-z][a-z0-9_]{0,31}")


# What errors are fractions of, by the convention's name.
_L_MIN = {"per-set": "least luminance of the same sky", "mean": "mean luminance of the same sky"}


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


def write(table: Table, facts: Facts, prefix: str = "skylight_sh") -> str:
    """Return the text of the header of ``table``; every symbol starts with ``prefix``.

    Raises ValueError for a prefix that is no C identifier of lower-case letters, digits and underscores.
    """
    if not PREFIX.fullmatch(prefix):
        raise ValueError(f"Invalid prefix {prefix!r}. Should be a lower-case C identifier of at most 32 characters.")
    double = table.dtype == np.float64
    number, suffix = (_double, "") if double else (_single, "f")
    names = [axis.name for axis in table.axes]
    azimuth = [] if table.spec.azimuth is not None else ["sun_azimuth"]
    inputs = [names[0], *azimuth, *names[1:]]
    middle = {axis.name: _single(float(f"{(axis.low + axis.high) / 2:.3g}")) for axis in table.axes}
    unit, notes = c_comment.about(table)
    turned = None if table.spec.azimuth is None else _single(table.spec.azimuth)
    fast = isinstance(table.body, Rows)
    return template("skylight_sh.h.j2").render(
        p=prefix,
        P=prefix.upper(),
        version=__version__,
        title=c_comment.safe(facts.title),
        example=", ".join(middle.get(name, "0.0f") for name in inputs),
        inputs=c_comment.input_lines(table) + [f"{name}: any finite angle, rad" for name in azimuth],
        channels=table.channels,
        unit=unit,
        notes=notes,
        twilight=_twilight(table, number),
        around=_around(table, number),
        fixed_azimuth=table.spec.azimuth is not None,
        windowed=table.spec.windowed,
        ground_added=_lower(table),
        e_mean=facts.e_mean,
        e_max=facts.e_max,
        l_min=_L_MIN.get(facts.l_min, c_comment.safe(facts.l_min)),
        least=facts.least,
        bytes=bytes_of(table),
        about_layout="laid out for speed" if fast else "packed into few bytes (a fast table takes more and less time)",
        provenance=[c_comment.safe(line) for line in facts.provenance],
        bands=table.bands,
        real="double" if double else "float",
        fn={"cos": f"cos{suffix}", "sin": f"sin{suffix}"},
        body="rows_body.j2" if fast else "packed_body.j2",
        fast=fast,
        rows=c_rows.parts(table, prefix, number) if fast else None,
        packed=_packed(table.body, number) if isinstance(table.body, Packed) else None,
        axes=_axes(table, number),
        xs=", ".join(f"x[{i}]" for i in range(len(names))),
        rest=_rest(table),
        mirrored=table.spec.mirrored,
        # Derivatives of other bases are not written, nor those of twilight.
        gradient=table.spec.basis == "chebyshev" and not table.spec.twilight,
        factor=_factor(table),
        luminance=[_single(v) for v in facts.luminance or [1.0] * len(table.channels)],
        azimuth=f"({prefix}_real){turned or 'sun_azimuth'}",
        azimuth_element=f"({prefix}_real){turned or 'sun_azimuth[s]'}",
        parameters=", ".join(f"float {name}" for name in inputs),
        arguments=", ".join(inputs),
        arrays=", ".join(f"const float *{name}" for name in inputs),
        elements=", ".join(f"{name}[s]" for name in inputs),
    )


def _twilight(table: Table, number: Number) -> dict[str, str] | None:
    """Return the numbers of the fade; the horizon in two parts, since float32 pi / 2 exceeds pi / 2."""
    if not table.spec.twilight:
        return None
    return {
        "begin": number(twilight.BEGIN),
        "rest": number(0.0 if table.dtype == np.float64 else twilight.REST),
        "each": number(1.0 / twilight.DEPTH),
        "body": _body(table.spec.twilight.program, C_DOUBLE if table.dtype == np.float64 else C_SINGLE, ["x"]),
        "axis": str(table.spec.peak_axis),
    }


def _around(table: Table, number: Number) -> dict[str, list[str]] | None:
    """Return the constants of the surroundings, row after row."""
    found = table.surroundings
    if not found:
        return None
    return {name: [number(v) for v in getattr(found, name).ravel().tolist()] for name in PARTS}


def _lower(table: Table) -> list[str]:
    """Return the zonal weights of an even ground, where one can be added to the table's weights at run time."""
    around = table.surroundings
    if table.bands < 2 or table.spec.ground != "black" or table.spec.windowed or table.spec.quantity != "radiance" or around:
        return []
    return [_single(value) for value in lower_hemisphere(table.bands).tolist()]


def template(name: str) -> Template:
    """Return a template of C text."""
    return _TEMPLATES.get_template(name)


def _axes(table: Table, number: Number) -> list[dict[str, object]]:
    found: list[dict[str, object]] = []
    language = C_DOUBLE if table.dtype == np.float64 else C_SINGLE
    limits = zip(table.ranges, float32_limits(table), strict=True)
    for axis, degree, ((least, most), (first, last)) in zip(table.axes, table.degrees, limits, strict=True):
        program = BASES[table.spec.basis].program(degree, shallow=True)
        targets = [f"t[{k}]" for k in range(degree + 1)]
        found.append(
            {
                "name": axis.name,
                "map": axis.map,
                "terms": degree + 1,
                # Loops over terms run in fours.
                "room": -(-(degree + 1) // 4) * 4,
                "body": _body(axis.variable, language, ["v"]),
                "wide_body": _body(axis.variable, C_DOUBLE, ["v"]),
                "fill": "\n".join(printers.assignments(program, language, ["u"], targets)),
                "low": number(axis.low),
                "high": number(axis.high),
                "least": number(least),
                "most": number(most),
                "wide_low": _double(axis.low),
                "wide_high": _double(axis.high),
                "first": _single(first),
                "last": _single(last),
            }
        )
    return found


def _packed(body: Packed, number: Number) -> dict[str, object]:
    return {
        "stream": list(body.stream),
        "rest": body.rest_profile.tolist(),
        "channel": body.channel_profile.tolist(),
        "step": number(body.step),
    }


def _factor(table: Table) -> dict[str, str]:
    """Return what the template needs of the table's factor; the fit divided by the same."""
    scale = table.spec.scale
    if not scale:
        return {"kind": "none", "about": "nothing"}
    closed = scale.kind == CLOSED_FORM
    inputs = [f"x{a}" for a in range(len(table.axes))]
    return {
        "kind": scale.kind,
        "about": f"the closed form {scale.name}" if closed else "1 over a polynomial in the same variables",
        "body": _body(scale.program, C_DOUBLE if table.dtype == np.float64 else C_SINGLE, inputs),
        "wide_body": _body(scale.program, C_DOUBLE, inputs),
    }


def _body(program: Program, language: Language, inputs: Sequence[str]) -> str:
    """Return the statements of a function of one result."""
    lines, results = printers.statements(program, language, inputs)
    read = {int(step[1]) for step in program.steps if step[0] == "input"}
    # Compilers warn of what a factor of fewer axes leaves aside.
    aside = [f"(void){name};" for place, name in enumerate(inputs) if place not in read]
    return "\n".join([*aside, *lines, f"return {results[0]};"])


def _rest(table: Table) -> int:
    """Return the number of products of the other axes' powers."""
    return int(np.prod([d + 1 for d in table.degrees[1:]], dtype=int))


def _single(value: float) -> str:
    return _pointed(f"{float(np.float32(value)):.9g}") + "f"


def _double(value: float) -> str:
    return _pointed(f"{value:.17g}")


def _pointed(text: str) -> str:
    """Add the point without which a C number is no floating one."""
    return text if any(c in text for c in ".en") else text + ".0"


_TEMPLATES = Environment(
    loader=PackageLoader("skylight_sh.export"),
    undefined=StrictUndefined,
    keep_trailing_newline=True,
    # C is no markup; ``_comment`` keeps text inside its comment.
    autoescape=select_autoescape(default=False),
)
