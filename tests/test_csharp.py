"""C#: the exported class by Mono against the vectors that hold the C header, and what Unity reads of it."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from c_programs import FACTS
from conftest import ROOT, SMALL, run_quietly, with_spec
from skylight_sh import runtime, sphere
from skylight_sh.config import load
from skylight_sh.export import c_data, csharp, engines, vectors
from skylight_sh.runtime import Table
from skylight_sh.studies.stability.flavours import flavours
from test_shaders import MADE, made

PARTS = ROOT / "pipeline" / "skylight_sh" / "export" / "evaluators" / "csharp"
REFERENCE = ROOT / "reports" / "reference" / "export"
FLAVOURS = flavours()
TABLES = {
    **FLAVOURS,
    "fixed": with_spec(FLAVOURS["rows"], azimuth=0.7),
    "windowed": with_spec(FLAVOURS["rows"], windowed=True),
    "two-of-three": made(*MADE["classes-all-orders"]),
    "released": runtime.read(REFERENCE / "skylight_sh.npz"),
    "released-packed": runtime.read(REFERENCE / "7-bands-0.1pct-packed" / "skylight_sh.npz"),
}
# Holds every class against its vectors, cut to every number of bands too, and prints how many failed, the largest deviation,
# and how many bytes many calls allocate.
PROGRAM = """
using System;
using System.Globalization;
using System.IO;
public static class Program
{
    delegate int One(float[] inputs, int bands, float[] weights);
    static float Number(string word)
    {
        return word == "nan" ? float.NaN : word == "inf" ? float.PositiveInfinity : word == "-inf"
            ? float.NegativeInfinity : (float)double.Parse(word, CultureInfo.InvariantCulture);
    }
    static void Hold(string name, bool cut, One evaluate, int most)
    {
        var words = File.ReadAllText(name + ".txt").Split(new[] { ' ', '\\n' }, StringSplitOptions.RemoveEmptyEntries);
        Func<int, int> fact = k => int.Parse(words[2 * k + 1]);
        int count = fact(1), channels = fact(2), per = fact(3), vectors = fact(6), at = 14, failed = 0;
        float largest = Number(words[11]), furthest = 0;
        double bound = Number(words[9]);
        var inputs = new float[count];
        var got = new float[channels * per];
        for (int v = 0; v < vectors; ++v)
        {
            for (int i = 0; i < count; ++i) inputs[i] = Number(words[at++]);
            int status = int.Parse(words[at++]);
            bool bad = false;
            for (int bands = 0; bands <= (cut ? most : 0); ++bands)
            {
                bad |= evaluate(inputs, bands, got) != status;
                int used = bands == 0 ? per : bands * bands;
                for (int k = 0; k < got.Length; ++k)
                {
                    float off = Math.Abs(got[k] - (k % per < used ? Number(words[at + k]) : 0)) / largest;
                    bad |= !(off <= bound);
                    furthest = Math.Max(furthest, off);
                }
            }
            at += got.Length;
            if (bad) ++failed;
        }
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int k = 0; k < 1000; ++k) evaluate(inputs, 0, got);
        long calls = GC.GetAllocatedBytesForCurrentThread() - before;
        for (int k = 0; k < 1000; ++k) got = new float[got.Length];
        long control = GC.GetAllocatedBytesForCurrentThread() - before - calls;
        Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "{0} {1} {2} {3} {4} {5}", name, vectors, failed,
            furthest, calls, control));
    }
    public static void Main()
    {
CALLS
    }
}
"""


def write(table: Table, folder: Path, name: str) -> str:
    """Write a table's class into ``folder`` and return the class's name."""
    prefix = "t_" + name.replace("-", "_")
    (folder / f"{name}.cs").write_text(csharp.write(table, FACTS, prefix), encoding="utf-8")
    return csharp.class_name(prefix)


def run(folder: Path, program: str, *flags: str) -> str:
    """Compile a program with all classes in ``folder``, every warning an error, and run it."""
    (folder / "Program.cs").write_text(program, encoding="utf-8")
    files = sorted(path.name for path in folder.glob("*.cs"))
    command = ["mcs", "-langversion:7.2", "-warn:4", "-warnaserror", "-out:program.exe", *flags, *files]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    ran = subprocess.run(["mono", "program.exe"], cwd=folder, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    return ran.stdout


@pytest.mark.tools
def test_tools_are_there() -> None:
    assert [tool for tool in ("mcs", "mono") if not shutil.which(tool)] == [], "install what .ci/run installs"


@pytest.mark.tools
def test_mono_agrees_with_the_vectors(tmp_path: Path) -> None:
    calls = []
    for name, table in TABLES.items():
        made_class = write(table, tmp_path, name)
        (tmp_path / f"{name}.txt").write_text(vectors.write(table), encoding="utf-8")
        given = ", ".join(f"i[{k}]" for k in range(len(runtime.Runtime(table).inputs)))
        one = f"b == 0 ? {made_class}.Weights({given}, w) : {made_class}.WeightsBands({given}, b, w)"
        # Vectors are weights of all bands: a window would follow the cut.
        cut = "false" if table.spec.windowed or table.surroundings else "true"
        calls.append(f'Hold("{name}", {cut}, (i, b, w) => {one}, {made_class}.Bands);')
    lines = run(tmp_path, PROGRAM.replace("CALLS", "\n".join(calls))).splitlines()
    print("\n".join(lines))
    assert [line.split()[0] for line in lines] == list(TABLES)
    for line in lines:
        name, count, failed, furthest, allocated, control = line.split()
        assert int(count) > 100
        assert int(failed) == 0, line
        assert float(furthest) < vectors.BOUND
        assert (int(allocated), int(control) > 4000) == (0, True), line


@pytest.mark.tools
def test_mono_evaluates_many_suns_and_changes_weights(tmp_path: Path) -> None:
    table = FLAVOURS["classes-packed"]
    (tmp_path / "skylight_sh.cs").write_text(csharp.write(table, FACTS), encoding="utf-8")
    program = """
