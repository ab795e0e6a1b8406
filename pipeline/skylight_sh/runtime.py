"""Evaluate an exported table: ``load("skylight_sh.npz").weights(sun_zenith, sun_azimuth, turbidity)``.

This one file needs NumPy and nothing else: it may be copied into any project. What a table's formulas are (changes of
variable, basis, prefactor) travels in the file as programs, lists of arithmetic steps, so that a table of tomorrow needs
no other reader. Weights are those of real orthonormal spherical harmonics without the Condon-Shortley sign, z up, flat
index l*(l+1)+m, m > 0 cosine, m < 0 sine; angles are radians.
"""

from __future__ import annotations

import json
import math
import zipfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import MISSING, dataclass, field, fields
from functools import cached_property, partial
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Floats = NDArray[np.floating]
Index = NDArray[np.int64]

# 4: formulas as programs, one specification; what is added later has a default, so that 4 stays readable.
FORMAT = 4
OK, CLAMPED, INVALID = 0, 1, 2
# Beyond this share of the range (or of 1, if that is more) an input counts as outside: float32 pi/2 exceeds pi/2.
SLACK = 1e-6
_SETS_AT_ONCE = 2048
# Rows of a product that are summed at once: they stay in a first-level cache.
_ROWS_AT_ONCE = 128
_MOST_STEPS = 100_000
_FIELD = 5


def load(path: str | Path | BinaryIO) -> Runtime:
    """Load a table from an exported NPZ. Raises ValueError where the file is not one, or one of a later version."""
    return Runtime(read(path))


def in_double(function: Callable[[Any], Any], values: Floats) -> Floats:
    """Return an elementary ``function`` of ``values`` in their dtype, computed in double precision.

    Libraries' single-precision functions differ in the last bit between processors; a double result, rounded, does not.

    >>> in_double(np.log, np.float32([1.0, 2.0])).dtype
    dtype('float32')
    """
    wide = np.asarray(values, dtype=np.float64, order="C")
    return np.asarray(function(wide), dtype=np.asarray(values).dtype)


def product(left: Floats, right: Floats) -> Floats:
    """Return ``left @ right`` of shapes ``(n, terms)`` and ``(terms, m)``, every sum term by term from the first.

    A row's bits depend on that row alone, not on its neighbours; a library's matrix product promises neither. Works in
    the common dtype.

    >>> product(np.array([[1.0, 2.0]]), np.array([[3.0], [4.0]])).tolist()
    [[11.0]]
    """
    out = np.zeros((left.shape[0], right.shape[1]), dtype=np.result_type(left, right))
    for start in range(0, len(left), _ROWS_AT_ONCE):
        rows = slice(start, start + _ROWS_AT_ONCE)
        total, columns = out[rows], np.ascontiguousarray(left[rows].T)
        term = np.empty_like(total)
        for column, row in zip(columns, right, strict=True):
            np.multiply(column[:, np.newaxis], row, out=term)
            total += term
    return out


def flat_places(bands: int, *, mirrored: bool) -> Index:
    """Return the flat index of every stored weight: all N*N, or those of order m >= 0 where ``mirrored``.

    >>> flat_places(2, mirrored=True).tolist()
    [0, 2, 3]
    """
    return np.array([l * (l + 1) + m for l in range(bands) for m in range(0 if mirrored else -l, l + 1)])


def turned(weight: Any, partner: Any, cosine: Any, sine: Any) -> Any:
    """Return a weight of order m, turned: ``partner`` is that of order -m, cosine and sine are of m times the azimuth.

    Equation 4 of Habel et al. 2008, for generic numbers.
    """
    return weight * cosine - partner * sine


def rotate_azimuth(weights: Floats, azimuth: Floats) -> Floats:
    """Turn weights ``(..., N*N)`` by ``azimuth`` ``(...)`` radians about +z, +x towards +y (Habel et al. 2008, eq. 4).

    >>> rotate_azimuth(np.array([1.0, 0.0, 2.0, 3.0]), np.pi / 2).round(12).tolist()
    [1.0, 3.0, 2.0, 0.0]
    """
    bands = math.isqrt(weights.shape[-1])
    orders = np.concatenate([np.arange(-l, l + 1) for l in range(bands)])
    partner = np.arange(bands * bands) - 2 * orders
    angle = np.abs(orders) * np.asarray(azimuth, dtype=np.float64)[..., np.newaxis]
    cosine = np.cos(angle).astype(weights.dtype)
    sine = (np.sign(orders) * np.sin(angle)).astype(weights.dtype)
    return np.asarray(turned(weights, weights[..., partner], cosine, sine))


