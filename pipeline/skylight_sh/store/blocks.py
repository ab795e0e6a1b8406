"""Blocks of an artifact that is not whole yet: what a run that was stopped had finished, and the next one need not do again.

They lie beside the artifact, in ``<key>.blocks/``, and are gone when it is there. Each is written whole, and checked when
read.
"""

from __future__ import annotations

import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from skylight_sh.store import hdf5
from skylight_sh.store.dataset import Dataset

SUFFIX = ".blocks"


@dataclass(frozen=True)
class Blocks:
    """The blocks of the artifact of ``stage`` under ``key``; ``warn`` is told of one that is damaged."""

    folder: Path
    stage: str
    key: str
    warn: Callable[[str], None]

    def get(self, name: str) -> Dataset | None:
        """Return the block ``name``; None where it is not there, or damaged."""
        path = self._path(name)
        if not path.is_file():
            return None
        try:
            return hdf5.read(path, self._identity(name))
        except hdf5.CorruptArtifactError as error:
            self.warn(str(error))
            return None

    def put(self, name: str, dataset: Dataset) -> None:
        """Keep the block ``name``."""
        hdf5.write(self._path(name), dataset, self._identity(name))

    def clear(self) -> None:
        """Remove all blocks."""
        shutil.rmtree(self.folder, ignore_errors=True)

    def _path(self, name: str) -> Path:
        return self.folder / f"{name}.h5"

    def _identity(self, name: str) -> str:
        return f"{self.stage}/{self.key}/{name}"
