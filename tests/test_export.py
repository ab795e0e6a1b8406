"""Exports: the header compiled and run against the runtime, the NPZ, and what both do at and beyond the edges."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, with_spec
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from skylight_sh import runtime, sphere
from skylight_sh.export import c_header
from skylight_sh.export.reserved import usable
from skylight_sh.fit.axis import Axis
from skylight_sh.run.runner import Result
from skylight_sh.runtime import Table
from skylight_sh.table import npz
from skylight_sh.table.prefactor import reciprocal
from skylight_sh.table.table import fast, small, specification

Array = NDArray[np.float64]
STRICT = ["-O2", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror"]
COMPILERS = {"c99": ["gcc", "-std=c99"], "c++11": ["g++", "-std=c++11", "-x", "c++"]}
FACTS = c_header.Facts("Sky */ one", 0.001, 0.004, "per-set", ["line */ one", "line two"])

DRIVER = """
#include <stdio.h>
#include "{folder}/skylight_sh.h"
/* Reads inputs as raw floats and a number of bands; writes the status and the weights as raw numbers. */
int main(void)
{{
    float in[{inputs}], w[{P}_CHANNELS][{P}_WEIGHTS];
    int bands;
    while (fread(in, sizeof in, 1, stdin) == 1 && fread(&bands, sizeof bands, 1, stdin) == 1) {{
        const int status = bands ? {p}_weights_bands({arguments}, bands, w) : {p}_weights({arguments}, w);
        fwrite(&status, sizeof status, 1, stdout);
        fwrite(w, sizeof w, 1, stdout);
    }}
    return 0;
}}
"""


def compiled(folder: Path, place: Path, inputs: int, compiler: Sequence[str], flags: Sequence[str], p: str) -> Path:
    arguments = ", ".join(f"in[{i}]" for i in range(inputs))
    source = DRIVER.format(folder=folder, inputs=inputs, arguments=arguments, p=p, P=p.upper())
    place.mkdir(parents=True, exist_ok=True)
    (place / "driver.c").write_text(source, encoding="utf-8")
    command = [*compiler, *flags, str(place / "driver.c"), "-o", str(place / "driver"), "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return place / "driver"


def call(driver: Path, inputs: NDArray[np.float32], bands: int, shape: tuple[int, int]) -> tuple[Array, NDArray[np.int32]]:
    record = np.zeros(len(inputs), dtype=[("in", "<f4", inputs.shape[1]), ("bands", "<i4")])
    record["in"], record["bands"] = inputs, bands
    out = subprocess.run([str(driver)], input=record.tobytes(), capture_output=True, check=True).stdout
    got = np.frombuffer(out, dtype=[("status", "<i4"), ("w", "<f4", shape)])
    return got["w"].astype(np.float64), got["status"]


def drawn(table: Table, count: int, beyond: float = 0.0) -> NDArray[np.float32]:
    """Random inputs in the runtime's order, ``beyond`` of the range to each side."""
    rng = np.random.default_rng(3)
    columns = [rng.uniform(a.low - beyond * (a.high - a.low), a.high + beyond * (a.high - a.low), count) for a in table.axes]
    columns.insert(1, rng.uniform(-10, 10, count))
    return np.stack(columns, axis=-1).astype(np.float32)


def prefix_of(result: Result, name: str) -> str:
    return next(str(row["prefix"]) for row in result.summary["tables"] if row["name"] == name)


def exported(result: Result) -> dict[str, Path]:
    return {row["name"]: result.folder / row["path"] for row in result.summary["tables"]}


