"""A table: the polynomial coefficients of a light's SH weights, and their evaluation in the table's own arithmetic."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.fit import tensor_product
from skylight_sh.fit.axis import Axis
from skylight_sh.fit.bases import BASES
from skylight_sh.reproducible import product
from skylight_sh.table import packed, rows, twilight
from skylight_sh.table import prefactor as factors
from skylight_sh.table.packed import Packed
from skylight_sh.table.prefactor import Factor
from skylight_sh.table.row_layout import Layout, layout
from skylight_sh.table.rows import Rows
from skylight_sh.table.surroundings import Surroundings

Array = NDArray[np.float64]
Floats = NDArray[np.floating]

_SETS_AT_ONCE = 2048
# Beyond this share of the range (or of 1, if that is more) an input counts as outside: float32 pi/2 exceeds pi/2.
SLACK = 1e-6


@dataclass(frozen=True)
class Table:
    """Polynomial coefficients of SH weights over named axes.

    ``degrees`` are the largest ones, an axis; ``body`` holds the coefficients, laid out for speed (``Rows``) or for size
    (``Packed``). Weights are those of order m >= 0 where ``mirrored``, else all N*N. ``factor`` multiplies the polynomials.
    ``provenance`` is JSON-like and says where the table comes from. ``quantity`` is radiance or irradiance; ``windowed``
    says that the window of eq. 5 is in the weights; ``azimuth`` is the sun's where it is no input (radians);
    ``ground`` says what is below the horizon, ``sun_disc`` whether the sun's disc is in the weights, ``twilight`` whether a
    ``sun_zenith`` beyond the horizon fades them out. ``surroundings`` act on the weights once they are turned.
    """

    axes: tuple[Axis, ...]
    channels: tuple[str, ...]
    bands: int
    mirrored: bool
    basis: str
    degrees: tuple[int, ...]
    body: Rows | Packed
    factor: Factor | None = None
    provenance: Mapping[str, object] = field(default_factory=dict)
    quantity: str = "radiance"
    windowed: bool = False
    azimuth: float | None = None
    ground: str = "black"
    sun_disc: bool = False
    twilight: bool = False
    surroundings: Surroundings | None = None

    @property
    def dtype(self) -> np.dtype[np.floating]:
        """Number type of the arithmetic."""
        return self.body.dtype

    @property
    def count(self) -> int:
        """Number of stored weights a channel."""
        return sphere.count(self.bands, mirrored=self.mirrored)

    @property
    def rest(self) -> int:
        """Number of products of the other axes' powers."""
        return int(np.prod([d + 1 for d in self.degrees[1:]], dtype=int))

    @cached_property
    def layout(self) -> Layout:
        """The order of the outputs in a row."""
        return layout(self.bands, len(self.channels), mirrored=self.mirrored, degrees=carried(self.quantity, self.bands))

    @cached_property
    def coefficients(self) -> int:
        """How many coefficients are kept, padding left out."""
        if isinstance(self.body, Packed):
            return int(np.count_nonzero(packed.unpack(self.body)))
        return len(self.body.rows) * sum(place is not None for place in self.layout.places)

    @property
    def bytes(self) -> int:
        """Size of every constant an evaluation reads: coefficients, lengths, axes, factor, numbers in the code."""
        return self.bytes_at(self.bands)

    def bytes_at(self, bands: int) -> int:
        """Size of what the first ``bands`` bands alone read: a table of fewer bands is a prefix of this one.

        Surroundings read all bands, whatever is asked for.
        """
        bands = self.bands if self.surroundings else bands
        numbers = sum(2 + len(axis.constants) for axis in self.axes) + (self.factor.numbers if self.factor else 0)
        numbers += twilight.NUMBERS if self.twilight else 0
        numbers += self.surroundings.numbers if self.surroundings else 0
        body = self.body
        if isinstance(body, Packed):
            part = body if bands == self.bands else packed.pack(packed.unpack(body, bands), self._degrees(bands), body.step)
            # Beside stream and profiles the step.
            return part.bytes + self.dtype.itemsize * (numbers + 1)
        read = len(body.rows) * self.layout.widths[bands - 1] + numbers
        return read * self.dtype.itemsize + body.lengths.nbytes + len(self.layout.widths)

    def _degrees(self, bands: int) -> NDArray[np.int64]:
        return sphere.degrees_orders(bands, mirrored=self.mirrored)[0]

    @cached_property
    def _matrix(self) -> tuple[NDArray[np.int64], Floats]:
        """Places of the terms among all products, and their coefficients ``(terms, channels * count)``."""
        if isinstance(self.body, Packed):
            numbers = packed.unpack(self.body)
            values = numbers.astype(self.dtype) * self.dtype.type(self.body.step)
            flat = values.transpose(2, 3, 1, 0).reshape(values.shape[2] * values.shape[3], -1)
            # The last products of powers may be missing where nothing keeps them.
            places = np.arange(values.shape[2])[:, np.newaxis] * self.rest + np.arange(values.shape[3])
            return places.ravel(), np.ascontiguousarray(flat)
        columns = self.layout.columns(self.bands, len(self.channels), mirrored=self.mirrored).ravel()
        matrix = self.body.rows[:, columns] * (columns >= 0)
        return rows.terms(self.body.lengths), np.ascontiguousarray(matrix.astype(self.dtype))

    def evaluate(self, values: Array) -> Floats:
        """Return the stored weights at parameter sets ``(n, axes)``, azimuth 0: ``(n, channels, count)``.

        Works in the table's dtype throughout, terms summed in their order, so that a set's bits depend on nothing but the
        set. Values must lie in the axes' ranges.
        """
        places, matrix = self._matrix
        out = np.empty((len(values), len(self.channels), self.count), dtype=self.dtype)
        for start in range(0, len(values), _SETS_AT_ONCE):
            part = values[start : start + _SETS_AT_ONCE].astype(self.dtype)
            terms = products(self.basis, self.axes, part, self.degrees)[:, places]
            if self.factor:
                terms = terms * factors.evaluate(self.factor, self.axes, part)[:, np.newaxis]
            out[start : start + _SETS_AT_ONCE] = product(terms, matrix).reshape(len(part), *out.shape[1:])
        return out

    @property
    def ranges(self) -> list[tuple[float, float]]:
        """Least and largest value of each input: its axis's range, which twilight extends."""
        return [(axis.low, twilight.END if self._sinks(axis) else axis.high) for axis in self.axes]

    def fade(self, values: Array) -> Array:
        """Return what twilight multiplies weights with at inputs ``(n, axes)``, not clamped, ``(n,)``: ones without one."""
        sinking = [i for i, axis in enumerate(self.axes) if self._sinks(axis)]
        return np.asarray(twilight.fade(values[:, sinking[0]]) if sinking else np.ones(len(values)))

    def _sinks(self, axis: Axis) -> bool:
        return self.twilight and axis.name == "sun_zenith"

    def clamp(self, values: Array) -> tuple[Array, NDArray[np.bool_]]:
        """Clamp ``(n, axes)`` to the ranges; the second result marks sets with a value beyond the slack."""
        first, last = self._limits
        outside = np.any((values < first) | (values > last), axis=-1)
        return np.clip(values, [axis.low for axis in self.axes], [axis.high for axis in self.axes]), outside

    def float32_limits(self) -> list[tuple[float, float]]:
        """Return, for each axis, the first and the last float32 that count as inside.

        A target that works in float32 compares with these: range plus slack, rounded, would disagree by one number.
        """
        found = []
        for first, last in np.transpose(self._limits):
            up, down = np.float32(first), np.float32(last)
            up = up if up >= first else np.nextafter(up, np.float32(np.inf))
            down = down if down <= last else np.nextafter(down, np.float32(-np.inf))
            found.append((float(up), float(down)))
        return found

    @property
    def _limits(self) -> tuple[Array, Array]:
        """Least and largest value of each input that counts as inside."""
        low, high = np.transpose(self.ranges)
        slack = SLACK * np.maximum(high - low, 1.0)
        return low - slack, high + slack


