"""A pytest plugin that records which lines and templates each test, shared fixture and test module runs, and for how long.

The environment names the file to write and the parts to watch: RECORD_TO, and RECORD_SOURCES, a list of folders.
"""

from __future__ import annotations

import json
import os
import time
from collections.abc import Generator
from pathlib import Path

import coverage
import jinja2
import pytest
from skylight_sh.export import evaluators


class Recorder:
    """What was seen so far. Contexts are ``test ID``, ``fixture NAME`` and ``module FILE``."""

    def __init__(self, config: pytest.Config) -> None:
        self.root = config.rootpath
        self.coverage = coverage.Coverage(data_file=None, source=json.loads(os.environ["RECORD_SOURCES"]), config_file=False)
        self.coverage.start()
        self.context = ""
        self.templates: dict[str, set[str]] = {}
        self.seconds: dict[str, float] = {}
        self.fixtures: dict[str, list[str]] = {}
        self.failed: set[str] = set()
        self.tools: set[str] = set()
        self._watch_templates()

    def _watch_templates(self) -> None:
        load = jinja2.Environment._load_template
        render = jinja2.Template.render

        def loaded(environment: jinja2.Environment, name: object, *rest: object) -> jinja2.Template:
            self.templates.setdefault(str(name), set()).add(self.context)
            return load(environment, name, *rest)

        def rendered(template: jinja2.Template, *parts: object, **named: object) -> str:
            self.templates.setdefault(str(template.name), set()).add(self.context)
            return render(template, *parts, **named)

        part = evaluators.part

        def read(path: str, *rest: object) -> str:
            self.templates.setdefault(Path(path).name, set()).add(self.context)
            return part(path, *rest)

        # Before the modules that call it import it.
        evaluators.part = read
        jinja2.Environment._load_template = loaded
        jinja2.Template.render = rendered

    def switch(self, context: str) -> str:
        """Name what runs from here on; return what ran before."""
        before, self.context = self.context, context
        self.coverage.switch_context(context)
        return before

    @pytest.hookimpl(wrapper=True)
    def pytest_make_collect_report(self, collector: pytest.Collector) -> Generator[None, object, object]:
        before = self.switch(f"module {collector.nodeid}" if isinstance(collector, pytest.Module) else self.context)
        try:
            return (yield)
        finally:
            self.switch(before)

    @pytest.hookimpl(wrapper=True)
    def pytest_fixture_setup(self, fixturedef: pytest.FixtureDef[object]) -> Generator[None, object, object]:
        if fixturedef.scope == "function":
            return (yield)
        before, start = self.switch(f"fixture {fixturedef.argname}"), time.perf_counter()
        try:
            return (yield)
        finally:
            name = f"fixture {fixturedef.argname}"
            self.seconds[name] = self.seconds.get(name, 0.0) + time.perf_counter() - start
            self.switch(before)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Generator[None, object, object]:
        self.fixtures[item.nodeid] = list(getattr(item, "fixturenames", []))
        if item.get_closest_marker("tools"):
            self.tools.add(item.nodeid)
        self.switch(f"test {item.nodeid}")
        start = time.perf_counter()
        try:
            return (yield)
        finally:
            self.seconds[f"test {item.nodeid}"] = time.perf_counter() - start
            self.switch("")

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if report.failed:
            self.failed.add(report.nodeid)

    def pytest_sessionfinish(self) -> None:
        self.coverage.stop()
        data = self.coverage.get_data()
        lines = {
            Path(file).relative_to(self.root).as_posix(): {
                str(line): contexts for line, contexts in data.contexts_by_lineno(file).items()
            }
            for file in data.measured_files()
        }
        found = {
            "lines": lines,
            "templates": {name: sorted(contexts) for name, contexts in self.templates.items()},
            "seconds": self.seconds,
            "fixtures": self.fixtures,
            "failed": sorted(self.failed),
            "tools": sorted(self.tools),
        }
        Path(os.environ["RECORD_TO"]).write_text(json.dumps(found), encoding="utf-8")


def pytest_configure(config: pytest.Config) -> None:
    config.pluginmanager.register(Recorder(config))
