"""The README's quick starts in other languages, taken out of it, compiled and run against the table itself."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread

import numpy as np
import pytest
import shader_tools
from browser import browser
from conftest import ROOT
from numpy.typing import NDArray
from skylight_sh import runtime, sphere
from skylight_sh.export import transfer_shader
from test_cli import invoke
from test_readme import README, REFERENCE, code
from test_shader_values import TYPES
from test_shader_values import run as run_as_cpp

Array = NDArray[np.float64]

TABLE = REFERENCE / "export" / "skylight_sh.npz"
SUN = (1.1, 2.3, 3.5)
# What TYPES leaves out of GLSL.
MAX = "static vec3 max(vec3 a, vec3 b) { return vec3(max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)); }"
HTML = ROOT / "examples" / "three.html"


def weights() -> Array:
    """The first three bands of one sky, (3, 9)."""
    return np.asarray(runtime.load(TABLE).weights(*SUN)[:, :9], dtype=np.float64)


def normals() -> Array:
    found = np.random.default_rng(1).normal(size=(40, 3))
    return np.asarray(found / np.linalg.norm(found, axis=1, keepdims=True))


def lit(directions: Array) -> Array:
    """Irradiance / pi, (n, 3): the clamped cosine's degrees times the weights, no less than 0."""
    cosine = sphere.clamped_cosine(3)[[0, 1, 1, 1, 2, 2, 2, 2, 2]] / np.pi
    return np.maximum(sphere.basis(directions, 3) @ (cosine * weights()).T, 0.0)


def evaluated(form: str) -> object:
    place = ["--sun-zenith", str(SUN[0]), "--sun-azimuth", str(SUN[1]), "--turbidity", str(SUN[2])]
    done, out, _ = invoke("evaluate", str(TABLE), *place, "--format", form)
    assert done == 0
    return json.loads(out)


def shaded(function: str, sky: Array, directions: Array, folder: Path) -> Array:
    """What the README's function ``skylight`` returns, compiled as C++; ``sky`` (9, 3)."""
    listed = ", ".join(f"vec3({', '.join(map(repr, row))})" for row in sky.tolist())
    given = ", ".join(f"vec3({', '.join(map(repr, row))})" for row in directions.tolist())
    source = f"""{TYPES}{MAX}
    static const vec3 sky[9] = {{{listed}}};
    {function.replace("vec3(0.0)", "vec3(0.0, 0.0, 0.0)")}
    int main() {{
        const vec3 given[] = {{{given}}};
        for (const vec3& n : given) {{ const vec3 v = skylight(n); printf("%.9g %.9g %.9g\\n", v.x, v.y, v.z); }}
    }}"""
    return np.array([[float(v) for v in line.split()] for line in run_as_cpp(source, folder).decode().splitlines()])


def function_of(shader: str) -> str:
    found = re.search(r"^vec3 skylight\(vec3 n\).*?^}", shader, re.DOTALL | re.MULTILINE)
    assert found
    return found[0]


def test_nine_weights_light_a_surface_in_a_shader(tmp_path: Path) -> None:
    found = shaded(function_of(code("glsl", "sky[9]")), weights().T, normals(), tmp_path)
    assert found == pytest.approx(lit(normals()), abs=1e-5 * lit(normals()).max())


def test_godots_shader_lights_what_evaluate_prints(tmp_path: Path) -> None:
    sky = np.array(evaluated("godot"))
    east, north, up = normals().T
    found = shaded(function_of(code("gdshader", "sky[9]")), sky, np.stack([east, up, -north], axis=1), tmp_path)
    assert found == pytest.approx(lit(normals()), abs=1e-5 * lit(normals()).max())


def test_unreals_function_fills_what_evaluate_prints(tmp_path: Path) -> None:
    """With a stand-in for Unreal's type, whose members have these names."""
    stand_in = "struct FSHVector3 { float V[12]; };\nstruct FSHVectorRGB3 { FSHVector3 R, G, B; };\n"
    program = f"""#include <cstdio>
    #include <initializer_list>
    {stand_in}{code("cpp", "FSHVectorRGB3")}
    int main() {{
        const FSHVectorRGB3 s = Skylight({", ".join(f"{value}f" for value in SUN)}, 1.0f);
        for (const FSHVector3* c : {{&s.R, &s.G, &s.B}}) for (int k = 0; k < 9; ++k) printf("%.9g\\n", c->V[k]);
    }}"""
    (tmp_path / "unreal.cpp").write_text(program, encoding="utf-8")
    flags = ["-std=c++17", "-Wall", "-Wextra", "-Werror", "-I", str(REFERENCE / "export")]
    subprocess.run(["c++", *flags, str(tmp_path / "unreal.cpp"), "-o", str(tmp_path / "unreal")], check=True)
    done = subprocess.run([str(tmp_path / "unreal")], capture_output=True, text=True, check=True)
    printed = evaluated("unreal")
    assert isinstance(printed, dict)
    expected = np.concatenate([printed[channel] for channel in "RGB"])
    assert np.array(done.stdout.split(), dtype=float) == pytest.approx(expected, abs=1e-5 * np.abs(expected).max())


