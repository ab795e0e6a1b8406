"""A pytest plugin that keeps the tests a file names, in its order, and ends a test that takes far longer than it should.

The environment variable MUTANT_TESTS names the file: JSON, pairs of a test and its seconds.
"""

from __future__ import annotations

import json
import os
import signal
from collections.abc import Generator
from pathlib import Path

import pytest

from .worker import TOO_LONG

# Of a test's own time and beside it: others may be busy on the machine.
_TIMES, _SECONDS = 10.0, 30.0


class Ordering:
    def __init__(self) -> None:
        pairs = json.loads(Path(os.environ["MUTANT_TESTS"]).read_text(encoding="utf-8"))
        self.seconds: dict[str, float] = dict(pairs)
        self.places = {test: place for place, (test, _) in enumerate(pairs)}

    def pytest_collection_modifyitems(self, config: pytest.Config, items: list[pytest.Item]) -> None:
        kept = [item for item in items if item.nodeid in self.places]
        config.hook.pytest_deselected(items=[item for item in items if item.nodeid not in self.places])
        items[:] = sorted(kept, key=lambda item: self.places[item.nodeid])

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Generator[None, object, object]:
        signal.signal(signal.SIGALRM, lambda *_: os._exit(TOO_LONG))
        signal.alarm(int(_SECONDS + _TIMES * self.seconds[item.nodeid]))
        try:
            return (yield)
        finally:
            signal.alarm(0)


def pytest_configure(config: pytest.Config) -> None:
    config.pluginmanager.register(Ordering())
