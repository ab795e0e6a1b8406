"""The same bits everywhere: rounding, sums in a fixed order, one sun's bits alone and in a batch, bytes under noise."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest
from conftest import ROOT, SMALL, run_quietly, scene_config
from hypothesis import given
from hypothesis import strategies as st
from skylight_sh import runtime
from skylight_sh.config import load
from skylight_sh.fit import peaks
from skylight_sh.fit.errors import l_min
from skylight_sh.quadrature import parameter_points
from skylight_sh.reproducible import cube_root, logarithm, significant, to_grid
from skylight_sh.run.runner import Result
from skylight_sh.runtime import in_double, product
from skylight_sh.store.store import Store
from skylight_sh.studies.stability import same_bytes

# Two kernels that are far from each other and run on any x86-64 machine of the last ten years; others ignore them.
DISTANT = (
    {"OPENBLAS_CORETYPE": "Nehalem", "NPY_DISABLE_CPU_FEATURES": "X86_V3 X86_V4 AVX512_ICL AVX512_SPR"},
    {"OPENBLAS_CORETYPE": "Haswell", "OPENBLAS_NUM_THREADS": "2"},
)


@given(st.floats(1e-300, 1e300), st.integers(2, 40))
def test_significant_keeps_so_many_bits(value: float, bits: int) -> None:
    got = float(significant(value, bits))
    # The spacing of numbers with so many bits, in exact arithmetic.
    exponent = np.frexp(value)[1] - bits
    spacing = Fraction(2) ** int(exponent)
    assert (Fraction(got) / spacing).denominator == 1
    assert abs(Fraction(got) - Fraction(value)) <= spacing / 2
    assert float(significant(-value, bits)) == -got


def test_least_luminances_are_rounded_to_fourteen_bits() -> None:
    least, mean = np.array([1.0, 1.0 + 2.0**-14, 300.123456]), np.array([2.0, 3.0, 4.0])
    made = l_min(least, mean)
    assert made["per-set"].tolist()[:2] == [1.0, 1.0]
    assert np.all(np.abs(made["per-set"] / least - 1.0) <= 2.0**-14)
    assert made["global"].tolist() == [1.0] * 3
    assert list(l_min(np.array([0.0, 1.0, 2.0]), mean)) == ["mean"]


def test_a_grid_is_the_largest_magnitudes() -> None:
    values = np.array([-5.0, 3.0 + 2.0**-9, 2.0**-30, 0.0])
    # 5 has the power of two 4; with 8 bits the step is 4 / 256.
    assert to_grid(values, 8).tolist() == [-5.0, 3.0, 0.0, 0.0]
    assert to_grid(np.zeros(3), 8).tolist() == [0.0] * 3


@given(st.integers(1, 300), st.integers(1, 40), st.integers(1, 20), st.sampled_from(["float32", "float64"]))
def test_a_product_is_summed_term_by_term(rows: int, terms: int, columns: int, dtype: str) -> None:
    rng = np.random.default_rng(rows)
    left, right = (rng.normal(size=shape).astype(dtype) for shape in ((rows, terms), (terms, columns)))
    got = product(left, right)
    expected = np.zeros((rows, columns), dtype=dtype)
    for term in range(terms):
        expected += left[:, term, np.newaxis] * right[term]
    assert got.dtype == np.dtype(dtype)
    assert np.array_equal(got, expected)
    assert np.array_equal(product(left[::-1], right), got[::-1])
    assert np.array_equal(product(left[:1], right), got[:1])


@pytest.mark.parametrize("value", [1e-8, 0.3, 1.0, 2.0, 27.0, 12345.678])
def test_constants_are_correctly_rounded(value: float) -> None:
    with mpmath.workprec(200):
        assert logarithm(value) == float(mpmath.log(value))
        assert cube_root(value) == float(mpmath.cbrt(value))


def test_single_precision_functions_are_correctly_rounded() -> None:
    x = np.linspace(0.01, 3.0, 301, dtype=np.float32)[::-1]
    for function, exact in ((np.log, mpmath.log), (np.exp, mpmath.exp), (np.cos, mpmath.cos), (np.cbrt, mpmath.cbrt)):
        with mpmath.workprec(100):
            expected = [np.float32(float(exact(mpmath.mpf(float(v))))) for v in x]
        assert in_double(function, x).dtype == np.float32
        assert in_double(function, x).tolist() == [float(v) for v in expected]


def test_peaks_between_nodes_are_found() -> None:
    # |sin| of five lobes at four nodes each, two of them astride a lobe's top: cos(pi / 8) of it.
    x = (np.arange(20) + 0.5) / 20.0
    y = np.linspace(0.0, 1.0, 7)
    values = np.abs(np.sin(5 * np.pi * x))[:, np.newaxis] * (1.0 + 0.1 * y)
    assert values.max() == pytest.approx(1.1 * np.cos(np.pi / 8))
    # The parabola's vertex over sin^2 at pi/8, 3 pi/8 and 5 pi/8, by hand: 0.942.
    a, b = np.sin(np.pi / 8) ** 2, np.sin(3 * np.pi / 8) ** 2
    expected = 1.1 * np.sqrt(b + (b - a) / 8)
    assert peaks.largest(values.reshape(-1, 1), (20, 7)) == pytest.approx(expected)
    assert 0.97 < expected / 1.1 < 1.0
    # Six nodes a lobe, one off its top by a third of the spacing.
    fine = np.sin(np.pi * (np.arange(7) / 6 + 1 / 18))
    assert peaks.largest(fine[:, np.newaxis], (7,)) == pytest.approx(1.0, abs=0.005)
    # Nothing is added at an end, nor to sets beyond the grid.
    assert peaks.largest(np.array([[3.0], [2.0], [1.0], [5.0]]), (3,)) == 5.0
    assert peaks.largest(np.array([[1.0], [2.0], [1.0], [0.0]]), (3,)) == 2.0


def test_held_out_sets_are_even_and_hold_edges_and_corners() -> None:
    ranges = [(0.0, 1.5), (2.0, 6.0)]
    made = parameter_points.held_out(ranges, 2000, 128, 7)
    assert made.shape == (2000 + 4 * 128 + 4, 2)
    inside, edges, corners = made[:2000], made[2000:-4], made[-4:]
    assert np.all((inside > [0.0, 2.0]) & (inside < [1.5, 6.0]))
    # 1,024 scrambled Sobol points leave no box of 1 / 32 by 1 / 32 empty: that is what makes them a (0, m, 2)-net.
    boxes = np.floor(32 * (inside[:1024] - [0.0, 2.0]) / [1.5, 4.0]).astype(int)
    assert len({tuple(box) for box in boxes.tolist()}) == 32 * 32
    assert [int(np.sum(edges[:, a] == end)) for a in (0, 1) for end in ranges[a]] == [128] * 4
    assert sorted(map(tuple, corners.tolist())) == [(0.0, 2.0), (0.0, 6.0), (1.5, 2.0), (1.5, 6.0)]
    assert not np.array_equal(made, parameter_points.held_out(ranges, 2000, 128, 8))
    assert parameter_points.held_out([(0.0, 1.0), (3.0, 3.0)], 10, 4, 1).shape == (12, 2)


def test_held_out_sets_are_read_by_the_measurement_alone() -> None:
    from skylight_sh.run.steps import steps

    readers = {step.name for step in steps(load(ROOT / "configs/preetham.toml")) if "truth/held-out" in step.inputs}
    assert readers == {"measure"}
    for name in (
        "pipeline/skylight_sh/run/stages/select.py",
        "pipeline/skylight_sh/run/stages/fit.py",
        "pipeline/skylight_sh/run/stages/origins.py",
        "pipeline/skylight_sh/run/from_config.py",
        "pipeline/skylight_sh/table/selection.py",
        "pipeline/skylight_sh/table/grid_fit.py",
        "pipeline/skylight_sh/fit/paper_scheme.py",
    ):
        assert "held" not in (ROOT / name).read_text(encoding="utf-8").replace("held-out ones", "")


SCENES = {
    "plain": "",
    "twilight": "twilight = true",
    "surroundings": """horizon = [0.1, 0.4, 0.2]
