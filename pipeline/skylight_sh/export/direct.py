"""The Preetham sky summed over its own directions, as C: one header, C99 and C++11, without a table.

The sun-centred rule with few nodes (``direct_nodes``). The evaluator stands in ``evaluators/c/direct.h`` and is copied
beside its constants: nodes, factors of the basis, and the model's numbers.
"""

from __future__ import annotations

import hashlib
import re
import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh import __version__, sphere
from skylight_sh.export import c_comment, direct_nodes, evaluators, prefixes
from skylight_sh.export.evaluators import part, renamed, wrapped
from skylight_sh.fit.axis import Axis
from skylight_sh.fit.errors import published
from skylight_sh.formula import harmonics, printers
from skylight_sh.formula.azimuth import waves_of_angle
from skylight_sh.formula.printers import C_SINGLE
from skylight_sh.light import colour, preetham
from skylight_sh.light.preetham import Preetham
from skylight_sh.light.protocol import Light
from skylight_sh.quadrature import sun_centred
from skylight_sh.quadrature.sun_centred import Nodes
from skylight_sh.reproducible import to_grid
from skylight_sh.runtime import Table
from skylight_sh.table.table import float32_limits

_P, _p = "SKYLIGHT_SH", "skylight_sh"
# The recurrence of waves loses digits with the square of the bands.
_MOST_BANDS = 16
# Numbers that a processor's library decides are rounded to so many bits before they are printed.
_BITS = 40
# What a scene does to weights, by its keys, and the values of a sky alone.
_ALONE: Mapping[str, object] = {
    "channels": "all",
    "quantity": "radiance",
    "ground": "black",
    "sun_disc": False,
    "twilight": False,
    "horizon": None,
    "clouds": None,
    "occluders": None,
    "lights": None,
    "window": False,
    "azimuth": None,
}

Array = NDArray[np.float64]


def misfit(light: Light, scene: Mapping[str, Any]) -> str | None:
    """Say why the sky of a config's ``light`` and ``scene`` (its section as plain values) has no sum here, or nothing."""
    if not isinstance(light, Preetham):
        return f'the target sums the Preetham sky, not the {light.title}. Use model = "preetham"'
    for key, alone in _ALONE.items():
        if (scene[key] or None) != (alone or None):
            return f"the target sums the sky alone, without what scene.{key} does to it. Leave scene.{key} out"
    return None


def obstacle(table: Table) -> str | None:
    """Say why ``table`` has no sum of the sky beside it, or nothing where it has."""
    config: Any = table.provenance.get("config")
    if config is None:
        return "it does not say its light"
    if config["light"]["model"] != "preetham":
        return f"the target sums the Preetham sky, not {config['light']['model']}"
    if why := misfit(_light(table), config["scene"]):
        return why
    if table.bands > _MOST_BANDS:
        return f"it has {table.bands} bands; the target sums up to {_MOST_BANDS}"
    try:
        _chosen(table)
    except ValueError as error:
        return str(error)
    return None


def write(table: Table, provenance: Sequence[str] = (), prefix: str = evaluators.PREFIX) -> str:
    """Return the text of the header that does without ``table``: of its light and bands, within its budget.

    Every symbol starts with ``prefix`` and ``_direct``; ``provenance`` are lines of its comment. The error stays within the
    budget over the table's ranges; the header takes the model's, and says its error there. Raises ValueError for a table
    with an ``obstacle``, or a prefix that is no C identifier.
    """
    why = obstacle(table)
    if why:
        raise ValueError(f"This table has no sum of its sky beside it: {why}.")
    prefixes.check(prefix)
    own = prefixes.by_table(["direct"], "", prefix)["direct"]
    light, (nodes, e_mean) = _light(table), _chosen(table)
    wide = _widened(table, light)
    anywhere = direct_nodes.e_mean(light, _ranges(wide), table.bands, nodes)
    declared = [*_facts(wide, e_mean, anywhere), "", *_declaration()]
    body = [*constants(light, table.bands, nodes), "", *_limits(wide), "", *_formulas(table.bands)]
    body += [part("c/inputs.h", ()), part("c/direct.h", ())]
    # Tells sums under one prefix apart.
    sign = hashlib.sha256("\n".join([*declared, *body]).encode()).hexdigest()[:8]
    lines = [
        part("c/requirements.h", ()),
        f"#ifndef {_P}_H",
        f"#define {_P}_H 0x{sign}",
        "",
        part("c/linkage.h", ()),
        *declared,
        "",
        f"#elif {_P}_H != 0x{sign}",
        f'#error "Another sky has the prefix {own}_ already: export one of them under a prefix of its own."',
        f"#endif /* {_P}_H */",
        "",
        f"#if (!defined({_P}_EXTERN) || defined({_P}_IMPLEMENTATION)) && !defined({_P}_DEFINED)",
        f"#define {_P}_DEFINED",
        "",
        *body,
        f"#endif /* {_P}_DEFINED */",
    ]
    text = re.sub(r"\n{3,}", "\n\n", "\n".join(lines))
    comment = _comment(table, wide, (nodes, e_mean, anywhere), provenance, own)
    return wrapped("\n".join(comment) + "\n" + renamed(text, own))


