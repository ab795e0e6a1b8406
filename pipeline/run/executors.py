"""Where tasks run: Dask threads, Dask processes, or a Dask cluster by its address."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from functools import lru_cache, partial
from typing import Any, TypeVar

from threadpoolctl import ThreadpoolController

Item = TypeVar("Item")
Result = TypeVar("Result")
Advance = Callable[[int, int], None]


def map_tasks(
    function: Callable[[Item], Result], items: Sequence[Item], *, executor: str, workers: int, advance: Advance
) -> list[Result]:
    """Apply ``function`` to each item and return the results in the items' order, whoever finished first.

    ``executor`` is ``threads``, ``processes`` or a scheduler's address; ``workers`` 0 means one a core (a cluster has its
    own). ``advance(done, total)`` is told of progress. Raises what a task raised, or OSError where no
    scheduler answers.
    """
    if "://" in executor:
        return _on_cluster(function, items, executor, advance)
    from dask.callbacks import Callback

    done = 0

    def count(*_: object) -> None:
        nonlocal done
        done += 1
        advance(done, len(items))

    get: Any
    if executor == "threads":
        from dask.threaded import get
    else:
        from dask.multiprocessing import get
    graph = {("task", i): (_single_threaded, function, item) for i, item in enumerate(items)}
    with Callback(posttask=count):
        return list(get(graph, list(graph), num_workers=workers or os.cpu_count() or 1))


def _on_cluster(function: Callable[[Item], Result], items: Sequence[Item], address: str, advance: Advance) -> list[Result]:
    from distributed import Client, as_completed

    with Client(address, timeout="10s", set_as_default=False) as client:
        futures = client.map(partial(_single_threaded, function), list(items), pure=False)
        for done, _ in enumerate(as_completed(futures), start=1):
            advance(done, len(items))
        return list(client.gather(futures))


def _single_threaded(function: Callable[[Item], Result], item: Item) -> Result:
    """Run a task with BLAS on one thread: its sums must not depend on how many there are."""
    with _pools().limit(limits=1):
        return function(item)


@lru_cache(maxsize=1)
def _pools() -> ThreadpoolController:
    return ThreadpoolController()
