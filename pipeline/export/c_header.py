"""Tables as C: one header, C99 and C++11, that evaluates, turns by azimuth and windows."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined, Template, select_autoescape

from pipeline import __version__
from pipeline.export import c_rows
from pipeline.export.c_rows import Number
from pipeline.fit.bases import BASES
from pipeline.fit.maps import MAPS
from pipeline.light import PREFACTORS
from pipeline.sphere import clamped_cosine, lower_hemisphere
from pipeline.table import twilight
from pipeline.table.factor import ClosedForm, Reciprocal
from pipeline.table.packed import Packed
from pipeline.table.rows import Rows
from pipeline.table.surroundings import PARTS
from pipeline.table.table import Table

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
    azimuth = [] if table.azimuth is not None else ["sun_azimuth"]
    inputs = [names[0], *azimuth, *names[1:]]
    middle = {axis.name: _single(float(f"{(axis.low + axis.high) / 2:.3g}")) for axis in table.axes}
    quantity, unit, notes = _about(table)
    turned = "0.0f" if table.azimuth is None else _single(table.azimuth)
    fast = isinstance(table.body, Rows)
    return template("skylight_sh.h.j2").render(
        p=prefix,
        P=prefix.upper(),
        version=__version__,
        title=_comment(facts.title),
        example=", ".join(middle.get(name, "0.0f") for name in inputs),
        inputs=input_lines(table) + [f"{name}: any finite angle, rad" for name in azimuth],
        channels=table.channels,
        quantity=quantity,
        unit=unit,
        notes=notes,
        twilight=_twilight(table, number),
        around=_around(table, number),
        fixed_azimuth=table.azimuth is not None,
        windowed=table.windowed,
        ground=_below(table),
        ground_added=_lower(table),
        e_mean=facts.e_mean,
        e_max=facts.e_max,
        l_min=_L_MIN.get(facts.l_min, _comment(facts.l_min)),
        least=facts.least,
        bytes=table.bytes,
        about_layout="laid out for speed" if fast else "packed into few bytes (a fast table takes more and less time)",
        provenance=[_comment(line) for line in facts.provenance],
        bands=table.bands,
        real="double" if double else "float",
        fn={"cos": f"cos{suffix}", "sin": f"sin{suffix}"},
        body="rows_body.j2" if fast else "packed_body.j2",
        fast=fast,
        rows=c_rows.parts(table, prefix, number) if fast else None,
        packed=_packed(table.body, number) if isinstance(table.body, Packed) else None,
        axes=_axes(table, prefix, suffix, number),
        xs=", ".join(f"x[{i}]" for i in range(len(names))),
        rest=table.rest,
        mirrored=table.mirrored,
        # Derivatives of other bases are not written, nor those of twilight.
        gradient=table.basis == "chebyshev" and not table.twilight,
        factor=_factor(table, number),
        luminance=[_single(v) for v in facts.luminance or [1.0] * len(table.channels)],
        azimuth=f"({prefix}_real){turned if table.azimuth is not None else 'sun_azimuth'}",
        azimuth_element=f"({prefix}_real){turned if table.azimuth is not None else 'sun_azimuth[s]'}",
        parameters=", ".join(f"float {name}" for name in inputs),
        arguments=", ".join(inputs),
        arrays=", ".join(f"const float *{name}" for name in inputs),
        elements=", ".join(f"{name}[s]" for name in inputs),
    )


def input_lines(table: Table) -> list[str]:
    """Return the axes with their ranges and units, a line each."""
    units = ["" if axis.unit == "1" else axis.unit for axis in table.axes]
    return [
        f"{axis.name}: [{low:.9g}, {high:.9g}] {unit}".rstrip()
        for axis, (low, high), unit in zip(table.axes, table.ranges, units, strict=True)
    ]


def _twilight(table: Table, number: Number) -> dict[str, str] | None:
    """Return the numbers of the fade; the horizon in two parts, since float32 pi / 2 exceeds pi / 2."""
    if not table.twilight:
        return None
    rest = 0.0 if table.dtype == np.float64 else twilight.BEGIN - float(np.float32(twilight.BEGIN))
    return {
        "begin": number(twilight.BEGIN),
        "rest": number(rest),
        "each": number(1.0 / twilight.DEPTH),
    }


def _around(table: Table, number: Number) -> dict[str, list[str]] | None:
    """Return the constants of the surroundings, row after row."""
    found = table.surroundings
    if not found:
        return None
    return {name: [number(v) for v in getattr(found, name).ravel().tolist()] for name in PARTS}


def _below(table: Table) -> str:
    """Return in words what is below the horizon."""
    lit = f"an even ground of {table.ground}, lit by the sky{' and the sun' if table.sun_disc else ''}"
    if table.surroundings and table.surroundings.below.size:
        lit = lit.replace("the sky", "what of the sky is seen")
    return {"black": "black", "mirror": "the sky's mirror image"}.get(table.ground, lit)


def _lower(table: Table) -> list[str]:
    """Return the zonal weights of an even ground, where one can be added to the table's weights at run time."""
    around = table.surroundings
    if table.bands < 2 or table.ground != "black" or table.windowed or table.quantity != "radiance" or around:
        return []
    return [_single(value) for value in lower_hemisphere(table.bands).tolist()]


