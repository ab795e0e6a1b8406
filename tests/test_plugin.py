"""A light of another package, told nothing of: sampled adaptively, its variables and prefactor found, fitted, exported."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from conftest import run_quietly
from skylight_sh import runtime, sphere
from skylight_sh.cli import main
from skylight_sh.config import ConfigError, load
from skylight_sh.light.plugin import Plugin
from skylight_sh.quadrature import direction_sums, zenith_gauss
from skylight_sh.store.store import Store

CONFIG = """
name = "glow"
[light]
model = "plugin"
entry = "example_glow"
options = { width = 0.8 }
[[axes]]
name = "sun_zenith"
range = [0.0, 1.5]
map = "auto"
nodes = 12
verification = 33
degrees = [2, 8]
[[axes]]
name = "strength"
range = [0.5, 8.0]
map = "auto"
nodes = 8
verification = 17
degrees = [1, 4]
[truth]
bands = 3
tolerance = 1e-7
random = 20
[fit]
prefactor = "auto"
[[winners]]
bands = 3
budgets = [0.001]
layouts = ["rows", "packed"]
[export]
recommended = "3-bands-0.1pct"
[report]
figures = ["maps"]
"""


def write(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "glow.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_a_black_box_from_another_package_goes_all_the_way(tmp_path: Path) -> None:
    result = run_quietly(load(write(tmp_path, CONFIG)), tmp_path)
    light = Plugin("example_glow", {"width": 0.8})
    directions, solid = zenith_gauss.directions(120)
    table = direction_sums.tabulate(directions, solid, 3)
    for row in result.summary["tables"]:
        assert row["e_mean"] <= 0.001
        loaded = runtime.load(result.folder / row["path"] / "skylight_sh.npz")
        for sun, strength in ((0.0, 8.0), (0.7, 2.3), (1.5, 0.5)):
            exact = direction_sums.project_one(light, {"sun_zenith": sun, "strength": strength}, directions, table)
            # The sky's least radiance is 1000 cd/m2 at least.
            assert np.linalg.norm(loaded.weights(sun, 0.0, strength) - exact) < 0.001 * 1000 * (1 + strength)
    store = Store(tmp_path / "artifacts")
    truths = [store.get(e.stage, e.key) for e in store.entries() if e.stage == "truth"]
    rule = next(t for t in truths if t.attrs["step"] == "truth/rule")
    assert rule.attrs["rule"] == "adaptive"
    assert bool(rule.attrs["mirrored"])  # found by sampling: the light claims nothing
    grid = next(t for t in truths if t.attrs["step"] == "truth/grid")
    assert grid["estimate"].max() <= 1e-7
    assert grid["weights"].shape[-1] == sphere.Harmonics.even(3).count


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('"example_glow"', '"nowhere"', r"No installed package offers the light 'nowhere'.*example_glow"),
        ("width = 0.8", "height = 0.8", r"unexpected keyword argument 'height'"),
    ],
)
def test_a_plugin_that_cannot_be_made_is_told(tmp_path: Path, old: str, new: str, message: str) -> None:
    with pytest.raises(ConfigError, match=message):
        load(write(tmp_path, CONFIG.replace(old, new)))


def test_a_rule_that_cannot_keep_its_word_is_refused(tmp_path: Path) -> None:
    path = write(tmp_path, CONFIG.replace("tolerance = 1e-7", 'tolerance = 1e-9\nrule = "stratified"'))
    places = ["--store", str(tmp_path / "s"), "--reports", str(tmp_path / "r")]
    result = CliRunner().invoke(main, ["run", str(path), *places])
    assert result.exit_code == 2
    assert "rule 'stratified' reach" in result.stderr
    assert "another truth.rule" in result.stderr
    assert not (tmp_path / "r").exists()