@pytest.mark.parametrize("language", COMPILERS)
@pytest.mark.parametrize("name", ["4-bands-1pct", "4-bands-1pct-packed", "3-bands-degrees-6-4-float64"])
@pytest.mark.parametrize("more", [["-ffp-contract=off"], ["-O3", "-ffast-math"]], ids=["strict", "fast-math"])
def test_header_agrees_with_the_runtime(
    small_run: Result, tmp_path: Path, language: str, name: str, more: list[str]
) -> None:
    folder = exported(small_run)[name]
    loaded = runtime.load(folder / "skylight_sh.npz")
    shape = (len(loaded.table.channels), loaded.table.bands**2)
    driver = compiled(folder, tmp_path, 3, COMPILERS[language], [*STRICT, *more], prefix_of(small_run, name))

    inputs = drawn(loaded.table, 1000)
    got, status = call(driver, inputs, 0, shape)
    expected = loaded.weights(*inputs.T)
    assert not status.any()
    assert np.abs(got - expected).max() < 2e-6 * np.abs(expected).max()

    inputs = drawn(loaded.table, 300, beyond=1.0)
    got, status = call(driver, inputs, 0, shape)
    expected, expected_status = loaded.weights_and_status(*inputs.T)
    assert status.tolist() == expected_status.tolist()
    assert set(status.tolist()) == {0, 1}
    assert np.abs(got - expected).max() < 2e-6 * np.abs(expected).max()

    fewer, _ = call(driver, drawn(loaded.table, 50), 2, shape)
    whole = loaded.weights(*drawn(loaded.table, 50).T, bands=2)
    assert np.abs(fewer[..., :4] - whole).max() < 2e-6 * np.abs(whole).max()
    assert not fewer[..., 4:].any()


@pytest.mark.parametrize("flags", [[], ["-ffast-math", "-O3"]], ids=["strict", "fast-math"])
def test_header_reports_what_is_no_number(small_run: Result, tmp_path: Path, flags: list[str]) -> None:
    folder = exported(small_run)["4-bands-1pct"]
    loaded = runtime.load(folder / "skylight_sh.npz")
    driver = compiled(folder, tmp_path, 3, COMPILERS["c99"], flags, "skylight_sh")
    nan, inf, large = np.nan, np.inf, np.float32(3e38)
    half_pi = np.float32(np.pi / 2)
    cases = {
        (nan, 0, 3): 2,
        (1, nan, 3): 2,
        (1, 0, nan): 2,
        (1, inf, 3): 2,
        (1, -inf, 3): 2,
        (inf, 0, 3): 1,
        (-inf, 0, 3): 1,
        (1, 0, inf): 1,
        (1, 0, -inf): 1,
        (large, 0, -large): 1,
        (half_pi, 0, 6): 0,
        (0, -0.0, 2.5): 0,
        (1e-40, 1e-40, 3): 0,
        (-1e-3, 0, 3): 1,
        (1, 0, 6.001): 1,
        (1, 0, 6.0000005): 0,
    }
    inputs = np.array(list(cases), dtype=np.float32)
    got, status = call(driver, inputs, 0, (3, 16))
    expected, expected_status = loaded.weights_and_status(*inputs.T)
    assert status.tolist() == list(cases.values()) == expected_status.tolist()
    assert not got[status == 2].any()
    assert np.abs(got - expected).max() < 2e-6 * np.abs(expected).max()


def test_window_follows_the_paper(small_run: Result, tmp_path: Path) -> None:
    folder = exported(small_run)["4-bands-1pct"]
    loaded = runtime.load(folder / "skylight_sh.npz")
    source = (folder / "skylight_sh.h").read_text(encoding="utf-8")
    assert "skylight_sh_window(int bands" in source
    inputs = drawn(loaded.table, 20)
    plain, windowed = loaded.weights(*inputs.T), loaded.weights(*inputs.T, window=True)
    assert windowed == pytest.approx(plain * sphere.zonal_sinc(4).astype(np.float32))
    program = f"""
#include <stdio.h>
#include "{folder}/skylight_sh.h"
int main(void) {{
    float w[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS]; int i;
    skylight_sh_weights(0.8f, 0.3f, 3.0f, w);
    skylight_sh_window(SKYLIGHT_SH_BANDS, w);
    for (i = 0; i < SKYLIGHT_SH_WEIGHTS; ++i) printf("%.9g\\n", (double)w[1][i]);
    return 0;
}}"""
    (tmp_path / "w.c").write_text(program, encoding="utf-8")
    subprocess.run(["gcc", "-std=c99", *STRICT, str(tmp_path / "w.c"), "-o", str(tmp_path / "w"), "-lm"], check=True)
    got = [
        float(v) for v in subprocess.run([str(tmp_path / "w")], capture_output=True, text=True, check=True).stdout.split()
    ]
    expected = loaded.weights(0.8, 0.3, 3.0, window=True)[1]
    assert got == pytest.approx(expected, abs=2e-6 * float(np.abs(expected).max()))


