"""Where tasks run: Dask threads, Dask processes, or a Dask cluster by its address."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from functools import lru_cache, partial
from typing import Any, TypeVar

from threadpoolctl import threadpool_limits

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

    threads = executor == "threads"
    get: Any
    if threads:
        from dask.threaded import get
    else:
        from dask.multiprocessing import get
    task = function if threads else partial(_on_worker, function)
    graph = {("task", i): (task, item) for i, item in enumerate(items)}
    with threadpool_limits(1), Callback(posttask=count):
        return list(get(graph, list(graph), num_workers=workers or os.cpu_count() or 1))


def _on_cluster(function: Callable[[Item], Result], items: Sequence[Item], address: str, advance: Advance) -> list[Result]:
    from distributed import Client, as_completed

    with Client(address, timeout="10s", set_as_default=False) as client, client.as_current():
        futures = client.map(partial(_on_worker, function), list(items), pure=False)
        for done, _ in enumerate(as_completed(futures), start=1):
            advance(done, len(items))
        return list(client.gather(futures))


def _on_worker(function: Callable[[Item], Result], item: Item) -> Result:
    """Run a task in another process with BLAS on one thread: its sums must not depend on how many there are."""
    _limit_blas()
    return function(item)


@lru_cache(maxsize=1)
def _limit_blas() -> threadpool_limits:
    # For the worker's whole life: a limit undone by one of its threads would be undone for all of them.
    return threadpool_limits(1)