def products(basis: str, axes: Sequence[Axis], values: Floats, degrees: Sequence[int]) -> Floats:
    """Return all products of one basis function an axis: ``(n, terms)``, first axis slowest, in the values' dtype."""
    # A column of its own: libraries' functions may treat numbers that do not lie side by side otherwise.
    columns = (np.ascontiguousarray(values[:, i]) for i in range(len(axes)))
    vander = BASES[basis].vander
    return tensor_product.products(
        [vander(axis.scaled(column), d) for axis, column, d in zip(axes, columns, degrees, strict=True)]
    )


@dataclass(frozen=True)
class Frame:
    """All of a table but its coefficients: what one fit's tables have in common, surroundings by the number of bands."""

    axes: tuple[Axis, ...]
    channels: tuple[str, ...]
    mirrored: bool
    basis: str
    factor: Factor | None
    quantity: str = "radiance"
    windowed: bool = False
    azimuth: float | None = None
    ground: str = "black"
    sun_disc: bool = False
    twilight: bool = False
    surroundings: Mapping[int, Surroundings] = field(default_factory=dict)

    def table(self, bands: int, degrees: tuple[int, ...], body: Rows | Packed) -> Table:
        """Return a table of this frame."""
        return Table(
            self.axes,
            self.channels,
            bands,
            self.mirrored,
            self.basis,
            degrees,
            body,
            self.factor,
            quantity=self.quantity,
            windowed=self.windowed,
            azimuth=self.azimuth,
            ground=self.ground,
            sun_disc=self.sun_disc,
            twilight=self.twilight,
            surroundings=self.surroundings.get(bands),
        )