@pytest.mark.parametrize(
    ("axes", "mirrored", "basis", "dtype", "layout"),
    [
        (1, True, "chebyshev", "float32", "rows"),
        (1, True, "monomial", "float64", "rows"),
        (2, False, "legendre", "float32", "rows"),
        (3, True, "fourier", "float64", "rows"),
        (3, False, "monomial", "float32", "rows"),
        (1, False, "chebyshev", "float32", "packed"),
        (2, True, "chebyshev", "float32", "packed"),
        (3, True, "legendre", "float32", "packed"),
    ],
)
def test_tables_over_any_axes_reach_c(
    tmp_path: Path, axes: int, mirrored: bool, basis: str, dtype: str, layout: str
) -> None:
    rng = np.random.default_rng(axes)
    names = ("sun_zenith", "albedo", "haze")[:axes]
    degrees = (5, 3, 2)[:axes]
    kinds = (("reciprocal", 9.0), ("identity", 0.0), ("log", -1.0))
    made = tuple(Axis(n, 0.0, 1.0 + i, map=kinds[i][0], point=kinds[i][1]) for i, n in enumerate(names))
    numbers = np.array([2.0, 0.3, 0.1]).reshape(3, *(1,) * (axes - 1)).astype(np.float32)
    scale = reciprocal(numbers, [axis.specified for axis in made])
    dense = rng.normal(size=(2, sphere.Harmonics(3, mirrored).count, *(d + 1 for d in degrees)))
    spec = specification(made, ("one", "two"), mirrored, basis, scale if basis == "chebyshev" else None)
    if layout == "packed":
        whole = np.rint(20 * dense.swapaxes(0, 1).reshape(dense.shape[1], 2, degrees[0] + 1, -1)).astype(np.int64)
        table = small(spec, whole * rng.integers(0, 2, whole.shape), 0.05, degrees, 3)
    else:
        lengths = rng.integers(0, degrees[0] + 2, size=dense.shape[3:])
        lengths.flat[0] = 2
        table = fast(spec, dense, lengths, 3, dtype)
    (tmp_path / "skylight_sh.h").write_text(c_header.write(table, FACTS, "other_sh"), encoding="utf-8")
    driver = compiled(tmp_path, tmp_path, axes + 1, COMPILERS["c99"], STRICT, "other_sh")
    loaded = runtime.Runtime(table)
    inputs = drawn(table, 200)
    got, _ = call(driver, inputs, 0, (2, 9))
    expected = loaded.weights(*inputs.T)
    assert np.abs(got - expected).max() < 2e-6 * np.abs(expected).max()


@pytest.mark.parametrize("language", COMPILERS)
def test_one_band_compiles(tmp_path: Path, language: str) -> None:
    frame = specification((Axis("sun_zenith", 0.0, 1.0),), ("one",), True, "chebyshev", None)
    table = fast(frame, np.ones((1, 1, 3)), np.array(3), 1, "float32")
    (tmp_path / "skylight_sh.h").write_text(c_header.write(table, FACTS, "other_sh"), encoding="utf-8")
    driver = compiled(tmp_path, tmp_path, 2, COMPILERS[language], STRICT, "other_sh")
    got, status = call(driver, np.array([[1.0, 0.3]], dtype=np.float32), 0, (1, 1))
    assert got[0, 0, 0] == pytest.approx(3.0)
    assert status == 0


@pytest.mark.parametrize("prefix", ["2x", "A", "a-b", "a b", "x" * 64, ""])
def test_a_prefix_that_is_no_identifier_is_refused(small_run: Result, prefix: str) -> None:
    table = runtime.read(exported(small_run)["4-bands-1pct"] / "skylight_sh.npz")
    with pytest.raises(ValueError, match="Invalid prefix"):
        c_header.write(table, FACTS, prefix)


