"""Which triangles of a mesh touch: vertices at one place, edges, and shells."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from skylight_sh.mesh._mesh import Mesh

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Mask = NDArray[np.bool_]


def group(rows: NDArray[np.float64 | np.int64]) -> tuple[Index, Index]:
    """Return for ``rows`` ``(n, k)`` the number ``(n,)`` of the group of equal rows, and each group's first row ``(g,)``.

    >>> numbers, first = group(np.array([[2.0, 1.0], [0.0, 0.0], [2.0, 1.0]]))
    >>> numbers.tolist(), first.tolist()
    ([1, 0, 1], [1, 0])
    """
    # Adding 0 makes -0 and 0 alike.
    order = np.lexsort((rows + 0).T[::-1])
    ordered = rows[order]
    new = np.ones(len(rows), bool)
    new[1:] = (ordered[1:] != ordered[:-1]).any(axis=-1)
    numbers = np.empty(len(rows), np.int64)
    numbers[order] = np.cumsum(new) - 1
    return numbers, order[new]


def components(count: int, a: Index, b: Index) -> Index:
    """Return the number ``(count,)`` of the component that each node of a graph with edges ``a``, ``b`` ``(e,)`` is in."""
    graph = coo_array((np.ones(len(a), bool), (a, b)), shape=(count, count))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int64)


@dataclass(frozen=True)
class Topology:
    """The edges of a mesh whose vertices are joined, within each part, where they are at exactly one place.

    A half-edge k = 3 i + j leads from the corner j of the triangle i to its next one. ``place`` ``(v,)`` numbers places,
    ``edge`` ``(3 t,)`` says which edge a half-edge is on, ``forward`` ``(3 t,)`` which way it leads.
    """

    place: Index
    edge: Index
    forward: Mask

    @cached_property
    def uses(self) -> Index:
        """How many half-edges each edge has, ``(e,)``."""
        return np.bincount(self.edge)

    @cached_property
    def pairs(self) -> Index:
        """The two half-edges of every edge of two triangles, ``(p, 2)``."""
        order = np.argsort(self.edge, kind="stable")
        return np.asarray(order[self.uses[self.edge[order]] == 2].reshape(-1, 2))

    @cached_property
    def shell(self) -> Index:
        """The number of the shell that each triangle is in, ``(t,)``: triangles joined over edges of two triangles."""
        return components(len(self.edge) // 3, *(self.pairs.T // 3))

    @cached_property
    def closed(self) -> Mask:
        """Which shells are closed, ``(s,)``: every edge is passed as often one way as the other."""
        shells = int(self.shell.max(initial=-1)) + 1
        side, first = group(np.stack([np.repeat(self.shell, 3), self.edge], axis=-1))
        balance = np.bincount(side, np.where(self.forward, 1.0, -1.0))
        shell_of_side = np.repeat(self.shell, 3)[first]
        return np.asarray(np.bincount(shell_of_side[balance != 0], minlength=shells) == 0)


def topology(mesh: Mesh) -> Topology:
    """Return which triangles of a mesh touch."""
    part = np.zeros(len(mesh.positions), np.int64)
    part[mesh.triangles] = mesh.part[:, np.newaxis]
    place, _ = group(np.column_stack([part, mesh.positions]))
    start = place[mesh.triangles]
    end = np.roll(start, -1, axis=1)
    key = np.minimum(start, end) * (int(place.max()) + 1) + np.maximum(start, end)
    edge = np.unique(key.ravel(), return_inverse=True)[1]
    return Topology(place, np.asarray(edge), (start < end).ravel())
