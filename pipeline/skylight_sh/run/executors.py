"""Where tasks run: Dask threads, Dask processes, or a Dask cluster by its address.

A worker in another process is believed only where its fingerprint is this process's: a cluster's workers are asked before
the first task, and every worker asks itself before each task, since workers come and go.
"""

from __future__ import annotations

import os
import traceback
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any, TypeVar

from skylight_sh import UserError
from skylight_sh.run.blas import one_thread
from skylight_sh.run.fingerprint import Fingerprint, differences, fingerprint, in_use

Item = TypeVar("Item")
Result = TypeVar("Result")
Advance = Callable[[int, int], None]

_REMEDY = (
    "Install the same skylight-sh, Python and libraries there as here and start the worker anew; or use the executor threads"
)


class WorkerError(UserError, RuntimeError):
    """A worker has other code or libraries than this process, or cannot work at all; none of its results are used."""

    code = 1


class _StoppedError(Exception):
    """One answer ended the work: ``error`` says why."""

    def __init__(self, error: Exception) -> None:
        super().__init__(str(error))
        self.error = error


@dataclass(frozen=True)
class _Answer:
    """What a worker sends back: who it is, its fingerprint, and the task's result or what it raised."""

    worker: str
    found: Fingerprint
    result: Any = None
    error: Exception | None = None


def map_tasks(
    function: Callable[[Item], Result],
    items: Sequence[Item],
    *,
    executor: str,
    workers: int,
    advance: Advance,
    finished: Callable[[int, Result], None] | None = None,
) -> list[Result]:
    """Apply ``function`` to each item and return the results in the items' order, whoever finished first.

    ``executor`` is ``threads``, ``processes`` or a scheduler's address; ``workers`` 0 means one a core (a cluster has its
    own). ``advance(done, total)`` is told of progress; ``finished(place, result)`` is called in this process as soon as the
    item at a place is done, before it counts as such. Raises what a task raised, WorkerError where a worker would compute
    otherwise than this process, or OSError where no scheduler answers.
    """
    try:
        if "://" in executor:
            return _on_cluster(function, items, executor, advance, finished or _nothing)
        return _here(
            function, items, workers or os.cpu_count() or 1, advance, finished or _nothing, threads=executor == "threads"
        )
    except _StoppedError as stopped:
        raise stopped.error from None


def _nothing(_: int, __: object) -> None:
    """Do nothing with a result."""


def _here(
    function: Callable[[Item], Result],
    items: Sequence[Item],
    workers: int,
    advance: Advance,
    finished: Callable[[int, Result], None],
    *,
    threads: bool,
) -> list[Result]:
    """Map in threads of this process, or in processes of this machine."""
    from dask.callbacks import Callback

    get: Any
    if threads:
        from dask.threaded import get
    else:
        from dask.multiprocessing import get
    used = () if threads else in_use()
    expected = {} if threads else fingerprint(used)
    done = 0

    def count(key: Any, answer: Any, *__: object) -> None:
        nonlocal done
        finished(key[1], answer if threads else _believed(answer, expected))
        done += 1
        advance(done, len(items))

    task: Callable[[Item], Any] = function if threads else partial(_on_worker, function, used, expected, "")
    graph = {("task", i): (task, item) for i, item in enumerate(items)}
    with one_thread(), Callback(posttask=count):
        try:
            found = list(get(graph, list(graph), num_workers=workers))
        except Exception as error:
            # What a task raises in another process comes back as an answer.
            if threads or isinstance(error, _StoppedError):
                raise
            raise WorkerError(f"A worker process cannot work: {_said(error)}. {_REMEDY}.") from error
    return found if threads else [_believed(answer, expected) for answer in found]


