"""Progress for people: a bar on a terminal, nothing elsewhere."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from skylight_sh.run.executors import Advance


@contextmanager
def bar(title: str) -> Iterator[Advance]:
    """Show ``title``, a bar, the share done and the time left while the block runs; yields ``advance(done, total)``."""
    if not sys.stderr.isatty():
        yield _silent
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn

    columns = (
        TextColumn("{task.description:<22}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("elapsed"),
        TimeElapsedColumn(),
        TextColumn("left"),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task(title, total=None)
        yield lambda done, total: progress.update(task, completed=done, total=total)
        progress.stop_task(task)


@contextmanager
def silent(_: str) -> Iterator[Advance]:
    """Show nothing."""
    yield _silent


def _silent(_: int, __: int) -> None:
    """Tell nobody."""
