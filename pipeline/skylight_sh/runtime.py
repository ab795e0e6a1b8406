"""Evaluate an exported table: ``load("skylight_sh.npz").weights(sun_zenith, sun_azimuth, turbidity)``. Needs NumPy only."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skylight_sh import sphere
from skylight_sh.export import npz
from skylight_sh.table.table import Table, full_weights

Array = NDArray[np.float64]

OK, CLAMPED, INVALID = 0, 1, 2


def load(path: str | Path) -> Runtime:
    """Load a table from an exported NPZ. Raises ValueError where the file is not one."""
    return Runtime(npz.read(path))


@dataclass(frozen=True)
class Runtime:
    """An exported table, ready to evaluate in its own number type, like the C header."""

    table: Table

    @property
    def inputs(self) -> tuple[str, ...]:
        """Names of the inputs in order: the first axis, ``sun_azimuth`` unless the table fixes it, the other axes."""
        first, *rest = (axis.name for axis in self.table.axes)
        azimuth = ("sun_azimuth",) if self.table.azimuth is None else ()
        return (first, *azimuth, *rest)

    def weights(
        self, *values: ArrayLike, bands: int | None = None, window: bool = False, **named: ArrayLike
    ) -> NDArray[np.floating]:
        """Return SH weights ``(..., channels, N*N)`` for inputs that broadcast to ``(...)``, angles in radians.

        Inputs come in the order of ``inputs`` or by name. Out-of-range inputs are clamped, a NaN (or an infinite
        azimuth) gives zeros; ``status`` tells which. ``bands`` cuts to fewer bands, ``window`` applies the zonal
        window of eq. 5. Raises TypeError for a missing or unknown input, ValueError for impossible bands.
        """
        return self.weights_and_status(*values, bands=bands, window=window, **named)[0]

    def status(self, *values: ArrayLike, **named: ArrayLike) -> NDArray[np.int64]:
        """Return, for each set of inputs, what the C header returns: 0, 1 where clamped, 2 where invalid."""
        columns = self._columns(values, named)
        return self._check(columns.reshape(-1, columns.shape[-1]))[3].reshape(columns.shape[:-1])

    def weights_and_status(
        self, *values: ArrayLike, bands: int | None = None, window: bool = False, **named: ArrayLike
    ) -> tuple[NDArray[np.floating], NDArray[np.int64]]:
        """Return ``weights`` and ``status`` of one evaluation."""
        table = self.table
        bands = table.bands if bands is None else bands
        if not 1 <= bands <= table.bands:
            raise ValueError(f"Invalid bands {bands}. Should be 1 to {table.bands}, the bands of this table.")
        inputs = self._columns(values, named)
        shape = inputs.shape[:-1]
        clamped, fade, azimuth, status = self._check(inputs.reshape(-1, inputs.shape[-1]))
        # What surrounds the sky carries light from band to band.
        full = full_weights(table, table.evaluate(clamped), table.bands if table.surroundings else bands)
        if table.twilight:
            full = full * fade.astype(full.dtype)[:, np.newaxis, np.newaxis]
        out = sphere.rotate_azimuth(full, azimuth[:, np.newaxis])
        if table.surroundings:
            out = table.surroundings.apply(out, bands)
        if window and table.windowed:
            raise ValueError("The window is in the weights of this table already. Leave window=False.")
        if window:
            out = out * sphere.zonal_sinc(bands).astype(out.dtype)
        if table.windowed and bands < table.bands:
            # The window follows the number of bands.
            whole = sphere.zonal_sinc(table.bands)[: bands * bands]
            out = out * (sphere.zonal_sinc(bands) / whole).astype(out.dtype)
        out[status == INVALID] = 0.0
        return out.reshape(*shape, len(table.channels), bands * bands), status.reshape(shape)

    def _columns(self, values: tuple[ArrayLike, ...], named: dict[str, ArrayLike]) -> Array:
        """Broadcast the inputs against each other, in order along the last axis."""
        inputs = np.broadcast_arrays(*(np.asarray(v, dtype=np.float64) for v in self._bind(values, named)))
        return np.stack(inputs, axis=-1)

    def _check(self, columns: Array) -> tuple[Array, Array, Array, NDArray[np.int64]]:
        """Return axis values inside their ranges ``(n, axes)``, twilight's factors, azimuths and status ``(n,)``."""
        place = 1 if self.table.azimuth is None else None
        azimuth = np.full(len(columns), self.table.azimuth) if place is None else columns[:, place]
        invalid = np.isnan(columns).any(axis=1) | np.isinf(azimuth.astype(np.float64))
        columns = np.where(invalid[:, np.newaxis], 0.0, columns)
        azimuth = np.where(invalid, 0.0, azimuth)
        values = columns if place is None else np.delete(columns, place, axis=1)
        clamped, outside = self.table.clamp(values)
        return clamped, self.table.fade(values), azimuth, np.where(invalid, INVALID, np.where(outside, CLAMPED, OK))

    def _bind(self, values: tuple[ArrayLike, ...], named: dict[str, ArrayLike]) -> list[ArrayLike]:
        names = self.inputs
        given = dict(zip(names, values, strict=False)) | named
        if len(values) > len(names) or len(given) < len(values) + len(named) or set(given) != set(names):
            raise TypeError(f"weights() takes exactly the inputs {', '.join(names)}, by position or by name.")
        return [given[name] for name in names]
