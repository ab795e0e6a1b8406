"""Tables made of a fit's coefficients: laid out for speed (``fast``, ``whole``) or for size (``small``)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit import tensor_product
from skylight_sh.fit.axis import Axis
from skylight_sh.formula.bases import BASES
from skylight_sh.runtime import Program, Scale, Specification, Surroundings, Table, Twilight
from skylight_sh.table import packed, rows
from skylight_sh.table.row_layout import columns, stored

Array = NDArray[np.float64]
Floats = NDArray[np.floating]


def specification(
    axes: Sequence[Axis],
    channels: tuple[str, ...],
    mirrored: bool,
    basis: str,
    scale: Scale | None = None,
    *,
    quantity: str = "radiance",
    windowed: bool = False,
    azimuth: float | None = None,
    ground: str | tuple[float, ...] = "black",
    sun_disc: bool = False,
    peak_axis: str | None = None,
    twilight: Twilight | None = None,
    parity: bool = False,
) -> Specification:
    """Return what all tables of one fit over ``axes`` have in common; see ``runtime.Specification``."""
    return Specification(
        tuple(axis.specified for axis in axes),
        channels,
        mirrored,
        basis,
        scale,
        quantity=quantity,
        windowed=windowed,
        azimuth=azimuth,
        ground=ground,
        sun_disc=sun_disc,
        peak_axis=peak_axis,
        twilight=twilight,
        parity=parity,
    )


def products(basis: str, axes: Sequence[Axis], values: Floats, degrees: Sequence[int]) -> Floats:
    """Return all products of one basis function an axis: ``(n, terms)``, first axis slowest, in the values' dtype.

    >>> products("chebyshev", [Axis("height", 0.0, 1.0)], np.array([[0.0], [1.0]]), [2]).tolist()
    [[1.0, -1.0, 1.0], [1.0, 1.0, 1.0]]
    """
    # A column of its own: libraries' functions may treat numbers that do not lie side by side otherwise.
    columns = (np.ascontiguousarray(values[:, i]) for i in range(len(axes)))
    vander = BASES[basis].vander
    return tensor_product.products(
        [vander(axis.scaled(column), d) for axis, column, d in zip(axes, columns, degrees, strict=True)]
    )


def fast(
    spec: Specification,
    dense: Array,
    lengths: NDArray[np.integer],
    bands: int,
    dtype: str,
    surroundings: Surroundings | None = None,
) -> Table:
    """Make a table laid out for speed of ``dense`` ``(classes, count, d_1+1, .., d_D+1)``.

    ``lengths`` ``(classes, d_2+1, .., d_D+1)``, or without the first axis for all classes, says how many terms of the first
    axis to keep; powers that nothing keeps are dropped.
    """
    lengths = np.broadcast_to(lengths, (len(dense), *dense.shape[3:]))
    degrees = rows.used_degrees(lengths.max(axis=0).ravel(), [d - 1 for d in dense.shape[2:]])
    cut = tuple(slice(d + 1) for d in degrees)
    part = dense[(slice(None), slice(stored(spec, bands).count), *cut)]
    kept = lengths[(slice(None), *cut[1:])].reshape(len(lengths), -1)
    flat = part.reshape(*part.shape[:3], -1)
    return Table(spec, bands, _terms(spec, degrees), rows.arrange(flat, kept, columns(spec, bands), dtype), surroundings)


def whole(spec: Specification, dense: Array, bands: int, dtype: str, surroundings: Surroundings | None = None) -> Table:
    """Make a table of every coefficient of ``dense``, laid out for speed.

    >>> spec = specification([Axis("height", 0.0, 1.0)], ("luminance",), True, "chebyshev")
    >>> whole(spec, np.array([[[3.0, 1.0]]]), 1, "float32").evaluate(np.array([[0.0], [1.0]])).ravel().tolist()
    [2.0, 4.0]
    """
    return fast(spec, dense, np.full((len(dense), *dense.shape[3:]), dense.shape[2]), bands, dtype, surroundings)


def small(
    spec: Specification,
    numbers: NDArray[np.int64],
    step: float,
    degrees: Sequence[int],
    bands: int,
    surroundings: Surroundings | None = None,
) -> Table:
    """Make a packed table of whole ``numbers`` ``(count, classes, first, rest)`` of size ``step``.

    ``degrees`` are those of the numbers, an axis; powers that nothing keeps are dropped.
    """
    lengths = packed.lengths_of(numbers).max(axis=(0, 1))
    used = rows.used_degrees(lengths, degrees)
    shape = tuple(d + 1 for d in degrees)
    cut = numbers.reshape(*numbers.shape[:2], *shape)[(slice(None), slice(None), *(slice(d + 1) for d in used))]
    flat = cut.reshape(*cut.shape[:3], -1)
    body = packed.pack(flat, stored(spec, bands).degrees, step)
    return Table(spec, bands, _terms(spec, used), body, surroundings)


def _terms(spec: Specification, degrees: Sequence[int]) -> tuple[Program, ...]:
    return tuple(BASES[spec.basis].program(degree) for degree in degrees)


def float32_limits(table: Table) -> list[tuple[float, float]]:
    """Return, for each axis, the first and the last float32 that count as inside.

    A target that works in float32 compares with these: range plus slack, rounded, would disagree by one number.
    """
    found = []
    for first, last in np.transpose(table.limits):
        up, down = np.float32(first), np.float32(last)
        up = up if up >= first else np.nextafter(up, np.float32(np.inf))
        down = down if down <= last else np.nextafter(down, np.float32(-np.inf))
        found.append((float(up), float(down)))
    return found
