"""JavaScript: the exported module by Node against the vectors that hold the C header, and what it tells of itself."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
from c_programs import FACTS
from conftest import ROOT, SMALL, run_quietly, with_spec
from skylight_sh import runtime, sphere
from skylight_sh.config import load
from skylight_sh.export import c_data, javascript, javascript_types, statements, vectors
from skylight_sh.studies.stability.flavours import flavours
from test_shaders import MADE, made

PARTS = ROOT / "pipeline" / "skylight_sh" / "export" / "evaluators" / "javascript"
REFERENCE = ROOT / "reports" / "reference" / "export"
TYPESCRIPT = "typescript@5.9.3"
FLAVOURS = flavours()
TABLES = {
    **FLAVOURS,
    "fixed": with_spec(FLAVOURS["rows"], azimuth=0.7),
    "windowed": with_spec(FLAVOURS["rows"], windowed=True),
    "two-of-three": made(*MADE["classes-all-orders"]),
    "released": runtime.read(REFERENCE / "skylight_sh.npz"),
    "released-packed": runtime.read(REFERENCE / "7-bands-0.1pct-packed" / "skylight_sh.npz"),
}
# Holds a module against its vectors, cut to every number of bands too, and prints how many failed and the largest deviation.
PROGRAM = """
import { readFileSync } from "node:fs";
import * as sky from "./skylight_sh.mjs";
const words = readFileSync("vectors.txt", "utf8").split(/\\s+/);
const about = {};
for (let k = 0; k < 14; k += 2) about[words[k]] = Number(words[k + 1]);
const number = (word) => ({ nan: NaN, inf: Infinity, "-inf": -Infinity })[word] ?? Math.fround(Number(word));
let at = 14, failed = 0, furthest = 0;
for (let v = 0; v < about.vectors; ++v) {
  const read = (count) => { const part = words.slice(at, at + count).map(number); at += count; return part; };
  const inputs = read(about.inputs), [status] = read(1), expected = read(about.channels * about.weights);
  let bad = sky.status(...inputs) !== status;
  for (let bands = 0; bands <= sky.BANDS; ++bands) {
    const got = bands ? sky.weightsBands(...inputs, bands) : sky.weights(...inputs);
    const used = (bands || sky.BANDS) ** 2;
    got.forEach((value, k) => {
      const wanted = k % about.weights < used ? expected[k] : 0;
      const off = Math.abs(value - wanted) / about.largest;
      bad ||= !(off <= about.bound);
      furthest = Math.max(furthest, off);
    });
  }
  if (bad) ++failed;
}
console.log(JSON.stringify({ count: about.vectors, failed, furthest, names: Object.keys(sky).sort() }));
"""


def node(folder: Path, program: str) -> str:
    (folder / "program.mjs").write_text(program, encoding="utf-8")
    done = subprocess.run(["node", "program.mjs"], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.tools
@pytest.mark.parametrize("name", TABLES)
def test_node_agrees_with_the_vectors(tmp_path: Path, name: str) -> None:
    table = TABLES[name]
    # Vectors are weights of all bands: a window would follow the cut.
    program = PROGRAM.replace("bands <= sky.BANDS", "bands <= 0") if table.spec.windowed or table.surroundings else PROGRAM
    (tmp_path / "skylight_sh.mjs").write_text(javascript.write(table, FACTS), encoding="utf-8")
    (tmp_path / "vectors.txt").write_text(vectors.write(table), encoding="utf-8")
    found = json.loads(node(tmp_path, program))
    assert found["failed"] == 0, found
    assert found["furthest"] < vectors.BOUND
    assert found["count"] > 100
    constants = {"AXES", "BANDS", "CHANNELS", "CLAMPED", "INVALID", "OK", "UNIT", "WEIGHTS"}
    functions = {"status", "weights", "weightsBands", "weightsBatch", "applyExposure"}
    functions |= {"unpack"} if table.body.kind == "packed" else set()
    functions |= set() if table.spec.windowed else {"applyWindow"}
    functions |= {"applyGround"} if "TAKES_GROUND" in c_data.features(table) else set()
    assert set(found["names"]) == constants | functions


@pytest.mark.tools
@pytest.mark.parametrize("name", ["surrounded", "windowed"])
def test_node_cuts_bands_as_the_runtime_does(tmp_path: Path, name: str) -> None:
    table = TABLES[name]
    (tmp_path / "skylight_sh.mjs").write_text(javascript.write(table, FACTS), encoding="utf-8")
    text = 'import * as sky from "./skylight_sh.mjs";\nconsole.log([...sky.weightsBands(0.8, 0.3, 3.0, 2)].join(" "));\n'
    got = np.array(node(tmp_path, text).split(), dtype=float).reshape(len(table.channels), -1)
    expected = runtime.Runtime(table).weights(0.8, 0.3, 3.0, bands=2)
    assert np.abs(got[:, :4] - expected).max() < 2e-6 * np.abs(expected).max()
    assert not got[:, 4:].any()


@pytest.mark.tools
def test_node_windows_and_fills(tmp_path: Path) -> None:
    table = FLAVOURS["rows"]
    (tmp_path / "skylight_sh.mjs").write_text(javascript.write(table, FACTS), encoding="utf-8")
    text = """import * as sky from "./skylight_sh.mjs";
