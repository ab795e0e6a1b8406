"""Configs: every mistake is told, with its path, its value and a remedy, and leaves nothing behind."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from skylight_sh.cli import main
from skylight_sh.config import Config, ConfigError, load, table_names

ROOT = Path(__file__).resolve().parents[1]
GOOD = (Path(__file__).parent / "small.toml").read_text(encoding="utf-8")

# What is broken: text replaced in a config that holds, by what, and what the message must name.
BROKEN = {
    "wrong type": ("nodes = 12", 'nodes = "twelve"', r"\$\.axes\[0\]\.nodes = 'twelve'.*more than the largest degree"),
    "number for text": ('name = "small"', "name = 7", r"\$\.name = 7.*lower-case"),
    "float for an integer": ("bands = 4\ntolerance", "bands = 4.5\ntolerance", r"\$\.truth\.bands = 4\.5.*1 to 32"),
    "unknown key": ("random = 40", "randoms = 40", r"\$\.truth\.randoms = 40.*Did you mean 'random'"),
    "unknown section": ("[report]", "[reports]", r"\$\.reports = .*Did you mean 'report'"),
    "unknown light": ('model = "preetham"', 'model = "prethaam"', r"\$\.light = .*prethaam.*preetham"),
    "unknown option of a light": ('model = "preetham"', 'model = "preetham"\nsky = 3', r"\$\.light\.sky = 3.*Unknown key"),
    "missing key": ("nodes = 12\n", "", r"\$\.axes\[0\]\.nodes = None.*required"),
    "empty range": ("range = [2.5, 6.0]", "range = [6.0, 2.5]", r"\$\.axes\[1\]\.range = \[6\.0, 2\.5\].*low < high"),
    "turbidity below the pole": ("range = [2.5, 6.0]", "range = [1.5, 6.0]", r"\$\.axes\[1\]\.range = .*1\.7, 10.*1\.643"),
    "angle in degrees": ("1.5707963267948966]", "90.0]", r"\$\.axes\[0\]\.range = \[0\.0, 90\.0\].*rad"),
    "negative degree": ("degrees = [1, 6]", "degrees = [-1, 6]", r"\$\.axes\[1\]\.degrees\[0\] = -1.*0 to 40"),
    "degrees backwards": ("degrees = [3, 9]", "degrees = [9, 3]", r"\$\.axes\[0\]\.degrees = \[9, 3\].*least <= largest"),
    "too few nodes": ("nodes = 8", "nodes = 6", r"\$\.axes\[1\]\.nodes = 6.*at least 7"),
    "too coarse verification": ("verification = 25", "verification = 23", r"\$\.axes\[1\]\.verification = 23.*at least 24"),
    "pole of the map inside": ("point = 0.5", "point = 3.0", r"\$\.axes\[1\]\.point = 3\.0.*below the range"),
    "name that climbs": ('name = "small"', 'name = "../small"', r"\$\.name = '\.\./small'.*lower-case"),
    "prefix that is no identifier": (
        "[export]",
        '[export]\nprefix = "2-sky"',
        r"\$\.export\.prefix = '2-sky'.*lower-case C identifier",
    ),
    "budget that is no fraction": ("budgets = [0.05, 0.01]", "budgets = [5.0]", r"\$\.winners\[0\]\.budgets\[0\] = 5\.0"),
    "no such winner": ("4-bands-1pct", "4-bands-2pct", r"\$\.export\.recommended = '4-bands-2pct'.*4-bands-1pct"),
    "more bands than the truth": ("bands = 3", "bands = 9", r"\$\.winners\[1\]\.bands = 9.*truth has 4 bands"),
    "missing axis": ('name = "turbidity"', 'name = "albedo"', r"\$\.axes.*turbidity"),
    "case out of range": (
        "turbidity = 6.0 }",
        "turbidity = 7.0 }",
        r"cases\[0\]\.at\.turbidity = 7\.0.*2\.5, 6",
    ),
    "not a number": ("tolerance = 1e-8", "tolerance = nan", r"\$\.truth\.tolerance = nan.*1e-14 to 1e-2"),
    "released result overwritten": ('name = "small"', 'name = "reference"', r"\$\.name = 'reference'.*another name"),
    "no TOML": ("[light]", "[light", r"not valid TOML"),
}


@pytest.mark.parametrize("what", BROKEN)
def test_a_broken_config_is_refused_in_one_message_and_writes_nothing(what: str, tmp_path: Path) -> None:
    old, new, message = BROKEN[what]
    assert old in GOOD
    path = tmp_path / "broken.toml"
    path.write_text(GOOD.replace(old, new, 1), encoding="utf-8")
    options = ["--store", str(tmp_path / "store"), "--reports", str(tmp_path / "reports")]
    result = CliRunner().invoke(main, ["run", str(path), *options])
    assert result.exit_code == 2
    assert result.stdout == ""
    assert re.search(message, result.stderr), result.stderr
    assert "Traceback" not in result.stderr
    assert [p.name for p in tmp_path.iterdir()] == ["broken.toml"]


@pytest.mark.parametrize("kind", ["missing", "folder", "binary"])
def test_an_unreadable_file_is_refused(kind: str, tmp_path: Path) -> None:
    path = tmp_path / "config.toml"
    if kind == "folder":
        path.mkdir()
    elif kind == "binary":
        path.write_bytes(b"\xff\xfe\x00name")
    result = CliRunner().invoke(main, ["run", str(path)])
    assert result.exit_code == 2
    assert str(path) in result.stderr
    assert "Give the path of a TOML file" in result.stderr


def test_all_errors_come_at_once(tmp_path: Path) -> None:
    path = tmp_path / "broken.toml"
    broken = GOOD.replace("nodes = 12", "nodes = -1").replace("random = 40", "randoms = 40").replace('"log"', '"root"')
    path.write_text(broken, encoding="utf-8")
    with pytest.raises(ConfigError) as caught:
        load(path)
    text = str(caught.value)
    assert "3 problems" in text
    assert all(field in text for field in ("$.axes[0].nodes", "$.truth.randoms", "$.axes[1].map"))


@pytest.mark.parametrize("path", sorted((ROOT / "configs").glob("*.toml")), ids=lambda p: p.stem)
def test_shipped_configs_hold(path: Path) -> None:
    config = load(path)
    assert config.name == path.stem
    assert config.export.recommended in table_names(config)


def test_a_config_cannot_be_changed() -> None:
    # As code that is not type-checked would see it.
    config: Any = load(ROOT / "configs" / "preetham.toml")
    with pytest.raises(ValueError, match="frozen"):
        config.name = "other"


def test_schema_describes_every_key_of_its_sections() -> None:
    result = CliRunner().invoke(main, ["config", "schema"])
    assert result.exit_code == 0
    schema = json.loads(result.stdout)
    assert schema == Config.model_json_schema()
    for section, found in schema["$defs"].items():
        for key, described in found["properties"].items():
            assert described.get("description"), (section, key)
