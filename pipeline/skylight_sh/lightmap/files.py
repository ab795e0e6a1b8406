"""Lightmaps as NPZ files: no pickle, no dates, equal bytes for equal lightmaps."""

from __future__ import annotations

import zipfile
from pathlib import Path

import numpy as np

from skylight_sh import UserError
from skylight_sh.lightmap.evaluation import Lightmap
from skylight_sh.table.npz import archive

FORMAT = 1
_AXES = ("tangent", "bitangent", "normal")
_NAMES = ("format", "weights", *_AXES, "covered")


def write(lightmap: Lightmap) -> bytes:
    """Return the bytes of a lightmap's NPZ, numbers in single precision; the packed form stands beside the weights."""
    axes = {name: lightmap.frames[..., k, :].astype(np.float32) for k, name in enumerate(_AXES)}
    return archive(
        {
            "format": np.array(FORMAT),
            "weights": lightmap.weights.astype(np.float32),
            "packed": lightmap.packed.astype(np.float32),
            **axes,
            "covered": lightmap.covered,
        }
    )


def read(path: Path) -> Lightmap:
    """Read what ``write`` made. Raises UserError for a file that is none, another format, or arrays that make no sense."""
    try:
        with np.load(path, allow_pickle=False) as held:
            absent = [name for name in _NAMES if name not in held]
            if absent:
                raise UserError(f"{path}: has no array {absent[0]!r}. Should be a lightmap, with {', '.join(_NAMES)}.")
            form = held["format"]
            if form.shape or int(form) != FORMAT:
                raise UserError(f"{path}: has format {form}, not {FORMAT}. A newer version wrote it: use that.")
            frames = np.stack([held[name].astype(np.float64) for name in _AXES], axis=-2)
            weights, covered = held["weights"].astype(np.float64), held["covered"].astype(bool)
        off = np.abs(frames @ frames.swapaxes(-1, -2) - np.eye(3)).max(initial=0.0)
        if not off < 1e-3:
            raise UserError(f"{path}: tangent, bitangent and normal are not unit vectors at right angles. Bake it again.")
        return Lightmap(weights, frames, covered)
    except (OSError, ValueError, zipfile.BadZipFile) as error:
        raise UserError(f"{path}: is no lightmap ({error}). Write it by skylight_sh.lightmap.files.write.") from error
