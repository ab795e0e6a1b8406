"""The tables of runs as their folders tell them: ``summary.json``, ``errors.csv`` and a benchmark's ``speed.json``."""

from __future__ import annotations

import csv
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from skylight_sh import UserError
from skylight_sh.report import timings, titles
from skylight_sh.report.timings import Timing, Timings

SUMMARY = "summary.json"
# Where a run's own benchmark leaves its figures, and where a release has them.
_SPEEDS = ("bench/speed.json", "speed.json")


@dataclass(frozen=True)
class PublishedTable:
    """A table of a run under ``reports``: its ``run``, ``name`` and ``folder``, size, and headline errors as fractions.

    ``quantity`` is ``radiance`` or ``irradiance``, ``unit`` says what the weights are of in words, with its unit. Tables of
    equal ``sky`` expand the same light in the same scene over the same ranges, so that one may stand in for the other;
    ``sky_words`` tells these. ``timing`` is None where this very table was not timed, for which ``untimed`` has a word.
    ``convention`` is that of the errors.
    """

    reports: Path
    run: str
    name: str
    folder: Path
    prefix: str
    bands: int
    layout: str
    bytes: int
    e_mean: float
    e_max: float
    convention: str
    quantity: str
    unit: str
    sky: str
    sky_words: str
    recommended: bool
    timing: Timing | None
    untimed: str
    machine: str

    @property
    def title(self) -> str:
        """The run and the name, as the command line takes them."""
        return f"{self.run}/{self.name}"

    @property
    def ns(self) -> float | None:
        """Nanoseconds of a call, all bands; a packed table decodes in each."""
        return self.timing.ns if self.timing else None


def folders(reports: Path) -> list[Path]:
    """Return the folders under ``reports`` that hold a summary, whole or not, by name."""
    return sorted(path.parent for path in reports.glob(f"*/{SUMMARY}"))


def read(folder: Path, released: Timings) -> list[PublishedTable]:
    """Return the tables of the run in ``folder``; times are of its own benchmark, or else the ``released`` ones.

    Raises UserError, which tells path and remedy, where its summary cannot be read or lacks something.
    """
    place = folder / SUMMARY
    try:
        told = json.loads(place.read_text(encoding="utf-8"))
        settings = told["config"]
        parts = [settings["light"], settings["scene"], [[axis["name"], axis["range"]] for axis in settings["axes"]]]
        sky = json.dumps(parts, sort_keys=True)
        words = _sky_words(settings)
        unit = titles.quantity(settings)
        own, damaged = _own_timings(folder)
        return [
            _table(folder, row, (sky, words, unit), row["name"] == told["recommended"], (own, released, damaged))
            for row in told["tables"]
        ]
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        why = str(error)
        if isinstance(error, KeyError):
            why = f"it has no {error}"
        elif isinstance(error, TypeError | AttributeError):
            why = f"it is not what a run writes, {error}"
        raise UserError(
            f"{place} cannot be read as a run's summary: {why}. Run its config again, skylight-sh run {folder.name}, or "
            "remove the folder."
        ) from error


def _table(
    folder: Path,
    row: Mapping[str, object],
    sky: tuple[str, str, str],
    recommended: bool,
    speeds: tuple[Timings, Timings, bool],
) -> PublishedTable:
    name, size = str(row["name"]), _whole(row, "bytes")
    own, released, damaged = speeds
    used = own if own.of(name, size) else released
    timing = used.of(name, size)
    known = {named for timings_ in (own, released) for named, _ in timings_.by_table}
    untimed = "damaged" if damaged else "other bytes timed" if name in known else "not timed"
    identity, words, unit = sky
    return PublishedTable(
        reports=folder.parent,
        run=folder.name,
        name=name,
        folder=folder / str(row["path"]),
        prefix=str(row["prefix"]),
        bands=_whole(row, "bands"),
        layout=str(row["layout"]),
        bytes=size,
        e_mean=_error(row, "e_mean"),
        e_max=_error(row, "e_max"),
        convention=str(row["l_min"]),
        quantity=str(row["quantity"]),
        unit=unit,
        sky=identity,
        sky_words=words,
        recommended=recommended,
        timing=timing,
        untimed="" if timing else untimed,
        machine=used.machine if timing else "",
    )


def _whole(row: Mapping[str, object], key: str) -> int:
    value = row[key]
    if type(value) is not int or value < 1:
        raise ValueError(f"{key} of {row['name']} is {value!r}, but should be a whole number of at least 1")
    return value


def _error(row: Mapping[str, object], key: str) -> float:
    value = row[key]
    if not isinstance(value, int | float) or isinstance(value, bool) or not 0 <= value < float("inf"):
        raise ValueError(f"{key} of {row['name']} is {value!r}, but should be a fraction of at least 0")
    return float(value)


def _own_timings(folder: Path) -> tuple[Timings, bool]:
    """Return what a run's own benchmark says, and whether it has one that cannot be read."""
    for path in _SPEEDS:
        if (folder / path).is_file():
            try:
                return timings.read(folder / path), False
            except (OSError, ValueError, KeyError, TypeError, AttributeError):
                return Timings(), True
    return Timings(), False


def _sky_words(settings: Mapping[str, Any]) -> str:
    light = settings["light"]
    told = [str(light[key]) for key in ("model", "sky") if key in light]
    units = {"sun_zenith": "rad"}
    return ", ".join([" ".join(told), *titles.surroundings(settings), titles.ranges(settings, units)])


def errors_by_bands(tables: Sequence[PublishedTable], folder: Path) -> dict[str, dict[int, tuple[float, float]]]:
    """Return E_mean and E_max of each table of a run over its first 1, 2, .. bands, the worst channel, as fractions.

    All bands are as the summary tells them; the others are of ``errors.csv``, and missing where that file is.
    Raises UserError where it is damaged.
    """
    found: dict[str, dict[int, tuple[float, float]]] = {table.name: {} for table in tables}
    conventions = {table.name: table.convention for table in tables}
    place = folder / "errors.csv"
    try:
        if place.is_file():
            with place.open(encoding="utf-8", newline="") as file:
                for row in csv.DictReader(file):
                    name = row["table"]
                    if name in found and row["l_min"] == conventions[name]:
                        bands, now = int(row["bands"]), (float(row["e_mean"]), float(row["e_max"]))
                        before = found[name].get(bands, (0.0, 0.0))
                        found[name][bands] = (max(now[0], before[0]), max(now[1], before[1]))
    except (OSError, ValueError, KeyError, TypeError) as error:
        why = f"it has no column {error}" if isinstance(error, KeyError) else str(error)
        raise UserError(
            f"{place} cannot be read as a run's errors: {why}. Run its config again: skylight-sh run {folder.name}."
        ) from error
    for table in tables:
        found[table.name][table.bands] = (table.e_mean, table.e_max)
    return found
