"""Whether a light can be believed: what it tells and what it gives are looked at before they are integrated.

A table's proof is relative to the light it is made of. One that is negative, not finite or another at each call would be
proved all the same, so such a light is refused.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skylight_sh import sphere
from skylight_sh.light import BlackBox, Fixed, Light, LightError, Luminance, MissingExtraError, validation
from skylight_sh.light.protocol import Parameters, RadianceError
from skylight_sh.light.validation import at, span
from skylight_sh.quadrature import parameter_points as parameter_sets
from skylight_sh.quadrature.samples import Samples

Array = NDArray[np.float64]
Ranges = Mapping[str, tuple[float, float]]

# Parameter sets: three values an axis where they are few, or the corners, and some at random.
_GRID = 81
_CORNERS = 128
_RANDOM = 24
_SPIRAL = 320
_ALONE = 8
# A channel or the luminance may dip below 0 by this share of the set's largest: Preetham's blue does by 0.03 with a low sun,
# Hosek and Wilkie's luminance by 0.11 near the horizon.
_DIP = 0.2
# Tables are single precision, whose squares and sums must not leave float64 either.
_FAINTEST, _BRIGHTEST = 1e-30, 1e30


@dataclass(frozen=True)
class _Question:
    """Directions ``(n, 3)``, of which ``even`` share the hemisphere evenly, and parameter sets ``(s, axes)``."""

    light: Light
    channels: int
    names: tuple[str, ...]
    directions: Array
    even: slice
    sets: Array

    def named(self, sets: Array, rank: int = 0) -> dict[str, Array]:
        """Return parameter sets ``(s, axes)`` by name, each ``(s,)`` and ``rank`` axes of size 1."""
        return {name: sets[:, i].reshape(-1, *(1,) * rank).copy() for i, name in enumerate(self.names)}


def vet(light: Light, ranges: Ranges) -> None:
    """Raise LightError where a light's claims or its radiance over ``ranges`` (by parameter) make no sense.

    Asked for some 50 parameter sets, corners included, towards 200 directions, the zenith, the horizon and the peak among
    them, its radiance has to be an array of floating-point numbers ``(..., channels)``, finite, nowhere clearly negative,
    black for no set, within what single precision holds, the same at every call to the last bit, the same but for rounding
    however many are asked for at once, and has to leave its arguments and its earlier results alone.

    >>> from skylight_sh.light.preetham import Preetham
    >>> vet(Preetham(), {"sun_zenith": (0.0, 1.5), "turbidity": (2.5, 6.0)})
    """
    try:
        told = validation.check(light)
    except LightError as error:
        raise LightError(f"A light cannot be used: {error}. Mend it.") from error
    try:
        missing = [name for name in ranges if name not in told.parameters]
        if missing:
            raise LightError(f"it has no parameter {missing[0]!r}")
        validation.check_ranges(told, ranges)
        with np.errstate(all="ignore"):
            question = _question(light, told, ranges)
            if told.hints.prefactor:
                fixed = {key: np.full(len(question.sets), value) for key, value in _fixed(light).items()}
                validation.check_prefactor(told.hints.prefactor, question.named(question.sets) | fixed)
            _check_radiance(question)
    except RadianceError:
        raise
    except LightError as error:
        source = f" ({light.version})" if light.version else ""
        raise LightError(
            f"The light {told.title!r}{source} cannot be used: {error}. Mend it, or its axes' ranges."
        ) from error


def check_samples(light: Light, parameters: Parameters, samples: Samples) -> None:
    """Raise LightError where SH weights or the mean luminance, of sets ``(n,)``, show what ``vet`` was not shown.

    ``samples`` has any leading shape of n sets; errors are relative to the least or mean luminance, so the mean is positive.
    """
    weights = samples.weights.reshape(-1, *samples.weights.shape[-2:])
    finite = np.isfinite(weights).all(axis=(1, 2)) & np.isfinite(samples.least.ravel())
    dark = finite & ~(weights[:, :, 0] @ light.luminance_row > 0.0)
    for wrong, why in ((~finite, "is not finite"), (dark, "has no positive mean luminance")):
        if wrong.any():
            raise LightError(
                f"The light {light.title!r} cannot be used: it {why}{at(parameters, wrong)}. Mend it, or its axes' ranges."
            )


def _question(light: Light, told: validation.Claims, ranges: Ranges) -> _Question:
    spiral = sphere.spiral(_SPIRAL)
    spiral = spiral[spiral[:, 2] >= 0.0]
    azimuth = np.arange(8) * (np.pi / 4)
    horizon = np.stack([np.cos(azimuth), np.sin(azimuth), np.zeros(8)], axis=-1)
    hints = told.hints
    peak = ranges.get(
        hints.peak_axis or "", (hints.peak_zenith, hints.peak_zenith) if hints.peak_zenith else (0.0, np.pi / 2)
    )
    zenith = np.linspace(*peak, 5)
    peaks = np.stack([np.sin(zenith), np.zeros(5), np.maximum(np.cos(zenith), 0.0)], axis=-1)
    directions = np.concatenate([spiral, horizon, peaks, [[0.0, 0.0, 1.0]]])
    count = len(ranges)
    fine = [np.linspace(low, high, 3) for low, high in ranges.values()]
    if 3**count <= _GRID:
        sets = parameter_sets.grid(fine)
    elif 2**count <= _CORNERS:
        sets = parameter_sets.grid([values[::2] for values in fine])
    else:
        picks = np.random.default_rng(0).integers(0, 3, (_CORNERS, count))
        sets = np.stack([values[picks[:, i]] for i, values in enumerate(fine)], axis=-1)
    drawn = parameter_sets.random(list(ranges.values()), _RANDOM, 0)
    return _Question(light, len(told.channels), tuple(ranges), directions, slice(len(spiral)), np.concatenate([sets, drawn]))


def _fixed(light: Light) -> dict[str, float]:
    """Return the parameters that are fixed in a light made of another one, by name."""
    found: dict[str, float] = {}
    while isinstance(light, BlackBox | Fixed | Luminance):
        found |= dict(light.values) if isinstance(light, Fixed) else {}
        light = light.light
    return found


def _check_radiance(question: _Question) -> None:
    sets, directions = question.sets, question.directions
    # Everything at once; then again; backwards; in pairs; in the rules' groups; and some of them alone.
    rows = np.arange(len(sets))
    first = _ask(question, directions, question.named(sets, 1), (len(sets), len(directions)))
    kept = first.copy()
    _check_values(question, kept)
    rounding = np.sqrt(np.finfo(kept.dtype).eps) * np.abs(kept).max(axis=(1, 2))
    again = _ask(question, directions, question.named(sets, 1), kept.shape[:2])
    if not np.array_equal(again, kept):
        raise LightError(
            "two calls with the same arguments give other bits. Its radiance must depend on its arguments alone"
        )

    def compare(found: Array, expected: Array, at_sets: NDArray[np.int64], how: str) -> None:
        # Radiance (sets, ..) of both; half the digits must agree.
        wrong = np.abs(found - expected).reshape(len(at_sets), -1).max(axis=1) > rounding[at_sets]
        if wrong.any():
            place = at(question.named(sets[at_sets]), wrong)
            raise LightError(
                f"its radiance{place} is another when asked for {how}. It must not depend on what else is asked"
            )

    backwards = _ask(question, directions[::-1], question.named(sets[::-1], 1), kept.shape[:2])
    compare(backwards[::-1, ::-1], kept, rows, "in another order")
    shaped = {name: values[np.newaxis] for name, values in question.named(sets, 1).items()}
    grouped = _ask(question, directions.reshape(1, 1, -1, 3), shaped, (1, *kept.shape[:2]))
    compare(grouped[0], kept, rows, "in a group")
    # A direction a set; 7 steps on, so that they come from the whole sky.
    pair = rows * 7 % len(directions)
    paired = _ask(question, directions[pair], question.named(sets), rows.shape)
    compare(paired, kept[rows, pair], rows, "in pairs")
    for i in rows[:: max(1, len(rows) // _ALONE)]:
        one = rows[i : i + 1]
        compare(_ask(question, directions[pair[one]], question.named(sets[one]), (1,)), kept[one, pair[one]], one, "alone")
    if not np.array_equal(first, kept):
        raise LightError("a later call changes an earlier result. Return a new array at every call")


def _ask(question: _Question, directions: Array, parameters: dict[str, Array], lead: tuple[int, ...]) -> Array:
    """Return the radiance ``(*lead, channels)``. Raises LightError where it is none, or the arguments were changed."""
    given, values = np.ascontiguousarray(directions).copy(), {name: array.copy() for name, array in parameters.items()}
    try:
        found = question.light.radiance(given, values)
    except (MissingExtraError, LightError):
        raise
    except Exception as error:
        raise LightError(f"its radiance raises {type(error).__name__} ({error}) {span(parameters)}") from error
    expected = (*lead, question.channels)
    if not isinstance(found, np.ndarray) or found.dtype.kind != "f" or found.dtype.itemsize < np.dtype(np.float32).itemsize:
        kind = f"an array of {found.dtype}" if isinstance(found, np.ndarray) else f"a {type(found).__name__}"
        raise LightError(f"its radiance is {kind}, not an array of float64 or float32")
    if found.shape != expected:
        raise LightError(
            f"its radiance has the shape {found.shape}, not {expected}: that of directions and parameters, and the channels"
        )
    same = values.keys() == parameters.keys() and all(np.array_equal(values[name], parameters[name]) for name in parameters)
    if not same or not np.array_equal(given, directions):
        raise LightError("its radiance changes its arguments. Work on a copy of them")
    return found


def _check_values(question: _Question, radiance: Array) -> None:
    """Look at radiance ``(sets, directions, channels)``."""
    named = question.named(question.sets)
    largest = np.abs(radiance).max(axis=(1, 2))
    luminance = radiance @ question.light.luminance_row
    for wrong, why in (
        (~np.isfinite(radiance).all(axis=(1, 2)), "its radiance is not finite"),
        (largest == 0.0, "it is black, which leaves no luminance that errors could be relative to,"),
        (largest < _FAINTEST, f"its radiance is below {_FAINTEST:g} cd/m2, too faint for single precision,"),
        (largest > _BRIGHTEST, f"its radiance is above {_BRIGHTEST:g} cd/m2, too bright for single precision,"),
        (luminance[:, question.even].mean(axis=1) <= 0.0, "its mean luminance is not positive"),
        (luminance.min(axis=1) < -_DIP * luminance.max(axis=1), "its luminance is negative"),
        (radiance.min(axis=(1, 2)) < -_DIP * largest, "a channel is far below 0"),
    ):
        if wrong.any():
            where = radiance[int(np.argmax(wrong))]
            raise LightError(f"{why}{at(named, wrong)} (it gives {where.min():g} to {where.max():g})")
