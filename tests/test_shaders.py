"""Shaders: compiled by glslang and Tint, run in software, held against the runtime; and what they refuse."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shader_tools
from conftest import ROOT, SMALL, run_quietly, with_spec
from numpy.typing import NDArray
from skylight_sh import runtime, sphere
from skylight_sh.config import ConfigError, load, loading
from skylight_sh.export import shaders
from skylight_sh.export.shader_dialects import DIALECTS
from skylight_sh.fit.axis import Axis
from skylight_sh.formula.elementary import exp, label
from skylight_sh.light.protocol import Prefactor
from skylight_sh.run.runner import Result
from skylight_sh.runtime import Table
from skylight_sh.studies.stability.flavours import flavours
from skylight_sh.table.prefactor import closed_form, reciprocal
from skylight_sh.table.table import fast, specification

Floats = NDArray[np.float32]
Array = NDArray[np.float64]
REFERENCE = ROOT / "reports" / "reference" / "export" / "skylight_sh.npz"
AXES = (
    Axis("sun_zenith", 0.0, 1.0, map="cbrt", point=1.0),
    Axis("albedo", -1.0, 2.0, map="log", point=-2.0),
    Axis("haze", 0.0, 3.0),
)
# A matrix from three classes to two channels.
MIXED = Prefactor(
    "mixed",
    ("albedo", "haze"),
    (0.5, 2.0),
    lambda v, w, k: [k[0] * w, v * v, -1.0, k[1] + label(v * w, "both"), v - w, 1.0 / (w + k[1])],
)
# Each: axes, channels, bands, whether mirrored, basis, what sums are multiplied with, whether with parity.
MADE = {
    "one-band": (1, 1, 1, True, "chebyshev", "", False),
    "all-orders": (1, 1, 3, False, "legendre", "", True),
    "three-axes": (3, 2, 5, True, "fourier", "", False),
    "over-polynomial": (2, 3, 3, True, "chebyshev", "polynomial", False),
    "monomials": (2, 3, 9, False, "monomial", "", False),
    "classes": (3, 2, 4, True, "chebyshev", "matrix", True),
    "classes-all-orders": (3, 2, 3, False, "legendre", "matrix", True),
}


def made(axes: int, channels: int, bands: int, mirrored: bool, basis: str, over: str, parity: bool) -> Table:
    rng = np.random.default_rng(axes)
    degrees = (5, 3, 2)[:axes]
    specified = tuple(axis.specified for axis in AXES[:axes])
    numbers = np.array([2.0, 0.3, -0.1]).reshape(3, *(1,) * (axes - 1)).astype(np.float32)
    scales = {"polynomial": lambda: reciprocal(numbers, specified), "matrix": lambda: closed_form(MIXED, specified)}
    scale = scales[over]() if over else None
    names = ("a", "b", "c")[:channels]
    spec = specification(AXES[:axes], names, mirrored, basis, scale, peak_axis="sun_zenith", parity=parity)
    dense = rng.normal(size=(spec.classes, sphere.Harmonics(bands, mirrored).count, *(d + 1 for d in degrees)))
    lengths = rng.integers(0, degrees[0] + 2, size=(spec.classes, *dense.shape[3:]))
    lengths.flat[0] = 2
    return fast(spec, dense, lengths, bands, "float32")


def tables() -> dict[str, Table]:
    known = {"preetham": runtime.read(REFERENCE), "twilight": flavours()["twilight"]}
    return known | {name: made(*given) for name, given in MADE.items()}


def drawn(table: Table) -> Floats:
    """Twenty parameter sets, some of them beyond the ranges."""
    rng = np.random.default_rng(4)
    beyond = [0.4 * (axis.high - axis.low) * (np.arange(20) % 3 == 0) for axis in table.axes]
    columns = [rng.uniform(a.low - far, a.high + far) for a, far in zip(table.axes, beyond, strict=True)]
    columns.insert(1, rng.uniform(-10, 10, 20))
    return np.stack(columns, axis=-1).astype(np.float32)


def directions() -> Floats:
    """Fifty unit vectors, the poles and a horizontal one among them."""
    found = np.random.default_rng(5).normal(size=(50, 3))
    found[:3] = [[0, 0, 1], [0, 0, -1], [1, 0, 0]]
    return (found / np.linalg.norm(found, axis=-1, keepdims=True)).astype(np.float32)


def lobe(bands: int) -> Array:
    """The clamped cosine's factors of degrees 0 to bands - 1, by quadrature."""
    nodes, weights = np.polynomial.legendre.leggauss(64)
    height = (nodes + 1) / 2
    legendre = np.polynomial.legendre.legvander(height, bands - 1)
    return np.asarray(np.pi * (weights * height) @ legendre)


@pytest.fixture(scope="module")
def images(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Floats]:
    folder = tmp_path_factory.mktemp("shaders")
    programs = {}
    for name, table in tables().items():
        for language in DIALECTS:
            one = shader_tools.program(table, language, drawn(table), directions())
            programs[f"{name}.{language}"] = shader_tools.as_glsl(one, folder) if language == "hlsl" else one
    return shader_tools.run(programs, folder)


