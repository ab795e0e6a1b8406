"""The command line: every command explains itself, and evaluation prints what the runtime gives."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import click
import numpy as np
import pytest
from click.testing import CliRunner
from conftest import ROOT, SMALL
from skylight_sh import runtime
from skylight_sh.cli import main
from skylight_sh.run.runner import Result


def invoke(*arguments: str) -> tuple[int, str, str]:
    result = CliRunner().invoke(main, list(arguments))
    assert result.exception is None or isinstance(result.exception, SystemExit), result.exception
    return result.exit_code, result.stdout, result.stderr


def commands(group: click.Group, start: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], click.Command]]:
    context = click.Context(group)
    for name in group.list_commands(context):
        command = group.get_command(context, name)
        assert command is not None
        yield (*start, name), command
        if isinstance(command, click.Group):
            yield from commands(command, (*start, name))


def test_every_command_and_option_has_help() -> None:
    names = {" ".join(path) for path, _ in commands(main)}
    assert {"run", "configs", "init", "bench", "stability", "verify", "evaluate", "project", "export"} <= names
    assert {"config schema", "config check"} <= names
    assert {f"artifacts {verb}" for verb in ("ls", "show", "verify", "gc")} <= names
    for path, command in commands(main):
        assert command.help, path
        for option in command.params:
            if isinstance(option, click.Option) and option.name != "help":
                assert option.help, (path, option.name)
        assert invoke(*path, "--help")[0] == 0


def test_evaluate_prints_what_the_runtime_gives(small_run: Result) -> None:
    table = str(small_run.folder / "export" / "skylight_sh.npz")
    place = ("--sun-zenith", "0.8", "--turbidity", "3", "--sun-azimuth", "0.4")
    code, out, _ = invoke("evaluate", table, *place, "--json")
    assert code == 0
    expected = runtime.load(table).weights(0.8, 0.4, 3.0)
    assert np.array_equal(np.array(list(json.loads(out).values()), dtype=np.float32), expected)
    code, out, _ = invoke("evaluate", table, "--at", "sun_zenith=0.8", "--at", "turbidity=3", "--bands", "2", "--window")
    assert code == 0
    lines = out.splitlines()
    assert lines[0].split() == ["l", "m", "red", "green", "blue"]
    assert len(lines) == 5


def test_evaluate_takes_every_input_by_name(small_run: Result) -> None:
    table = str(small_run.folder / "export" / "skylight_sh.npz")
    place = ("--sun-zenith", "0.8", "--turbidity", "3", "--json")
    turned = invoke("evaluate", table, *place, "--at", "sun_azimuth=0.5")
    assert turned == invoke("evaluate", table, *place, "--sun-azimuth", "0.5")
    assert turned != invoke("evaluate", table, *place)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--sun-zenith", "1", "--at", "turbidity=3", "--at", "turbidity=4"), "turbidity is given twice"),
        (("--sun-zenith", "1", "--at", "turbidity=3", "--turbidity", "4"), "turbidity is given twice"),
        (("--sun-zenith", "1"), "--at turbidity=VALUE is missing"),
        (("--sun-zenith", "1", "--turbidity", "3", "--at", "albedo=1"), "albedo is no axis"),
        (("--at", "sun_zenith=1", "--at", "turbidity=dust"), "NAME=VALUE"),
        (("--sun-zenith", "nan", "--turbidity", "3"), "finite"),
        (("--sun-zenith", "1", "--turbidity", "3", "--bands", "9"), "1 to 4"),
        (("--sun-zenith", "east", "--turbidity", "3"), "east"),
    ],
)
def test_evaluate_refuses_bad_input(small_run: Result, arguments: tuple[str, ...], message: str) -> None:
    code, out, err = invoke("evaluate", str(small_run.folder / "export" / "skylight_sh.npz"), *arguments)
    assert code == 2
    assert out == ""
    assert message in err


def test_evaluate_warns_of_a_clamp(small_run: Result) -> None:
    code, _, err = invoke(
        "evaluate", str(small_run.folder / "export" / "skylight_sh.npz"), "--sun-zenith", "2", "--turbidity", "3"
    )
    assert code == 0
    assert "sun_zenith = 2 lies outside the table, sun_zenith [0, 1.5708], turbidity [2.5, 6], and was clamped" in err


def test_artifacts_commands(tmp_path: Path) -> None:
    store, reports = ("--store", str(tmp_path / "s")), ("--reports", str(tmp_path / "r"))
    code, out, err = invoke("run", str(SMALL), *store, *reports)
    assert code == 0
    assert err == ""  # quiet where there is no terminal
    assert str(tmp_path / "r" / "small" / "index.html") in out
    assert "recommended" in out

    code, listed, _ = invoke("artifacts", "ls", *store)
    assert code == 0
    keys = [line.split()[1] for line in listed.splitlines()]
    assert len(keys) == 10
    code, shown, _ = invoke("artifacts", "show", keys[-1], *store)
    assert code == 0
    assert "@provenance" in shown
    assert invoke("artifacts", "show", "zz", *store)[0] == 2
    assert invoke("artifacts", "verify", *store)[:2] == (0, "10 of 10 artifacts hold.\n")
    assert invoke("artifacts", "gc", *store)[1] == "freed 0 bytes\n"

    broken = next((tmp_path / "s" / "fit").glob("*.h5"))
    broken.write_bytes(broken.read_bytes()[:-200])
    code, out, err = invoke("artifacts", "verify", *store)
    assert code == 1
    assert out == "9 of 10 artifacts hold.\n"
    assert str(broken) in err
    assert invoke("artifacts", "show", broken.stem, *store)[0] == 1


def test_a_store_that_is_a_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way", encoding="utf-8")
    code, _, err = invoke("run", str(SMALL), "--store", str(tmp_path / "file"))
    assert code == 2
    assert "is a file" in err


def test_configs_lists_every_shipped_config_with_a_line() -> None:
    code, out, _ = invoke("configs")
    assert code == 0
    lines = dict(line.split(maxsplit=1) for line in out.splitlines())
    assert list(lines) == sorted(path.stem for path in (ROOT / "configs").glob("*.toml"))
    assert all(line.endswith(".") for line in lines.values())


def test_a_config_is_a_path_or_a_shipped_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "paper").mkdir()
    assert invoke("config", "check", "paper") == (0, "paper holds: run 'paper'.\n", "")
    # A file comes first.
    (tmp_path / "preetham").write_bytes(SMALL.read_bytes())
    assert invoke("config", "check", "preetham")[1] == "preetham holds: run 'small'.\n"
    code, _, err = invoke("run", "valley.toml")
    assert code == 2
    assert "'valley.toml' is neither a file nor the name of a shipped config. Did you mean 'valley'?" in err


def test_init_starts_a_config_and_overwrites_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert invoke("init", "My Sky.toml")[0] == 0
    assert invoke("config", "check", "My Sky.toml")[1] == "My Sky.toml holds: run 'my-sky'.\n"
    before = (tmp_path / "My Sky.toml").read_bytes()
    code, _, err = invoke("init", "My Sky.toml")
    assert code == 2
    assert "exists" in err
    assert (tmp_path / "My Sky.toml").read_bytes() == before
    assert invoke("init", "preetham")[0] == 2


def test_a_command_that_is_none_gets_the_nearest_one_told() -> None:
    code, _, err = invoke("evalute")
    assert code == 2
    assert "Did you mean 'evaluate'?" in err
