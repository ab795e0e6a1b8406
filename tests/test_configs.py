"""Every shipped config, run through the whole pipeline at a size that lets all of them run: what it ships must work."""

from __future__ import annotations

import csv
import math
import re
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import ROOT, run_quietly
from numpy.typing import NDArray
from skylight_sh import runtime
from skylight_sh.config import Config, parse
from skylight_sh.config.extending import read
from skylight_sh.config.wanted import table_names
from skylight_sh.fit.axis import Axis
from skylight_sh.formula.printers import C_DOUBLE, statements
from skylight_sh.light.perez import Perez
from skylight_sh.light.preetham import Preetham
from skylight_sh.light.protocol import Light
from skylight_sh.table.prefactor import closed_form

CONFIGS = sorted((ROOT / "configs").glob("*.toml"))
DEFAULT = read(ROOT / "configs" / "preetham.toml")["report"]["figures"]
# Of a reduced run at most: bands, each axis's degree (the last one's is every further axis's); and the error allowed.
BANDS, DEGREES, BUDGET = 4, (9, 6, 1), 0.4
PROGRAM = """
#include <stdio.h>
#include "skylight_sh.h"
int main(void)
{{
    static float w[{large}_CHANNELS][{large}_WEIGHTS];
    const int status = {prefix}_weights({arguments}, w);
    fwrite(w, sizeof w, 1, stdout);
    return status;
}}
"""


