"""The report: what the page says, what errors.csv holds, and pictures for any number of axes."""

from __future__ import annotations

import itertools
import json
import re
import shutil
import struct
from collections.abc import Callable
from html import unescape
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from conftest import SMALL, run_quietly
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.transforms import Bbox
from PIL import Image
from skylight_sh import MissingExtraError, runtime, shipped
from skylight_sh.config import load
from skylight_sh.report import overview, style, timings
from skylight_sh.report.amounts import percent
from skylight_sh.report.choice import same_as
from skylight_sh.report.origins import explained
from skylight_sh.report.report_data import Entry
from skylight_sh.report.titles import title
from skylight_sh.run.provenance import settings
from skylight_sh.run.runner import Result

PICTURES = ("bands", "maps", "panoramas", "ringing", "gibbs", "encoding", "bytes", "degrees")
FIGURES = f"figures = {json.dumps([*PICTURES, 'daylight', 'surroundings'])}"


def png_size(data: bytes) -> tuple[int, int]:
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    width, height = struct.unpack(">II", data[16:24])
    return width, height


def test_page_stands_alone(small_run: Result) -> None:
    page = (small_run.folder / "index.html").read_text(encoding="utf-8")
    assert "://" not in page.replace("json-schema", "")
    links = set(re.findall(r'(?:src|href)="([^"#]+)"', page))
    assert links
    assert all((small_run.folder / link).is_file() for link in links)
    for row in small_run.summary["tables"]:
        assert row["name"] in page
        assert percent(row["e_mean"]) in page
    # What sorts tables; the player's script, and what it reads.
    assert page.count("<script") == 3


class _Cells(HTMLParser):
    """The words of each cell of a page's tables, and the numbers that they are sorted by."""

    def __init__(self) -> None:
        super().__init__()
        self.cells: list[str] = []
        self.keys: list[str] = []
        self._open = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag in ("td", "th"):
            self._open = True
            self.cells.append("")
            self.keys += [value or "" for name, value in attrs if name == "data-key"]

    def handle_endtag(self, tag: str) -> None:
        self._open = self._open and tag not in ("td", "th")

    def handle_data(self, data: str) -> None:
        if self._open:
            self.cells[-1] += data


def _cells(page: str) -> _Cells:
    found = _Cells()
    found.feed(page)
    return found


def test_every_table_is_linked_and_no_cell_is_empty(small_run: Result) -> None:
    page = (small_run.folder / "index.html").read_text(encoding="utf-8")
    for row in small_run.summary["tables"]:
        for file in ("skylight_sh.h", "skylight_sh.npz"):
            assert f'href="{row["path"]}/{file}"' in page
    found = _cells(page)
    assert all(cell.strip() for cell in found.cells)
    assert {"nan", "inf", "None"}.isdisjoint(found.cells)
    numbers = [float(key) for key in found.keys]
    assert len(numbers) >= 6 * len(small_run.summary["tables"])
    assert np.all(np.isfinite(numbers))
    for row in small_run.summary["tables"]:
        assert f'data-key="{row["bytes"]}">{row["bytes"]:,}<' in page
        assert row["e_mean"] in numbers


def test_every_shipped_config_has_a_title_of_its_own() -> None:
    told = {}
    for name in shipped.names():
        try:
            config = load(shipped.find(name))
            light = config.source.title
        except MissingExtraError:
            continue
        told[name] = title(light, settings(config))
        assert told[name].startswith(f"{name}: ")
        assert "cd/m²" in told[name] or "lux" in told[name] or "zenith" in told[name]
    assert len(told) > 30
    assert len(set(told.values())) == len(told)
    # A title tells what is in the scene, so that runs of one sky are told apart without their names.
    alike = ("preetham", "desktop-prt", "mobile-diffuse", "clear-day", "courtyard", "papers-scenes", "paper")
    assert len({told[name].partition(": ")[2] for name in alike}) == len(alike)
    assert "7 bands within 0.1 %" in told["preetham"]
    assert "in lux" in told["mobile-diffuse"]
    assert "turbidity 3" in told["fixed-weather"]
    assert "sun's disc" in told["clear-day"]
    assert "luminance" in told["high-latitude-winter"]