def zonal_sinc(bands: int) -> Array:
    """Return the factors ``(N*N,)`` of the zonal window ``sinc(pi l / N)``, m = 0 alone (Habel et al. 2008, eq. 5).

    >>> zonal_sinc(2).round(4).tolist()
    [1.0, 1.0, 0.6366, 1.0]
    """
    factors = np.ones(bands * bands)
    l = np.arange(bands)
    factors[l * (l + 1)] = np.sinc(l / bands)
    return factors


FUNCTIONS: Mapping[str, Callable[[Any], Any]] = {
    name: partial(in_double, function)
    for name, function in {
        "log": np.log,
        "exp": np.exp,
        "sin": np.sin,
        "cos": np.cos,
        "sqrt": np.sqrt,
        "cbrt": np.cbrt,
    }.items()
}
_OPERATORS: Mapping[str, Callable[[Any, Any], Any]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
}


@dataclass(frozen=True)
class Program:
    """A formula as a list of steps, each using earlier ones alone.

    A step is ``("number", value)``, ``("constant", place)``, ``("input", place)``, ``("negative", step)``, an operator with
    two steps or a function's name with one; ``outputs`` are the steps asked for, ``labels`` steps' names for people.
    """

    inputs: tuple[str, ...]
    constants: tuple[float, ...]
    steps: tuple[tuple[str | int | float, ...], ...]
    outputs: tuple[int, ...]
    labels: tuple[tuple[int, str], ...] = ()

    @property
    def literals(self) -> tuple[float, ...]:
        """The different numbers that stand in the formula itself, beside its constants."""
        return tuple(dict.fromkeys(float(step[1]) for step in self.steps if step[0] == "number"))

    def run(self, values: Sequence[ArrayLike]) -> list[Floats]:
        """Return the outputs at ``values``, one array an input that broadcast, in their dtype.

        >>> half = Program(("x",), (), (("input", 0), ("number", 2.0), ("/", 0, 1)), (2,))
        >>> half.run([np.array([1.0, 3.0])])[0].tolist()
        [0.5, 1.5]
        """
        arrays = [np.asarray(value) for value in values]
        real = np.result_type(*arrays, np.float32)
        done: list[Any] = []
        for operation, *arguments in self.steps:
            if operation == "number":
                done.append(real.type(arguments[0]))
            elif operation == "input":
                done.append(arrays[int(arguments[0])])
            elif operation == "constant":
                done.append(real.type(self.constants[int(arguments[0])]))
            elif operation == "negative":
                done.append(-done[int(arguments[0])])
            elif operation in FUNCTIONS:
                done.append(FUNCTIONS[str(operation)](done[int(arguments[0])]))
            else:
                done.append(_OPERATORS[str(operation)](*(done[int(place)] for place in arguments)))
        return [done[place] for place in self.outputs]

    def check(self, name: str, inputs: int, outputs: int | None = None) -> None:
        """Raise ValueError where the program is no formula of so many inputs and outputs."""
        sizes = {"number": 1, "input": 1, "constant": 1, "negative": 1, **dict.fromkeys(FUNCTIONS, 1)}
        sizes |= dict.fromkeys(_OPERATORS, 2)
        if len(self.steps) > _MOST_STEPS or len(self.inputs) != inputs or not all(map(math.isfinite, self.constants)):
            raise ValueError(
                f"{name} has {len(self.steps)} steps, the inputs {self.inputs}, or constants that are not finite"
            )
        limits = {"input": inputs, "constant": len(self.constants)}
        for place, (operation, *arguments) in enumerate(self.steps):
            if len(arguments) != sizes.get(str(operation), -1):
                raise ValueError(f"{name} has the unknown step {(operation, *arguments)}: a newer version wrote it")
            if operation == "number":
                sound = isinstance(arguments[0], int | float) and math.isfinite(arguments[0])
            else:
                sound = all(type(a) is int and 0 <= a < limits.get(str(operation), place) for a in arguments)
            if not sound:
                raise ValueError(f"{name} has the impossible step {(operation, *arguments)}")
        known = range(len(self.steps))
        if not all(type(place) is int and place in known for place in self.outputs):
            raise ValueError(f"{name} has the impossible outputs {self.outputs}")
        if outputs not in (None, len(self.outputs)):
            raise ValueError(f"{name} has the impossible outputs {self.outputs}: there should be {outputs}")
        # They become names in code.
        if not all(place in known and isinstance(word, str) and word.isidentifier() for place, word in self.labels):
            raise ValueError(f"{name} has the impossible labels {self.labels}")


@dataclass(frozen=True)
class Axis:
    """An input ``name`` over ``[low, high]`` in ``unit``; ``variable`` is the program of its change of variable.

    ``map`` and ``point`` name the change of variable for people.
    """

    name: str
    low: float
    high: float
    unit: str
    map: str
    point: float
    variable: Program