def test_npz_round_trip_and_provenance(small_run: Result, tmp_path: Path) -> None:
    for folder in exported(small_run).values():
        data = (folder / "skylight_sh.npz").read_bytes()
        table = runtime.read(folder / "skylight_sh.npz")
        assert npz.write(table) == data
        assert {"config", "version"} <= set(table.provenance)
        assert not {"environment", "keys"} & set(table.provenance)
        with np.load(folder / "skylight_sh.npz", allow_pickle=False) as archive:
            packed = folder.name.endswith("packed")
            body = {"stream", "rest_profile", "channel_profile"} if packed else {"rows", "lengths", "columns"}
            assert set(archive.files) == {"header"} | body
    for name, content in {"text.npz": b"hello", "empty.npz": b"", "cut.npz": data[:500]}.items():
        (tmp_path / name).write_bytes(content)
        with pytest.raises(ValueError, match=r"no table .*Give the \.npz") as caught:
            runtime.read(tmp_path / name)
        assert "pickle" not in str(caught.value)


@given(st.floats(0, 1.5), st.floats(-9, 9), st.floats(2.5, 6))
def test_turning_the_sun_turns_the_sky(theta: float, azimuth: float, tau: float) -> None:
    loaded = runtime.load(ROOT / "reports" / "reference" / "export" / "skylight_sh.npz")
    there = loaded.weights(theta, azimuth, tau).astype(np.float64)
    back = sphere.rotate_azimuth(there, -azimuth)
    assert np.abs(back - loaded.weights(theta, 0.0, tau)).max() < 1e-5 * np.abs(there).max()


def test_runtime_broadcasts_and_names_its_inputs(small_run: Result) -> None:
    loaded = runtime.load(exported(small_run)["4-bands-1pct"] / "skylight_sh.npz")
    many = loaded.weights(np.linspace(0, 1.5, 5)[:, np.newaxis], 0.3, np.array([2.5, 4.0]))
    assert many.shape == (5, 2, 3, 16)
    one = loaded.weights(turbidity=4.0, sun_zenith=1.5, sun_azimuth=0.3)
    assert np.array_equal(many[-1, -1], one)
    with pytest.raises(TypeError, match="sun_zenith, sun_azimuth, turbidity"):
        loaded.weights(1.0, 0.3)
    with pytest.raises(ValueError, match=r"Invalid bands 5\. Should be 1 to 4"):
        loaded.weights(1.0, 0.3, 3.0, bands=5)


def test_runtime_needs_numpy_alone(small_run: Result) -> None:
    path = exported(small_run)["4-bands-1pct"] / "skylight_sh.npz"
    code = f"""
import sys
for name in ("dask", "h5py", "scipy", "pandas", "matplotlib", "pydantic", "click", "rich", "jinja2"):
    sys.modules[name] = None
from skylight_sh import runtime
print(runtime.load({str(path)!r}).weights(0.8, 0.0, 3.0).shape)
"""
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.stdout.strip() == "(3, 16)", done.stderr


def test_names_of_axes_that_headers_use_are_refused(small_run: Result, tmp_path: Path) -> None:
    """A header compiles with an axis of any name that is let through, those that occur in it among them."""
    text = re.sub(r"/\*.*?\*/", "", (small_run.folder / "export" / "skylight_sh.h").read_text(encoding="utf-8"), flags=re.S)
    table = runtime.read(small_run.folder / "export" / "skylight_sh.npz")
    words = sorted({w for w in re.findall(r"[a-z][a-z0-9_]+", text) if not w.startswith("skylight")} | {"haze", "hour"})
    # Of the numbered names of steps the first few stand for all.
    allowed = [w for w in words if usable(w) and w != table.axes[0].name and not re.fullmatch(r"part_\d\d+", w)]
    assert {"haze", "hour"} <= set(allowed)
    for word in allowed:
        axes = (table.axes[0], replace(table.axes[1], name=word))
        header = c_header.write(with_spec(table, axes=axes, scale=None), FACTS)
        (tmp_path / f"{word}.c").write_text(f"{header}\nint main(void) {{ return 0; }}\n", encoding="utf-8")
    files = [str(tmp_path / f"{word}.c") for word in allowed]
    for compiler in (["gcc", "-std=c99"], ["g++", "-std=c++11", "-x", "c++"]):
        done = subprocess.run([*compiler, "-fsyntax-only", *files], capture_output=True, text=True, check=False)
        assert done.stderr == ""