@pytest.mark.tools
@pytest.mark.parametrize("language", DIALECTS)
@pytest.mark.parametrize("name", ["preetham", "twilight", *MADE])
def test_shaders_agree_with_the_runtime(images: dict[str, Floats], name: str, language: str) -> None:
    table = tables()[name]
    image = images[f"{name}.{language}"].astype(np.float64)
    weights, status = runtime.Runtime(table).weights_and_status(*drawn(table).T.astype(np.float64))
    assert set(status.tolist()) == {0, 1}
    assert np.array_equal(image[..., 3], np.broadcast_to(status[:, np.newaxis], image.shape[:2]))

    degrees = sphere.Harmonics(table.bands).degrees
    basis = sphere.basis(directions().astype(np.float64), table.bands)
    bent = weights * lobe(table.bands)[degrees]
    expected = np.concatenate([weights, weights @ basis.T, bent @ basis.T], axis=-1)
    got = image[..., : len(table.channels)].swapaxes(1, 2)
    assert got.shape == expected.shape
    assert np.abs(got - expected).max() < 1e-5 * np.abs(weights).max()


@pytest.mark.tools
@pytest.mark.parametrize("name", ["preetham", "three-axes"])
def test_glslang_takes_every_flavour(tmp_path: Path, name: str) -> None:
    table = tables()[name]
    glsl = shader_tools.program(table, "glsl", drawn(table), directions()).source
    shader_tools.glslang(glsl, tmp_path / "es.frag")
    for version in ("330", "450"):
        shader_tools.glslang(glsl.replace("300 es", version, 1), tmp_path / f"{version}.frag")
    # Two tables in one program.
    both = [shaders.write(table, shader_tools.FACTS, "glsl", prefix) for prefix in ("day_sh", "night_sh", "day_sh")]
    shader_tools.glslang("\n".join(["#version 300 es", *both, "void main() {}"]), tmp_path / "both.frag")


def test_what_cannot_become_a_shader_is_refused(small_run: Result) -> None:
    folders = {row["name"]: small_run.folder / row["path"] for row in small_run.summary["tables"]}
    for name, why in {"4-bands-1pct-packed": "layout is packed", "3-bands-degrees-6-4-float64": "float64"}.items():
        table = runtime.read(folders[name] / "skylight_sh.npz")
        with pytest.raises(ValueError, match=why):
            shaders.write(table, shader_tools.FACTS, "glsl")
    table = made(*MADE["one-band"])
    with pytest.raises(ValueError, match="5 channels"):
        shaders.write(with_spec(table, channels=tuple("abcde")), shader_tools.FACTS, "wgsl")
    for prefix in ("gl_sky", "a__b", "sky_", "Sky"):
        with pytest.raises(ValueError, match="Invalid prefix"):
            shaders.write(table, shader_tools.FACTS, "hlsl", prefix)


def test_a_prefactor_becomes_a_dialect() -> None:
    def formula(x: Any, k: Any) -> Any:
        a = label(k[0] * x - 1, "a")
        c = label(exp(a * k[1]), "c")
        return 1e-5 * c / (x * k[2])

    axis = Axis("haze", 1.0, 3.0)
    scale = closed_form(Prefactor("made_up", ("haze",), (-0.5, 3.0, 1e-6), formula), (axis.specified,))
    table = fast(specification((axis,), ("one",), True, "chebyshev", scale), np.ones((1, 1, 2)), np.array([2]), 1, "float32")
    for language, declared in {"glsl": "float {}", "hlsl": "const float {}", "wgsl": "let {}: f32"}.items():
        text = shaders.write(table, shader_tools.FACTS, language)
        lines = [
            f"{declared.format('a')} = (-0.5) * x0 - 1.0;",
            f"{declared.format('c')} = exp(a * 3.0);",
            "return 9.99999975e-06 * c / (x0 * 9.99999997e-07);",
        ]
        assert "\n".join(f"    {line}" for line in lines) in text


def test_a_run_publishes_the_shaders_it_is_asked_for(small_run: Result, tmp_path: Path) -> None:
    assert not [path for path in small_run.folder.rglob("skylight_sh.*") if path.suffix not in (".h", ".npz")]
    config = load(SMALL)
    asked = config.model_copy(
        update={"export": config.export.model_copy(update={"targets": ("c", "npz", "glsl", "hlsl", "wgsl")})}
    )
    found = run_quietly(asked, tmp_path)
    for row in found.summary["tables"]:
        expected = {"h", "npz"} | (set(DIALECTS) if row["layout"] == "rows" and row["dtype"] == "float32" else set())
        files = (found.folder / row["path"]).glob("skylight_sh.*")
        assert {path.suffix[1:] for path in files} == expected, row["name"]
    text = (found.folder / "export" / "skylight_sh.wgsl").read_text(encoding="utf-8")
    assert "CC0-1.0" in text
    assert re.search(r"config small [0-9a-f]{16}, table 4-bands-1pct", text)
    # Which files tell of a table changes no table.
    plain = {**small_run.summary, "config": {**small_run.summary["config"], "export": found.summary["config"]["export"]}}
    assert found.summary == plain


def test_targets_are_checked() -> None:
    raw = tomllib.loads(SMALL.read_text(encoding="utf-8"))
    raw["export"] |= {"targets": ["glsl"], "prefix": "a__b"}
    with pytest.raises(ConfigError, match=r"(?s)export\.targets.*export\.prefix"):
        loading.parse(raw, "small")
