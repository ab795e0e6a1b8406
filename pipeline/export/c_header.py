"""Tables as C: one header, C99 and C++11, that evaluates, turns by azimuth and windows."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

from pipeline import __version__
from pipeline.export import c_rows
from pipeline.export.c_rows import Number
from pipeline.fit.bases import BASES
from pipeline.fit.maps import MAPS
from pipeline.light import PREFACTORS
from pipeline.table.factor import ClosedForm, Reciprocal
from pipeline.table.packed import Packed
from pipeline.table.rows import Rows
from pipeline.table.table import SLACK, Table

PREFIX = re.compile(r"[a-z][a-z0-9_]{0,31}")


@dataclass(frozen=True)
class Facts:
    """What the header says about its table: title, measured errors (fractions), convention, provenance lines."""

    title: str
    e_mean: float
    e_max: float
    l_min: str
    provenance: Sequence[str]


def write(table: Table, facts: Facts, prefix: str = "skylight_sh") -> str:
    """Return the text of the header of ``table``; every symbol starts with ``prefix``.

    Raises ValueError for a prefix that is no C identifier of lower-case letters, digits and underscores.
    """
    if not PREFIX.fullmatch(prefix):
        raise ValueError(f"Invalid prefix {prefix!r}. Should be a lower-case C identifier of at most 32 characters.")
    number = _double if table.dtype == np.float64 else _single
    suffix = "" if table.dtype == np.float64 else "f"
    names = [axis.name for axis in table.axes]
    middle = [_single(float(f"{(axis.low + axis.high) / 2:.3g}")) for axis in table.axes]
    inputs = [names[0], "sun_azimuth", *names[1:]]
    fast = isinstance(table.body, Rows)
    return _TEMPLATES.get_template("skylight_sh.h.j2").render(
        p=prefix,
        P=prefix.upper(),
        version=__version__,
        title=_comment(facts.title),
        example=", ".join([middle[0], "0.0f", *middle[1:]]),
        inputs=[f"{a.name}: [{a.low:.9g}, {a.high:.9g}] {'' if a.unit == '1' else a.unit}".rstrip() for a in table.axes]
        + ["sun_azimuth: any finite angle, rad"],
        channels=table.channels,
        e_mean=facts.e_mean,
        e_max=facts.e_max,
        l_min=_comment(facts.l_min),
        bytes=table.bytes,
        about_layout="laid out for speed" if fast else "packed into few bytes (a fast table takes more and less time)",
        provenance=[_comment(line) for line in facts.provenance],
        bands=table.bands,
        real="double" if table.dtype == np.float64 else "float",
        fn={"cos": f"cos{suffix}", "sin": f"sin{suffix}"},
        body="rows_body.j2" if fast else "packed_body.j2",
        spread="rows_spread.j2" if fast else "packed_spread.j2",
        rows=c_rows.parts(table, prefix, number) if isinstance(table.body, Rows) else None,
        packed=_packed(table.body, number) if isinstance(table.body, Packed) else None,
        axes=_axes(table, prefix, suffix, number),
        rest=table.rest,
        mirrored=table.mirrored,
        prefactor=_prefactor(table, number),
        denominator=_denominator(table, number),
        parameters=", ".join(f"float {name}" for name in inputs),
        arguments=", ".join(inputs),
    )


def _axes(table: Table, prefix: str, suffix: str, number: Number) -> list[dict[str, object]]:
    low = table.factor.coefficients.shape if isinstance(table.factor, Reciprocal) else (1,) * len(table.axes)
    found: list[dict[str, object]] = []
    for axis, degree, least in zip(table.axes, table.degrees, low, strict=True):
        terms = max(degree + 1, least)
        expression = MAPS[axis.map].c_expression.replace("LOG", f"log{suffix}").replace("CBRT", f"cbrt{suffix}")
        found.append(
            {
                "name": axis.name,
                "map": axis.map,
                "powers": degree + 1,
                "terms": terms,
                # Loops over terms run in fours.
                "room": -(-terms // 4) * 4,
                "constants": [number(c) for c in axis.constants],
                "expression": expression,
                "fill": _fill(table.basis, prefix, suffix),
                "low": number(axis.low),
                "high": number(axis.high),
                "slack": number(SLACK * max(axis.high - axis.low, 1.0)),
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


def _denominator(table: Table, number: Number) -> dict[str, object] | None:
    if not isinstance(table.factor, Reciprocal):
        return None
    found = table.factor.coefficients
    return {"numbers": [number(float(c)) for c in found.ravel()], "sizes": found.shape}


def _fill(basis: str, prefix: str, suffix: str) -> str:
    """Return the basis's C statements in the table's number type."""
    text = re.sub(r"\breal\b", f"{prefix}_real", BASES[basis].c_fill)
    return text.replace("COS(", f"cos{suffix}(").replace("SIN(", f"sin{suffix}(")


def _prefactor(table: Table, number: Number) -> dict[str, object] | None:
    if not isinstance(table.factor, ClosedForm):
        return None
    body = PREFACTORS[table.factor.name].c_body
    if table.dtype == np.float64:
        body = re.sub(r"\b(tan|cos|sin|exp|log)f\b", r"\1", re.sub(r"(\d\.\d+)f\b", r"\1", body))
        body = re.sub(r"\bfloat\b", "double", body)
    return {"name": table.factor.name, "constants": [number(c) for c in table.factor.constants], "body": body}


def _single(value: float) -> str:
    return _pointed(f"{float(np.float32(value)):.9g}") + "f"


def _double(value: float) -> str:
    return _pointed(f"{value:.17g}")


def _pointed(text: str) -> str:
    """Add the point without which a C number is no floating one."""
    return text if any(c in text for c in ".en") else text + ".0"


def _comment(text: str) -> str:
    """Keep text from ending the comment that holds it."""
    return text.replace("*/", "* /").replace("\n", " ")


_TEMPLATES = Environment(
    loader=PackageLoader("pipeline.export"),
    undefined=StrictUndefined,
    keep_trailing_newline=True,
    # C is no markup; ``_comment`` keeps text inside its comment.
    autoescape=select_autoescape(default=False),
)
