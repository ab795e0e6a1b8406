"""Compilers and a browser for shaders: programs that print what the exported functions return, and where they run.

A program makes an image: one row a parameter set; columns are all weights, then the radiance, then the irradiance in each
direction; a pixel holds up to three channels and, in the last place, the status.
"""

from __future__ import annotations

import base64
import html
import json
import re
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from skylight_sh.export import shaders
from skylight_sh.export.c_header import Facts
from skylight_sh.export.shader_dialects import DIALECTS
from skylight_sh.formula.printers import single as number
from skylight_sh.runtime import Table

Floats = NDArray[np.float32]
FACTS = Facts("Sky \\\n one */ \u2028 \u00fc \\", 0.001, 0.004, "per-set", ["line one \\", "line\ntwo"])

HEADS = {
    "glsl": "layout(location = 0) out vec4 result;\nvoid main() {{\n"
    "int i = int(gl_FragCoord.x); int s = int(gl_FragCoord.y);",
    "hlsl": "float4 main(float4 place : SV_Position) : SV_Target {{\nint i = int(place.x); int s = int(place.y);",
    "wgsl": "@group(0) @binding(0) var<storage, read_write> result: array<vec4<f32>>;\n@compute @workgroup_size(1)\n"
    "fn main(@builtin(global_invocation_id) id: vec3<u32>) {{ let i = i32(id.x); let s = i32(id.y);",
}
ENDS = {"glsl": "result = {};\n}}\n", "hlsl": "return {};\n}}\n", "wgsl": "result[s * {width} + i] = {};\n}}\n"}

PAGE = """<!doctype html><pre id="result"></pre><iframe id="hold"></iframe><script>
// The page counts as loading, and so is not printed, until this frame's document closes.
const hold = document.getElementById("hold").contentDocument;
hold.open();
const encode = (a) => { let t = ""; for (const b of new Uint8Array(a.buffer)) t += String.fromCharCode(b); return btoa(t); };
const gl = document.createElement("canvas").getContext("webgl2");
if (!gl || !gl.getExtension("EXT_color_buffer_float")) throw new Error("no WebGL 2 with float targets");
function webgl({ source, width, height }) {
  const program = gl.createProgram();
  const corner = "vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1)";
  const corners = `#version 300 es\\nvoid main() { gl_Position = ${corner}; }`;
  for (const [kind, text] of [[gl.VERTEX_SHADER, corners], [gl.FRAGMENT_SHADER, source]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, width, height);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, gl.getParameter(gl.TEXTURE_BINDING_2D), 0);
  gl.viewport(0, 0, width, height);
  gl.useProgram(program);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const out = new Float32Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, out);
  if (gl.getError()) throw new Error("WebGL error");
  return out;
}
async function webgpu(device, { source, width, height }) {
  const module = device.createShaderModule({ code: source });
  const told = (await module.getCompilationInfo()).messages;
  if (told.length) throw new Error(told.map((m) => `${m.lineNum}: ${m.message}`).join("; "));
  const pipeline = await device.createComputePipelineAsync({ layout: "auto", compute: { module, entryPoint: "main" } });
  const size = 16 * width * height;
  const [made, read] = ["STORAGE", "MAP_READ"].map((use, i) =>
    device.createBuffer({ size, usage: GPUBufferUsage[use] | GPUBufferUsage[i ? "COPY_DST" : "COPY_SRC"] }));
  const entries = [{ binding: 0, resource: { buffer: made } }];
  const encoder = device.createCommandEncoder();
  const pass = encoder.beginComputePass();
  pass.setPipeline(pipeline);
  pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries }));
  pass.dispatchWorkgroups(width, height);
  pass.end();
  encoder.copyBufferToBuffer(made, 0, read, 0, size);
  device.queue.submit([encoder.finish()]);
  await read.mapAsync(GPUMapMode.READ);
  return new Float32Array(read.getMappedRange().slice(0));
}
(async () => {
  const results = {};
  const device = await (await navigator.gpu.requestAdapter()).requestDevice();
  for (const [name, program] of Object.entries(PROGRAMS)) {
    try {
      results[name] = { data: encode(program.api === "webgpu" ? await webgpu(device, program) : webgl(program)) };
    } catch (error) {
      results[name] = { error: String(error) };
    }
  }
  document.getElementById("result").textContent = JSON.stringify(results);
})().catch((error) => { document.title = String(error); }).finally(() => hold.close());
</script>
"""


