"""Tasks whose results are kept one by one, so that a run that is stopped goes on from the last of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

from skylight_sh.run.executors import Advance, map_tasks
from skylight_sh.store.blocks import Blocks
from skylight_sh.store.dataset import Dataset, Variable

Item = TypeVar("Item")
Arrays = Mapping[str, Any]


def map_in_blocks(
    function: Callable[[Item], Arrays],
    named: Sequence[tuple[str, Item]],
    blocks: Blocks,
    *,
    executor: str,
    workers: int,
    advance: Advance,
) -> list[Arrays]:
    """Apply ``function``, which gives arrays by name, to each item; return the results in the items' order.

    An item's name is that of its block. Those that an earlier run has finished are read instead.
    """
    found: dict[str, Arrays] = {}
    for name, _ in named:
        block = blocks.get(name)
        if block is not None:
            found[name] = {key: variable.data for key, variable in block.variables.items()}
    missing = [(name, item) for name, item in named if name not in found]
    ready = len(found)

    def keep(place: int, result: Arrays) -> None:
        dims = {key: tuple(f"{key}_{axis}" for axis in range(array.ndim)) for key, array in result.items()}
        blocks.put(missing[place][0], Dataset({key: Variable(dims[key], array) for key, array in result.items()}))

    computed = map_tasks(
        function,
        [item for _, item in missing],
        executor=executor,
        workers=workers,
        advance=lambda done, _: advance(ready + done, len(named)),
        finished=keep,
    )
    found |= {name: result for (name, _), result in zip(missing, computed, strict=True)}
    return [found[name] for name, _ in named]