using System;
using System.Globalization;
public static class Program
{
    static void Show(float[] numbers)
    {
        var words = Array.ConvertAll(numbers, v => v.ToString("R", CultureInfo.InvariantCulture));
        Console.WriteLine(string.Join(" ", words));
    }
    public static void Main()
    {
        float[] zeniths = { 0.2f, 0.9f, 1.7f, float.NaN, 0.4f };
        float[] azimuths = { 0.1f, -2, 3, 0, 1 }, haze = { 3, 5, 2.5f, 3, 4 };
        int size = SkylightSh.ChannelCount * SkylightSh.WeightCount;
        var many = new float[5 * size];
        int worst = SkylightSh.WeightsBatch(zeniths, azimuths, haze, many);
        Show(many);
        var one = new float[size];
        SkylightSh.Weights(0.2f, 0.1f, 3, one);
        SkylightSh.Ground(new[] { 0.1f, 0.2f, 0.7f }, one);
        Show(one);
        SkylightSh.Window(3, one);
        Show(one);
        SkylightSh.Expose(0.5f, one);
        Show(one);
        Console.WriteLine("{0} {1} {2} {3}", worst, SkylightSh.WeightsBands(0.2f, 0.1f, 3, 0, one),
            SkylightSh.WeightsBands(0.2f, 0.1f, 3, 4, one), SkylightSh.TurbidityMin == 2.5f);
        try { SkylightSh.Weights(0.2f, 0.1f, 3, new float[size - 1]); }
        catch (ArgumentException error) { Console.WriteLine(error.ParamName); }
    }
}
"""
    *found, said, refused = run(tmp_path, program).splitlines()
    many, ground, window, half = (np.array(line.split(), dtype=float) for line in found)
    assert (said, refused) == ("2 1 0 True", "weights")
    suns = [[0.2, 0.9, 1.7, np.nan, 0.4], [0.1, -2.0, 3.0, 0.0, 1.0], [3.0, 5.0, 2.5, 3.0, 4.0]]
    expected = runtime.Runtime(table).weights(*suns).astype(float)
    near = 2e-6 * float(np.abs(expected).max())
    assert many.reshape(expected.shape) == pytest.approx(expected, abs=near)
    lit = np.stack([sphere.add_ground(w, albedo, 4) for w, albedo in zip(expected[0], (0.1, 0.2, 0.7), strict=True)])
    assert ground.reshape(3, 16) == pytest.approx(lit, abs=near)
    lit[:, :9] *= sphere.zonal_sinc(3)
    assert window.reshape(3, 16) == pytest.approx(lit, abs=near)
    assert half.reshape(3, 16) == pytest.approx(lit / 2, abs=near)


@pytest.mark.tools
def test_unity_reads_what_its_profile_says(tmp_path: Path) -> None:
    """Of a sky of three channels and of one, in all nine numbers of each."""
    calls, expected = [], []
    for name in ("classes", "one-axis"):
        table = FLAVOURS[name]
        made_class = write(table, tmp_path, name)
        inputs = (0.7, 2.1, 3.5)[: len(runtime.Runtime(table).inputs)]
        weights = runtime.Runtime(table).weights(*inputs, bands=3).astype(float)
        expected.append(engines.convert(weights, engines.PROFILES["unity"]).ravel())
        given = ", ".join(f"{value}f" for value in inputs)
        calls.append(f"""{{
            var w = new float[{made_class}.ChannelCount * {made_class}.WeightCount];
            var probe = new float[27];
            {made_class}.Weights({given}, w);
            {made_class}.Unity(w, probe);
            foreach (float v in probe) Console.Write(v.ToString("R", CultureInfo.InvariantCulture) + " ");
        }}""")
    body = "\n".join(calls)
    program = "using System; using System.Globalization;\n"
    got = run(tmp_path, f"{program}public static class Program {{ public static void Main() {{ {body} }} }}")
    for found, true in zip(np.array(got.split(), dtype=float).reshape(2, 27), expected, strict=True):
        assert found == pytest.approx(true, abs=2e-6 * float(np.abs(true).max()))
    assert "Unity(" not in csharp.write(FLAVOURS["irradiance"], FACTS)


@pytest.mark.tools
def test_the_evaluator_compiles_as_it_stands(tmp_path: Path) -> None:
    """Beside the table in ``example.cs`` its files are one class."""
    table = FLAVOURS["surrounded"]
    text = (PARTS / "example.cs").read_text(encoding="utf-8")
    assert text == csharp.example(table, FLAVOURS["twilight-packed"])
    for path in PARTS.glob("*.cs"):
        shutil.copy(path, tmp_path)
    program = """
