"""Conformance: every header against its test vectors, across compilers, standards, flags and machines."""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, SMALL, run_quietly
from skylight_sh import runtime
from skylight_sh.config import load
from skylight_sh.export import c_header, vectors
from skylight_sh.runtime import Table
from skylight_sh.studies.stability.flavours import flavours

pytestmark = pytest.mark.tools

REFERENCE = ROOT / "reports" / "reference" / "export"
TABLES = {
    **flavours(),
    "released": runtime.read(REFERENCE / "skylight_sh.npz"),
    "released-packed": runtime.read(REFERENCE / "7-bands-0.1pct-packed" / "skylight_sh.npz"),
}
FACTS = c_header.Facts("conformance", 0.0, 0.0, "per-set", [])
STRICT = "-Wall -Wextra -Wconversion -Wshadow -pedantic -Werror"
# Of clang's every warning all but: old compilers' limits, C as seen from C++, and buffers, comparisons and layouts as such.
EVERYTHING = "-Weverything -Werror -Wno-declaration-after-statement -Wno-padded -Wno-unknown-warning-option " + (
    "-Wno-unsafe-buffer-usage -Wno-c++98-compat-pedantic -Wno-old-style-cast -Wno-zero-as-null-pointer-constant"
)
SANITIZE = "-g -fsanitize=address,undefined -fno-sanitize-recover=all"
X86 = {
    "gcc x86-64": "gcc -std=c99 -O3 -march=x86-64",
    "gcc x86-64-v3, contracted": "gcc -std=c11 -O3 -march=x86-64-v3 -ffp-contract=fast",
    "gcc x86-64-v3, fast-math": "gcc -std=c11 -O3 -march=x86-64-v3 -ffast-math",
    "clang x86-64-v3, contracted": "clang -std=c17 -O3 -march=x86-64-v3 -ffp-contract=fast",
}
BUILDS = {
    "gcc c99 -O0": f"gcc -std=c99 -O0 {STRICT}",
    "gcc c11 -O1": f"gcc -std=c11 -O1 {STRICT}",
    "gcc c17 -O2": f"gcc -std=c17 -O2 -ffp-contract=off {STRICT}",
    "gcc -O3, native, contracted": "gcc -std=c11 -O3 -march=native -ffp-contract=fast",
    "gcc -O3, native, fast-math": "gcc -std=c11 -O3 -march=native -ffast-math",
    "gcc -O3, fast-math": "gcc -std=c99 -O3 -ffast-math",
    "gcc, sanitizers": f"gcc -std=c99 -O1 {SANITIZE}",
    "clang c99 -O0": f"clang -std=c99 -O0 {EVERYTHING}",
    "clang c17 -O2": f"clang -std=c17 -O2 -ffp-contract=off {EVERYTHING}",
    "clang -O3, native, contracted": "clang -std=c11 -O3 -march=native -ffp-contract=fast",
    "clang -O3, native, fast-math": "clang -std=c11 -O3 -march=native -ffast-math",
    "clang, sanitizers": f"clang -std=c11 -O1 {SANITIZE}",
    "clang, memory": "clang -std=c11 -O1 -g -fsanitize=memory -fno-sanitize-recover=all",
    "g++ c++11": f"g++ -x c++ -std=c++11 -O2 {STRICT}",
    "g++ c++14": f"g++ -x c++ -std=c++14 -O1 {STRICT}",
    "g++ c++20": f"g++ -x c++ -std=c++20 -O3 {STRICT}",
    "clang++ c++17": f"clang++ -x c++ -std=c++17 -O2 {EVERYTHING}",
    "clang++ c++20, fast-math": f"clang++ -x c++ -std=c++20 -O3 -ffast-math {STRICT}",
    "arm64 -O2": f"aarch64-linux-gnu-gcc -static -std=c99 -O2 {STRICT}",
    "arm64 -O3, fast-math": "aarch64-linux-gnu-gcc -static -std=c11 -O3 -ffast-math",
    **(X86 if platform.machine() == "x86_64" else {}),
}
# The rest of the tables differ from these in numbers more than in code.
FULL = ("rows", "packed", "float64", "one-axis", "unmirrored")
BRIEF = ("gcc c17 -O2", "gcc -O3, fast-math", "clang, sanitizers", "arm64 -O2")
TOOLS = ("gcc", "g++", "clang", "clang++", "aarch64-linux-gnu-gcc", "qemu-aarch64")
CORES = os.cpu_count() or 1


def write(table: Table, folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "skylight_sh.h").write_text(c_header.write(table, FACTS), encoding="utf-8")
    (folder / "skylight_sh_vectors.txt").write_text(vectors.write(table), encoding="utf-8")
    (folder / "skylight_sh_selftest.c").write_text(vectors.self_test(table), encoding="utf-8")


