"""What lights share: luminance alone, values that only this package's code decides, the CIE's axis."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from skylight_sh.light.protocol import OPTIONS, Array, Domain


class OwnCode:
    """A light whose values nothing but its options and this package's code decides."""

    @property
    def version(self) -> str:
        """Nothing."""
        return ""


class OneChannel:
    """A light of one channel, luminance."""

    @property
    def channels(self) -> tuple[str, ...]:
        """Luminance alone."""
        return ("luminance",)

    @property
    def luminance_row(self) -> Array:
        """The one channel is luminance."""
        return np.ones(1)


_DOMAINS: Mapping[str, Domain] = {
    "sun_zenith": Domain(0.0, float(np.pi / 2), "rad", "the standard describes a sun above the horizon"),
}


class Relative(OwnCode, OneChannel):
    """What the CIE's skies share: the axis of the sun's zenith angle."""

    __pydantic_config__: ClassVar[Mapping[str, object]] = OPTIONS

    @property
    def domains(self) -> Mapping[str, Domain]:
        """Sun zenith."""
        return _DOMAINS
