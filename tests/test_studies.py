"""Pages of measurements: words follow from rows, every cell is filled, series are told apart."""

from __future__ import annotations

import itertools
import re
from pathlib import Path

import pytest
from skylight_sh.report import style
from skylight_sh.studies import outcomes, page
from skylight_sh.studies.page import Section


def test_a_page_of_measurements_shows_every_cell_and_what_came_out(tmp_path: Path) -> None:
    rows = [
        {"what": "<a>", "error": 0.00123, "bytes": 12345, "noisy": "", "holds": "yes"},
        {"what": "b", "error": None, "bytes": 7, "noisy": "ns", "holds": "no"},
        {"what": "c", "error": float("inf"), "bytes": 8, "noisy": "", "holds": "yes"},
    ]
    page.write(
        tmp_path, "Measured & told", "A lead.", [Section("one", "One", "What was <tried>.", rows, told="It came out.")]
    )
    text = (tmp_path / "index.html").read_text(encoding="utf-8")
    assert "Measured &amp; told" in text
    assert "<tried>" not in text
    assert "<a>" not in text
    assert "It came out. 1 of 3 rows do not hold. 1 of 3 rows is noisy." in text
    cells = re.findall(r"<t[dh][^>]*>(.*?)</t[dh]>", text)
    assert all(cells)
    assert {"12,345", "0.00123", "-", "overflow", "&lt;a&gt;"} <= set(cells)
    assert 'data-key="12345"' in text
    assert "://" not in text
    assert "prefers-color-scheme: dark" in text
    assert (tmp_path / "one.csv").is_file()


def test_series_are_told_apart_by_colour_and_marker() -> None:
    looks = [style.look(place) for place in range(14)]
    for one, other in itertools.combinations(looks, 2):
        assert any(one[key] != other[key] for key in ("color", "marker", "markerfacecolor"))
    for one, other in itertools.combinations(looks[:7], 2):
        assert one["color"] != other["color"]
        assert one["marker"] != other["marker"]


def test_words_follow_from_the_figures() -> None:
    def schemes(single: float) -> str:
        rows = [
            {"fit": "a", "scheme": "x", "float64": 0.001, "float32": single, "float16": float("nan"), "int16": 0.5},
            {"fit": "b", "scheme": "x", "float64": 0.001, "float32": 0.001, "float16": 0.1, "int16": 0.001},
        ]
        return outcomes.schemes(rows)

    assert "float32: 'a', the best at 0.1 %; float16: every one, the best at 10 %; int16: 'a'" in schemes(0.1)
    assert "float32: none" in schemes(0.0015)

    def bases(last: float) -> str:
        errors = (0.1, 0.01, last)
        return outcomes.bases(
            [{"fit": "a", "degree": k, "E_mean float64": 1.0, "E_mean float32": e} for k, e in enumerate(errors)]
        )

    assert "in float64 by none; in float32 by 'a'." in bases(0.05)
    assert "in float32 by 'a'" in bases(float("inf"))
    assert "in float32 by none" in bases(0.01)

    def sky(lux: float) -> str:
        rows = [{"sun's height": 90, "turbidity": "IES RP-21", "sky": 100, "sun": 200, "both": 300}]
        rows += [{"sun's height": 0, "turbidity": "IES RP-21", "sky": 10, "sun": 0, "both": 10}]
        rows += [{"sun's height": h, "turbidity": "2", "sky": lux, "sun": 0, "both": lux} for h in (0, 90)]
        return outcomes.daylight(rows)

    assert sky(200.0) == (
        "Times as bright as IES RP-21 on the horizon: sky 20, both 20; from 30 degrees up: sky 2, sun 0, both 0.67."
    )
    assert outcomes.again([{"ratio": 0.9}, {"ratio": 1.1}]) == "1 of 2 published errors hold; the largest ratio is 1.1."


@pytest.mark.parametrize(("win", "told"), [("", "In 0 of 1 pairs"), ("portable", "In 1 of 1 pairs")])
def test_rivals_that_win_are_told(win: str, told: str) -> None:
    words = outcomes.rivals([{"table": "a", "rival": "a: direct", "bytes": 0.25, "rival wins": win}])
    assert words.startswith(told)
    assert ("direct" in words) == bool(win)
    assert "0.25 times as many bytes" in words