ground = [0.2, 0.3, 0.1]
lights = [{ kind = "point", centre = [1.0, 2.0, 3.0], intensity = [100.0, 50.0, 20.0] }]""",
}


@pytest.fixture(scope="module")
def tables(small_run: Result, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """NPZ files of every layout and number type, of a twilight, of surroundings, and of a Perez sky's prefactor."""
    found = {path.parent.name: path for path in small_run.folder.rglob("*.npz")}
    for name in ("twilight", "surroundings"):
        made = run_quietly(scene_config(SCENES[name]), tmp_path_factory.mktemp(name))
        found[name] = made.folder / "export" / "skylight_sh.npz"
    found["reference"] = ROOT / "reports/reference/export/skylight_sh.npz"
    return found


def test_one_sun_has_the_same_bits_alone_and_in_any_batch(tables: dict[str, Path]) -> None:
    rng = np.random.default_rng(3)
    for name, path in tables.items():
        sky = runtime.load(path)
        low, high = np.transpose(sky.table.ranges)
        values = rng.uniform(low, high, size=(4096, len(low)))
        values[:4] = [low, high, low - 1.0, high + 1.0]
        columns = {axis.name: values[:, i] for i, axis in enumerate(sky.table.axes)}
        columns["sun_azimuth"] = np.concatenate([rng.uniform(-7.0, 7.0, 4000), 10.0 ** rng.uniform(1, 9, 96)])
        whole = sky.weights(**columns)
        back = sky.weights(**{key: column[::-1] for key, column in columns.items()})
        assert np.array_equal(back[::-1], whole), name
        for size in (1, 2, 7):
            for start in (0, 1, 500, 4096 - size):
                part = sky.weights(**{key: column[start : start + size] for key, column in columns.items()})
                assert np.array_equal(part, whole[start : start + size]), (name, size, start)
        alone = sky.weights(**{key: column[17] for key, column in columns.items()})
        assert np.array_equal(alone, whole[17]), name


