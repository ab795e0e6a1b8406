"""Transfer: what each vertex of a mesh makes of the light, in blocks of vertices that a stopped run need not do again."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray

from skylight_sh.mesh import Mesh
from skylight_sh.mesh.findings import told
from skylight_sh.run.blocks import Arrays, map_in_blocks
from skylight_sh.run.executors import Advance
from skylight_sh.run.mesh_source import MeshSource
from skylight_sh.run.plan import Inputs
from skylight_sh.store.blocks import Blocks
from skylight_sh.store.dataset import Dataset, Variable
from skylight_sh.transfer.inspection import inspect
from skylight_sh.transfer.whole import Setup, Transfer, blocks_of, collect, finish, open_transfer, prepare, see

_MEANING = "its dot product with the SH weights of the light is irradiance / pi, bounces included, before the albedo"
_BASIS = "real orthonormal spherical harmonics without the Condon-Shortley sign, index l * (l + 1) + m"
_AXES = "+x east, +y north, +z up; azimuths from +x towards +y"


def make(source: MeshSource, executor: str, workers: int, _: Inputs, advance: Advance, blocks: Blocks) -> Dataset:
    """Compute the transfer of a mesh."""
    mesh, options = source.mesh(blocks.warn), source.options
    if source.unshadowed:
        return _dataset(source, mesh, open_transfer(mesh, options.bands), None)
    setup = prepare(mesh, options)
    # A mesh that code makes is known, and healed without a word.
    for sentence in () if source.made else told(inspect(mesh, setup.rays, setup.start, options.seed)):
        blocks.warn(sentence)
    found = in_blocks(setup, executor, workers, advance, blocks)
    return _dataset(source, mesh, found.transfer, found)


def in_blocks(setup: Setup, executor: str, workers: int, advance: Advance, blocks: Blocks) -> Transfer:
    """Return the transfer of the mesh of ``setup``, block by block."""
    parts = blocks_of(setup.mesh)
    passes = {"direct": see, **({"gather": collect} if setup.options.bounces else {})}
    found = map_in_blocks(
        partial(_block, setup),
        [(f"{name}-{part.start}", (part, function)) for name, function in passes.items() for part in parts],
        blocks,
        executor=executor,
        workers=workers,
        advance=advance,
    )
    return finish(setup, found[: len(parts)], found[len(parts) :])


def _block(setup: Setup, item: tuple[slice, Callable[[Setup, slice], Arrays]]) -> Arrays:
    # The function comes second: Dask calls one that comes first.
    part, function = item
    return function(setup, part)


def _dataset(source: MeshSource, mesh: Mesh, transfer: NDArray[np.float64], found: Transfer | None) -> Dataset:
    direct = transfer[:, 0] if found is None else found.direct
    variables = {
        "transfer": Variable(("vertex", "channel", "weight"), transfer.astype(np.float32), {"long_name": _MEANING}),
        "direct": Variable(("vertex", "weight"), direct.astype(np.float32), {"long_name": "transfer without bounces"}),
        "position": Variable(("vertex", "axis"), mesh.positions, {"long_name": _AXES, "units": "the mesh's own"}),
        "normal": Variable(("vertex", "axis"), mesh.normals),
        "albedo": Variable(("vertex", "channel"), mesh.albedo, {"long_name": "linear RGB, 0 to 1"}),
        "uv": Variable(("vertex", "coordinate"), mesh.uv),
        "triangle": Variable(("triangle_index", "corner"), mesh.triangles.astype(np.int32)),
        "part": Variable(("triangle_index",), mesh.part.astype(np.int32)),
        "part_name": Variable(("part_index",), np.array([part.name for part in mesh.parts], dtype=object)),
        "channel": Variable(("channel",), np.array(["red", "green", "blue"], dtype=object)),
        "axis": Variable(("axis",), np.array(["x", "y", "z"], dtype=object)),
        "coordinate": Variable(("coordinate",), np.array(["u", "v"], dtype=object)),
    }
    # Readers of netCDF want a coordinate for every dimension where one has any.
    counts = {"vertex": len(mesh.positions), "weight": transfer.shape[2], "corner": 3}
    counts |= {"triangle_index": len(mesh.triangles), "part_index": len(mesh.parts)}
    variables |= {name: Variable((name,), np.arange(count, dtype=np.int32)) for name, count in counts.items()}
    attrs = {"bands": source.options.bands, "basis": _BASIS, "axes": _AXES}
    if found is None:
        return Dataset(variables, attrs | {"error": 0.0, "bounces": 0, "rays": 0})
    variables["spread"] = Variable(("vertex",), found.spread, {"long_name": "relative error of a vertex, without bounces"})
    variables["behind"] = Variable(("vertex",), found.start.behind, {"long_name": "share of rays that meet a back face"})
    variables["healed"] = Variable(("vertex",), found.start.buried.astype(np.uint8), {"long_name": "taken from neighbours"})
    options = source.options
    attrs |= {"error": found.error, "bounces": options.bounces, "rays": options.rays, "gather_rays": options.gather_rays}
    return Dataset(variables, attrs | {"seed": options.seed})