def template(name: str) -> Template:
    """Return a template of C text."""
    return _TEMPLATES.get_template(name)


def _about(table: Table) -> tuple[str, str, list[str]]:
    """Return what the weights are, their unit, and what else a reader must know."""
    notes = []
    if table.quantity == "irradiance":
        quantity, unit = "diffuse irradiance E(n) = sum of w * y(n), luminance-scaled lux", "lx"
        notes.append("E is not divided by pi: a white diffuse surface reflects E / pi. Bands l = 3, 5, .. carry none of it.")
    else:
        quantity, unit = "linear radiance, luminance-scaled cd/m2", "cd/m2"
    if table.windowed:
        notes.append("The zonal window sinc(pi l / bands) (Habel et al. 2008, eq. 5) is in the weights.")
    if table.sun_disc:
        notes.append("The sun's disc, 0.2665 degrees in radius and dimmed by the air, is in the weights.")
        if table.quantity == "irradiance":
            lost = 100 * _lobe_error(table.bands)
            notes.append(
                f"{table.bands} bands of a surface's cosine give its light to {lost:.2g} % of that of a facing one."
            )
    elif "sun_zenith" in [axis.name for axis in table.axes]:
        notes.append("The glow about the sun is in the weights, its disc is not: with a disc of your own, add no halo.")
    if table.surroundings:
        notes.append("The scene's surroundings are in the weights: what hides part of the sky, and what shines beside it.")
        notes.append(
            f"The accuracy below is the sky's alone; E_mean grows by no more than {table.surroundings.gain:.3g} times."
        )
    if table.twilight:
        notes.append("Below the horizon the light of a sun on it fades: (1 - x)^10 (1 + 10 x), x = depth / 12 degrees.")
    if table.azimuth is not None:
        notes.append(f"The sun's azimuth is {table.azimuth:.9g} rad for good.")
    if isinstance(table.factor, ClosedForm):
        notes += [f"{name} is {value:.9g} for good." for name, value in table.factor.fixed]
    return quantity, unit, notes


def _lobe_error(bands: int) -> float:
    """Return how far a clamped cosine of so many bands is from its own, at most, as a share of 1."""
    cosine = np.linspace(-1.0, 1.0, 401)
    degrees = np.arange(bands)
    factors = clamped_cosine(bands) * (2 * degrees + 1) / (4 * np.pi)
    cut = np.polynomial.legendre.legval(cosine, factors)
    return float(np.abs(cut - np.maximum(cosine, 0.0)).max())


def _axes(table: Table, prefix: str, suffix: str, number: Number) -> list[dict[str, object]]:
    found: list[dict[str, object]] = []
    limits = zip(table.ranges, table.float32_limits(), strict=True)
    for axis, degree, ((least, most), (first, last)) in zip(table.axes, table.degrees, limits, strict=True):
        expression = MAPS[axis.map].c_expression
        found.append(
            {
                "name": axis.name,
                "map": axis.map,
                "powers": degree + 1,
                "terms": degree + 1,
                # Loops over terms run in fours.
                "room": -(-(degree + 1) // 4) * 4,
                "constants": [number(c) for c in axis.constants],
                "wide_constants": [_double(c) for c in axis.constants],
                "expression": expression.replace("LOG", f"log{suffix}").replace("CBRT", f"cbrt{suffix}"),
                "wide_expression": expression.replace("LOG", "log").replace("CBRT", "cbrt"),
                "fill": _fill(table.basis, prefix, suffix),
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


def _factor(table: Table, number: Number) -> dict[str, object]:
    """Return what the template needs of the table's factor; the fit divided by the same."""
    if isinstance(table.factor, ClosedForm):
        body = PREFACTORS[table.factor.name].c_body
        wide = re.sub(r"\bfloat\b", "double", re.sub(r"(\d\.\d+)f\b", r"\1", body))
        wide = re.sub(r"\b(tan|cos|sin|exp|log)f\b", r"\1", wide)
        return {
            "kind": "closed",
            "about": f"the closed form {table.factor.name}",
            "constants": [number(c) for c in table.factor.constants],
            "wide_constants": [_double(c) for c in table.factor.constants],
            "fixed": [(name, _double(value)) for name, value in table.factor.fixed],
            "body": wide if table.dtype == np.float64 else body,
            "wide_body": wide,
        }
    if isinstance(table.factor, Reciprocal):
        found = table.factor.coefficients
        return {
            "kind": "reciprocal",
            "about": "1 over a polynomial in the same variables",
            "constants": [number(float(c)) for c in found.ravel()],
            "wide_constants": [_double(float(c)) for c in found.ravel()],
            "sizes": found.shape,
        }
    return {"kind": "none", "about": "nothing"}


def _fill(basis: str, prefix: str, suffix: str) -> str:
    """Return the basis's C statements in the table's number type."""
    text = re.sub(r"\breal\b", f"{prefix}_real", BASES[basis].c_fill)
    return text.replace("COS(", f"cos{suffix}(").replace("SIN(", f"sin{suffix}(")


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