using System;
public static partial class SkylightSh
{
    public static void Main()
    {
        var weights = new float[27];
        Console.WriteLine(Evaluate(new[] { 0.8f, 3f }, 0.3f, 3, weights) + " " + Unpacked.Rows.Length);
        Console.WriteLine(string.Join(" ", weights));
    }
}
"""
    names = ";".join(f"SKYLIGHT_SH_{name}" for name in sorted(c_data.features(table)))
    first, second = run(tmp_path, program, f"-define:{names}").splitlines()
    expected = runtime.Runtime(table).weights(0.8, 0.3, 3.0).ravel()
    assert first.split()[0] == "0"
    assert np.array(second.split(), dtype=float) == pytest.approx(expected, abs=2e-6 * float(np.abs(expected).max()))


def test_a_class_is_plain_text_of_readable_width() -> None:
    for table in TABLES.values():
        text = csharp.write(table, FACTS)
        assert max(map(len, text.splitlines())) <= 120
        assert not re.search(r"#if|#endif|partial|\t", text)
        assert csharp.write(table, FACTS) == text


def test_names_are_those_of_csharp_and_stay_apart() -> None:
    assert csharp.parameter("sun_zenith") == "sunZenith"
    assert csharp.parameter("fixed") == "@fixed"
    prefixes = ["a_b", "ab", "a_1", "a1", "a_1_0", "a_10", "a__b", "a_b_", "ab_"]
    assert len({csharp.class_name(prefix) for prefix in prefixes}) == len(prefixes)
    text = csharp.write(FLAVOURS["rows"], FACTS, "day_sh")
    assert "public static class DaySh\n" in text
    with pytest.raises(ValueError, match="Invalid prefix"):
        csharp.write(FLAVOURS["rows"], FACTS, "Day")


def test_a_run_writes_the_class(tmp_path: Path) -> None:
    asked = '[export]\ntargets = ["c", "npz", "csharp"]'
    text = SMALL.read_text(encoding="utf-8").replace("[export]", asked)
    (tmp_path / "asked.toml").write_text(text, encoding="utf-8")
    result = run_quietly(load(tmp_path / "asked.toml"), tmp_path)
    for row in result.summary["tables"]:
        assert "CC0-1.0" in (result.folder / row["path"] / "skylight_sh.cs").read_text(encoding="utf-8")