def test_shaders_of_the_quick_starts_are_no_others() -> None:
    """One each of what is tested here and in test_readme: a new one needs a test."""
    languages = re.findall(r"^```(\w+)$", README.split("## Quick starts")[1].split("## Limits")[0], re.MULTILINE)
    tested = {"c": 1, "glsl": 2, "csharp": 1, "cpp": 1, "gdshader": 1, "python": 1}
    assert {name: languages.count(name) for name in set(languages) - {"sh", "text"}} == tested


@pytest.mark.tools
def test_glslang_takes_the_shaders(tmp_path: Path) -> None:
    version = "#version 300 es\n"
    whole = code("glsl", "skylight_sh_transfer")
    made = whole.replace("// yard_shader.glsl goes here", transfer_shader.write("glsl", 20))
    assert made != whole
    shader_tools.glslang(made, tmp_path / "transfer.vert", "-S", "vert")
    plain = (
        code("glsl", "sky[9]") + "in vec3 normal;\nout vec4 colour;\nvoid main() { colour = vec4(skylight(normal), 1.0); }\n"
    )
    shader_tools.glslang(f"{version}precision highp float;\n{plain}", tmp_path / "plain.frag", "-S", "frag")
    godot = re.sub(r"^(shader_type|render_mode) .*$", "", code("gdshader", "sky[9]"), flags=re.MULTILINE)
    around = "in vec3 NORMAL;\nuniform mat4 INV_VIEW_MATRIX;\nvec3 ALBEDO;\nout vec3 EMISSION;\n"
    godot = godot.replace(" : source_color = vec3(0.8)", "") + "void main() { fragment(); }\n"
    shader_tools.glslang(f"{version}precision highp float;\n{around}{godot}", tmp_path / "godot.frag", "-S", "frag")


UNITY = """
namespace UnityEngine
{
    public class MonoBehaviour { }
    public struct Vector3
    {
        public float x, y, z;
        public Vector3(float a, float b, float c) { x = a; y = b; z = c; }
        public static Vector3 operator -(Vector3 a) { return new Vector3(-a.x, -a.y, -a.z); }
    }
    public class Transform { public Vector3 forward; }
    public class Light { public Transform transform = new Transform(); }
    public static class Mathf
    {
        public static float Acos(float a) { return (float)System.Math.Acos(a); }
        public static float Atan2(float a, float b) { return (float)System.Math.Atan2(a, b); }
    }
    public static class RenderSettings
    {
        public static Rendering.AmbientMode ambientMode;
        public static Rendering.SphericalHarmonicsL2 ambientProbe;
    }
}
namespace UnityEngine.Rendering
{
    public enum AmbientMode { Skybox, Custom }
    public struct SphericalHarmonicsL2
    {
        float[] held;
        public float this[int channel, int k]
        {
            get { return held[9 * channel + k]; }
            set { if (held == null) held = new float[27]; held[9 * channel + k] = value; }
        }
    }
}
public static class Program
{
    public static void Main()
    {
        var sky = new Skylight { sun = new UnityEngine.Light(), turbidity = TURBIDITY, exposure = 1f };
        sky.sun.transform.forward = new UnityEngine.Vector3(FORWARD);
        typeof(Skylight).GetMethod("Update", (System.Reflection.BindingFlags)36).Invoke(sky, null);
        if (UnityEngine.RenderSettings.ambientMode != UnityEngine.Rendering.AmbientMode.Custom) throw new System.Exception();
        var probe = UnityEngine.RenderSettings.ambientProbe;
        var plain = System.Globalization.CultureInfo.InvariantCulture;
        for (int k = 0; k < 27; ++k) System.Console.WriteLine(probe[k / 9, k % 9].ToString("R", plain));
    }
}
"""