@dataclass(frozen=True)
class Scale:
    """What sums are multiplied with: ``program`` of the axes' values, ``name`` and ``fixed`` parameters for people.

    ``kind`` is ``closed form``, a light's prefactor, or ``reciprocal``, 1 over a polynomial found in samples. A program with
    one output is a factor of all weights; one with more is a matrix ``(channels, classes)``, row by row: a table keeps sums
    of so many classes, and each channel's weight is made of those of all classes.
    """

    kind: str
    name: str
    program: Program
    fixed: tuple[tuple[str, float], ...] = ()


@dataclass(frozen=True)
class Twilight:
    """How the light of a sun on the horizon fades as it sinks: ``program`` of its depth, 0 to 1 over ``depth`` radians."""

    depth: float
    program: Program


@dataclass(frozen=True)
class Specification:
    """What a table is but its coefficients: all that an evaluation and its reader must know.

    Weights are those of order m >= 0 where ``mirrored``, else all N*N. ``quantity`` is ``radiance`` or ``irradiance``;
    ``windowed`` says that the window of eq. 5 is in the weights; ``azimuth`` is the sun's where it is no input (radians);
    ``ground`` is ``black``, ``mirror`` or one albedo a channel; ``sun_disc`` says that the sun's disc is in the weights;
    ``peak_axis`` names the axis that is the zenith angle of the light's peak, which ``twilight`` extends. With ``parity``
    sums of order m are the weights over sin^m of that angle.
    """

    axes: tuple[Axis, ...]
    channels: tuple[str, ...]
    mirrored: bool
    basis: str
    scale: Scale | None = None
    quantity: str = "radiance"
    windowed: bool = False
    azimuth: float | None = None
    ground: str | tuple[float, ...] = "black"
    sun_disc: bool = False
    peak_axis: str | None = None
    twilight: Twilight | None = None
    parity: bool = False

    @property
    def classes(self) -> int:
        """How many sums a weight of all channels is made of: one a channel, or those of the scale's matrix."""
        outputs = len(self.scale.program.outputs) if self.scale else 1
        return len(self.channels) if outputs == 1 else outputs // len(self.channels)


@dataclass(frozen=True)
class ClassRows:
    """A body laid out for speed: for each class in turn a row of coefficients for each term that the class keeps.

    ``lengths`` ``(classes, rest)``: terms of the first axis for each product of the others' functions, last axis fastest;
    ``rows`` ``(terms of all classes, width)``, a class after another; ``columns`` ``(count,)``: each weight's column, or -1.
    """

    lengths: NDArray[np.uint8]
    rows: Floats
    columns: NDArray[np.int16]

    @property
    def kind(self) -> str:
        """Name of this layout."""
        return "rows"

    @property
    def dtype(self) -> np.dtype[np.floating]:
        """Number type of coefficients and arithmetic."""
        return self.rows.dtype

    @property
    def starts(self) -> list[int]:
        """The first row of each class, and the number of rows."""
        return [0, *np.cumsum(self.lengths.sum(axis=1, dtype=np.int64)).tolist()]


@dataclass(frozen=True)
class Rows:
    """A body as earlier versions wrote it: a row of coefficients ``(terms, width)`` for each term, which all channels keep.

    ``lengths`` ``(rest,)``: terms of the first axis for each product of the others' functions, last axis fastest;
    ``columns`` ``(channels, count)``: each weight's column, or -1.
    """

    lengths: NDArray[np.uint8]
    rows: Floats
    columns: NDArray[np.int16]

    @property
    def kind(self) -> str:
        """Name of this layout."""
        return "rows"

    @property
    def dtype(self) -> np.dtype[np.floating]:
        """Number type of coefficients and arithmetic."""
        return self.rows.dtype


@dataclass(frozen=True)
class Packed:
    """A body in few bytes: a coefficient is ``step`` times a whole number of ``stream``, Rice codes that ``unpack`` reads.

    ``first`` is the longest run of the first axis; the profiles are small whole numbers, one a product of the other axes'
    functions and one a class.
    """

    stream: bytes
    first: int
    rest_profile: Index
    channel_profile: Index
    step: float

    @property
    def kind(self) -> str:
        """Name of this layout."""
        return "packed"

    @property
    def dtype(self) -> np.dtype[np.floating]:
        """Number type of the arithmetic."""
        return np.dtype(np.float32)


_NONE: Array = np.zeros(0)


