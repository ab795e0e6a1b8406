"""Blocks of the README and docs, ``<!-- name -->`` to ``<!-- /name -->``, written from released files and nothing else."""

from __future__ import annotations

import json
import re
import textwrap
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from skylight_sh import runtime

_WIDTH = 127
# What the README's examples ask for: sun zenith, sun azimuth, turbidity.
_EXAMPLE = (0.8, 0.3, 3.0)
# By how much a total may differ from the published one that the README still trusts.
_TRUSTED = 0.12


@dataclass(frozen=True)
class Released:
    """A released run: its ``folder``, ``summary`` and ``claims``, the ``speed`` of a benchmark, the ``times`` of configs."""

    folder: Path
    summary: Mapping[str, Any]
    claims: Mapping[str, Any]
    speed: Mapping[str, Any]
    times: Mapping[str, Any]


def released(folder: Path) -> Released:
    """Read a released run. Raises OSError where one of its files is missing, and says what makes it."""
    read = {}
    makers = {"summary": "make reference", "claims": "make reference", "speed": "make bench speed", "times": "make times"}
    for name, maker in makers.items():
        path = folder / f"{name}.json"
        if not path.is_file():
            raise OSError(f"{path} is missing. Run `{maker}`, which writes it.")
        read[name] = json.loads(path.read_text(encoding="utf-8"))
    return Released(folder, read["summary"], read["claims"], read["speed"], read["times"])


def rewrite(page: str, text: str, found: Released) -> str:
    """Return the ``text`` of a ``page`` of ``PAGES`` with every block of it as ``found`` has it.

    Raises ValueError where the text lacks a block.
    """
    for name in PAGES[page]:
        if len(re.findall(rf"<!-- {name} -->\n.*?<!-- /{name} -->", text, re.DOTALL)) != 1:
            raise ValueError(f"{page} needs the block {name} once: `<!-- {name} -->` to `<!-- /{name} -->`. Put it back.")
        start, end = (text.index(mark) for mark in (f"<!-- {name} -->\n", f"<!-- /{name} -->"))
        text = f"{text[:start]}<!-- {name} -->\n{BLOCKS[name](found)}\n{text[end:]}"
    return text


def _table(heading: list[str], rows: list[list[str]]) -> str:
    lines = [heading, ["---"] * len(heading), *rows]
    return "\n".join(f"|{'|'.join(cells)}|" if cells[0] == "---" else f"| {' | '.join(cells)} |" for cells in lines)


def _words(text: str) -> str:
    """Wrap a paragraph, whatever its white space; a number and its unit stay together."""
    tied = re.sub(r"(?<=\d) (?=%|ns)", "\0", " ".join(text.split()))
    return textwrap.fill(tied, _WIDTH, break_long_words=False, break_on_hyphens=False).replace("\0", " ")


def _digits(value: float, digits: int) -> str:
    """Return a number to so many digits, without an exponent."""
    return np.format_float_positional(float(f"{value:.{digits}g}"), trim="-")


def _share(value: float, digits: int = 2) -> str:
    """Return a fraction in per cent."""
    return f"{_digits(100 * value, digits)} %"


def _power(value: float, digits: int = 1) -> str:
    """Return a number as one times a power of ten, like 2.1e-4."""
    return re.sub(r"e([+-])0+", r"e\1", f"{value:.{digits}e}")


def _results(found: Released) -> str:
    rows = []
    for row in found.summary["tables"]:
        name = f"**{row['name']}**" if row["name"] == found.summary["recommended"] else row["name"]
        rows.append([name, f"{row['bytes']:,}", f"{100 * row['e_mean']:.4g} %", f"{100 * row['e_max']:.4g} %"])
    return _table(["table", "bytes", "E_mean", "E_max"], rows)


def printed(summary: Mapping[str, Any], folder: str) -> list[str]:
    """Return the lines that a run ends with, as the command line prints them; ``folder`` is its report's."""
    lines = [f"{'table':<24}{'bytes':>8}{'E_mean':>12}{'E_max':>12}"]
    for row in summary["tables"]:
        errors = "".join(f"{100 * row[key]:>10.4g} %" for key in ("e_mean", "e_max"))
        mark = "  recommended" if row["name"] == summary["recommended"] else ""
        lines.append(f"{row['name']:<24}{row['bytes']:>8}{errors}{mark}")
    files = {"report": "index.html", "C": "export/skylight_sh.h", "NPZ": "export/skylight_sh.npz"}
    return [*lines, "", *(f"{what:<8}{folder}/{path}" for what, path in files.items())]


