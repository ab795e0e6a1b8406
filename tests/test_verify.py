"""The command that runs a released result again: same, or differs by how much in what."""

from __future__ import annotations

import io
import shutil
from dataclasses import replace
from hashlib import sha256
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from conftest import SMALL
from skylight_sh import runtime
from skylight_sh.cli import main
from skylight_sh.config import load
from skylight_sh.run.provenance import whole_settings
from skylight_sh.run.runner import Result
from skylight_sh.run.verify import differences, released_config
from skylight_sh.runtime import ClassRows
from skylight_sh.table import npz


@pytest.fixture
def released(small_run: Result, tmp_path: Path) -> Path:
    """A copy of a result that a test may spoil."""
    return Path(shutil.copytree(small_run.folder, tmp_path / "released"))


def run(folder: Path, small_run: Result) -> tuple[int, str]:
    store = small_run.folder.parents[1] / "artifacts"
    done = CliRunner().invoke(main, ["verify", str(folder), "--store", str(store)])
    return done.exit_code, done.output


def resum(folder: Path, path: str) -> None:
    """Say in SHA256SUMS what the file now is: as if another machine had released it."""
    lines = (folder / "SHA256SUMS").read_text(encoding="utf-8").splitlines()
    fresh = f"{sha256((folder / path).read_bytes()).hexdigest()}  {path}"
    (folder / "SHA256SUMS").write_text("".join(f"{fresh if line.endswith(path) else line}\n" for line in lines))


def test_the_same_bytes_are_told_file_by_file(released: Path, small_run: Result) -> None:
    code, text = run(released, small_run)
    count = len((released / "SHA256SUMS").read_text(encoding="utf-8").splitlines())
    assert code == 0
    assert text.count("same     ") == count
    assert f"{count} of {count} files are the same bytes." in text
    # Nothing but run.json, the page, its pictures and the machine's own figures lies outside of the sums.
    summed = {line.split("  ")[1] for line in (released / "SHA256SUMS").read_text(encoding="utf-8").splitlines()}
    others = {p.relative_to(released).as_posix() for p in released.rglob("*") if p.is_file()} - summed
    assert others == {"SHA256SUMS", "index.html", "run.json", "references.csv", "figures/bands.png"}


def test_a_figure_that_another_machine_released_is_told_as_a_number(released: Path, small_run: Result) -> None:
    path = released / "errors.csv"
    lines = path.read_text(encoding="utf-8").splitlines()
    cells = lines[7].split(",")
    column = lines[0].split(",").index("e_max")
    before = float(cells[column])
    cells[column] = f"{1.25 * before:.4g}"
    path.write_text("\n".join([*lines[:7], ",".join(cells), *lines[8:], ""]), encoding="utf-8")
    resum(released, "errors.csv")
    code, text = run(released, small_run)
    assert code == 1
    told = next(line for line in text.splitlines() if line.startswith("DIFFERS"))
    assert "errors.csv: differs in 1 numbers of 1 lines, the first at line 8" in told
    assert f"to {before:.6g}, at most 0.2 of a number" in told


def test_a_spoilt_release_is_told(released: Path, small_run: Result) -> None:
    header = released / "export" / "skylight_sh.h"
    header.write_text(header.read_text(encoding="utf-8").replace("float", "double", 1), encoding="utf-8")
    (released / "export" / "4-bands-5pct" / "skylight_sh.npz").unlink()
    code, text = run(released, small_run)
    assert code == 1
    assert "DIFFERS  export/skylight_sh.h: the released file is not the one of its sum" in text
    # What is gone is computed the same, so that its sum holds.
    assert "same     export/4-bands-5pct/skylight_sh.npz" in text


@pytest.mark.parametrize(
    ("spoil", "told"),
    [
        (lambda folder: (folder / "SHA256SUMS").unlink(), "holds no SHA256SUMS"),
        (lambda folder: (folder / "SHA256SUMS").write_text("no sum\n"), "a line that is no SHA-256"),
        (lambda folder: (folder / "summary.json").unlink(), "holds no released result"),
        (lambda folder: (folder / "summary.json").write_text("{}"), "holds no released result"),
        (lambda folder: (folder / "summary.json").write_text('{"config": {"name": "x"}}'), "This key is required"),
    ],
)
def test_what_is_no_release_is_bad_input(released: Path, small_run: Result, spoil: object, told: str) -> None:
    assert callable(spoil)
    spoil(released)
    code, text = run(released, small_run)
    assert code == 2
    assert told in text


def test_a_release_tells_its_config(released: Path) -> None:
    assert whole_settings(released_config(released)) == whole_settings(load(SMALL))


def test_arrays_are_compared_as_numbers(small_run: Result) -> None:
    data = (small_run.folder / "export" / "skylight_sh.npz").read_bytes()
    table = runtime.read(io.BytesIO(data))
    assert isinstance(table.body, ClassRows)
    rows = table.body.rows.copy()
    rows[2, 3] = np.float32(1.5) * rows[2, 3]
    changed = npz.write(replace(table, body=replace(table.body, rows=rows)))
    told = differences(data, changed)
    assert told.startswith(f"differs: rows: 1 of {rows.size} numbers, largest change")
    assert told.endswith("at most 0.33 of a number")
    assert differences(b"one 1\n", b"two 1\n") == "differs in words: line 1 was 'one 1', now 'two 1'"
    assert differences(b"a\nb\n", b"a\n") == "differs in length: 2 lines, now 1"
    assert differences(b"\xff\x00", b"\xff\x01") == "differs in content (2 bytes, now 2)"
