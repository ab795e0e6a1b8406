"""One made-up table of every kind of code that a header can hold, for conformance tests and fuzzing."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.axis import Axis
from skylight_sh.light.preetham import Preetham
from skylight_sh.runtime import Specification, Surroundings, Table
from skylight_sh.table.prefactor import closed_form, reciprocal
from skylight_sh.table.row_layout import stored
from skylight_sh.table.table import fast, small, specification
from skylight_sh.table.twilight import TWILIGHT

_SKY = Preetham().hints
_ZENITH = Axis(str(_SKY.peak_axis), 0.0, np.pi / 2, "rad", map="reciprocal", point=5.0)
_TURBIDITY = Axis("turbidity", 2.5, 6.0, map="log", point=0.5)
# Its end is the root's singular point, beyond which the range's end rounds in float32.
_HOUR = Axis("hour", -0.1, 1.7, map="cbrt", point=1.7)
_ALBEDO = Axis("albedo", 0.0, 1.0)
_RGB = ("red", "green", "blue")


def flavours() -> dict[str, Table]:
    """Return the tables by name; the same ones every time."""
    rng = np.random.default_rng(2008)
    two, three = (_ZENITH, _TURBIDITY), (_ZENITH, _TURBIDITY, _ALBEDO)
    specified = tuple(axis.specified for axis in two)
    closed = closed_form(_SKY.prefactor, specified) if _SKY.prefactor else None
    classes = closed_form(_SKY.classes, specified) if _SKY.classes else None
    even: dict[str, Any] = {"peak_axis": _ZENITH.name, "parity": True}
    found = reciprocal(np.array([[2.0, 0.3], [0.4, 0.1], [0.1, 0.0]], dtype=np.float32), specified)
    sinking: dict[str, Any] = {"twilight": TWILIGHT}
    made = {
        "rows": _rows(rng, specification(two, _RGB, True, "chebyshev", closed), (9, 5), 7, "float32"),
        "packed": _packed(rng, specification(two, _RGB, True, "chebyshev", closed), (9, 5), 7),
        "float64": _rows(rng, specification(two, _RGB, True, "chebyshev", found), (6, 4), 4, "float64"),
        "one-axis": _rows(rng, specification((_HOUR,), ("luminance",), True, "legendre", None), (6,), 5, "float32"),
        "unmirrored": _rows(rng, specification(three, _RGB[:2], False, "monomial", None), (5, 3, 1), 5, "float32"),
        "twilight": _rows(
            rng, specification(two, ("luminance",), True, "chebyshev", closed, **sinking), (5, 2), 3, "float32"
        ),
        "twilight-packed": _packed(rng, specification(two, _RGB, True, "chebyshev", None, **sinking), (5, 2), 3),
        "surrounded": replace(
            _rows(rng, specification(two, _RGB, True, "chebyshev", closed), (5, 2), 3, "float32"), surroundings=_around(rng)
        ),
        "unmirrored-packed": _packed(rng, specification((_TURBIDITY,), _RGB, False, "fourier", None), (4,), 3),
        "classes": _rows(rng, specification(two, _RGB, True, "chebyshev", classes, **even), (9, 5), 7, "float32"),
        "classes-packed": _packed(rng, specification(two, _RGB, True, "chebyshev", classes, **even), (6, 3), 4),
        "classes-float64": _rows(
            rng, specification(two, _RGB, True, "chebyshev", classes, **even, **sinking), (5, 2), 5, "float64"
        ),
        "classes-surrounded": replace(
            _rows(rng, specification(two, _RGB, False, "chebyshev", classes, **even), (5, 2), 3, "float32"),
            surroundings=_around(rng),
        ),
        "parity": _rows(rng, specification(two, ("luminance",), True, "chebyshev", closed, **even), (5, 2), 6, "float32"),
        "irradiance": _rows(
            rng, specification(two, _RGB, True, "chebyshev", classes, **even, quantity="irradiance"), (5, 2), 7, "float32"
        ),
    }
    return {name: _with_sun(table) if table.spec.axes[0].name == _ZENITH.name else table for name, table in made.items()}


def _with_sun(table: Table) -> Table:
    return replace(table, spec=replace(table.spec, peak_axis=_ZENITH.name))


def _around(rng: np.random.Generator) -> Surroundings:
    """Return surroundings of three bands and three channels, every part of them."""
    return Surroundings(np.eye(9) / 2 + rng.normal(size=(9, 9)) / 20, *rng.normal(size=(2, 3, 9)) / 10)


def _dense(rng: np.random.Generator, spec: Specification, degrees: tuple[int, ...], bands: int) -> NDArray[np.float64]:
    """Return coefficients ``(classes, count, d_1+1, ..)`` that fall off with the degree, as those of smooth lights do."""
    sizes = tuple(d + 1 for d in degrees)
    dense = rng.normal(size=(spec.classes, stored(spec, bands).count, *sizes))
    return np.asarray(dense * 2.0 ** -np.sum(np.indices(sizes), axis=0))


def _rows(rng: np.random.Generator, spec: Specification, degrees: tuple[int, ...], bands: int, dtype: str) -> Table:
    dense = _dense(rng, spec, degrees, bands)
    # Each class keeps fewer terms than the one before.
    rest = np.sum(np.indices(dense.shape[3:]), axis=0) if len(degrees) > 1 else np.array(0)
    lengths = np.stack([np.maximum(degrees[0] + 1 - rest - k, 0) for k in range(len(dense))])
    return fast(spec, dense, lengths, bands, dtype)


def _packed(rng: np.random.Generator, spec: Specification, degrees: tuple[int, ...], bands: int) -> Table:
    dense = _dense(rng, spec, degrees, bands).swapaxes(0, 1)
    whole = np.rint(2000 * dense.reshape(*dense.shape[:2], degrees[0] + 1, -1)).astype(np.int64)
    return small(spec, whole, 0.0005, degrees, bands)
