"""Turning by the azimuth: the waves cos(m azimuth) and sin(m azimuth) in float32, near quarter turns and far from 0."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh.runtime import Runtime, Table
from skylight_sh.studies import compiled
from skylight_sh.studies.page import Row, Section
from skylight_sh.studies.stability import rounding, zenith

Array = NDArray[np.float64]

_NEAR = 40
# Where the nearest quarter turn changes, and where it is exact; beyond 1e5 the header asks the library.
_AZIMUTHS = (0.0, 1e-7, 0.3, np.pi / 4, np.pi / 2, 3 * np.pi / 4, np.pi, 2 * np.pi, -2.5, 100.0, -9.9e4, 1.1e5, 1e7)
_DIGITS = 60
TEXT = (
    "cos(m azimuth) and sin(m azimuth), m up to the recommended table's, as the C header and the Python runtime turn "
    f"weights, from a table whose weights are 1 at azimuth 0, against mpmath in {_DIGITS} digits: at {_NEAR} numbers of "
    "single precision about each azimuth. Errors are absolute, the waves' largest values 1. In C the bound is, in roundings "
    "of 2^-24, m times that of the azimuth's own cosine and sine and 2 sqrt(2) for each of m - 1 products of two waves "
    "(Higham 2002, section 3.6): the former are polynomials of the rest of the nearest quarter turn, whose distance from "
    "both is by mpmath, and each operation's rounding is followed to the result. Python rounds once. Where bounds hold, "
    "nothing jumps from one quarter to the next."
)


def section(table: Table) -> Section:
    """Measure waves for as many bands as ``table`` has."""
    with tempfile.TemporaryDirectory() as folder:
        return Section("turning", "Turned by the azimuth", TEXT, waves(table.bands, Path(folder)))


def even(bands: int) -> Table:
    """Return a table of one axis, whatever its value, whose weights are all 1 at azimuth 0."""
    made = zenith.pure(bands)
    return replace(made, spec=replace(made.spec, parity=False))


def waves(bands: int, place: Path) -> list[Row]:
    """Measure the waves in C, compiled in ``place``, and Python."""
    table = even(bands)
    azimuths = np.concatenate([_following(start) for start in _AZIMUTHS])
    inputs = np.stack([np.zeros_like(azimuths), azimuths], axis=1).astype(np.float32)
    found = {
        "Python": np.asarray(Runtime(table).weights(*inputs.astype(np.float64).T), dtype=np.float64),
        "C": compiled.weights(compiled.header_of(table), inputs, place, zenith.FLAGS),
    }
    m = np.arange(bands)
    places = np.stack([m * (m + 2), m * m])
    exact = _exact(azimuths, bands)
    rows: list[Row] = []
    for i, start in enumerate(_AZIMUTHS):
        mine = slice(i * _NEAR, (i + 1) * _NEAR)
        for name, got in found.items():
            bound = limit(bands) if name == "C" else np.where(m > 0, rounding.UNIT, 0.0)
            # Of order 0 there is no sine, but the weight itself.
            error = np.abs(got[mine, 0][:, places] - exact[mine])
            at = np.unravel_index(np.argmax(error), error.shape)
            rows.append(
                {
                    "in": name,
                    "azimuth": float(start),
                    "error of m = 1": float(error[..., 1:2].max(initial=0.0)),
                    "bound of m = 1": float(bound[1:2].max(initial=0.0)),
                    "error": float(error[at]),
                    "of order m": int(at[2]),
                    "bound": float(bound.max()),
                    "holds": "yes" if (error <= bound).all() else "no",
                }
            )
    return rows


def limit(bands: int) -> Array:
    """Return how far the header's waves of order 0, 1, .. may be off, ``(bands,)``."""
    m = np.arange(bands)
    return np.asarray(rounding.UNIT * (m * rounding.circle_of_header() + 2.0 * np.sqrt(2.0) * np.maximum(m - 1, 0)))


def _following(start: float) -> Array:
    """Return numbers of single precision about ``start``, half of them closer to 0, as doubles; from 0 away from it."""
    first = int(np.float32(start).view(np.int32))
    steps = np.arange(_NEAR) - (_NEAR // 2 if start else 0)
    return (first + steps).astype(np.int32).view(np.float32).astype(np.float64)


def _exact(azimuths: Array, bands: int) -> Array:
    """Return cosines and sines by mpmath, ``(n, 2, bands)``; 1 in the place of order 0's sine."""
    import mpmath

    found = np.ones((azimuths.size, 2, bands))
    with mpmath.workdps(_DIGITS):
        for i, azimuth in enumerate(azimuths.tolist()):
            for m in range(bands):
                angle = m * mpmath.mpf(azimuth)
                found[i, :, m] = float(mpmath.cos(angle)), float(mpmath.sin(angle)) if m else 1.0
    return found
