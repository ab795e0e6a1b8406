"""Evaluation: every table and rival warm and with a cold cache, in three builds; and table against rival, pair by pair."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from skylight_sh.studies import outcomes
from skylight_sh.studies.page import Row, Section
from skylight_sh.studies.speed.contest import LITERAL, OURS, Contest
from skylight_sh.studies.timing import NOISY, Spread

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CALLS_TEXT = (
    "One call: inputs to all weights, azimuth rotation included, over sets of inputs that fill the ranges, in nanoseconds "
    "of the thread's CPU clock. All candidates of a build run in one process and take turns in every round; figures are "
    "medians over rounds, `spread` their interquartile range over the median, `noisy` what spreads by a tenth or more. "
    "`times faster` is than `paper-literal`, round by round. `cold` is a call after 64 MB of other memory was written, "
    "since a frame asks once; a round's figure is the median of seven. Builds: cc -O3 (`portable`), and -mavx2 -mfma, and "
    "-march=native. `code` is the call's machine code at -O3, beside the bytes of its constants. `paper-literal` is the "
    "2008 scheme: monomials of degree (13, 7) in double precision, all orders; `paper-well-written` has the same "
    "polynomials over scaled parameters in float32, orders m >= 0, powers shared, within a few per cent of the fastest of "
    "six writings. `unpack` decodes a packed table, an `unpacked table` is a call after that, its bytes the memory. A "
    "`lookup` is the smallest table on a grid of the product's own variables, divided by its factor, whose error is the "
    "table's. `brute force` evaluates the sky and sums. E_mean is of what the program returns."
)
RIVALS_TEXT = (
    "Each table against those of as many bands: how many times as long the rival takes, and how many times as many bytes "
    "of constants it reads. Below 1 the rival wins. Lookup tables and `direct` are as exact as the table; the paper's "
    "scheme and brute force are what they are. All ratios are from the rounds of `evaluation`."
)


def calls(contest: Contest) -> Section:
    """Return what each candidate costs in each build."""
    rows: list[Row] = []
    for name, candidate in contest.candidates.items():
        for build, result in contest.results.items():
            figures = {"": (result.warm.time(name), result.warm.times_faster(name, LITERAL))}
            if result.cold:
                figures["cold "] = (result.cold.time(name), result.cold.times_faster(name, LITERAL))
            row: dict[str, object] = {
                "table": name,
                "kind": candidate.kind,
                "bands": candidate.bands,
                "build": build,
                "bytes": candidate.bytes,
                "code": contest.code[name],
                "E_mean": contest.errors[name],
            }
            noisy: list[str] = []
            for kind, (time, ratio) in figures.items():
                row |= {f"{kind}ns": 1e9 * time.median, f"{kind}spread": time.spread}
                row |= {f"{kind}times faster": ratio.median, f"{kind}ratio's spread": ratio.spread}
                noisy += [f"{kind}{what}" for what, figure in (("ns", time), ("ratio", ratio)) if figure.noisy]
            rows.append(row | {"noisy": ", ".join(noisy)})
    return Section(
        "evaluation",
        "Evaluation: error against time and bytes",
        f"{CALLS_TEXT} {told(contest)}",
        rows,
        _draw,
        outcomes.evaluation(rows),
    )


def rivals(contest: Contest) -> Section:
    """Return each table against each of its rivals."""
    rows: list[Row] = []
    for name, candidate in contest.candidates.items():
        for rival in contest.rivals(name) if candidate.kind in OURS else []:
            ratios: dict[str, Spread] = {}
            for build, result in contest.results.items():
                ratios[build] = result.warm.times_faster(name, rival)
                if result.cold:
                    ratios[f"{build}, cold"] = result.cold.times_faster(name, rival)
            row: dict[str, object] = {"table": name, "rival": rival}
            row |= {"bytes": contest.candidates[rival].bytes / candidate.bytes}
            for label, ratio in ratios.items():
                row |= {label: ratio.median, f"{label}: spread": ratio.spread}
            row["rival wins"] = ", ".join(label for label, ratio in ratios.items() if ratio.high < 1.0)
            rows.append(row | {"noisy": ", ".join(label for label, ratio in ratios.items() if ratio.noisy)})
    return Section("rivals", "Tables against their rivals", RIVALS_TEXT, rows, told=outcomes.rivals(rows) if rows else "")


def told(contest: Contest) -> str:
    """Say how many timings were dropped, and how many ratios are flagged."""
    dropped, total = contest.timings
    found = [
        laps.times_faster(name, LITERAL)
        for result in contest.results.values()
        for laps in (result.warm, result.cold)
        if laps
        for name in contest.candidates
        if name != LITERAL
    ]
    noisy = sum(ratio.noisy for ratio in found)
    return (
        f"{dropped:,} of {total:,} timings were disturbed by other work, and dropped; {noisy} of {len(found)} ratios "
        f"spread by {100 * NOISY:.0f} % or more, and are flagged."
    )


# What the picture tells apart, by candidates' kinds.
_GROUPS = {
    "fast tables": ("table",),
    "packed tables, decoded at every call": ("packed table",),
    "packed tables, decoded once": ("unpacked table",),
    "the paper's scheme": ("paper",),
    "lookup tables, linear": ("lookup, linear",),
    "lookup tables, cubic": ("lookup, cubic",),
    "quadrature and brute force": ("direct", "brute force"),
}


def _draw(rows: Sequence[Row]) -> Figure:
    from skylight_sh.report import style

    figure = style.figure(style.WIDTH, 9.4)
    panels = figure.subplots(2, 1, sharey=True)
    shown = [row for row in rows if row["build"] == "portable" and row["E_mean"] is not None]
    most = max(int(str(row["bands"])) for row in shown)
    for label, kinds, colour, marker in zip(_GROUPS, _GROUPS.values(), style.SERIES, style.MARKERS, strict=True):
        for filled in (True, False):
            mine = [row for row in shown if row["kind"] in kinds and (row["bands"] == most) == filled]
            for panel, key in zip(panels, ("ns", "bytes"), strict=True):
                panel.loglog(
                    [row[key] for row in mine],
                    [row["E_mean"] for row in mine],
                    marker,
                    color=colour,
                    markerfacecolor=colour if filled else "none",
                    markersize=8,
                    label=label if filled else None,
                )
    panels[0].set_xlabel("nanoseconds a call, warm, -O3")
    panels[1].set_xlabel("bytes of constants")
    for panel in panels:
        panel.set_ylabel("largest E_mean")
        panel.xaxis.set_major_formatter(style.plain_ticks())
        panel.yaxis.set_major_formatter(style.percent_ticks())
        style.steps(panel.xaxis)
        style.steps(panel.yaxis)
        panel.grid(True, which="major", alpha=0.3)
    panels[0].set_title(f"filled: {most} bands; open: fewer", fontsize=11)
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", fontsize=11, frameon=False)
    return figure