def carried(quantity: str, bands: int) -> tuple[int, ...]:
    """Return the degrees l that carry any of ``quantity``: all, or l = 1 and the even ones for diffuse irradiance."""
    return tuple(l for l in range(bands) if quantity == "radiance" or l == 1 or l % 2 == 0)


def fast(frame: Frame, dense: Array, lengths: NDArray[np.integer], bands: int, dtype: str) -> Table:
    """Make a table laid out for speed of ``dense`` ``(channels, count, d_1+1, .., d_D+1)``.

    ``lengths`` ``(d_2+1, .., d_D+1)`` says how many terms of the first axis to keep; powers that nothing keeps are dropped.
    """
    degrees = rows.used_degrees(lengths.ravel(), [d - 1 for d in dense.shape[2:]])
    cut = tuple(slice(d + 1) for d in degrees)
    count = sphere.count(bands, mirrored=frame.mirrored)
    part = dense[(slice(None), slice(count), *cut)]
    kept = lengths[cut[1:]].ravel() if len(cut) > 1 else lengths.ravel()
    degrees_ = carried(frame.quantity, bands)
    placed = layout(bands, len(frame.channels), mirrored=frame.mirrored, degrees=degrees_)
    columns = placed.columns(bands, len(frame.channels), mirrored=frame.mirrored)
    flat = part.reshape(*part.shape[:3], -1)
    body = rows.arrange(flat, kept, columns, len(placed.places), dtype)
    return frame.table(bands, degrees, body)


def whole(frame: Frame, dense: Array, bands: int, dtype: str) -> Table:
    """Make a table of every coefficient of ``dense``, laid out for speed."""
    return fast(frame, dense, np.full(dense.shape[3:], dense.shape[2]), bands, dtype)


def small(frame: Frame, numbers: NDArray[np.int64], step: float, degrees: Sequence[int], bands: int) -> Table:
    """Make a packed table of whole ``numbers`` ``(count, channels, first, rest)`` of size ``step``.

    ``degrees`` are those of the numbers, an axis; powers that nothing keeps are dropped.
    """
    lengths = packed.lengths_of(numbers).max(axis=(0, 1))
    used = rows.used_degrees(lengths, degrees)
    shape = tuple(d + 1 for d in degrees)
    cut = numbers.reshape(*numbers.shape[:2], *shape)[(slice(None), slice(None), *(slice(d + 1) for d in used))]
    flat = cut.reshape(*cut.shape[:3], -1)
    body = packed.pack(flat, sphere.degrees_orders(bands, mirrored=frame.mirrored)[0], step)
    return frame.table(bands, used, body)


def full_weights(table: Table, stored: Floats, bands: int) -> Floats:
    """Spread stored weights over all N*N of the first ``bands`` bands: ``(n, channels, bands**2)``."""
    cut = stored[..., : sphere.count(bands, mirrored=table.mirrored)]
    return sphere.unmirror(cut, bands) if table.mirrored else cut
