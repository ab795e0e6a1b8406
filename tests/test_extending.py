"""Configs that extend others: what is taken over, what replaces it, and what is refused."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from conftest import ROOT, SMALL
from skylight_sh.config import ConfigError, load
from skylight_sh.run.provenance import settings
from test_cli import invoke


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    shutil.copy(SMALL, tmp_path / "small.toml")
    return tmp_path


def extend(folder: Path, text: str, name: str = "own.toml") -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def test_tables_merge_axes_by_name_and_lists_are_replaced(folder: Path) -> None:
    base = load(folder / "small.toml")
    text = """
extends = "small.toml"
name = "own"
[[axes]]
name = "turbidity"
range = [3.0, 6.0]
[truth]
random = 7
[report]
figures = []
"""
    own = load(extend(folder, text))
    assert (own.name, own.extends) == ("own", "small.toml")
    assert [axis.name for axis in own.axes] == ["sun_zenith", "turbidity"]
    assert own.axes[0] == base.axes[0]
    assert own.axes[1] == base.axes[1].model_copy(update={"range": (3.0, 6.0)})
    assert own.truth == base.truth.model_copy(update={"random": 7})
    assert own.report.figures == ()
    assert own.winners == base.winners
    # And once more on top.
    again = load(extend(folder, 'extends = "own.toml"\nname = "again"\n', "again.toml"))
    assert again.axes == own.axes


def test_what_is_taken_away(folder: Path) -> None:
    text = """
extends = "small.toml"
name = "own"
[fit]
references = []
[scene]
fixed = { turbidity = 3.0 }
[[winners]]
bands = 4
budgets = [0.01]
[[report.cases]]
title = "Low"
at = { sun_zenith = 1.5 }
"""
    own = load(extend(folder, text))
    assert own.fit.references == ()
    assert [axis.name for axis in own.axes] == ["sun_zenith"]
    # Another light takes none of the base's options.
    (folder / "smits.toml").write_text(
        (folder / "small.toml").read_text(encoding="utf-8").replace('"preetham"', '"preetham"\nconstants = "smits"'),
        encoding="utf-8",
    )
    other = 'extends = "smits.toml"\nname = "other"\n[light]\nmodel = "cie_general"\nsky = 3\n'
    with pytest.raises(ConfigError) as caught:
        load(extend(folder, other))
    assert "constants" not in str(caught.value)
    assert "turbidity" in str(caught.value)


def test_the_same_config_written_out_is_the_same(folder: Path) -> None:
    extended = load(extend(folder, 'extends = "small.toml"\nname = "small"\n'))
    assert settings(extended) == settings(load(folder / "small.toml"))


def test_what_is_wrong_is_told_of_the_whole(folder: Path) -> None:
    path = extend(folder, 'extends = "small.toml"\nname = "own"\n[truth]\nbands = 3\n')
    with pytest.raises(ConfigError, match=r"own\.toml has .* problem.*\n.*\$\.winners\[0\]\.bands = 4"):
        load(path)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('extends = "../small.toml"', r"extends = '\.\./small\.toml' leaves the config's folder"),
        ('extends = "below/small.toml"', "leaves the config's folder"),
        ('extends = "none.toml"', r"none\.toml cannot be read"),
        ('extends = "own.toml"', "in a circle"),
        ("extends = 3", r"\$\.extends = 3"),
    ],
)
def test_a_base_that_cannot_be_is_refused(folder: Path, text: str, message: str) -> None:
    below = folder / "below"
    below.mkdir()
    with pytest.raises(ConfigError, match=message):
        load(extend(below, f'{text}\nname = "own"\n'))


def test_a_config_that_extends_has_its_own_name(folder: Path) -> None:
    with pytest.raises(ConfigError, match="name is missing"):
        load(extend(folder, 'extends = "small.toml"\n'))


def test_a_broken_base_is_named(folder: Path) -> None:
    extend(folder, "[light", "broken.toml")
    code, _, err = invoke("config", "check", str(extend(folder, 'extends = "broken.toml"\nname = "own"\n')))
    assert code == 2
    assert "broken.toml is not valid TOML" in err


def test_a_shipped_config_is_extended_by_its_name_from_any_folder(tmp_path: Path) -> None:
    own = load(extend(tmp_path, 'extends = "preetham"\nname = "own"\n'))
    assert (own.name, own.extends) == ("own", "preetham")
    assert own.truth == load(ROOT / "configs" / "preetham.toml").truth
    # A file beside it of that name comes first.
    (tmp_path / "preetham").write_text(SMALL.read_text(encoding="utf-8"), encoding="utf-8")
    assert load(tmp_path / "own.toml").truth == load(SMALL).truth


def test_pictures_of_a_shipped_config_are_found_from_any_folder(tmp_path: Path) -> None:
    valley = load(extend(tmp_path, 'extends = "valley"\nname = "own"\n'))
    assert valley.file("clouds.png") == ROOT / "configs" / "clouds.png"
    (tmp_path / "clouds.png").write_bytes(b"")
    assert valley.file("clouds.png") == tmp_path / "clouds.png"
