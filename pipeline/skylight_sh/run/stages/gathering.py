"""What lets light of emitters bounce between a mesh's vertices: the matrix that gathers, and where vertices' rays start."""

from __future__ import annotations

from functools import partial

from skylight_sh.run.blocks import map_in_blocks
from skylight_sh.run.executors import Advance
from skylight_sh.run.mesh_source import MeshSource
from skylight_sh.run.plan import Inputs
from skylight_sh.store.blocks import Blocks
from skylight_sh.store.dataset import Dataset, Variable
from skylight_sh.transfer.whole import blocks_of, collect, gather_matrix, prepare


def make(source: MeshSource, executor: str, workers: int, _: Inputs, advance: Advance, blocks: Blocks) -> Dataset:
    """Compute the matrix of a mesh; an empty one where there are no bounces."""
    setup = prepare(source.mesh(blocks.warn), source.options)
    named = [(f"gather-{part.start}", part) for part in blocks_of(setup.mesh)] if source.options.bounces else []
    found = map_in_blocks(partial(collect, setup), named, blocks, executor=executor, workers=workers, advance=advance)
    matrix = gather_matrix(setup, found)
    return Dataset(
        {
            "data": Variable(("entry",), matrix.data.astype("float32")),
            "column": Variable(("entry",), matrix.indices.astype("int32")),
            "row_start": Variable(("row_edge",), matrix.indptr.astype("int32")),
            "start": Variable(("vertex", "axis"), setup.start.points),
            "healed": Variable(("vertex",), setup.start.buried.astype("uint8")),
        },
        {"bounces": source.options.bounces},
    )