def test_the_page_over_all_runs_lists_what_is_whole(small_run: Result, tmp_path: Path) -> None:
    shutil.copytree(small_run.folder, tmp_path / "one")
    shutil.copytree(small_run.folder, tmp_path / "two & <b>")
    (tmp_path / "empty").mkdir()
    (tmp_path / "broken").mkdir()
    (tmp_path / "broken" / "summary.json").write_text('{"tables": []', encoding="utf-8")
    (tmp_path / "stray.txt").touch()
    found = overview.runs(tmp_path)
    assert [run.folder for run in found] == ["one", "two & <b>"]
    best = next(row for row in small_run.summary["tables"] if row["name"] == small_run.summary["recommended"])
    assert (found[0].table, found[0].bytes, found[0].error) == (best["name"], best["bytes"], best["e_mean"])
    page = overview.page(found).decode()
    assert "<b>" not in page
    assert "://" not in page
    told = _cells(page)
    assert all(cell.strip() for cell in told.cells)
    assert found[0].title in told.cells
    assert percent(best["e_mean"]) in told.cells
    assert [float(key) for key in told.keys] == 2 * [best["bytes"], best["e_mean"]]
    assert {unescape(link) for link in re.findall(r'href="([^"]+)"', page)} == {f"{run.folder}/index.html" for run in found}


def test_a_run_lists_itself_and_others(tmp_path: Path) -> None:
    text = (SMALL.parent / "small-cie.toml").read_text(encoding="utf-8")
    config = load(SMALL.parent / "small-cie.toml")
    first = run_quietly(config, tmp_path)
    page = first.folder.parent / "index.html"
    before = page.read_bytes()
    assert f"{first.folder.name}/index.html".encode() in before
    name = config.name
    (tmp_path / "again.toml").write_text(text.replace(f'name = "{name}"', 'name = "again"', 1), encoding="utf-8")
    run_quietly(load(tmp_path / "again.toml"), tmp_path)
    assert [run.folder for run in overview.runs(page.parent)] == sorted(["again", first.folder.name])
    assert b"again/index.html" in page.read_bytes()


def test_times_are_shown_of_the_very_table_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def spread(ns: float) -> dict[str, object]:
        return {"portable": {"ns": {"median": ns}}}

    rows = [
        {"name": "a", "kind": "table", "bytes": 100, "times": spread(12.3)},
        {"name": "b-packed", "kind": "packed table", "bytes": 50, "times": spread(5000.0)},
        {"name": "b-packed: unpack", "kind": "unpack", "bytes": 300, "times": spread(4900.0)},
        {"name": "b-packed: unpacked table", "kind": "unpacked table", "bytes": 300, "times": spread(20.0)},
        {"name": "a: direct", "kind": "direct", "bytes": 100, "times": spread(1.0)},
    ]
    told = {"machine": {"processor": "A processor", "compiler": "cc (some) 12"}, "candidates": rows}
    (tmp_path / "speed.json").write_text(json.dumps(told), encoding="utf-8")
    monkeypatch.setattr(shipped, "speed", lambda: tmp_path / "speed.json")
    found = timings.released()
    assert found.machine.startswith("A processor, cc -O3")
    assert found.of("a", 100) == timings.Timing(12.3)
    assert found.of("a", 101) is None
    assert found.of("a: direct", 100) is None
    assert found.of("b-packed", 50) == timings.Timing(5000.0, 4900.0, 20.0, 300)
    monkeypatch.setattr(shipped, "speed", lambda: None)
    assert timings.released().of("a", 100) is None


def test_the_released_figures_are_those_that_reports_show() -> None:
    told = json.loads((shipped.folder().parent / "reports" / "reference" / "speed.json").read_text(encoding="utf-8"))
    found = timings.released()
    assert told["machine"]["processor"] in found.machine
    tables = [row for row in told["candidates"] if row["kind"] in ("table", "packed table")]
    assert tables
    for row in tables:
        timing = found.of(row["name"], row["bytes"])
        assert timing is not None
        assert timing.ns == row["times"]["portable"]["ns"]["median"]
        assert (timing.unpack is not None) == (row["kind"] == "packed table")


