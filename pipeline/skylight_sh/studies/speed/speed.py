"""The figures of speed that are released: medians and spread of a benchmark, and the machine they are from."""

from __future__ import annotations

import json
import os
import platform
import re
import subprocess
from collections.abc import Mapping
from pathlib import Path

from skylight_sh.runtime import Table
from skylight_sh.store import atomic
from skylight_sh.studies.page import Section
from skylight_sh.studies.speed.evaluation import LITERAL

FILE = "speed.json"
_RATIOS = ("times faster", "native times faster", "cold times faster")
_TIMES = ("ns", "native ns", "cold ns")


def save(folder: Path, section: Section, tables: Mapping[str, Table], repeats: int) -> None:
    """Write ``speed.json`` in ``folder``: the evaluation's rows of ``tables`` and of the paper's scheme, and the machine.

    Times are nanoseconds a call, medians over ``repeats`` rounds; ratios are to the paper's scheme of the same round, each
    with its ``median``, ``least`` and ``most``. Numbers have three digits.
    """
    found = []
    for row in section.rows:
        name = str(row["table"])
        if name in tables or name == LITERAL:
            times = {key.replace(" ", "_"): _three(row[key]) for key in _TIMES}
            ratios = {
                key.replace(" ", "_"): {
                    "median": _three(row[key]),
                    "least": _three(row[f"{key}, least"]),
                    "most": _three(row[f"{key}, most"]),
                }
                for key in _RATIOS
            }
            bands = tables[name].bands if name in tables else None
            found.append({"name": name, "bands": bands, "bytes": row["bytes"], **times, **ratios})
    record = {"machine": machine(), "rounds": repeats, "baseline": LITERAL, "tables": found}
    folder.mkdir(parents=True, exist_ok=True)
    atomic.write(folder / FILE, (json.dumps(record, indent=2) + "\n").encode())


def machine() -> dict[str, object]:
    """Return the processor's name, the number of cores, the system and the compiler's first line."""
    return {"processor": _processor(), "cores": os.cpu_count(), "system": platform.system(), "compiler": _compiler()}


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


def _three(value: object) -> float:
    return float(f"{value:.3g}")