const own = new Float32Array(sky.CHANNELS.length * sky.WEIGHTS);
if (sky.weights(0.8, 0.3, 3.0, own) !== own) throw new Error("another array");
console.log([...sky.applyWindow(own)].join(" "));
console.log(JSON.stringify([sky.AXES, sky.UNIT, sky.status(9, 0, 3), sky.status(1, Infinity, 3)]));
"""
    first, second = node(tmp_path, text).splitlines()
    expected = runtime.Runtime(table).weights(0.8, 0.3, 3.0) * sphere.zonal_sinc(7)
    assert np.array(first.split(), dtype=float) == pytest.approx(expected.ravel(), abs=2e-6 * np.abs(expected).max())
    axes, unit, *status = json.loads(second)
    assert [axis["name"] for axis in axes] == ["sun_zenith", "turbidity"]
    assert (axes[1]["min"], axes[1]["max"], unit, status) == (2.5, 6.0, "cd/m2", [1, 2])


@pytest.mark.tools
def test_node_evaluates_many_suns_and_adds_a_ground(tmp_path: Path) -> None:
    table = FLAVOURS["classes-packed"]
    (tmp_path / "skylight_sh.mjs").write_text(javascript.write(table, FACTS), encoding="utf-8")
    text = """import * as sky from "./skylight_sh.mjs";