def _luminance(colour: str) -> float:
    shares = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    red, green, blue = (s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4 for s in shares)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def test_both_schemes_have_enough_contrast_to_be_read(small_run: Result) -> None:
    page = (small_run.folder / "index.html").read_text(encoding="utf-8")
    schemes = [
        dict(re.findall(r"--(\w+): (#[0-9a-f]{6})", block)) for block in re.findall(r":root \{(.*?)\}", page, re.DOTALL)
    ]
    assert len(schemes) == 3
    for scheme in schemes[:2]:
        for ink in ("ink", "soft", "mark"):
            for paper in ("paper", "tint", "best"):
                light, dark = sorted((_luminance(scheme[ink]), _luminance(scheme[paper])), reverse=True)
                assert (light + 0.05) / (dark + 0.05) >= 4.5, (ink, paper)


def test_one_table_under_two_names_is_told(small_run: Result) -> None:
    tables = {
        row["name"]: runtime.read(small_run.folder / row["path"] / "skylight_sh.npz") for row in small_run.summary["tables"]
    }
    zero = np.zeros((2, 1, 1))
    entries = [Entry(name, table, zero, zero, zero[0], zero) for name, table in tables.items()]
    again = [Entry(f"{one.name}-again", one.table, zero, zero, zero[0], zero) for one in entries]
    assert same_as(entries) == {}
    assert same_as([*entries, *again]) == {f"{name}-again": name for name in tables}


def test_the_papers_error_is_explained_by_the_trials_own_figures() -> None:
    trials = {
        "solver": np.array(["svd", "qr", "normal"]),
        "solver_e_mean": np.array([[0.003, 2.0], [0.003, 2.0], [3.7, 5.0]]),
        "samples": np.array([100, 400, 1600]),
        "own": np.array([0.02, 0.01, 0.005]),
        "truth": np.array([0.2, 0.1, 0.05]),
        "m_below_0": np.array([0.026, 0.013, 0.0065]),
        "rel_l2": np.array([0.106, 0.053, 0.0265]),
    }
    words = " ".join(explained(trials, 0.001))
    assert "0.3 %" in words
    assert "370 %" in words
    assert "About 400 to 1,600 samples" in words
    assert "not like polynomials or degrees" in words
    # 800 samples, half way between, are off by 0.1 / sqrt 2.
    assert "about 7 % off the truth, 5 times what the paper quotes" in words
    # What the trials do not reach is not claimed.
    trials["rel_l2"] = np.array([0.9, 0.8, 0.7])
    assert "not like polynomials" not in " ".join(explained(trials, 0.001))


def _labels(figure: Figure) -> dict[str, Bbox]:
    """Return the letters that a drawn figure shows, with their places in pixels; letters at one place once."""
    hidden: set[Text] = set()
    for axes in figure.findobj(Axes):
        for axis in (axes.xaxis, axes.yaxis):
            low, high = sorted(axis.get_view_interval())
            room = 1e-9 * (high - low)
            if not (axis.get_visible() and axes.axison):
                hidden.update(axis.findobj(Text))
            for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks()):
                if not low - room <= tick.get_loc() <= high + room:
                    hidden.update((tick.label1, tick.label2))
    found = {}
    for text in figure.findobj(Text):
        if text.get_text().strip() and text.get_visible() and text not in hidden:
            place = text.get_window_extent()
            found[f"{text.get_text()} at {place.x0:.0f} {place.y0:.0f}"] = place
    return found


