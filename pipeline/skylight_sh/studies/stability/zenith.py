"""The sun at the zenith and beside it: powers of the sine in float32, and what weights do as the sun crosses over."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.axis import Axis
from skylight_sh.runtime import Runtime, Table, orders_of
from skylight_sh.studies import compiled
from skylight_sh.studies.page import Row, Section
from skylight_sh.studies.stability import rounding, wide
from skylight_sh.table.powers import in_powers
from skylight_sh.table.table import specification, whole

Array = NDArray[np.float64]

FLAGS = ("-O2", "-ffp-contract=off")
_ANGLES = (0.0, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.3, 1.0)
_NEAR = 40
_AZIMUTHS = np.linspace(-np.pi, np.pi, 13)
_DIGITS = 60
POWERS = (
    "sin^m of the sun's zenith angle, m up to the recommended table's, as the C header and the Python runtime have it, from "
    f"a table whose weights are nothing else, against mpmath in {_DIGITS} digits: at each angle and {_NEAR} numbers of "
    "single precision behind it. The bound of the relative error is, in roundings of 2^-24, m times that of the sine and "
    "m - 1 for the products, and half of 2^-149 for each product that is too small for full precision. Python's sine is "
    "rounded once; the header's is a polynomial: its distance from the sine by mpmath, and each operation's rounding "
    "followed to the result."
)
CROSSING = (
    "Every table that has powers of the sine, in C and Python, with the sun at the zenith and beside it at 13 azimuths: "
    "the largest change of a weight from the zenith itself, relative to the largest weight, at the least, middle and "
    "largest values of the other axes. At the zenith every order m > 0 must be exactly 0 and nothing may hang on the "
    "azimuth. Beside it the change may not exceed the angle times the largest slope on the way, by complex steps, and what "
    "rounding may do: no weight jumps, turned or not."
)


def sections(table: Table, tables: Mapping[str, Table]) -> list[Section]:
    """Measure powers for as many bands as ``table`` has, and crossings of every one of ``tables`` that has parity."""
    own = {name: one for name, one in tables.items() if _crosses(one)}
    with tempfile.TemporaryDirectory() as folder:
        rows = powers(table.bands, Path(folder)) if table.spec.parity else []
        crossed = [row for name, one in own.items() for row in crossing(name, one, Path(folder))]
    return [
        Section("zenith-powers", "Powers of the sine near the zenith", POWERS, rows),
        Section("zenith-crossing", "Across the zenith", CROSSING, crossed),
    ]


def pure(bands: int) -> Table:
    """Return a table of one axis whose weights of order m are sin^m of it, in single precision."""
    axis = Axis("sun_zenith", 0.0, np.pi / 2, "rad", map="even", point=-14.0)
    spec = specification((axis,), ("luminance",), True, "chebyshev", None, peak_axis=axis.name, parity=True)
    return whole(spec, np.ones((1, bands * (bands + 1) // 2, 1)), bands, "float32")


def powers(bands: int, place: Path) -> list[Row]:
    """Measure sin^m in C and Python; C is compiled in ``place``."""
    table = pure(bands)
    angles = np.concatenate([_following(start) for start in _ANGLES])
    exact, short = _exact(angles, bands), rounding.sine_of_header(table, angles)
    inputs = np.stack([angles, np.zeros_like(angles)], axis=1).astype(np.float32)
    highest = np.arange(bands) * (np.arange(bands) + 2)
    found = {
        "Python": (table.whole(table.evaluate(angles[:, np.newaxis]))[:, 0, highest], np.ones_like(angles)),
        "C": (compiled.weights(compiled.header_of(table), inputs, place, FLAGS)[:, 0, highest], short),
    }
    rows: list[Row] = []
    for i, start in enumerate(_ANGLES):
        mine = slice(i * _NEAR, (i + 1) * _NEAR)
        for name, (got, sine) in found.items():
            error, bound = np.abs(got[mine] - exact[mine]), _bound_of_powers(exact[mine], sine[mine])
            # Nothing is relative to 0, which has to be met exactly.
            size = np.where(exact[mine] > 0.0, exact[mine], 1.0)
            at = np.unravel_index(np.argmax(error / size), error.shape)
            holds = bool((error <= bound).all())
            rows.append(
                {
                    "in": name,
                    "zenith angle": start,
                    "relative error": float((error / size)[at]),
                    "of order m": int(at[1]),
                    "relative bound": float((bound / size)[at]),
                    "absolute error": float(error.max()),
                    "absolute bound": float(bound.max()),
                    "holds": "yes" if holds else "no",
                }
            )
    return rows


def _following(start: float) -> Array:
    """Return ``start`` and the single-precision numbers behind it, as doubles; 0 alone, again and again."""
    first = np.float32(start).view(np.int32)
    steps = np.arange(_NEAR, dtype=np.int32) if start else np.zeros(_NEAR, dtype=np.int32)
    return (first + steps).astype(np.int32).view(np.float32).astype(np.float64)


def _exact(angles: Array, bands: int) -> Array:
    """Return sin^m by mpmath, ``(n, bands)``."""
    import mpmath

    with mpmath.workdps(_DIGITS):
        sines = [mpmath.sin(mpmath.mpf(angle)) for angle in angles.tolist()]
        return np.array([[float(sine**m) for m in range(bands)] for sine in sines])


def _bound_of_powers(exact: Array, sine: Array) -> Array:
    m = np.arange(exact.shape[1])
    products = np.maximum(m - 1, 0)
    relative = rounding.UNIT * (m * sine[:, np.newaxis] + products)
    # To first order; 2^-20 of it is more than what the squares of so few roundings add.
    return np.asarray((1.0 + 2.0**-20) * relative * exact + np.where(exact > 0.0, products * rounding.SMALLEST, 0.0))


def _crosses(table: Table) -> bool:
    peak = [axis for axis in table.axes if axis.name == table.spec.peak_axis]
    return table.spec.parity and table.spec.azimuth is None and peak[0].low == 0.0


def crossing(name: str, table: Table, place: Path) -> list[Row]:
    """Move the sun from the zenith, in C and Python; C is compiled in ``place``."""
    header = compiled.header_of(table)

    def in_c(inputs: NDArray[np.float32]) -> Array:
        return compiled.weights(header, inputs, place, FLAGS)

    def in_python(inputs: NDArray[np.float32]) -> Array:
        return np.asarray(Runtime(table).weights(*inputs.astype(np.float64).T), dtype=np.float64)

    bounds = {"C": _limits(in_powers(table), horner=True), "Python": _limits(table, horner=False)}
    rows: list[Row] = []
    for language, evaluate in (("C", in_c), ("Python", in_python)):
        got = _around(table, evaluate)
        size = float(np.abs(got).max())
        turning = orders_of(np.arange(table.bands**2)) != 0
        still = max(float(np.abs(got[0][..., turning]).max()), float(np.abs(got[0] - got[0][:, :1]).max()))
        row: dict[str, object] = {"table": name, "in": language, "at 0": still / size}
        holds = still == 0.0
        for angle, turned, bound in zip(_ANGLES[1:-2], got[1:], bounds[language], strict=True):
            change = np.abs(turned - got[0][:, :1])
            holds = holds and bool((change <= bound[:, np.newaxis]).all())
            row |= {f"at {angle:g}": float(change.max() / size), f"bound {angle:g}": float(bound.max() / size)}
        row["holds"] = "yes" if holds else "no"
        rows.append(row)
    return rows


def _around(table: Table, evaluate: Callable[[NDArray[np.float32]], Array]) -> list[Array]:
    """Return the weights ``(others, azimuths, channels, N*N)`` at each zenith angle."""
    found = []
    for angle in _ANGLES[:-2]:
        sets = np.repeat(_beside(table, angle), _AZIMUTHS.size, axis=0)
        azimuths = np.tile(_AZIMUTHS, len(sets) // _AZIMUTHS.size)
        got = evaluate(np.insert(sets, 1, azimuths, axis=1).astype(np.float32))
        found.append(got.reshape(-1, _AZIMUTHS.size, *got.shape[1:]))
    return found


def _beside(table: Table, angle: float) -> Array:
    """Return parameter sets with the sun at ``angle`` and the other axes at their ends and middles."""
    low, high = np.transpose([(axis.low, axis.high) for axis in table.axes])
    sets = low + (high - low) * np.array([[0.0], [0.5], [1.0]])
    sets[:, _peak(table)] = angle
    return wide.in_single(table, sets)


def _peak(table: Table) -> int:
    return [axis.name for axis in table.axes].index(str(table.spec.peak_axis))


def _limits(table: Table, *, horner: bool) -> list[Array]:
    """Return how far a weight may be from its value at the zenith, ``(others, channels, N*N)``, for each angle but 0."""
    orders = np.abs(orders_of(table.places))
    at_zenith = _beside(table, 0.0)
    own = rounding.bound(table, at_zenith, horner=horner)
    found = []
    for angle in _ANGLES[1:-2]:
        there = _beside(table, angle)
        sine = float(rounding.sine_of_header(table, there[:, _peak(table)]).max()) if horner else 1.0
        rounded = own + rounding.bound(table, there, sine=sine, horner=horner)
        # Waves of the azimuth: sine and cosine, the radius, and products of two waves (Higham 2002, section 3.6).
        waves = rounding.UNIT * (
            orders * (rounding.circle_of_header() + 1.0) + 2.0 * np.sqrt(2.0) * np.maximum(orders - 1, 0) + 1.0
        )
        slope = np.max(
            [np.abs(_slope(table, _on_the_way(table, there, share))) for share in np.linspace(0.0, 1.0, 9)], axis=0
        )
        weights = np.abs(wide.parts(table, there).weights)
        one = slope * there[:, _peak(table)].max() + rounded + waves * weights
        limits = np.zeros((len(there), len(table.channels), table.bands**2))
        limits[..., table.places] = one
        # Order -m is order m by another wave.
        mirrored = table.places - 2 * orders_of(table.places)
        limits[..., mirrored] = one
        found.append(limits)
    return found


def _on_the_way(table: Table, sets: Array, share: float) -> Array:
    found = sets.copy()
    found[:, _peak(table)] *= share
    return found


def _slope(table: Table, sets: Array) -> Array:
    """Return the weights' derivatives after the peak's angle by a complex step (Squire and Trapp 1998)."""
    moved = sets.astype(np.complex128)
    moved[:, _peak(table)] += 1e-30j
    return np.asarray(wide.parts(table, moved).weights.imag / 1e-30)