@dataclass(frozen=True)
class Surroundings:
    """What a scene does to the weights once the sun is turned.

    ``weights -> transfer @ weights + own``, then ``+ below * weights[l = 1, m = 0]``. ``transfer`` is ``(N*N, N*N)``,
    ``own`` and ``below`` ``(channels, N*N)``; each of size 0 where it does nothing.
    """

    transfer: Array = field(default_factory=lambda: _NONE)
    own: Array = field(default_factory=lambda: _NONE)
    below: Array = field(default_factory=lambda: _NONE)

    def apply(self, weights: Floats, bands: int) -> Floats:
        """Return the first ``bands`` bands of the scene, ``(..., channels, M*M)``, from all ``(..., channels, N*N)``."""
        real, out = weights.dtype, weights
        if self.transfer.size:
            flat = product(weights.reshape(-1, weights.shape[-1]), self.transfer.T.astype(real))
            out = flat.reshape(*weights.shape[:-1], -1)
        if self.own.size:
            out = out + self.own.astype(real)
        if self.below.size:
            out = out + self.below.astype(real) * out[..., 2:3]
        return out[..., : bands * bands]


@dataclass(frozen=True)
class Table:
    """A table: its ``spec``, its number of ``bands``, the program of each axis's functions, and its coefficients.

    ``terms`` have the axis's variable as their input and functions 0, 1, .. as outputs. ``provenance`` is JSON-like and says
    where the table comes from.
    """

    spec: Specification
    bands: int
    terms: tuple[Program, ...]
    body: ClassRows | Packed | Rows
    surroundings: Surroundings | None = None
    provenance: Mapping[str, object] = field(default_factory=dict)

    @property
    def axes(self) -> tuple[Axis, ...]:
        """The inputs but the azimuth."""
        return self.spec.axes

    @property
    def channels(self) -> tuple[str, ...]:
        """Names of the channels."""
        return self.spec.channels

    @property
    def dtype(self) -> np.dtype[np.floating]:
        """Number type of the arithmetic."""
        return self.body.dtype

    @property
    def degrees(self) -> tuple[int, ...]:
        """The largest degree of each axis."""
        return tuple(len(program.outputs) - 1 for program in self.terms)

    @cached_property
    def places(self) -> Index:
        """The flat index of every stored weight, ``(count,)``."""
        return flat_places(self.bands, mirrored=self.spec.mirrored)

    @cached_property
    def matrices(self) -> list[tuple[Index, Floats]]:
        """Of each class: places of its terms among all products of functions, and coefficients ``(terms, count)``."""
        rest, body = math.prod(degree + 1 for degree in self.degrees[1:]), self.body
        if isinstance(body, Packed):
            numbers = unpack(body, self.places)
            values = numbers.astype(self.dtype) * self.dtype.type(body.step)
            # The last products of functions may be missing where nothing keeps them.
            places = (np.arange(values.shape[2])[:, np.newaxis] * rest + np.arange(values.shape[3])).ravel()
            flat = values.transpose(1, 2, 3, 0).reshape(values.shape[1], places.size, -1)
            return [(places, np.ascontiguousarray(matrix)) for matrix in flat]
        if isinstance(body, Rows):
            kept = kept_terms(body.lengths)
            return [(kept, _spread(body.rows, columns)) for columns in body.columns]
        parts = zip(body.lengths, body.starts, body.starts[1:], strict=False)
        return [(kept_terms(lengths), _spread(body.rows[start:end], body.columns)) for lengths, start, end in parts]

    def evaluate(self, values: Array) -> Floats:
        """Return the stored weights at parameter sets ``(n, axes)``, azimuth 0: ``(n, channels, count)``.

        Works in the table's dtype throughout, terms summed in their order, so that a set's bits depend on nothing but the
        set. Values must lie in the axes' ranges.
        """
        out = np.empty((len(values), len(self.channels), self.places.size), dtype=self.dtype)
        for start in range(0, len(values), _SETS_AT_ONCE):
            part = values[start : start + _SETS_AT_ONCE].astype(self.dtype)
            # A column of its own: libraries' functions may treat numbers that do not lie side by side otherwise.
            columns = [np.ascontiguousarray(part[:, i]) for i in range(part.shape[1])]
            terms = np.ones((len(part), 1), dtype=self.dtype)
            for axis, program, column in zip(self.axes, self.terms, columns, strict=True):
                functions = np.ones((len(part), len(program.outputs)), dtype=self.dtype)
                for k, found in enumerate(program.run(axis.variable.run([column]))):
                    functions[:, k] = found
                terms = (terms[:, :, np.newaxis] * functions[:, np.newaxis, :]).reshape(len(part), -1)
            sums = [product(terms[:, places], matrix) for places, matrix in self.matrices]
            out[start : start + _SETS_AT_ONCE] = self._mixed(sums, columns)
        return out

    def _mixed(self, sums: Sequence[Floats], columns: Sequence[Floats]) -> Floats:
        """Return the weights ``(n, channels, count)`` of the classes' ``sums``, each ``(n, count)``, at the axes' values."""
        made = np.stack(sums, axis=1)
        if self.spec.scale:
            factors = [np.broadcast_to(f, len(made))[:, np.newaxis] for f in self.spec.scale.program.run(columns)]
            if len(factors) == 1:
                made = made * factors[0][:, np.newaxis]
            else:
                rows = np.split(np.arange(len(factors)), len(self.channels))
                made = np.stack([sum(factors[i] * one for i, one in zip(row, sums, strict=True)) for row in rows], axis=1)
        if self.spec.parity:
            names = [axis.name for axis in self.axes]
            sines = FUNCTIONS["sin"](columns[names.index(str(self.spec.peak_axis))])
            made = made * powers(sines, self.bands)[:, np.newaxis, np.abs(orders_of(self.places))]
        return made

    def whole(self, stored: Floats, bands: int | None = None) -> Floats:
        """Spread stored weights of at least ``bands`` bands, ``(..., count)``, over all N*N of them, ``(..., bands**2)``."""
        bands = self.bands if bands is None else bands
        places = flat_places(bands, mirrored=self.spec.mirrored)
        full = np.zeros((*stored.shape[:-1], bands * bands), dtype=stored.dtype)
        full[..., places] = stored[..., : places.size]
        return full

    @property
    def ranges(self) -> list[tuple[float, float]]:
        """Least and largest value of each input: its axis's range, which twilight extends."""
        sinking, twilight = self._sinking, self.spec.twilight
        return [
            (axis.low, axis.high + twilight.depth if twilight and i == sinking else axis.high)
            for i, axis in enumerate(self.axes)
        ]

    def fade(self, values: Array) -> Array:
        """Return what twilight multiplies weights with at inputs ``(n, axes)``, not clamped, ``(n,)``: ones without one."""
        twilight, sinking = self.spec.twilight, self._sinking
        if not twilight or sinking is None:
            return np.ones(len(values))
        depth = np.clip((values[:, sinking] - self.axes[sinking].high) / twilight.depth, 0.0, 1.0)
        return np.asarray(twilight.program.run([depth])[0], dtype=np.float64)

    @property
    def _sinking(self) -> int | None:
        names = [axis.name for axis in self.axes]
        return names.index(self.spec.peak_axis) if self.spec.twilight and self.spec.peak_axis in names else None

    def clamp(self, values: Array) -> tuple[Array, NDArray[np.bool_]]:
        """Clamp ``(n, axes)`` to the ranges; the second result marks sets with a value beyond the slack."""
        first, last = self.limits
        outside = np.any((values < first) | (values > last), axis=-1)
        return np.clip(values, [axis.low for axis in self.axes], [axis.high for axis in self.axes]), outside

    @property
    def limits(self) -> tuple[Array, Array]:
        """Least and largest value of each input that counts as inside."""
        low, high = np.transpose(self.ranges)
        slack = SLACK * np.maximum(high - low, 1.0)
        return low - slack, high + slack


