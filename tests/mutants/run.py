"""Trying mutants: each is written into a copy of the repository, its tests run there, and the file is put back."""

from __future__ import annotations

import json
import queue
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from . import concern
from .generate import Mutant
from .worker import BROKEN, TOO_LONG

# Seconds of tests in the first round; most mutants need no second one, whose modules are then never imported.
_FIRST_ROUND = 2.0
_PASSED, _INTERNAL_ERROR, _NOTHING_RAN = 0, 3, 5


@dataclass(frozen=True)
class Outcome:
    """What became of a mutant: ``killed``, or a survivor of ``asked`` tests; ``how`` says by what."""

    mutant: Mutant
    killed: bool
    asked: int
    how: str


def copy(root: Path, place: Path) -> Path:
    """Copy the repository's files to ``place`` and return it."""
    for path in concern.files(root):
        (place / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(root / path, place / path)
    return place


class Worker:
    """A copy of the repository with a process that runs its tests."""

    def __init__(self, place: Path) -> None:
        self.place = place
        self.tests, self.log = place.with_suffix(".tests.json"), place.with_suffix(".log")
        self.process = subprocess.Popen(
            [sys.executable, "-m", "mutants.worker"],
            cwd=place,
            env=concern.environment(place),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    def close(self) -> None:
        """End the process, and what it runs."""
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.process.terminate()
        self.process.wait()
        self.process.stdin.close()
        self.process.stdout.close()

    def run(self, tests: Sequence[tuple[str, float]]) -> int:
        """Run tests, given with the seconds each takes, in this order; return pytest's exit code."""
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.tests.write_text(json.dumps(list(tests)), encoding="utf-8")
        job: dict[str, Any] = {
            "tests": str(self.tests),
            "files": list(dict.fromkeys(test.split("::")[0] for test, _ in tests)),
            "seconds": 120.0 + 10.0 * sum(seconds for _, seconds in tests),
            "log": str(self.log),
        }
        self.process.stdin.write(json.dumps(job) + "\n")
        self.process.stdin.flush()
        return int(self.process.stdout.readline())

    def attempt(self, mutant: Mutant, tests: Sequence[tuple[str, float]]) -> Outcome:
        """Return what the tests, the cheapest first, say of a mutant."""
        file = self.place / mutant.path
        source = file.read_bytes()
        try:
            self._write(file, mutant.applied(source))
            for some in _rounds(tests):
                code = self.run(some)
                if code in (BROKEN, _INTERNAL_ERROR):
                    raise RuntimeError(f"The tests could not be run:\n{self.log.read_text(errors='replace')}")
                if code == TOO_LONG:
                    return Outcome(mutant, True, len(tests), "takes too long")
                if code not in (_PASSED, _NOTHING_RAN):
                    return Outcome(mutant, True, len(tests), self._failure(code))
        finally:
            self._write(file, source)
        return Outcome(mutant, False, len(tests), f"{len(tests)} tests pass" if tests else "no test runs it")

    def _write(self, file: Path, contents: bytes) -> None:
        """Write a source file; its compiled form would count as new where size and second are the same."""
        for compiled in (file.parent / "__pycache__").glob(f"{file.stem}.*"):
            compiled.unlink()
        file.write_bytes(contents)

    def _failure(self, code: int) -> str:
        found = [line for line in self.log.read_text(errors="replace").splitlines() if line.startswith(("FAILED", "ERROR"))]
        return found[0].split(" - ")[0].split(" ", 1)[1] if found else f"exit code {code}"


def _rounds(tests: Sequence[tuple[str, float]]) -> list[list[tuple[str, float]]]:
    total, first = 0.0, 0
    while first < len(tests) and total + tests[first][1] <= _FIRST_ROUND:
        total += tests[first][1]
        first += 1
    return [list(part) for part in (tests[:first], tests[first:]) if part]


def attempt_all(
    places: Sequence[Path],
    drawn: Sequence[Mutant],
    tests_of: Callable[[Mutant], Sequence[tuple[str, float]]],
    say: Callable[[str], None],
) -> list[Outcome]:
    """Try all mutants, one worker a copy, and return their outcomes in the mutants' order."""
    waiting: queue.SimpleQueue[tuple[int, Mutant]] = queue.SimpleQueue()
    for pair in enumerate(drawn):
        waiting.put(pair)
    found: dict[int, Outcome] = {}

    def work(worker: Worker) -> None:
        while True:
            try:
                at, mutant = waiting.get_nowait()
            except queue.Empty:
                return
            start = time.monotonic()
            outcome = found[at] = worker.attempt(mutant, tests_of(mutant))
            what = "killed  " if outcome.killed else "SURVIVED"
            took = f"{time.monotonic() - start:.1f} s, {outcome.how}"
            say(f"[{len(found)}/{len(drawn)}] {what} {mutant.path}:{mutant.line} ({took})")
            if not outcome.killed:
                say(f"    - {mutant.before}\n    + {mutant.after}")

    workers = [Worker(place) for place in places]
    with ThreadPoolExecutor(len(workers)) as pool:
        try:
            for done in [pool.submit(work, worker) for worker in workers]:
                done.result()
        finally:
            # After a failure or Ctrl-C too: the other worker's wait then ends.
            while not waiting.empty():
                waiting.get()
            for worker in workers:
                worker.close()
    return [found[at] for at in range(len(drawn))]