def example() -> str:
    """Return ``evaluators/c/direct_example.h``: what ``direct.h`` reads beside ``example.h``, for three bands."""
    lines = [
        "/* What an export writes of one sum over the sky, for direct.h as it stands. Written by direct.example. */",
        "#pragma once",
        '#include "linkage.h"',
        "",
        *constants(Preetham(), 3, direct_nodes.nodes_of(16, 6)),
        "",
        *_formulas(3),
    ]
    return wrapped("\n".join(lines).rstrip())


def constants(light: Preetham, bands: int, nodes: Nodes) -> Iterator[str]:
    """Yield the evaluator's macros and constants for ``bands`` bands and so many ``nodes``."""
    rings, shares, weights = _rings(nodes)
    turns, turn_weights = sun_centred.graded(nodes.waves, sun_centred.WAVE_POWER)
    perez, zenith = preetham.constants_of(light.constants)
    yield from evaluators.commented(
        "Rings: circles about the sun, then arcs that end on the horizon; turns about it of each."
    )
    yield f"#define {_P}_CIRCLES {nodes.circles}"
    yield f"#define {_P}_RINGS {nodes.circles + nodes.arcs}"
    yield f"#define {_P}_SIDE {direct_nodes.SIDE}"
    yield f"#define {_P}_TURNS {nodes.waves}"
    yield f"#define {_P}_ORDERS(ORDER) {' '.join(f'ORDER({m})' for m in range(bands))}"
    yield ""
    yield from evaluators.commented(
        "Of each ring: its angle to the sun as a share of the circles' largest, or the arcs' h over the sun's zenith angle; "
        "that from 1; its weight."
    )
    yield from _floats("ring", rings)
    yield from _floats("ring_rest", shares)
    yield from _floats("ring_weight", weights)
    yield from evaluators.commented("Turns as shares of the ring's, and their weights.")
    yield from _floats("turn_at", turns)
    yield from _floats("turn_weight", turn_weights)
    yield from evaluators.commented(
        "Factors of the basis, order by order: of the diagonal (half a turn about the sun in its sign), then for each "
        "degree those of the next one's recurrence (Holmes and Featherstone 2002)."
    )
    yield from _floats("legendre", list(_legendre(bands)))
    yield from evaluators.commented(
        "Of degrees 1, 2, ..: eigenvectors of the turn about y, frequencies l, l - 2, .. (Feng, Wang, Yang and Jin 2015)."
    )
    yield from _floats("vectors", list(_vectors(bands)) or [0.0])
    yield from evaluators.commented("The channels by X, Y and S = X + Y + Z.")
    to_rgb = colour.matrix(light.colour_space)
    yield from _doubles("mix", np.stack([to_rgb[:, 0] - to_rgb[:, 2], to_rgb[:, 1] - to_rgb[:, 2], to_rgb[:, 2]], axis=-1))
    yield from evaluators.commented(
        f"The model's constants ({light.constants}): A..E for Y, x and y, by slope and offset; zenith chromaticity x and y, "
        "by turbidity and zenith angle."
    )
    yield from _doubles("perez", perez)
    yield from _doubles("zenith", zenith)