def _spread(rows: Floats, columns: NDArray[np.integer]) -> Floats:
    """Return the weights' coefficients ``(terms, count)`` of ``rows``; 0 where a column is -1."""
    return np.ascontiguousarray((rows[:, columns] * (columns >= 0)).astype(rows.dtype))


def orders_of(places: Index) -> Index:
    """Return the order m of each flat index l (l + 1) + m.

    >>> orders_of(np.array([0, 1, 2, 3])).tolist()
    [0, -1, 0, 1]
    """
    degrees = np.array([math.isqrt(place) for place in places.tolist()], dtype=np.int64)
    return np.asarray(places - degrees * (degrees + 1))


def powers(base: Floats, count: int) -> Floats:
    """Return ``base`` ``(n,)`` to the powers 0, 1, .. ``count - 1``, ``(n, count)``, by doubling as C does.

    >>> powers(np.array([2.0]), 5).tolist()
    [[1.0, 2.0, 4.0, 8.0, 16.0]]
    """
    out = np.ones((len(base), count), dtype=base.dtype)
    for m in range(1, count):
        out[:, m] = out[:, m // 2] * out[:, m - m // 2] if m > 1 else base
    return out


def kept_terms(lengths: NDArray[np.integer]) -> Index:
    """Return the kept terms' places in a dense ``(first, rest)`` array, in the order of ``Rows``: ``(terms,)``.

    >>> kept_terms(np.array([2, 1])).tolist()
    [0, 2, 1]
    """
    return np.concatenate([np.arange(int(n)) * lengths.size + r for r, n in enumerate(lengths)]).astype(np.int64)


class BitReader:
    """Reads whole numbers from bytes, low bit of each byte first. Raises IndexError beyond the end."""

    def __init__(self, data: bytes) -> None:
        self._bits = np.unpackbits(np.frombuffer(data, dtype=np.uint8), bitorder="little").tolist()
        self._at = 0

    def fixed(self, width: int) -> int:
        """Read ``width`` bits as a number of at least 0."""
        start, self._at = self._at, self._at + width
        if self._at > len(self._bits):
            raise IndexError("The bits of a packed table end early.")
        return sum(bit << i for i, bit in enumerate(self._bits[start : self._at]))

    def rice(self, low_bits: int) -> int:
        """Read a signed number: its folded high part as that many ones and a zero, then ``low_bits`` low bits."""
        high = 0
        while self._bits[self._at]:
            high += 1
            self._at += 1
        self._at += 1
        folded = (high << low_bits) | self.fixed(low_bits)
        return -(folded + 1) // 2 if folded & 1 else folded // 2


def unpack(packed: Packed, places: Index) -> Index:
    """Return the whole numbers ``(count, channels, first, rest)`` of the stored weights at flat ``places`` ``(count,)``.

    ``places`` may be those of fewer bands than the stream holds. The format is described in ``table/packed.py``.
    """
    reader = BitReader(packed.stream)
    numbers = np.zeros((places.size, packed.channel_profile.size, packed.first, packed.rest_profile.size), dtype=np.int64)
    lengths = np.zeros((packed.channel_profile.size, packed.rest_profile.size), dtype=np.int64)
    profile: list[int] = []
    band = -1
    for w, place in enumerate(places.tolist()):
        if math.isqrt(place) != band:
            band = math.isqrt(place)
            profile = [reader.fixed(_FIELD) for _ in range(reader.fixed(_FIELD))]
        for channel, rest in np.ndindex(*lengths.shape):
            lengths[channel, rest] += reader.rice(0)
            level = int(packed.rest_profile[rest]) + int(packed.channel_profile[channel])
            for i in range(int(lengths[channel, rest])):
                numbers[w, channel, i, rest] = reader.rice(max(profile[i] + level, 0) >> 1)
    return numbers


@dataclass(frozen=True)
class Runtime:
    """An exported table, ready to evaluate in its own number type, like the C header."""

    table: Table

    @property
    def inputs(self) -> tuple[str, ...]:
        """Names of the inputs in order: the first axis, ``sun_azimuth`` unless the table fixes it, the other axes."""
        first, *rest = (axis.name for axis in self.table.axes)
        azimuth = ("sun_azimuth",) if self.table.spec.azimuth is None else ()
        return (first, *azimuth, *rest)

    def weights(self, *values: ArrayLike, bands: int | None = None, window: bool = False, **named: ArrayLike) -> Floats:
        """Return SH weights ``(..., channels, N*N)`` for inputs that broadcast to ``(...)``, angles in radians.

        Inputs come in the order of ``inputs`` or by name. Out-of-range inputs are clamped, a NaN (or an infinite
        azimuth) gives zeros; ``status`` tells which. ``bands`` cuts to fewer bands, ``window`` applies the zonal
        window of eq. 5. Raises TypeError for a missing or unknown input, ValueError for impossible bands.
        """
        return self.weights_and_status(*values, bands=bands, window=window, **named)[0]

    def status(self, *values: ArrayLike, **named: ArrayLike) -> Index:
        """Return, for each set of inputs, what the C header returns: 0, 1 where clamped, 2 where invalid."""
        columns = self._columns(values, named)
        return self._check(columns.reshape(-1, columns.shape[-1]))[3].reshape(columns.shape[:-1])

    def weights_and_status(
        self, *values: ArrayLike, bands: int | None = None, window: bool = False, **named: ArrayLike
    ) -> tuple[Floats, Index]:
        """Return ``weights`` and ``status`` of one evaluation."""
        table = self.table
        bands = table.bands if bands is None else bands
        if not 1 <= bands <= table.bands:
            raise ValueError(f"Invalid bands {bands}. Should be 1 to {table.bands}, the bands of this table.")
        if window and table.spec.windowed:
            raise ValueError("The window is in the weights of this table already. Leave window=False.")
        inputs = self._columns(values, named)
        shape = inputs.shape[:-1]
        clamped, fade, azimuth, status = self._check(inputs.reshape(-1, inputs.shape[-1]))
        # What surrounds the sky carries light from band to band.
        full = table.whole(table.evaluate(clamped), table.bands if table.surroundings else bands)
        if table.spec.twilight:
            full = full * fade.astype(full.dtype)[:, np.newaxis, np.newaxis]
        out = rotate_azimuth(full, azimuth[:, np.newaxis])
        if table.surroundings:
            out = table.surroundings.apply(out, bands)
        if window:
            out = out * zonal_sinc(bands).astype(out.dtype)
        if table.spec.windowed and bands < table.bands:
            # The window follows the number of bands.
            out = out * (zonal_sinc(bands) / zonal_sinc(table.bands)[: bands * bands]).astype(out.dtype)
        out[status == INVALID] = 0.0
        return out.reshape(*shape, len(table.channels), bands * bands), status.reshape(shape)

    def _columns(self, values: tuple[ArrayLike, ...], named: dict[str, ArrayLike]) -> Array:
        """Broadcast the inputs against each other, in order along the last axis."""
        inputs = np.broadcast_arrays(*(np.asarray(v, dtype=np.float64) for v in self._bind(values, named)))
        return np.stack(inputs, axis=-1)

    def _check(self, columns: Array) -> tuple[Array, Array, Array, Index]:
        """Return axis values inside their ranges ``(n, axes)``, twilight's factors, azimuths and status ``(n,)``."""
        turned = self.table.spec.azimuth
        azimuth = columns[:, 1] if turned is None else np.full(len(columns), turned)
        invalid = np.isnan(columns).any(axis=1) | np.isinf(azimuth.astype(np.float64))
        columns = np.where(invalid[:, np.newaxis], 0.0, columns)
        azimuth = np.where(invalid, 0.0, azimuth)
        values = np.delete(columns, 1, axis=1) if turned is None else columns
        clamped, outside = self.table.clamp(values)
        return clamped, self.table.fade(values), azimuth, np.where(invalid, INVALID, np.where(outside, CLAMPED, OK))

    def _bind(self, values: tuple[ArrayLike, ...], named: dict[str, ArrayLike]) -> list[ArrayLike]:
        names = self.inputs
        given = dict(zip(names, values, strict=False)) | named
        if len(values) > len(names) or len(given) < len(values) + len(named) or set(given) != set(names):
            raise TypeError(f"weights() takes exactly the inputs {', '.join(names)}, by position or by name.")
        return [given[name] for name in names]


def read(path: str | Path | BinaryIO) -> Table:
    """Read a table from an exported NPZ and check it. Raises ValueError where the file is not one, or of a later version."""
    try:
        # NumPy takes anything that is no archive for a pickle, and would advise to trust it.
        if not zipfile.is_zipfile(path):
            raise ValueError(_no_archive(path))
        with np.load(path, allow_pickle=False) as archive:
            header = json.loads(str(archive["header"]))
            found = header.get("format")
            if found != FORMAT:
                later = isinstance(found, int) and found > FORMAT
                remedy = "a newer version wrote it" if later else "run the fit again"
                raise ValueError(f"its format is {found!r}, this version reads {FORMAT}: {remedy}")
            table = _decoded(header["table"], archive)
        if not isinstance(table, Table):
            raise ValueError(f"it holds a {type(table).__name__}")
        for wrong in _wrong(table):
            raise ValueError(wrong)
    except (OSError, LookupError, AttributeError, TypeError, ValueError, EOFError, zipfile.BadZipFile) as error:
        raise ValueError(f"{path} is no table of this pipeline ({error}). Give the .npz that a run exported.") from error
    return table


def _no_archive(path: str | Path | BinaryIO) -> str:
    """Say what ``path`` is instead of an archive."""
    place = Path(path) if isinstance(path, str | Path) else None
    if place and place.is_dir():
        return "it is a folder"
    return "it is no archive" if not place or place.exists() else "there is no such file"


# What a file may hold, by the name that stands in it under "is".
KINDS: Mapping[str, Any] = {
    kind.__name__: kind
    for kind in (Table, Specification, Axis, Program, Scale, Twilight, ClassRows, Rows, Packed, Surroundings)
}


def _decoded(value: Any, arrays: Mapping[str, NDArray[Any]]) -> Any:
    """Return what ``table/npz.py`` has encoded; fields that a file lacks have their defaults, unknown ones are refused."""
    if isinstance(value, list):
        return tuple(_decoded(part, arrays) for part in value)
    if not isinstance(value, dict):
        return value
    if "array" in value:
        return arrays[value["array"]]
    if "bytes" in value:
        return arrays[value["bytes"]].astype(np.uint8).tobytes()
    if "json" in value:
        return value["json"]
    if value["is"] not in KINDS:
        raise ValueError(f"it holds a {value['is']}: a newer version wrote it")
    kind = KINDS[value["is"]]
    known = {f.name for f in fields(kind)}
    unknown = sorted(set(value) - known - {"is"})
    if unknown:
        raise ValueError(f"its {value['is']} has {', '.join(unknown)}: a newer version wrote it")
    missing = [f.name for f in fields(kind) if f.default is MISSING and f.default_factory is MISSING and f.name not in value]
    if missing:
        raise ValueError(f"its {value['is']} lacks {', '.join(missing)}")
    return kind(**{name: _decoded(part, arrays) for name, part in value.items() if name != "is"})


def _wrong(table: Table) -> Iterator[str]:
    """Yield what makes no sense in a table that was read."""
    spec, body, bands = table.spec, table.body, table.bands
    if type(bands) is not int or not 1 <= bands <= 64 or not spec.axes or not spec.channels:
        yield f"it has {bands!r} bands, {len(spec.axes)} axes and {len(spec.channels)} channels"
    if len(table.terms) != len(spec.axes):
        yield f"it has {len(table.terms)} lists of functions for {len(spec.axes)} axes"
    yield from _wrong_specification(spec)
    for axis, terms in zip(spec.axes, table.terms, strict=True):
        terms.check(f"its axis {axis.name}", 1)
    if isinstance(body, Packed):
        yield from _wrong_stream(table, body)
    else:
        yield from _wrong_rows(table, body)
    yield from _wrong_surroundings(table, table.surroundings) if table.surroundings else ()


def _wrong_specification(spec: Specification) -> Iterator[str]:
    names = [axis.name for axis in spec.axes]
    if len(set(names)) < len(names):
        yield f"its axes are {', '.join(names)}"
    for axis in spec.axes:
        if not (math.isfinite(axis.low) and math.isfinite(axis.high) and axis.low <= axis.high):
            yield f"its axis {axis.name} has the range [{axis.low}, {axis.high}]"
        axis.variable.check(f"its axis {axis.name}", 1, 1)
    if spec.azimuth is not None and not math.isfinite(spec.azimuth):
        yield f"its azimuth is {spec.azimuth}"
    if spec.scale:
        spec.scale.program.check("its prefactor", len(spec.axes))
        outputs = len(spec.scale.program.outputs)
        if outputs != 1 and (not outputs or outputs % len(spec.channels)):
            yield f"its prefactor has {outputs} outputs for {len(spec.channels)} channels"
    if spec.parity and spec.peak_axis not in names:
        yield f"it has parity about {spec.peak_axis!r}, which is none of its axes {', '.join(names)}"
    if spec.twilight:
        spec.twilight.program.check("its twilight", 1, 1)
        if not 0.0 < spec.twilight.depth < math.inf:
            yield f"its twilight is {spec.twilight.depth} deep"


def _wrong_surroundings(table: Table, around: Surroundings) -> Iterator[str]:
    channels, count = len(table.channels), table.bands**2
    for name, shape in {"transfer": (count, count), "own": (channels, count), "below": (channels, count)}.items():
        part = getattr(around, name)
        if part.size and part.shape != shape:
            yield f"its surroundings' {name} has the shape {part.shape}, not {shape}"
        if not np.isfinite(part).all():
            yield f"its surroundings' {name} is not finite"


def _wrong_rows(table: Table, body: ClassRows | Rows) -> Iterator[str]:
    count, rest = table.places.size, math.prod(degree + 1 for degree in table.degrees[1:])
    width = body.rows.shape[1] if body.rows.ndim == 2 else 0
    lengths: tuple[int, ...] = (table.spec.classes, rest)
    columns: tuple[int, ...] = (count,)
    if isinstance(body, Rows):
        lengths, columns = (rest,), (len(table.channels), count)
    if body.rows.shape != (int(body.lengths.sum()), width) or body.lengths.shape != lengths:
        yield f"its rows have the shape {body.rows.shape}, its lengths {body.lengths.tolist()}"
    if body.lengths.size and int(body.lengths.max()) > table.degrees[0] + 1:
        yield f"its lengths are {body.lengths.tolist()} for {table.degrees[0] + 1} functions"
    if body.columns.shape != columns or body.columns.min() < -1 or body.columns.max() >= width:
        yield f"its columns have the shape {body.columns.shape}, or lead beyond {width}"
    if body.rows.dtype not in (np.float32, np.float64) or not np.isfinite(body.rows).all():
        yield f"its rows are {body.rows.dtype}, or not finite"


def _wrong_stream(table: Table, body: Packed) -> Iterator[str]:
    rest = math.prod(degree + 1 for degree in table.degrees[1:])
    if body.channel_profile.size != table.spec.classes or not 1 <= body.rest_profile.size <= rest:
        yield f"its profiles have {body.channel_profile.size} classes and {body.rest_profile.size} products"
    if not 1 <= body.first <= table.degrees[0] + 1 or not math.isfinite(body.step):
        yield f"its runs have {body.first} terms of {table.degrees[0] + 1}, its step is {body.step}"
    try:
        unpack(body, table.places)
    except IndexError:
        yield "its stream ends early, or has longer runs"
