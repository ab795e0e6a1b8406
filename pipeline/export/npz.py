"""Tables as NPZ files: fixed key order, no compression, no dates, no pickle."""

from __future__ import annotations

import io
import json
import zipfile
from dataclasses import asdict
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from pipeline.fit.axes import Axis
from pipeline.table.table import Table

FORMAT = 1
_NO_DATE = (1980, 1, 1, 0, 0, 0)


def write(table: Table) -> bytes:
    """Return the bytes of ``table`` as an NPZ archive; equal tables give equal bytes."""
    name, constants = table.prefactor or ("", ())
    header = {
        "format": FORMAT,
        "axes": [asdict(axis) for axis in table.axes],
        "channels": table.channels,
        "bands": table.bands,
        "mirrored": table.mirrored,
        "basis": table.basis,
        "degrees": table.degrees,
        "prefactor": name,
        "prefactor_constants": constants,
        "provenance": table.provenance,
    }
    arrays: dict[str, NDArray[np.generic]] = {
        "header": np.array(json.dumps(header, sort_keys=True)),
        "lengths": table.lengths,
        "coefficients": table.coefficients,
    }
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_STORED) as archive:
        for key, array in arrays.items():
            member = io.BytesIO()
            np.lib.format.write_array(member, np.ascontiguousarray(array) if array.ndim else array, allow_pickle=False)
            archive.writestr(zipfile.ZipInfo(f"{key}.npy", _NO_DATE), member.getvalue())
    return out.getvalue()


def read(path: str | Path | BinaryIO) -> Table:
    """Read a table written by ``write``. Raises ValueError where the file is not one."""
    try:
        # NumPy takes anything that is no archive for a pickle, and would advise to trust it.
        if not zipfile.is_zipfile(path):
            raise ValueError("it is no archive")
        with np.load(path, allow_pickle=False) as archive:
            header = json.loads(str(archive["header"]))
            lengths, coefficients = archive["lengths"], archive["coefficients"]
    except (OSError, KeyError, ValueError, EOFError, zipfile.BadZipFile) as error:
        raise ValueError(f"{path} is no table of this pipeline ({error}). Give the .npz that a run exported.") from error
    if header.get("format") != FORMAT:
        raise ValueError(
            f"{path} has table format {header.get('format')!r}, this version reads {FORMAT}. Run the fit again."
        )
    name = header["prefactor"]
    return Table(
        axes=tuple(Axis(**axis) for axis in header["axes"]),
        channels=tuple(header["channels"]),
        bands=header["bands"],
        mirrored=header["mirrored"],
        basis=header["basis"],
        degrees=tuple(header["degrees"]),
        lengths=lengths,
        coefficients=coefficients,
        prefactor=(name, tuple(header["prefactor_constants"])) if name else None,
        provenance=header["provenance"],
    )