def _on_cluster(
    function: Callable[[Item], Result],
    items: Sequence[Item],
    address: str,
    advance: Advance,
    finished: Callable[[int, Result], None],
) -> list[Result]:
    from distributed import Client, as_completed
    from distributed.protocol import pickle
    from distributed.versions import VersionMismatchWarning

    used = in_use()
    expected = fingerprint(used)
    with warnings.catch_warnings():
        # ``_ask`` says more, and says it of those libraries that decide results.
        warnings.simplefilter("ignore", VersionMismatchWarning)
        client = Client(address, timeout="10s", set_as_default=False)
    with client, client.as_current():
        _ask(client, used, expected)
        # Bytes that any worker can receive, and that do the task where they are read.
        calls = [pickle.dumps(_Call((function, used, expected, address, item))) for item in items]
        futures = client.map(pickle.loads, calls, pure=False)
        places = {future.key: place for place, future in enumerate(futures)}
        results = {}
        try:
            for done, (future, answer) in enumerate(as_completed(futures, with_results=True), start=1):
                results[future.key] = _believed(answer, expected)
                finished(places[future.key], results[future.key])
                advance(done, len(items))
        except (_StoppedError, OSError):
            raise
        except Exception as error:
            # What a task raises comes back as an answer. Perhaps a worker came that cannot even read the task.
            _ask(client, used, expected)
            raise WorkerError(f"The cluster {address} cannot do a task: {_said(error)}. {_REMEDY}.") from error
        return [results[future.key] for future in futures]


@dataclass(frozen=True)
class _Call:
    """Arguments of ``_on_worker``; reading its pickle calls that.

    A task itself that a worker cannot read, having no such package, ends Dask's worker before it can say why, and the task
    waits for another one for ever.
    """

    arguments: tuple[Any, ...]

    def __reduce__(self) -> tuple[Callable[..., _Answer], tuple[Any, ...]]:
        return _on_worker, self.arguments


def _ask(client: Any, used: tuple[str, ...], expected: Fingerprint) -> None:
    """Ask every worker of a cluster for its fingerprint. Raises WorkerError, naming one that has another or none."""
    for worker, found in client.run(fingerprint, used, on_error="return").items():
        if isinstance(found, Exception):
            raise WorkerError(f"The worker {worker} has no skylight-sh, or another one ({_said(found)}). {_REMEDY}.")
        _compare(worker, found, expected)


def _compare(worker: str, found: Fingerprint, expected: Fingerprint) -> None:
    """Raise WorkerError where a worker's fingerprint is not ``expected``."""
    told = differences(found, expected)
    if told:
        raise WorkerError(f"The worker {worker} would compute something else: {told}. {_REMEDY}.")


def _believed(answer: _Answer, expected: Fingerprint) -> Any:
    """Return an answer's result. Raises _StoppedError where the worker is not as this process, or its task failed."""
    try:
        _compare(answer.worker, answer.found, expected)
    except WorkerError as error:
        raise _StoppedError(error) from None
    if answer.error is not None:
        raise _StoppedError(answer.error)
    return answer.result


def _on_worker(
    function: Callable[[Item], Result], used: tuple[str, ...], expected: Fingerprint, address: str, item: Item
) -> _Answer:
    """Run a task in another process, a worker of the cluster at ``address`` if there is one, where that is as the asker's.

    BLAS has one thread: its sums must not depend on how many there are.
    """
    worker, found = _name(address), fingerprint(used)
    if found != expected:
        return _Answer(worker, found)
    _limit_blas()
    try:
        return _Answer(worker, found, function(item))
    except Exception as error:
        error.add_note(f"On the worker {worker}:\n{''.join(traceback.format_exception(error))}")
        return _Answer(worker, found, error=error)


def _name(address: str) -> str:
    if not address:
        return f"process {os.getpid()}"
    from distributed import get_worker

    return str(get_worker().address)


def _said(error: Exception) -> str:
    """Return an error in one line; Dask's have a traceback below."""
    lines = str(error).strip().splitlines() or [""]
    # Dask tells an error in a message it cannot read as a plain Exception with that error's text.
    kind = "" if type(error) is Exception else f"{type(error).__name__}: "
    return f"{kind}{lines[0]}".rstrip(".: ")


@lru_cache(maxsize=1)
def _limit_blas() -> object:
    # For the worker's whole life: a limit undone by one of its threads would be undone for all of them.
    return one_thread()
