"""Packed tables that are decoded once: what that costs, and what a call costs after it, where their headers can."""

from __future__ import annotations

import re

from skylight_sh.studies import compiled
from skylight_sh.studies.speed.candidate import Candidate

UNPACK, UNPACKED = "unpack", "unpacked table"
_MEMORY = """
static float bench_memory[{P}_UNPACKED];
"""
# Calls of the header's name stand for what is timed: decoding, or calls of what is decoded at the first one.
_CALLS = {
    UNPACK: """
static inline int bench_unpack(float weights[{P}_CHANNELS][{P}_WEIGHTS])
{{
    {p}_unpack(bench_memory);
    __asm__ volatile("" : : "g"(bench_memory) : "memory");
    weights[0][0] = bench_memory[0];
    return 0;
}}
#define {p}_weights({names}, weights) bench_unpack(weights)
""",
    UNPACKED: """
static int bench_is_unpacked;
static inline int bench_unpacked({parameters}, float weights[{P}_CHANNELS][{P}_WEIGHTS])
{{
    if (!bench_is_unpacked) {p}_unpack(bench_memory);
    bench_is_unpacked = 1;
    return {p}_unpacked_weights(bench_memory, {names}, weights);
}}
#define {p}_weights bench_unpacked
""",
}


def unpacked(name: str, header: str, inputs: int, bands: int) -> dict[str, Candidate]:
    """Return decoding the packed table ``name``, and calls after it, by name; nothing where ``header`` has no such calls.

    Their bytes are those of the memory they write and read.
    """
    prefix = compiled.PREFIX
    size = re.search(rf"#define {prefix.upper()}_UNPACKED (\d+)", header)
    if not size or f"{prefix}_unpacked_weights(" not in header:
        return {}
    names = [f"v{i}" for i in range(inputs)]
    values = {"p": prefix, "P": prefix.upper(), "names": ", ".join(names)}
    values["parameters"] = ", ".join(f"float {name}" for name in names)
    memory, taken = _MEMORY.format(**values), 4 * int(size[1])
    calls = {what: header + memory + call.format(**values) for what, call in _CALLS.items()}
    return {f"{name}: {what}": Candidate(text, taken, bands, what) for what, text in calls.items()}
