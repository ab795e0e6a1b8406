"""The artifact store: ``artifacts/<stage>/<key>.h5``, and what each run still needs."""

from __future__ import annotations

import json
import re
import shutil
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from skylight_sh.store import atomic, hdf5
from skylight_sh.store.blocks import SUFFIX, Blocks
from skylight_sh.store.dataset import Dataset
from skylight_sh.store.hdf5 import CorruptArtifactError

_KEY = re.compile(r"[0-9a-f]{64}")
# A temporary file younger than this may belong to a run under way.
_STALE_SECONDS = 3600.0


@dataclass(frozen=True)
class Entry:
    """An artifact on disk."""

    stage: str
    key: str
    path: Path
    size: int


@dataclass(frozen=True)
class Store:
    """A folder of artifacts. Several runs may share it: an artifact is whole or absent, and says itself which it is."""

    root: Path

    def path(self, stage: str, key: str) -> Path:
        """Return where the artifact of ``stage`` under ``key`` lives."""
        return self.root / stage / f"{key}.h5"

    def has(self, stage: str, key: str) -> bool:
        """Say whether an artifact is there; ``get`` checks its content, and that it is the one."""
        return self.path(stage, key).is_file()

    def get(self, stage: str, key: str, step: str | None = None) -> Dataset:
        """Read an artifact, of ``step`` if it is given.

        Raises CorruptArtifactError where its content does not match its checksum, or proves to be that of another stage,
        key or step than the file's name and the caller say.
        """
        dataset = hdf5.read(self.path(stage, key), f"{stage}/{key}")
        # Beside the store's own identity stands its maker's: another's, where a dataset was read here and put there.
        told, maker = dataset.attrs, str(dataset.attrs.get("step", stage))
        facts = {
            "key": (told.get("key", key), key),
            "stage": (maker.partition("/")[0], stage),
            "step": (maker, step or maker),
        }
        for name, (found, asked) in facts.items():
            if str(found) != asked:
                wrong = f"{self.path(stage, key)} is of the {name} {found!r}, not {asked!r}"
                raise CorruptArtifactError(f"{wrong}. Delete it; the next run makes it again.")
        return dataset

    def attributes(self, stage: str, key: str) -> dict[str, Any]:
        """Return an artifact's attributes alone, unchecked; none where it cannot be read."""
        return hdf5.attributes(self.path(stage, key))

    def put(self, stage: str, key: str, dataset: Dataset) -> None:
        """Publish an artifact atomically, with its stage and key inside."""
        hdf5.write(self.path(stage, key), dataset, f"{stage}/{key}")

    def blocks(self, stage: str, key: str, warn: Callable[[str], None]) -> Blocks:
        """Return the finished blocks of an artifact that is not whole yet; ``warn`` is told of a damaged one."""
        return Blocks(self.root / stage / f"{key}{SUFFIX}", stage, key, warn)

    def entries(self) -> list[Entry]:
        """Return all artifacts, by stage and key."""
        found = [
            Entry(path.parent.name, path.stem, path, path.stat().st_size)
            for path in self.root.glob("*/*.h5")
            if _KEY.fullmatch(path.stem)
        ]
        return sorted(found, key=lambda e: (e.stage, e.key))

    def unfinished(self) -> list[tuple[Entry, int]]:
        """Return the artifacts that are not whole yet, each with the number of its finished blocks."""
        found = []
        for folder in sorted(self.root.glob(f"*/*{SUFFIX}")):
            sizes = [path.stat().st_size for path in folder.glob("[!.]*.h5")]
            found.append((Entry(folder.parent.name, folder.stem, folder, sum(sizes)), len(sizes)))
        return found

    def find(self, start: str) -> Entry:
        """Return the artifact whose key starts with ``start``. Raises KeyError where none or several do."""
        matches = [e for e in self.entries() if e.key.startswith(start)] if start else []
        if len(matches) != 1:
            count = "No artifact's key starts" if not matches else f"{len(matches)} artifacts' keys start"
            raise KeyError(f"{count} with {start!r}. Give a longer or another start; `artifacts ls` lists the keys.")
        return matches[0]

    def keep(self, run: str, keys: Sequence[str]) -> None:
        """Remember that the run named ``run`` uses ``keys``, so that ``collect`` leaves them."""
        path = self.root / "runs" / f"{run}.json"
        path.parent.mkdir(parents=True, exist_ok=True)
        atomic.write(path, (json.dumps(sorted(keys), indent=1) + "\n").encode())

    def collect(self) -> Iterator[Entry]:
        """Delete, and yield, every artifact that no run's last result uses, and what runs left behind unfinished."""
        used: set[str] = set()
        for path in self.root.glob("runs/*.json"):
            try:
                used.update(json.loads(path.read_text(encoding="utf-8")))
            except (ValueError, TypeError) as error:
                raise OSError(f"{path} is damaged ({error}). Delete it, and run its config again before `gc`.") from error
        for entry in self.entries():
            if entry.key not in used:
                entry.path.unlink()
                yield entry
        for path in (*self.root.glob("*/*.partial"), *self.root.glob(f"*/*{SUFFIX}/*.partial")):
            if _is_stale(path):
                path.unlink()
        for folder in self.root.glob(f"*/*{SUFFIX}"):
            if all(map(_is_stale, folder.iterdir())):
                shutil.rmtree(folder)


def _is_stale(path: Path) -> bool:
    """Say whether nobody has written a file lately."""
    return time.time() - path.stat().st_mtime > _STALE_SECONDS
