"""The JavaScript module's types, a TypeScript declaration file: what a compiler or an editor knows of its exports."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Iterator

from skylight_sh import __version__
from skylight_sh.export import c_comment
from skylight_sh.export.c_data import features
from skylight_sh.export.javascript import plain
from skylight_sh.export.statements import inputs_of
from skylight_sh.runtime import Packed, Table

_SHARED = """
/** Weights, channel by channel: CHANNELS.length * WEIGHTS numbers a sun, index l * (l + 1) + m in a channel. */
export type Weights = Float32Array | Float64Array;
/** An input; angles are radians. */
export interface Axis {
  readonly name: string;
  readonly unit: string;
  readonly min: number;
  readonly max: number;
}
/** The inputs but the azimuth. */
export declare const AXES: readonly Axis[];
/** All inputs inside their ranges. */
export declare const OK: 0;
/** An input outside its range: evaluated at the range's end. */
export declare const CLAMPED: 1;
/** An input that is no number, or an infinite azimuth: all weights are 0. */
export declare const INVALID: 2;
export type Status = typeof OK | typeof CLAMPED | typeof INVALID;
"""


def write(table: Table, title: str) -> str:
    """Return the text of ``skylight_sh.d.mts``, which stands beside the module of ``table``."""
    unit, _ = c_comment.about(table)
    lines = [
        f"// Types of {plain(title)}. Written by skylight-sh {__version__} (CC0-1.0).",
        "",
        "/** SH bands. */",
        f"export declare const BANDS: {table.bands};",
        "/** Weights a channel. */",
        f"export declare const WEIGHTS: {table.bands**2};",
        f"export declare const CHANNELS: readonly {json.dumps(list(table.channels))};",
        "/** Of what the weights expand. */",
        f"export declare const UNIT: {json.dumps(unit)};",
        *_SHARED.strip().splitlines(),
        "",
        *_functions(table),
    ]
    return "\n".join(lines) + "\n"


def _functions(table: Table) -> Iterator[str]:
    names = inputs_of(table)
    one, many = (", ".join(f"{name}: {kind}" for name in names) for kind in ("number", "ArrayLike<number>"))
    yield "/** Evaluates all bands; fills `weightsOut` where it is given. */"
    yield from _filling("weights", one)
    yield "/** Evaluates the first `bandCount` bands, 1 to BANDS; the others are 0. */"
    yield from _filling("weightsBands", f"{one}, bandCount: number")
    yield "/** Evaluates many suns: an array an input, all of one length; one sun's weights after another. */"
    yield from _filling("weightsBatch", many)
    yield "/** What an evaluation of these inputs meets. */"
    yield f"export declare function status({one}): Status;"
    yield "/** Multiplies weights by an exposure, in place. */"
    yield "export declare function applyExposure<Out extends Weights>(weights: Out, exposure: number): Out;"
    if "TAKES_GROUND" in features(table):
        yield "/** Adds an even ground of this albedo, one a channel, below the horizon, in place, before any window. */"
        yield "export declare function applyGround<Out extends Weights>(weights: Out, albedo: ArrayLike<number>): Out;"
    if not table.spec.windowed:
        yield "/** Tames the ringing of the horizon by the zonal window of the first `bands` bands, in place. */"
        yield "export declare function applyWindow<Out extends Weights>(weights: Out, bands?: number): Out;"
    if isinstance(table.body, Packed):
        yield "/** Unpacks the table; without it the first evaluation does. */"
        yield "export declare function unpack(): void;"


def _filling(name: str, parameters: str) -> Iterator[str]:
    """Yield a function that makes its result, and one that fills the caller's."""
    listed = [f"  {line}" for line in textwrap.wrap(f"{parameters},", 94)]
    yield from (f"export declare function {name}(", *listed, "): Float32Array;")
    yield from (f"export declare function {name}<Out extends Weights>(", *listed, "  weightsOut: Out,", "): Out;")