def _fit(found: Released) -> str:
    return "\n".join(["```text", *printed(found.summary, f"reports/{found.summary['config']['name']}"), "```"])


def _speed(found: Released) -> str:
    speed, machine = found.speed, found.speed["machine"]
    bands = next(row["bands"] for row in found.summary["tables"] if row["name"] == found.summary["recommended"])
    names = [row["name"] for row in speed["candidates"] if row["bands"] == bands and row["kind"] == "table"]
    rows = []
    for name in names:
        paper = [_rival(speed, name, speed[key]) for key in ("literal", "well_written")]
        lookups = [row for row in _against(speed, name) if row["rival"].endswith("cubic")]
        warm = [*(_ratios(row, "warm") for row in paper), *([_ratios(row, "warm") for row in lookups] or [""])]
        cold = [_ratios(paper[0], "cold"), *([_ratios(row, "cold") for row in lookups] or [""])]
        rows.append([name, *warm, *([_digits(row["bytes"], 2) for row in lookups] or [""]), *cold])
    base = {row["name"]: row["times"] for row in speed["candidates"]}
    builds = list(base[speed["literal"]])
    told = _words(
        f"""Measured on {machine["processor"]} ({machine["cores"]} shared cores) with {machine["compiler"]}, by the CPU
        clock: medians of {speed["rounds"]} rounds in which all take turns; {speed["dropped"]:,} of {speed["timings"]:,}
        timings, which other work disturbed, are left out. How many times as long a rival takes, for {bands} bands,
        {" / ".join(_BUILDS[build] for build in builds)}, and how many times as many bytes it reads; `~` where the middle
        half of the rounds spreads by 10 % or more. A cubic lookup table is as exact as the table beside it.
        The paper's scheme written literally took {_three(base, speed["literal"], builds[0])} ns a call, its polynomials
        written well {_three(base, speed["well_written"], builds[0])} ns, the recommended table
        {_three(base, found.summary["recommended"], builds[0])} ns (-O3, warm)."""
    )
    heading = [
        "table",
        "paper, literal",
        "paper, well written",
        "cubic lookup",
        "its bytes",
        "cold: literal",
        "cold: lookup",
    ]
    parts = [told, _table(heading, rows), _others(speed, bands), _wins(speed, bands)]
    return "\n\n".join(part for part in parts if part)


# How a build is called.
_BUILDS = {"portable": "-O3", "AVX2": "AVX2", "native": "-march=native"}


def _others(speed: Mapping[str, Any], bands: int) -> str:
    """Say what packed tables cost, decoded at every call or once, and what doing without a table does, at -O3."""
    times: dict[str, list[str]] = {}
    for row in speed["candidates"]:
        if row["bands"] == bands:
            times.setdefault(row["kind"], []).append(f"{row['times']['portable']['ns']['median']:,.0f}")
    listed = {kind: " / ".join(found) for kind, found in times.items()}
    told = []
    if "packed table" in listed:
        told.append(f"Packed tables decode at every call, which takes {listed['packed table']} ns (-O3)")
    if "unpack" in listed:
        told[-1] += f"; decoded once in {listed['unpack']} ns, a call takes {listed['unpacked table']} ns"
    if "direct" in listed:
        told.append(f"Without a table, the sky's quadrature as exact as these takes {listed['direct']} ns")
    if "brute force" in listed:
        told.append(f"Summing 1,024 directions by brute force takes {listed['brute force']} ns")
    return _words(" ".join(f"{sentence}." for sentence in told))


def _against(speed: Mapping[str, Any], name: str) -> list[Mapping[str, Any]]:
    return [row for row in speed["rivals"] if row["table"] == name]


def _rival(speed: Mapping[str, Any], name: str, rival: str) -> Mapping[str, Any]:
    return next(row for row in _against(speed, name) if row["rival"] == rival)


def _ratios(row: Mapping[str, Any], kind: str) -> str:
    """Return the ratios of a pair, a build after another."""
    figures = [times[kind] for times in row["times"].values() if kind in times]
    return " / ".join(f"{'~' if f['noisy'] else ''}{_digits(f['median'], 2)}" for f in figures)


def _three(times: Mapping[str, Any], name: str, build: str) -> str:
    return f"{times[name][build]['ns']['median']:,.0f}"


