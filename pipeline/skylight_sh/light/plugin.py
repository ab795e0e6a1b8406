"""Lights of other packages: any callable registered as an installed entry point."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from importlib.metadata import EntryPoint
from typing import ClassVar, Literal

import numpy as np

from skylight_sh import MissingExtraError
from skylight_sh.light import installed, validation
from skylight_sh.light.protocol import (
    OPTIONS,
    Array,
    Domain,
    Hints,
    Light,
    LightError,
    Parameters,
    RadianceError,
)


def _check(light: Light) -> None:
    """Ask a light for everything once. Raises LightError where it does not keep to the protocol."""
    channels = len(validation.check(light).channels)
    middle = {name: np.full((1, 1), _inside(domain)) for name, domain in light.domains.items()}
    try:
        with np.errstate(all="ignore"):
            found = np.asarray(light.radiance(np.array([[[0.6, 0.0, 0.8], [0.0, 0.0, 1.0]]]), middle))
    except Exception as error:
        told = f"its radiance raises {type(error).__name__} ({error}) {validation.span(middle)}"
        raise LightError(told) from error
    if found.shape[-1:] != (channels,) or found.dtype.kind != "f" or not np.all(np.isfinite(found)):
        raise LightError(
            f"its radiance of shape {found.shape} and {found.dtype} is not finite with {channels} channels last"
        )


def _inside(domain: Domain) -> float:
    """Return a domain's middle, or a finite end."""
    found = [value for value in ((domain.low + domain.high) / 2, domain.low, domain.high) if np.isfinite(value)]
    return float(found[0]) if found else 0.0


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
        # Made at once, so that a config's error is told before anything runs.
        _ = self._point
        try:
            _check(self._light)
        except Exception as error:
            told = str(error) if isinstance(error, LightError) else f"{type(error).__name__}: {error}"
            raise ValueError(f"The light {self.entry!r} cannot be made ({told}). Mend its options or its package") from error

    @cached_property
    def _point(self) -> EntryPoint:
        found = installed.points()
        if self.entry not in found:
            known = ", ".join(sorted(found)) or "none"
            raise ValueError(
                f"No installed package offers the light {self.entry!r} (entry points of group {installed.GROUP}: {known}). "
                "Install the package, or use one of these"
            )
        return found[self.entry]

    @cached_property
    def _light(self) -> Light:
        made: Light = self._point.load()(**self.options)
        return made

    @property
    def version(self) -> str:
        """The package that offers the light, its version and its code's hash, and what the light itself says."""
        return f"{installed.identity(self.entry)} {self._light.version}".rstrip()

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
        """Ask the light. Raises RadianceError where it raises anything, whatever that is."""
        try:
            return self._light.radiance(directions, parameters)
        except (LightError, MissingExtraError):
            raise
        except Exception as error:
            raise RadianceError(
                f"The radiance of the light {self.entry!r} raises {type(error).__name__} ({error}) "
                f"{validation.span(parameters)}. Mend its package, or the axes' ranges."
            ) from error
