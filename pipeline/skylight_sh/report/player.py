"""What the player at the top of the report's page gets: the run's tables as ES modules, its sky's formula, the courtyard.

All of it is text inside the page. A table is the module that ``export/javascript.py`` writes, to the letter: the page
imports it, so that what it shows is what a renderer gets.
"""

from __future__ import annotations

import base64
import json
import math
import re
import zlib
from collections.abc import Sequence
from dataclasses import replace
from importlib.resources import files
from typing import Any

import numpy as np

from skylight_sh import sphere
from skylight_sh.export import javascript, prefixes, statements
from skylight_sh.export.c_header import Facts
from skylight_sh.formula import harmonics
from skylight_sh.light import colour, preetham, sun_disc
from skylight_sh.light.preetham import Preetham
from skylight_sh.light.wrappers import Fixed
from skylight_sh.quadrature import sun_centred
from skylight_sh.quadrature.sun_centred import Nodes
from skylight_sh.report import courtyard
from skylight_sh.report.amounts import percent
from skylight_sh.report.report_data import Entry, ReportData
from skylight_sh.runtime import Axis, Packed, Table, flat_places
from skylight_sh.table.size import bytes_of
from skylight_sh.transfer.random_suns import CLEAR

# The paper's own fit, as runs name it; the first one that a run has.
PAPER = ("paper-literal", "paper-svd")
SHADERS = ("scene.vert", "scene.frag", "sky.vert", "sky.frag", "shadow.vert", "shadow.frag", "tone.frag")
# Gauss nodes of the page's own truth, which errs by 1e-8 of a sky's largest weight.
_NODES = Nodes.usual(40)
# What the sources of a picture's error are called, where their own names are short.
_SOURCES = {
    "table": "the recommended table",
    "smallest table": "the smallest table",
    "sampling": "rays that sample transfer",
    "vertices": "transfer at vertices alone",
    "all": "all together, 5 bands",
    "no bounces": "all, and no bounces",
    "no shadows": "all, and no shadows",
}
# A line of a table's numbers, and what stands in its place in a module without them.
_NUMBERS = re.compile(r"^[-\d.eE, ]+$", re.M)
_GAP, _END = "\x01", "\x02"
_LETTERS = "".join(chr(code) for code in range(32, 127) if chr(code) not in '"/<\\')


def of(data: ReportData) -> dict[str, Any]:
    """Return what ``player.html.j2`` shows; ``json`` is what its script reads."""
    entries = [*data.winners, *_papers(data)]
    best = data.best.table
    height = _height(best)
    moves = height is not None and best.spec.azimuth is None
    grounds = best.spec.ground == "black" and best.spec.quantity == "radiance" and not best.surroundings
    scene = _lights_courtyard(data, best)
    shipped: dict[str, Any] = {}
    if scene:
        shipped = {"courtyard": written(courtyard.shipped()), "shaders": _shaders()}
    return {
        "axes": [_control(axis) for axis in best.spec.axes if axis.name != best.spec.peak_axis],
        "best": data.recommended,
        "entries": [_about(data, entry) for entry in entries],
        "bands": max(entry.table.bands for entry in entries),
        "sun": height,
        "moves": moves,
        "exact": _formula(data, best) is not None,
        "scene": scene,
        "disc": scene and _preetham(data) is not None,
        "poster": base64.b64encode(courtyard.shipped(courtyard.POSTER)).decode() if scene else None,
        "grounds": grounds,
        "windowed": best.spec.windowed,
        "irradiance": best.spec.quantity == "irradiance",
        "sources": _sources(data) if scene else None,
        "json": _json(
            {
                "name": data.name,
                "title": data.light.title,
                "best": data.recommended,
                "tables": [_about(data, entry) for entry in entries],
                "modules": written(modules([_module(data, entry) for entry in entries])),
                "channels": len(best.channels),
                "luminance": data.light.luminance_row.tolist(),
                "sun": best.spec.peak_axis if height else None,
                "zeniths": [math.radians(90.0 - height[end]) for end in ("high", "low")] if height else None,
                "moves": moves,
                "azimuth": best.spec.azimuth,
                "grounds": ["mirror", "black", "albedo"] if grounds else ["the table's"],
                "formula": _formula(data, best),
                "legendre": _legendre(max(courtyard.BANDS, *(entry.table.bands for entry in entries))),
                "disc": _disc(sky.colour_space) if scene and (sky := _preetham(data)) else None,
                "tau": data.settings["scene"]["fixed"].get("turbidity", CLEAR),
                **shipped,
            }
        ),
    }


