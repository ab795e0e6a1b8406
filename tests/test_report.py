"""The report: what the page says, what errors.csv holds, and pictures for any number of axes."""

from __future__ import annotations

import json
import re
import struct
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from conftest import SMALL, run_quietly
from PIL import Image
from skylight_sh.config import load
from skylight_sh.report.style import percent
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
    assert "<script" not in page


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
        pixels = np.asarray(Image.open(result.folder / "figures" / f"{name}.png"))
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
    assert [percent(v) for v in (0.015, 1e-7, 12.3, 0.0)] == ["1.5 %", "0.00001 %", "1230 %", "0 %"]
