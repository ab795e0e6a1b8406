"""Files of measured reflectance, looked at before they are believed: the MERL database's, and an NPZ of a grid of angles.

Both give a ``Measured`` and findings, a line each for people: what was put right, and what the samples break.
"""

from __future__ import annotations

import struct
import zipfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh import UserError
from skylight_sh.reflectance.measured import Measured, half_and_difference, reciprocity, zeniths_and_azimuth

Array = NDArray[np.float64]

# Red, green and blue of the MERL files' whole numbers (Matusik et al. 2003).
_MERL_SCALES = np.array([1.0, 1.15, 1.66]) / 1500.0
_MERL_HEADER = struct.Struct("<3i")
_MERL_MOST = 720
# Above this, samples are told not to be reciprocal.
_RECIPROCAL = 0.01


class ReflectanceError(UserError, ValueError):
    """A file of measured reflectance makes no sense; the text names file, place and remedy."""


def read_merl(path: Path) -> tuple[Measured, tuple[str, ...]]:
    """Read a binary file of the MERL database: linear RGB over half-vector and difference angles.

    Three little-endian int32, the numbers of the half vector's zenith angles, the difference's zenith angles and its
    azimuths (90, 90, 180), then for each channel as many float64 in that order, the last angle fastest. Zenith angles of the
    half vector stand at (pi/2) k**2, the others evenly, all in the middle of their cells; azimuths cover [0, pi) (Matusik et
    al. 2003; the angles: Rusinkiewicz 1998). A negative number means that there was no measurement: 0 is taken, and told
    where both directions lie above the surface. Raises ReflectanceError for another size, NaN or infinity.
    """
    try:
        data = path.read_bytes()
    except OSError as error:
        raise ReflectanceError(f"{path}: cannot be read ({error.strerror}). Give a file of the MERL database.") from error
    shape = _MERL_HEADER.unpack(data[: _MERL_HEADER.size]) if len(data) >= _MERL_HEADER.size else (0, 0, 0)
    if not all(2 <= n <= _MERL_MOST for n in shape):
        raise ReflectanceError(f"{path}: its first numbers are {shape}, not 90, 90, 180. Give a file of the MERL database.")
    wanted = _MERL_HEADER.size + 3 * 8 * shape[0] * shape[1] * shape[2]
    if len(data) != wanted:
        raise ReflectanceError(f"{path}: has {len(data)} bytes, but its sizes {shape} ask for {wanted}. Fetch it again.")
    raw = np.frombuffer(data, "<f8", offset=_MERL_HEADER.size).reshape(3, *shape).transpose(1, 2, 3, 0)
    half, difference, azimuth = ((np.arange(n) + 0.5) / n for n in shape)
    nodes = (np.pi / 2 * half**2, np.pi / 2 * difference, np.pi * azimuth)
    above = _above(*nodes)
    _check_finite(path, raw[above])
    missing = np.any(raw < 0, axis=-1)
    findings = _told_missing(path, int(np.count_nonzero(missing & above)), int(np.count_nonzero(above)))
    samples = np.where(np.isfinite(raw) & (raw > 0), raw, 0.0) * _MERL_SCALES
    # The angles themselves are reciprocal: exchanging the directions gives the same three.
    return Measured(path.stem, nodes, samples, half_and_difference, np.pi), findings


def read_grid(path: Path) -> tuple[Measured, tuple[str, ...]]:
    """Read an NPZ of f in 1/sr over the angles of incidence and view.

    ``theta_incident`` ``(a,)`` and ``theta_view`` ``(b,)`` are zenith angles in radians that rise within [0, pi/2]; ``phi``
    ``(c,)`` the azimuth between the directions, rising from 0 to pi, or within [0, 2 pi) where the samples are not
    mirrored; ``values`` ``(a, b, c, channels)``. Raises ReflectanceError for an array that is missing, of another shape,
    not rising, negative by more than a millionth of the largest, NaN or infinite.
    """
    names = ("theta_incident", "theta_view", "phi", "values")
    try:
        with np.load(path, allow_pickle=False) as archive:
            absent = [name for name in names if name not in archive]
            if absent:
                raise ReflectanceError(f"{path}: has no array {absent[0]!r}. Should have {', '.join(names)}.")
            first, second, phi, values = (np.asarray(archive[name], dtype=np.float64) for name in names)
    except (OSError, ValueError, zipfile.BadZipFile) as error:
        if isinstance(error, ReflectanceError):
            raise
        raise ReflectanceError(f"{path}: is no NPZ of numbers ({error}). Write it by numpy.savez.") from error
    for name, angles, end in (
        ("theta_incident", first, np.pi / 2),
        ("theta_view", second, np.pi / 2),
        ("phi", phi, 2 * np.pi),
    ):
        if angles.ndim != 1 or angles.size < 2 or not np.all(np.diff(angles) > 0):
            raise ReflectanceError(f"{path}: {name} of shape {angles.shape} does not rise. Give two rising angles or more.")
        if angles[0] < 0 or angles[-1] > end + 1e-6:
            raise ReflectanceError(
                f"{path}: {name} goes from {angles[0]:g} to {angles[-1]:g}. Should be radians from 0 to {end:.4g}."
            )
    shape = (first.size, second.size, phi.size)
    if values.ndim != 4 or values.shape[:3] != shape or not values.shape[3]:
        raise ReflectanceError(f"{path}: values of shape {values.shape}. Should be {shape} and the channels.")
    _check_finite(path, values)
    low = float(values.min())
    if low < -1e-6 * float(values.max()):
        raise ReflectanceError(f"{path}: values go down to {low:g}. Should be at least 0: clamp them.")
    # Samples up to pi alone are mirrored.
    mirrored = bool(phi[-1] <= np.pi + 1e-6)
    found = Measured(
        path.stem, (first, second, phi), np.maximum(values, 0.0), zeniths_and_azimuth, 0.0 if mirrored else 2 * np.pi
    )
    findings = [
        f"{path}: {name} ends at {np.degrees(angles[-1]):.0f} degrees; beyond, its last samples are taken."
        for name, angles in (("theta_incident", first), ("theta_view", second))
        if angles[-1] < np.radians(85)
    ]
    off = reciprocity(found)
    if off > _RECIPROCAL:
        findings.append(f"{path}: not reciprocal: exchanging the directions changes it by {100 * off:.1f} % (RMS).")
    return found, tuple(findings)


def _above(half: Array, difference: Array, azimuth: Array) -> NDArray[np.bool_]:
    """Say ``(a, b, c)`` where both directions lie above the surface: their heights are cc -+ ss cos(azimuth)."""
    level = np.multiply.outer(np.cos(half), np.cos(difference))[..., np.newaxis]
    lean = np.multiply.outer(np.multiply.outer(np.sin(half), np.sin(difference)), np.abs(np.cos(azimuth)))
    return np.asarray(level > lean)


def _check_finite(path: Path, values: Array) -> None:
    wrong = int(np.count_nonzero(~np.isfinite(values)))
    if wrong:
        raise ReflectanceError(f"{path}: {wrong} of its values are NaN or infinite. Mend them, or fetch it again.")


def _told_missing(path: Path, missing: int, of: int) -> tuple[str, ...]:
    if not missing:
        return ()
    return (f"{path}: {missing} of {of} samples above the surface were not measured (negative): taken as 0.",)
