"""Lights of other packages: any callable registered as an installed entry point."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from importlib.metadata import EntryPoint, entry_points
from typing import ClassVar, Literal

import numpy as np

from pipeline.light.protocol import OPTIONS, Array, Domain, Hints, Light, Parameters

GROUP = "skylight_sh.lights"


class _UnfitError(Exception):
    """A light that does not keep to the protocol; its text says where."""


# What another package's code may raise while it is loaded and asked for the first time.
_WRONG = (ImportError, AttributeError, TypeError, SyntaxError, RuntimeError, LookupError, ArithmeticError, _UnfitError)


def _check(light: Light) -> None:
    """Ask a light for everything once. Raises _UnfitError where it does not keep to the protocol."""
    peak, channels = light.hints.peak_axis, len(light.channels)
    if not isinstance(light.title, str) or not isinstance(light.version, str):
        raise _UnfitError("its title and version must be texts")
    if peak is not None and peak not in light.domains:
        raise _UnfitError(f"its peak_axis {peak!r} is none of its parameters {', '.join(light.domains)}")
    if np.shape(light.luminance_row) != (channels,):
        raise _UnfitError(f"its luminance_row must have one number for each of {channels} channels")
    middle = {name: np.full((1, 1), (domain.low + domain.high) / 2) for name, domain in light.domains.items()}
    found = np.asarray(light.radiance(np.array([[[0.6, 0.0, 0.8], [0.0, 0.0, 1.0]]]), middle))
    if found.shape[-1:] != (channels,) or not np.all(np.isfinite(found)):
        raise _UnfitError(f"its radiance of shape {found.shape} is not finite with {channels} channels last")


@dataclass(frozen=True)
class Plugin:
    """The light that the entry point ``entry`` of group ``skylight_sh.lights`` makes when called with ``options``.

    Raises ValueError where no installed package offers that entry, or where it does not take the options.
    """

    __pydantic_config__: ClassVar[Mapping[str, object]] = OPTIONS

    entry: str
    """name of an entry point of the group skylight_sh.lights"""
    options: dict[str, bool | int | float | str] = field(default_factory=dict)
    """keyword arguments of that light's class"""
    model: Literal["plugin"] = "plugin"
    """A light of another package."""

    def __post_init__(self) -> None:
        try:
            # Made at once, so that a config's error is told before anything runs.
            _ = self._light
            _check(self._light)
        except _WRONG as error:
            raise ValueError(
                f"The light {self.entry!r} cannot be made ({error}). Mend its options or its package"
            ) from error

    @cached_property
    def _point(self) -> EntryPoint:
        found = {point.name: point for point in entry_points(group=GROUP)}
        if self.entry not in found:
            known = ", ".join(sorted(found)) or "none"
            raise ValueError(
                f"No installed package offers the light {self.entry!r} (entry points of group {GROUP}: {known}). "
                "Install the package, or use one of these"
            )
        return found[self.entry]

    @cached_property
    def _light(self) -> Light:
        made: Light = self._point.load()(**self.options)
        return made

    @property
    def version(self) -> str:
        """The package that offers the light, and its version."""
        package = self._point.dist
        told = f"{package.name} {package.version}" if package else "unknown"
        return f"{told} {self._light.version}".rstrip()

    @property
    def title(self) -> str:
        """Name for people."""
        return self._light.title

    @property
    def channels(self) -> tuple[str, ...]:
        """The light's own."""
        return self._light.channels

    @property
    def luminance_row(self) -> Array:
        """The light's own."""
        return self._light.luminance_row

    @property
    def domains(self) -> Mapping[str, Domain]:
        """The light's own."""
        return self._light.domains

    @property
    def hints(self) -> Hints:
        """The light's own."""
        return self._light.hints

    def radiance(self, directions: Array, parameters: Parameters) -> Array:
        """Ask the light."""
        return self._light.radiance(directions, parameters)
