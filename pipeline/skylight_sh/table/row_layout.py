"""The order of a table's outputs in a row: that of the stored weights, without the degrees that carry nothing."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from skylight_sh.runtime import Specification
from skylight_sh.sphere import Harmonics


def stored(spec: Specification, bands: int) -> Harmonics:
    """Return which SH weights a table of ``bands`` bands stores."""
    return Harmonics(bands, spec.mirrored)


def carried(quantity: str, bands: int) -> tuple[int, ...]:
    """Return the degrees l that carry any of ``quantity``: all, or l = 1 and the even ones for diffuse irradiance.

    >>> carried("irradiance", 7)
    (0, 1, 2, 4, 6)
    """
    return tuple(l for l in range(bands) if quantity == "radiance" or l == 1 or l % 2 == 0)


def columns(spec: Specification, bands: int) -> NDArray[np.int16]:
    """Return each stored weight's column ``(count,)``, -1 where its degree carries nothing; bands follow one another."""
    kept = np.isin(stored(spec, bands).degrees, carried(spec.quantity, bands))
    return np.where(kept, np.cumsum(kept) - 1, -1).astype(np.int16)


def widths(spec: Specification, bands: int) -> tuple[int, ...]:
    """Return how many columns the first 1, 2, .. bands take."""
    kept = columns(spec, bands) >= 0
    degrees = stored(spec, bands).degrees
    return tuple(int(np.count_nonzero(kept & (degrees < n))) for n in range(1, bands + 1))