def self_test(folder: Path, command: str, number: int = 0) -> tuple[int, str]:
    """Compile the self-test in ``folder`` and run it, on an emulator where need be; return its exit code and its words."""
    program = f"selftest{number}"
    made = subprocess.run(
        [*command.split(), "skylight_sh_selftest.c", "-o", program, "-lm"],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )
    if made.returncode:
        return made.returncode, made.stderr[:3000]
    if "x86-64-v3" in command and not {"avx2", "fma"} <= set(Path("/proc/cpuinfo").read_text(encoding="utf-8").split()):
        return 0, "compiled alone: this processor cannot run it"
    emulator = ["qemu-aarch64"] if command.startswith("aarch64") else []
    run = subprocess.run(
        [*emulator, f"./{program}", "skylight_sh_vectors.txt"],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )
    return run.returncode, run.stdout + run.stderr[:3000]


def test_tools_are_there() -> None:
    assert [tool for tool in TOOLS if not shutil.which(tool)] == [], "install what .ci/run installs"


def test_every_build_passes_its_self_test(tmp_path: Path) -> None:
    for name, table in TABLES.items():
        write(table, tmp_path / name)
    cases = [(name, label) for name in TABLES for label in (BUILDS if name in FULL else BRIEF)]
    with ThreadPoolExecutor(CORES) as pool:
        done = pool.map(lambda k: self_test(tmp_path / cases[k][0], BUILDS[cases[k][1]], k), range(len(cases)))
        results = dict(zip(cases, done, strict=True))
    assert {case: text for case, (code, text) in results.items() if code} == {}
    for (name, label), (_, text) in results.items():
        print(f"{name} | {label} | {text.splitlines()[-1]}")


@pytest.mark.parametrize("name", TABLES)
def test_vectors_hold_what_a_reader_is_told(name: str) -> None:
    text = vectors.write(TABLES[name])
    assert text == vectors.write(TABLES[name])
    assert len(text) < 300_000
    keys = dict(line.split() for line in text.splitlines()[:7])
    inputs, channels, weights = (int(keys[key]) for key in ("inputs", "channels", "weights"))
    numbers = np.array(text.split()[14:], dtype=np.float32).reshape(int(keys["vectors"]), -1)
    assert numbers.shape[1] == inputs + 1 + channels * weights
    status = numbers[:, inputs]
    assert set(status.tolist()) == {0, 1, 2}
    assert not numbers[status == 2, inputs + 1 :].any()
    expected, _ = runtime.Runtime(TABLES[name]).weights_and_status(*numbers[:, :inputs].T)
    assert np.array_equal(numbers[:, inputs + 1 :], expected.reshape(len(numbers), -1).astype(np.float32))
    assert float(keys["largest"]) == pytest.approx(np.abs(expected).max())


def test_a_wrong_header_fails_its_self_test(tmp_path: Path) -> None:
    write(TABLES["one-axis"], tmp_path)
    header = (tmp_path / "skylight_sh.h").read_text(encoding="utf-8")
    faults = {
        "a last bit of status": header.replace("(v > skylight_sh_inside", "(v >= skylight_sh_inside"),
        "a weight off by 1e-5": header.replace(
            "    return status;\n}\n\n/* One of many suns",
            "    weights[0][1] *= 1.00001f;\n    return status;\n}\n\n/* One of many suns",
        ),
        "NaN by comparison": header.replace("(bits >= 0x7f800000u) + (bits > 0x7f800000u)", "v != v ? 2 : 0"),
    }
    for number, (fault, text) in enumerate(faults.items()):
        assert text != header
        (tmp_path / "skylight_sh.h").write_text(text, encoding="utf-8")
        code, words = self_test(tmp_path, "gcc -std=c99 -O2", number)
        assert (code, "failed" in words) == (1, True), (fault, words)
    write(TABLES["float64"], tmp_path / "other")
    shutil.copy(tmp_path / "other" / "skylight_sh_vectors.txt", tmp_path)
    assert self_test(tmp_path, "gcc -std=c99 -O2")[0] == 2


@pytest.mark.parametrize("scene", ["", "[scene]\nazimuth = 0.7\n"])
def test_the_export_publishes_vectors_where_asked(tmp_path: Path, scene: str) -> None:
    asked = '[export]\ntargets = ["c", "npz", "vectors"]\nprefix = "day_sh"'
    text = SMALL.read_text(encoding="utf-8").replace("[export]", f"{scene}{asked}")
    (tmp_path / "asked.toml").write_text(text, encoding="utf-8")
    result = run_quietly(load(tmp_path / "asked.toml"), tmp_path)
    for row in result.summary["tables"]:
        code, words = self_test(result.folder / row["path"], "gcc -std=c99 -O2")
        assert (code, " 0 failed" in words) == (0, True), words