def modules(sources: Sequence[str]) -> bytes:
    r"""Return ES modules as one compressed text: the code, in which a compressor finds its like, then all lines of numbers.

    The page puts the lines back where a byte 1 stands, so that each module is what it was, to the letter.

    >>> zlib.decompress(modules(["a = [\n  1, 2\n];", "b"])).decode().split("\x02")
    ['a = [\n\x01\n];', 'b', '  1, 2']
    """
    code = [_NUMBERS.sub(_GAP, source) for source in sources]
    numbers = (match[0] for source in sources for match in _NUMBERS.finditer(source))
    return zlib.compress(_END.join([*code, "\n".join(numbers)]).encode(), 9)


def _papers(data: ReportData) -> list[Entry]:
    """Return the paper's own fit, of no more bands than the largest table has, or none."""
    known = {entry.name: entry for entry in data.references}
    bands = max(entry.table.bands for entry in data.winners)
    return [_first(known[name], bands) for name in PAPER if name in known][:1]


def _first(entry: Entry, bands: int) -> Entry:
    """Return an entry's first bands, where its rows have a column for every weight."""
    table, body = entry.table, entry.table.body
    if bands >= table.bands or table.surroundings or isinstance(body, Packed):
        return entry
    count = len(flat_places(bands, mirrored=table.spec.mirrored))
    columns = body.columns[..., :count]
    cut = replace(body, rows=np.ascontiguousarray(body.rows[:, : int(columns.max()) + 1]), columns=columns)
    errors = {name: getattr(entry, name)[..., :bands] for name in ("e_max", "e_mean", "rel_l2")}
    return replace(entry, table=replace(table, bands=bands, body=cut), at=entry.at[..., :bands, :], **errors)


def _module(data: ReportData, entry: Entry) -> str:
    e_mean, e_max = entry.headline
    facts = Facts(data.light.title, e_mean, e_max, data.conventions[0], [f"config {data.name}, table {entry.name}"])
    return javascript.write(entry.table, facts)


def _about(data: ReportData, entry: Entry) -> dict[str, Any]:
    table, (e_mean, _) = entry.table, entry.headline
    return {
        "name": entry.name,
        "bands": table.bands,
        "bytes": bytes_of(table),
        "e_mean": e_mean,
        "inputs": statements.inputs_of(table),
        "prefix": _prefixes(data).get(entry.name, data.settings["export"]["prefix"]),
        "paper": entry not in data.winners,
        "irradiance": table.spec.quantity == "irradiance",
        "ground": table.spec.ground if isinstance(table.spec.ground, str) else "folded",
    }


def _prefixes(data: ReportData) -> dict[str, str]:
    names = [entry.name for entry in data.winners]
    return prefixes.by_table(names, data.recommended, data.settings["export"]["prefix"])


def _lights_courtyard(data: ReportData, table: Table) -> bool:
    """Say whether a table's light falls on the courtyard: radiance of a sun that moves, and nothing folded in."""
    spec = table.spec
    moves = spec.peak_axis is not None and spec.peak_axis in [axis.name for axis in spec.axes] and spec.azimuth is None
    plain = spec.quantity == "radiance" and not (spec.sun_disc or spec.windowed or table.surroundings or spec.twilight)
    return bool(moves and plain and len(table.channels) in (1, 3) and not data.settings["scene"]["lights"])


def _formula(data: ReportData, table: Table) -> dict[str, Any] | None:
    """Return the numbers of the Preetham sky, where the page can hold the table against it; else None."""
    light, spec = _preetham(data), table.spec
    if light is None or not _lights_courtyard(data, table) or spec.ground not in ("black", "mirror"):
        return None
    perez, zenith = preetham.constants_of(light.constants)
    to_rgb = colour.matrix(light.colour_space)
    model = {"perez": perez.tolist(), "zenith": zenith.tolist(), "rgb": to_rgb.tolist()}
    return model | {"columns": to_rgb.T.ravel().tolist(), "rule": _rule()}


def _preetham(data: ReportData) -> Preetham | None:
    """Return the run's light where it is a Preetham sky, some of whose parameters may be fixed."""
    light = data.light.light if isinstance(data.light, Fixed) else data.light
    return light if isinstance(light, Preetham) else None


def _rule() -> dict[str, list[list[float]]]:
    """Return nodes and weights on [0, 1] of the rule that sums the sky: circles' angles, arcs, and turns about the sun."""
    arcs = sphere.gauss(_NODES.arcs)
    rule = {
        "circles": sun_centred.graded(_NODES.circles, _NODES.power),
        "turns": sun_centred.graded(_NODES.waves, sun_centred.WAVE_POWER),
        "arcs": (np.pi / 2 * arcs[0], np.pi / 2 * arcs[1]),
    }
    return {name: np.column_stack(pair).tolist() for name, pair in rule.items()}


