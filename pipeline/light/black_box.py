"""A light with its hints hidden: what a fit makes of radiance alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pipeline.light.protocol import Array, Domain, Hints, Light, Parameters


@dataclass(frozen=True)
class BlackBox:
    """``light``, telling nothing about itself but its channels and domains."""

    light: Light

    @property
    def title(self) -> str:
        """Name for people."""
        return f"{self.light.title}, hints hidden"

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
        """None."""
        return Hints()

    def radiance(self, directions: Array, parameters: Parameters) -> Array:
        """Ask the light."""
        return self.light.radiance(directions, parameters)
