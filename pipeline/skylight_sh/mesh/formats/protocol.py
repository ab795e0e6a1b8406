"""What a reader of a format makes of a file: surfaces as they are, nothing checked, merged or healed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError
from skylight_sh.mesh.findings import Finding

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Up = Literal["y", "z"]

# Of vertices, and of triangles: healing so many takes 1.5 GB and 20 seconds.
MOST_VERTICES = 2_000_000


@dataclass(frozen=True)
class Surface:
    """A part as a file has it: ``positions`` ``(v, 3)`` and ``triangles`` ``(t, 3)``, and what else the file says.

    ``normals`` ``(v, 3)``, ``albedo`` ``(v, 3)`` (linear RGB), ``uv`` ``(v, 2)`` (v upwards), ``texture`` and ``relief`` are
    None where it says nothing. Indices may be out of range and numbers wrong: that is seen later.
    """

    name: str
    positions: Array
    triangles: Index
    normals: Array | None = None
    albedo: Array | None = None
    uv: Array | None = None
    texture: Array | None = field(default=None, repr=False)
    relief: Array | None = field(default=None, repr=False)


@dataclass(frozen=True)
class Content:
    """All surfaces of a file, and what its reader left out or made up."""

    surfaces: tuple[Surface, ...]
    findings: tuple[Finding, ...] = ()


@dataclass(frozen=True)
class Format:
    """A format: its ``title`` for people, which axis is ``up`` by default, its reader, and which files it reads.

    ``read`` raises UserError, telling what is wrong where, for a file that it cannot read whole. ``beside`` names the other
    files that a file draws on, there or not; it may leave out what it cannot make out, for then ``read`` fails.
    """

    title: str
    up: Up
    read: Callable[[Path], Content]
    beside: Callable[[Path], tuple[Path, ...]] = lambda _: ()


def check_count(count: int, noun: str, most: int = MOST_VERTICES) -> None:
    """Raise UserError, before anything is allocated, for more vertices or triangles than memory holds."""
    if count > most:
        raise UserError(f"{count:,} {noun}. Should be at most {most:,}. Simplify the mesh, or split it into several.")


def check_indices(part: str, indices: Index, count: int, noun: str) -> None:
    """Raise UserError where ``indices`` (from 0) name what a part of ``count`` does not have."""
    wrong = (indices < 0) | (indices >= count)
    if wrong.any():
        bad = int(indices[wrong][0])
        raise UserError(
            f"part {part!r}: {int(wrong.sum()):,} indices out of range, such as {bad} (from 0). Should be from 0 to "
            f"{count - 1}, for it has {count:,} {noun}. Export it anew."
        )
