"""Tables of reflectance as NPZ files: no pickle, no dates, equal bytes for equal tables."""

from __future__ import annotations

import zipfile
from pathlib import Path

import numpy as np

from skylight_sh import UserError
from skylight_sh.reflectance.tabulated import Table
from skylight_sh.table.npz import archive

FORMAT = 1
_NAMES = ("format", "title", "estimate", "weights")


def write(table: Table) -> bytes:
    """Return the bytes of a table's NPZ, its weights in single precision."""
    told = {"format": np.array(FORMAT), "title": np.array(table.title), "estimate": np.array(table.estimate)}
    return archive({**told, "weights": table.weights.astype(np.float32)})


def read(path: Path) -> Table:
    """Read what ``write`` made. Raises UserError for a file that is none, another format, or weights that make no sense."""
    try:
        with np.load(path, allow_pickle=False) as held:
            absent = [name for name in _NAMES if name not in held]
            if absent:
                raise UserError(f"{path}: has no array {absent[0]!r}. Should be a reflectance table: {', '.join(_NAMES)}.")
            form = held["format"]
            if form.shape or int(form) != FORMAT:
                raise UserError(f"{path}: has format {form}, not {FORMAT}. A newer version wrote it: use that.")
            return Table(str(held["title"]), held["weights"].astype(np.float64), float(held["estimate"]))
    except (OSError, ValueError, TypeError, zipfile.BadZipFile) as error:
        raise UserError(
            f"{path}: is no reflectance table ({error}). Write it by skylight_sh.reflectance.files.write."
        ) from error
