"""Tables as NPZ files: fixed key order, no compression, no dates, no pickle."""

from __future__ import annotations

import io
import json
import zipfile
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.fit.axis import Axis
from skylight_sh.fit.bases import BASES
from skylight_sh.light import PREFACTORS
from skylight_sh.table.packed import Packed
from skylight_sh.table.prefactor import ClosedForm, Factor, Reciprocal
from skylight_sh.table.rows import Rows
from skylight_sh.table.surroundings import PARTS, Surroundings
from skylight_sh.table.table import Table

FORMAT = 3
_NO_DATE = (1980, 1, 1, 0, 0, 0)
_NONE = np.zeros(0, dtype=np.float32)


def write(table: Table) -> bytes:
    """Return the bytes of ``table`` as an NPZ archive; equal tables give equal bytes."""
    header, arrays = _body(table.body)
    header |= {
        "format": FORMAT,
        "axes": [asdict(axis) for axis in table.axes],
        "channels": table.channels,
        "bands": table.bands,
        "mirrored": table.mirrored,
        "basis": table.basis,
        "degrees": table.degrees,
        "prefactor": table.factor.name if isinstance(table.factor, ClosedForm) else "",
        "prefactor_constants": table.factor.constants if isinstance(table.factor, ClosedForm) else (),
        "fixed": table.factor.fixed if isinstance(table.factor, ClosedForm) else (),
        "quantity": table.quantity,
        "windowed": table.windowed,
        "azimuth": table.azimuth,
        "ground": table.ground,
        "sun_disc": table.sun_disc,
        "twilight": table.twilight,
        "provenance": table.provenance,
    }
    around = table.surroundings or Surroundings()
    arrays |= {part: getattr(around, part) for part in PARTS}
    arrays["denominator"] = table.factor.coefficients if isinstance(table.factor, Reciprocal) else _NONE
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_STORED) as archive:
        for key, array in {"header": np.array(json.dumps(header, sort_keys=True)), **arrays}.items():
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
            if header.get("format") != FORMAT:
                found = header.get("format")
                raise ValueError(f"its format is {found!r}, this version reads {FORMAT}: run the fit again")
            return _table(header, archive)
    except (OSError, LookupError, AttributeError, TypeError, ValueError, EOFError, zipfile.BadZipFile) as error:
        raise ValueError(f"{path} is no table of this pipeline ({error}). Give the .npz that a run exported.") from error


def _body(body: Rows | Packed) -> tuple[dict[str, object], dict[str, NDArray[Any]]]:
    if isinstance(body, Rows):
        return {"layout": body.kind}, {"lengths": body.lengths, "rows": body.rows}
    profiles = {"rest_profile": body.rest_profile, "channel_profile": body.channel_profile}
    header = {"layout": body.kind, "step": body.step, "first": body.first}
    stream = np.frombuffer(body.stream, dtype=np.uint8)
    return header, {"stream": stream, **{key: value.astype(np.int8) for key, value in profiles.items()}}


def _table(header: dict[str, Any], archive: Mapping[str, NDArray[Any]]) -> Table:
    body: Rows | Packed
    if header["layout"] == "rows":
        body = Rows(archive["lengths"], archive["rows"])
    else:
        body = Packed(
            archive["stream"].tobytes(),
            sphere.degrees_orders(header["bands"], mirrored=header["mirrored"])[0],
            header["first"],
            archive["rest_profile"].astype(np.int64),
            archive["channel_profile"].astype(np.int64),
            header["step"],
        )
    factor: Factor | None = None
    for kind, known in (("basis", BASES), ("prefactor", {"": None, **PREFACTORS})):
        if header[kind] not in known:
            raise ValueError(f"this version knows no {kind} {header[kind]!r}")
    if header["prefactor"]:
        factor = ClosedForm(header["prefactor"], tuple(header["prefactor_constants"]), tuple(map(tuple, header["fixed"])))
    elif archive["denominator"].size:
        factor = Reciprocal(archive["denominator"])
    around = Surroundings(*(archive[part] for part in PARTS))
    return Table(
        axes=tuple(Axis(**axis) for axis in header["axes"]),
        channels=tuple(header["channels"]),
        bands=header["bands"],
        mirrored=header["mirrored"],
        basis=header["basis"],
        degrees=tuple(header["degrees"]),
        body=body,
        factor=factor,
        provenance=header["provenance"],
        quantity=header["quantity"],
        windowed=header["windowed"],
        azimuth=header["azimuth"],
        ground=header["ground"],
        sun_disc=header["sun_disc"],
        twilight=header["twilight"],
        surroundings=around if around.numbers else None,
    )