@pytest.mark.parametrize("seed", range(3))
def test_noise_on_the_truth_changes_no_byte(small_run: Result, seed: int) -> None:
    config = load(SMALL)
    config = config.model_copy(update={"report": config.report.model_copy(update={"figures": ()})})
    truths = same_bytes.truths_of(config, Store(small_run.folder.parents[1] / "artifacts"))
    quiet = same_bytes.outputs(config, truths)
    assert same_bytes.outputs(config, truths, same_bytes.Noise(seed)) == quiet
    # Noise that matters does change bytes: the study sees what it looks for.
    loud = same_bytes.outputs(config, truths, same_bytes.Noise(seed, weights=1e-4))
    assert same_bytes.flips(quiet, loud)


def test_bytes_do_not_depend_on_the_kernels(small_run: Result, tmp_path: Path) -> None:
    expected = (small_run.folder / "SHA256SUMS").read_bytes()
    for number, kernels in enumerate(DISTANT):
        command = [sys.executable, "-m", "skylight_sh", "run", str(SMALL)]
        options = ["--store", str(tmp_path / f"a{number}"), "--reports", str(tmp_path / f"r{number}")]
        subprocess.run([*command, *options], cwd=ROOT, env={**os.environ, **kernels}, check=True, capture_output=True)
        assert (tmp_path / f"r{number}" / "small" / "SHA256SUMS").read_bytes() == expected


def test_provenance_is_in_the_record_alone_and_true(small_run: Result, tmp_path: Path) -> None:
    record = json.loads((small_run.folder / "run.json").read_text(encoding="utf-8"))
    assert set(record["computed_in"].values()) == {0}
    (environment,) = record["environments"]
    assert environment["blas"]
    assert environment["cpu_features"]
    for path in small_run.folder.rglob("*"):
        if path.is_file() and path.name != "run.json":
            data = path.read_bytes()
            assert environment["cpu_features"][0].encode() not in data, path
            assert b"openblas" not in data, path
    # A store filled by another kernel says so, in whoever's run.
    store, reports = tmp_path / "a", tmp_path / "r"
    command = [sys.executable, "-m", "skylight_sh", "run", str(SMALL), "--store", str(store), "--reports", str(reports)]
    disabled = "X86_V4 AVX512_ICL AVX512_SPR ASIMDHP ASIMDDP SVE"
    subprocess.run(
        command, cwd=ROOT, env={**os.environ, "NPY_DISABLE_CPU_FEATURES": disabled}, check=True, capture_output=True
    )
    one = json.loads((reports / "small" / "run.json").read_text(encoding="utf-8"))
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
    other = json.loads((reports / "small" / "run.json").read_text(encoding="utf-8"))
    assert other["environments"] == one["environments"]
    assert other["computed_in"] == one["computed_in"]
