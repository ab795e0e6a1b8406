"""How long the shipped configs take, from nothing, in seconds of processors: other work on the machine hardly moves them."""

from __future__ import annotations

import resource
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from skylight_sh.studies.speed.speed import machine

FILE = "times.json"


def measure(names: Iterable[str]) -> dict[str, Any]:
    """Return ``machine`` and ``seconds``: of processors, whole ones, that `skylight-sh run NAME` takes in an empty folder.

    Raises subprocess.CalledProcessError where a run fails, as those do that lack their extra.
    """
    return {"machine": machine(), "seconds": {name: _of(name) for name in names}}


def _of(name: str) -> int:
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "skylight_sh", "run", name]
        subprocess.run(command, cwd=Path(folder), check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return round(after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)
