"""What lights of luminance alone share."""

from __future__ import annotations

import numpy as np

from pipeline.light.protocol import Array


class OneChannel:
    """A light of this package with one channel, luminance."""

    @property
    def version(self) -> str:
        """Nothing but this package's code."""
        return ""

    @property
    def channels(self) -> tuple[str, ...]:
        """Luminance alone."""
        return ("luminance",)

    @property
    def luminance_row(self) -> Array:
        """The one channel is luminance."""
        return np.ones(1)