def _wins(speed: Mapping[str, Any], bands: int) -> str:
    """Say where a rival wins, warm, in builds where it is faster by 5 % or more; of packed tables by how much at most."""
    kinds = {row["name"]: row["kind"] for row in speed["candidates"]}
    rivals = {name: _RIVALS.get(kind, name) for name, kind in kinds.items()}
    lost: dict[str, list[str]] = {}
    packed: dict[str, float] = {}
    for name in (row["name"] for row in speed["candidates"] if row["bands"] == bands):
        for row in _against(speed, name):
            ratios = {build: times["warm"] for build, times in row["times"].items() if times["warm"]["median"] < _EVEN}
            rival, times = rivals[row["rival"]], [1 / ratio["median"] for ratio in ratios.values()]
            if not times or kinds[row["rival"]] == "table":
                continue
            if kinds[name] == "packed table":
                packed[rival] = max(packed.get(rival, 0.0), *times)
            elif kinds[name] == "table":
                where = "" if len(ratios) == len(row["times"]) else f" ({', '.join(_BUILDS[build] for build in ratios)})"
                told = f"{' / '.join(_digits(time, 2) for time in times)} times as fast as {name}{where}"
                lost.setdefault(rival, []).append(f"{told}, {_digits(row['bytes'], 2)} times its bytes")
    lines = [f"- {rival}: {'; '.join(told)}" for rival, told in lost.items()]
    if packed:
        most = ", ".join(f"{rival} by up to {_digits(times, 2)} times" for rival, times in packed.items())
        lines.append(f"- against packed tables that decode at every call: {most}")
    if not lines:
        return "No rival is faster than any of these tables, warm."
    wrapped = (textwrap.fill(line, _WIDTH, subsequent_indent="  ", break_on_hyphens=False) for line in lines)
    return "\n".join(["Where a rival wins, warm:", "", *wrapped])


_EVEN = 0.95
# What rivals that are made for one table are called.
_RIVALS = {
    "lookup, cubic": "a cubic lookup table as exact",
    "lookup, linear": "a linear lookup table as exact",
    "direct": "the sky's own quadrature",
}


def _example(found: Released) -> tuple[int, np.ndarray[Any, Any]]:
    table = runtime.load(found.folder / "export" / "skylight_sh.npz")
    weights, status = table.weights_and_status(*_EXAMPLE)
    return int(status), weights


def _c_output(found: Released) -> str:
    status, weights = _example(found)
    return "\n".join(["```text", " ".join([str(status), *(f"{value:.0f}" for value in weights[:, 0])]), "```"])


def _py_output(found: Released) -> str:
    _, weights = _example(found)
    # Some libraries make NumPy print as it once did.
    with np.printoptions(legacy=False):
        return "\n".join(["```text", f"{weights.shape} {weights[:, 0].round()}", "```"])


def _gradient(found: Released) -> str:
    claim = found.claims["gradient"]
    return _words(
        f"""Derivatives are exact ones, computed in double precision: right to {_power(max(claim.values()), 0)} of the
        largest derivative after the same axis at the same sun, on the edges and in the corners of the ranges too."""
    )


def _pictures(found: Released) -> str:
    claim = found.claims["pictures"]
    exact = " and ".join(f"of {int(width):,} pixels across within {_share(off)}" for width, off in claim["exact"].items())
    channels = ", ".join(f"{name} {_share(value)}" for name, value in claim["hdr_channels"].items())
    return _words(
        f"""A Preetham sky comes back from a panorama of floats {exact} of the largest weight, the worst of
        {claim["skies"]} skies in {claim["bands"]} bands. Radiance HDR (`.hdr`) keeps eight bits of a channel and cuts the
        rest off: such a picture is read too dark, by up to {_share(claim["hdr"])} of the largest weight ({channels} of
        the channel's own largest). Take OpenEXR where that matters."""
    )


def _ringing(found: Released) -> str:
    claim = found.claims["ringing"]
    black, mirrored = claim["undershoot"]["black ground"], claim["undershoot"]["mirrored sky"]
    ground, lit = next(entry for entry in claim["undershoot"].items() if entry[0].startswith("ground of albedo"))
    plain, windowed = black
    told = f"""At {claim["bands"]} bands the Preetham sky undershoots by up to {_share(black[plain])} of the sky's own
        brightest value; by {_share(black[windowed])} behind the zonal window of eq. 5, by {_share(lit[plain])} above a
        {ground}, by {_share(lit[windowed])} with both, and by {_share(mirrored[plain])} above a mirrored sky: each the worst
        of {claim["sets"]} sets. The report's pictures of ringing and `ringing.csv` give this share too, at the sets that
        they name."""
    best = next(row for row in found.summary["tables"] if row["name"] == found.summary["recommended"])
    if "least" in best:
        told += f""" `least` in `summary.json` is another: a share of the expansion's own largest value, at the worst of
        all verification sets, {_share(best["least"], 3)} for the recommended table."""
    return _words(told)


