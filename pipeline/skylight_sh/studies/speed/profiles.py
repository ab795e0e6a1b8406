"""Scene profiles: what is skipped, and what bytes, build time and evaluation time fall to; each line built and measured."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable
from copy import deepcopy
from pathlib import Path
from typing import Any

from skylight_sh.config import parse
from skylight_sh.config.schema import Config
from skylight_sh.run import plan
from skylight_sh.run.from_config import headline_of, read_table
from skylight_sh.run.progress import silent
from skylight_sh.run.provenance import settings
from skylight_sh.run.steps import steps
from skylight_sh.runtime import Table
from skylight_sh.store.store import Store
from skylight_sh.studies import compiled, outcomes
from skylight_sh.studies.grid_samples import Samples, light_alone
from skylight_sh.studies.page import Row, Section
from skylight_sh.studies.speed import contest, race
from skylight_sh.table.size import bytes_of

TEXT = (
    "The config's light built anew in an empty store for each profile, one table each: CPU seconds from nothing to the "
    "selected table, its bytes and error as shipped, nanoseconds a call (portable -O3, everything included), and how "
    "many times faster that is than the paper-literal header in the same rounds, with the ratio's interquartile range over "
    "its median."
)
_FIXED = {"turbidity": 3.0}


def section(config: Config, samples: Samples, repeats: int) -> Section:
    """Build and time every profile that the config's axes allow."""
    built = [(label, *_build(parse(_raw(config, edit), label))) for label, edit in _profiles(config)]
    ranges = contest.ranges_of([axis.range for axis in config.axes], fixed_azimuth=False)
    entrants = {contest.LITERAL: race.calls(contest.literal(samples).header, ranges)}
    for label, _, table, _ in built:
        own = contest.ranges_of([(axis.low, axis.high) for axis in table.axes], fixed_azimuth=table.spec.azimuth is not None)
        entrants[label] = race.calls(compiled.header_of(table), own)
    with tempfile.TemporaryDirectory() as folder:
        found = race.run(entrants, ["-O3"], Path(folder), 6 * repeats).warm
    rows: list[Row] = []
    for label, seconds, table, error in built:
        ratio = found.times_faster(label, contest.LITERAL)
        rows.append(
            {
                "profile": label,
                "build CPU s": seconds,
                "bytes": bytes_of(table),
                "E_mean": error,
                "inputs": len(table.axes) + (table.spec.azimuth is None),
                "ns": 1e9 * found.time(label).median,
                "times faster": ratio.median,
                "spread": ratio.spread,
                "noisy": "yes" if ratio.noisy else "",
            }
        )
    return Section("profiles", "Scene profiles", TEXT, rows, told=outcomes.profiles(rows))


def _profiles(config: Config) -> list[tuple[str, Callable[[dict[str, Any]], None]]]:
    """Return each profile's label and how it changes the config's data."""

    def bands(n: int, budget: float) -> Callable[[dict[str, Any]], None]:
        def edit(raw: dict[str, Any]) -> None:
            raw["truth"]["bands"] = n
            raw["winners"] = [{"bands": n, "budgets": [budget]}]
            raw["export"]["recommended"] = f"{n}-bands-{100 * budget:.6g}pct"

        return edit

    def scene(n: int, budget: float, **keys: Any) -> Callable[[dict[str, Any]], None]:
        def edit(raw: dict[str, Any]) -> None:
            bands(n, budget)(raw)
            raw["scene"] |= keys
            raw["axes"] = [axis for axis in raw["axes"] if axis["name"] not in keys.get("fixed", {})]

        return edit

    def low_sun(raw: dict[str, Any]) -> None:
        bands(7, 0.001)(raw)
        raw["axes"][0]["range"][0] = 1.2

    found = [
        ("7 bands, 0.1 %", bands(7, 0.001)),
        ("7 bands, 0.1 %, luminance", scene(7, 0.001, channels="luminance")),
        ("7 bands, 0.1 %, fixed azimuth", scene(7, 0.001, azimuth=0.5)),
        ("4 bands, 0.1 %", bands(4, 0.001)),
        ("diffuse, 3 bands, 0.1 %", scene(3, 0.001, quantity="irradiance")),
        ("diffuse, 3 bands, 1.5 %", scene(3, 0.015, quantity="irradiance")),
    ]
    if config.axes[0].name == config.light.hints.peak_axis:
        found.append(("7 bands, 0.1 %, a sun below 21 degrees", low_sun))
    if len(config.axes) > 1 and all(name in {a.name for a in config.axes} for name in _FIXED):
        found += [
            ("7 bands, 0.1 %, fixed weather", scene(7, 0.001, fixed=_FIXED)),
            ("diffuse, 3 bands, 0.1 %, fixed weather", scene(3, 0.001, quantity="irradiance", fixed=_FIXED)),
        ]
    return found


def _raw(config: Config, edit: Callable[[dict[str, Any]], None]) -> dict[str, Any]:
    raw = light_alone(deepcopy(settings(config)))
    raw["report"] = {"figures": []}
    raw["fit"]["references"] = []
    edit(raw)
    return raw


def _build(config: Config) -> tuple[float, Table, float]:
    """Return CPU seconds of all threads to the selected table from an empty store, the table and its error."""
    wanted = [step for step in steps(config) if step.stage in ("truth", "fit", "select", "measure")]
    with tempfile.TemporaryDirectory() as folder:
        start = _cpu()
        _, made = plan.execute(wanted, Store(Path(folder)), dict, silent, lambda _: None, wanted=("select", "measure"))
        seconds = _cpu() - start
    name = config.export.recommended
    table = read_table(made["select"], f"tables/{name}")
    return seconds, table, headline_of(made["measure"], f"tables/{name}")[0]


def _cpu() -> float:
    """Return the CPU seconds of this process, its threads and the processes that it has waited for."""
    return sum(os.times()[:4])