def test_letters_of_figures_are_legible_on_a_phone_and_do_not_overlap(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn: list[Figure] = []

    def png(figure: Figure, made: Callable[[Figure], bytes] = style.png) -> bytes:
        drawn.append(figure)
        return made(figure)

    monkeypatch.setattr(style, "png", png)
    text = SMALL.read_text(encoding="utf-8").replace('figures = ["bands"]', FIGURES)
    (tmp_path / "all.toml").write_text(text, encoding="utf-8")
    run_quietly(load(tmp_path / "all.toml"), tmp_path)
    assert len(drawn) >= len(PICTURES)
    for figure in drawn:
        shown = 360.0 / figure.bbox.width
        labels = _labels(figure)
        assert labels
        sizes = [t.get_fontsize() for t in figure.findobj(Text) if t.get_text().strip()]
        assert min(sizes) * figure.dpi / 72.0 * shown >= 11.0 - 1e-6
        for (one, place), (other, there) in itertools.combinations(labels.items(), 2):
            both = Bbox.intersection(place, there)
            # Boxes are a little larger than their letters.
            assert both is None or min(both.width, both.height) * shown < 2.5, (one, other)


def test_page_escapes_what_the_config_says(tmp_path: Path) -> None:
    text = SMALL.read_text(encoding="utf-8").replace('figures = ["bands"]', FIGURES)
    text = text.replace("Sunset & <dust>", "<script>alert(1)</script>")
    (tmp_path / "all.toml").write_text(text, encoding="utf-8")
    result = run_quietly(load(tmp_path / "all.toml"), tmp_path)
    page = (result.folder / "index.html").read_text(encoding="utf-8")
    assert "<script>alert" not in page
    assert "&lt;script&gt;alert" in page
    for name in (*PICTURES, "daylight"):
        width, height = png_size((result.folder / "figures" / f"{name}.png").read_bytes())
        assert width >= 800
        assert height >= 350
        assert b"matplotlib" not in (result.folder / "figures" / f"{name}.png").read_bytes().lower()
        # A label that the picture's edge cuts off would leave ink on it.
        pixels = np.asarray(Image.open(result.folder / "figures" / f"{name}.png").convert("RGB"))
        assert all(edge.min() == 255 for edge in (pixels[0], pixels[-1], pixels[:, 0], pixels[:, -1])), name


def test_errors_csv_is_the_contract(small_run: Result) -> None:
    table = pd.read_csv(small_run.folder / "errors.csv")
    columns = ["basis", "dtype", "bands", "channel", "l_min", "e_max", "e_mean", "rel_l2", "coefficients", "bytes"]
    axes = ("sun_zenith", "turbidity")
    assert {*columns, *(f"degree_{a}" for a in axes), *(f"{a}_at_worst" for a in axes)} <= set(table.columns)
    sweep = table[table["table"] == "sweep"]
    assert len(sweep) == 7 * 6 * 4 * 3 * 2
    assert not sweep.duplicated([*(f"degree_{a}" for a in axes), "bands", "channel", "l_min"]).any()
    assert np.all(np.isfinite(table[["e_max", "e_mean", "rel_l2"]]))
    assert np.all(table["e_max"] >= table["e_mean"])
    assert table["sun_zenith_at_worst"].between(0, np.pi / 2).all()
    for row in small_run.summary["tables"]:
        mine = table[(table["table"] == row["name"]) & (table["bands"] == row["bands"]) & (table["l_min"] == row["l_min"])]
        assert mine["e_mean"].max() == pytest.approx(row["e_mean"], rel=1e-3)
        assert mine["e_max"].max() == pytest.approx(row["e_max"], rel=1e-3)
    index = ["table", "bands", "channel", "degree_sun_zenith", "degree_turbidity"]
    stricter = table.pivot_table(index=index, columns="l_min", values="e_mean")
    assert np.all(stricter["global"] >= stricter["per-set"] * (1 - 1e-3))


def test_more_bands_never_err_less_and_more_degrees_end_better(small_run: Result) -> None:
    table = pd.read_csv(small_run.folder / "errors.csv")
    sweep = table[(table["table"] == "sweep") & (table["l_min"] == "per-set")]
    by_bands = sweep.pivot_table(
        index=["degree_sun_zenith", "degree_turbidity", "channel"], columns="bands", values="e_mean"
    )
    assert np.all(np.diff(by_bands.to_numpy(), axis=1) >= 0)
    worst = sweep[sweep["bands"] == 4].groupby(["degree_sun_zenith", "degree_turbidity"])["e_mean"].max()
    assert worst[(9, 6)] < 0.1 * worst[(3, 1)]


def test_one_axis_and_one_channel_have_their_pictures(tmp_path: Path) -> None:
    text = (SMALL.parent / "small-cie.toml").read_text(encoding="utf-8")
    (tmp_path / "cie.toml").write_text(f"{text}\n[report]\n{FIGURES}\n", encoding="utf-8")
    result = run_quietly(load(tmp_path / "cie.toml"), tmp_path)
    for name in PICTURES:
        png_size((result.folder / "figures" / f"{name}.png").read_bytes())
    # What a light or a scene does not have is not shown.
    assert not any((result.folder / "figures" / f"{name}.png").exists() for name in ("daylight", "surroundings"))
    assert "CIE general sky, type 12" in (result.folder / "index.html").read_text(encoding="utf-8")


def test_percent_never_shows_exponents() -> None:
    assert [percent(v) for v in (0.015, 1e-7, 12.3, 0.0)] == ["1.5 %", "0.00001 %", "1,230 %", "0 %"]