def _legendre(bands: int) -> list[dict[str, Any]]:
    """Return what the recurrence of each order m takes: its start, and the factors of the degrees l > m."""
    rows = []
    for m in range(bands):
        steps = [
            [float(harmonics.ahead(l, m)), float(harmonics.behind(l, m)) if l > m + 1 else 0.0] for l in range(m + 1, bands)
        ]
        rows.append({"start": harmonics.sectoral(m), "steps": steps})
    return rows


def _disc(colour_space: str) -> dict[str, Any]:
    """Return what the sun's disc is summed from, wavelength by wavelength: see ``light/sun_disc.py``."""
    still, gases, vapour = sun_disc.absorption()
    columns = [sun_disc.spectrum_rgb(colour_space), still, (sun_disc.WAVELENGTHS / 1000.0) ** -1.3, gases, vapour]
    rows = np.column_stack(columns)
    return {"half_angle": sun_disc.HALF_ANGLE, "rows": [[float(f"{v:.8g}") for v in row] for row in rows.tolist()]}


def _control(axis: Axis) -> dict[str, Any]:
    angle = axis.unit == "rad"
    low, high = (float(np.degrees(value)) if angle else value for value in (axis.low, axis.high))
    return {
        "name": axis.name,
        "label": axis.name.replace("_", " ").capitalize(),
        "unit": "°" if angle else "",
        "low": float(f"{low:.6g}"),
        "high": float(f"{high:.6g}"),
        "step": float(f"{(high - low) / 100:.1g}"),
    }


def _height(table: Table) -> dict[str, float] | None:
    """Return the range of the sun's height in degrees, where the table has its zenith angle as an axis."""
    axis = next((axis for axis in table.spec.axes if axis.name == table.spec.peak_axis), None)
    if axis is None:
        return None
    low, high = table.ranges[[one.name for one in table.axes].index(axis.name)]
    return {"low": round(90.0 - float(np.degrees(high)), 3), "high": round(90.0 - float(np.degrees(low)), 3)}


def _sources(data: ReportData) -> dict[str, Any] | None:
    """Return the bars of a picture's error by source and sun: the run's own where it made pictures of the courtyard.

    Otherwise those that ship with the courtyard, where it is shown.
    """
    found = data.pictures.get("courtyard")
    if found is not None:
        names, heights, errors = (found[f"sources/{name}"] for name in ("source", "height", "error"))
    elif told := courtyard.unpack(courtyard.shipped()).facts.get("sources"):
        names, heights, errors = (told[name] for name in ("names", "heights", "errors"))
    else:
        return None
    values = np.asarray(errors, dtype=np.float64)
    low = np.log10(values[values > 0.0].min()) - 0.3
    # Of the row, the rest is for the number.
    shares = np.log10(np.maximum(values, 10.0**low)) - low
    widths = 70.0 * shares / shares.max()
    rows = [
        {
            "name": _SOURCES.get(str(name), str(name)),
            "bars": [{"width": round(w, 1), "text": percent(float(f"{v:.2g}"))} for w, v in zip(*row, strict=True)],
        }
        for name, *row in zip(names, widths.tolist(), values.tolist(), strict=True)
    ]
    by_name = {
        str(name): [percent(float(f"{v:.2g}")) for v in (row.min(), row.max())]
        for name, row in zip(names, values, strict=True)
    }
    told = {"table": by_name["table"][1], "all": " to ".join(by_name["all"])}
    return {"own": found is not None, "suns": [f"{height:g}°" for height in heights], "rows": rows, "told": told}


def _shaders() -> dict[str, str]:
    folder = files(__package__).joinpath("templates")
    return {name: folder.joinpath(f"{name}.glsl").read_text(encoding="utf-8") for name in SHADERS}


def written(data: bytes) -> dict[str, Any]:
    """Return bytes as text that JSON and HTML take as it is, 13 bits in two letters of 91: 8 % less than base64.

    The letters are those of ASCII from the blank on but for four with a meaning of their own.

    >>> written(b"sky")
    {'bytes': 3, 'text': 'C5+a'}
    """
    bits = np.unpackbits(np.frombuffer(data, np.uint8), bitorder="little")
    whole = np.concatenate([bits, np.zeros(-len(bits) % 13, np.uint8)]).reshape(-1, 13)
    pairs = whole @ (1 << np.arange(13))
    letters = np.frombuffer(_LETTERS.encode(), np.uint8)
    return {"bytes": len(data), "text": letters[np.stack([pairs // 91, pairs % 91], axis=-1)].tobytes().decode()}


def _json(value: object) -> str:
    """Return JSON that may stand inside a script element."""
    return json.dumps(value, ensure_ascii=True, separators=(",", ":"), allow_nan=False).replace("</", "<\\/")