def reduced(path: Path) -> dict[str, Any]:
    """The config at ``path``, smaller in every number that costs time, and the same in all that makes it what it is."""
    raw = read(path)
    raw.pop("extends", None)
    for i, axis in enumerate(raw["axes"]):
        most = DEGREES[min(i, len(DEGREES) - 1)]
        least, largest = (min(degree, most) for degree in axis["degrees"])
        axis["degrees"] = [least if axis["degrees"][0] == axis["degrees"][1] else least // 2, largest]
        axis["nodes"] = min(axis["nodes"], largest + 3)
        axis["verification"] = min(axis["verification"], 4 * largest + 3)
    truth = raw["truth"]
    # Different numbers of bands stay different.
    used = sorted({truth["bands"], *(winner["bands"] for winner in raw["winners"])}, reverse=True)
    bands = {count: min(count, max(BANDS - i, 1)) for i, count in enumerate(used)}
    truth["bands"] = bands[truth["bands"]]
    truth["random"] = min(truth.get("random", 500), 20)
    truth["tolerance"] = max(truth.get("tolerance", 0.0), 1e-7 if truth.get("hints", True) else 1e-3)
    largest = [axis["degrees"][1] for axis in raw["axes"]]
    for table in (*raw["winners"], *raw.get("fit", {}).get("references", ())):
        if "degrees" in table:
            table["degrees"] = [min(pair) for pair in zip(table["degrees"], largest, strict=True)]
    for winner in raw["winners"]:
        winner["bands"] = bands[winner["bands"]]
        if "budgets" in winner:
            winner["budgets"] = [BUDGET]
    # A picture that the default does not draw is worth more than one that it does.
    drawn = raw.setdefault("report", {}).get("figures", DEFAULT)
    raw["report"]["figures"] = [next((picture for picture in drawn if picture not in DEFAULT), drawn[0])]
    if "mesh" in raw.get("scene", {}):
        raw["scene"]["mesh"] |= {"rays": 16, "gather_rays": 16, "bounces": 1}
    # Views may ask for tables of other names.
    raw["views"] = [{key: value for key, value in view.items() if key != "table"} for view in raw.get("views", ())]
    raw["export"]["recommended"] = recommended(raw["winners"][0], raw["export"]["recommended"].endswith("-packed"))
    return raw


def recommended(winner: dict[str, Any], packed: bool) -> str:
    """The name of a winner's first table of a layout."""
    about = "-".join(["degrees", *map(str, winner["degrees"])]) if "degrees" in winner else f"{100 * BUDGET:g}pct"
    dtype = [winner["dtype"]] if winner.get("dtype", "float32") != "float32" else []
    return "-".join([f"{winner['bands']}-bands", about, *dtype, *(["packed"] if packed else [])])


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One store and one folder of reports for all configs: some share their truth."""
    return tmp_path_factory.mktemp("configs")


@pytest.mark.parametrize("path", CONFIGS, ids=lambda path: path.stem)
def test_a_shipped_config_runs(path: Path, place: Path) -> None:
    config = parse(reduced(path), str(path), path.parent)
    result = run_quietly(config, place)
    files_of_the_contract(result.folder, config)
    rows = result.summary["tables"]
    assert result.summary["config"]["name"] == config.name == path.stem
    assert [row["name"] for row in rows] == table_names(config)
    for row in rows:
        assert 0 <= row["e_mean"] < math.inf
        assert 0 <= row["e_max"] < math.inf
        if row["name"].split("-bands-")[1].startswith(f"{100 * BUDGET:g}pct"):
            assert row["e_mean"] <= BUDGET
    for row in rows:
        header_agrees(result.folder / row["path"], row["prefix"])


def files_of_the_contract(folder: Path, config: Config) -> None:
    """What design and README promise of every run: the page, its pictures, figures in numbers, tables and the record."""
    picture = config.report.figures[0]
    expected = ["index.html", "errors.csv", "summary.json", "run.json", f"figures/{picture}.png"]
    for name in table_names(config):
        table = "export" if name == config.export.recommended else f"export/{name}"
        expected += [f"{table}/skylight_sh.h", f"{table}/skylight_sh.npz"]
        expected += [f"{table}/skylight_sh_vectors.txt"] if "vectors" in config.export.targets else []
    expected += ["ringing.csv"] if picture == "gibbs" else []
    for name in expected:
        assert (folder / name).stat().st_size > 0, name
    page = (folder / "index.html").read_text(encoding="utf-8")
    assert f"figures/{picture}.png" in page
    assert not re.search(r"\bnan\b|\binf\b", re.sub(r"<pre>.*?</pre>", "", page, flags=re.DOTALL))
    with (folder / "errors.csv").open(encoding="utf-8", newline="") as file:
        errors = list(csv.DictReader(file))
    assert errors
    assert all(0 <= float(row[key]) < math.inf for row in errors for key in ("e_max", "e_mean", "rel_l2"))


def header_agrees(folder: Path, prefix: str) -> None:
    """A table's header, compiled strictly as C99, gives the runtime's weights at one set, to 2e-6 of the largest."""
    loaded = runtime.load(folder / "skylight_sh.npz")
    named = {axis.name: 0.4 * axis.low + 0.6 * axis.high for axis in loaded.table.axes} | {"sun_azimuth": 2.0}
    inputs = np.array([named[name] for name in loaded.inputs], dtype=np.float32)
    expected = loaded.weights(*inputs)
    assert expected.shape == (len(loaded.table.channels), loaded.table.bands**2)
    large, arguments = prefix.upper(), ", ".join(f"{value:.9e}f" for value in inputs)
    program = PROGRAM.format(large=large, prefix=prefix, arguments=arguments)
    flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-x", "c", "-", "-o", "one", "-lm"]
    subprocess.run(["cc", *flags], input=program.encode(), cwd=folder, check=True)
    out = subprocess.run([str(folder / "one")], capture_output=True, check=True).stdout
    got: NDArray[np.float32] = np.frombuffer(out, dtype=np.float32).reshape(expected.shape)
    assert np.abs(got - expected).max() < 2e-6 * np.abs(expected).max()


@pytest.mark.parametrize(("light", "count"), [(Preetham(), 20), (Perez(category=5), 1)], ids=["preetham", "perez"])
def test_a_prefactor_counts_the_numbers_in_its_code(light: Light, count: int) -> None:
    """Every different number written into the formula's text, constants left out: a table's bytes count them."""
    hint = light.hints.prefactor
    assert hint is not None
    axes = [Axis(name, domain.low, domain.high).specified for name, domain in light.domains.items() if name in hint.axes]
    program = closed_form(hint, axes).program
    assert len(program.literals) == count
    # Constants printed as names, so that every digit in the text is a literal's.
    names = replace(program, constants=tuple(float(7000 + i) for i in range(len(program.constants))))
    lines, results = statements(names, C_DOUBLE, [f"x{i}" for i in range(len(axes))])
    text = re.sub(r"\b7\d\d\d\.0\b", "k", "\n".join([*lines, *results]))
    assert len(set(re.findall(r"(?<![\w.])(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?\b", text))) == count