def _limits(found: Released) -> str:
    return _trusted(found)[0]


def _daylight(found: Released) -> str:
    told, rows = _trusted(found)
    told += " In klx on the horizontal, ours / IES RP-21 (1984) for a clear day (`make bench` prints other turbidities):"
    return f"{_words(told)}\n\n{_table(['sun, degrees high', 'sky', 'sun', 'both'], rows)}"


def _trusted(found: Released) -> tuple[str, list[list[str]]]:
    """Return in words which lux to trust, and a row a height of the sun."""
    claim = found.claims["daylight"]
    rows, ratios = [], {}
    for row in claim["heights"]:
        ours, theirs = (row["sky"], row["sun"]), (row["published_sky"], row["published_sun"])
        pairs = [*zip(ours, theirs, strict=True), (sum(ours), sum(theirs))]
        rows.append([str(row["height"]), *(f"{one / 1000:.1f} / {other / 1000:.1f}" for one, other in pairs)])
        ratios[row["height"]] = ours[0] / theirs[0], sum(ours) / sum(theirs)
    trusted = {height: ratio for height, ratio in ratios.items() if abs(ratio[1] - 1) < _TRUSTED}
    skies, totals = zip(*trusted.values(), strict=True)
    off = max(abs(total - 1) for total in totals)
    told = _words(
        f"""With the sun {min(trusted)} degrees high or more and a turbidity of {claim["turbidity"]:g}, sky and sun
        together send down the light of a clear day within {100 * off:.0f} %, but only since two errors cancel: the
        Preetham sky alone is {min(skies):.1f} to {max(skies):.1f} times as bright as was published, its sun dimmer. Trust
        that total. Do not trust the sky's lux alone, nor a low sun: on the horizon the sky is {ratios[0][0]:.0f} times
        too bright."""
    )
    return told, rows


def _valley(found: Released) -> str:
    claim = found.claims["valley"]
    first = claim["first"]
    parts = ", ".join(
        f"the first {n} are within {_share(entry['most'])}" for n, entry in first.items() if int(n) < claim["bands"]
    )
    best = ", ".join(_share(entry["least"]) for entry in first.values())
    return _words(
        f"""Of the valley's {claim["bands"]} bands {parts}, and all {claim["bands"]} within
        {_share(first[str(claim["bands"])]["most"])} of those of the scene itself, sampled direction by direction
        (relative L2; the worst channel and sun of the picture; the best are within {best}). What is lost is what the sky has
        beyond the table's bands. The picture's heading tells another thing, how far the first bands move with a
        sky of more bands, which is cut too."""
    )


def _lighting(found: Released) -> str:
    claim, rows = found.claims["lighting"], []
    lost = claim["tables"]
    for row in found.summary["tables"]:
        cells = [" / ".join(_share(value) for value in lost[row["name"]][key]) for key in ("irradiance", "picture")]
        rows.append([row["name"], f"{100 * row['e_mean']:.4g} %", *cells])
    by_bands = {row["bands"]: lost[row["name"]]["bands"] for row in found.summary["tables"]}
    bands = " and ".join(
        f"by {_share(worst)} / {_share(half)} with {n} bands" for n, (worst, half) in sorted(by_bands.items())
    )
    most = max(lost[row["name"]]["irradiance"][0] / row["e_mean"] for row in found.summary["tables"])
    told = _words(
        f"""By how much the light on a surface is off, and a picture of a scene lit through precomputed transfer: the worst
        of {claim["sets"]} skies that neither fit nor selection saw / half of them. No table loses more of any surface's
        light than {_digits(most, 2)} times its E_mean. What few bands lose of the sky itself no better table mends: the
        light on a surface is off {bands}."""
    )
    return f"{told}\n\n{_table(['table', 'E_mean', 'light on a surface', 'a picture'], rows)}"