@dataclass(frozen=True)
class Program:
    """Source over the exported functions, and the size of the image it makes."""

    language: str
    source: str
    width: int
    height: int


def program(table: Table, language: str, inputs: Floats, directions: Floats, prefix: str = "skylight_sh") -> Program:
    """Write a program for ``inputs`` ``(n, axes + 1)`` in the runtime's order and unit ``directions`` ``(k, 3)``."""
    d = DIALECTS[language]
    channels, weights, count = len(table.channels), table.bands**2, len(directions)
    colour = "real" if channels == 1 else f"vec{channels}"
    given = ", ".join(f"test_inputs[{inputs.shape[1]} * s + {i}]" for i in range(inputs.shape[1]))
    parts = ["v"] if channels == 1 else [f"v.{c}" for c in "xyz"[:channels]]
    pixel = d.vector([*parts, *["0.0"] * (3 - len(parts)), f"{d.types['real']}(status)"])
    width = weights + 2 * count
    lines = [
        shaders.write(table, FACTS, language, prefix),
        d.constants("real", "test_inputs", [number(v) for v in inputs.ravel().tolist()], 8),
        d.constants("vec3", "test_directions", [d.vector([number(v) for v in row]) for row in directions.tolist()], 4),
        HEADS[language].format(),
        d.array(colour, "w", weights),
        d.fixed("whole", "status", f"{prefix}_weights({given}, {'&' if language == 'wgsl' else ''}w)"),
        d.variable(colour, "v", "w[0]"),
        f"if (i < {weights}) {{ v = w[i]; }}",
        f"else if (i < {weights + count}) {{ v = {prefix}_radiance(w, test_directions[i - {weights}]); }}",
        f"else {{ v = {prefix}_irradiance(w, test_directions[i - {weights + count}]); }}",
        ENDS[language].format(pixel, width=width),
    ]
    version = "#version 300 es\n" if language == "glsl" else ""
    return Program(language, version + "\n".join(lines), width, len(inputs))


def glslang(source: str, place: Path, *flags: str) -> None:
    """Compile with glslang, whose word is in the error."""
    place.write_text(source, encoding="utf-8")
    done = subprocess.run(["glslangValidator", *flags, str(place)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "WARNING" not in done.stdout, done.stdout


def as_glsl(made: Program, folder: Path) -> Program:
    """Translate an HLSL program into GLSL, through SPIR-V, since no software renderer takes HLSL itself."""
    spirv = folder / "made.spv"
    # -Od: of loops that glslang has optimised, SPIRV-Cross (as of Debian 12) makes GLSL that adds wrong rows.
    glslang(made.source, folder / "made.hlsl", "-V", "-Od", "-D", "-e", "main", "-S", "frag", "-o", str(spirv))
    command = ["spirv-cross", "--es", "--version", "300", str(spirv)]
    text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    # SPIR-V knows no default precision; HLSL floats have 32 bits.
    return Program("glsl", text.replace("precision mediump float", "precision highp float"), made.width, made.height)


def run(programs: Mapping[str, Program], folder: Path) -> dict[str, Floats]:
    """Run GLSL by WebGL 2 and WGSL by WebGPU in one headless browser without a GPU: images ``(height, width, 4)``."""
    listed = {
        name: {
            "api": "webgpu" if p.language == "wgsl" else "webgl",
            "source": p.source,
            "width": p.width,
            "height": p.height,
        }
        for name, p in programs.items()
    }
    data = json.dumps(listed).replace("<", "\\u003c")
    page = folder / "page.html"
    page.write_text(PAGE.replace("<script>", f"<script>\nconst PROGRAMS = {data};", 1), encoding="utf-8")
    flags = ["--headless", "--no-sandbox", "--no-first-run", "--disable-background-networking", "--dump-dom"]
    software = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--enable-unsafe-webgpu"]
    adapter = ["--use-webgpu-adapter=swiftshader", f"--user-data-dir={folder / 'profile'}"]
    command = ["chromium", *flags, *software, *adapter, page.as_uri()]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=300)
    found = re.search(r'<pre id="result">(.+?)</pre>', done.stdout, re.DOTALL)
    assert found, done.stdout[:300] + done.stderr[-2000:]
    results = json.loads(html.unescape(found[1]))
    wrong = {name: result["error"] for name, result in results.items() if "error" in result}
    assert not wrong, wrong
    return {
        name: np.frombuffer(base64.b64decode(results[name]["data"]), dtype="<f4").reshape(p.height, p.width, 4)
        for name, p in programs.items()
    }