@pytest.mark.tools
def test_unitys_script_fills_what_evaluate_prints(tmp_path: Path) -> None:
    """With stand-ins for the engine's types; Unity looks from the sun, x east, y up, z north."""
    theta, phi, _ = SUN
    towards = np.array([np.sin(theta) * np.cos(phi), np.cos(theta), np.sin(theta) * np.sin(phi)])
    forward = ", ".join(f"{value!r}f" for value in (-towards).tolist())
    (tmp_path / "Skylight.cs").write_text(code("csharp", "MonoBehaviour"), encoding="utf-8")
    program = UNITY.replace("FORWARD", forward).replace("TURBIDITY", f"{SUN[2]}f")
    (tmp_path / "Program.cs").write_text(program, encoding="utf-8")
    files = [str(tmp_path / "Skylight.cs"), str(tmp_path / "Program.cs"), str(REFERENCE / "code" / "skylight_sh.cs")]
    # 0649: the editor sets public fields.
    command = ["mcs", "-langversion:7.2", "-warn:4", "-warnaserror", "-nowarn:0649", f"-out:{tmp_path / 'program.exe'}"]
    made = subprocess.run([*command, *files], capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stdout + made.stderr
    done = subprocess.run(["mono", str(tmp_path / "program.exe")], capture_output=True, text=True, check=True)
    expected = np.array(evaluated("unity")).ravel()
    assert np.array(done.stdout.split(), dtype=float) == pytest.approx(expected, abs=2e-5 * np.abs(expected).max())


THREE = """
class Probe { sh = { coefficients: Array.from({ length: 9 }, () => ({ set(...c) { this.c = c; } })) }; }
"""


@pytest.mark.tools
def test_the_page_for_three_js_fills_what_evaluate_prints(tmp_path: Path) -> None:
    """Its script parses as a module, and its own function `light` fills a stand-in of the probe."""
    script = HTML.read_text(encoding="utf-8").partition('<script type="module">')[2].partition("</script>")[0]
    (tmp_path / "page.mjs").write_text(script, encoding="utf-8")
    subprocess.run(["node", "--check", str(tmp_path / "page.mjs")], check=True)
    function = re.search(r"^function light\(.*?^}", script, re.DOTALL | re.MULTILINE)
    assert function
    module = (REFERENCE / "code" / "skylight_sh.mjs").as_uri()
    program = f"""import {{ weights, WEIGHTS }} from "{module}";{THREE}{function[0]}
    const probe = new Probe();
    light(probe, weights({", ".join(map(str, SUN))}));
    console.log(JSON.stringify(probe.sh.coefficients.map((one) => one.c)));"""
    (tmp_path / "try.mjs").write_text(program, encoding="utf-8")
    done = subprocess.run(["node", str(tmp_path / "try.mjs")], capture_output=True, text=True, check=True)
    printed = evaluated("threejs")
    assert isinstance(printed, dict)
    expected = np.array(printed["object"]["sh"]).reshape(9, 3)
    assert np.array(json.loads(done.stdout)) == pytest.approx(expected, abs=1e-5 * np.abs(expected).max())


@contextmanager
def served(folder: Path) -> Iterator[str]:
    """The address of a server of a folder's files."""
    handler = partial(Quiet, directory=str(folder))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        thread = Thread(target=server.serve_forever)
        thread.start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()
        thread.join()


class Quiet(SimpleHTTPRequestHandler):
    """Tells nothing of what it served."""

    def log_message(self, *_: object) -> None:
        return


@pytest.mark.tools
def test_the_page_for_three_js_shows_light_that_follows_the_hour(tmp_path: Path) -> None:
    """As the README says: three.js beside the page, a server, a browser. The ground darkens towards the evening."""
    package = next(word for word in code("sh", "npm install").split() if word.startswith("three@"))
    for folder in ("examples", "reports/reference/code"):
        shutil.copytree(ROOT / folder, tmp_path / folder, ignore=shutil.ignore_patterns("node_modules", "package*"))
    quiet = ["--ignore-scripts", "--no-audit", "--no-fund", "--silent"]
    subprocess.run(["npm", "install", "--prefix", str(tmp_path / "examples"), *quiet, package], check=True)
    with served(tmp_path) as address, browser(tmp_path / "profile") as window:
        window.size(320, 200)
        window.call("Page.navigate", url=f"{address}/examples/three.html")
        window.run("new Promise((done) => document.readyState === 'complete' ? done() : addEventListener('load', done))")
        grounds = []
        for hour in (12, 17.5):
            window.run(f"hour.value = {hour}; hour.dispatchEvent(new Event('input', {{ bubbles: true }})); null")
            window.frames()
            # In a corner right of the sliders, where no shadow falls.
            grounds.append(window.picture()[180:195, 290:315].mean(axis=(0, 1)))
        assert window.errors == []
    noon, evening = grounds
    assert noon.min() > 60
    assert evening.sum() < 0.8 * noon.sum()
