"""Every shipped config's page in the browser: the config as it is but for coarse tables, which take no time to fit."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from browser import Browser, browser
from conftest import run_quietly
from skylight_sh import shipped
from skylight_sh.config import Config, load
from skylight_sh.config.wanted import table_names

DEGREE = 4
# Skies that do not hang on their sun.
STILL = {"cie-overcast", "cie-general-01", "cie-general-03", "cie-general-05"}


def coarse(config: Config) -> Config:
    """Return a config with one table of low degrees, on few nodes, without pictures."""
    few = {"nodes": 9, "verification": 13, "degrees": (2, DEGREE)}
    axes = tuple(axis.model_copy(update=few) for axis in config.axes)
    first = config.winners[0]
    table = {
        "budgets": (),
        "sizes": (),
        "layouts": ("rows",),
        "degrees": (DEGREE,) * len(axes),
        "bands": min(first.bands, 5),
    }
    truth = {"random": 5, "held_out": 16, "held_out_edge": 2, "bands": min(config.truth.bands, 5), "tolerance": 1e-4}
    changed = config.model_copy(
        update={
            "axes": axes,
            "winners": (first.model_copy(update=table),),
            "truth": config.truth.model_copy(update=truth),
            "fit": config.fit.model_copy(update={"references": ()}),
            "report": config.report.model_copy(update={"figures": (), "cases": ()}),
            "scene": config.scene.model_copy(update={"mesh": None}),
        }
    )
    export = {"recommended": table_names(changed)[0], "targets": ("npz",)}
    return changed.model_copy(update={"export": config.export.model_copy(update=export)})


@pytest.fixture(scope="module")
def window(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    with browser(tmp_path_factory.mktemp("browser")) as running:
        running.size(360, 780, phone=True)
        yield running


@pytest.mark.tools
@pytest.mark.parametrize("name", shipped.names())
def test_every_shipped_config_has_a_page(window: Browser, tmp_path: Path, name: str) -> None:
    # A coarse fit may be dark somewhere, which nobody shall see.
    with np.errstate(invalid="ignore", divide="ignore"):
        done = run_quietly(coarse(load(shipped.folder() / f"{name}.toml")), tmp_path)
    window.open(done.folder / "index.html")
    state = window.run("skylight.state()")
    keys = window.run("[...document.querySelectorAll('#player [data-key]')].map((one) => one.dataset.key)")
    assert set(keys) - {"height"} <= set(state)
    axes = {axis.name: axis.range for axis in load(shipped.folder() / f"{name}.toml").axes}
    assert set(axes) <= set(state)
    for axis, (low, high) in axes.items():
        seen = window.canvas("sky")
        # Into the other half of its range.
        share = 0.7 if state[axis] < (low + high) / 2 else 0.3
        window.run(f"skylight.set({{ {axis}: {low + share * (high - low)!r} }})")
        assert (window.canvas("sky") != seen).any() == (name not in STILL)
    radiance = window.canvas("sky").astype(int)
    assert radiance.max() > 60
    assert window.run("document.scrollingElement.scrollWidth") <= 360
    assert "NaN" not in window.run("document.getElementById('player').textContent")
    assert window.errors == []