def _rings(nodes: Nodes) -> tuple[Array, Array, Array]:
    """Return of circles and arcs their places, an arc's distance from 1, and weights, both sides of the sky together."""
    circles, circle_weights = sun_centred.graded(nodes.circles, nodes.power)
    x, v = sphere.gauss(nodes.arcs)
    u = np.pi / 2 * x
    places = np.concatenate([circles, np.sin(u)])
    rest = np.concatenate([np.zeros(nodes.circles), 2 * np.sin((np.pi / 2 - np.abs(u)) / 2) ** 2])
    return places, rest, 2 * np.concatenate([circle_weights, np.pi / 2 * v * np.cos(u)])


def _legendre(bands: int) -> Iterator[float]:
    for m in range(bands):
        yield -harmonics.diagonal(m) if m else harmonics.CONSTANT
        for l in range(m, bands):
            yield float(harmonics.ahead(l + 1, m))
            yield float(harmonics.behind(l + 1, m)) if l > m else 0.0


def _vectors(bands: int) -> Iterator[float]:
    """Yield s_m U_mk of each degree: of V with V exp(-i k theta) V^T, +k and -k together, i^m by its sign alone.

    An eigenvector's own sign is free: here its first component that is not 0 is positive.
    """
    for l in range(1, bands):
        vectors, signs = sphere.generator_vectors(l, 0), np.where(np.arange(l + 1) % 4 < 2, 1.0, -1.0)
        for frequency in range(l, -1, -2):
            column = to_grid(vectors[:, (frequency + l) // 2], _BITS)
            column = column * np.sign(column[np.flatnonzero(column)[0]]) * (np.sqrt(2.0) if frequency else 1.0)
            # No -0.
            yield from (column * signs + 0.0).tolist()


def _light(table: Table) -> Preetham:
    config: Any = table.provenance["config"]
    return Preetham(**config["light"])


def _ranges(table: Table) -> direct_nodes.Ranges:
    """Return the ranges of the light's parameters: the table's, or the model's where the table has none."""
    found = {axis.name: (axis.low, axis.high) for axis in table.axes}
    return tuple(found.get(name, (domain.low, domain.high)) for name, domain in preetham.DOMAINS.items())


def _chosen(table: Table) -> tuple[Nodes, float]:
    """Return the nodes for the table's budget, or its error where it was not chosen by one, and their E_mean."""
    budget: Any = table.provenance.get("budget") or table.provenance["e_mean"]
    return direct_nodes.choose(_light(table), _ranges(table), table.bands, float(budget))


def _widened(table: Table, light: Light) -> Table:
    """Return what is said of ``table`` with axes over the model's whole domain."""
    axes = [Axis(name, domain.low, domain.high, domain.unit).specified for name, domain in light.domains.items()]
    return replace(table, spec=replace(table.spec, axes=tuple(axes), scale=None))


def _facts(wide: Table, e_mean: float, anywhere: float) -> Iterator[str]:
    yield f'#define {_P}_VERSION "{__version__}"'
    yield f"#define {_P}_BANDS {wide.bands}"
    yield f"#define {_P}_WEIGHTS {wide.bands**2}"
    yield f"#define {_P}_CHANNELS {len(wide.channels)}"
    yield f"#define {_P}_AXES {len(wide.axes)}"
    yield f'#define {_P}_UNIT "cd/m2"'
    yield f"#define {_P}_E_MEAN {published(e_mean):.6e}"
    yield f"#define {_P}_E_MEAN_ANYWHERE {published(anywhere):.6e}"
    for axis in wide.axes:
        yield f"#define {_P}_{axis.name.upper()}_MIN {C_SINGLE.number(axis.low)}"
        yield f"#define {_P}_{axis.name.upper()}_MAX {C_SINGLE.number(axis.high)}"


def _declaration() -> Iterator[str]:
    yield from evaluators.commented("Evaluates all bands.")
    yield (
        f"{_P}_API int {_p}_weights(float sun_zenith, float sun_azimuth, float turbidity, "
        f"float weights[{_P}_CHANNELS][{_P}_WEIGHTS]);"
    )


def _limits(wide: Table) -> Iterator[str]:
    number = C_SINGLE.number
    inside, ends = float32_limits(wide), [(axis.low, axis.high) for axis in wide.axes]
    yield f"typedef float {_p}_real;"
    yield from evaluators.commented("Of each axis: the first and last float that counts as inside, and its range.")
    for name, pairs in (("inside", inside), ("range", ends)):
        text = ", ".join(f"{{ {number(low)}, {number(high)} }}" for low, high in pairs)
        yield f"static const float {_p}_{name}[{_P}_AXES][2] = {{ {text} }};"


def _formulas(bands: int) -> Iterator[str]:
    yield from evaluators.commented("cos(m angle) and sin(m angle) for m < bands, by doubling.")
    targets = [f"{name}[{m}]" for name in ("cosines", "sines") for m in range(bands)]
    yield f"static inline void {_p}_circle(float angle, float *cosines, float *sines)"
    yield "{"
    yield from (f"    {line}" for line in printers.assignments(waves_of_angle(bands), C_SINGLE, ["angle"], targets))
    yield "    (void)angle;"
    yield "}"


def _floats(name: str, values: ArrayLike) -> Iterator[str]:
    numbers = np.asarray(values, dtype=np.float64)
    yield from _array(f"static const float {_p}_{name}[{numbers.size}]", map(C_SINGLE.number, numbers.tolist()))


def _doubles(name: str, values: Array) -> Iterator[str]:
    sizes = "".join(f"[{size}]" for size in values.shape)
    yield f"static const double {_p}_{name}{sizes} = {_braced(values.tolist())};"


def _braced(values: list[Any]) -> str:
    return f"{{ {', '.join(_braced(v) if isinstance(v, list) else printers.pointed(repr(v)) for v in values)} }}"


def _array(head: str, items: Iterable[str]) -> Iterator[str]:
    yield f"{head} = {{"
    yield from evaluators.filled(items)
    yield "};"


def _comment(
    table: Table, wide: Table, chosen: tuple[Nodes, float, float], provenance: Sequence[str], prefix: str
) -> Iterator[str]:
    upper, (nodes, e_mean, anywhere) = prefix.upper(), chosen
    _, notes = c_comment.about(wide)
    ends = [f"{axis.name} {low:.9g} to {high:.9g}" for axis, (low, high) in zip(wide.axes, _ranges(table), strict=True)]
    told = [
        "",
        f"Written by skylight-sh {__version__}; this code may be used by anyone for anything (CC0-1.0).",
        "C99 and C++11, no allocation, no global written, nothing static but constants: any thread may call it. No table: "
        f"{nodes.waves * (nodes.circles + nodes.arcs)} samples of half the sky a call. A table of the same sky is many "
        "times faster: this is for tools, and for inputs beyond its ranges.",
        "",
        "Usage",
        f"  float w[{upper}_CHANNELS][{upper}_WEIGHTS];",
        f"  int status = {prefix}_weights(0.785f, 0.0f, 4.0f, w);",
        "Compile with, for instance",
        "  cc -std=c99 -O3 program.c -o program -lm",
        f"Included plainly, the file is all there is. With {upper}_EXTERN defined before it, it declares only; the one unit "
        f"that also defines {upper}_IMPLEMENTATION holds the function, for C and C++.",
        "",
        "Inputs",
        *(f"  {line}" for line in c_comment.input_lines(wide)),
        "  sun_azimuth: any finite angle, rad",
        "Output",
        *(f"  {line}" for line in notes),
        f"  Define {upper}_EXPOSURE before this file (where it holds the function) to multiply all weights (1 by default).",
        "",
        f"Accuracy: E_mean {100 * published(e_mean):.3g} % of the least luminance of the same sky for {' and '.join(ends)}, "
        f"{100 * published(anywhere):.3g} % anywhere in the inputs' ranges.",
        "",
        "Provenance",
        *(f"  {c_comment.safe(line)}" for line in provenance),
    ]
    yield f"/* {c_comment.safe(_light(table).title)}: spherical-harmonics weights, summed over the sky."
    for line in told:
        indent = " " * (len(line) - len(line.lstrip()))
        found = textwrap.wrap(line, evaluators.COLUMNS - 3, subsequent_indent=indent, break_on_hyphens=False)
        yield from (f" * {one}" for one in found or [""])
    yield " */"
