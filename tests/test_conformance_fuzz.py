"""Headers called with inputs of any bits, in builds with sanitizers and without."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from skylight_sh.export import c_data
from skylight_sh.studies.stability import fuzz
from skylight_sh.studies.stability.flavours import flavours
from skylight_sh.table.table import float32_limits

pytestmark = pytest.mark.tools

FLAVOURS = flavours()
CORES = os.cpu_count() or 1


def test_any_bits_keep_the_promises(tmp_path: Path) -> None:
    cases = [(name, label) for name in FLAVOURS for label in fuzz.BUILDS]

    def one(number: int) -> tuple[bool, str]:
        name, label = cases[number]
        return fuzz.run(fuzz.build(FLAVOURS[name], tmp_path / str(number), fuzz.BUILDS[label]), 50_000, number)

    with ThreadPoolExecutor(CORES) as pool:
        results = dict(zip(cases, pool.map(one, range(len(cases))), strict=True))
    assert {case: text for case, (good, text) in results.items() if not good} == {}


def test_the_fuzzer_finds_a_limit_that_is_one_float_off(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    off = [(low, float(np.nextafter(np.float32(high), np.float32(9)))) for low, high in float32_limits(FLAVOURS["rows"])]
    monkeypatch.setattr(c_data, "float32_limits", lambda _: off)
    good, text = fuzz.run(fuzz.build(FLAVOURS["rows"], tmp_path, fuzz.BUILDS["gcc, fast-math"]), 50_000, 1)
    assert not good
    assert "promises 1 broken" in text
