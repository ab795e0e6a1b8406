"""Truth rules: error against time, from loose to tight."""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.config.schema import Config
from skylight_sh.light import BlackBox
from skylight_sh.quadrature import adaptive, direction_sums, monte_carlo, rings, sun_centred, zenith_gauss
from skylight_sh.studies import outcomes, timing
from skylight_sh.studies.page import Row, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

_HELD = sphere.Harmonics.even(7)
_FINEST = 160
# The two comparisons that are asked for: a rule, the error it is met at, and which rule meets it.
TEXT = (
    "One parameter set, 7 bands, directions and basis tabulated beforehand for every rule alike (an adaptive rule has "
    "no such table); the time is radiance and sums. Errors are relative to the largest weight, against 160 "
    "sun-centred nodes. `times faster than Monte Carlo` compares with stratified Monte Carlo of 1000 x 1000 samples, "
    "for rows whose error is no larger than its; `than zenith Gauss` with the cheapest zenith rule below 1e-7, for "
    "rows below 1e-7."
)


def section(config: Config, repeats: int) -> Section:
    """Time every rule at growing cost, at three quarters of the way from the first axis's start, half of the others'."""
    shares = [0.76, *[1 / 7] * (len(config.axes) - 1)]
    where = {a.name: a.range[0] + s * (a.range[1] - a.range[0]) for a, s in zip(config.axes, shares, strict=True)}
    exact = _centred(config, where, _FINEST)
    calls: dict[str, Callable[[], Array]] = {}
    samples: dict[str, int] = {}
    for name, nodes in _tables(config, where):
        table = direction_sums.tabulate(*nodes, _HELD)
        calls[name] = partial(direction_sums.project_one, config.source, where, nodes[0], table)
        samples[name] = len(nodes[0])
    for tolerance in (1e-3, 1e-6, 1e-9):
        name = f"adaptive, no hints, to {tolerance:g}"
        calls[name] = partial(_adaptive, config, where, tolerance)
        samples[name] = 0
    errors = {name: float(np.abs(call() - exact).max() / np.abs(exact).max()) for name, call in calls.items()}
    times = timing.rounds(calls, repeats, at_least=0.005)
    seconds = {name: statistics.median(found) for name, found in times.items()}
    carlo = next(name for name in calls if name.startswith("stratified Monte Carlo, 1000"))
    zenith = min((n for n in calls if n.startswith("zenith") and errors[n] <= 1e-7), key=seconds.__getitem__, default=None)
    rows: list[Row] = []
    for name in calls:
        to_carlo = timing.ratios(times[carlo], times[name]) if errors[name] <= errors[carlo] else None
        to_zenith = timing.ratios(times[zenith], times[name]) if zenith and errors[name] <= 1e-7 else None
        found = [ratio for ratio in (to_carlo, to_zenith) if ratio]
        rows.append(
            {
                "rule": name,
                "samples": samples[name] or None,
                "error": errors[name],
                "ms": 1e3 * seconds[name],
                "times faster than Monte Carlo": to_carlo.median if to_carlo else None,
                "times faster than zenith Gauss": to_zenith.median if to_zenith else None,
                "ratios' spread": max((ratio.spread for ratio in found), default=None),
                "noisy": "yes" if any(ratio.noisy for ratio in found) else "",
            }
        )
    return Section("rules", "Truth rules: error against time", TEXT, rows, _draw, outcomes.rules(rows))


def _tables(config: Config, where: dict[str, float]) -> Iterator[tuple[str, tuple[Array, Array]]]:
    """Yield each fixed rule's name and nodes, coarse to fine."""
    for n in (100, 300, 1000):
        yield f"stratified Monte Carlo, {n} x {n}", monte_carlo.directions(n, 1)
    for n in (16, 64, 128, 300, 512):
        yield f"zenith Gauss, {n} x {2 * n}", zenith_gauss.directions(n)
    theta = where[config.source.hints.peak_axis] if config.source.hints.peak_axis else 0.0
    for n in (12, 15, 20, 26, 32, 44, 64, 88):
        yield f"sun-centred, {n}", sun_centred.half_sky(theta, n)
    for n in (22, 32, 44, 60, 88, 112):
        yield f"rings, {n}", rings.half_sky(theta, n, _HELD.bands)


def _named(where: dict[str, float]) -> dict[str, Array]:
    return {name: np.full((1, 1), value) for name, value in where.items()}


def _centred(config: Config, where: dict[str, float], nodes: int) -> Array:
    got = sun_centred.project(config.source, _named(where), nodes=nodes, harmonics=_HELD).weights[0, 0]
    return np.asarray(got)


def _adaptive(config: Config, where: dict[str, float], tolerance: float) -> Array:
    light = BlackBox(config.light)
    got = adaptive.project(light, _named(where), tolerance=tolerance, harmonics=_HELD)
    return np.asarray(got.weights[0, 0])


def _draw(rows: Sequence[Row]) -> Figure:
    from skylight_sh.report import style

    figure = style.figure(style.WIDTH, 5.6)
    axes = figure.subplots()
    for i, kind in enumerate(("stratified Monte Carlo", "zenith Gauss", "sun-centred", "rings", "adaptive, no hints")):
        mine = [row for row in rows if str(row["rule"]).startswith(kind)]
        times, errors = [row["ms"] for row in mine], [max(float(str(row["error"])), 1e-16) for row in mine]
        axes.loglog(times, errors, label=kind, **style.look(i))
    axes.set_xlabel("milliseconds a parameter set")
    axes.set_ylabel("error, of the largest weight")
    axes.xaxis.set_major_formatter(style.plain_ticks())
    style.steps(axes.xaxis)
    style.decades(axes.yaxis)
    axes.grid(True, which="major", alpha=0.3)
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=2, fontsize=11, frameon=False)
    return figure
