"""The figures of speed that are released: medians and spread of a benchmark, and the machine they are from."""

from __future__ import annotations

import json
import os
import platform
import re
import subprocess
from pathlib import Path

from skylight_sh.store import atomic
from skylight_sh.studies.speed.contest import LITERAL, OURS, WELL_WRITTEN, Contest
from skylight_sh.studies.timing import Spread

FILE = "speed.json"


def save(folder: Path, contest: Contest) -> None:
    """Write ``speed.json`` in ``folder``: every candidate's times and every table's ratios to its rivals, and the machine.

    Times are nanoseconds a call; ratios say how many times as long the rival takes, so that below 1 it wins. Each has its
    ``median``, its quartiles ``low`` and ``high``, and says whether it is ``noisy``. Numbers have three digits.
    """
    dropped, timings = contest.timings
    candidates = []
    for name, candidate in contest.candidates.items():
        times = {}
        for build, result in contest.results.items():
            times[build] = {"ns": spread(result.warm.time(name), 1e9)}
            if result.cold:
                times[build]["cold_ns"] = spread(result.cold.time(name), 1e9)
        candidates.append(
            {
                "name": name,
                "kind": candidate.kind,
                "rival_of": candidate.rival_of,
                "bands": candidate.bands,
                "bytes": candidate.bytes,
                "code": contest.code[name],
                "e_mean": three(error) if (error := contest.errors[name]) is not None else None,
                "times": times,
            }
        )
    record = {
        "machine": machine(),
        "rounds": contest.rounds,
        "timings": timings,
        "dropped": dropped,
        "literal": LITERAL,
        "well_written": WELL_WRITTEN,
        "candidates": candidates,
        "rivals": rivals(contest),
    }
    folder.mkdir(parents=True, exist_ok=True)
    atomic.write(folder / FILE, (json.dumps(record, indent=2) + "\n").encode())


def rivals(contest: Contest) -> list[dict[str, object]]:
    """Return each table against each of its rivals: ratios of bytes, and of times by build."""
    found = []
    for name, candidate in contest.candidates.items():
        for rival in contest.rivals(name) if candidate.kind in OURS else []:
            ratios = {}
            for build, result in contest.results.items():
                ratios[build] = {"warm": spread(result.warm.times_faster(name, rival))}
                if result.cold:
                    ratios[build]["cold"] = spread(result.cold.times_faster(name, rival))
            size = three(contest.candidates[rival].bytes / candidate.bytes)
            found.append({"table": name, "rival": rival, "bytes": size, "times": ratios})
    return found


def spread(found: Spread, unit: float = 1.0) -> dict[str, object]:
    """Return a figure as the file has it."""
    numbers = {key: three(unit * getattr(found, key)) for key in ("median", "low", "high")}
    return {**numbers, "noisy": found.noisy}


def machine() -> dict[str, object]:
    """Return the processor's name, the number of cores, the system and the compiler's first line."""
    return {"processor": _processor(), "cores": os.cpu_count(), "system": platform.system(), "compiler": _compiler()}


def three(value: float) -> float:
    """Return a number to three digits.

    >>> three(123456.0)
    123000.0
    """
    return float(f"{value:.3g}")


def _processor() -> str:
    try:
        told = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        told = ""
    named = re.search(r"^model name\s*:\s*(.+)$", told, re.MULTILINE)
    return named[1].strip() if named else platform.processor() or platform.machine()


def _compiler() -> str:
    told = subprocess.run(["cc", "--version"], capture_output=True, text=True, check=False)
    return told.stdout.splitlines()[0] if told.stdout else "cc"
