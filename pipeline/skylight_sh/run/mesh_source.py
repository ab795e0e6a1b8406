"""Which mesh a transfer is of, and how it is computed."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from dataclasses import asdict, dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from skylight_sh.run.code import Later
from skylight_sh.transfer.options import Options

if TYPE_CHECKING:
    from skylight_sh.mesh import Mesh

# Meshes that are made by code.
MADE = {"courtyard": Later("skylight_sh.mesh.courtyard:courtyard", ())}


@dataclass(frozen=True)
class MeshSource:
    """A mesh, ``file`` or one of ``MADE``, with ``up`` as its upward axis, and the options of its transfer.

    ``unshadowed`` surfaces see no mesh.
    """

    file: Path
    options: Options
    up: Literal["y", "z"] | None = None
    unshadowed: bool = False

    @property
    def made(self) -> bool:
        """Whether code makes the mesh."""
        return str(self.file) in MADE

    def mesh(self, warn: Callable[[str], None] = lambda _: None) -> Mesh:
        """Return the mesh; ``warn`` is told what was found wrong with it and healed. Raises UserError."""
        from skylight_sh.mesh import read
        from skylight_sh.mesh.findings import told

        if self.made:
            made: Mesh = MADE[str(self.file)]()
            return made
        found, findings = read(self.file, self.up)
        for sentence in told(findings):
            warn(sentence)
        return found

    def _sums(self) -> list[str]:
        """Return the sums of all files that the mesh is in: its materials and pictures may stand beside it."""
        from skylight_sh.mesh import files

        return [_sum(file) for file in files(self.file)]

    def parameters(self) -> dict[str, Any]:
        """Return what decides the transfer beside its code, JSON-like."""
        return {
            "mesh": str(self.file) if self.made else self._sums(),
            "up": self.up,
            "options": asdict(self.options),
            "unshadowed": self.unshadowed,
            "embree": _version("embreex"),
        }


def _sum(file: Path) -> str:
    """Return the SHA-256 of a file, or nothing where it cannot be read: the step then tells why."""
    try:
        return hashlib.sha256(file.read_bytes()).hexdigest()
    except OSError:
        return ""


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return ""