sky.unpack();
const suns = [[0.2, 0.9, 1.7, NaN, 0.4], [0.1, -2.0, 3.0, 0, 1.0], [3.0, 5.0, 2.5, 3.0, 4.0]];
const many = sky.weightsBatch(...suns), ground = sky.weights(0.2, 0.1, 3.0, new Float64Array(48));
const bright = sky.applyExposure(new Float64Array(ground), 0.5);
for (const found of [many, sky.applyGround(ground, [0.1, 0.2, 0.7]), bright]) console.log([...found].join(" "));
"""
    many, ground, bright = (np.array(line.split(), dtype=float) for line in node(tmp_path, text).splitlines())
    suns = [[0.2, 0.9, 1.7, np.nan, 0.4], [0.1, -2.0, 3.0, 0.0, 1.0], [3.0, 5.0, 2.5, 3.0, 4.0]]
    expected = runtime.Runtime(table).weights(*suns).astype(float)
    assert many.reshape(expected.shape) == pytest.approx(expected, abs=2e-6 * np.abs(expected).max())
    lit = np.stack([sphere.add_ground(w, albedo, 4) for w, albedo in zip(expected[0], (0.1, 0.2, 0.7), strict=True)])
    assert ground.reshape(3, 16) == pytest.approx(lit, abs=2e-6 * np.abs(expected).max())
    assert bright.reshape(3, 16) == pytest.approx(expected[0] / 2, abs=2e-6 * np.abs(expected).max())


USE = """
import * as sky from "./skylight_sh.mjs";
const made: Float32Array = sky.weights({one});
const filled: Float64Array = sky.weightsBands({one}, 2, new Float64Array(sky.WEIGHTS));
const many: Float32Array = sky.weightsBatch({many});
const channel: {channel} = sky.CHANNELS[0];
const said: 0 | 1 | 2 = sky.status({one});
const low: number = sky.AXES[0].min + sky.applyExposure(made, 0.5)[0];
// @ts-expect-error: not an array
sky.weightsBatch({one});
// @ts-expect-error: one too many
sky.status({one}, 3);
// @ts-expect-error: no more bands than there are
const bands: 99 = sky.BANDS;
// @ts-expect-error: a list of other numbers has no room for fractions
sky.weights({one}, new Int32Array(9));
// @ts-expect-error: nobody sets these
sky.AXES[0].min = 3;
console.log(filled, many, channel, said, low, bands);
{more}
"""


@pytest.mark.tools
def test_typescript_takes_the_types(tmp_path: Path) -> None:
    """Of every kind of table, and they name just what the module exports."""
    install = ["npm", "install", "--prefix", str(tmp_path), "--ignore-scripts", "--no-audit", "--no-fund", "--silent"]
    subprocess.run([*install, TYPESCRIPT], check=True)
    uses = []
    for name, table in TABLES.items():
        folder = tmp_path / name
        folder.mkdir()
        (folder / "skylight_sh.mjs").write_text(javascript.write(table, FACTS), encoding="utf-8")
        types = javascript_types.write(table, FACTS.title)
        (folder / "skylight_sh.d.mts").write_text(types, encoding="utf-8")
        count = len(statements.inputs_of(table))
        more = [] if table.spec.windowed else ["sky.applyWindow(made, 2);"]
        more += ["sky.applyGround(made, [0.1, 0.2]);"] if "TAKES_GROUND" in c_data.features(table) else []
        more += ["sky.unpack();"] if table.body.kind == "packed" else []
        known = {"one": ", ".join(["0.5"] * count), "many": ", ".join(["[0.5]"] * count), "more": "\n".join(more)}
        use = USE.format(**known, channel=json.dumps(table.channels[0]))
        (folder / "use.mts").write_text(use, encoding="utf-8")
        uses.append(f"{name}/use.mts")
        text = 'import * as sky from "./skylight_sh.mjs";\nconsole.log(JSON.stringify(Object.keys(sky)));\n'
        values = set(re.findall(r"^export declare (?:const|function) (\w+)", types, re.MULTILINE))
        assert values == set(json.loads(node(folder, text)))
    flags = ["--noEmit", "--strict", "--target", "es2022", "--module", "nodenext"]
    command = ["node_modules/.bin/tsc", *flags, *uses]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.tools
def test_the_evaluator_runs_as_it_stands(tmp_path: Path) -> None:
    """Beside the table in ``example.mjs`` its parts are a module without an export."""
    assert (PARTS / "example.mjs").read_text(encoding="utf-8") == javascript.example(
        FLAVOURS["surrounded"], FLAVOURS["twilight-packed"]
    )
    text = f"""import {{ evaluateTable }} from "{PARTS / "evaluate.mjs"}";
import "{PARTS / "packed.mjs"}";
const out = new Float32Array(27);
console.log(evaluateTable([0.8, 3], 0.3, 3, out), [...out].join(" "));
"""
    status, *numbers = map(float, node(tmp_path, text).split())
    expected = runtime.Runtime(FLAVOURS["surrounded"]).weights(0.8, 0.3, 3.0)
    assert status == 0
    assert numbers == pytest.approx(expected.ravel().tolist(), abs=2e-6 * float(np.abs(expected).max()))


def test_a_module_is_plain_text_of_readable_width() -> None:
    for table in TABLES.values():
        text = javascript.write(table, FACTS)
        assert max(map(len, text.splitlines())) <= 120
        assert max(map(len, javascript_types.write(table, FACTS.title).splitlines())) <= 120
        assert not re.search(r"^import |example\.mjs", text, re.MULTILINE)
        assert javascript.write(table, FACTS) == text


def test_a_run_writes_the_module(tmp_path: Path) -> None:
    asked = '[export]\ntargets = ["c", "npz", "javascript"]'
    text = SMALL.read_text(encoding="utf-8").replace("[export]", asked)
    (tmp_path / "asked.toml").write_text(text, encoding="utf-8")
    result = run_quietly(load(tmp_path / "asked.toml"), tmp_path)
    for row in result.summary["tables"]:
        for file in ("skylight_sh.mjs", "skylight_sh.d.mts"):
            assert "CC0-1.0" in (result.folder / row["path"] / file).read_text(encoding="utf-8")