def _choice(found: Released) -> str:
    """Say which table to take for which need: the recommended one first, then the extremes."""
    rows = {row["name"]: row for row in found.summary["tables"]}
    times = {row["name"]: row["times"]["portable"]["ns"]["median"] for row in found.speed["candidates"]}
    unpacked = {row["name"].partition(":")[0]: row for row in found.speed["candidates"] if row["kind"] == "unpacked table"}
    best = rows[found.summary["recommended"]]
    alike = [row for row in rows.values() if row["e_mean"] < _ALIKE * best["e_mean"]]
    plain, packed = ([row for row in alike if (row["layout"] == "packed") == wanted] for wanted in (False, True))
    needs = {
        "shadows by precomputed transfer, normal maps: **take this one**": best,
        "the same in less memory; unpack it once": min(
            (row for row in packed if row["bands"] == best["bands"]), key=lambda row: row["bytes"]
        ),
        "diffuse light, soft shadows": min(plain, key=lambda row: row["bytes"]),
        "the fastest call": min(rows.values(), key=lambda row: times[row["name"]]),
        "the fewest bytes: a phone, a web page": min(rows.values(), key=lambda row: row["bytes"]),
        "offline pictures, a reference": min(rows.values(), key=lambda row: row["e_mean"]),
    }
    lines = []
    for need, row in needs.items():
        name = row["name"]
        lost = found.claims["lighting"]["tables"][name]["irradiance"][0]
        once = f"; unpacked {unpacked[name]['times']['portable']['ns']['median']:,.0f}" if name in unpacked else ""
        cells = [f"{row['bytes']:,}", f"{times[name]:,.0f}{once}", f"{100 * row['e_mean']:.2g} %", _share(lost)]
        lines.append([need, f"[{name}][]", *cells])
    processor = found.speed["machine"]["processor"]
    told = _words(
        f"""ns: one call in C, in three colours, at -O3 on {processor}. E_mean: the largest error of all weights together, as
        a share of the darkest part of the same sky. Last column: by how much the light on a surface is off at most. The
        number of bands matters more: {_bands_lose(found)}, whatever the table, since so few bands cannot hold the sky
        itself. All {len(rows)} tables and their rivals: [results](docs/results.md)."""
    )
    heading = ["what for", "table, a C header", "bytes", "ns", "E_mean", "light on a surface"]
    links = (f"[{row['name']}]: reports/reference/{row['path']}/skylight_sh.h" for row in needs.values())
    return "\n\n".join([_table(heading, lines), told, "\n".join(dict.fromkeys(links))])


def _bands_lose(found: Released) -> str:
    tables = found.summary["tables"]
    worst = {row["bands"]: found.claims["lighting"]["tables"][row["name"]]["bands"][0] for row in tables}
    return " and ".join(f"{n} bands lose up to {_share(lost)}" for n, lost in sorted(worst.items()))


def _times(found: Released) -> str:
    machine, seconds = found.times["machine"], found.times["seconds"]
    by_time: dict[int, list[str]] = {}
    for name, time in sorted(seconds.items()):
        by_time.setdefault(next(most for most in _TIMES if time <= most), []).append(name)
    parts = "; ".join(f"up to {most} s: {', '.join(f'`{name}`' for name in by_time[most])}" for most in sorted(by_time))
    return _words(
        f"""Seconds of one processor ({machine["processor"]}), from nothing to the report; several cores take less.
        {parts[0].upper()}{parts[1:]}. A second run takes half a second: every stage is cached in `artifacts/`."""
    )


def _day(found: Released) -> str:
    claim = found.claims["day"]
    parts = int(float(f"{claim['error'] / claim['from_table']:.2g}"))
    return _words(
        f"""A table of {claim["bytes"]:,} bytes ({claim["bands"]} bands) holds the light of this sky for every hour and haze.
        Precomputed transfer makes its shadows and bounces; the sun's own come from shadow rays. Beside path tracing the
        picture is off by {_share(claim["error"])} (RMS); the table's part of that is {_share(claim["from_table"], 1)}, one
        part in {parts:,}."""
    )


# Tables whose errors are called alike, and classes of run times in seconds.
_ALIKE = 1.1
_TIMES = (5, 10, 20, 30, 60, 120, 300, 600, 3600)

PAGES: Mapping[str, tuple[str, ...]] = {
    "README.md": ("day", "choice", "c-output", "py-output", "limits", "times"),
    "docs/guide.md": ("fit",),
    "docs/results.md": ("results", "lighting", "speed", "gradient", "ringing", "pictures", "daylight", "valley"),
}
"""The blocks of each page, by its path."""

BLOCKS: Mapping[str, Callable[[Released], str]] = {
    "day": _day,
    "choice": _choice,
    "limits": _limits,
    "times": _times,
    "results": _results,
    "speed": _speed,
    "fit": _fit,
    "c-output": _c_output,
    "py-output": _py_output,
    "gradient": _gradient,
    "pictures": _pictures,
    "ringing": _ringing,
    "daylight": _daylight,
    "lighting": _lighting,
    "valley": _valley,
}
