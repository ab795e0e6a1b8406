"""Lights made of another light: with its hints hidden, with parameters fixed, or reduced to its luminance."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from skylight_sh.light.mixins import OneChannel
from skylight_sh.light.protocol import Array, Domain, Hints, Light, Parameters


@dataclass(frozen=True)
class _Derived:
    """Everything of ``light`` but what a subclass changes."""

    light: Light

    @property
    def title(self) -> str:
        """Name for people."""
        return self.light.title

    @property
    def version(self) -> str:
        """The light's own."""
        return self.light.version

    @property
    def channels(self) -> tuple[str, ...]:
        """The light's own."""
        return self.light.channels

    @property
    def luminance_row(self) -> Array:
        """The light's own."""
        return self.light.luminance_row

    @property
    def domains(self) -> Mapping[str, Domain]:
        """The light's own."""
        return self.light.domains

    @property
    def hints(self) -> Hints:
        """The light's own."""
        return self.light.hints

    def radiance(self, directions: Array, parameters: Parameters) -> Array:
        """Ask the light."""
        return self.light.radiance(directions, parameters)


@dataclass(frozen=True)
class BlackBox(_Derived):
    """``light``, telling nothing about itself but its channels and domains."""

    @property
    def title(self) -> str:
        """Name for people."""
        return f"{self.light.title}, hints hidden"

    @property
    def hints(self) -> Hints:
        """None."""
        return Hints()


@dataclass(frozen=True)
class Fixed(_Derived):
    """``light`` with the parameters ``values`` fixed: they are no parameters any more."""

    values: tuple[tuple[str, float], ...]

    @property
    def title(self) -> str:
        """Name for people."""
        return f"{self.light.title}, {', '.join(f'{name} {value:g}' for name, value in self.values)}"

    @property
    def domains(self) -> Mapping[str, Domain]:
        """Those of the free parameters."""
        fixed = dict(self.values)
        return {name: domain for name, domain in self.light.domains.items() if name not in fixed}

    @property
    def hints(self) -> Hints:
        """The light's own; a peak whose zenith angle is fixed stands there."""
        hints, fixed = self.light.hints, dict(self.values)
        if hints.peak_axis in fixed:
            return replace(hints, peak_axis=None, peak_zenith=fixed[hints.peak_axis])
        return hints

    def radiance(self, directions: Array, parameters: Parameters) -> Array:
        """Ask the light, with the fixed values beside the free ones."""
        rank = max((value.ndim for value in parameters.values()), default=0)
        fixed = {name: np.full((1,) * rank, value) for name, value in self.values}
        return self.light.radiance(directions, {**parameters, **fixed})


@dataclass(frozen=True)
class Luminance(OneChannel, _Derived):
    """The luminance of ``light`` alone, one channel in cd/m2."""

    @property
    def title(self) -> str:
        """Name for people."""
        return f"{self.light.title}, luminance"

    @property
    def hints(self) -> Hints:
        """The light's own, with the factor of its luminance."""
        hints = self.light.hints
        return replace(hints, prefactor=hints.luminance or hints.prefactor, classes=None)

    def radiance(self, directions: Array, parameters: Parameters) -> Array:
        """Return the light's luminance, ``(..., 1)``."""
        return np.asarray(self.light.radiance(directions, parameters) @ self.light.luminance_row)[..., np.newaxis]
