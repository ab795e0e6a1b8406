"""What a light tells about itself, held against what it may tell: channels, domains, hints. No radiance is asked for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from skylight_sh.formula.expression import trace
from skylight_sh.light.protocol import Hints, Light, LightError, Parameters, Prefactor

# Rounding of a range's end, in radians.
_SLACK = 1e-9


@dataclass(frozen=True)
class Claims:
    """A light's title, channels, parameters and hints, each of the type it should have."""

    title: str
    channels: tuple[str, ...]
    parameters: tuple[str, ...]
    hints: Hints


def check(light: Light) -> Claims:
    """Return what a light tells about itself. Raises LightError, saying what, where that makes no sense."""
    try:
        title, version, channels = light.title, light.version, light.channels
        row, domains, hints = light.luminance_row, light.domains, light.hints
    except Exception as error:
        raise LightError(f"it cannot tell what it is ({type(error).__name__}: {error})") from error
    if not isinstance(title, str) or not isinstance(version, str):
        raise LightError("its title and version must be texts")
    if not isinstance(channels, tuple | list) or not all(isinstance(c, str) and c for c in channels):
        raise LightError(f"its channels {channels!r} must be a tuple of names")
    if not channels or len(set(channels)) < len(channels):
        raise LightError(f"its channels {channels!r} must be one name or more, each another")
    _check_row(row, len(channels))
    if not isinstance(domains, Mapping) or not all(isinstance(name, str) for name in domains):
        raise LightError("its domains must be a mapping from its parameters' names")
    for name, domain in domains.items():
        _check_domain(name, domain)
    _check_hints(hints, tuple(domains))
    return Claims(title, tuple(channels), tuple(domains), hints)


def _check_row(row: object, channels: int) -> None:
    found = np.asarray(row)
    if found.shape != (channels,) or found.dtype.kind not in "iuf":
        raise LightError(
            f"its luminance_row must have one number for each of {channels} channels, not shape {found.shape} of "
            f"{found.dtype}"
        )
    if not np.all(np.isfinite(found)) or not np.any(found):
        raise LightError(f"its luminance_row {found.tolist()} must be finite numbers, not all 0")


def _check_domain(name: str, domain: Any) -> None:
    try:
        low, high, known = (
            float(domain.low),
            float(domain.high),
            isinstance(domain.unit, str) and isinstance(domain.why, str),
        )
    except (AttributeError, TypeError, ValueError) as error:
        raise LightError(f"its domain of {name} must be a Domain of numbers, unit and reason ({error})") from error
    if not known or not low <= high:
        raise LightError(
            f"its domain of {name}, [{low:g}, {high:g}], must be numbers, low to high, with a unit and a reason"
        )


def _check_hints(hints: Hints, names: tuple[str, ...]) -> None:
    if not isinstance(hints, Hints):
        raise LightError(f"its hints must be Hints, not {type(hints).__name__}")
    told = ", ".join(names)
    if hints.peak_axis is not None and hints.peak_axis not in names:
        raise LightError(f"its peak_axis {hints.peak_axis!r} is none of its parameters {told}")
    peak = hints.peak_zenith
    if peak is not None and not (isinstance(peak, int | float) and 0.0 <= peak <= np.pi / 2 + _SLACK):
        raise LightError(f"its peak_zenith {peak!r} must be radians from 0 to pi/2")
    if hints.prefactor is not None and not isinstance(hints.prefactor, Prefactor):
        raise LightError(f"its prefactor must be a Prefactor, not {type(hints.prefactor).__name__}")


def check_ranges(claims: Claims, ranges: Mapping[str, tuple[float, float]]) -> None:
    """Raise LightError where a light's peak leaves the upper hemisphere within the ``ranges`` of its parameters."""
    low, high = ranges.get(claims.hints.peak_axis or "", (0.0, 0.0))
    if low < -_SLACK or high > np.pi / 2 + _SLACK:
        raise LightError(
            f"its peak_axis {claims.hints.peak_axis!r} reaches from {low:g} to {high:g}, but a peak's zenith angle is "
            "radians from 0 to pi/2"
        )


def check_prefactor(prefactor: Prefactor, parameters: Parameters) -> None:
    """Raise LightError where a prefactor is not finite and positive at ``parameters``, each ``(n,)``.

    It is asked as a table keeps it, a program, in both precisions: single is what renderers use.
    """
    missing = [name for name in prefactor.axes if name not in parameters]
    if missing:
        raise LightError(f"its prefactor {prefactor.name!r} needs {missing[0]!r}, which is none of its parameters")
    shape = np.broadcast_shapes(*(values.shape for values in parameters.values()))
    try:
        program = trace(lambda *arguments: [prefactor.formula(*arguments)], prefactor.axes, prefactor.constants)
    except Exception as error:
        raise LightError(
            f"its prefactor {prefactor.name!r} is no formula of numbers ({type(error).__name__}: {error}); use + - * / and "
            "the functions of skylight_sh.formula.elementary"
        ) from error
    for real in (np.dtype(np.float64), np.dtype(np.float32)):
        named: dict[str, NDArray[np.floating]] = {name: values.astype(real) for name, values in parameters.items()}
        found = np.asarray(program.run([named[name] for name in prefactor.axes])[0])
        found = np.broadcast_to(found, shape) if found.ndim == 0 else found
        if found.shape != shape or found.dtype.kind != "f":
            raise LightError(
                f"its prefactor {prefactor.name!r} must be one real number a parameter set, {shape}, not {found.shape} of "
                f"{found.dtype}"
            )
        wrong = ~(np.isfinite(found) & (found > 0.0))
        if wrong.any():
            raise LightError(
                f"its prefactor {prefactor.name!r} is {found[wrong][0]:g}{at(named, wrong)}, but must be finite and positive"
            )


def at(parameters: Mapping[str, NDArray[np.floating]], where: Any) -> str:
    """Say where the first true one of ``where`` ``(n,)`` stands: `` at sun_zenith = 0.5, turbidity = 3``."""
    first = int(np.argmax(where))
    told = ", ".join(f"{name} = {np.broadcast_to(v, np.shape(where))[first]:.6g}" for name, v in parameters.items())
    return f" at {told}" if told else ""


def span(parameters: Parameters) -> str:
    """Say between which values parameters lie: ``at sun_zenith = 0 to 1.5, turbidity = 3``."""
    told = []
    for name, values in parameters.items():
        low, high = float(values.min()), float(values.max())
        told.append(f"{name} = {low:.6g}" + (f" to {high:.6g}" if high > low else ""))
    return f"at {', '.join(told)}"
