"""Fuzz headers: ``python -m skylight_sh.studies.stability.fuzz COUNT [NPZ..]`` calls each with any bits.

Builds have sanitizers, or -ffast-math. Every input's returned code is held against a classification of its bits alone;
weights must be finite, bounded, and zero where they should be; fewer bands must give the same weights as all. The tables
are one of every kind (``flavours``) and any NPZ given. Needs gcc and clang.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from skylight_sh import runtime
from skylight_sh.export import c_header
from skylight_sh.export.template import template
from skylight_sh.runtime import Runtime, Table
from skylight_sh.studies.stability.flavours import flavours

_SANITIZE = "-fsanitize=address,undefined,float-cast-overflow,float-divide-by-zero -fno-sanitize-recover=all"
BUILDS = {
    "gcc, sanitizers": f"gcc -std=c99 -O2 -g {_SANITIZE}",
    "clang, sanitizers": f"clang -std=c99 -O2 -g {_SANITIZE}",
    "gcc, fast-math": "gcc -std=c99 -O3 -ffast-math",
    "clang, fast-math": "clang -std=c99 -O3 -ffast-math",
}
# Of these `main` runs two; the tests run all, shortly.
LONG = ("clang, sanitizers", "gcc, fast-math")
_PREFIX = "fuzz_sh"
_FACTS = c_header.Facts("fuzz", 0.0, 0.0, "per-set", [])
# Weights at random sets come this close to the largest there is; an infinity or a wild number does not.
_SANE = 4.0
# Float32 bits of +infinity: every finite float ranks below.
_INFINITE = 0x7F800000


def source(table: Table) -> str:
    """Return the C program that fuzzes ``table``'s header."""
    rng = np.random.default_rng(1)
    # Half of each axis's values at its ends, where weights tend to be largest.
    values = [
        np.clip(rng.uniform(1.5 * a.low - 0.5 * a.high, 1.5 * a.high - 0.5 * a.low, 500), a.low, a.high) for a in table.axes
    ]
    weights = Runtime(table).weights(values[0], rng.uniform(-4, 4, 500), *values[1:])
    axes = [
        {
            "first": _end(table, i, -1),
            "last": _end(table, i, 1),
            "low": f"{np.float32(low):.9e}f",
            "high": f"{np.float32(high):.9e}f",
        }
        for i, (low, high) in enumerate(table.ranges)
    ]
    azimuth = {"first": 1 - _INFINITE, "last": _INFINITE - 1, "low": "-1e1f", "high": "1e1f"}
    return template("fuzz.c.j2").render(
        p=_PREFIX,
        P=_PREFIX.upper(),
        inputs=[axes[0], azimuth, *axes[1:]],
        largest=hex(int(np.float32(_SANE * np.abs(weights).max()).view(np.uint32))),
        arguments=", ".join(f"in[{i}]" for i in range(len(axes) + 1)),
    )


def build(table: Table, folder: Path, command: str) -> Path:
    """Compile the fuzzer of ``table`` with ``command`` in ``folder``; return the program. Raises OSError where it fails."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "skylight_sh.h").write_text(c_header.write(table, _FACTS, _PREFIX), encoding="utf-8")
    (folder / "fuzz.c").write_text(source(table), encoding="utf-8")
    done = subprocess.run(
        [*command.split(), "fuzz.c", "-o", "fuzz", "-lm"], cwd=folder, capture_output=True, text=True, check=False
    )
    if done.returncode:
        raise OSError(f"{command} failed: {done.stderr[:2000]}")
    return folder / "fuzz"


def run(program: Path, count: int, seed: int) -> tuple[bool, str]:
    """Return whether ``count`` inputs passed, and what the program said."""
    done = subprocess.run([str(program), str(count), str(seed)], capture_output=True, text=True, check=False)
    return done.returncode == 0, done.stdout + done.stderr[:4000]


def _end(table: Table, axis: int, sign: int) -> int:
    """Return the rank of the outermost float32 that ``table`` takes for inside, found by bisection."""
    middle = [(a.low + a.high) / 2 for a in table.axes]
    inside = _rank(np.float32(middle[axis]))
    outside = sign * _INFINITE
    while abs(outside - inside) > 1:
        between = (inside + outside) // 2
        value = np.uint32(abs(between)).view(np.float32) * np.float32(1 if between >= 0 else -1)
        beyond = table.clamp(np.array([[*middle[:axis], float(value), *middle[axis + 1 :]]]))[1][0]
        inside, outside = (inside, between) if beyond else (between, outside)
    return inside


def _rank(value: np.float32) -> int:
    bits = int(value.view(np.uint32))
    return -(bits & 0x7FFFFFFF) if bits >> 31 else bits


def main(count: int, files: list[str]) -> int:
    """Fuzz every table in every build, on all cores; return the process's exit code."""
    tables = flavours() | {Path(file).parent.name: runtime.read(file) for file in files}
    cores = os.cpu_count() or 1
    failed = False
    with tempfile.TemporaryDirectory() as place, ThreadPoolExecutor(cores) as pool:
        for name, table in tables.items():
            for number, label in enumerate(LONG):
                start = time.perf_counter()
                program = build(table, Path(place) / name / str(number), BUILDS[label])
                parts = [count // cores + (k < count % cores) for k in range(cores)]
                seeds = range(number * cores + 1, (number + 1) * cores + 1)
                for good, text in pool.map(run, [program] * cores, parts, seeds):
                    failed |= not good
                    print(f"{name}, {label}: {text.strip()}")
                print(f"{name}, {label}: {time.perf_counter() - start:.1f} s", flush=True)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(int(float(sys.argv[1])), sys.argv[2:]))
