"""A process that runs chosen tests of a copy, again and again, each time in a child that starts with libraries loaded.

Reads one JSON object a line: ``tests``, a file for the plugin ``ordering``; ``files``, the test modules to collect;
``seconds``, the limit; ``log``, where pytest's output goes. Answers with pytest's exit code, or what ended it, a line each.
"""

from __future__ import annotations

import contextlib
import importlib
import json
import os
import signal
import sys
import time
import traceback
from typing import Any

# Whatever takes long to import, and nothing of the copy itself.
LIBRARIES = (
    *("numpy", "scipy.linalg", "scipy.optimize", "scipy.integrate", "scipy.special", "scipy.interpolate", "scipy.spatial"),
    *("h5py", "pandas", "matplotlib.figure", "jinja2", "pydantic", "rich.progress", "click", "dask.threaded"),
    *("hypothesis.strategies", "hypothesis.extra.numpy", "pytest", "threadpoolctl"),
)

# Libraries that are loaded have no assertions that pytest could rewrite.
_LOADED_BEFORE = "ignore::pytest.PytestAssertRewriteWarning"
# Exit codes of the child beside pytest's own, 0 to 5.
TOO_LONG, BROKEN = 64, 70


def main() -> None:
    # Ended from outside, it takes the child along.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    for name in LIBRARIES:
        try:
            importlib.import_module(name)
        except ImportError:
            continue
    # An example that fails is enough; the smallest one would take long to find.
    importlib.import_module("hypothesis.internal.conjecture.engine").MAX_SHRINKING_SECONDS = 0
    for line in sys.stdin:
        job = json.loads(line)
        child = os.fork()
        if not child:
            _run(job)
        print(_wait(child, job["seconds"]), flush=True)


def _run(job: dict[str, Any]) -> None:
    """Be the child: run the tests and end."""
    os.setsid()
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    log = os.open(str(job["log"]), os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    os.dup2(log, 1)
    os.dup2(log, 2)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    os.environ["MUTANT_TESTS"] = str(job["tests"])
    code = BROKEN
    try:
        import pytest

        options = ["-x", "-q", "-m", "", "--tb=line", "--no-header", "-p", "mutants.ordering", "-W", _LOADED_BEFORE]
        code = int(pytest.main([*options, *job["files"]]))
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        os._exit(code)


def _wait(child: int, seconds: float) -> int:
    """Return the child's exit code, negative for a signal; a child that takes too long is killed with all it started."""
    until = time.monotonic() + seconds
    try:
        while time.monotonic() < until:
            done, status = os.waitpid(child, os.WNOHANG)
            if done:
                return os.waitstatus_to_exitcode(status)
            time.sleep(0.01)
        return TOO_LONG
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(child, signal.SIGKILL)
        with contextlib.suppress(ChildProcessError):
            os.waitpid(child, 0)


if __name__ == "__main__":
    main()
